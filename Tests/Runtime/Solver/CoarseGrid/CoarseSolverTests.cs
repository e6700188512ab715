using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Rill.Tests.Reference;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>The V-cycle against a solution in double precision, on each path that the device runs.</summary>
    [TestFixture(Largest), TestFixture(Small)]      // known without a device, which who lists the fixtures may not have
    public class CoarseSolverTests
    {
        const string Largest = "the largest kernels of the device", Small = "small kernels";

        readonly CoarseSolverPath path;

        public CoarseSolverTests(string path) => this.path = PathOf(path);

        static CoarseSolverPath PathOf(string name) => name == Small ? SmallPath : CoarseSolverPath.For(DeviceLimits.Current);

        static CoarseSolverPath LargePath => new CoarseSolverPath(smallTiles: false, smallTail: false);
        static CoarseSolverPath SmallPath => new CoarseSolverPath(smallTiles: true, smallTail: true);

        const float Inactive = CoarseConstants.Inactive;
        const float CellSize = 4f;
        const int EnoughCycles = 60, EnoughOfFullBox = 200;

        // Means of the right-hand side, which varies by 0.2 about them: where it is negative for long, phi >= 0 binds.
        const double Dense = 0.2, Dilute = 0.02, VeryDilute = -0.03;

        // Cells along each axis, and the fill of a cell from its relative and a random number from 0 to 1.
        static readonly Dictionary<string, (int3 counts, Func<int3, double, double> fill)> Boxes = new Dictionary<string,
            (int3, Func<int3, double, double>)>
        {
            ["one cell"] = (new int3(1, 1, 1), (cell, random) => 1.0),
            ["one active cell"] = (new int3(5, 5, 5), (cell, random) => math.all(cell == 2) ? 0.8 : 0.1),
            ["no active cell"] = (new int3(5, 5, 5), (cell, random) => 0.59 * random),
            ["full box"] = (new int3(20, 20, 20), (cell, random) => 0.9 + 0.2 * random),
            ["half filled box"] = (new int3(20, 20, 20), (cell, random) => BelowSurface(cell.y, 10, random)),
            ["primes"] = (new int3(7, 13, 11), (cell, random) => BelowSurface(cell.y, 9, random)),
            ["scattered cells"] = (new int3(17, 13, 19), (cell, random) => random),
            ["deep column"] = (new int3(6, 60, 6), (cell, random) => BelowSurface(cell.y, 50, random)),
            ["large half filled box"] = (new int3(50, 50, 50), (cell, random) => BelowSurface(cell.y, 25, random)),
            ["half filled, one level above the tail"] = (new int3(28, 28, 28), (cell, random) => BelowSurface(cell.y, 14, random)),
            ["25 rows"] = (new int3(6, 75, 6), (cell, random) => Rows(cell.y, 25)),
            ["49 rows"] = (new int3(6, 150, 6), (cell, random) => Rows(cell.y, 49)),
            ["full box of odd sides"] = (new int3(33, 17, 33), (cell, random) => 1.0),
        };

        static IEnumerable<string> Names => Boxes.Keys;

        // Largest factor by which a cycle leaves the residual. Aggregates that keep the free surface's faces in full are too stiff
        // below it, the more so the deeper the water is; a calm surface is worth that. So is a surface that lies near a cell's center,
        // whose row is up to ten times as large. A full box is held by the screening alone; what all its water has in common comes late
        // and moves nothing.
        static double MaxLeft(string name)
        {
            switch (name)
            {
                case "full box": return 0.95;
                case "full box of odd sides": return 0.75;
                case "deep column":
                case "49 rows": return 0.55;
                default: return 0.45;
            }
        }

        [TestCaseSource(nameof(Names))]
        public void Cycles_converge_to_the_reference(string name)
        {
            using (var problem = new Problem(name, Dense, path))
            {
                double first = problem.Reference.Residual(new double[problem.Cells.Total]), residual = first;
                int cycles = 0;
                // Iterates as far as single precision carries.
                for (; cycles < 12 && residual > 1e-4 * first; cycles++)
                    residual = problem.Reference.Residual(problem.Cycle().Potential);
                double factor = cycles == 0 ? 0.0 : Math.Pow(residual / first, 1.0 / cycles);
                TestContext.Out.WriteLine($"{name}: the residual falls to {factor:0.000} in a cycle, mean of {cycles}");
                Assert.That(factor, Is.LessThan(MaxLeft(name)));
                problem.Cycle((name.StartsWith("full") ? EnoughOfFullBox : EnoughCycles) - cycles);
                problem.AssertSolution(1e-3);
            }
        }

        [TestCase("full box", VeryDilute)]
        [TestCase("half filled box", Dilute)]
        [TestCase("primes", VeryDilute)]
        [TestCase("scattered cells", Dilute)]
        [TestCase("deep column", VeryDilute)]
        [TestCase("half filled, one level above the tail", Dilute)]
        [TestCase("large half filled box", Dilute, Category = "LongRun")]
        public void Where_the_water_would_be_in_tension_the_potential_is_zero_and_the_rest_converges(string name, double source)
        {
            using (var problem = new Problem(name, source, path))
            {
                problem.Cycle(EnoughCycles);
                Assert.That(problem.Raw.Where((value, cell) => problem.Cells.active[cell]).Count(value => value == 0f), Is.GreaterThan(20),
                    "no cell is in tension");
                problem.AssertSolution(1e-3);
            }
        }

        [TestCase("half filled box")]
        [TestCase("half filled, one level above the tail")]
        [TestCase("scattered cells")]
        public void After_every_cycle_the_potential_is_nowhere_negative_and_zero_in_inactive_cells(string name)
        {
            using (var problem = new Problem(name, Dilute, path))
            {
                for (int cycle = 0; cycle < 6; cycle++)
                {
                    float[] potential = problem.Cycle().Raw;
                    for (int cell = 0; cell < potential.Length; cell++)
                        if (!(potential[cell] >= 0f) || float.IsInfinity(potential[cell]) || !problem.Cells.active[cell] && potential[cell] != 0f)
                            Assert.Fail($"cycle {cycle}, cell {cell}: {potential[cell]}, {(problem.Cells.active[cell] ? "active" : "inactive")}");
                }
            }
        }

        [Test]
        public void Two_runs_give_the_same_potential_bit_for_bit()
        {
            const string name = "half filled, one level above the tail";
            using (Problem one = new Problem(name, Dilute, path).Cycle(3), other = new Problem(name, Dilute, path).Cycle(3))
                Compare.Same("potential", other.Raw.Select(math.asuint).ToArray(), one.Raw.Select(math.asuint).ToArray());
        }

        // Oil of a quarter of the density of the water beside and below it. Kernels for several densities have small tiles on every path.
        [TestCase("half filled box")]
        [TestCase("primes")]
        [TestCase("half filled, one level above the tail")]
        public void With_two_densities_cycles_converge_to_the_reference(string name)
        {
            using (var problem = new Problem(name, Dense, path, (cell, counts) => 2 * cell.x > counts.x && 4 * cell.y > counts.y ? 0.25 : 1.0))
            {
                problem.Cycle(EnoughCycles);
                problem.AssertSolution(1e-3);
            }
        }

        [TestCase("half filled box")]
        [TestCase("deep column")]
        public void A_cycle_starts_from_the_potential_that_it_is_given(string name)
        {
            using (var problem = new Problem(name, Dense, path))
            {
                double cold = problem.Reference.Residual(problem.Cycle().Potential);
                double[] solved = problem.Cycle(EnoughCycles).Potential;
                double[] again = problem.Cycle().Potential;
                double largest = solved.Max();
                Compare.Scalars("potential", solved.Length, i => again[i], i => solved[i], i => 1e-4 * largest);
                Assert.That(problem.Reference.Residual(again), Is.LessThan(1e-2 * cold));
            }
        }

        [Test]
        public void A_reference_of_another_equation_is_noticed()
        {
            using (var problem = new Problem("primes", Dense, path))
            {
                problem.Cycle(15).AssertSolution(1e-3);
                problem.Cells.active[problem.Cells.Index(new int3(3, 4, 5))] = false;
                Assert.That(() => problem.AssertSolution(1e-3), Throws.InstanceOf<AssertionException>());
            }
        }

        [Test]
        public void The_boxes_have_none_one_and_two_levels_above_the_tail()
        {
            foreach ((string name, int first) in new[] { ("half filled box", path.SmallTail ? 2 : 1),
                ("half filled, one level above the tail", 2), ("large half filled box", 3), ("primes", 1) })
                Assert.That(new CoarseGrid(CellSize * (float3)Boxes[name].counts, CellSize, path.TailCells).FirstTailLevel, Is.EqualTo(first), name);
        }

        [TestCase("large half filled box")]
        [TestCase("primes")]
        [TestCase("scattered cells")]
        public void Tiles_of_each_size_give_the_same_potential_bit_for_bit(string name)
        {
            uint[] expected = null;
            foreach (string other in new[] { Largest, Small })
            {
                var tiles = new CoarseSolverPath(PathOf(other).SmallTiles, smallTail: true);
                using (Problem problem = new Problem(name, Dilute, tiles).Cycle(3))
                {
                    uint[] actual = problem.Raw.Select(math.asuint).ToArray();
                    expected = expected ?? actual;
                    Compare.Same(other, actual, expected);
                }
            }
            Assert.That(expected, Has.Some.Not.Zero);
        }

        [Test]
        public void A_device_gets_the_largest_kernels_that_it_holds()
        {
            CoarseSolverPath For(int threads, int groupshared) => CoarseSolverPath.For(new DeviceLimits(16, 16, threads, groupshared));
            Assert.That(For(1024, 32768), Is.EqualTo(LargePath));
            Assert.That(For(256, 32768), Is.EqualTo(new CoarseSolverPath(smallTiles: false, smallTail: true)));
            Assert.That(For(1024, 16384), Is.EqualTo(SmallPath));
            Assert.That(For(256, 16384), Is.EqualTo(SmallPath));
        }

        // One row more than what fills a coarse cell: up to the third level and further the top one is alone in its cell.
        static double Rows(int y, int rows) => y < rows - 1 ? 1.0 : y == rows - 1 ? 0.8 : 0.0;

        // Full cells, a layer of any fill, none above.
        static double BelowSurface(int y, int surface, double random) => y < surface ? 0.9 + 0.2 * random : y == surface ? random : 0.0;

        /// <summary>An equation on some grid, on the device and in the reference.</summary>
        sealed class Problem : IDisposable
        {
            public readonly CoarseCells Cells;
            public readonly CoarsePotential Reference;
            public readonly CoarseGrid Grid;
            readonly CoarseSolver solver;
            readonly GraphicsBuffer constants, source, diagonal, potential, densities;

            /// <param name="mean">Of the right-hand side.</param>
            /// <param name="densityOf">Density of a cell by its index, relative to the heaviest's, in a grid of so many; null for 1.</param>
            public Problem(string name, double mean, CoarseSolverPath path, Func<int3, int3, double> densityOf = null)
            {
                (int3 counts, Func<int3, double, double> fill) = Boxes[name];
                Grid = new CoarseGrid(CellSize * (float3)counts, CellSize, path.TailCells);
                Cells = new CoarseCells(CellSize * (double3)counts, counts);
                var random = new Unity.Mathematics.Random(811);
                var sources = new float[Cells.Total];
                var diagonals = new float[Cells.Total];
                for (int cell = 0; cell < Cells.Total; cell++)
                {
                    Cells.fill[cell] = fill(Cells.Coordinates(cell), random.NextDouble());
                    Cells.active[cell] = Cells.fill[cell] >= 0.6;
                }
                double[] rho = densityOf == null ? null
                    : Enumerable.Range(0, Cells.Total).Select(cell => densityOf(Cells.Coordinates(cell), counts)).ToArray();
                for (int cell = 0; cell < Cells.Total; cell++)
                {
                    double3 relative = (double3)Cells.Coordinates(cell) / counts;
                    double smooth = 0.1 * Math.Sin(7.0 * relative.x) * Math.Cos(5.0 * relative.z) + mean;
                    sources[cell] = Cells.active[cell] ? (float)(smooth + random.NextDouble(-0.1, 0.1)) : Inactive;
                    diagonals[cell] = Cells.active[cell] ? (float)Cells.Diagonal(cell, rho) : 1f;
                }
                Reference = new CoarsePotential(Cells, sources.Select(s => (double)s).ToArray(), diagonals.Select(d => (double)d).ToArray(),
                    rho);
                solver = new CoarseSolver(Grid, path);
                constants = GpuTest.UploadConstants(CoarseConstants.For(Grid));
                source = GpuTest.Upload("Source", sources);
                diagonal = GpuTest.Upload("Diagonal", diagonals);
                potential = GpuTest.Upload("Potential", new float[Cells.Total]);
                densities = rho == null ? null : GpuTest.Upload("Densities", rho.Select(value => (float)value).ToArray());
            }

            public double[] Potential => Raw.Select(value => (double)value).ToArray();

            public float[] Raw => GpuTest.Read<float>(potential, Cells.Total);

            public Problem Cycle(int count = 1)
            {
                for (int i = 0; i < count; i++)
                    GpuTest.Run(cmd => solver.Record(cmd, constants, source, diagonal, potential, densities: densities));
                return this;
            }

            /// <summary>Fails unless each cell is as near to the reference as a fraction of the largest potential.</summary>
            public void AssertSolution(double fraction)
            {
                double[] expected = Reference.Solve(1.9, fraction: Cells.Total > 100000 ? 1e-6 : 1e-8), actual = Potential;
                double largest = expected.Max();
                double error = Enumerable.Range(0, expected.Length).Max(i => Math.Abs(actual[i] - expected[i]));
                TestContext.Out.WriteLine($"off by at most {error / Math.Max(largest, 1e-30):g3} of {largest:g4}");
                Compare.Scalars("potential", expected.Length, i => actual[i], i => expected[i], i => fraction * largest + 1e-12);
            }

            public void Dispose()
            {
                solver.Dispose();
                constants.Release();
                source.Release();
                diagonal.Release();
                potential.Release();
                densities?.Release();
            }
        }
    }
}
