using System;

namespace Host.Report
{
    static class Percentile
    {
        /// <summary>The value that a fraction of all values does not exceed, linear between the two nearest ranks. Sorts the values.</summary>
        /// <param name="fraction">0 (the least) to 1 (the largest).</param>
        public static double Of(float[] values, double fraction)
        {
            if (values.Length == 0)
                throw new ArgumentException("A percentile needs at least one value.");
            Array.Sort(values);
            double rank = fraction * (values.Length - 1);
            int below = (int)rank;
            int above = Math.Min(below + 1, values.Length - 1);
            return values[below] + (rank - below) * (values[above] - values[below]);
        }
    }
}
