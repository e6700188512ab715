using System;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>Comparisons of many values at once that name the worst; NaN is never near anything.</summary>
    static class Compare
    {
        /// <summary>The positions or velocities of a buffer as the reference takes them.</summary>
        public static double3[] Points(float4[] values) => values.Select(value => (double3)value.xyz).ToArray();

        public static void Scalars(string what, int count, Func<int, double> actual, Func<int, double> expected, Func<int, double> tolerance)
        {
            Elements(what, count, i => Math.Abs(actual(i) - expected(i)), tolerance, i => $"{actual(i):g9} instead of {expected(i):g9}");
        }

        public static void Vectors(string what, int count, Func<int, double3> actual, Func<int, double3> expected, Func<int, double> tolerance)
        {
            Elements(what, count, i => math.length(actual(i) - expected(i)), tolerance, i => $"{actual(i)} instead of {expected(i)}");
        }

        /// <summary>Bit for bit.</summary>
        public static void Same(string what, float4[] actual, float4[] expected)
        {
            Assert.That(actual.Length, Is.EqualTo(expected.Length), what);
            for (int i = 0; i < actual.Length; i++)
                if (math.any(math.asuint(actual[i]) != math.asuint(expected[i])))
                    Assert.Fail($"{what}: element {i} is {actual[i]} instead of {expected[i]}, bit for bit");
        }

        public static void Same(string what, uint[] actual, uint[] expected)
        {
            Assert.That(actual.Length, Is.EqualTo(expected.Length), what);
            for (int i = 0; i < actual.Length; i++)
                if (actual[i] != expected[i])
                    Assert.Fail($"{what}: element {i} is {actual[i]} instead of {expected[i]}");
        }

        static void Elements(string what, int count, Func<int, double> error, Func<int, double> tolerance, Func<int, string> describe)
        {
            int worst = -1, wrong = 0;
            double worstFraction = 1.0;
            for (int i = 0; i < count; i++)
            {
                double fraction = error(i) / tolerance(i);
                if (fraction <= 1.0)
                    continue;
                wrong++;
                if (worst < 0 || !(fraction <= worstFraction))
                    (worst, worstFraction) = (i, fraction);
            }
            if (wrong > 0)
                Assert.Fail($"{what}: {wrong:N0} of {count:N0} are off, worst element {worst}: {describe(worst)}, {worstFraction:g3} " +
                    $"times the tolerance of {tolerance(worst):g3}");
        }
    }
}
