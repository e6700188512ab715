using System;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>How far the surface lies from the water's, whose shape is known: ellipsoids alone, before any filter on the screen.</summary>
    public class SurfaceQualityTests
    {
        const float Spacing = 0.05f;

        [Test, Category("LongRun")]
        public void A_still_pool_is_flat_and_as_high_as_its_volume()
        {
            const float side = 36f, depth = 10f, margin = 4f;
            using (var fluid = new TestFluid(new float3(side, 30f, side) * Spacing, Spacing, 13000))
            {
                fluid.Input.material.velocitySmoothing = 0.5f;
                fluid.AddBlock(0f, new float3(side, depth, side) * Spacing, jitter: 0.3f).Step(200);
                SurfaceShape[] shapes = Shapes(fluid);
                double height = fluid.Alive / (side * side);
                var rays = new SurfaceRays(shapes, 1, -1, margin, side - margin);
                Assert.That(rays.Hits, Has.None.NaN, "rays that meet no water");
                double mean = rays.Hits.Average(hit => hit - height), absolute = rays.Hits.Average(hit => Math.Abs(hit - height));
                double tilt = Degrees(Math.Sqrt(rays.Normals.Average(normal => 1.0 - normal.y * normal.y)));
                double filtered = Degrees(Math.Sqrt(Filtered(rays)));
                double before = rays.Hits.Average();
                fluid.Step();
                var next = new SurfaceRays(Shapes(fluid), 1, -1, margin, side - margin);
                double shimmer = Math.Sqrt(rays.Hits.Zip(next.Hits, (a, b) => (a - b) * (a - b)).Average());
                TestContext.Out.WriteLine($"pool {depth} d deep: height error mean {mean:+0.000;-0.000} d, absolute {absolute:0.000} " +
                    $"d; normal rms {tilt:0.00}°, {filtered:0.00}° after a Gaussian of 0.5 d; a step later {shimmer:0.0000} d rms apart");
                Assert.That(absolute, Is.LessThanOrEqualTo(0.1));
                Assert.That(tilt, Is.LessThanOrEqualTo(3.0), "before the screen's filter");
                Assert.That(filtered, Is.LessThanOrEqualTo(2.0), "as the screen's filter leaves it");
                Assert.That(shimmer, Is.LessThanOrEqualTo(0.005));
            }
        }

        [Test, Category("LongRun")]
        public void Water_is_full_up_to_the_walls_of_its_box()
        {
            using (var fluid = new TestFluid(new float3(20f, 16f, 20f) * Spacing, Spacing, 4000))
            {
                fluid.Input.material.velocitySmoothing = 0.5f;
                fluid.AddBlock(0f, new float3(20f, 8f, 20f) * Spacing, jitter: 0.3f).Step(120);
                SurfaceShape[] shapes = Shapes(fluid);
                // Along x from its low wall, on y and z; along y from the floor, on z and x.
                var side = new SurfaceRays(shapes, 0, 1, new double2(0.5, 0.5), new double2(7.0, 19.5));
                var floor = new SurfaceRays(shapes, 1, 1, 0.5, 19.5);
                TestContext.Out.WriteLine($"from a wall to the water {side.Hits.Average():0.0000} d, from the floor " +
                    $"{floor.Hits.Average():0.0000} d; furthest {side.Hits.Max():0.000} d and {floor.Hits.Max():0.000} d");
                Assert.That(side.Hits, Has.None.NaN);
                Assert.That(floor.Hits, Has.None.NaN);
                Assert.That(side.Hits.Concat(floor.Hits).Max(), Is.LessThan(0.1));
                var top = new SurfaceRays(shapes, 1, -1, 0.3, 19.7);
                double center = top.Hits.Where((_, i) => math.cmax(math.abs(top.At(i) - 10.0)) < 5.0).Average();
                double rim = top.Hits.Where((_, i) => math.cmax(math.abs(top.At(i) - 10.0)) > 9.2).Average();
                TestContext.Out.WriteLine($"the surface within 0.8 d of the walls lies {rim - center:+0.00;-0.00} d above the center");
                Assert.That(rim - center, Is.InRange(-0.7, 0.7), "the water itself lies lower at the walls");
            }
        }

        [Test, Category("LongRun")]
        public void A_ball_has_the_radius_of_its_volume()
        {
            const double radius = 10.0, cell = 0.1;
            using (var fluid = new TestFluid(new float3(30f) * Spacing, Spacing, 5000))
            {
                fluid.Input.gravity = 0f;
                float3[] positions = EvenBall(4189, radius);
                fluid.Add(positions.Select(p => (p + 15f) * Spacing).ToArray());
                for (int step = 0; step < 30; step++)
                {
                    fluid.Step();
                    fluid.Solver.Velocities.SetData(new float4[fluid.Solver.Velocities.count]);
                }
                double3[] points = Compare.Points(fluid.Read().positions);
                double r = Math.Pow(0.75 / Math.PI * points.Length, 1.0 / 3.0), square = 0.0, sum = 0.0, radial = 0.0;
                double3 center = points.Aggregate((a, b) => a + b) / points.Length;
                SurfaceShape[] shapes = Shapes(fluid);
                int both = 0, either = 0;
                for (int axis = 0; axis < 3; axis++)
                    foreach (int direction in new[] { 1, -1 })
                    {
                        var mid = new double2(center[(axis + 1) % 3], center[(axis + 2) % 3]);
                        var rays = new SurfaceRays(shapes, axis, direction, mid - r - 2.0, mid + r + 2.0, cell);
                        for (int i = 0; i < rays.Hits.Length; i++)
                        {
                            double2 off = rays.At(i) - mid;
                            double left = r * r - math.lengthsq(off);
                            bool isHit = !double.IsNaN(rays.Hits[i]);
                            either += left > 0.0 || isHit ? 1 : 0;
                            if (left <= 0.0 || !isHit)
                                continue;
                            both++;
                            double towardsEye = -direction * (rays.Hits[i] - center[axis]), error = towardsEye - Math.Sqrt(left);
                            sum += error;
                            square += error * error;
                            radial += Math.Pow(Math.Sqrt(math.lengthsq(off) + towardsEye * towardsEye) - r, 2.0);
                        }
                    }
                double rms = Math.Sqrt(square / both), overlap = both / (double)either;
                TestContext.Out.WriteLine($"ball of {points.Length:N0} particles, R = {r:0.00} d: depth RMSE {rms:0.000} d, mean " +
                    $"{sum / both:+0.000;-0.000} d, along the normal {Math.Sqrt(radial / both):0.000} d rms; silhouette IoU " +
                    $"{overlap:0.0000}");
                Assert.That(rms, Is.LessThanOrEqualTo(0.1));
                Assert.That(overlap, Is.GreaterThanOrEqualTo(0.98));
            }
        }

        [TestCase(1, 0f)]
        [TestCase(1, 0.15f)]
        [TestCase(2, 0f)]
        [TestCase(2, 0.15f)]
        public void A_sheet_has_no_holes_and_its_own_thickness(int layers, float jitter)
        {
            using (var fluid = new TestFluid(new float3(40f, 20f, 40f) * Spacing, Spacing, 1500))
            {
                fluid.Input.gravity = 0f;
                ParticleState sheet = ParticleState.Lattice(0f, new float3(8f, 10f, 8f), new int3(24, layers, 24), jitter);
                fluid.Add(sheet.positions.Select(p => p.xyz * Spacing).ToArray()).Step();
                SurfaceShape[] shapes = Shapes(fluid);
                var above = new SurfaceRays(shapes, 1, -1, 9.0, 30.0);
                var below = new SurfaceRays(shapes, 1, 1, 9.0, 30.0);
                double coverage = above.Hits.Count(hit => !double.IsNaN(hit)) / (double)above.Hits.Length;
                double[] thickness = above.Hits.Zip(below.Hits, (a, b) => a - b).Where(t => !double.IsNaN(t)).ToArray();
                TestContext.Out.WriteLine(
                    $"sheet of {layers}, jitter {jitter} d: coverage {100.0 * coverage:0.00} %, {thickness.Average():0.000} d thick");
                Assert.That(coverage, Is.GreaterThanOrEqualTo(0.995));
                Assert.That(thickness.Average(), Is.EqualTo(layers).Within(10).Percent);
            }
        }

        [TestCase(1.2f)]
        [TestCase(1.35f)]
        public void A_sheet_that_comes_apart_keeps_its_volume(float stretch)
        {
            using (var fluid = new TestFluid(new float3(40f, 20f, 40f) * Spacing, Spacing, 1500))
            {
                fluid.Input.gravity = 0f;
                ParticleState sheet = ParticleState.Lattice(0f, 0f, new int3(24, 1, 24), 0.1f);
                fluid.Add(sheet.positions.Select(p => (new float3(4f, 10f, 4f) + p.xyz * new float3(stretch, 1f, stretch)) * Spacing)
                    .ToArray()).Step();
                SurfaceShape[] shapes = Shapes(fluid);
                var above = new SurfaceRays(shapes, 1, -1, 7.0, 28.0);
                var below = new SurfaceRays(shapes, 1, 1, 7.0, 28.0);
                double[] thickness = above.Hits.Zip(below.Hits, (a, b) => a - b).Select(t => double.IsNaN(t) ? 0.0 : t).ToArray();
                double coverage = thickness.Count(t => t > 0.0) / (double)thickness.Length, volume = thickness.Average() * stretch * stretch;
                TestContext.Out.WriteLine($"particles {stretch} d apart: coverage {100.0 * coverage:0.00} %, {volume:0.000} d^3 a particle");
                Assert.That(coverage, Is.GreaterThanOrEqualTo(0.995));
                Assert.That(volume, Is.EqualTo(1.0).Within(10).Percent);
            }
        }

        [Test]
        public void Of_a_large_box_of_water_a_quarter_at_most_is_drawn()
        {
            const int side = 36;
            using (var fluid = new TestFluid(new float3(60f) * Spacing, Spacing, side * side * side))
            {
                fluid.Input.gravity = 0f;
                fluid.AddBlock(12f * Spacing, side * Spacing, jitter: 0.1f).Step();
                double drawn = Shapes(fluid).Length, layers = 0.5 * (side - Math.Pow(side * side * side - drawn, 1.0 / 3.0));
                double ofHundred = 1.0 - Math.Pow(1.0 - 2.0 * layers / 100.0, 3.0);
                TestContext.Out.WriteLine($"{drawn:N0} of {fluid.Added:N0} particles are drawn, {layers:0.00} layers: " +
                    $"{100.0 * ofHundred:0.0} % of 100 x 100 x 100");
                Assert.That(ofHundred, Is.LessThanOrEqualTo(0.25));
            }
        }

        [Test]
        public void Between_two_bodies_of_water_three_spacings_apart_nothing_is_drawn()
        {
            using (var fluid = new TestFluid(new float3(40f, 20f, 20f) * Spacing, Spacing, 2000))
            {
                fluid.Input.gravity = 0f;
                fluid.AddBlock(new float3(6f) * Spacing, 8f * Spacing, jitter: 0.1f).AddBlock(new float3(17f, 6f, 6f) * Spacing,
                    8f * Spacing, jitter: 0.1f).Step();
                foreach (SurfaceShape shape in Shapes(fluid))
                {
                    double low = shape.center.x - shape.Reach.x, high = shape.center.x + shape.Reach.x;
                    Assert.That(high < 14.8 || low > 16.2, $"particle {shape.particle} reaches from {low} to {high}");
                }
            }
        }

        static SurfaceShape[] Shapes(TestFluid fluid)
        {
            GpuTest.Run(cmd => fluid.Solver.RecordSurface(cmd, fluid.Input));
            return SurfaceShape.Read(fluid.Solver);
        }

        static double Degrees(double radians) => radians * 180.0 / Math.PI;

        // Mean square of the slope after a Gaussian of standard deviation 0.5 d, about what a filter of radius 1 d leaves.
        static double Filtered(SurfaceRays rays)
        {
            const double deviation = 0.5;
            int reach = (int)Math.Ceiling(2.0 * deviation / rays.Step);
            double[] weights = Enumerable.Range(-reach, 2 * reach + 1)
                .Select(k => Math.Exp(-0.5 * Math.Pow(k * rays.Step / deviation, 2.0))).ToArray();
            double[] smooth = rays.Hits;
            foreach (int stride in new[] { 1, rays.Count.x })
            {
                double[] from = smooth;
                smooth = from.Select((_, i) => (stride == 1 ? IsInside(i % rays.Count.x, rays.Count.x, reach)
                    : IsInside(i / rays.Count.x, rays.Count.y, reach)) ? weights.Select((w, k) => w * from[i + (k - reach) * stride])
                    .Sum() / weights.Sum() : 0.0).ToArray();
            }
            double[] squares = Enumerable.Range(0, smooth.Length).Where(i => IsInside(i % rays.Count.x, rays.Count.x, reach + 1)
                && IsInside(i / rays.Count.x, rays.Count.y, reach + 1))
                .Select(i => Math.Pow((smooth[i + 1] - smooth[i - 1]) / (2.0 * rays.Step), 2.0)
                    + Math.Pow((smooth[i + rays.Count.x] - smooth[i - rays.Count.x]) / (2.0 * rays.Step), 2.0)).ToArray();
            return squares.Average();

            bool IsInside(int k, int count, int rim) => k >= rim && k < count - rim;
        }

        // Points that keep their distance from one another and from their images in a sphere: what the solver then relaxes is not a lattice,
        // which would end in steps.
        static float3[] EvenBall(int count, double radius)
        {
            const double reach = 1.6;
            var random = new Unity.Mathematics.Random(5u);
            var points = new double3[count];
            for (int i = 0; i < count; i++)
                do
                    points[i] = random.NextFloat3((float)-radius, (float)radius);
                while (math.length(points[i]) > radius - 0.3);
            for (int pass = 0; pass < 120; pass++)
            {
                double3[] images = points.Where(p => math.length(p) > radius - 1.2).Select(p => p * (2.0 * radius / math.length(p) - 1.0)).ToArray();
                double3[] all = points.Concat(images).ToArray();
                int[][] neighbors = Reference.Neighbors.ByCells(all, reach);
                double longest = 0.3 * (1.0 - pass / 160.0);
                points = points.Select((p, i) =>
                {
                    double3 push = 0.0;
                    foreach (int j in neighbors[i])
                    {
                        double3 away = p - all[j];
                        double distance = math.length(away);
                        push += away * (Math.Pow(1.0 - distance / reach, 2.0) / Math.Max(distance, 1e-3));
                    }
                    p += push * (longest * Math.Min(1.0, 1.0 / Math.Max(math.length(push), 1e-9)));
                    return math.length(p) > radius - 0.3 ? p * ((radius - 0.3) / math.length(p)) : p;
                }).ToArray();
            }
            return points.Select(p => (float3)p).ToArray();
        }
    }
}
