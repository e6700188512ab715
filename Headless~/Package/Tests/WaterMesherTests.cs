using System;
using System.Collections.Generic;
using System.Linq;
using Host.Reference;
using NUnit.Framework;
using Unity.Mathematics;

namespace Host.Tests
{
    /// <summary>The mesh that the reference draws is closed, keeps the water's volume, and lies where the water is. Lengths in d.</summary>
    public class WaterMesherTests
    {
        static readonly double3 box = 30.0;

        [Test]
        public void A_ball_of_particles_is_a_ball_of_their_volume()
        {
            double3 center = 15.0;
            double3[] ball = Lattice(p => math.length(p - center) < 7.0, 0.1);
            var mesh = new WaterMesher(ball, new double3[0], box, 0.15);
            double radius = Math.Pow(ball.Length * 0.75 / Math.PI, 1.0 / 3.0), error = 0.0;
            foreach (double3 vertex in mesh.Vertices)
                error += Math.Pow(math.length(vertex - center) - radius, 2.0);
            error = Math.Sqrt(error / mesh.Vertices.Count);
            double turned = Math.Sqrt(Normals(mesh).Select(n => Math.Pow(Angle(n.Normal, n.At - center), 2.0)).Average());
            TestContext.Out.WriteLine($"volume {mesh.Volume() / ball.Length:0.000}, off by {error:0.000} d rms, normals {turned:0.0} degrees rms");
            Assert.That(mesh.OpenEdges(), Is.Zero);
            Assert.That(mesh.Volume() / ball.Length, Is.EqualTo(1.0).Within(0.05));
            Assert.That(error, Is.LessThan(0.18), "cut from a lattice, as steps");
            Assert.That(turned, Is.LessThan(11.0));
        }

        [Test]
        public void A_pool_fills_the_box_to_its_level_and_reaches_behind_the_walls()
        {
            double3[] pool = Lattice(p => p.y < 8.0, 0.1, new double3(16, 8, 12));
            var mesh = new WaterMesher(pool, new double3[0], new double3(16, 20, 12), 0.15);
            double3 low = mesh.Vertices.Aggregate(math.min), high = mesh.Vertices.Aggregate(math.max);
            double[] level = mesh.Vertices.Where(v => v.y > 4.0 && v.x > 0.0 && v.x < 16.0 && v.z > 0.0 && v.z < 12.0).Select(v => v.y).ToArray();
            double rms = Math.Sqrt(level.Average(y => (y - level.Average()) * (y - level.Average())));
            TestContext.Out.WriteLine($"level {level.Average():0.000}, rms {rms:0.000}");
            Assert.That(mesh.OpenEdges(), Is.Zero);
            Assert.That((low.x, low.y, low.z, high.x, high.z), Is.EqualTo((-0.15, -0.15, -0.15, 16.15, 12.15)));
            Assert.That(level.Average(), Is.EqualTo(8.0).Within(0.08));
            Assert.That(rms, Is.LessThan(0.04));
        }

        // Threads of one particle, sheets of one, two and three, drops.
        [TestCase(20, 1, 1, 0.3)]
        [TestCase(18, 1, 18, 0.05)]
        [TestCase(18, 2, 18, 0.05)]
        [TestCase(18, 3, 18, 0.05)]
        [TestCase(2, 2, 2, 0.15)]
        [TestCase(3, 3, 3, 0.1)]
        public void Thin_water_keeps_its_volume(int x, int y, int z, double within)
        {
            double3[] particles = Lattice(p => true, 0.05, new double3(x, y, z)).Select(p => p + 5.0).ToArray();
            var mesh = new WaterMesher(particles, new double3[0], box, 0.15);
            TestContext.Out.WriteLine($"volume {mesh.Volume() / particles.Length:0.000}");
            Assert.That(mesh.OpenEdges(), Is.Zero);
            Assert.That(mesh.Volume() / particles.Length, Is.EqualTo(1.0).Within(within));
        }

        [Test]
        public void Any_particles_at_all_make_a_closed_mesh()
        {
            var random = new System.Random(1);
            double3[] particles = Enumerable.Range(0, 4000)
                .Select(_ => box * new double3(random.NextDouble(), random.NextDouble(), random.NextDouble())).ToArray();
            var mesh = new WaterMesher(particles, new double3[0], box, 0.15);
            Assert.That(mesh.Quads.Count, Is.GreaterThan(10000));
            Assert.That(mesh.OpenEdges(), Is.Zero);
            mesh.Quads.RemoveAt(mesh.Quads.Count / 2);
            Assert.That(mesh.OpenEdges(), Is.EqualTo(4), "it can tell");
        }

        [Test]
        public void Nothing_is_made_of_no_particles()
            => Assert.That(new WaterMesher(new double3[0], new double3[0], box, 0.15).Quads, Is.Empty);

        static double3[] Lattice(Func<double3, bool> inside, double noise, double3? of = null)
        {
            double3 size = of ?? box;
            var random = new System.Random(3);
            var found = new List<double3>();
            for (int i = 0; i < (int)size.x * (int)size.y * (int)size.z; i++)
            {
                var at = new double3(i % (int)size.x, i / (int)size.x % (int)size.y, i / ((int)size.x * (int)size.y)) + 0.5;
                if (inside(at))
                    found.Add(at + noise * (2.0 * new double3(random.NextDouble(), random.NextDouble(), random.NextDouble()) - 1.0));
            }
            return found.ToArray();
        }

        // Normals of the vertices, by the quads around.
        static IEnumerable<(double3 At, double3 Normal)> Normals(WaterMesher mesh)
        {
            var sums = new double3[mesh.Vertices.Count];
            foreach (int4 quad in mesh.Quads)
            {
                double3 normal = math.cross(mesh.Vertices[quad.z] - mesh.Vertices[quad.x], mesh.Vertices[quad.w] - mesh.Vertices[quad.y]);
                for (int i = 0; i < 4; i++)
                    sums[quad[i]] += normal;
            }
            return sums.Select((sum, i) => (mesh.Vertices[i], sum));
        }

        static double Angle(double3 a, double3 b)
            => Math.Acos(math.clamp(math.dot(math.normalize(a), math.normalize(b)), -1.0, 1.0)) * 180.0 / Math.PI;
    }
}
