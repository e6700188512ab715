using System;
using System.Collections.Generic;
using System.Linq;

namespace Host.Report
{
    /// <summary>x(t) = offset + amplitude e^(−damping t) cos(frequency t + phase), fitted to samples by least squares.</summary>
    sealed class DampedCosine
    {
        const int CoarseSteps = 400;
        const double MaxCycles = 40;

        double start, cosine, sine;

        public double Offset { get; private set; }
        public double Amplitude { get; private set; }
        /// <summary>1/s.</summary>
        public double Damping { get; private set; }
        /// <summary>rad/s.</summary>
        public double Frequency { get; private set; }
        public double Period => 2 * Math.PI / Frequency;
        /// <summary>Rms of what is left over the amplitude: near 0 where the samples are such a curve.</summary>
        public double Misfit { get; private set; }

        /// <param name="time">As in the samples.</param>
        public double At(double time) => Offset + Math.Exp(-Damping * (time - start))
            * (cosine * Math.Cos(Frequency * (time - start)) + sine * Math.Sin(Frequency * (time - start)));

        /// <exception cref="ArgumentException">Fewer samples than the curve needs.</exception>
        public static DampedCosine Fit(IReadOnlyList<(double Time, double Value)> samples)
        {
            if (samples.Count < 8)
                throw new ArgumentException($"{samples.Count} samples: a damped cosine needs at least 8.");
            var fit = new DampedCosine();
            double span = samples[^1].Time - samples[0].Time;
            // No guess from theory: every frequency from half a cycle in all to 40 is tried, then the best one is refined.
            double frequencyStep = 2 * Math.PI * MaxCycles / span / CoarseSteps, dampingStep = 0.5 / span;
            double best = double.MaxValue, frequency = 0, damping = 0;
            for (int i = 5; i <= CoarseSteps; i++)
                for (int j = 0; j <= 6; j++)
                    if (fit.Solve(samples, i * frequencyStep, j * dampingStep) is double error && error < best)
                        (best, frequency, damping) = (error, i * frequencyStep, j * dampingStep);
            while (frequencyStep > 1e-9 * frequency)
            {
                bool better = false;
                foreach ((double f, double d) in new[] { (frequencyStep, 0), (-frequencyStep, 0), (0, dampingStep), (0.0, -dampingStep) })
                    if (fit.Solve(samples, frequency + f, damping + d) is double error && error < best)
                        (best, frequency, damping, better) = (error, frequency + f, damping + d, true);
                if (!better)
                {
                    frequencyStep /= 2;
                    dampingStep /= 2;
                }
            }
            fit.Solve(samples, frequency, damping);
            return fit;
        }

        // With frequency and damping given the rest is linear: normal equations of 3 unknowns. Returns the sum of squares that is left.
        double? Solve(IReadOnlyList<(double Time, double Value)> samples, double frequency, double damping)
        {
            var m = new double[3, 4];
            foreach ((double time, double value) in samples)
            {
                double[] row = Row(time - samples[0].Time, frequency, damping);
                for (int i = 0; i < 3; i++)
                {
                    for (int j = 0; j < 3; j++)
                        m[i, j] += row[i] * row[j];
                    m[i, 3] += row[i] * value;
                }
            }
            if (Eliminate(m) is not double[] x)
                return null;
            double left = samples.Sum(sample =>
            {
                double[] row = Row(sample.Time - samples[0].Time, frequency, damping);
                double difference = sample.Value - (x[0] + x[1] * row[1] + x[2] * row[2]);
                return difference * difference;
            });
            start = samples[0].Time;
            (Offset, cosine, sine) = (x[0], x[1], x[2]);
            Amplitude = Math.Sqrt(x[1] * x[1] + x[2] * x[2]);
            Frequency = frequency;
            Damping = damping;
            Misfit = Math.Sqrt(left / samples.Count) / Amplitude;
            return left;
        }

        static double[] Row(double time, double frequency, double damping)
        {
            double decay = Math.Exp(-damping * time);
            return new[] { 1, decay * Math.Cos(frequency * time), decay * Math.Sin(frequency * time) };
        }

        static double[] Eliminate(double[,] m)
        {
            for (int i = 0; i < 3; i++)
            {
                if (!(Math.Abs(m[i, i]) > 1e-12))
                    return null;
                for (int row = 0; row < 3; row++)
                {
                    double factor = row == i ? 0 : m[row, i] / m[i, i];
                    for (int column = i; column < 4; column++)
                        m[row, column] -= factor * m[i, column];
                }
            }
            return new[] { m[0, 3] / m[0, 0], m[1, 3] / m[1, 1], m[2, 3] / m[2, 2] };
        }
    }
}
