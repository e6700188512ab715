using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>The analyses of meshes that a window has shown. A mesh is analyzed once for as long as it stays the same, one mesh at a
    /// time, beside the editor.</summary>
    sealed class MeshAnalyses
    {
        readonly Dictionary<Mesh, MeshAnalysis> known = new Dictionary<Mesh, MeshAnalysis>();
        MeshAnalysis running;

        /// <summary>Analyses that were begun beside the editor.</summary>
        public int Started { get; private set; }

        /// <summary>Whether nothing more is begun until <see cref="Resume"/>.</summary>
        public bool IsPaused { get; private set; }

        /// <summary>The one that is known of the mesh as it is now, or one that is yet to be begun.</summary>
        public MeshAnalysis Of(Mesh mesh)
        {
            if (known.TryGetValue(mesh, out MeshAnalysis analysis) && analysis.IsCurrent)
                return analysis;
            foreach (Mesh gone in known.Keys.Where(key => key == null).ToList())
                known.Remove(gone);
            analysis?.Cancel();
            return known[mesh] = new MeshAnalysis(mesh);
        }

        /// <summary>At every update of the editor: takes a result and begins the next analysis.</summary>
        /// <param name="wanted">In this order; one that runs and is not among them is canceled.</param>
        /// <returns>Whether there is something new to show.</returns>
        public bool Update(IEnumerable<MeshAnalysis> wanted)
        {
            bool isNews = false;
            List<MeshAnalysis> open = wanted.Where(analysis => !analysis.IsDone && analysis.Mesh != null).ToList();
            if (running != null)
            {
                if (!open.Contains(running))
                    running.Cancel();
                isNews = true;
                if (!running.Poll() && running.IsRunning)
                    return true;
                running = null;
                open.RemoveAll(analysis => analysis.IsDone);
            }
            if (IsPaused || open.Count == 0)
                return isNews;
            running = open[0];
            running.Start();
            Started++;
            return true;
        }

        /// <summary>Cancels what runs and begins nothing more.</summary>
        public void Pause()
        {
            running?.Cancel();
            IsPaused = true;
        }

        public void Resume() => IsPaused = false;

        /// <summary>Forgets what is known: all is analyzed again.</summary>
        public void Clear()
        {
            running?.Cancel();
            known.Clear();
            IsPaused = false;
        }
    }
}
