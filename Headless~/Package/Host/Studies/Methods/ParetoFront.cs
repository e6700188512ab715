using System;
using System.Collections.Generic;
using System.Linq;

namespace Host.Studies.Methods
{
    /// <summary>Which of several runs no one beats.</summary>
    static class ParetoFront
    {
        /// <summary>Times and errors repeat to about this: less is no difference.</summary>
        public const double Same = 0.02;

        /// <summary>A run leaves the front for one that is better by at least this fraction in one cost, and nowhere worse.</summary>
        public const double Better = 0.05;

        /// <param name="costs">Of a run, each 0 or more; the less the better.</param>
        public static List<T> Of<T>(IReadOnlyCollection<T> runs, Func<T, double[]> costs)
        {
            List<(T run, double[] costs)> all = runs.Select(run => (run, costs(run))).ToList();
            return all.Where(one => !all.Any(other => Beats(other.costs, one.costs))).Select(one => one.run).ToList();
        }

        public static bool Beats(double[] one, double[] other)
        {
            bool better = false;
            for (int i = 0; i < one.Length; i++)
            {
                if (one[i] > other[i] * (1 + Same))
                    return false;
                better |= one[i] < other[i] * (1 - Better);
            }
            return better;
        }
    }
}
