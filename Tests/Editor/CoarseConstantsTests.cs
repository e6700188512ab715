using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Editor.Tests
{
    public class CoarseConstantsTests
    {
        [Test]
        public void Values_are_those_of_the_grid()
        {
            var grid = new CoarseGrid(new float3(10f, 41f, 2f), 4f);
            Assert.That(grid.Counts, Is.EqualTo(new int3(2, 10, 1)));
            CoarseConstants constants = CoarseConstants.For(grid);
            Assert.That(constants.coarseCounts, Is.EqualTo(new uint3(2, 10, 1)));
            Assert.That(constants.coarseTotal, Is.EqualTo(20));
            double volume = 5.0 * 4.1 * 2.0;
            Near(constants.inverseVolume, 1.0 / volume);
            Assert.That(constants.activeCount, Is.EqualTo(24f), "two layers across a cell are 23.8 particles");
            Near(constants.inverseCoarseSize.y, 1.0 / 4.1);
            Near(constants.coupling.x, 1.0 / 25.0);
            Near(constants.coupling.y, 1.0 / (4.1 * 4.1));
            Near(constants.coupling.z, 1.0 / 4.0);
            Near(constants.screening, 1.0 / 90000.0);
            Near(constants.negativeFraction, 0.3);
            Near(constants.minSurfaceDistance, 0.1);
            Near(constants.maxSurfaceDistance, 1.5);
            Assert.That(constants.levelCount, Is.EqualTo(2));
            Assert.That(constants.levels.level1, Is.EqualTo(new uint4(1, 5, 1, 0)));
            Assert.That(constants.levels.level2, Is.EqualTo(new uint4(1, 3, 1, 5)));
            Assert.That(constants.levels.level7, Is.EqualTo(constants.levels.level2));

            void Near(float actual, double expected) => Assert.That(actual, Is.EqualTo(expected).Within(1e-6 * expected));
        }

        [TestCase(4f, 32)]
        [TestCase(8f, 128)]
        public void Two_layers_across_a_cell_make_it_active_whatever_its_size(float cellSize, int particles)
        {
            Assert.That(CoarseConstants.For(new CoarseGrid(new float3(80f, 40f, 64f), cellSize)).activeCount, Is.EqualTo((float)particles));
        }
    }
}
