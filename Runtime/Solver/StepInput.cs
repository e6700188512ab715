using Unity.Mathematics;

namespace Rill
{
    /// <summary>What one step of a solver is given; all of it may change from step to step.</summary>
    struct StepInput
    {
        /// <summary>Length of the step, s, above 0; divided among the substeps.</summary>
        public float timeStep;
        /// <summary>Acceleration in the domain's frame, m/s².</summary>
        public float3 gravity;
        /// <summary>Validated.</summary>
        public SolverSettings settings;
        /// <summary>Validated.</summary>
        public FluidMaterial material;
        /// <summary>Whether something reads the density that comes with the velocities.</summary>
        public bool needsDensity;
        /// <summary>Solid colliders over the frame that the step belongs to; null for none.</summary>
        public ColliderSet colliders;
        /// <summary>Fractions of that frame at which the step starts and ends.</summary>
        public float frameFrom, frameTo;
        /// <summary>Emitters, drains and force fields; null for none.</summary>
        public StepSources sources;
        /// <summary>Neighbors to take particles and ghosts from before this step; null for none.</summary>
        public StepConnections connections;
        /// <summary>Bit 2 a + b: a neighbor covers the lower (b 0) or upper end of the box along axis a.</summary>
        public uint openFaces;
        /// <summary>Whether a pass before the step may have marked particles to remove.</summary>
        public bool removesKilled;
        /// <summary>Whether particles have phases also where no emitter gives any.</summary>
        public bool tracksPhases;
        /// <summary>Validated; a budget of 0 is no foam.</summary>
        public FoamSettings foam;
        /// <summary>Of the random numbers of foam.</summary>
        public int foamSeed;

        /// <summary>Length of a substep, s.</summary>
        public float SubstepTime => timeStep / settings.substeps;
    }
}
