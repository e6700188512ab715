using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>The water's surface for what draws it: found once in each frame in which something requests it and the water has
    /// changed.</summary>
    sealed class SurfaceRequests
    {
        const int FramesToKeep = 30;        // without a request: a camera may look away for a moment

        readonly FluidSimulation fluid;
        int framesWithout;
        float meshCell;         // requested in this frame, d; 0: no mesh
        BoxWalls meshWalls;     // at which that mesh has faces
        PbfSolver tooLarge;     // whose surface this device cannot hold

        public SurfaceRequests(FluidSimulation fluid) => this.fluid = fluid;

        /// <summary>Raised before the steps of a frame: what draws the surface in this frame sets <see cref="IsNeeded"/>.</summary>
        public event Action Requesting;

        /// <summary>Whether this frame ends with the surface of its state: <see cref="PbfSolver.Surface"/>. False again after the frame.</summary>
        public bool IsNeeded { get; set; }

        /// <summary>Requests the surface as a mesh. The finest request serves all, with the walls of all.</summary>
        /// <param name="cell">Distance of its nodes, d.</param>
        /// <param name="walls">Walls at which it has faces.</param>
        public void RequestMesh(float cell, BoxWalls walls)
        {
            meshWalls = meshCell > 0f ? meshWalls | walls : walls;
            meshCell = meshCell > 0f ? Math.Min(meshCell, cell) : cell;
        }

        /// <summary>Collects the requests of a frame, and gives the mesh more room where an earlier one had too little. The mesh is gone
        /// then, so it is found again in this frame, also in one without steps.</summary>
        public void Collect()
        {
            meshCell = 0f;
            Requesting?.Invoke();
            if (!IsNeeded)
                return;
            try
            {
                fluid.Solver.FollowMeshSize();
            }
            catch (ArgumentException problem)
            {
                fluid.Solver.ReleaseSurface();
                ContinueWithoutSurface(problem);
            }
        }

        /// <summary>Records the surface where it is requested and is not that of the current state.</summary>
        /// <returns>Whether anything was recorded.</returns>
        public bool Record(CommandBuffer commands)
        {
            PbfSolver solver = fluid.Solver;
            if (!IsNeeded || solver == tooLarge)
                return false;
            SetMesh();
            if (solver.SurfaceIsCurrent)
                return false;
            if (!fluid.Support.HasAfterSteps(Features.SurfaceParticles)
                || meshCell > 0f && !fluid.Support.Gate.IsLoaded(Features.SurfaceMesh))
                return false;
            try
            {
                solver.RecordSurface(commands, fluid.Steps.Input);
                return true;
            }
            catch (ArgumentException problem)
            {
                ContinueWithoutSurface(problem);
                return false;
            }
        }

        /// <summary>Ends a frame: finds the surface in a frame without steps, where water was added, the fluid was restarted, or the surface is
        /// drawn for the first time.</summary>
        public void Update(CommandBuffer commands)
        {
            PbfSolver solver = fluid.Solver;
            if (solver == null)
                return;
            framesWithout = IsNeeded ? 0 : Math.Min(framesWithout + 1, FramesToKeep);
            if (IsNeeded)
                SetMesh();
            if (IsNeeded && !solver.SurfaceIsCurrent)
            {
                commands.Clear();
                if (Record(commands))
                    Graphics.ExecuteCommandBuffer(commands);
            }
            else if (framesWithout == FramesToKeep)
            {
                solver.ReleaseSurface();
            }
            IsNeeded = false;
        }

        void SetMesh()
        {
            fluid.Solver.MeshCell = meshCell;
            if (meshCell > 0f)
                fluid.Solver.MeshWalls = (int)meshWalls;
        }

        void ContinueWithoutSurface(ArgumentException problem)
        {
            tooLarge = fluid.Solver;
            Debug.LogError($"Rill: FluidSimulation '{fluid.name}' goes on without the water's surface: {problem.Message} Lower the " +
                $"capacity, or draw it with a ParticleRenderer.", fluid);
        }
    }
}
