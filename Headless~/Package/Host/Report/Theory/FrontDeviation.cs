using System;
using System.Collections.Generic;
using System.Linq;

namespace Host.Report
{
    /// <summary>How far a front is ahead of the mean of experiments, (Z − mean) / mean at equal T, where all of them have points and their
    /// mean is at most 3.</summary>
    sealed class FrontDeviation
    {
        /// <summary>Limits that the solver has to keep.</summary>
        public const double Lowest = -0.05, Highest = 0.10;

        const double Furthest = 3, Interval = 0.05;

        /// <summary>(T, deviation), evenly in T.</summary>
        public readonly List<(double T, double Value)> Values = new();

        public FrontDeviation(FrontSeries front, IReadOnlyList<FrontSeries> experiments)
        {
            foreach (double time in Times(experiments))
                Values.Add((time, front.At(time) / experiments.Average(series => series.At(time)) - 1));
        }

        public double Min => Values.Min(value => value.Value);
        public double Max => Values.Max(value => value.Value);
        public double Mean => Values.Average(value => value.Value);

        /// <summary>False, too, for a front that ends before the experiments do.</summary>
        public bool WithinBar => Min >= Lowest && Max <= Highest;

        static IEnumerable<double> Times(IReadOnlyList<FrontSeries> experiments)
        {
            double last = experiments.Min(series => series.Last);
            for (double time = experiments.Max(series => series.First);
                time <= last && experiments.Average(series => series.At(time)) <= Furthest; time += Interval)
                yield return time;
        }
    }
}
