using System;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    public class CoarseGridTests
    {
        static readonly float3[] Domains =
        {
            new float3(2f, 2f, 2f), new float3(4f, 4f, 4f), new float3(5.9f, 6.1f, 9.9f), new float3(50f, 100f, 40f), new float3(200f, 200f, 100f),
            new float3(11f, 13f, 17f), new float3(24f, 720f, 24f), new float3(240f, 240f, 240f), new float3(432f, 432f, 216f),
                new float3(8192f, 2f, 2f), new float3(8192f, 200f, 2f),
        };

        [Test]
        public void Cells_are_whole_fill_the_domain_and_are_as_near_the_wanted_size_as_they_come(
            [ValueSource(nameof(Domains))] float3 domain, [Values(4f, 8f)] float wanted)
        {
            var grid = new CoarseGrid(domain, wanted);
            Assert.That(grid.WantedSize, Is.EqualTo(wanted));
            Assert.That(grid.Total, Is.EqualTo(grid.Counts.x * grid.Counts.y * grid.Counts.z));
            for (int axis = 0; axis < 3; axis++)
            {
                Assert.That(grid.Counts[axis] * (double)grid.CellSize[axis], Is.EqualTo((double)domain[axis]).Within(1e-6 * domain[axis]));
                double cells = domain[axis] / wanted;
                Assert.That(grid.Counts[axis], Is.GreaterThanOrEqualTo(1));
                if (cells >= 0.5)
                    Assert.That(Math.Abs(grid.Counts[axis] - cells), Is.LessThanOrEqualTo(0.5 + 1e-6), $"axis {axis}");
            }
        }

        [TestCaseSource(nameof(Domains))]
        public void Every_level_halves_the_one_before_and_lies_behind_it(float3 domain)
        {
            var grid = new CoarseGrid(domain, 4f);
            Assert.That(grid.Level(0), Is.EqualTo(new uint4((uint3)grid.Counts, 0)));
            Assert.That(grid.LevelCount, Is.InRange(1, CoarseGrid.MaxLevels - 1));
            int first = 0;
            for (int level = 1; level <= grid.LevelCount; level++)
            {
                Assert.That(grid.Level(level).xyz, Is.EqualTo((grid.Level(level - 1).xyz + 1u) / 2u), $"level {level}");
                Assert.That(grid.Level(level).w, Is.EqualTo(first), $"level {level}");
                Assert.That(grid.Cells(level), Is.EqualTo((int)(grid.Level(level).x * grid.Level(level).y * grid.Level(level).z)));
                first += grid.Cells(level);
            }
            Assert.That(grid.LevelCells, Is.EqualTo(first));
            Assert.That(grid.Cells(grid.LevelCount), Is.LessThanOrEqualTo(64));
            Assert.That(grid.Level(CoarseGrid.MaxLevels), Is.EqualTo(grid.Level(grid.LevelCount)), "beyond the last");
        }

        // Halved until 64 cells are left, and 4 along each axis: a long one would need more sweeps than it gets.
        [TestCase(100f, 8f, 8f, 3)]         // 25 x 2 x 2, 13, 7, 4
        [TestCase(8f, 100f, 8f, 3)]
        [TestCase(8f, 8f, 68f, 3)]          // 17, 9, 5, 3
        [TestCase(16f, 16f, 16f, 1)]        // 4 x 4 x 4, 2
        [TestCase(48f, 48f, 48f, 2)]        // 12, 6, 3
        [TestCase(8192f, 2f, 2f, 7)]        // 2048 and as many levels as there can be
        public void Levels_go_on_until_few_cells_are_left_in_all_and_along_each_axis(float x, float y, float z, int levels)
            => Assert.That(new CoarseGrid(new float3(x, y, z), 4f).LevelCount, Is.EqualTo(levels));

        [Test]
        public void The_shaders_get_every_level_by_itself()
        {
            CoarseLevels levels = CoarseConstants.For(new CoarseGrid(new float3(8192f, 8f, 2f), 4f)).levels;
            Assert.That(new[] { levels.level0, levels.level1, levels.level2, levels.level3, levels.level4, levels.level5, levels.level6,
                levels.level7 }, Is.EqualTo(new[] { new uint4(2048, 2, 1, 0), new uint4(1024, 1, 1, 0), new uint4(512, 1, 1, 1024),
                new uint4(256, 1, 1, 1536), new uint4(128, 1, 1, 1792), new uint4(64, 1, 1, 1920), new uint4(32, 1, 1, 1984),
                new uint4(16, 1, 1, 2016) }));
        }

        // By 2048 cells, or 1024 of 16 KB of groupshared memory: 216, 27 and 8 cells are left below 1728.
        [Test]
        public void A_tail_of_half_the_memory_holds_half_the_cells()
        {
            var large = new CoarseSolverPath(false, false);
            var small = new CoarseSolverPath(true, true);
            Assert.That((large.TailCells, small.TailCells), Is.EqualTo((2048, 1024)));
            var domain = new float3(92f, 92f, 92f);         // 23³ cells, 12³, 6³, 3³
            Assert.That(new CoarseGrid(domain, 4f, large.TailCells).FirstTailLevel, Is.EqualTo(1));
            Assert.That(new CoarseGrid(domain, 4f, small.TailCells).FirstTailLevel, Is.EqualTo(2));
        }

        [TestCaseSource(nameof(Domains))]
        public void The_tail_holds_as_many_levels_as_fit_one_thread_group(float3 domain)
        {
            var grid = new CoarseGrid(domain, 4f);
            Assert.That(grid.FirstTailLevel, Is.InRange(1, grid.LevelCount));
            Assert.That(From(grid.FirstTailLevel), Is.LessThanOrEqualTo(CoarseGrid.LargeTailCells));
            if (grid.FirstTailLevel > 1)
                Assert.That(From(grid.FirstTailLevel - 1), Is.GreaterThan(CoarseGrid.LargeTailCells), "one more level would fit");

            int From(int level) => Enumerable.Range(level, grid.LevelCount + 1 - level).Sum(grid.Cells);
        }

        [Test]
        public void The_smallest_domain_is_one_cell_with_one_level_below()
        {
            var grid = new CoarseGrid(2f, 4f);
            Assert.That(grid.Counts, Is.EqualTo(new int3(1)));
            Assert.That(grid.CellSize, Is.EqualTo(new float3(2f)));
            Assert.That(grid.LevelCount, Is.EqualTo(1));
            Assert.That(grid.FirstTailLevel, Is.EqualTo(1));
        }

        [Test]
        public void Small_grids_keep_all_their_levels_in_the_tail_and_large_ones_do_not()
        {
            Assert.That(new CoarseGrid(4f * new float3(20f, 20f, 20f), 4f).FirstTailLevel, Is.EqualTo(1));
            Assert.That(new CoarseGrid(4f * new float3(60f, 60f, 60f), 4f).FirstTailLevel, Is.EqualTo(3));
        }

        [Test]
        public void A_domain_too_large_for_cells_of_four_spacings_gets_larger_ones()
        {
            var domain = new float3(8192f, 8192f, 100f);
            float size = CoarseGrid.CellSizeFor(domain, 0.1f, 100f, 0f);
            var grid = new CoarseGrid(domain, size);
            Assert.That(size, Is.GreaterThan(8f));
            Assert.That(grid.Total, Is.LessThanOrEqualTo(CoarseGrid.MaxCells));
            Assert.That(grid.LevelCount, Is.LessThan(CoarseGrid.MaxLevels));
        }

        [TestCase(100f, 0.59f, 4f, 4f)]
        [TestCase(100f, 0.61f, 4f, 5f)]
        [TestCase(100f, 0.34f, 5f, 5f)]
        [TestCase(100f, 0.33f, 5f, 4f)]
        [TestCase(10f, 1.67f, 4f, 4f)]
        [TestCase(10f, 1.69f, 4f, 8f)]
        [TestCase(10f, 0.95f, 8f, 8f)]
        [TestCase(10f, 0.93f, 8f, 4f)]
        [TestCase(100f, 0.93f, 8f, 5f)]
        public void A_grid_that_is_there_changes_late(float layers, float gravityStep, float present, float cellSize)
        {
            Assert.That(CoarseGrid.CellSizeFor(100f, gravityStep, layers, present), Is.EqualTo(cellSize));
        }

        [TestCase(100f, 0f, 4f)]
        [TestCase(100f, 0.27f, 4f)]     // 1 m of a million particles, 60 steps a second
        [TestCase(216f, 0.59f, 5f)]     // the same of ten millions
        [TestCase(20f, 1.3f, 4f)]       // 4 cm of water, d = 2 mm
        [TestCase(20f, 1.5f, 8f)]
        [TestCase(216f, 1.5f, 8f)]
        public void Cells_grow_with_how_far_gravity_carries_in_a_step_and_with_depth(float layers, float gravityStep, float cellSize)
        {
            Assert.That(CoarseGrid.CellSizeFor(100f, gravityStep, layers, 0f), Is.EqualTo(cellSize));
        }

        [TestCase(4f, true)]
        [TestCase(5f, true)]
        [TestCase(8f, true)]
        [TestCase(6f, false)]
        [TestCase(0f, false)]
        [TestCase(float.NaN, false)]
        public void Only_the_sides_that_it_chooses_from_are_sides_of_cells(float size, bool isOne)
        {
            Assert.That(CoarseGrid.IsCellSize(100f, size), Is.EqualTo(isOne));
        }
    }
}
