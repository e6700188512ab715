using System;
using System.Threading.Tasks;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>Problems of a mesh, found once: on a thread beside the editor, or at once for a bake.</summary>
    sealed class MeshAnalysis
    {
        // Seconds at most; the rest of a larger mesh is reported as not examined.
        const long MaxCrossingTests = 2_000_000;
        const int MillisecondsBetweenLooks = 20;
        const string Reading = "Reading the mesh";

        readonly MeshVersion version;
        Task<MeshReport> running;
        ulong hash;     // of the triangles that the report is of
        // Written by one thread, read by the other.
        volatile bool isCanceled;
        volatile float progress;
        volatile string stage = Reading;

        public MeshAnalysis(Mesh mesh)
        {
            Mesh = mesh;
            version = new MeshVersion(mesh);
        }

        public Mesh Mesh { get; }

        /// <summary>Null until it is done.</summary>
        public MeshReport Report { get; private set; }

        /// <summary>Why the mesh cannot be baked with any settings; null if it can or is not known yet.</summary>
        public string Problem => failure ?? Report?.Problem;

        string failure;

        public bool IsDone => Report != null || failure != null;

        public bool IsRunning => running != null;

        /// <summary>How far it is, 0 to 1, and at what.</summary>
        public (float fraction, string stage) Progress => (progress, stage);

        /// <summary>Whether the mesh is still the one that this is of, as far as that is seen without reading it.</summary>
        public bool IsCurrent => Mesh != null && version.Equals(new MeshVersion(Mesh));

        /// <summary>Reads the mesh, and begins to look it through on another thread.</summary>
        public void Start()
        {
            if (IsDone || IsRunning)
                return;
            TriangleMesh triangles = EditorMesh.Read(Mesh);
            isCanceled = false;
            (progress, stage) = (0f, Reading);
            running = Task.Run(() => Check(triangles, SetProgress));
        }

        /// <summary>Takes what the other thread found.</summary>
        /// <returns>Whether it has just ended.</returns>
        public bool Poll()
        {
            if (running == null || !running.IsCompleted)
                return false;
            Task<MeshReport> ended = running;
            running = null;
            if (ended.IsFaulted)
                failure = ended.Exception.GetBaseException().Message;
            else
                Report = ended.Result;      // null where it was canceled
            return true;
        }

        /// <summary>Lets the other thread end soon, without a result.</summary>
        public void Cancel() => isCanceled = true;

        /// <summary>Waits for the result, or finds it now where nothing runs; again where the mesh has changed meanwhile.</summary>
        /// <param name="go">Told the fraction that is done and the stage, and asked whether to go on.</param>
        /// <param name="triangles">What is there now, for the bake.</param>
        /// <returns>False if it was canceled.</returns>
        public bool Finish(Func<float, string, bool> go, out TriangleMesh triangles)
        {
            triangles = EditorMesh.Read(Mesh);
            bool goesOn = true;
            while (running != null && !Poll())
            {
                goesOn = goesOn && go(progress, stage);
                if (!goesOn)
                    Cancel();
                try
                {
                    running.Wait(MillisecondsBetweenLooks);
                }
                catch (AggregateException)
                {
                    // Poll tells of it.
                }
            }
            if (!goesOn)
                return false;
            ulong now = triangles.Hash();
            if (IsDone && now == hash)
                return true;
            failure = null;
            Report = Check(triangles, go);
            return Report != null;
        }

        MeshReport Check(TriangleMesh triangles, Func<float, string, bool> go)
        {
            hash = triangles.Hash();
            return MeshCheck.Run(triangles, MaxCrossingTests, go);
        }

        bool SetProgress(float fraction, string what)
        {
            (progress, stage) = (fraction, what);
            return !isCanceled;
        }
    }
}
