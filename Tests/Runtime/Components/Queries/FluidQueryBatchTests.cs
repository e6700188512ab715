using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>Samples of a batch at its points, against probes, and when it has none.</summary>
    public class FluidQueryBatchTests
    {
        const float Spacing = QueryScene.Spacing;

        [Test, Category("LongRun")]
        public void A_batch_says_of_each_point_what_a_probe_there_says()
        {
            using (var scene = new SourceScene(new Vector3(1.2f, 0.8f, 0.4f), Spacing, 4000))
            using (var batch = new FluidQueryBatch(scene.Fluid, 300))
            {
                scene.AddWhere(p => p.x < -0.2f && p.y < 0.2f, new Vector3(2f, 0f, 0f));
                scene.Add<FluidEmitter>(new Vector3(0.3f, 0.2f, 0f), Vector3.left, e => { e.Rate = 0.01f; e.Phase = 3; });
                scene.Fluid.transform.SetPositionAndRotation(new Vector3(30f, 2f, -7f), Quaternion.Euler(0f, 40f, 0f));
                scene.Fluid.Inertial = false;
                var random = new Unity.Mathematics.Random(9u);
                float3 half = (float3)scene.Fluid.DomainSize * 0.499f;
                Vector3[] positions = Enumerable.Range(0, 300)
                    .Select(_ => scene.Fluid.transform.TransformPoint(random.NextFloat3(-half, half))).ToArray();
                FluidProbe[] probes = positions.Take(60).Select(scene.Probe).ToArray();
                for (int i = 0; i < probes.Length; i++)
                    positions[i] = probes[i].transform.position;       // as its object's place rounds it
                batch.SetPoints(positions, 0, 300);
                scene.Run(25);
                int wet = 0, surfaces = 0, emitted = 0;
                for (int i = 0; i < probes.Length; i++)
                {
                    FluidProbeSample expected = probes[i].Flushed();
                    Assert.That(batch.TryGetSample(i, out FluidProbeSample found));
                    Assert.That(found, Is.EqualTo(expected), $"point {i}");
                    wet += found.hasVelocity ? 1 : 0;
                    surfaces += found.hasSurface ? 1 : 0;
                    emitted += found.phase == 3 ? 1 : 0;
                }
                Assert.That(wet, Is.GreaterThan(10));
                Assert.That(surfaces, Is.GreaterThan(10));
                Assert.That(emitted, Is.GreaterThan(0));
                using (var samples = new NativeArray<FluidProbeSample>(300, Allocator.Persistent))
                {
                    Assert.That(batch.CopySamples(samples), Is.EqualTo(300));
                    for (int i = 0; i < 300; i++)
                    {
                        Assert.That(batch.TryGetSample(i, out FluidProbeSample one));
                        Assert.That(samples[i], Is.EqualTo(one));
                        Assert.That(one.position, Is.EqualTo(positions[i]));
                    }
                }
            }
        }

        // Each part of few lines has a group of threads of its own; of many lines a group searches part after part, down to what it finds.
        [Test]
        public void Many_points_and_rays_get_the_answers_of_few([Values(300, 1100)] int count)
        {
            const int Few = 24;
            using (var scene = new SourceScene(new Vector3(0.6f, 5f, 0.6f), Spacing, 4000))
            using (var few = new FluidQueryBatch(scene.Fluid, Few, Few))
            using (var many = new FluidQueryBatch(scene.Fluid, count, count))
            {
                scene.AddWhere(p => p.y < -2.3f || p.x < 0f && Math.Abs(p.y) < 0.2f || p.z < 0f && p.y > 1.2f && p.y < 1.5f);
                var random = new Unity.Mathematics.Random(3u);
                float3 half = (float3)scene.Fluid.DomainSize * 0.499f;
                Vector3[] points = Enumerable.Range(0, count).Select(_ => (Vector3)random.NextFloat3(-half, half)).ToArray();
                FluidRay[] rays = Enumerable.Range(0, count).Select(i => new FluidRay(random.NextFloat3(-half, half),
                    random.NextFloat3(-half, half) * new float3(0.2f, 1f, 0.2f), i % 3 == 0 ? 2f : 20f,
                    i % 2 == 0 ? FluidCrossing.Enter : FluidCrossing.Any)).ToArray();
                few.SetPoints(points, 0, Few);
                few.SetRays(rays.Take(Few).ToList());
                many.SetPoints(points, 0, count);
                many.SetRays(rays.ToList());
                scene.Run(2);
                few.Flush();
                many.Flush();
                int hits = 0;
                var heights = new HashSet<int>();
                for (int i = 0; i < Few; i++)
                {
                    Assert.That(few.TryGetSample(i, out FluidProbeSample point));
                    Assert.That(many.TryGetSample(i, out FluidProbeSample samePoint));
                    Assert.That(samePoint, Is.EqualTo(point), $"point {i}");
                    Assert.That(few.TryGetHit(i, out FluidRayHit hit));
                    Assert.That(many.TryGetHit(i, out FluidRayHit sameHit));
                    Assert.That(sameHit, Is.EqualTo(hit), $"ray {i}");
                    heights.Add(Mathf.RoundToInt(point.height));
                    hits += hit.hit ? 1 : 0;
                }
                Assert.That(heights.Count, Is.EqualTo(3), "surfaces in three parts of the lines");
                Assert.That(hits, Is.GreaterThan(Few / 4));
            }
        }

        [Test]
        public void Points_of_an_array_a_part_a_list_and_one_alone_are_those_that_are_asked()
        {
            using (SourceScene scene = Pool())
            using (var batch = new FluidQueryBatch(scene.Fluid, 4))
            {
                Vector3 Point(int i) => new Vector3(0.05f * i - 0.1f, -0.1f, 0f);
                void AssertAsked(params int[] indices)
                {
                    scene.Step();
                    batch.Flush();
                    for (int i = 0; i < 4; i++)
                    {
                        Assert.That(batch.TryGetSample(i, out FluidProbeSample sample), Is.EqualTo(i < indices.Length), $"point {i}");
                        if (i < indices.Length)
                            Assert.That(sample.position, Is.EqualTo(Point(indices[i])));
                    }
                }
                using (var array = new NativeArray<float3>(new float3[] { Point(0), Point(1), Point(2) }, Allocator.Persistent))
                {
                    batch.SetPoints(array);
                    AssertAsked(0, 1, 2);
                    batch.SetPoints(array.GetSubArray(1, 2));
                    AssertAsked(1, 2);
                }
                batch.SetPoints(Enumerable.Range(0, 5).Select(Point).ToArray(), 1, 4);
                AssertAsked(1, 2, 3, 4);
                batch.SetPoints(new List<Vector3> { Point(4) });
                AssertAsked(4);
                batch.SetPoint(0, Point(2));
                AssertAsked(2);
                batch.PointCount = 2;       // the second is not set
                scene.Step();
                batch.Flush();
                Assert.That(batch.TryGetSample(0, out _));
                Assert.That(batch.TryGetSample(1, out _), Is.False);
                batch.SetPoint(1, Point(0));
                AssertAsked(2, 0);
                batch.PointCount = 0;
                Assert.That(batch.TryGetSample(0, out _), "the newest samples stay");
            }
        }

        [Test]
        public void A_sample_is_not_valid_before_the_first_result_outside_not_finite_after_a_restart_or_while_off()
        {
            using (SourceScene scene = Pool())
            using (var batch = new FluidQueryBatch(scene.Fluid, 3))
            {
                batch.SetPoints(new List<Vector3> { Vector3.zero, new Vector3(0f, 0.31f, 0f), new Vector3(float.NaN, 0f, 0f) });
                AssertNone(batch);
                scene.Step();
                batch.Flush();
                Assert.That(batch.TryGetSample(0, out FluidProbeSample first));
                Assert.That(first.time, Is.EqualTo(scene.Fluid.FluidTime));
                Assert.That(batch.TryGetSample(1, out FluidProbeSample outside) || outside.valid, Is.False);
                Assert.That(batch.TryGetSample(2, out FluidProbeSample nowhere) || nowhere.valid, Is.False);

                scene.Step();
                scene.Fluid.Restart();      // a request is pending
                AssertNone(batch);
                batch.Flush();
                AssertNone(batch);
                scene.Step();
                batch.Flush();
                Assert.That(batch.TryGetSample(0, out FluidProbeSample again));
                Assert.That(again.step, Is.EqualTo(1));

                scene.Fluid.KeepStateOnDisable = false;
                scene.Fluid.enabled = false;
                AssertNone(batch);
                scene.Fluid.enabled = true;
                AssertNone(batch);
            }
        }

        static void AssertNone(FluidQueryBatch batch)
        {
            Assert.That(batch.HasResult, Is.False);
            Assert.That(batch.TryGetSample(0, out FluidProbeSample sample), Is.False);
            Assert.That(sample.valid, Is.False);
        }

        [Test]
        public void A_batch_that_does_not_repeat_is_asked_once_each_time_that_it_is_set()
        {
            using (SourceScene scene = Pool())
            using (var batch = new FluidQueryBatch(scene.Fluid, 1) { Repeats = false })
            {
                Assert.That(batch.IsPending, Is.False);
                batch.SetPoints(new[] { Vector3.zero }, 0, 1);
                Assert.That(batch.IsPending);
                scene.Run(3);
                Assert.That(batch.IsPending, Is.False);
                Assert.That(batch.TryGetSample(0, out FluidProbeSample sample));
                Assert.That(sample.step, Is.EqualTo(1));
                batch.SetPoint(0, 0.1f * Vector3.down);
                Assert.That(batch.IsPending);
                Assert.That(batch.TryGetSample(0, out sample) && sample.step == 1, "the old one until the new one comes");
                scene.Run(1);
                Assert.That(batch.IsPending, Is.False);
                Assert.That(batch.TryGetSample(0, out sample) && sample.step == 4);
                scene.Fluid.Restart();      // what was answered is gone
                Assert.That(batch.IsPending);
                scene.Run(1);
                Assert.That(batch.TryGetSample(0, out sample) && sample.step == 1);
            }
        }

        [Test]
        public void What_a_batch_cannot_do_is_said_with_the_limit()
        {
            using (SourceScene scene = Pool())
            {
                AssertThrows<ArgumentNullException>(() => new FluidQueryBatch(null, 1), "fluid");
                AssertThrows<ArgumentOutOfRangeException>(() => new FluidQueryBatch(scene.Fluid, 0),
                    "A batch asks at 0 to 16,384 points, or casts at least one ray");
                AssertThrows<ArgumentOutOfRangeException>(() => new FluidQueryBatch(scene.Fluid, 16385), "make several for more");
                var batch = new FluidQueryBatch(scene.Fluid, 2);
                AssertThrows<ArgumentOutOfRangeException>(() => batch.SetPoints(new Vector3[3], 0, 3),
                    "3 points are more than this batch was made for, 2: make it larger, or several");
                AssertThrows<ArgumentOutOfRangeException>(() => batch.SetPoints(new Vector3[3], 2, 2), "2 points from 2 on are not in an array of 3");
                AssertThrows<ArgumentOutOfRangeException>(() => batch.SetPoint(0, Vector3.zero), "Index 0 is not one of 0 points");
                AssertThrows<ArgumentOutOfRangeException>(() => batch.TryGetSample(2, out _), "Index 2 is not one of 2 points");
                AssertThrows<ArgumentException>(() => batch.SetPoints(default(NativeArray<float3>)), "not created");
                AssertThrows<ArgumentOutOfRangeException>(() => batch.Radius = 0f, "above 0 m");
                batch.SetPoints(new Vector3[2], 0, 2);
                scene.Step();
                batch.Flush();
                using (var small = new NativeArray<FluidProbeSample>(1, Allocator.Persistent))
                    AssertThrows<ArgumentException>(() => batch.CopySamples(small), "holds 1 elements, and 2 results came back");
                scene.Step();       // a request is pending
                batch.Dispose();
                batch.Dispose();
                AssertThrows<ObjectDisposedException>(() => batch.TryGetSample(0, out _), "FluidQueryBatch");
                AssertThrows<ObjectDisposedException>(() => batch.SetPoint(0, Vector3.zero), "FluidQueryBatch");
                scene.Run(2);
            }
        }

        [Test]
        public void A_batch_outlives_its_fluid_and_says_nothing_of_it()
        {
            SourceScene scene = Pool();
            using (var batch = new FluidQueryBatch(scene.Fluid, 1))
            {
                using (scene)
                {
                    batch.SetPoints(new Vector3[1], 0, 1);
                    scene.Run(2);
                    Assert.That(batch.TryGetSample(0, out _));
                }
                AssertNone(batch);
                batch.Flush();
            }
        }

        // A point in the water, one outside the box, and a ray from above; set again in between.
        [Test, Category("LongRun")]
        public void Of_a_million_reads_at_any_time_none_is_passed_as_valid_that_is_not([Values] bool repeats)
        {
            using (var scene = new SourceScene(new Vector3(0.4f, 0.4f, 0.4f), Spacing, 300).Fill(0.2f))
            using (var batch = new FluidQueryBatch(scene.Fluid, 2, 1) { Repeats = repeats })
            {
                Vector3 inside = new Vector3(0f, -0.1f, 0f), outside = 3f * Vector3.one;
                int reads = 0, valid = 0, set = 0;
                void Fail(string what, int step, float age)
                    => Assert.Fail($"read {reads}: {what}, step {step} of {scene.Fluid.StepCount}, age {age}");
                bool IsOfNow(int step, double time, float age) => step >= 1 && step <= scene.Fluid.StepCount && age >= 0f
                    && Math.Abs(time + age - scene.Fluid.FrameTime) < 1e-5;
                void Read(int count)
                {
                    if (set++ % 7 == 0)
                    {
                        batch.SetPoints(new[] { inside, outside }, 0, 2);
                        batch.SetRays(new[] { new FluidRay(new Vector3(0f, 0.19f, 0f), Vector3.down) }, 0, 1);
                    }
                    for (int i = 0; i < count; i += 3, reads += 3)
                    {
                        bool isValid = batch.TryGetSample(0, out FluidProbeSample s);
                        if (isValid != s.valid || isValid != batch.HasResult || isValid && (!IsOfNow(s.step, s.time, s.age) || !(s.density > 0.5f)
                            || !s.hasSurface || s.position != inside))
                            Fail($"point {isValid}, density {s.density}", s.step, s.age);
                        if (batch.TryGetSample(1, out FluidProbeSample none) || none.valid)
                            Fail("a point outside the box is valid", none.step, none.age);
                        bool isCast = batch.TryGetHit(0, out FluidRayHit found);
                        if (isCast != found.valid || isCast != isValid || isCast && (!IsOfNow(found.step, found.time, found.age) || !found.hit
                            || Math.Abs(found.distance - 0.19f) > 2f * Spacing))
                            Fail($"ray {isCast}, hit {found.hit} at {found.distance}", found.step, found.age);
                        valid += isValid ? 3 : 0;
                    }
                }
                QueryScene.ReadAtAnyTime(scene.Fluid, Read);
                TestContext.Out.WriteLine($"{reads:N0} reads, {valid:N0} valid");
                Assert.That(reads, Is.GreaterThanOrEqualTo(1000000));
                Assert.That(valid, Is.GreaterThan(reads / 4).And.LessThan(reads));
            }
        }

        static SourceScene Pool() => new SourceScene(new Vector3(0.6f, 0.6f, 0.6f), Spacing, 1000).Fill(0.35f);

        static void AssertThrows<T>(TestDelegate call, string text) where T : Exception
            => Assert.That(Assert.Throws<T>(call).Message, Does.Match(Regex.Escape(text)));
    }
}
