using UnityEngine;

namespace Rill
{
    // Settings that a script may change at any time.
    public sealed partial class FluidSimulation
    {
        /// <summary>Inner size of the box, m, each side at least two particle spacings. A running fluid starts again with another in its
        /// next frame.</summary>
        public Vector3 DomainSize { get => domainSize; set => ConfigureIfOther(value, particleSpacing, capacity); }

        /// <summary>Distance between particles at rest, m, above 0. A running fluid starts again with another in its next frame.</summary>
        public float ParticleSpacing { get => particleSpacing; set => ConfigureIfOther(domainSize, value, capacity); }

        /// <summary>Most particles, 1 to 16,777,216. A running fluid starts again with another in its next frame.</summary>
        public int Capacity { get => capacity; set => ConfigureIfOther(domainSize, particleSpacing, value); }

        /// <summary>Fixed steps in a second of fluid time, 10 to 1000. Acts from the next step on. Out-of-range values are clamped with a
        /// warning.</summary>
        public float StepRate { get => stepRate; set { stepRate = value; Changed(); } }

        /// <summary>Steps that one frame takes at most, 1 to 16. Acts in the next frame. Out-of-range values are clamped with a warning.</summary>
        public int MaxStepsPerFrame { get => maxStepsPerFrame; set { maxStepsPerFrame = value; Changed(); } }

        /// <summary>Of the small offsets from the lattice with which fluid is filled in. Acts at the next <see cref="Restart"/> or fill.</summary>
        public int Seed { get => seed; set => seed = value; }

        void ConfigureIfOther(Vector3 size, float spacing, int particles)
        {
            if (size != domainSize || spacing != particleSpacing || particles != capacity)
                Configure(size, spacing, particles);
        }
    }
}
