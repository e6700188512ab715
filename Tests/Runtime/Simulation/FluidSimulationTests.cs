using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;
using static System.FormattableString;

namespace Rill.Tests
{
    /// <summary>The component in a playing scene, a frame to each fixed step.</summary>
    public class FluidSimulationTests : PlayedFluidFixture
    {
        static readonly Vector3 Box = new Vector3(1f, 0.6f, 0.5f);
        const float Spacing = 0.05f;

        [UnityTest]
        public IEnumerator A_volume_fills_its_box_and_every_frame_takes_a_step()
        {
            FluidSimulation fluid = Dam();
            yield return Frames(5);
            Assert.That(fluid.IsRunning);
            Assert.That(fluid.StepCount, Is.EqualTo(5));
            Assert.That(fluid.FluidTime, Is.EqualTo(5.0 / 60.0).Within(1e-6));
            Assert.That(State(fluid).Count, Is.EqualTo(800));
        }

        [UnityTest]
        public IEnumerator Paused_fluid_stands_still_and_goes_on_as_if_nothing_had_been()
        {
            FluidSimulation fluid = Dam(), undisturbed = Dam();
            yield return Frames(3);
            fluid.Paused = true;
            ParticleState before = State(fluid);
            yield return Frames(4);
            TestFluid.AssertSame(State(fluid), before);
            Assert.That(fluid.StepCount, Is.EqualTo(3));

            fluid.Paused = false;
            undisturbed.Paused = true;
            yield return Frames(4);
            TestFluid.AssertSame(State(fluid), State(undisturbed));
        }

        [UnityTest]
        public IEnumerator A_restart_forgets_the_time_that_no_step_has_taken_yet()
        {
            FluidSimulation fluid = Dam();
            yield return Frames(1);
            fluid.Advance(0.7f * fluid.FixedStep);
            fluid.Restart();
            fluid.Advance(0.7f * fluid.FixedStep);
            Assert.That(fluid.StepCount, Is.Zero);
            fluid.Advance(0.7f * fluid.FixedStep);
            Assert.That(fluid.StepCount, Is.EqualTo(1));
        }

        [UnityTest]
        public IEnumerator A_restart_repeats_the_first_run_bit_for_bit()
        {
            FluidSimulation fluid = Dam();
            yield return Frames(10);
            ParticleState first = State(fluid);
            yield return Frames(7);
            fluid.Restart();
            Assert.That(fluid.StepCount, Is.Zero);
            yield return Frames(10);
            TestFluid.AssertSame(State(fluid), first);
        }

        [UnityTest]
        public IEnumerator Enabled_and_disabled_twenty_times_it_runs_as_it_did_at_first()
        {
            FluidSimulation fluid = Dam(f => f.KeepStateOnDisable = false);
            yield return Frames(5);
            ParticleState first = State(fluid);
            for (int i = 0; i < 20; i++)
            {
                fluid.enabled = false;
                Assert.That(fluid.IsRunning, Is.False);
                if (i % 2 == 0)
                    yield return null;
                fluid.enabled = true;
                Assert.That(fluid.IsRunning);
            }
            yield return Frames(5);
            TestFluid.AssertSame(State(fluid), first);
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator Two_simulations_in_a_scene_do_not_disturb_each_other()
        {
            FluidSimulation dam = Dam(), other = Other();
            yield return Frames(15);
            ParticleState damBesideOther = State(dam), otherBesideDam = State(other);
            dam.gameObject.SetActive(false);
            other.gameObject.SetActive(false);

            FluidSimulation damAlone = Dam();
            yield return Frames(15);
            TestFluid.AssertSame(damBesideOther, State(damAlone));
            damAlone.gameObject.SetActive(false);

            FluidSimulation otherAlone = Other();
            yield return Frames(15);
            TestFluid.AssertSame(otherBesideDam, State(otherAlone));

            FluidSimulation Other() => Fluid("Other", new Vector3(0.8f, 0.8f, 0.8f), 0.04f, 2000, new Vector3(0.4f, 0.4f, 0.4f), fluid =>
            {
                SolverSettings settings = SolverSettings.Default;
                settings.iterations = 2;
                settings.substeps = 2;
                fluid.Settings = settings;
                FluidMaterial material = FluidMaterial.Water;
                material.vorticity = 0.4f;
                material.shearModulus = 200f;
                material.artificialPressure = 0.05f;
                fluid.Material = material;
                fluid.Gravity = new Vector3(1f, -5f, 0f);
            });
        }

        [UnityTest]
        public IEnumerator A_deep_and_a_shallow_simulation_in_a_scene_do_not_disturb_each_other()
        {
            FluidSimulation deep = Tank(), shallow = Puddle();
            yield return Frames(10);
            Assert.That(Buffers(deep), Has.Member("Rill.Coarse.Bins"));
            Assert.That(Buffers(shallow), Has.No.Member("Rill.Coarse.Bins"));
            ParticleState deepTogether = State(deep), shallowTogether = State(shallow);
            deep.gameObject.SetActive(false);
            shallow.gameObject.SetActive(false);

            FluidSimulation deepAlone = Tank();
            yield return Frames(10);
            TestFluid.AssertSame(deepTogether, State(deepAlone));
            deepAlone.gameObject.SetActive(false);

            FluidSimulation shallowAlone = Puddle();
            yield return Frames(10);
            TestFluid.AssertSame(shallowTogether, State(shallowAlone));
        }

        [UnityTest]
        public IEnumerator A_restart_with_other_volumes_decides_again_whether_the_water_is_deep()
        {
            FluidSimulation fluid = Tank();
            yield return Frames(2);
            Assert.That(Buffers(fluid), Has.Member("Rill.Coarse.Bins"), "20 layers");

            var volume = fluid.GetComponentInChildren<FluidVolume>();
            volume.Size = new Vector3(0.5f, 0.2f, 0.5f);
            fluid.Restart();
            yield return Frames(2);
            Assert.That(Buffers(fluid), Has.No.Member("Rill.Coarse.Bins"), "4 layers");

            fluid.transform.rotation = Quaternion.Euler(0f, 0f, 90f);
            volume.Size = new Vector3(0.8f, 0.2f, 0.5f);
            fluid.Restart();
            yield return Frames(2);
            Assert.That(Buffers(fluid), Has.Member("Rill.Coarse.Bins"), "16 layers along what is down in the turned box");
        }

        [UnityTest]
        public IEnumerator Statistics_come_late_and_say_what_they_are_of()
        {
            FluidSimulation fluid = Dam(f => f.StatisticsInterval = 5);
            yield return Frames(5);
            Assert.That(fluid.TryGetStatistics(out _), Is.False, "in the frame that asked for them");
            yield return Frames(8);
            Assert.That(fluid.TryGetStatistics(out FluidStatistics statistics));
            Assert.That(statistics.step % 5, Is.Zero);
            Assert.That(statistics.particles, Is.EqualTo(800));
            Assert.That(statistics.time, Is.EqualTo(statistics.step / 60.0).Within(1e-6));
        }

        [UnityTest]
        public IEnumerator Statistics_from_before_a_restart_never_come()
        {
            FluidSimulation fluid = Dam(f => f.StatisticsInterval = 10);
            yield return Frames(30);
            Assert.That(fluid.TryGetStatistics(out _));
            fluid.Restart();
            Assert.That(fluid.TryGetStatistics(out _), Is.False);
            for (int frame = 0; frame < 20; frame++)
            {
                yield return null;
                if (fluid.TryGetStatistics(out FluidStatistics statistics))
                    Assert.That(statistics.step, Is.LessThanOrEqualTo(fluid.StepCount));
            }
            Assert.That(fluid.TryGetStatistics(out _));
        }

        [UnityTest]
        public IEnumerator An_interval_of_zero_measures_nothing_and_holds_nothing()
        {
            FluidSimulation fluid = Dam(f => f.StatisticsInterval = 1);
            yield return Frames(8);
            Assert.That(Buffers(fluid), Has.Member("Rill.Statistics.Results"));
            fluid.StatisticsInterval = 0;
            yield return Frames(8);
            Assert.That(Buffers(fluid), Has.No.Member("Rill.Statistics.Results"));
            Assert.That(fluid.TryGetStatistics(out _), Is.False);
        }

        [UnityTest]
        public IEnumerator Relaxation_above_the_limit_is_clamped_and_the_statistics_say_so()
        {
            FluidSimulation fluid = Dam(f => f.StatisticsInterval = 1);
            SolverSettings settings = SolverSettings.Default;
            settings.relaxation = 5f;
            LogAssert.Expect(LogType.Warning, new Regex("relaxation 5 is outside 0 to 2; using 2"));
            fluid.Settings = settings;
            yield return Frames(8);
            Assert.That(fluid.TryGetStatistics(out FluidStatistics statistics));
            Assert.That(statistics.relaxation, Is.EqualTo(SolverSettings.MaxRelaxation(settings.iterations)));
            Assert.That(statistics.relaxationClamped);
            Assert.That(fluid.Settings.relaxation, Is.EqualTo(2f), "what was asked for is kept for when more iterations allow it");

            fluid.Settings = SolverSettings.Default;
            yield return Frames(8);
            fluid.TryGetStatistics(out statistics);
            Assert.That(statistics.relaxationClamped, Is.False);
            LogAssert.NoUnexpectedReceived();
        }

        // Frames of 0.2 s need 12 steps, and 4 are taken.
        [Test]
        public void Time_that_is_dropped_is_told_once_after_five_frames_in_a_row()
        {
            using (var scene = new SourceScene(0.3f * Vector3.one, Spacing, 10))
            {
                for (int i = 0; i < 4; i++)
                    scene.Fluid.Advance(0.2f);
                scene.Step();
                for (int i = 0; i < 4; i++)
                    scene.Fluid.Advance(0.2f);
                LogAssert.NoUnexpectedReceived();
                LogAssert.Expect(LogType.Warning, new Regex("^Rill: FluidSimulation 'Fluid' drops time.* of 0\\.2 s need 12 fixed steps"));
                foreach (int row in new[] { 1, 8, 8 })
                {
                    for (int i = 0; i < row; i++)
                        scene.Fluid.Advance(0.2f);
                    scene.Step();
                }
            }
            LogAssert.NoUnexpectedReceived();
        }

        [UnityTest]
        public IEnumerator A_viscosity_beyond_its_passes_is_said_once_by_name_with_the_remedy()
        {
            FluidMaterial thick = FluidMaterial.Viscous(1000f, 50000f);
            LogAssert.Expect(LogType.Warning,
                new Regex(
                "'Dam': its dynamic viscosity of 5E\\+04 Pa s is more than 96 passes solve: at this spacing and substep that is .* Pa " +
                "s\\. .* Take 9 substeps or a particle spacing of 0\\.1[45].* m, or lower"));
            FluidSimulation fluid = Dam(f => f.Material = thick);
            yield return Frames(3);
            LogAssert.NoUnexpectedReceived();
            List<string> Problems()
            {
                var problems = new List<string>();
                ((IHasProblems)fluid).ListProblems(problems);
                return problems;
            }
            Assert.That(Problems(), Has.Some.Contains("its dynamic viscosity of 5E+04 Pa s"));
            TestContext.Out.WriteLine(Problems()[0]);

            SolverSettings settings = SolverSettings.Default;
            settings.substeps = 9;
            fluid.Settings = settings;
            yield return Frames(2);
            Assert.That(Problems(), Is.Empty);
        }

        [UnityTest]
        public IEnumerator A_surface_tension_that_does_not_act_as_asked_is_said_once_by_name_with_the_remedy([Values(0, 1, 2)] int fault)
        {
            string expected = new[]
            {
                "its surface tension of 0.1 N/m does not act with 1 iteration. Take 2 iterations or more, or set Surface Tension to 0.",
                "N/m: more is not stable at this spacing and substep. Take 2 substeps or a particle spacing of",
                "its artificial pressure and allowed tension do not act beside its surface tension, which replaces them. Set both to 0,",
            }[fault];
            LogAssert.Expect(LogType.Warning, new Regex("^Rill: FluidSimulation 'Dam': .*" + Regex.Escape(expected)));
            FluidSimulation fluid = Dam(f =>
            {
                FluidMaterial material = FluidMaterial.Water;
                float limit = material.MaxSurfaceTension(f.ParticleSpacing, f.FixedStep, 4, true);
                material.surfaceTension = fault == 1 ? 3f * limit : 0.1f;
                material.allowedTension = fault == 2 ? 0.05f : 0f;
                f.Material = material;
                f.DeepWater = DeepWater.On;
                f.Iterations = fault == 0 ? 1 : 4;
            });
            yield return Frames(3);
            LogAssert.NoUnexpectedReceived();
            Assert.That(Problems(), Has.Count.EqualTo(1).And.Some.Contains(expected));

            FluidMaterial corrected = fluid.Material;
            corrected.allowedTension = 0f;
            fluid.Material = corrected;
            fluid.Iterations = 4;
            fluid.Substeps = 2;
            yield return Frames(2);
            Assert.That(Problems(), Is.Empty);

            List<string> Problems()
            {
                var problems = new List<string>();
                ((IHasProblems)fluid).ListProblems(problems);
                return problems;
            }
        }

        [UnityTest]
        public IEnumerator Deep_water_without_relaxation_gains_no_energy_and_the_statistics_say_why()
        {
            SolverSettings settings = SolverSettings.Default;
            settings.relaxation = 0f;
            FluidSimulation fluid = Dam(f => { f.StatisticsInterval = 1; f.Settings = settings; });
            yield return Frames(8);
            Assert.That(fluid.TryGetStatistics(out FluidStatistics first));
            Assert.That(first.relaxationClamped);
            float highest = 0f, last = 0f;
            for (int frame = 0; frame < 80; frame++)
            {
                yield return null;
                Assert.That(fluid.TryGetStatistics(out FluidStatistics now));
                last = now.Energy;
                highest = math.max(highest, last);
            }
            TestContext.Out.WriteLine($"{first.Energy} J, at most {highest}, in the end {last}");
            Assert.That(highest, Is.LessThan(1.001f * first.Energy));
            Assert.That(last, Is.LessThan(0.7f * first.Energy), "it has fallen");
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator Gravity_too_strong_for_the_step_takes_more_substeps_and_the_statistics_say_so()
        {
            FluidSimulation fluid = Dam(f => f.StatisticsInterval = 1);
            yield return Frames(8);
            Assert.That(fluid.TryGetStatistics(out FluidStatistics statistics));
            Assert.That(statistics.substeps, Is.EqualTo(1));
            fluid.Gravity = new Vector3(0f, -981f, 0f);     // 5.45 spacings in a step
            yield return Frames(30);
            fluid.TryGetStatistics(out statistics);
            Assert.That(statistics.substeps, Is.EqualTo(5));
            Assert.That(fluid.Settings.substeps, Is.EqualTo(1), "what was asked for is kept");
            Assert.That(statistics.densityError, Is.LessThan(0.1f));
        }

        [UnityTest]
        public IEnumerator After_a_hitch_the_fluid_is_that_of_as_many_steps_without_one()
        {
            FluidSimulation fluid = Dam(), even = Dam();
            yield return Frames(3);
            even.Paused = true;
            Time.captureDeltaTime = 1f;
            yield return null;
            Time.captureDeltaTime = 1f / 60f;
            yield return Frames(3);
            Assert.That(fluid.StepCount, Is.EqualTo(3 + 4 + 3));
            fluid.Paused = true;
            even.Paused = false;
            yield return Frames(4 + 3);
            TestFluid.AssertSame(State(fluid), State(even));
        }

        [UnityTest]
        public IEnumerator A_velocity_that_is_not_finite_culls_its_particle_and_no_other([Values(float.NaN, float.NegativeInfinity)] float bad)
        {
            FluidSimulation fluid = Dam(f => f.StatisticsInterval = 1);
            Add(fluid, new float3(0f, 0.1f, 0f), new float3(0f, bad, 0f));
            yield return Frames(8);
            Assert.That(fluid.TryGetStatistics(out FluidStatistics statistics));
            Assert.That(statistics.particles, Is.EqualTo(800));
            Assert.That(statistics.nonFinite, Is.EqualTo(1));
        }

        [UnityTest]
        public IEnumerator Ten_kilometers_from_the_origin_the_fluid_does_as_at_home()
        {
            FluidSimulation far = Dam(f => f.transform.position = new Vector3(1e4f, 1e4f, -1e4f)), near = Dam();
            yield return Frames(40);
            ParticleState there = State(far), here = State(near);
            Assert.That(there.Count, Is.EqualTo(800));
            // Positions are filled in by world space, whose floats are a thousandth of a meter apart out there.
            Assert.That(math.distance(Mean(there), Mean(here)), Is.LessThan(0.1f));

            float3 Mean(ParticleState state) => new float3(state.positions.Average(p => p.x), state.positions.Average(p => p.y),
                state.positions.Average(p => p.z));
        }

        [UnityTest]
        public IEnumerator Any_spacing_means_the_same_when_gravity_is_in_proportion([Values(1e-4f, 10f)] float spacing)
        {
            FluidSimulation fluid = Fluid("Scaled", Box / Spacing * spacing, spacing, 1000, new Vector3(10f, 8f, 10f) * spacing,
                f => f.Gravity = Vector3.down * (9.81f * spacing / Spacing)), usual = Dam();
            yield return Frames(20);
            ParticleState state = State(fluid), expected = State(usual);
            Assert.That(state.Count, Is.EqualTo(800));
            Assert.That(state.positions.Average(p => p.x), Is.EqualTo(expected.positions.Average(p => p.x)).Within(0.05f));
            Assert.That(state.positions.Average(p => p.y), Is.EqualTo(expected.positions.Average(p => p.y)).Within(0.05f));
        }

        [UnityTest]
        public IEnumerator A_hitch_takes_the_most_steps_and_drops_the_rest()
        {
            FluidSimulation fluid = Dam(f => f.StatisticsInterval = 1);
            yield return Frames(3);
            Time.captureDeltaTime = 1f;
            yield return null;      // goes on within the frame of the hitch, before its steps
            float hitch = Time.deltaTime;
            int before = fluid.StepCount;
            Time.captureDeltaTime = 1f / 60f;
            yield return null;
            Assert.That(fluid.StepCount, Is.EqualTo(before + 4));
            yield return Frames(8);
            Assert.That(fluid.StepCount, Is.EqualTo(before + 4 + 8), "nothing of the hitch is caught up with");
            Assert.That(fluid.TryGetStatistics(out FluidStatistics statistics));
            Assert.That(statistics.droppedTime, Is.EqualTo(hitch - 4.0 / 60.0).Within(1.5 / 60.0));
            Assert.That(statistics.escaped + statistics.nonFinite, Is.Zero);
        }

        [TestCase(0f, 10f)]
        [TestCase(-60f, 10f)]
        [TestCase(2000f, 1000f)]
        [TestCase(float.NaN, 60f)]
        [TestCase(float.PositiveInfinity, 60f)]
        public void A_step_rate_out_of_range_is_clamped_by_name(float given, float expected)
        {
            LogAssert.Expect(LogType.Warning,
                new Regex(Invariant($"'Dam': step rate {Regex.Escape(Invariant($"{given}"))} is outside 10 to 1000; using {expected}\\.")));
            FluidSimulation fluid = Dam(f => SetSerialized(f, "stepRate", given));
            Assert.That(fluid.IsRunning);
            Assert.That(fluid.FixedStep, Is.EqualTo(1f / expected));
            LogAssert.NoUnexpectedReceived();
        }

        [UnityTest]
        public IEnumerator Steps_of_a_frame_out_of_range_are_clamped_by_name([Values(-1, 0, 17)] int given)
        {
            int expected = given < 1 ? 1 : 16;
            LogAssert.Expect(LogType.Warning, new Regex(Invariant($"'Dam': max steps per frame {given} is outside 1 to 16; using {expected}\\.")));
            FluidSimulation fluid = Dam(f => SetSerialized(f, "maxStepsPerFrame", given));
            Time.captureDeltaTime = 0.3f;
            yield return null;      // goes on within the first frame of that length, before its steps
            int before = fluid.StepCount;
            yield return null;
            Assert.That(fluid.StepCount, Is.EqualTo(before + expected));
            LogAssert.NoUnexpectedReceived();
        }

        [UnityTest]
        public IEnumerator A_gravity_that_is_not_finite_becomes_the_default_by_name([Values(float.NaN, float.NegativeInfinity)] float bad)
        {
            FluidSimulation fluid = Dam();
            LogAssert.Expect(LogType.Warning, new Regex("'Dam': gravity .* is not finite; using \\(0.00, -9.81, 0.00\\)\\."));
            fluid.Gravity = new Vector3(1f, bad, 0f);
            Assert.That(fluid.Gravity, Is.EqualTo(new Vector3(0f, -9.81f, 0f)));
            yield return Frames(2);
            Assert.That(State(fluid).Count, Is.EqualTo(800));
            LogAssert.NoUnexpectedReceived();
        }

        [UnityTest]
        public IEnumerator Frames_shorter_than_a_step_add_up()
        {
            FluidSimulation fluid = Dam();
            Time.captureDeltaTime = 1f / 240f;
            yield return null;
            int before = fluid.StepCount;
            yield return Frames(40);
            Assert.That(fluid.StepCount - before, Is.InRange(9, 11));
        }

        [UnityTest]
        public IEnumerator A_transform_that_stops_being_finite_is_said_once_and_not_followed()
        {
            FluidSimulation fluid = Stretched(out GameObject stretched), healthy = Dam(f => f.transform.position = Aside);
            yield return Frames(2);
            Matrix4x4 pose = fluid.DomainToWorld;
            LogAssert.Expect(LogType.Error, new Regex("'Dam': its transform is not finite.*goes on where it last was.*and its parents"));
            stretched.transform.localScale = Vector3.one * 3e38f;
            yield return Frames(10);
            Assert.That(fluid.IsRunning);
            Assert.That(fluid.DomainToWorld, Is.EqualTo(pose));
            TestFluid.AssertSame(State(fluid), State(healthy));

            stretched.transform.localScale = Vector3.one;
            fluid.transform.localPosition = Aside + Vector3.up;
            yield return Frames(5);
            Assert.That(fluid.DomainToWorld, Is.Not.EqualTo(pose));
            TestFluid.AssertSame(State(fluid), State(healthy));

            LogAssert.Expect(LogType.Error, new Regex("'Dam': its transform is not finite"));
            stretched.transform.localScale = Vector3.one * 3e38f;
            yield return Frames(3);
        }

        [UnityTest]
        public IEnumerator A_simulation_cannot_start_where_there_is_no_place()
        {
            FluidSimulation fluid = Stretched(out GameObject stretched), healthy = Dam();
            fluid.enabled = false;
            stretched.transform.localScale = Vector3.one * 3e38f;
            LogAssert.Expect(LogType.Error, new Regex("'Dam' is off: its transform is not finite.*Set position"));
            fluid.enabled = true;
            yield return Frames(3);
            Assert.That(fluid.IsRunning, Is.False);
            Assert.That(healthy.StepCount, Is.EqualTo(3));

            stretched.transform.localScale = Vector3.one;       // which is enough
            yield return Frames(2);
            Assert.That(fluid.StepCount, Is.EqualTo(2));
        }

        static readonly Vector3 Aside = new Vector3(2f, 0f, 0f);

        // Beside a parent whose scale can take it beyond all numbers.
        FluidSimulation Stretched(out GameObject parent)
        {
            var stretched = new GameObject("Stretched");
            made.Add(stretched);
            FluidSimulation fluid = Dam(f =>
            {
                f.transform.SetParent(stretched.transform, false);
                f.transform.localPosition = Aside;
            });
            parent = stretched;
            return fluid;
        }

        static readonly BadLayout[] BadLayouts =
        {
            new BadLayout(Box, Spacing, 0, "Capacity 0.*1 to 16,777,216 particles"),
            new BadLayout(Box, Spacing, -7, "Capacity -7"),
            new BadLayout(Box, 0f, 1000, "Particle spacing 0 m: it must be above 0"),
            new BadLayout(Box, float.NaN, 1000, "Particle spacing NaN m"),
            new BadLayout(new Vector3(1f, 0.05f, 1f), Spacing, 1000, "Domain size.*at least the support radius, 0.1 m"),
            new BadLayout(new Vector3(1f, float.PositiveInfinity, 1f), Spacing, 1000, "Domain size.*not finite"),
            new BadLayout(new Vector3(1f, 2000f, 1f), Spacing, 1000, "8,192 particle spacings"),
        };

        [UnityTest]
        public IEnumerator A_bad_layout_stops_the_fluid_with_a_message_until_it_is_a_good_one([ValueSource(nameof(BadLayouts))] BadLayout bad)
        {
            FluidSimulation healthy = Dam();
            LogAssert.Expect(LogType.Error, new Regex("FluidSimulation 'Bad' is off: .*" + bad.Message));
            FluidSimulation fluid = Fluid("Bad", bad.Box, bad.Spacing, bad.Capacity, Vector3.zero);
            yield return Frames(2);
            Assert.That(fluid.enabled, "so that it can recover");
            Assert.That(fluid.IsRunning, Is.False);
            Assert.That(healthy.StepCount, Is.EqualTo(2));
            LogAssert.Expect(LogType.Error, new Regex("FluidSimulation 'Bad' is off: .*" + bad.Message));
            fluid.Restart();        // says why, again
            yield return Frames(2);

            fluid.Configure(Box, Spacing, 1000);
            yield return Frames(2);
            Assert.That(fluid.StepCount, Is.EqualTo(2));
        }

        [UnityTest]
        public IEnumerator A_volume_partly_outside_is_filled_as_far_as_it_lies_inside_and_says_so()
        {
            LogAssert.Expect(LogType.Warning, new Regex("400 of 800 particles of FluidVolume 'Water' lie outside the domain of 'Half'"));
            FluidSimulation fluid = Fluid("Half", Box, Spacing, 1000, Vector3.zero,
                f => AddWater(f, new Vector3(0.5f, 0.4f, 0.5f), new Vector3(0.5f, 0f, 0f)));
            yield return Frames(1);
            Assert.That(State(fluid).Count, Is.EqualTo(400));
            LogAssert.NoUnexpectedReceived();
        }

        [UnityTest]
        public IEnumerator A_volume_that_a_scale_moves_outside_names_the_scale([Values("parent", "fluid", "none")] string scaled)
        {
            var rig = new GameObject("Rig");
            made.Add(rig);
            rig.transform.localScale = (scaled == "parent" ? 2f : 1f) * Vector3.one;
            string cause = scaled == "none" ? ""
                : $@"The scale \(2.00, 2.00, 2.00\) of '{(scaled == "parent" ? "Rig" : "Half")}' moves .* set it to 1\. ";
            LogAssert.Expect(LogType.Warning,
                new Regex($@"400 of 800 particles of FluidVolume 'Water' lie outside .* left out\. {cause}Move or shrink"));
            FluidSimulation fluid = Fluid("Half", Box, Spacing, 1000, Vector3.zero, f =>
            {
                f.transform.SetParent(rig.transform, false);
                f.transform.localScale = (scaled == "fluid" ? 2f : 1f) * Vector3.one;
                AddWater(f, new Vector3(0.5f, 0.4f, 0.5f), new Vector3(scaled == "none" ? 0.5f : 0.25f, 0f, 0f));
            });
            yield return Frames(1);
            Assert.That(State(fluid).Count, Is.EqualTo(400));
            LogAssert.NoUnexpectedReceived();
        }

        [UnityTest]
        public IEnumerator Volumes_beyond_the_capacity_are_refused_by_number()
        {
            LogAssert.Expect(LogType.Warning, new Regex("'Small' refused 300 of 800 particles of its volumes: the capacity is 500"));
            FluidSimulation fluid = Fluid("Small", Box, Spacing, 500, new Vector3(0.5f, 0.4f, 0.5f));
            yield return Frames(1);
            Assert.That(State(fluid).Count, Is.EqualTo(500));
            LogAssert.NoUnexpectedReceived();
        }

        [UnityTest]
        public IEnumerator A_volume_that_is_not_finite_is_left_out_by_name()
        {
            LogAssert.Expect(LogType.Error, new Regex("FluidVolume 'Water' was not filled: .*not finite"));
            FluidSimulation fluid = Fluid("Fluid", Box, Spacing, 1000, new Vector3(0.5f, 0.4f, 0.5f),
                f => AddWater(f, new Vector3(0.5f, float.NaN, 0.5f), Vector3.zero));
            yield return Frames(1);
            Assert.That(State(fluid).Count, Is.EqualTo(800), "the other volume");
        }

        [UnityTest]
        public IEnumerator Added_particles_come_from_world_space_into_the_domain()
        {
            FluidSimulation fluid = Fluid("Turned", Box, Spacing, 10, Vector3.zero, f =>
            {
                f.transform.SetPositionAndRotation(new Vector3(100f, -50f, 7f), Quaternion.Euler(0f, 90f, 0f));
                f.Paused = true;
            });
            // The domain's x points along the world's -z.
            Add(fluid, new float3(100f, -50f, 7f - 0.25f), new float3(0f, 0f, -3f));
            yield return null;
            ParticleState state = State(fluid);
            Assert.That(state.Count, Is.EqualTo(1));
            Assert.That(math.distance(state.positions[0].xyz, new float3(0.75f, 0.3f, 0.25f) / Spacing), Is.LessThan(1e-3f));
            Assert.That(math.distance(state.velocities[0].xyz, new float3(3f, 0f, 0f) / Spacing), Is.LessThan(1e-3f));
        }

        [UnityTest]
        public IEnumerator Added_particles_beyond_the_capacity_are_refused_and_counted()
        {
            FluidSimulation fluid = Fluid("Small", Box, Spacing, 3, Vector3.zero, f => f.StatisticsInterval = 1);
            for (int i = 0; i < 5; i++)
                Add(fluid, new float3(0.1f * i - 0.2f, 0f, 0f), 0f);
            yield return Frames(8);
            Assert.That(fluid.TryGetStatistics(out FluidStatistics statistics));
            Assert.That(statistics.particles, Is.EqualTo(3));
            Assert.That(statistics.refused, Is.EqualTo(2));
        }

        [UnityTest]
        public IEnumerator Particles_cannot_be_added_to_a_fluid_that_does_not_run_or_without_velocities()
        {
            FluidSimulation fluid = Fluid("Fluid", Box, Spacing, 10, Vector3.zero);
            using (var positions = new NativeArray<float3>(2, Allocator.Persistent))
            using (var velocities = new NativeArray<float3>(3, Allocator.Persistent))
            {
                Assert.That(Assert.Throws<ArgumentException>(() => fluid.AddParticles(positions, velocities)).Message,
                    Does.Contain("2 positions with 3 velocities"));
                fluid.enabled = false;
                Assert.That(Assert.Throws<InvalidOperationException>(() => fluid.AddParticles(positions, positions)).Message,
                    Does.Contain("'Fluid' is not running"));
            }
            yield return null;
        }

        [UnityTest]
        public IEnumerator A_box_that_speeds_up_pushes_its_fluid_only_if_inertial([Values(true, false)] bool inertial)
        {
            FluidSimulation fluid = Dam(f => f.Inertial = inertial), still = Dam();
            yield return Frames(2);
            double velocity = 0.0;
            for (int frame = 0; frame < 10; frame++)
            {
                velocity += 6.0 / 60.0;     // 6 m/s²
                fluid.transform.position += Vector3.right * (float)(velocity / 60.0);
                yield return null;
                if (frame > 0)
                    Assert.That(math.distance(fluid.Input.gravity, new float3(inertial ? -6f : 0f, -9.81f, 0f)), Is.LessThan(0.05f),
                        $"frame {frame}");
            }
            if (inertial)
                Assert.That(State(fluid).velocities.Average(v => v.x), Is.LessThan(State(still).velocities.Average(v => v.x) - 1f));
            else
                TestFluid.AssertSame(State(fluid), State(still));
        }

        [UnityTest]
        public IEnumerator A_turned_box_feels_gravity_from_its_own_side()
        {
            FluidSimulation fluid = Dam();
            yield return Frames(2);
            fluid.transform.rotation = Quaternion.Euler(0f, 0f, 90f);
            yield return null;
            Assert.That(math.distance(fluid.Input.gravity, new float3(-9.81f, 0f, 0f)), Is.LessThan(1e-4f));
        }

        [UnityTest]
        public IEnumerator Moving_the_box_while_paused_is_no_push()
        {
            FluidSimulation fluid = Dam();
            yield return Frames(2);
            fluid.Paused = true;
            fluid.transform.position += Vector3.right * 3f;
            yield return Frames(2);
            fluid.Paused = false;
            yield return null;
            Assert.That(math.distance(fluid.Input.gravity, new float3(0f, -9.81f, 0f)), Is.LessThan(1e-3f));
        }

        [UnityTest]
        public IEnumerator A_hitch_of_a_box_in_even_motion_is_no_push()
        {
            FluidSimulation fluid = Dam();
            const float speed = 2f;
            for (int frame = 0; frame < 6; frame++)
            {
                fluid.transform.position += Vector3.right * (speed / 60f);
                yield return null;
            }
            float hitch = Time.maximumDeltaTime;
            Time.captureDeltaTime = hitch;
            fluid.transform.position += Vector3.right * (speed / 60f);
            yield return null;      // goes on within the frame of the hitch, before its steps
            fluid.transform.position += Vector3.right * (speed * hitch);
            yield return null;
            Assert.That(math.abs(fluid.Input.gravity.x), Is.LessThan(1f));
        }

        // Frames and steps differ: at 144 Hz two or three frames pass between two steps.
        [Test]
        public void A_box_in_even_or_evenly_faster_motion_is_pushed_alike_at_any_frame_rate([Values(1f / 144f, 1f / 100f, 1f / 60f,
            1f / 25f)] float frame, [Values(0f, 6f)] float acceleration)
        {
            using (var scene = new SourceScene(new Vector3(1f, 1f, 1f), 0.1f, 100))
            {
                scene.Fluid.Gravity = Vector3.zero;
                float worst = 0f;
                for (int i = 0; i * frame < 1f; i++)
                {
                    float time = i * frame;
                    scene.Fluid.transform.position = new Vector3(2f * time + 0.5f * acceleration * time * time, 0f, 0f);
                    scene.Fluid.Advance(frame);
                    if (time > 0.2f)
                        worst = math.max(worst, math.abs(scene.Fluid.Input.gravity.x + acceleration));
                }
                TestContext.Out.WriteLine($"off by at most {worst:0.000} m/s²");
                Assert.That(worst, Is.LessThan(0.05f));
            }
        }

        [UnityTest]
        public IEnumerator New_settings_go_on_with_the_fluid_as_it_is()
        {
            // Sides that the spacing does not divide, in a box where rounding shows.
            FluidSimulation fluid = Fluid("Odd", new Vector3(1.1f, 0.7f, 0.53f), 0.03f, 5000, new Vector3(0.3f, 0.3f, 0.3f));
            yield return Frames(3);
            FluidMaterial material = fluid.Material;
            material.velocitySmoothing = 0.1f;
            fluid.Material = material;
            SolverSettings settings = fluid.Settings;
            settings.iterations = 2;
            fluid.Settings = settings;
            yield return Frames(2);
            Assert.That(fluid.StepCount, Is.EqualTo(5));
        }

        [UnityTest]
        public IEnumerator A_new_layout_starts_the_fluid_again()
        {
            FluidSimulation fluid = Dam();
            yield return Frames(3);
            fluid.Configure(Box, 0.1f, 1000);
            yield return Frames(2);
            Assert.That(fluid.StepCount, Is.EqualTo(2));
            Assert.That(State(fluid).Count, Is.EqualTo(100));

            SolverSettings settings = fluid.Settings;
            settings.neighborCapacity = 96;
            fluid.Settings = settings;
            yield return Frames(2);
            Assert.That(fluid.StepCount, Is.EqualTo(2));
            Assert.That(fluid.Solver.Layout.NeighborCapacity, Is.EqualTo(96));
        }

        [UnityTest]
        public IEnumerator Vorticity_turned_on_and_off_leaves_no_buffer()
        {
            FluidSimulation fluid = Dam();
            yield return Frames(2);
            SetVorticity(0.5f);
            yield return Frames(2);
            Assert.That(Buffers(fluid), Has.Member("Rill.Curl"));
            SetVorticity(0f);
            yield return Frames(2);
            Assert.That(Buffers(fluid), Has.No.Member("Rill.Curl").And.No.Member("Rill.Unconfined"));
            Assert.That(fluid.StepCount, Is.EqualTo(6));

            void SetVorticity(float value)
            {
                FluidMaterial material = fluid.Material;
                material.vorticity = value;
                fluid.Material = material;
            }
        }

        [UnityTest]
        public IEnumerator A_renderer_of_the_density_has_it_summed()
        {
            FluidSimulation fluid = Dam(f =>
            {
                FluidMaterial material = FluidMaterial.Water;
                material.velocitySmoothing = 0f;
                f.Material = material;
            });
            yield return Frames(2);
            Assert.That(State(fluid).velocities.All(v => v.w == 1f));

            fluid.gameObject.AddComponent<ParticleRenderer>().ColorBy = ParticleRenderer.Quantity.Density;
            yield return Frames(3);
            Assert.That(State(fluid).velocities.Count(v => v.w != 1f), Is.GreaterThan(700));
        }

        [UnityTest]
        public IEnumerator The_density_is_summed_while_any_renderer_shows_it()
        {
            FluidSimulation fluid = Dam();
            var byDensity = fluid.gameObject.AddComponent<ParticleRenderer>();
            byDensity.ColorBy = ParticleRenderer.Quantity.Density;
            var bySpeed = fluid.gameObject.AddComponent<ParticleRenderer>();
            yield return Frames(3);
            Assert.That(fluid.Input.needsDensity, "beside one that shows the speed");
            bySpeed.enabled = false;
            yield return null;
            Assert.That(fluid.Input.needsDensity, "when that one goes");
            byDensity.enabled = false;
            yield return Frames(2);
            Assert.That(fluid.Input.needsDensity, Is.False);
        }

        [UnityTest]
        public IEnumerator A_destroyed_simulation_leaves_the_others_running()
        {
            FluidSimulation fluid = Dam(f => f.StatisticsInterval = 1), other = Dam();
            yield return Frames(2);
            Object.Destroy(fluid.gameObject);
            yield return Frames(3);
            Assert.That(fluid == null);
            Assert.That(other.StepCount, Is.EqualTo(5));
        }

        [Test]
        public void The_domain_begins_at_its_lowest_corner()
        {
            FluidSimulation fluid = Fluid("Placed", Box, Spacing, 10, Vector3.zero, f => f.transform.position = new Vector3(5f, 6f, 7f));
            Assert.That(Vector3.Distance(fluid.DomainToWorld.MultiplyPoint3x4(Vector3.zero), new Vector3(4.5f, 5.7f, 6.75f)), Is.LessThan(1e-5f));
            Assert.That(Vector3.Distance(fluid.DomainToWorld.MultiplyPoint3x4(new Vector3(20f, 12f, 10f)), new Vector3(5.5f, 6.3f, 7.25f)),
                Is.LessThan(1e-5f));
        }

        /// <summary>A layout that cannot be, and what is logged of it.</summary>
        public sealed class BadLayout
        {
            public readonly Vector3 Box;
            public readonly float Spacing;
            public readonly int Capacity;
            public readonly string Message;

            public BadLayout(Vector3 box, float spacing, int capacity, string message)
            {
                Box = box;
                Spacing = spacing;
                Capacity = capacity;
                Message = message;
            }

            public override string ToString() => $"box {Box}, spacing {Spacing}, capacity {Capacity}";
        }

        FluidSimulation Dam(Action<FluidSimulation> setUp = null) => Fluid("Dam", Box, Spacing, 1000, new Vector3(0.5f, 0.4f, 0.5f), setUp);

        // Too shallow for the coarse correction.
        FluidSimulation Puddle() => Fluid("Puddle", Box, Spacing, 1000, new Vector3(0.5f, 0.2f, 0.5f));

        FluidSimulation Tank() => Fluid("Tank", new Vector3(1f, 1.2f, 0.5f), Spacing, 2000, new Vector3(0.5f, 1f, 0.4f));

        // Sets a field like a scene file or the inspector.
        static void SetSerialized(FluidSimulation fluid, string field, object value)
        {
            typeof(FluidSimulation).GetField(field, BindingFlags.Instance | BindingFlags.NonPublic).SetValue(fluid, value);
        }

        static ParticleState State(FluidSimulation fluid) => TestFluid.Read(fluid.Solver);

        static IEnumerable<string> Buffers(FluidSimulation fluid)
        {
            return fluid.Solver.Describe(fluid.Input, fluid.StatisticsInterval).SelectMany(stage => stage.Buffers)
                .Select(buffer => buffer.name).ToArray();
        }
    }
}
