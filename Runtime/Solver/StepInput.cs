using Unity.Mathematics;

namespace Rill
{
    /// <summary>Input of one step of a solver; all of it may change from step to step.</summary>
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
        /// <summary>Validated materials of the phases that have their own.</summary>
        public PhaseMaterials phases;
        /// <summary>Whether something reads the density that comes with the velocities.</summary>
        public bool needsDensity;
        /// <summary>Validated, with bands that the box has room for.</summary>
        public FluidBorders borders;
        /// <summary>Solid colliders over the frame that the step belongs to; null for none.</summary>
        public ColliderSet colliders;
        /// <summary>Fractions of that frame at which the step starts and ends.</summary>
        public float frameFrom, frameTo;
        /// <summary>Emitters, drains and force fields; null for none.</summary>
        public StepSources sources;
        /// <summary>Neighbors whose water is felt; null for none.</summary>
        public StepConnections connections;
        /// <summary>Whether particles and ghosts are taken from them before this step: the first of a frame.</summary>
        public bool takesParticles;
        /// <summary>Whether a pass before the step may have marked particles to remove.</summary>
        public bool removesKilled;
        /// <summary>Whether particles have phases also where no emitter gives any.</summary>
        public bool tracksPhases;
        /// <summary>Validated settings; a budget of 0 means without foam.</summary>
        public FoamSettings foam;
        /// <summary>Seed of the random numbers of foam.</summary>
        public int foamSeed;
        /// <summary>Whether there is air with smoke over the fluid.</summary>
        public bool hasSmoke;
        /// <summary>Validated.</summary>
        public SmokeSettings smoke;

        /// <summary>Whether all particles have phases: a script asks for them, or they have materials that differ or mix.</summary>
        public readonly bool HasPhases => tracksPhases || MaterialTable.IsNeeded(this) || Diffusion.IsNeeded(this);

        /// <summary>Makes all grains liquids.</summary>
        public void LeaveOutGrains()
        {
            material.frictionAngle = material.cohesion = 0f;
            phases = phases.WithoutFriction();
        }

        /// <summary>Length of a substep, s.</summary>
        public readonly float SubstepTime => timeStep / settings.substeps;
    }
}
