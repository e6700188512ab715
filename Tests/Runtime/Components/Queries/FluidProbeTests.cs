using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Samples of probes, against the particles and geometry, and when they have none.</summary>
    public class FluidProbeTests
    {
        const float Spacing = QueryScene.Spacing;

        // The surface of water that stands lies where its volume has it.
        [Test]
        public void The_height_of_a_pool_is_within_a_quarter_spacing_and_its_normal_within_two_degrees_beside_walls_too()
        {
            using (var scene = new SourceScene(new Vector3(0.8f, 0.8f, 0.8f), Spacing, 5000).Fill(0.4f))
            {
                FluidProbe[] probes = Around().Select(at => scene.Probe(new Vector3(0.4f * at.x, 0.1f * at.y, 0.4f * at.z))).ToArray();
                scene.Run(60);
                AssertSurface(scene, probes, Vector3.up);
            }
        }

        // Water that already stands where gravity leans it.
        [TestCase(12f)]
        [TestCase(25f)]
        [Category("LongRun")]
        public void The_height_and_normal_of_a_pool_that_leans_are_those_of_gravity(float degrees)
        {
            using (var scene = new SourceScene(new Vector3(0.8f, 0.8f, 0.8f), Spacing, 5000))
            {
                Vector3 up = Quaternion.Euler(0f, 30f, degrees) * Vector3.up;
                scene.Fluid.Gravity = -9.81f * up;
                scene.AddWhere(p => Vector3.Dot(p, up) < 0f);
                FluidProbe[] probes = Around().Select(at => scene.Probe(OnPlane(0.4f * at.x, 0.4f * at.z, up) + 0.06f * at.y * up)).ToArray();
                scene.Run(90);
                AssertSurface(scene, probes, up);
            }
        }

        // Water that does not yet lie as gravity has it: the normal is that of the water.
        [TestCase(14f)]
        [TestCase(-25f)]
        public void The_normal_of_a_slope_is_the_slopes(float degrees)
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 8000))
            {
                Vector3 slope = Quaternion.Euler(degrees, 40f, 0f) * Vector3.up;
                scene.Fluid.Gravity = 1e-3f * Vector3.down;
                scene.AddWhere(p => Vector3.Dot(p, slope) < 0f);
                FluidProbe[] probes = Around().Select(at => scene.Probe(OnPlane(0.24f * at.x, 0.24f * at.z, slope))).ToArray();
                scene.Step();
                foreach (FluidProbe probe in probes)
                {
                    FluidProbeSample sample = probe.Flushed();
                    TestContext.Out.WriteLine($"{probe.transform.position}: depth {sample.depth / Spacing:0.000} d, normal off by " +
                        $"{Vector3.Angle(sample.normal, slope):0.00} degrees");
                }
                Assert.That(probes.Max(probe => Vector3.Angle(probe.Latest.normal, slope)), Is.LessThan(2f));
                Assert.That(probes.Max(probe => Math.Abs(probe.Latest.depth)), Is.LessThan(0.5f * Spacing));
            }
        }

        static Vector3 OnPlane(float x, float z, Vector3 up) => new Vector3(x, -(up.x * x + up.z * z) / up.y, z);

        // At the center, near one wall, and near two; above and below the surface. Of half the box.
        static IEnumerable<Vector3> Around()
        {
            foreach (float x in new[] { -0.9f, -0.41f, 0.07f, 0.93f })
                foreach (float z in new[] { -0.95f, 0f, 0.5f })
                    yield return new Vector3(x, x + z < 0f ? 1f : -1f, z);
        }

        static void AssertSurface(SourceScene scene, FluidProbe[] probes, Vector3 up)
        {
            Vector3 box = scene.Fluid.DomainSize;
            // Depth over the center of the floor by the center of mass, which lies at (h² + v) / 2h under a plane: v is the mean square of what it
            // leans by. The depth by volume is more by what the water is pressed together.
            ParticleState state = scene.Read();
            float low = state.positions.Average(p => p.y) * Spacing;
            float leans = (up.x * up.x * box.x * box.x + up.z * up.z * box.z * box.z) / (12f * up.y * up.y);
            float depth = low + Mathf.Sqrt(low * low - leans), byVolume = state.Count * scene.ParticleVolume / (box.x * box.z);
            float mean = depth - 0.5f * box.y;
            TestContext.Out.WriteLine($"{depth / Spacing:0.00} d deep, {byVolume / Spacing:0.00} d by volume");
            double worst = 0.0, steepest = 0.0;
            foreach (FluidProbe probe in probes)
            {
                FluidProbeSample sample = probe.Flushed();
                Assert.That(sample.hasSurface);
                float height = Vector3.Dot(new Vector3(0f, mean, 0f), up);
                float error = (sample.height - height) / Spacing, angle = Vector3.Angle(sample.normal, up);
                TestContext.Out.WriteLine($"{probe.transform.position}: height off by {error:0.000} d, normal by {angle:0.00} degrees");
                worst = Math.Max(worst, Math.Abs(error));
                steepest = Math.Max(steepest, angle);
                Assert.That(sample.depth, Is.EqualTo(sample.height - Vector3.Dot(sample.position, up)).Within(1e-4f));
            }
            TestContext.Out.WriteLine($"height within {worst:0.000} d, normal within {steepest:0.00} degrees");
            Assert.That(worst, Is.LessThan(0.25));
            Assert.That(steepest, Is.LessThan(2.0));
        }

        // More particles around a line than a group of threads lists, before the step that sorts them and after it.
        [Test]
        public void Height_and_density_of_crowded_water_are_those_of_all_its_particles()
        {
            using (var scene = new SourceScene(new Vector3(0.7f, 0.8f, 0.7f), Spacing, 30000))
            {
                scene.Run(1);
                float3[] positions = Lattice(new float3(-0.32f, -0.37f, -0.32f), new int3(39, 12, 39), Spacing / 3f);
                using (var water = new NativeArray<float3>(positions, Allocator.Persistent))
                using (var still = new NativeArray<float3>(water.Length, Allocator.Persistent))
                    scene.Fluid.AddParticles(water, still);
                var asked = new[] { new Vector3(0.01f, -0.3f, 0.02f), new Vector3(-0.21f, 0.1f, 0.13f), new Vector3(0.31f, -0.33f, -0.31f) };
                FluidProbe[] probes = asked.Select(scene.Probe).ToArray();
                for (int step = 0; step < 2; step++)
                {
                    ParticleState state = scene.Read();
                    foreach (FluidProbe probe in probes)
                    {
                        FluidProbeSample sample = probe.MeasureNow();
                        double3 at = (double3)((float3)sample.position + (float3)scene.Fluid.DomainSize * 0.5f) / Spacing;
                        Assert.That(sample.density, Is.EqualTo(QueryScene.Density(state, at)).Within(0.01).Percent, $"step {step}");
                        Assert.That(sample.height / Spacing + 0.5 * state.box.y, Is.EqualTo(QueryScene.Surface(state, at)).Within(0.01),
                            $"step {step}");
                    }
                    scene.Step();
                }
                Assert.That(scene.Read().Count, Is.EqualTo(positions.Length));
            }
        }

        static float3[] Lattice(float3 corner, int3 counts, float spacing)
        {
            var positions = new List<float3>();
            for (int z = 0; z < counts.z; z++)
                for (int y = 0; y < counts.y; y++)
                    for (int x = 0; x < counts.x; x++)
                        positions.Add(corner + spacing * new float3(x, y, z));
            return positions.ToArray();
        }

        // Water in motion: what the sort of the step says of neighbors still holds after its corrections.
        [Test]
        public void Density_velocity_and_height_of_a_breaking_dam_are_those_of_all_its_particles([Values(5, 25, 45)] int steps)
        {
            using (var scene = new SourceScene(new Vector3(1.2f, 0.8f, 0.4f), Spacing, 4000))
            {
                scene.AddWhere(p => p.x < -0.2f && p.y < 0.2f, new Vector3(2f, 0f, 0f));
                scene.Add<FluidEmitter>(new Vector3(0.3f, 0.2f, 0f), Vector3.left, e => e.Rate = 0.01f);
                var random = new Unity.Mathematics.Random(7u);
                float3 half = (float3)scene.Fluid.DomainSize * 0.499f;
                FluidProbe[] probes = Enumerable.Range(0, 40).Select(_ => scene.Probe(random.NextFloat3(-half, half))).ToArray();
                scene.Run(steps);
                ParticleState state = scene.Read();
                double densityError = 0.0, velocityError = 0.0, heightError = 0.0;
                int wet = 0, surfaces = 0;
                foreach (FluidProbe probe in probes)
                {
                    FluidProbeSample sample = probe.Flushed();
                    double3 at = (double3)((float3)sample.position + (float3)scene.Fluid.DomainSize * 0.5f) / Spacing;
                    double density = QueryScene.Density(state, at);
                    densityError = Math.Max(densityError, Math.Abs(density - sample.density));
                    Assert.That(sample.hasVelocity, Is.EqualTo(density > 0.0));
                    if (sample.hasVelocity)
                    {
                        wet++;
                        velocityError = Math.Max(velocityError,
                            math.distance(QueryScene.Velocity(state, at) * Spacing, (double3)(float3)sample.velocity));
                    }
                    double found = QueryScene.Surface(state, at);
                    Assert.That(sample.hasSurface, Is.EqualTo(!double.IsNaN(found)));
                    if (!sample.hasSurface)
                        continue;
                    surfaces++;
                    heightError = Math.Max(heightError, Math.Abs(found - (sample.height / Spacing + 0.5 * state.box.y)));
                }
                TestContext.Out.WriteLine($"{wet} in water, {surfaces} with a surface: density within {densityError:0.0000}, velocity " +
                    $"within {velocityError:0.0000} m/s, height within {heightError:0.000} d");
                Assert.That(surfaces, Is.GreaterThan(10));
                Assert.That(wet, Is.GreaterThan(5));
                Assert.That(densityError, Is.LessThan(1e-3));
                Assert.That(velocityError, Is.LessThan(2e-3));
                Assert.That(heightError, Is.LessThan(0.01));
            }
        }

        [Test]
        public void The_phase_is_that_of_the_water_around_and_what_a_source_has_just_let_in_counts()
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), Spacing, 3000))
            {
                scene.AddWhere(p => p.y < -0.3f && p.x < 0f);
                scene.Add<FluidEmitter>(new Vector3(0.3f, 0.3f, 0f), Vector3.down, e =>
                {
                    e.Rate = 0.05f;
                    e.Phase = 5;
                });
                FluidProbe water = scene.Probe(new Vector3(-0.3f, -0.42f, 0f)), jet = scene.Probe(new Vector3(0.3f, 0.29f, 0f));
                scene.Run(10);
                Assert.That(water.Flushed().phase, Is.Zero);
                Assert.That(jet.Flushed().phase, Is.EqualTo(5));
                Assert.That(jet.Latest.density, Is.GreaterThan(0.3f));
                Assert.That(jet.Latest.velocity.y, Is.LessThan(-0.5f));
            }
        }

        [Test]
        public void Nothing_is_valid_before_the_first_result_after_a_restart_outside_the_box_or_while_off()
        {
            using (var scene = new SourceScene(new Vector3(0.6f, 0.6f, 0.6f), Spacing, 1000).Fill(0.2f))
            {
                FluidProbe probe = scene.Probe(Vector3.zero), outside = scene.Probe(new Vector3(0f, 0.31f, 0f));
                AssertNone(probe);
                scene.Step();
                FluidProbeSample first = probe.Flushed();
                Assert.That(first.time, Is.EqualTo(scene.Fluid.FluidTime));
                Assert.That(first.position, Is.EqualTo(Vector3.zero));
                outside.Flush();
                AssertNone(outside);

                scene.Step(2);
                Assert.That(probe.TryGetSample(out FluidProbeSample late) && late.age > 0.5f * SourceScene.Step60 == late.step < 3,
                    "its age is that of its step");
                scene.Fluid.Restart();      // a request is pending
                AssertNone(probe);
                probe.Flush();
                AssertNone(probe);
                scene.Step();
                Assert.That(probe.Flushed().step, Is.EqualTo(1));

                probe.enabled = false;
                AssertNone(probe);
                probe.enabled = true;
                AssertNone(probe);
                scene.Step();
                probe.Flushed();
                scene.Fluid.KeepStateOnDisable = false;
                scene.Fluid.enabled = false;
                AssertNone(probe);
                scene.Fluid.enabled = true;
                AssertNone(probe);
            }
        }

        static void AssertNone(FluidProbe probe)
        {
            Assert.That(probe.TryGetSample(out FluidProbeSample sample), Is.False);
            Assert.That(sample.valid, Is.False);
            Assert.That(probe.Latest.valid, Is.False);
        }

        [Test]
        public void Of_a_million_reads_at_any_time_none_is_passed_as_valid_that_is_not()
        {
            using (var scene = new SourceScene(new Vector3(0.4f, 0.4f, 0.4f), Spacing, 300).Fill(0.2f))
            {
                FluidProbe probe = scene.Probe(new Vector3(0f, -0.1f, 0f));
                int valid = 0, reads = 0;
                double lastAge = 0.0;
                void Read(int count)
                {
                    for (int i = 0; i < count; i++, reads++)
                    {
                        bool isValid = probe.TryGetSample(out FluidProbeSample s);
                        if (isValid != s.valid || isValid
                            && (s.step < 1 || s.step > scene.Fluid.StepCount || !(s.density > 0.5f) || !s.hasSurface || !(s.age >= 0f)
                            || Math.Abs(s.time + s.age - scene.Fluid.FrameTime) > 1e-5))
                            Assert.Fail($"read {reads}: {isValid}, step {s.step} of {scene.Fluid.StepCount}, age {s.age}, density {s.density}");
                        valid += isValid ? 1 : 0;
                        lastAge = s.age;
                    }
                }
                QueryScene.ReadAtAnyTime(scene.Fluid, Read);
                TestContext.Out.WriteLine($"{reads:N0} reads, {valid:N0} valid, the last {lastAge:0.000} s old");
                Assert.That(reads, Is.GreaterThanOrEqualTo(1000000));
                Assert.That(valid, Is.GreaterThan(reads / 4).And.LessThan(reads));
            }
        }

        [Test]
        public void The_same_steps_give_the_same_bits_at_60_and_at_144_frames_a_second()
        {
            Dictionary<int, FluidProbeSample> slow = Series(60), fast = Series(144);
            int common = 0;
            foreach (int step in slow.Keys.Where(fast.ContainsKey))
            {
                FluidProbeSample a = slow[step], b = fast[step];
                Assert.That(b.height, Is.EqualTo(a.height), $"step {step}");
                Assert.That(b.density, Is.EqualTo(a.density), $"step {step}");
                Assert.That(b.velocity, Is.EqualTo(a.velocity), $"step {step}");
                Assert.That(b.normal, Is.EqualTo(a.normal), $"step {step}");
                Assert.That(b.time, Is.EqualTo(a.time), $"step {step}");
                common++;
            }
            Assert.That(common, Is.GreaterThan(25));
            Assert.That(slow.Values.Select(sample => sample.height).Distinct().Count(), Is.GreaterThan(20), "the water moves");
        }

        // The fluid steps in LateUpdate, and results come between frames: a script that reads at fixed times gets a few of them, each of its step.
        [UnityTest]
        public IEnumerator Samples_that_FixedUpdate_reads_are_those_of_their_steps()
        {
            Dictionary<int, FluidProbeSample> expected = Series(60);
            using (SourceScene scene = Breaking(out FluidProbe probe))
            {
                FixedReader reader = probe.gameObject.AddComponent<FixedReader>();
                reader.Probe = probe;
                for (int frame = 0; frame < 600 && scene.Fluid.StepCount < 28; frame++)
                    yield return null;
                int common = 0;
                foreach (int step in reader.Samples.Keys.Where(expected.ContainsKey))
                {
                    FluidProbeSample a = expected[step], b = reader.Samples[step];
                    Assert.That(b.height, Is.EqualTo(a.height), $"step {step}");
                    Assert.That(b.density, Is.EqualTo(a.density), $"step {step}");
                    Assert.That(b.velocity, Is.EqualTo(a.velocity), $"step {step}");
                    Assert.That(b.time, Is.EqualTo(a.time), $"step {step}");
                    common++;
                }
                TestContext.Out.WriteLine($"{reader.Reads} reads, {reader.Samples.Count} steps, {common} compared; oldest {reader.Oldest:0.000} s");
                Assert.That(common, Is.GreaterThanOrEqualTo(5));
                Assert.That(reader.Reads, Is.GreaterThanOrEqualTo(common));
                Assert.That(reader.IsConsistent, "step, time and age of each sample belong together");
            }
        }

        sealed class FixedReader : MonoBehaviour
        {
            public readonly Dictionary<int, FluidProbeSample> Samples = new Dictionary<int, FluidProbeSample>();
            public FluidProbe Probe;
            public int Reads;
            public double Oldest;
            public bool IsConsistent = true;

            void FixedUpdate()
            {
                bool isValid = Probe.TryGetSample(out FluidProbeSample sample);
                IsConsistent &= isValid == sample.valid;
                if (!isValid)
                    return;
                Reads++;
                Samples[sample.step] = sample;
                Oldest = Math.Max(Oldest, sample.age);
                IsConsistent &= sample.step <= Probe.Simulation.StepCount
                    && Math.Abs(sample.time + sample.age - Probe.Simulation.FrameTime) < 1e-5;
            }
        }

        static SourceScene Breaking(out FluidProbe probe)
        {
            var scene = new SourceScene(new Vector3(0.8f, 0.6f, 0.4f), Spacing, 2000);
            scene.AddWhere(p => p.x < 0f && p.y < 0f);
            probe = scene.Probe(new Vector3(0.05f, -0.2f, 0f));
            return scene;
        }

        static Dictionary<int, FluidProbeSample> Series(int rate)
        {
            using (SourceScene scene = Breaking(out FluidProbe probe))
            {
                var series = new Dictionary<int, FluidProbeSample>();
                for (int frame = 0; frame < rate / 2; frame++)
                {
                    scene.Fluid.Advance(1f / rate);
                    if (scene.Fluid.StepCount > 0)
                        series[scene.Fluid.StepCount] = probe.Flushed();
                }
                return series;
            }
        }

        [Test]
        public void One_probe_more_than_there_is_room_for_is_refused_by_name()
        {
            using (var scene = new SourceScene(new Vector3(0.4f, 0.4f, 0.4f), Spacing, 300).Fill(0.2f))
            {
                for (int i = 0; i < 64; i++)
                    scene.Probe(Vector3.zero);
                LogAssert.Expect(LogType.Warning,
                    new Regex(
                    "^Rill: FluidProbe 'FluidProbe': FluidSimulation 'Fluid' has 64 of its kind, the most it takes, and leaves this " +
                    "one out. Disable another"));
                FluidProbe late = scene.Probe(Vector3.zero);
                scene.Step();
                late.Flush();
                AssertNone(late);
            }
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void Without_gravity_there_is_no_surface_but_what_is_around_the_probe()
        {
            using (var scene = new SourceScene(new Vector3(0.6f, 0.6f, 0.6f), Spacing, 1000).Fill(0.3f))
            {
                scene.Fluid.Gravity = Vector3.zero;
                FluidProbe probe = scene.Probe(new Vector3(0f, -0.2f, 0f));
                scene.Step();
                FluidProbeSample sample = probe.Flushed();
                Assert.That(sample.hasSurface, Is.False);
                Assert.That(sample.density, Is.EqualTo(1f).Within(0.05f));
            }
        }

        [Test]
        public void A_column_without_water_has_no_surface_and_one_that_is_full_ends_at_the_lid()
        {
            using (var scene = new SourceScene(new Vector3(0.8f, 0.4f, 0.4f), Spacing, 2000))
            {
                scene.Fluid.Gravity = new Vector3(0f, -0.01f, 0f);
                scene.AddWhere(p => p.x < 0f);
                FluidProbe dry = scene.Probe(new Vector3(0.3f, 0f, 0f)), full = scene.Probe(new Vector3(-0.2f, 0f, 0f));
                scene.Step();
                FluidProbeSample none = dry.Flushed();
                Assert.That(none.hasSurface || none.hasVelocity, Is.False);
                Assert.That(none.density, Is.Zero);
                Assert.That(none.submerged, Is.Zero);
                Assert.That(full.Flushed().height, Is.EqualTo(0.2f).Within(1e-4f));
                Assert.That(full.Latest.submerged, Is.EqualTo(1f));
            }
        }

        // A block that rises evenly: the late sample says where its surface is by now.
        [Test]
        public void The_extrapolated_height_makes_up_for_the_lag()
        {
            using (var scene = new SourceScene(new Vector3(0.8f, 1f, 0.8f), Spacing, 4000))
            {
                scene.Fluid.Gravity = new Vector3(0f, -1e-3f, 0f);
                scene.AddWhere(p => p.y < -0.1f && p.y > -0.4f && Math.Abs(p.x) < 0.35f && Math.Abs(p.z) < 0.35f,
                    1.2f * Vector3.up);
                FluidProbe probe = scene.Probe(Vector3.zero);
                scene.Run(5);
                FluidProbeSample then = probe.Flushed();
                scene.Step(4);
                Assert.That(probe.TryGetSample(out FluidProbeSample late));
                Assert.That(late.step, Is.EqualTo(then.step), "the results of the last steps have not come");
                FluidProbeSample now = probe.Flushed();
                TestContext.Out.WriteLine(
                    $"{then.height:0.0000} m, {late.ExtrapolatedHeight:0.0000} m after {late.age:0.000} s, then {now.height:0.0000} m");
                Assert.That(now.height - then.height, Is.GreaterThan(1.4f * Spacing));
                Assert.That(late.ExtrapolatedHeight, Is.EqualTo(now.height).Within(0.15f * Spacing));
            }
        }

        [Test]
        public void The_submerged_fraction_is_that_of_the_ball_below_the_surface()
        {
            Assert.That(QueryResults.FractionOfBall(0f), Is.EqualTo(0.5f).Within(1e-6f));
            Assert.That(QueryResults.FractionOfBall(-1f), Is.Zero);
            Assert.That(QueryResults.FractionOfBall(2f), Is.EqualTo(1f));
            Assert.That(QueryResults.FractionOfBall(0.5f), Is.EqualTo(27f / 32f).Within(1e-6f));     // Archimedes: all but a cap of half the radius
        }
    }
}
