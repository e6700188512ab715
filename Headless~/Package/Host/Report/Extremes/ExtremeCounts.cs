using System;
using System.Collections.Generic;
using System.Linq;
using Rill;

namespace Host.Report.Extremes
{
    /// <summary>Counts of the particles of a case: what every case has to account for.</summary>
    sealed record ExtremeCounts(long Added, int Alive, int Refused, int NonFinite, int Escaped, int Coincident, int Overflow, float SpeedMax)
    {
        /// <param name="samples">All that were measured; the last is of the end.</param>
        public static ExtremeCounts Of(long added, IReadOnlyList<FluidStatistics> samples)
        {
            FluidStatistics last = samples[^1];
            return new ExtremeCounts(added, last.particles, last.refused, last.nonFinite, samples.Max(s => s.escaped), last.coincident,
                samples.Max(s => s.neighborOverflow), samples.Max(s => s.speedMax));
        }

        /// <summary>Checks what holds in any case: no particle outside, no particle lost uncounted, no particle without a number for a
        /// speed.</summary>
        public IEnumerable<string> Broken()
        {
            if (Escaped != 0)
                yield return $"{Escaped} particles outside";
            if (Alive + (long)Refused + NonFinite != Added)
                yield return $"{Added - Alive - Refused - NonFinite} particles lost uncounted";
            if (!float.IsFinite(SpeedMax))
                yield return "a speed is not finite";
        }
    }
}
