using System;

namespace Rill
{
    /// <summary>
    /// Says how many particles of an emitter are due in each step: after any time the rate times that time to within one
    /// particle, whatever the steps and however the rate changes.
    /// </summary>
    struct EmissionClock
    {
        // A sum of fractions may fall a hair short of a whole particle.
        const double Tolerance = 1e-9;

        double volume;          // m³ since the last start

        /// <summary>Time since the start, s.</summary>
        public double Time { get; private set; }

        /// <summary>Particles due since the start.</summary>
        public long Due { get; private set; }

        /// <summary>The particles that become due in one step.</summary>
        public struct Fraction
        {
            public int due;
            /// <summary>Number of the first, from 0.</summary>
            public long first;
            /// <summary>Time from when the first became due to the end of the step, s.</summary>
            public float firstAge;
            /// <summary>Time between two, s.</summary>
            public float interval;
        }

        /// <summary>All of it, for a snapshot.</summary>
        public EmissionRecord Record
        {
            get => new EmissionRecord { volume = volume, time = Time, due = Due };
            set => (volume, Time, Due) = (value.volume, value.time, value.due);
        }

        /// <summary>Counts what is due in particles of another volume.</summary>
        /// <param name="particleVolume">m³, above 0.</param>
        public void Resample(double particleVolume) => Due = (long)Math.Floor(volume / particleVolume + Tolerance);

        /// <summary>Takes a step.</summary>
        /// <param name="step">s, above 0.</param>
        /// <param name="rate">m³/s, not negative.</param>
        /// <param name="from">Time at which emission begins, s.</param>
        /// <param name="until">Time at which it ends, s; may be infinite.</param>
        /// <param name="particleVolume">m³, above 0.</param>
        /// <param name="most">Particles of a step; what is beyond is due in the next.</param>
        public Fraction Advance(double step, double rate, double from, double until, double particleVolume, int most)
        {
            double start = Time, end = Time + step;
            Time = end;
            double begins = Math.Min(Math.Max(start, from), end);
            double ends = Math.Max(Math.Min(end, until), begins);
            volume += rate * (ends - begins);

            long dueBefore = Due;
            double whole = Math.Floor(volume / particleVolume + Tolerance);
            Due = (long)Math.Min(whole, dueBefore + (double)most);
            var fraction = new Fraction { due = (int)(Due - dueBefore), first = dueBefore };
            if (fraction.due > 0 && rate > 0.0)
            {
                fraction.firstAge = (float)(end - ends + (volume - (dueBefore + 1) * particleVolume) / rate);
                fraction.interval = (float)(particleVolume / rate);
            }
            return fraction;
        }
    }
}
