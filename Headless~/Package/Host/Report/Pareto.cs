using System;
using System.Collections.Generic;
using System.Linq;

namespace Host.Report
{
    /// <summary>Finds the settings that are worth their cost.</summary>
    static class Pareto
    {
        /// <summary>
        /// Those that no other one beats: none costs no more with no more error and is better in one of the two. By rising cost; equals stay
        /// together. What lacks a figure (NaN) is never part of it.
        /// </summary>
        public static List<T> Front<T>(IEnumerable<T> all, Func<T, double> cost, Func<T, double> error)
        {
            var front = new List<T>();
            foreach (T one in all.Where(one => !double.IsNaN(cost(one)) && !double.IsNaN(error(one))).OrderBy(cost).ThenBy(error))
            {
                bool better = front.Count == 0 || error(one) < error(front[^1]);
                bool equal = front.Count > 0 && error(one) == error(front[^1]) && cost(one) == cost(front[^1]);
                if (better || equal)
                    front.Add(one);
            }
            return front;
        }
    }
}
