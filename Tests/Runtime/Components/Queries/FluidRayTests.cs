using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>Hits of rays and balls on the water: against geometry, against the particles, and when they do not.</summary>
    public class FluidRayTests
    {
        const float Spacing = QueryScene.Spacing;

        // A box that is moved and turned about gravity: the water stands in it as before.
        [Test]
        public void Rays_and_balls_hit_a_pool_where_geometry_says_at_steep_and_at_grazing_angles()
        {
            using (var scene = new SourceScene(new Vector3(1f, 0.8f, 1f), Spacing, 8000).Fill(0.4f))
            using (var batch = new FluidQueryBatch(scene.Fluid, 0, 64))
            {
                scene.Fluid.Inertial = false;
                scene.Fluid.transform.SetPositionAndRotation(new Vector3(30f, 2f, -7f), Quaternion.Euler(0f, 40f, 0f));
                scene.Run(60);
                // Under a flat surface the center of mass lies at half of its height.
                float level = 2f - 0.4f + 2f * scene.Read().positions.Average(p => p.y) * Spacing;
                var rays = new List<FluidRay>();
                foreach (float degrees in new[] { 0f, 30f, 60f, 75f, 84f })     // from the vertical
                    foreach (float radius in new[] { 0f, 0.04f, 0.1f, 0.22f })
                        foreach (float x in new[] { -0.12f, 0.1f })
                        {
                            Vector3 direction = scene.Fluid.transform.rotation * Quaternion.Euler(0f, 25f, -degrees) * Vector3.down;
                            Vector3 target = scene.Fluid.transform.TransformPoint(new Vector3(x, level - 2f, 0.05f));
                            float back = Mathf.Min(0.3f / Mathf.Cos(degrees * Mathf.Deg2Rad), 0.35f);
                            Vector3 touch = target + radius * Vector3.up;       // of a ball's center when it touches
                            rays.Add(FluidRay.Sphere(touch - back * direction, radius, 3f * direction, 2f));
                        }
                batch.SetRays(rays);
                scene.Step();
                batch.Flush();
                double worstDistance = 0.0, worstHeight = 0.0, worstAngle = 0.0, worstBall = 0.0;
                for (int i = 0; i < rays.Count; i++)
                {
                    Assert.That(batch.TryGetHit(i, out FluidRayHit found), $"ray {i}");
                    Vector3 direction = rays[i].direction.normalized;
                    double cos = -direction.y;
                    double expected = (rays[i].origin.y - level - rays[i].radius) / cos;
                    TestContext.Out.WriteLine($"{Mathf.Acos((float)cos) * Mathf.Rad2Deg:0} degrees, radius {rays[i].radius / Spacing:0.0} d: " +
                        $"hit {found.hit}, distance off by {(found.distance - expected) / Spacing:0.000} d, height by " +
                        $"{(found.point.y - level) / Spacing:0.000} d, normal by {Vector3.Angle(found.normal, Vector3.up):0.00} degrees");
                    Assert.That(found.hit && !found.startsInWater, $"ray {i}");
                    double touchError = Math.Abs(found.distance - expected) * cos / Spacing;       // in height
                    worstDistance = Math.Max(worstDistance, touchError);
                    if (rays[i].radius > 0f)
                        worstBall = Math.Max(worstBall,
                            Math.Abs(Vector3.Distance(found.point, rays[i].origin + found.distance * direction) / rays[i].radius - 1.0));
                    else
                        Assert.That(found.point, Is.EqualTo(rays[i].origin + found.distance * direction).Using(Near(1e-3f)));
                    worstHeight = Math.Max(worstHeight, Math.Abs(found.point.y - level) / Spacing);
                    worstAngle = Math.Max(worstAngle, Vector3.Angle(found.normal, Vector3.up));
                }
                TestContext.Out.WriteLine($"distance within {worstDistance:0.000} d of height, point within {worstHeight:0.000} d, " +
                    $"normal within {worstAngle:0.00} degrees");
                Assert.That(worstDistance, Is.LessThan(0.25));
                Assert.That(worstHeight, Is.LessThan(0.5));
                Assert.That(worstAngle, Is.LessThan(2.0));
                Assert.That(worstBall, Is.LessThan(1e-3), "the point is on the ball");
            }
        }

        static Comparison<Vector3> Near(float within) => (a, b) => Vector3.Distance(a, b) <= within ? 0 : 1;

        // Two blocks with a gap of four spacings between them.
        [Test]
        public void A_ray_across_a_gap_leaves_one_water_and_enters_the_next_and_says_where_it_starts()
        {
            using (var scene = new SourceScene(new Vector3(1.2f, 0.6f, 0.6f), Spacing, 4000))
            using (var batch = new FluidQueryBatch(scene.Fluid, 0, 16))
            {
                scene.Fluid.Gravity = 1e-3f * Vector3.down;
                scene.AddWhere(p => p.x < -0.1f && p.y < 0.1f, 0.2f * Vector3.right);
                scene.AddWhere(p => p.x > 0.1f && p.y < 0.1f, 0.4f * Vector3.right);
                Vector3 inside = new Vector3(-0.35f, -0.1f, 0.02f), between = new Vector3(0f, -0.1f, 0.02f);
                const FluidCrossing Enter = FluidCrossing.Enter, Leave = FluidCrossing.Leave, Any = FluidCrossing.Any;
                var casts = new List<FluidRay>
                {
                    new FluidRay(inside, Vector3.right),                        // 0: to the other block
                    new FluidRay(inside, Vector3.right, 10f, Leave),            // 1: out of its own
                    new FluidRay(inside, Vector3.right, 10f, Any),              // 2: the same
                    new FluidRay(between, Vector3.right, 10f, Any),             // 3: into the other
                    new FluidRay(between, Vector3.right, 10f, Leave),           // 4: through it to the wall
                    new FluidRay(between, Vector3.left),                        // 5
                    new FluidRay(between, Vector3.up),                          // 6: misses
                    new FluidRay(between, Vector3.right, 0.05f),                // 7: too short
                    new FluidRay(new Vector3(-2f, -0.1f, 0f), Vector3.right),   // 8: from outside through the wall
                    new FluidRay(new Vector3(-2f, 2f, 0f), Vector3.right),      // 9: beside the box
                    new FluidRay(new Vector3(-2f, -0.1f, 0f), Vector3.left),    // 10: away from it
                    new FluidRay(inside, Vector3.down, 10f, Enter),             // 11: nothing below it to enter
                    FluidRay.Sphere(inside, 0.05f, Vector3.right),              // 12: starts in water
                    FluidRay.Sphere(new Vector3(-0.08f, -0.1f, 0f), 0.08f, Vector3.right),     // 13: touches water behind it
                    FluidRay.Sphere(between, 0.03f, Vector3.right),             // 14
                };
                batch.SetRays(casts);
                scene.Step();
                batch.Flush();
                FluidRayHit[] found = casts.Select((_, i) => { Assert.That(batch.TryGetHit(i, out FluidRayHit hit)); return hit; }).ToArray();
                for (int i = 0; i < found.Length; i++)
                    TestContext.Out.WriteLine($"{i}: hit {found[i].hit} at {found[i].distance:0.000} m, normal {found[i].normal}, velocity " +
                        $"{found[i].velocity}, starts in water {found[i].startsInWater}");
                void AssertHit(int ray, float x, Vector3 normal, float speed)
                {
                    Assert.That(found[ray].hit, $"ray {ray}");
                    Assert.That(found[ray].point.x, Is.EqualTo(x).Within(0.5f * Spacing), $"ray {ray}");
                    Assert.That(Vector3.Angle(found[ray].normal, normal), Is.LessThan(6f), $"ray {ray}");
                    Assert.That(found[ray].velocity.x, Is.EqualTo(speed).Within(0.05f), $"ray {ray}");
                }
                AssertHit(0, 0.1f, Vector3.left, 0.4f);
                AssertHit(1, -0.1f, Vector3.right, 0.2f);
                Assert.That(found[2].distance, Is.EqualTo(found[1].distance).Within(1e-5f));
                AssertHit(3, 0.1f, Vector3.left, 0.4f);
                Assert.That(found[4].hit && Mathf.Abs(found[4].point.x - 0.6f) < 1e-3f);
                Assert.That(Vector3.Angle(found[4].normal, Vector3.right), Is.LessThan(0.1f));
                AssertHit(5, -0.1f, Vector3.right, 0.2f);
                Assert.That(found[8].hit && Mathf.Abs(found[8].distance - 1.4f) < 1e-3f);
                Assert.That(Vector3.Angle(found[8].normal, Vector3.left), Is.LessThan(0.1f));
                AssertHit(14, 0.1f, Vector3.left, 0.4f);
                Assert.That(found[14].distance, Is.EqualTo(found[3].distance - 0.03f).Within(0.15f * Spacing));
                foreach (int miss in new[] { 6, 7, 9, 10, 11, 12, 13 })
                    Assert.That(found[miss].hit, Is.False, $"ray {miss}");
                int[] wet = { 0, 1, 2, 11, 12, 13 };
                for (int i = 0; i < found.Length; i++)
                    Assert.That(found[i].startsInWater, Is.EqualTo(wet.Contains(i)), $"ray {i}");
            }
        }

        // Water in motion, with what a source has just let in.
        [Test]
        public void Hits_in_a_breaking_dam_are_those_of_all_its_particles([Values(5, 30)] int steps)
        {
            using (var scene = new SourceScene(new Vector3(1.2f, 0.8f, 0.4f), Spacing, 4000))
            using (var batch = new FluidQueryBatch(scene.Fluid, 0, 40))
            {
                scene.AddWhere(p => p.x < -0.2f && p.y < 0.2f, new Vector3(2f, 0f, 0f));
                scene.Add<FluidEmitter>(new Vector3(0.3f, 0.2f, 0f), Vector3.left, e => { e.Rate = 0.01f; e.Phase = 5; });
                var random = new Unity.Mathematics.Random(11u);
                float3 half = (float3)scene.Fluid.DomainSize * 0.499f;
                var rays = new FluidRay[40];
                for (int i = 0; i < rays.Length; i++)
                    rays[i] = new FluidRay(random.NextFloat3(-half, half), random.NextFloat3Direction(), 0.9f,
                        (FluidCrossing)(1 + i % 3));
                batch.SetRays(rays, 0, 40);
                scene.Run(steps);
                ParticleState state = scene.Read();
                int hits = 0, dry = 0, phases = 0;
                double worst = 0.0, slowest = 0.0;
                for (int i = 0; i < rays.Length; i++)
                {
                    Assert.That(batch.TryGetHit(i, out FluidRayHit found));
                    Assert.That(found.step, Is.EqualTo(steps));
                    double3 origin = (double3)((float3)rays[i].origin + (float3)scene.Fluid.DomainSize * 0.5f) / Spacing;
                    Assert.That(found.startsInWater, Is.EqualTo(QueryScene.Density(state, origin) >= 0.5), $"ray {i}");
                    double expected = FirstCrossing(state, origin, math.normalize((double3)(float3)rays[i].direction), rays[i].maxDistance / Spacing,
                        rays[i].crossing);
                    Assert.That(found.hit, Is.EqualTo(!double.IsNaN(expected)), $"ray {i} of {rays[i].crossing}: {expected}");
                    dry += found.hit ? 0 : 1;
                    if (!found.hit)
                        continue;
                    hits++;
                    phases += found.phase == 5 ? 1 : 0;
                    worst = Math.Max(worst, Math.Abs(found.distance / Spacing - expected));
                    double3 at = (double3)((float3)found.point + (float3)scene.Fluid.DomainSize * 0.5f) / Spacing;
                    slowest = Math.Max(slowest, math.distance(QueryScene.Velocity(state, at) * Spacing, (double3)(float3)found.velocity));
                }
                TestContext.Out.WriteLine($"{hits} hits, {phases} of the source, {dry} misses: distance within {worst:0.0000} d, velocity within " +
                    $"{slowest:0.0000} m/s");
                Assert.That(hits, Is.GreaterThan(8));
                Assert.That(dry, Is.GreaterThan(5));
                Assert.That(worst, Is.LessThan(0.01));
                Assert.That(slowest, Is.LessThan(5e-3));
            }
        }

        // In steps of half a spacing, and between two on a line. The water ends at the walls.
        static double FirstCrossing(ParticleState state, double3 origin, double3 direction, double maxDistance, FluidCrossing wanted)
        {
            double3 ends = (math.select((double3)0.0, (double3)state.box, direction > 0.0) - origin) / direction;
            double end = math.cmin(ends), before = QueryScene.Density(state, origin);
            for (double along = 0.5; along < Math.Min(end, maxDistance) + 0.5; along += 0.5)
            {
                bool isBeyond = along > end, wasWet = before >= 0.5;
                double density = isBeyond ? 0.0 : QueryScene.Density(state, origin + along * direction);
                double at = isBeyond ? end : along - 0.5 * (density - 0.5) / (density - before);
                bool isWanted = (wanted & (wasWet ? FluidCrossing.Leave : FluidCrossing.Enter)) != 0;
                if (density >= 0.5 != wasWet && isWanted && at <= maxDistance)
                    return at;
                before = density;
            }
            return double.NaN;
        }

        // Longer than a chunk of samples, which a group searches: what is found is the nearest, whichever group finds it first.
        [Test]
        public void A_long_ray_hits_the_nearest_of_many_waters()
        {
            using (var scene = new SourceScene(new Vector3(6f, 0.4f, 0.4f), Spacing, 6000))
            using (var batch = new FluidQueryBatch(scene.Fluid, 0, 64))
            {
                scene.Fluid.Gravity = Vector3.zero;
                scene.AddWhere(p => p.x > -2f && Mathf.Repeat(p.x, 1f) < 0.5f);
                for (int i = 0; i < 64; i++)
                {
                    batch.RayCount = i + 1;
                    batch.SetRay(i, new FluidRay(new Vector3(-2.95f + 0.09f * i, 0f, 0f), Vector3.right));
                }
                scene.Step();
                batch.Flush();
                for (int i = 0; i < 64; i++)
                {
                    float from = -2.95f + 0.09f * i, expected = Mathf.Max(Mathf.Ceil(from), -2f);
                    if (Mathf.Abs(from - Mathf.Round(from)) < Spacing)
                        continue;       // on a surface
                    Assert.That(batch.TryGetHit(i, out FluidRayHit found));
                    Assert.That(found.hit, Is.EqualTo(expected < 2.9f), $"ray {i} from {from}");
                    if (found.hit)
                        Assert.That(found.point.x, Is.EqualTo(expected).Within(0.5f * Spacing), $"ray {i} from {from}");
                }
            }
        }

        [Test]
        public void A_ray_has_no_result_before_the_first_after_a_restart_while_off_and_until_it_is_set()
        {
            using (var scene = new SourceScene(new Vector3(0.6f, 0.6f, 0.6f), Spacing, 1000).Fill(0.3f))
            using (var batch = new FluidQueryBatch(scene.Fluid, 2, 2))
            {
                void AssertNone(int ray)
                {
                    Assert.That(batch.TryGetHit(ray, out FluidRayHit none), Is.False);
                    Assert.That(none.valid || none.hit, Is.False);
                }
                batch.SetPoints(new List<Vector3> { new Vector3(0f, -0.1f, 0f) });
                batch.RayCount = 2;
                batch.SetRay(0, new FluidRay(0.2f * Vector3.up, Vector3.down));
                AssertNone(0);
                scene.Step();
                batch.Flush();
                AssertNone(1);
                Assert.That(batch.TryGetHit(0, out FluidRayHit first) && first.hit);
                Assert.That(batch.TryGetSample(0, out FluidProbeSample point));
                Assert.That(first.point.y, Is.EqualTo(point.height).Within(0.02f * Spacing), "points and rays of a batch are of one state");
                Assert.That(first.time, Is.EqualTo(point.time));
                Assert.That(first.ray.origin, Is.EqualTo(0.2f * Vector3.up));
                scene.Step();
                scene.Fluid.Restart();
                batch.Flush();
                AssertNone(0);
                scene.Run(1);
                Assert.That(batch.TryGetHit(0, out _));
                scene.Fluid.enabled = false;
                AssertNone(0);
            }
        }

        [Test]
        public void What_a_ray_cannot_be_is_said_with_its_number_and_what_to_do()
        {
            using (var scene = new SourceScene(new Vector3(0.6f, 0.6f, 0.6f), Spacing, 1000))
            using (var batch = new FluidQueryBatch(scene.Fluid, 0, 2))
            {
                void AssertRefused(FluidRay ray, string text)
                    => AssertThrows<ArgumentException>(() => batch.SetRays(new[] { new FluidRay(Vector3.zero, Vector3.up), ray }, 0, 2), text);
                AssertRefused(new FluidRay(new Vector3(0f, float.NaN, 0f), Vector3.up), "Ray 1 starts at");
                AssertRefused(new FluidRay(Vector3.zero, Vector3.zero), "points nowhere: give a finite one that is not 0");
                AssertRefused(new FluidRay(Vector3.zero, Vector3.up, 0f), "goes 0 m far: give a distance above 0");
                AssertRefused(FluidRay.Sphere(Vector3.zero, 1.01f, Vector3.up),
                    "has a radius of 1.01 m: give 0 to 1 m, which is 20 particle spacings");
                AssertRefused(FluidRay.Sphere(Vector3.zero, -0.1f, Vector3.up), "has a radius of -0.1 m");
                AssertRefused(new FluidRay(Vector3.zero, Vector3.up, 1f, 0), "hits nothing: give Enter, Leave or Any");
                AssertRefused(new FluidRay(Vector3.zero, Vector3.up, 1f, FluidCrossing.Leave) { radius = 0.1f }, "a ball only enters");
                Assert.That(batch.RayCount, Is.Zero);
                AssertThrows<ArgumentOutOfRangeException>(() => batch.SetRays(new FluidRay[3], 0, 3),
                    "3 rays are more than this batch was made for, 2");
                AssertThrows<ArgumentOutOfRangeException>(() => batch.SetRay(0, new FluidRay(Vector3.zero, Vector3.up)),
                    "Index 0 is not one of 0 rays");
                AssertThrows<ArgumentOutOfRangeException>(() => batch.TryGetHit(2, out _), "Index 2 is not one of 2 rays");
                AssertThrows<ArgumentOutOfRangeException>(() => new FluidQueryBatch(scene.Fluid, 0, 16385), "0 to 16,384 rays");
            }
        }

        static void AssertThrows<T>(TestDelegate call, string text) where T : Exception
            => Assert.That(Assert.Throws(Is.InstanceOf<T>(), call).Message, Does.Match(Regex.Escape(text)));
    }
}
