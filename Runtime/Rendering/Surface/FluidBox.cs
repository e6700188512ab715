using UnityEngine;

namespace Rill
{
    /// <summary>The box of a fluid in the world.</summary>
    readonly struct FluidBox
    {
        /// <summary>From the domain's frame in d to the world.</summary>
        public readonly Matrix4x4 DomainToWorld;

        /// <summary>d.</summary>
        public readonly Vector3 Size;

        /// <summary>Particle spacing, m.</summary>
        public readonly float Spacing;

        public FluidBox(Matrix4x4 domainToWorld, Vector3 size, float spacing)
        {
            DomainToWorld = domainToWorld;
            Size = size;
            Spacing = spacing;
        }

        public FluidBox(FluidSimulation fluid) : this(fluid.DomainToWorld, fluid.DomainSize / fluid.ParticleSpacing, fluid.ParticleSpacing) { }
    }
}
