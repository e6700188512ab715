using System;
using UnityEngine.Rendering;

namespace Rill
{
    // The drawn surface of the water, from the state that the last step left.
    partial class PbfSolver
    {
        readonly SurfaceWorkspace surfaceWorkspace = new SurfaceWorkspace();
        float meshCell;
        int meshWalls = 63;
        int substepsSinceSurface;
        bool hasNew;        // particles that the last step did not move

        /// <summary>Distance of the nodes of the surface's mesh, d, 0.25 to 2; 0 where the surface is drawn as ellipsoids.</summary>
        public float MeshCell
        {
            get => meshCell;
            set
            {
                if (value != meshCell)
                    InvalidateSurface();
                meshCell = value;
            }
        }

        /// <summary>Walls at which the mesh has faces: bit 2 a + s for that at the low (s 0) or high end of axis a.</summary>
        public int MeshWalls
        {
            get => meshWalls;
            set
            {
                if (value != meshWalls && Mesh != null)
                    SurfaceIsCurrent = false;
                meshWalls = value;
            }
        }

        /// <summary>Whether <see cref="Surface"/> is that of the current state.</summary>
        public bool SurfaceIsCurrent { get; private set; }

        /// <summary>Differs once <see cref="Surface"/> is that of another state.</summary>
        public int SurfaceVersion { get; private set; } = 1;

        /// <summary>Records the surface of the current state; not after <see cref="RecordStatistics"/> of that state, which sorts again.</summary>
        /// <exception cref="ArgumentOutOfRangeException">Its buffers are more than the device can bind.</exception>
        public void RecordSurface(CommandBuffer cmd, in StepInput input)
        {
            if (Surface == null)
                Keep(Features.SurfaceParticles, new SurfaceParticles(Layout, surfaceWorkspace));
            if (Mesh != null && Mesh.Cell != MeshCell)
                ReleaseMesh();
            if (MeshCell > 0f && Mesh == null)
                Keep(Features.SurfaceMesh, new SurfaceMesh(Layout, surfaceWorkspace, MeshCell));
            bool hasSteps = lastSubsteps > 0 && !isRestored && !HasMarked;       // the neighbor lists do not know which particles are gone
            StepInput last = input;
            last.settings.substeps = Math.Max(lastSubsteps, 1);
            SurfaceVersion++;
            StepContext step = Context(cmd, last, hasSteps);
            Surface.Record(step, hasSteps, hasNew, SurfaceVersion, substepsSinceSurface, hasGhosts, Mesh != null);
            if (Mesh != null)
                RecordMesh(step, hasSteps);
            SurfaceIsCurrent = true;
            substepsSinceSurface = 0;
        }

        /// <summary>Once a frame, before its surface is recorded: asks how large the last mesh was to be, and makes room where an earlier one had
        /// too little. The surface is not current then.</summary>
        /// <exception cref="ArgumentOutOfRangeException">It is more than the device can bind.</exception>
        public void FollowMeshSize()
        {
            if (Mesh != null && Mesh.Follow())
                SurfaceIsCurrent = false;
        }

        void RecordMesh(in StepContext step, bool hasSteps)
        {
            if (lastSubsteps == 0)
                UploadConstants(step.Commands, step.Input);
            Mesh.Record(step, Surface, hasSteps, meshWalls);
        }

        // Makes the next drawn surface independent of the ones before.
        void InvalidateSurface()
        {
            SurfaceIsCurrent = false;
            SurfaceVersion++;
        }

        /// <summary>Gives back what the surface needs, where nothing draws it any more.</summary>
        public void ReleaseSurface()
        {
            Release(Features.SurfaceParticles);
            SurfaceIsCurrent = false;
            ReleaseMesh();
        }

        void ReleaseMesh()
        {
            Release(Features.SurfaceMesh);
            surfaceWorkspace.Dispose();      // which had room for the mesh
        }
    }
}
