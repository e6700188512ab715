using Unity.Mathematics;

namespace Rill
{
    /// <summary>The steps that colliders are gathered for, and the fluid that takes them.</summary>
    readonly struct CollectedSteps
    {
        public readonly FluidSimulation fluid;
        public readonly DomainFrame frame;
        /// <summary>Size of the domain, d.</summary>
        public readonly float3 size;
        public readonly FixedStepClock clock;
        /// <summary>Fluid time of the steps, s.</summary>
        public readonly float duration;
        /// <summary>Length of a substep, s.</summary>
        public readonly float substepTime;

        public CollectedSteps(FluidSimulation fluid, in DomainFrame frame, float3 size, FixedStepClock clock, float duration, float substepTime)
        {
            this.fluid = fluid;
            this.frame = frame;
            this.size = size;
            this.clock = clock;
            this.duration = duration;
            this.substepTime = substepTime;
        }
    }
}
