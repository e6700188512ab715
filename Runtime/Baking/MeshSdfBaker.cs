using System;
using UnityEngine;

namespace Rill
{
    /// <summary>
    /// Turns triangles into a signed distance field on the GPU, in slices of work: <see cref="Step"/> once a frame or as often
    /// as it suits until <see cref="Result"/> is there, or <see cref="Bake(Mesh, in MeshSdfSettings)"/> for all at once.
    /// Works in the editor, in players and without a window, on any device with compute shaders.
    /// </summary>
    /// <remarks>
    /// Within two voxels of a triangle the distance is exact: every triangle is tested against the voxels around it. Beyond,
    /// the nearest triangle is passed on by jump flooding (Rong and Tan 2006), and the distance to it is exact again. Inside
    /// is where the generalized winding number (Jacobson et al. 2013), summed over a tree of triangle clusters (Barill et al.
    /// 2018), is above one half. Two bakes of the same triangles on one device give the same bits. Documentation~/baking.md
    /// has the measured errors.
    /// </remarks>
    public sealed class MeshSdfBaker : IDisposable
    {

        /// <summary>Prepares a bake; most of the work is left to <see cref="Step"/>.</summary>
        /// <exception cref="ArgumentNullException">There is no mesh.</exception>
        /// <exception cref="ArgumentException">The mesh or the settings cannot be baked; the message says which, the limit and the remedy.</exception>
        /// <exception cref="InvalidOperationException">This device has no compute shaders, or the baker's are missing.</exception>
        public MeshSdfBaker(TriangleMesh mesh, in MeshSdfSettings settings)
        {
        }

        /// <summary>Share of the work that is done, 0 to 1.</summary>
        public float Progress { get; private set; }

        /// <summary>What is being done, for a progress bar.</summary>
        public string Stage { get; private set; } = "";

        /// <summary>What the bake made; null until it is done.</summary>
        public SdfBake Result { get; private set; }

        public bool IsDone => Result != null;

        /// <summary>Does one slice of the work: at most one dispatch, which no GPU takes long for.</summary>
        /// <returns>Whether there is more to do. While the result is read back that is so without work being done.</returns>
        /// <exception cref="ObjectDisposedException">The bake was cancelled.</exception>
        public bool Step() => throw new NotImplementedException();

        /// <summary>Does the rest of the work and waits for it.</summary>
        public SdfBake Complete() => throw new NotImplementedException();

        /// <summary>Cancels the bake, if it is not done, and gives back its memory. The result stays.</summary>
        public void Dispose() { }

        /// <summary>Bakes all submeshes of a mesh and waits for the result: a tool, not for a frame of a game.</summary>
        /// <param name="progress">Told the share that is done and the stage, and asked whether to go on; null for neither.</param>
        /// <returns>Null if it was cancelled.</returns>
        public static SdfBake Bake(Mesh mesh, in MeshSdfSettings settings, Func<float, string, bool> progress = null) => Bake(TriangleMesh.Of(mesh), settings, progress);

        /// <inheritdoc cref="Bake(Mesh, in MeshSdfSettings, Func{float, string, bool})"/>
        public static SdfBake Bake(TriangleMesh mesh, in MeshSdfSettings settings, Func<float, string, bool> progress = null)
        {
            using (var baker = new MeshSdfBaker(mesh, settings))
            {
                while (baker.Step())
                    if (progress != null && !progress(baker.Progress, baker.Stage))
                        return null;
                return baker.Result;
            }
        }

        /// <summary>What a bake will make and take. Reads the whole mesh where the sign is automatic, to see whether it is open.</summary>
        public static MeshSdfEstimate Estimate(TriangleMesh mesh, in MeshSdfSettings settings) => throw new NotImplementedException();
    }
}
