using System;
using System.Collections.Generic;
using UnityEditor;
using UnityEngine;
using static System.FormattableString;

namespace Rill.Editor
{
    /// <summary>A mesh that is to be baked: what is wrong with it, where its field goes, and what came of it.</summary>
    sealed class BakeItem
    {
        // Fraction of the whole bake, used until the mesh has been analyzed.
        const float AnalysisFraction = 0.2f;
        const string Canceled = "Canceled: nothing was written.";

        /// <param name="existing">The field to bake into; null for a new one at the path.</param>
        public BakeItem(MeshAnalysis analysis, string path, SignedDistanceField existing)
        {
            Analysis = analysis;
            Path = path;
            Existing = existing;
        }

        public Mesh Mesh => Analysis.Mesh;

        /// <summary>Problems found in the mesh. May still be running; the bake then waits for it.</summary>
        public MeshAnalysis Analysis { get; }

        /// <summary>Path of the asset that the field is saved to.</summary>
        public string Path { get; }

        /// <summary>The asset that is there already.</summary>
        public SignedDistanceField Existing { get; }

        /// <summary>Objects of the selection that show the mesh.</summary>
        public List<GameObject> Objects { get; } = new List<GameObject>();

        /// <summary>Null until the analysis is done.</summary>
        public MeshReport Report => Analysis.Report;

        /// <summary>Why the mesh cannot be baked with any settings; null if it can or is not known yet.</summary>
        public string Problem => Analysis.Problem;

        /// <summary>Result of the bake; null before it was tried.</summary>
        public SignedDistanceField Field { get; private set; }

        /// <summary>In a sentence; null before it was tried.</summary>
        public string Outcome { get; private set; }

        public bool Failed { get; private set; }

        /// <summary>Estimates a bake with these settings. Reads no mesh.</summary>
        /// <param name="problem">Why it cannot be; null if it can, or while the analysis is running.</param>
        /// <returns>False also while the analysis is running.</returns>
        public bool TryEstimate(in MeshSdfSettings settings, out MeshSdfEstimate estimate, out string problem)
        {
            estimate = default;
            problem = Problem;
            if (problem != null || Report == null)
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

        /// <summary>Lists the parts of the mesh that a bake with these settings would not represent; empty until the analysis is done.</summary>
        public IReadOnlyList<MeshLoss> LossesOf(in MeshSdfSettings settings)
        {
            // Asked for at each event of a window.
            if (losses == null || lossesOf != Report || !lossesWith.Equals(settings))
                (losses, lossesOf, lossesWith) = (Report?.LossesOf(settings) ?? Array.Empty<MeshLoss>(), Report, settings);
            return losses;
        }

        IReadOnlyList<MeshLoss> losses;
        MeshReport lossesOf;
        MeshSdfSettings lossesWith;

        /// <summary>Bakes and writes the asset.</summary>
        /// <param name="progress">Told the fraction that is done and the stage, and asked whether to go on.</param>
        /// <returns>False if it was canceled: then nothing was written.</returns>
        public bool Bake(in MeshSdfSettings settings, Func<float, string, bool> progress)
        {
            Failed = true;
            float before = Analysis.IsDone ? 0f : AnalysisFraction;
            if (!Analysis.Finish((fraction, stage) => progress(before * fraction, stage), out TriangleMesh triangles))
            {
                Outcome = Canceled;
                return false;
            }
            if (!TryEstimate(settings, out _, out string problem))
            {
                Outcome = problem;
                return true;
            }
            try
            {
                double start = EditorApplication.timeSinceStartup;
                SdfBake bake = MeshSdfBaker.Bake(triangles, settings, (fraction, stage) => progress(before + (1f - before) * fraction, stage));
                if (bake == null)
                {
                    Outcome = Canceled;
                    return false;
                }
                Write(bake);
                Outcome = Invariant($"{BakeTexts.Of(bake)}; {EditorApplication.timeSinceStartup - start:0.00} s.");
                Failed = false;
            }
            catch (Exception e) when (e is ArgumentException || e is InvalidOperationException || e is UnityException)
            {
                Outcome = e.Message;
            }
            return true;
        }

        /// <summary>Adds to the outcome that nothing took the field.</summary>
        public void SetTaken(bool isTaken)
        {
            if (!isTaken)
                Outcome += " Assigned to nothing: what asked for it is gone or has a field. Drag the asset to where it belongs.";
        }

        void Write(SdfBake bake)
        {
            // Its own, where it was baked before.
            SignedDistanceField into = Existing != null ? Existing : Field;
            if (into != null)
            {
                FieldAssets.Replace(into, bake, Mesh);
                Field = into;
                return;
            }
            if (!FieldAssets.TryMakeFolder(Path.Substring(0, Path.LastIndexOf('/'))))
                throw new UnityException($"'{Path}' is in no folder of the project: choose one below Assets.");
            Field = FieldAssets.Create(bake, Mesh, Path);
        }
    }
}
