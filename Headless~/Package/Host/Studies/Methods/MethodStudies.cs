using System.Collections.Generic;
using System.Linq;
using Rill;

namespace Host.Studies.Methods
{
    /// <summary>Which methods and parameters are compared: accelerators of the passes.</summary>
    static partial class MethodStudies
    {
        static readonly float[] Relaxations = { 0.3f, 0.5f, 0.8f, 1f, 1.1f, 1.2f, 1.3f, 1.4f, 1.5f };

        /// <param name="quick">A few points of each.</param>
        public static IEnumerable<MethodStudy> All(bool quick)
        {
            yield return new MethodStudy("iterations", "Jacobi passes", "iterations",
                Iterations(quick ? new[] { 2, 4 } : new[] { 1, 2, 4, 8, 16 }).ToArray(), true);
            yield return new MethodStudy("omega", "Relaxation", "relaxation", Omega(quick ? new[] { 1.2f } : Relaxations).ToArray());
            yield return new MethodStudy("neighbor-mean", "Neighbors' mean (eq. 4.14)", "fraction of the neighbors' mean",
                (quick ? new[] { 0.5f } : new[] { 0.01f, 0.03f, 0.1f, 0.3f, 0.6f, 0.9f, 1f, 1.1f, 1.3f }).Select(NeighborMeanAt).ToArray());
            yield return new MethodStudy("chebyshev", "Chebyshev (Wang 2015)", "spectral radius", Chebyshev(quick).ToArray());
            yield return new MethodStudy("srj", "Scheduled relaxation", "lowest eigenvalue of the schedule", Scheduled(quick).ToArray(), true);
            yield return new MethodStudy("nesterov", "Nesterov", "iterations", Nesterov(quick).ToArray(), true);
            yield return new MethodStudy("gauss-seidel", "Colored Gauss-Seidel", "relaxation", GaussSeidelRuns(quick).ToArray());
            yield return new MethodStudy("substeps", "Substeps against iterations", "substeps", Substeps(quick).ToArray(), true);
            foreach (MethodStudy study in Coarse(quick))
                yield return study;
        }

        static IEnumerable<MethodVariant> Iterations(int[] counts)
        {
            foreach (int count in counts)
            {
                yield return new MethodVariant { Series = "Jacobi", Value = count, Iterations = count };
                yield return new MethodVariant { Series = "two-level", Value = count, Iterations = count, TwoLevel = true };
            }
        }

        static IEnumerable<MethodVariant> Omega(float[] values)
        {
            foreach (float value in values)
            {
                yield return new MethodVariant { Series = "Jacobi, k 4", Value = value, Iterations = 4, Relaxation = value };
                yield return new MethodVariant { Series = "two-level, k 2", Value = value, Iterations = 2, Relaxation = value, TwoLevel = true };
            }
        }

        static MethodVariant NeighborMeanAt(float fraction) =>
            new() { Series = "neighbors' mean, k 4", Value = fraction, Iterations = 4, Method = () => new NeighborMean(fraction),
            PassesPerIteration = 3 };

        static IEnumerable<MethodVariant> Chebyshev(bool quick)
        {
            foreach (double radius in quick ? new[] { 0.8 } : new[] { 0.5, 0.8, 0.9, 0.95, 0.99 })
            {
                yield return At("Chebyshev, k 8, S 2", radius, 8, 2, false);
                if (quick)
                    continue;
                yield return At("Chebyshev, k 4, S 1", radius, 4, 1, false);
                yield return At("Chebyshev, k 16, S 4", radius, 16, 4, false);
                yield return At("two-level Chebyshev, k 4, S 1", radius, 4, 1, true);
            }

            static MethodVariant At(string series, double radius, int iterations, int start, bool twoLevel) =>
                new() { Series = series, Value = radius, Iterations = iterations, TwoLevel = twoLevel,
                Method = () => new ChebyshevJacobi(radius, start) };
        }

        // The highest eigenvalue: twice the inverse of the largest stable relaxation of many passes, 1.3.
        const double MaxEigenvalue = 2 / 1.3;

        static IEnumerable<MethodVariant> Scheduled(bool quick)
        {
            foreach (double lowest in quick ? new[] { 0.3 } : new[] { 0.03, 0.1, 0.3, 0.6 })
                foreach (int iterations in quick ? new[] { 4 } : new[] { 4, 8, 16 })
                {
                    yield return At("SRJ", lowest, iterations, false);
                    if (!quick && iterations == 4)
                        yield return At("two-level SRJ", lowest, iterations, true);
                }
            if (!quick)
                yield return new MethodVariant
                {
                    Series = "SRJ of Yang and Mittal, k 16", Value = 0.01, Label = "P 2 N 16", Iterations = 16,
                    Method = () => new ScheduledJacobi(ScheduledJacobi.YangMittal16()),
                };

            static MethodVariant At(string series, double lowest, int iterations, bool twoLevel) => new()
            {
                Series = $"{series}, k {iterations}", Value = lowest, Iterations = iterations, TwoLevel = twoLevel,
                Method = () => new ScheduledJacobi(ScheduledJacobi.Optimal(iterations, lowest, MaxEigenvalue)),
            };
        }

        static IEnumerable<MethodVariant> Nesterov(bool quick)
        {
            foreach (int iterations in quick ? new[] { 4 } : new[] { 4, 8, 16 })
            {
                yield return At("Nesterov with restart", true, iterations, false);
                if (quick)
                    continue;
                yield return At("Nesterov without restart", false, iterations, false);
                yield return At("two-level Nesterov with restart", true, iterations, true);
            }

            static MethodVariant At(string series, bool restart, int iterations, bool twoLevel) =>
                new() { Series = series, Value = iterations, Iterations = iterations, TwoLevel = twoLevel,
                Method = () => new NesterovJacobi(restart) };
        }

        static IEnumerable<MethodVariant> GaussSeidelRuns(bool quick)
        {
            foreach (float relaxation in quick ? new[] { 1f } : new[] { 0.8f, 1.2f, 1.6f, 1.9f })
            {
                yield return At("8 colors", false, relaxation, 2, false);
                yield return At("27 colors", true, relaxation, 2, false);
                if (quick)
                    continue;
                yield return At("two-level, 8 colors", false, relaxation, 1, true);
                yield return At("two-level, 27 colors", true, relaxation, 1, true);
            }

            static MethodVariant At(string series, bool byConstraint, float relaxation, int iterations, bool twoLevel) => new()
            {
                Series = $"{series}, k {iterations}", Value = relaxation, Relaxation = relaxation, Iterations = iterations, TwoLevel = twoLevel,
                Method = () => new GaussSeidel(byConstraint),
            };
        }

        static IEnumerable<MethodVariant> Substeps(bool quick)
        {
            if (quick)
            {
                yield return At("Jacobi, 4 passes", false, 2, 2);
                yield break;
            }
            foreach (int passes in new[] { 8, 16 })
                for (int substeps = 1; substeps <= passes; substeps *= 2)
                    yield return At($"Jacobi, {passes} passes", false, substeps, passes / substeps);
            foreach (int passes in new[] { 4, 8 })
                for (int substeps = 1; substeps <= passes; substeps *= 2)
                    yield return At($"two-level, {passes} passes", true, substeps, passes / substeps);

            static MethodVariant At(string series, bool twoLevel, int substeps, int iterations)
            {
                // One iteration alone is stable up to a relaxation of 0.3 only.
                float relaxation = System.Math.Min(SolverSettings.Default.relaxation, SolverSettings.MaxRelaxation(iterations, twoLevel));
                return new MethodVariant { Series = series, Value = substeps, Substeps = substeps, Iterations = iterations,
                    TwoLevel = twoLevel, Relaxation = relaxation };
            }
        }
    }
}
