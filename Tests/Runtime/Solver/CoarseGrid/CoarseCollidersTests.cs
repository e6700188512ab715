using System;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>Open fractions of the coarse grid's cells and faces, against counted points. In boxes whose sides are not whole
    /// cells these are not cubes, and differ along each axis.</summary>
    public class CoarseCollidersTests
    {
        const float Spacing = 0.05f, HasRoom = 0.25f;
        const int Points = 12;      // along each side

        // Cells of 4 d, of 5 x 3.8 x 3.5 d, and of 3.8 x 3.5 x 5 d.
        static readonly float3[] Boxes = { 32f, new float3(10f, 34.5f, 14f), new float3(30f, 14f, 10f) };

        [Test]
        public void Open_fractions_of_cells_and_faces_are_those_of_counted_points([ValueSource(nameof(Boxes))] float3 box,
            [Values(ColliderShape.Sphere, ColliderShape.Box)] ColliderShape shape)
        {
            ColliderMotion collider = ColliderTests.Still(shape, shape == ColliderShape.Box ? new float3(4f, 3.5f, 3f) : 4.5f,
                box * new float3(0.45f, 0.5f, 0.55f), quaternion.Euler(0.3f, 0.5f, 0.2f));
            using (var fluid = new TestFluid(box * Spacing, Spacing, 64, ColliderDeepWaterTests.Deep))
            {
                fluid.AddBlock(0f, 4f * Spacing);
                ColliderTests.Use(fluid, collider);
                fluid.Step();
                CoarseGrid grid = fluid.Solver.Coarse.Grid;
                uint2[] open = GpuTest.Read<uint2>(fluid.Solver.Coarse.Colliders.Open, grid.Total);
                int cut = 0, cutFaces = 0, allFree = 0;
                double worst = 0.0, squares = 0.0, worstFace = 0.0, faceSquares = 0.0;
                for (int i = 0; i < grid.Total; i++)
                {
                    int3 cell = new int3(i % grid.Counts.x, i / grid.Counts.x % grid.Counts.y, i / (grid.Counts.x * grid.Counts.y));
                    float3 low = cell * grid.CellSize;
                    double volume = Open(collider, low, grid.CellSize), error = (open[i].y & 4095u) / 4095.0 - volume;
                    if (volume > 0.0 && volume < 1.0)
                        cut++;
                    squares += error * error;
                    worst = Math.Max(worst, Math.Abs(error));
                    int stride = 1;
                    for (int axis = 0; axis < 3; stride *= grid.Counts[axis++])
                    {
                        if (cell[axis] == 0 || Math.Min(Volume(open[i]), Volume(open[i - stride])) < HasRoom)
                            continue;
                        float3 size = grid.CellSize;
                        size[axis] = 0f;
                        double face = Open(collider, low, size);
                        // Each of four rays through the face that meets the solid between water takes a quarter.
                        double found = (open[i].x >> (10 * axis) & 1023u) / 1023.0;
                        int free = Enumerable.Range(1, 4).OrderBy(rays => Math.Abs(found - face * rays / 4.0)).First();
                        error = found - face * free / 4.0;
                        if (face > 0.0 && face < 1.0)
                        {
                            cutFaces++;
                            allFree += free == 4 ? 1 : 0;
                        }
                        faceSquares += error * error;
                        worstFace = Math.Max(worstFace, Math.Abs(error));
                    }
                }
                TestContext.Out.WriteLine($"{cut} cells: rms {Math.Sqrt(squares / cut):0.0000}, worst {worst:0.000}; {allFree} of {cutFaces} " +
                    "faces: rms " +
                    $"{Math.Sqrt(faceSquares / cutFaces):0.0000}, worst {worstFace:0.000}");
                Assert.That(new[] { cut, cutFaces }, Is.All.GreaterThan(15));
                Assert.That(Math.Sqrt(squares / cut), Is.LessThan(0.035));
                Assert.That(worst, Is.LessThan(0.08));
                Assert.That(Math.Sqrt(faceSquares / cutFaces), Is.LessThan(0.07));
                Assert.That(allFree, Is.GreaterThan(2 * cutFaces / 3));
            }
        }

        static double Volume(uint2 open) => (open.y & 4095u) / 4095.0;

        // Fraction of points outside of the solid, in a cell or on a face of it, which has no side along one axis.
        static double Open(in ColliderMotion collider, float3 low, float3 size)
        {
            int open = 0, count = 0;
            int3 along = new int3(size.x > 0f ? Points : 1, size.y > 0f ? Points : 1, size.z > 0f ? Points : 1);
            for (int z = 0; z < along.z; z++)
                for (int y = 0; y < along.y; y++)
                    for (int x = 0; x < along.x; x++, count++)
                        open += Reference.Shapes.Distance(collider, low + (new float3(x, y, z) + 0.5f) / along * size) > 0.0 ? 1 : 0;
            return open / (double)count;
        }
    }
}
