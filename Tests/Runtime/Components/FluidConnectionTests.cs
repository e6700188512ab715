using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;
using Rill.Testing;

namespace Rill.Tests
{
    /// <summary>Two fluids whose boxes overlap along x, and the water that flows between them.</summary>
    public class FluidConnectionTests : ConnectedFluidFixture
    {
        // Out of sight of all cameras it stands from this frame on, after or before the one beside it takes its steps. The copies of that one's
        // particles would stay among its own, be drawn twice, and be saved.
        [UnityTest]
        public IEnumerator A_fluid_that_comes_to_stand_holds_no_water_of_the_one_beside_it([Values] bool isLeft)
        {
            (FluidSimulation left, FluidSimulation right) = Pair(new Vector3(2f, 0.9f, 0.5f), new Vector3(2f, 0.5f, 0.5f), DeepWater.Off);
            Connect(left, right);
            yield return Frames(10);
            int all = Own(left).Length + Own(right).Length;
            FluidSimulation stands = isLeft ? left : right;
            stands.CullingMode = FluidCullingMode.Pause;
            for (int frame = 0; frame < 4; frame++)
            {
                yield return null;
                Assert.That((stands.IsCulled, stands.Solver.HasGhosts), Is.EqualTo((true, false)), $"frame {frame}");
                Assert.That(Own(left).Length + Own(right).Length, Is.EqualTo(all), $"particles of both in frame {frame}");
            }
        }

        // Its water is on its way to the new solver for some frames: what the one beside it took or gave meanwhile would be there twice, or lost.
        [UnityTest, Category("LongRun")]
        public IEnumerator A_fluid_that_gets_another_capacity_loses_and_doubles_no_water_that_crosses([Values] bool isLeft)
        {
            (FluidSimulation left, FluidSimulation right) = Pair(new Vector3(1.2f, 0.8f, 0.5f), Vector3.zero);
            Connect(left, right);
            const int All = 12 * 8 * 5;
            yield return Frames(45);
            FluidSimulation changes = isLeft ? left : right;
            int before = Own(right).Length, frames = 0;
            changes.Capacity = 3000;
            for (int frame = 0; frame < 40; frame++)
            {
                yield return null;
                frames += changes.Resolution.IsPending ? 1 : 0;
                Assert.That(Own(left).Length + Own(right).Length, Is.EqualTo(All), $"particles of both in frame {frame}");
            }
            Assert.That(changes.Capacity, Is.EqualTo(3000));
            Assert.That(frames, Is.GreaterThan(0), "it took some frames");
            Assert.That(Own(right).Length, Is.GreaterThan(before + 20), "water crossed");
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator Water_flows_into_an_empty_box_until_both_are_level_and_none_is_lost(
            [Values(DeepWater.Off, DeepWater.On)] DeepWater deepWater)
        {
            (FluidSimulation left, FluidSimulation right) = Pair(new Vector3(1.2f, 0.8f, 0.5f), Vector3.zero, deepWater);
            FluidConnection connection = Connect(left, right);
            int all = 12 * 8 * 5;
            for (int frame = 0; frame < 240; frame++)
            {
                yield return null;
                Assert.That(Own(left).Length + Own(right).Length, Is.EqualTo(all), $"particles of both in frame {frame}");
            }
            AsyncGPUReadback.WaitAllRequests();
            FluidAssert.NothingLost(left);
            FluidAssert.NothingLost(right);
            FluidStatistics onLeft = FluidAssert.Measure(left), onRight = FluidAssert.Measure(right);
            float levelLeft = Level(left, -1.4f, -0.2f), levelRight = Level(right, 0.2f, 1.4f);
            TestContext.Out.WriteLine($"{onLeft.particles} left, {onRight.particles} right, {connection.HandedToSecond} over, " +
                $"{connection.HandedToFirst} back; levels {levelLeft:0.000} and {levelRight:0.000} m, rms speed {onLeft.speed:0.000} and " +
                $"{onRight.speed:0.000} m/s, density error {onLeft.densityError:0.0000} and {onRight.densityError:0.0000}");
            Assert.That(onLeft.handedOut - onLeft.handedIn, Is.EqualTo(onRight.particles));
            Assert.That(levelLeft, Is.EqualTo(levelRight).Within(Spacing));
        }

        [UnityTest]
        public IEnumerator A_connected_fluid_does_not_sleep_and_one_let_go_does()
        {
            (FluidSimulation left, FluidSimulation right) = Pair(new Vector3(2f, 0.8f, 0.5f), new Vector3(2f, 0.8f, 0.5f), DeepWater.Off);
            SolverSettings settings = left.Settings;
            settings.sleepSpeed = 0.02f;
            left.Settings = settings;
            FluidConnection connection = Connect(left, right);
            yield return Frames(2);
            Assert.That(Sleeps(left), Is.False);
            connection.enabled = false;
            yield return Frames(2);
            Assert.That(Sleeps(left));
            Assert.That(Sleeps(right), Is.False, "which has no sleep speed");
        }

        // Each liquid has another number on the other side, and back it has another one than there.
        [UnityTest, Category("LongRun")]
        public IEnumerator A_liquid_keeps_its_material_in_a_fluid_that_numbers_its_phases_otherwise([Values] bool fromLeft)
        {
            FluidMaterialAsset oil = FluidMaterialAsset.Create("Oil", 900f), mercury = FluidMaterialAsset.Create("Mercury", 13500f),
                tar = FluidMaterialAsset.Create("Tar", 1100f);
            Vector3 water = new Vector3(1.2f, 0.8f, 0.5f);
            (FluidSimulation left, FluidSimulation right) = Pair(fromLeft ? water : Vector3.zero, fromLeft ? Vector3.zero : water, DeepWater.On,
                fluid => fluid.PhaseMaterials = fluid.name == "Left" ? new[] { oil, mercury, tar } : new[] { mercury, tar, oil });
            FluidSimulation from = fromLeft ? left : right, to = fromLeft ? right : left;
            from.GetComponentInChildren<FluidVolume>().Material = oil;
            from.Restart();
            Connect(left, right);
            yield return Frames(45);
            Assert.That((left.PhaseOf(oil), left.PhaseOf(mercury), left.PhaseOf(tar)), Is.EqualTo((1, 2, 3)));
            Assert.That((right.PhaseOf(oil), right.PhaseOf(mercury), right.PhaseOf(tar)), Is.EqualTo((3, 1, 2)));
            Assert.That(PhasesOf(from).Distinct(), Is.EqualTo(new[] { fromLeft ? 1u : 3u }));
            uint[] arrived = PhasesOf(to);
            Assert.That(arrived.Length, Is.GreaterThan(20), "oil crossed");
            Assert.That(arrived.Distinct(), Is.EqualTo(new[] { fromLeft ? 3u : 1u }), "and is oil there");
            Assert.That(left.Input.phases.Heaviest(left.Material), Is.EqualTo(right.Input.phases.Heaviest(right.Material)),
                "both weigh against the same");
            foreach (FluidMaterialAsset material in new[] { oil, mercury, tar })
                UnityEngine.Object.Destroy(material);
        }

        // Three bits a phase: those in which the two numbers differ.
        [Test]
        public void A_phase_without_a_material_keeps_its_number_unless_a_material_has_it_there()
        {
            FluidMaterialAsset oil = FluidMaterialAsset.Create("Oil", 900f), mercury = FluidMaterialAsset.Create("Mercury", 13500f);
            using (SourceScene one = new SourceScene(Vector3.one, 0.1f, 100), other = new SourceScene(Vector3.one, 0.1f, 100))
            {
                one.Fluid.PhaseMaterials = new[] { mercury, oil };
                other.Fluid.PhaseMaterials = new[] { oil, null, mercury };
                // 1 becomes 2, 2 without a material becomes 0, 3 becomes 1; 4 to 7 stay.
                Assert.That(one.Fluid.Phases.ChangesFrom(other.Fluid.Phases), Is.EqualTo(3u << 3 | 2u << 6 | 2u << 9));
                // 1 becomes 3, 2 becomes 1, 3 without a material becomes 0.
                Assert.That(other.Fluid.Phases.ChangesFrom(one.Fluid.Phases), Is.EqualTo(2u << 3 | 3u << 6 | 3u << 9));
            }
            UnityEngine.Object.DestroyImmediate(oil);
            UnityEngine.Object.DestroyImmediate(mercury);
        }

        [UnityTest]
        public IEnumerator A_connection_that_is_opened_again_counts_from_nothing()
        {
            (FluidSimulation left, FluidSimulation right) = Pair(new Vector3(1.2f, 0.8f, 0.5f), Vector3.zero);
            FluidConnection connection = Connect(left, right);
            yield return Frames(50);
            int first = connection.HandedToSecond;
            Assert.That(first, Is.GreaterThan(20));
            connection.enabled = false;
            Assert.That(connection.HandedToSecond, Is.Zero);
            yield return Frames(5);
            int before = Own(right).Length;
            connection.enabled = true;
            Assert.That(connection.HandedToSecond, Is.Zero);
            yield return Frames(12);
            Assert.That(connection.HandedToSecond - connection.HandedToFirst, Is.EqualTo(Own(right).Length - before).Within(30),
                "three frames late");
            Assert.That(connection.HandedToSecond, Is.LessThan(first));
        }

        // While they were apart each was filled where the other has water too.
        [UnityTest]
        public IEnumerator Fluids_that_are_connected_again_are_parted_again()
        {
            var water = new Vector3(Box.x, 0.3f, Box.z);
            (FluidSimulation left, FluidSimulation right) = Pair(water, water, DeepWater.Off, Weightless);
            FluidConnection connection = Connect(left, right);
            yield return Frames(2);
            int parted = Own(left).Length + Own(right).Length;
            Assert.That(parted, Is.EqualTo(32 * 3 * 5).Within(20), "both boxes together, 3.2 m long");
            connection.enabled = false;
            yield return null;
            Vector3 overlap = new Vector3(0f, -0.45f, 0f);
            left.Fill(FluidShape.Box(overlap, new Vector3(Overlap, 0.3f, 0.5f)));
            right.Fill(FluidShape.Box(overlap, new Vector3(Overlap, 0.3f, 0.5f)));
            yield return null;
            Assert.That(Own(left).Length + Own(right).Length, Is.GreaterThan(parted + 80), "it lies in both");
            connection.enabled = true;
            yield return Frames(2);
            Assert.That(Own(left).Length + Own(right).Length, Is.EqualTo(parted).Within(20));
        }

        // A particle near the border is in both fluids, in one of them as a copy that nothing is exchanged with.
        [UnityTest]
        public IEnumerator Materials_that_mix_across_a_connection_are_kept_to_the_particle()
        {
            FluidMaterialAsset dye = FluidMaterialAsset.Create("Dye", 1000f);
            (FluidSimulation left, FluidSimulation right) = Pair(new Vector3(2f, 0.8f, 0.5f), new Vector3(2f, 0.4f, 0.5f), DeepWater.Off, fluid =>
            {
                fluid.PhaseMaterials = new[] { dye };
                fluid.MaterialPairs = new[] { FluidMaterialPair.Mixing(null, dye, 0.05f) };
            });
            left.GetComponentInChildren<FluidVolume>().Material = dye;
            left.Restart();
            Connect(left, right);
            yield return Frames(2);
            int Count(uint phase) => PhasesOf(left).Concat(PhasesOf(right)).Count(own => own == phase);
            int dyed = Count(1), clear = Count(0);
            for (int frame = 0; frame < 30; frame++)
            {
                yield return null;
                Assert.That((Count(1), Count(0)), Is.EqualTo((dyed, clear)), $"frame {frame}");
            }
            Assert.That(PhasesOf(right).Count(phase => phase == 1), Is.GreaterThan(5), "dye crossed");
            UnityEngine.Object.Destroy(dye);
        }

        static uint[] PhasesOf(FluidSimulation fluid)
        {
            ParticleState state = TestFluid.Read(fluid.Solver);
            return GpuTest.Read<uint>(fluid.Solver.Tags, state.Count).Where((tag, i) => math.all(math.isfinite(state.positions[i].xyz)))
                .Select(tag => tag >> ParticleTags.PhaseShift).ToArray();
        }

        static bool Sleeps(FluidSimulation fluid) => fluid.Results.Describe().Single(stage => stage.Name == "Resting regions").IsUsed;

        [UnityTest, Category("LongRun")]
        public IEnumerator Water_at_rest_in_both_boxes_stays_level_and_calm(
            [Values(DeepWater.Off, DeepWater.On)] DeepWater deepWater)
        {
            (FluidSimulation left, FluidSimulation right) = Pair(new Vector3(2f, 0.8f, 0.5f), new Vector3(2f, 0.8f, 0.5f), deepWater);
            Connect(left, right);
            yield return Frames(1);
            int all = Own(left).Length + Own(right).Length;
            Assert.That(all, Is.EqualTo(32 * 8 * 5), "what both were filled with is there once");
            yield return Frames(120);
            var beside = new SpeedMean(0f, 0.4f);
            var far = new SpeedMean(1f, 1.6f);
            for (int frame = 0; frame < 60; frame += 6)
            {
                yield return Frames(6);
                beside.Add(left, right);
                far.Add(left, right);
            }
            FluidStatistics onLeft = FluidAssert.Measure(left), onRight = FluidAssert.Measure(right);
            float levelLeft = Level(left, -1.4f, -0.2f), levelRight = Level(right, 0.2f, 1.4f), between = Level(left, -0.2f, 0f);
            TestContext.Out.WriteLine($"{onLeft.particles} left, {onRight.particles} right; levels {levelLeft:0.000}, {between:0.000} and " +
                $"{levelRight:0.000} m, rms speed {beside.Rms:0.000} m/s up to 0.4 m from the opening and {far.Rms:0.000} beyond 1 m, density " +
                $"error {onLeft.densityError:0.0000} and {onRight.densityError:0.0000}");
            Assert.That(onLeft.particles + onRight.particles, Is.EqualTo(all));
            Assert.That(levelLeft, Is.EqualTo(levelRight).Within(0.5f * Spacing));
            Assert.That(beside.Rms, Is.LessThan(deepWater == DeepWater.On ? 0.16f : 0.22f), "m/s beside the opening");
        }

        // It is a displacement within a substep. Twenty times what still water has: what is held to it at the end is close to it.
        [UnityTest]
        public IEnumerator What_the_neighbors_grid_found_counts_by_the_square_of_both_substeps([Values(1, 3)] int substepsOfLeft)
        {
            (FluidSimulation left, FluidSimulation right) = Pair(new Vector3(2f, 0.8f, 0.5f), new Vector3(2f, 0.8f, 0.5f), DeepWater.On, fluid =>
            {
                if (fluid.name == "Left")
                    fluid.Substeps = substepsOfLeft;
            });
            Connect(left, right);
            yield return Frames(3);
            const float Found = 2f;        // d²
            CoarseCorrection here = left.Solver.Coarse, there = right.Solver.Coarse;
            there.Cells.flowPotential.SetData(Enumerable.Repeat(Found, there.Grid.Total).ToArray());
            yield return null;
            float[] potential = GpuTest.Read<float>(here.Cells.flowPotential, here.Grid.Total);
            float expected = Found / (substepsOfLeft * substepsOfLeft);
            for (int z = 0; z < here.Grid.Counts.z; z++)
            {
                float atEnd = potential[(z * here.Grid.Counts.y + 1) * here.Grid.Counts.x - 1];
                Assert.That(atEnd, Is.EqualTo(expected).Within(0.1f * expected), "d², on the floor at the end of the left box");
            }
        }

        [UnityTest]
        public IEnumerator A_particle_crosses_with_its_place_velocity_and_phase_and_gets_a_new_id()
        {
            (FluidSimulation left, FluidSimulation right) = Pair(Vector3.zero, Vector3.zero, setUp: Weightless);
            FluidConnection connection = Connect(left, right);
            yield return null;
            float3 from = new float3(-0.3f, 0.2f, 0.1f), velocity = new float3(1.2f, -0.3f, 0.15f);
            Add(right, new float3(1.5f, -0.2f, 0f), float3.zero);
            using (var positions = new NativeArray<float3>(new[] { from }, Allocator.Persistent))
            using (var velocities = new NativeArray<float3>(new[] { velocity }, Allocator.Persistent))
                left.AddParticles(positions, velocities, 3);
            for (int frame = 1; frame <= 40; frame++)
            {
                yield return null;
                Vector3[] there = Own(left).Concat(Own(right).Where(p => p.x < 1.2f)).ToArray();
                Assert.That(there.Length, Is.EqualTo(1), $"frame {frame}");
                Assert.That(Vector3.Distance(there[0], from + velocity * (frame / 60f)), Is.LessThan(0.01f * Spacing), $"frame {frame}");
            }
            Assert.That(Own(left), Is.Empty);
            ParticleState state = TestFluid.Read(right.Solver);
            int i = Array.FindIndex(state.positions, p => p.x * Spacing < 1.4f);
            Assert.That(math.distance(state.velocities[i].xyz * Spacing, velocity), Is.LessThan(1e-3f));
            Assert.That(state.ids, Is.EquivalentTo(new[] { 0u, 1u }));
            Assert.That(GpuTest.Read<uint>(right.Solver.Tags, 2)[i] >> ParticleTags.PhaseShift, Is.EqualTo(3u));
            AsyncGPUReadback.WaitAllRequests();
            yield return Frames(2);
            AsyncGPUReadback.WaitAllRequests();
            Assert.That((connection.HandedToSecond, connection.HandedToFirst, connection.WaitingForSecond), Is.EqualTo((1, 0, 0)));
            right.Restart();
            Assert.That(connection.HandedToSecond, Is.Zero, "it begins again");
            yield return Frames(3);
            AsyncGPUReadback.WaitAllRequests();
            Assert.That(connection.HandedToSecond, Is.Zero, "nor later");
        }

        [UnityTest]
        public IEnumerator What_a_full_fluid_cannot_take_waits_before_it_and_is_told()
        {
            FluidSimulation left = null, right = null;
            (left, right) = Pair(new Vector3(1.6f, 0.8f, 0.5f), Vector3.zero, setUp: fluid =>
            {
                if (fluid.transform.position.x > 0f)
                    fluid.Configure(Box, Spacing, 60);
            });
            FluidConnection connection = Connect(left, right);
            LogAssert.Expect(LogType.Warning, new Regex("^Rill: FluidConnection 'Opening': [0-9]+ particles wait to flow into 'Right', whose " +
                "capacity of 60 is full. Raise its capacity"));
            for (int frame = 0; frame < 90; frame++)
            {
                yield return null;
                Assert.That(Own(left).Length + Own(right).Length, Is.EqualTo(16 * 8 * 5), $"particles of both in frame {frame}");
            }
            AsyncGPUReadback.WaitAllRequests();
            yield return null;
            Assert.That(connection.WaitingForSecond, Is.GreaterThan(0));
            Assert.That(Own(right).Length, Is.EqualTo(60));
            Assert.That(FluidAssert.Measure(left).escaped, Is.Zero);
            var problems = new List<string>();
            ((IHasProblems)connection).ListProblems(problems);
            Assert.That(problems, Has.Exactly(1).Contains("capacity of 60 is full"));
            LogAssert.NoUnexpectedReceived();
        }

        [UnityTest]
        public IEnumerator A_drain_where_the_boxes_overlap_takes_no_ghosts()
        {
            (FluidSimulation left, FluidSimulation right) = Pair(new Vector3(2f, 0.6f, 0.5f), Vector3.zero);
            Connect(left, right);
            var hole = new GameObject("Hole");
            made.Add(hole);
            hole.SetActive(false);
            hole.transform.position = new Vector3(-0.2f, -0.4f, 0f);      // where the water of the other is
            var drain = hole.AddComponent<FluidDrain>();
            drain.Simulation = right;
            drain.Size = new Vector3(0.3f, 0.4f, 0.5f);
            hole.SetActive(true);
            yield return Frames(1);
            int all = Own(left).Length + Own(right).Length;
            yield return Frames(3);
            FluidStatistics onLeft = FluidAssert.Measure(left), onRight = FluidAssert.Measure(right);
            Assert.That(onLeft.drained + onRight.drained + onLeft.particles + onRight.particles, Is.EqualTo(all));
            FluidAssert.NothingLost(left);
            FluidAssert.NothingLost(right);
        }

        [UnityTest]
        public IEnumerator Each_surface_ends_where_the_other_fluids_begins()
        {
            (FluidSimulation left, FluidSimulation right) = Pair(new Vector3(2f, 0.6f, 0.5f), new Vector3(2f, 0.6f, 0.5f));
            Connect(left, right);
            left.Results.Surface.Requesting += () => left.Results.Surface.IsNeeded = true;
            yield return Frames(3);
            SurfaceParticles surface = left.Solver.Surface;
            int drawn = (int)GpuTest.Read<uint>(surface.Counters, surface.Counters.count)[(int)SurfaceParticles.Counter.Drawn];
            float[] alongX = GpuTest.Read<SurfaceParticles.Element>(surface.Particles, drawn).Select(e => math.asfloat(e.a.x)).ToArray();
            float center = (Box.x - 0.5f * Overlap) / Spacing;
            Assert.That(alongX.Where(x => x > 0f).Max(), Is.InRange(center - 1.5f, center + 1.5f));
            Assert.That(alongX.Count(x => x < 0f), Is.GreaterThan(20), "out of sight: what stands for the other fluid's water");
        }

        [UnityTest]
        public IEnumerator The_same_scene_flows_the_same_to_the_bit()
        {
            var ends = new List<ParticleState>();
            for (int run = 0; run < 2; run++)
            {
                (FluidSimulation left, FluidSimulation right) = Pair(new Vector3(1.6f, 0.8f, 0.5f), Vector3.zero);
                Connect(left, right);
                yield return Frames(40);
                ends.Add(TestFluid.Read(right.Solver));
                ends.Add(TestFluid.Read(left.Solver));
                left.gameObject.SetActive(false);
                right.gameObject.SetActive(false);
            }
            Assert.That(ends[0].Count, Is.GreaterThan(20));
            TestFluid.AssertSame(ends[2], ends[0]);
            TestFluid.AssertSame(ends[3], ends[1]);
        }

        [UnityTest]
        public IEnumerator What_keeps_two_fluids_apart_is_said_once_with_what_to_do([Values(0, 1, 2, 3, 4, 5)] int fault)
        {
            string[] expected = { "particle spacing of 0.1 m and 'Right' one of 0.05 m", "different materials", "120. Make their Step Rates equal",
                "turned differently", "overlap by 0.2 m along x, less than 4 spacings of 0.1 m. Let them overlap by 0.8 m",
                "have no end in each other" };
            (FluidSimulation left, FluidSimulation right) = Pair(new Vector3(1.6f, 0.4f, 0.5f), Vector3.zero);
            if (fault == 0)
                right.ParticleSpacing = 0.05f;
            else if (fault == 1)
                right.Material = new FluidMaterial
                {
                    density = 900f, velocitySmoothing = right.Material.velocitySmoothing,
                    artificialPressureDistance = 0.2f, relaxationTime = right.Material.relaxationTime,
                    contactAngle = right.Material.contactAngle
                };
            else if (fault == 2)
                right.StepRate = 120f;
            else if (fault == 3)
                right.transform.rotation = Quaternion.Euler(0f, 20f, 0f);
            else if (fault == 4)
                right.transform.position += new Vector3(0.6f, 0f, 0f);
            else
                right.transform.position = left.transform.position;
            FluidConnection connection = Connect(left, right);
            LogAssert.Expect(LogType.Warning, new Regex("^Rill: FluidConnection 'Opening': .*" + Regex.Escape(expected[fault])));
            yield return Frames(5);
            Assert.That(connection.IsOpen, Is.False);
            Assert.That(Own(right), Is.Empty);
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void A_connection_without_two_fluids_says_so()
        {
            (FluidSimulation left, _) = Pair(Vector3.zero, Vector3.zero);
            LogAssert.Expect(LogType.Warning, new Regex("has no two fluids. Set First and Second"));
            FluidConnection connection = Connect(left, null);
            LogAssert.Expect(LogType.Warning, new Regex("both ends are 'Left'"));
            connection.Second = left;
            LogAssert.NoUnexpectedReceived();
        }
    }
}
