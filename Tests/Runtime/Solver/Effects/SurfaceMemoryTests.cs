using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>The GPU memory of the surface's mesh and its planes, by their descriptions.</summary>
    public class SurfaceMemoryTests
    {
        const float Spacing = 0.05f;
        const float Medium = 0.75f;

        // A box of 64 d: 22 bricks along each axis. Room for 2,224 bricks, 16,096 vertices and as many quads, and 56,864 elements.
        [Test]
        public void A_mesh_takes_this_for_20000_particles()
        {
            Dictionary<string, long> bytes = BytesFor(20000, Medium);
            Assert.That(bytes, Is.EquivalentTo(new Dictionary<string, long>
            {
                { "Rill.Surface", 32 * 56864 },
                { "Rill.Surface.Workspace", 512 * 2224 },
                { "Rill.Surface.PlanesBefore", 16 * 20000 },
                { "Rill.Surface.Counters", 12 },
                { "Rill.Surface.Arguments", 64 },
                { "Rill.Mesh.Marks", 4 * (22 * 22 * 22 + 1) },
                { "Rill.Mesh.MarksBefore", 4 * (22 * 22 * 22 + 1) },
                { "Rill.Mesh.Top", 4 * 22 * 22 * 22 },
                { "Rill.Mesh.BrickPlaces", 4 * 2224 },
                { "Rill.Mesh.Field", 2 * 160 * 160 * 15 },
                { "Rill.Mesh.CellMasks", 8 * 2224 },
                { "Rill.Mesh.BrickCounts", 4 * (2 * 2224 + 1) },
                { "Rill.Mesh.CountsBefore", 4 * (2 * 2224 + 1) },
                { "Rill.Mesh.Vertices", 28 * 16096 },
                { "Rill.Mesh.Indices", 24 * 16096 },
                { "Rill.Mesh.Arguments", 124 },
                { "Rill.Mesh.Counters", 36 },
                { "Rill.PrefixSum.TileSums", 4 * (7 + 4) },
            }));
        }

        // The field's texture grows by whole layers of 1,024 bricks, not between these two.
        [Test]
        public void A_mesh_takes_111_6_bytes_more_for_each_particle_beside_its_field()
            => Assert.That(BytesFor(30000, Medium).Values.Sum() - BytesFor(20000, Medium).Values.Sum(), Is.EqualTo(1116000));

        [Test]
        public void Ellipsoids_take_64_bytes_more_for_each_particle()
            => Assert.That(BytesFor(30000, 0f).Values.Sum() - BytesFor(20000, 0f).Values.Sum(), Is.EqualTo(640000));

        [Test]
        public void What_the_mesh_has_worked_in_is_given_back_with_it()
        {
            using (TestFluid fluid = Still(20000))
            {
                Record(fluid, Medium);
                Assert.That(Bytes(fluid)["Rill.Surface.Workspace"], Is.EqualTo(512 * 2224));
                Record(fluid, 0f);
                Assert.That(Bytes(fluid)["Rill.Surface.Workspace"], Is.EqualTo(16 * 20000));
            }
        }

        static Dictionary<string, long> BytesFor(int capacity, float cell)
        {
            using (TestFluid fluid = Still(capacity))
            {
                Record(fluid, cell);
                return Bytes(fluid);
            }
        }

        static Dictionary<string, long> Bytes(TestFluid fluid)
            => fluid.Solver.Describe(fluid.Input, 0).Where(stage => stage.Name == "Surface mesh" || stage.Name == "Surface particles")
                .SelectMany(stage => stage.Buffers).GroupBy(buffer => buffer.name)
                .ToDictionary(buffers => buffers.Key, buffers => buffers.Sum(buffer => buffer.bytes));

        static TestFluid Still(int capacity)
            => new TestFluid(new float3(64f * Spacing), Spacing, capacity).Add(new[] { new float3(32f * Spacing) }).Step();

        static void Record(TestFluid fluid, float cell)
        {
            fluid.Solver.MeshCell = cell;
            GpuTest.Run(cmd => fluid.Solver.RecordSurface(cmd, fluid.Input));
        }
    }
}
