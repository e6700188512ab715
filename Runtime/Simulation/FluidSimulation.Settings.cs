using UnityEngine;

namespace Rill
{
    // Settings that a script may change at any time.
    public sealed partial class FluidSimulation
    {
        /// <summary>Inner size of the box, m, each side at least two particle spacings. A running fluid starts again with another in its
        /// next frame.</summary>
        public Vector3 DomainSize { get => domainSize; set => ConfigureIfOther(value, particleSpacing, capacity); }

        /// <summary>Distance between particles at rest, m, above 0. A running fluid keeps its water, as particles of the new spacing: it has them,
        /// and tells the new value, two or three frames later, and its time stands until then. Where the capacity does not hold them it stays as it
        /// is, which is logged.</summary>
        public float ParticleSpacing { get => particleSpacing; set => ChangeResolution(value, resampling?.capacity ?? capacity); }

        /// <summary>Most particles, 1 to 16,777,216. A running fluid keeps its water, as with another <see cref="ParticleSpacing"/>.</summary>
        public int Capacity { get => capacity; set => ChangeResolution(resampling?.spacing ?? particleSpacing, value); }

        /// <summary>Fixed steps in a second of fluid time, 10 to 1000. Acts from the next step on. Out-of-range values are clamped with a
        /// warning.</summary>
        public float StepRate { get => stepRate; set { stepRate = value; Changed(); } }

        /// <summary>Steps that one frame takes at most, 1 to 16. Acts in the next frame. Out-of-range values are clamped with a warning.</summary>
        public int MaxStepsPerFrame { get => maxStepsPerFrame; set { maxStepsPerFrame = value; Changed(); } }

        /// <summary>Jacobi iterations of the density constraint a substep, 1 to 50: those of <see cref="Settings"/>. Acts from the next step
        /// on, and the water goes on; a <see cref="Budget"/> has bounds of its own. Out-of-range values are clamped with a warning.</summary>
        public int Iterations { get => solver.iterations; set { solver.iterations = value; Changed(); } }

        /// <summary>Substeps of a fixed step, 1 to 16: those of <see cref="Settings"/>. Acts as <see cref="Iterations"/> does.</summary>
        public int Substeps { get => solver.substeps; set { solver.substeps = value; Changed(); } }

        /// <summary>Relaxation, 0 to 2: that of <see cref="Settings"/>. Acts as <see cref="Iterations"/> does.</summary>
        public float Relaxation { get => solver.relaxation; set { solver.relaxation = value; Changed(); } }

        /// <summary>Whether the pressure of deep water is also solved for on a coarse grid: as in <see cref="Settings"/>. Acts as
        /// <see cref="Iterations"/> does.</summary>
        public DeepWater DeepWater { get => solver.deepWater; set { solver.deepWater = value; Changed(); } }

        /// <summary>Mean speed below which water sleeps, m/s, 0 (off) to 1: that of <see cref="Settings"/>. Acts as <see cref="Iterations"/>
        /// does.</summary>
        public float SleepSpeed { get => solver.sleepSpeed; set { solver.sleepSpeed = value; Changed(); } }

        /// <summary>Numerical damping of waves and turning water, 0 to 1: that of <see cref="Settings"/>. Acts as <see cref="Iterations"/>
        /// does.</summary>
        public float NumericalDamping { get => solver.numericalDamping; set { solver.numericalDamping = value; Changed(); } }

        /// <summary>Dynamic viscosity, Pa s, 0 (off) to 1e6: that of <see cref="Material"/>. Acts as <see cref="Iterations"/> does.</summary>
        public float DynamicViscosity { get => material.dynamicViscosity; set { material.dynamicViscosity = value; Changed(); } }

        /// <summary>Of the small offsets from the lattice with which fluid is filled in. Acts at the next <see cref="Restart"/> or fill.</summary>
        public int Seed { get => seed; set => seed = value; }

        void ConfigureIfOther(Vector3 size, float spacing, int particles)
        {
            if (size != domainSize || spacing != particleSpacing || particles != capacity)
                Configure(size, spacing, particles);
        }
    }
}
