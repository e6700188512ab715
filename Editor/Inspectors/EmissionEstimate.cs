using System;
using static System.FormattableString;

namespace Rill.Editor
{
    /// <summary>How many particles an emitter lets in, and how long the capacity holds them.</summary>
    static class EmissionEstimate
    {
        const double Minute = 60.0, Hour = 3600.0;      // s

        /// <summary>Particles in a second.</summary>
        public static double PerSecond(FluidEmitter emitter, float spacing)
            => emitter.Rate / ((double)spacing * spacing * spacing);

        public static string RateText(FluidEmitter emitter, FluidSimulation fluid)
            => Invariant($"about {PerSecond(emitter, fluid.ParticleSpacing):N0} particles a second");

        /// <summary>When what is left of the capacity is full, by this emitter alone.</summary>
        public static string CapacityText(FluidEmitter emitter, FluidSimulation fluid)
        {
            double held = fluid.TryGetStatistics(out FluidStatistics statistics) ? statistics.particles : FillEstimate.Particles(fluid);
            double free = Math.Max(fluid.Capacity - held, 0.0), rate = PerSecond(emitter, fluid.ParticleSpacing);
            string left = Invariant($"{free:N0} of {fluid.Capacity:N0} left");
            if (free == 0.0)
                return left + ": what it lets in is refused. Raise the capacity.";
            if (!(rate > 0.0))
                return left;
            if (emitter.Duration > 0f && emitter.Duration * rate <= free)
                return Invariant($"{left}, enough for the {emitter.Duration * rate:N0} of its duration");
            return $"{left}, full after {TimeText(free / rate)} of this emitter alone";
        }

        static string TimeText(double seconds)
        {
            if (seconds < 2.0 * Minute)
                return Invariant($"{seconds:0.#} s");
            return seconds < 2.0 * Hour ? Invariant($"{seconds / Minute:0} min") : Invariant($"{seconds / Hour:0} h");
        }
    }
}
