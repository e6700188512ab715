using System;
using System.Collections.Generic;
using UnityEditor;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>A mesh that is to be baked: what is wrong with it, where its field goes, and what came of it.</summary>
    sealed class BakeItem
    {
        // Seconds at most; the rest of a larger mesh is said not to have been looked at.
        const long MostCrossingTests = 2_000_000;

        readonly TriangleMesh triangles;

        /// <param name="existing">The field to bake into; null for a new one at the path.</param>
        public BakeItem(Mesh mesh, string path, SignedDistanceField existing)
        {
            Mesh = mesh;
            Path = path;
            Existing = existing;
            try
            {
                triangles = TriangleMesh.Of(mesh);
                Report = MeshCheck.Run(triangles, MostCrossingTests);
                Problem = Report.Problem;
            }
            catch (ArgumentException e)
            {
                // A mesh that scripts cannot read.
                Problem = e.Message;
            }
        }

        public Mesh Mesh { get; }

        /// <summary>Of the asset that it goes into.</summary>
        public string Path { get; }

        /// <summary>The asset that is there already.</summary>
        public SignedDistanceField Existing { get; }

        /// <summary>Objects of the selection that show the mesh.</summary>
        public List<GameObject> Objects { get; } = new List<GameObject>();

        /// <summary>Null for a mesh that cannot be read.</summary>
        public MeshReport Report { get; }

        /// <summary>Why the mesh cannot be baked with any settings; null if it can.</summary>
        public string Problem { get; }

        /// <summary>What came of it; null before it was tried.</summary>
        public SignedDistanceField Field { get; private set; }

        /// <summary>In a sentence; null before it was tried.</summary>
        public string Outcome { get; private set; }

        public bool Failed { get; private set; }

        /// <summary>What a bake with these settings takes.</summary>
        /// <param name="problem">Why it cannot be; null if it can.</param>
        public bool TryEstimate(in MeshSdfSettings settings, out MeshSdfEstimate estimate, out string problem)
        {
            estimate = default;
            problem = Problem;
            if (problem != null)
                return false;
            try
            {
                estimate = MeshSdfBaker.Estimate(Report, settings);
                problem = estimate.Problem;
            }
            catch (ArgumentException e)
            {
                problem = e.Message;
            }
            return problem == null;
        }

        /// <summary>Bakes and writes the asset.</summary>
        /// <param name="progress">Told the share that is done and the stage, and asked whether to go on.</param>
        /// <returns>False if it was cancelled: then nothing was written.</returns>
        public bool Bake(in MeshSdfSettings settings, Func<float, string, bool> progress)
        {
            Failed = true;
            if (!TryEstimate(settings, out _, out string problem))
            {
                Outcome = problem;
                return true;
            }
            try
            {
                double start = EditorApplication.timeSinceStartup;
                SdfBake bake = MeshSdfBaker.Bake(triangles, settings, progress);
                if (bake == null)
                {
                    Outcome = "Cancelled: nothing was written.";
                    return false;
                }
                Write(bake);
                Outcome = $"{BakeTexts.Of(bake)}; {EditorApplication.timeSinceStartup - start:0.00} s.";
                Failed = false;
            }
            catch (Exception e) when (e is ArgumentException || e is InvalidOperationException || e is UnityException)
            {
                Outcome = e.Message;
            }
            return true;
        }

        void Write(SdfBake bake)
        {
            if (Existing != null)
            {
                FieldAssets.Replace(Existing, bake, Mesh);
                Field = Existing;
                return;
            }
            if (!FieldAssets.TryMakeFolder(Path.Substring(0, Path.LastIndexOf('/'))))
                throw new UnityException($"'{Path}' is in no folder of the project: choose one below Assets.");
            Field = FieldAssets.Create(bake, Mesh, Path);
        }
    }
}
