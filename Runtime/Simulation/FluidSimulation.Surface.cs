using System;
using UnityEngine;

namespace Rill
{
    // The water's surface for what draws it: found once a frame in which something asks for it and the water has changed.
    public sealed partial class FluidSimulation
    {
        const int FramesToKeepSurface = 30;     // that nothing asks for: a camera may look away for a moment

        [NonSerialized] int framesWithoutSurface;
        PbfSolver tooLarge;         // whose surface this device cannot hold

        /// <summary>Before the steps of a frame: what draws the surface sets <see cref="NeedsSurface"/> where it does in this frame.</summary>
        internal event Action AskForSurface;

        /// <summary>Whether this frame ends with the surface of its state: <see cref="PbfSolver.Surface"/>. False again after the frame.</summary>
        [field: NonSerialized] internal bool NeedsSurface { get; set; }

        [NonSerialized] float meshCell;         // asked for in this frame, d; 0: no mesh
        [NonSerialized] BoxWalls meshWalls;     // at which that mesh has faces

        /// <summary>Asks for the surface as a mesh. The finest that is asked for serves all, with the walls of all.</summary>
        /// <param name="cell">Distance of its nodes, d.</param>
        /// <param name="walls">At which it has faces.</param>
        internal void NeedMesh(float cell, BoxWalls walls)
        {
            meshWalls = meshCell > 0f ? meshWalls | walls : walls;
            meshCell = meshCell > 0f ? Math.Min(meshCell, cell) : cell;
        }

        void CollectMeshNeeds()
        {
            meshCell = 0f;
            AskForSurface?.Invoke();
        }

        /// <summary>Records the surface where it is asked for and not that of the current state.</summary>
        /// <returns>Whether anything was recorded.</returns>
        bool RecordSurface()
        {
            if (!NeedsSurface || pbf == tooLarge)
                return false;
            SetMesh();
            if (pbf.SurfaceIsCurrent)
                return false;
            wanted |= Features.SurfaceParticles;        // where no step has asked yet
            Gate.Decide(wanted);
            if (!Has(Features.SurfaceParticles) || meshCell > 0f && !Gate.IsLoaded(Features.SurfaceMesh))
                return false;
            try
            {
                pbf.RecordSurface(commands, input);
                return true;
            }
            catch (ArgumentException problem)
            {
                GoOnWithoutSurface(problem);
                return false;
            }
        }

        /// <summary>Before the surface of a frame is recorded: gives its mesh more room where an earlier one had too little. The mesh is gone
        /// then, so it is found anew in this frame, also in one without steps.</summary>
        void FollowMeshSize()
        {
            if (!NeedsSurface)
                return;
            try
            {
                pbf.FollowMeshSize();
            }
            catch (ArgumentException problem)
            {
                pbf.ReleaseSurface();
                GoOnWithoutSurface(problem);
            }
        }

        void SetMesh()
        {
            pbf.MeshCell = meshCell;
            if (meshCell > 0f)
                pbf.MeshWalls = (int)meshWalls;
        }

        void GoOnWithoutSurface(ArgumentException problem)
        {
            tooLarge = pbf;
            Debug.LogError($"Rill: FluidSimulation '{name}' goes on without the water's surface: {problem.Message} Lower the " +
                $"capacity, or draw it with a ParticleRenderer.", this);
        }

        /// <summary>Ends a frame: the surface of one without steps, for what was added, restarted or is drawn for the first time.</summary>
        void FinishSurface()
        {
            if (pbf == null)
                return;
            framesWithoutSurface = NeedsSurface ? 0 : Math.Min(framesWithoutSurface + 1, FramesToKeepSurface);
            if (NeedsSurface)
                SetMesh();
            if (NeedsSurface && !pbf.SurfaceIsCurrent)
            {
                commands.Clear();
                if (RecordSurface())
                    Graphics.ExecuteCommandBuffer(commands);
            }
            else if (framesWithoutSurface == FramesToKeepSurface)
            {
                pbf.ReleaseSurface();
            }
            NeedsSurface = false;
        }
    }
}
