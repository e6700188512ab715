using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Rill.Tests.Reference;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>The surface of breaking water against the isosurface of its raw particles.</summary>
    public class DamSurfaceTests
    {
        const double SprayRadius = 1.0;     // d: how far from a particle of the spray it may be drawn

        [Test]
        public void The_isosurface_of_a_lattice_is_its_boundary_at_the_walls_too()
        {
            var block = new Isosurface(Compare.Points(ParticleState.Lattice(20f, 0.5f, new int3(20, 8, 20)).positions), 20.0);
            double3[] ball = Compare.Points(ParticleState.Lattice(30f, 0.5f, 30).positions).Where(p => math.distance(p, 15.0) < 10.0).ToArray();
            double radius = Math.Pow(0.75 / Math.PI * ball.Length, 1.0 / 3.0);
            var round = new Isosurface(ball, 30.0);
            var sheet = new Isosurface(Compare.Points(ParticleState.Lattice(20f, new float3(0.5f, 10f, 0.5f), new int3(20, 1, 20)).positions), 20.0);
            double squares = 0.0;
            var random = new Unity.Mathematics.Random(3u);
            const int rays = 300;
            for (int i = 0; i < rays; i++)
            {
                var above = new double3(random.NextDouble(0.01, 19.99), 25.0, random.NextDouble(0.01, 19.99));
                Assert.That(block.Hit(above, new double3(0.0, -2.0, 0.0), out double distance, out bool isOnWall) && !isOnWall);
                Assert.That(25.0 - 2.0 * distance, Is.EqualTo(8.0).Within(0.03), "the top of the block, in lengths of the direction");
                Assert.That(block.Hit(new double3(above.x, 0.39 * above.z, -5.0), new double3(0.0, 0.0, 1.0), out distance, out isOnWall)
                    && isOnWall);
                Assert.That(sheet.Hit(above, new double3(0.0, -1.0, 0.0), out distance, out _));
                Assert.That(15.0 - distance, Is.InRange(0.0, 0.5));
                double3 outwards = random.NextFloat3Direction();
                Assert.That(round.Hit(15.0 + 30.0 * outwards, -outwards, out distance, out _));
                squares += (30.0 - distance - radius) * (30.0 - distance - radius);
            }
            TestContext.Out.WriteLine($"ball from a lattice: {Math.Sqrt(squares / rays):0.000} d rms from the radius of its volume");
            Assert.That(Math.Sqrt(squares / rays), Is.LessThan(0.2), "steps of the lattice");
            Assert.That(new Isosurface(new[] { new double3(5.0) }, 10.0).Hit(new double3(5.0, 5.0, -1.0), new double3(0.0, 0.0, 1.0), out _,
                out _), Is.False, "a drop alone is spray");
        }

        [Test, Category("LongRun")]
        public void A_breaking_dam_is_drawn_where_its_particles_are() => Assert.That(Error(1, 192, 108), Is.LessThanOrEqualTo(0.45));

        [Test, Explicit("100,000 particles: a minute on a CPU")]
        public void A_breaking_dam_of_a_hundred_thousand_is_drawn_where_its_particles_are()
            => Assert.That(Error(2, 384, 216), Is.LessThanOrEqualTo(0.46));

        // Rms, d. The same 1.5 m of dam, of 12,480 particles and of 99,840.
        static double Error(int scale, int width, int height)
        {
            float spacing = 0.025f / scale;
            float3 box = new float3(60f, 36f, 24f) * scale;
            var picture = new SurfacePicture();
            using (var fluid = new TestFluid(box * spacing, spacing, 12480 * scale * scale * scale))
            {
                fluid.AddBlock(0f, new float3(20f, 26f, 24f) * scale * spacing);
                Vector3 center = new float3(0.5f, 0.25f, 0.5f) * box * spacing;
                picture.Look(center + new Vector3(0.5f, 1.2f, -1.6f), center, 35f, width, height);
                double squares = 0.0;
                long compared = 0;
                int done = 0;
                foreach (int steps in new[] { 12, 24, 40, 70 })
                {
                    fluid.Step(steps - done);
                    done = steps;
                    double[] errors = Errors(picture.Draw(fluid), Compare.Points(fluid.Read().positions), box, spacing, out string told);
                    TestContext.Out.WriteLine($"{fluid.Added:N0} particles, step {steps}: {told}");
                    squares += errors.Sum(e => e * e);
                    compared += errors.Length;
                }
                double rms = Math.Sqrt(squares / compared);
                TestContext.Out.WriteLine($"all: depth RMSE {rms:0.000} d over {compared:N0} pixels");
                return rms;
            }
        }

        // Errors of the free surface: pixels that show water in a wall of the box are right by construction.
        static double[] Errors(SurfacePicture picture, double3[] particles, double3 box, double spacing, out string told)
        {
            var water = new Isosurface(particles, box);
            double3[] spray = particles.Where(p => water.Color(p) < Isosurface.Level).ToArray();
            var errors = new List<double>();
            double all = 0.0;
            int both = 0, either = 0, left = 0, allBoth = 0;
            for (int y = 0; y < picture.Height; y++)
                for (int x = 0; x < picture.Width; x++)
                {
                    picture.Ray(x, y, out float3 origin, out float3 direction);
                    double drawn = picture.Depth[y * picture.Width + x] / spacing;
                    bool isHit = water.Hit((double3)origin / spacing, direction, out double depth, out bool isOnWall);
                    if (isHit && isOnWall || !isHit && drawn == 0.0)
                        continue;
                    if (isHit && drawn > 0.0)
                    {
                        all += (drawn - depth) * (drawn - depth);
                        allBoth++;
                    }
                    if (Array.Exists(spray, p => IsInFront(p, (double3)origin / spacing, direction, isHit ? depth : double.MaxValue)))
                    {
                        left++;
                        continue;
                    }
                    either++;
                    if (!isHit || drawn == 0.0)
                        continue;
                    both++;
                    errors.Add(drawn - depth);
                }
            double[] sizes = errors.Select(e => Math.Abs(e)).OrderBy(e => e).ToArray();
            told = $"depth RMSE {Math.Sqrt(sizes.Average(e => e * e)):0.000} d, mean {errors.Average():+0.000;-0.000} d, median " +
                $"{sizes[sizes.Length / 2]:0.000} d, 90 % {sizes[sizes.Length * 9 / 10]:0.000} d, 99 % " +
                $"{sizes[sizes.Length * 99 / 100]:0.000} d; silhouette IoU {both / (double)either:0.0000}; {either:N0} pixels, " +
                $"{left:N0} more with spray, of {spray.Length} particles, {Math.Sqrt(all / allBoth):0.000} d with them";
            return errors.ToArray();
        }

        static bool IsInFront(double3 particle, double3 origin, double3 direction, double depth)
        {
            double along = math.dot(particle - origin, direction) / math.lengthsq(direction);
            return along < depth && math.lengthsq(origin + along * direction - particle) < SprayRadius * SprayRadius;
        }
    }
}
