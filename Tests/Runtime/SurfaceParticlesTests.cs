using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>What is found to be drawn of the water.</summary>
    public class SurfaceParticlesTests
    {
        [Test]
        public void A_block_of_water_is_drawn_by_its_surface_alone()
        {
            using (var fluid = new TestFluid(new float3(40f) * 0.0625f, 0.0625f, 9000))
            {
                fluid.Input.gravity = 0f;
                fluid.AddBlock(10f * 0.0625f, 20f * 0.0625f).Step();
                GpuTest.Run(cmd => fluid.Solver.RecordSurface(cmd, fluid.Input));
                SurfaceShape[] shapes = SurfaceShape.Read(fluid.Solver);
                TestContext.Out.WriteLine($"{shapes.Length:N0} of {fluid.Added:N0} particles are drawn");
                Assert.That(shapes.Length, Is.GreaterThanOrEqualTo(8000 - 18 * 18 * 18).And.LessThan(8000 - 15 * 15 * 15));
                Assert.That(shapes.Select(shape => shape.particle), Is.Unique);
                foreach (SurfaceShape shape in shapes)
                    Assert.That(math.all(shape.center > 9f) && math.all(shape.center < 31f) && math.all(shape.semiAxes > 0.09) && math.all(shape.semiAxes < 1.41), $"particle {shape.particle} at {shape.center}, {shape.semiAxes}");
            }
        }
    }
}
