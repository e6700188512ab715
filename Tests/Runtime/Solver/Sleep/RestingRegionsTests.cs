using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>Water that has come to rest sleeps until something nearby moves.</summary>
    public class RestingRegionsTests
    {
        const float Spacing = 0.05f, SleepSpeed = 0.02f, TimeStep = 1f / 60f;
        const float JitterRatio = 25f;      // of one particle's speed over that of a region
        const uint Asleep = (uint)RegionState.Asleep, AtEdge = (uint)RegionState.AsleepAtEdge, Awake = (uint)RegionState.Awake;
        const float SleepDisplacement = SleepSpeed * TimeStep / Spacing;      // d

        static readonly int StepsToSleep = (int)math.ceil(0.5f / TimeStep);

        // By the mean displacement of a region or by one fast particle; in boxes of whole and of cut regions.
        [TestCase(40, 48, 40, 62, 1.5f, 1)]
        [TestCase(40, 48, 40, 0, 1.5f, 1)]
        [TestCase(60, 20, 9, 7, 1.5f, 1)]
        [TestCase(60, 20, 9, 47, 0.7f, 2)]
        public void What_moves_keeps_the_regions_around_it_awake_and_those_beyond_at_hand(int x, int y, int z, int mover,
            float meanDisplacement, int fastParticles)
        {
            int3 counts = (new int3(x, y, z) + 7) / 8;
            int total = counts.x * counts.y * counts.z;
            ParticleState state = Jittering(new float3(x, y, z), counts, 20);
            float4 along = 0f;
            along[mover % 3] = meanDisplacement * SleepDisplacement / TimeStep;      // each axis is one's
            for (int i = mover * 20; i < mover * 20 + 20; i++)
                state.velocities[i] += along;
            bool moves = meanDisplacement > 1f;
            using (var stage = new Stage(state))
            {
                Assert.That(stage.Run(1), Is.All.EqualTo(Awake), "it begins awake");
                uint[] before = stage.Run(StepsToSleep - 1);
                uint[] expected = Enumerable.Range(0, total).Select(region => moves ? Around(region, mover, counts) : Asleep).ToArray();
                Assert.That(before, Is.All.EqualTo(Awake), "one step short");
                Assert.That(stage.Run(1), Is.EqualTo(expected));
                if (moves)
                    return;

                for (int i = mover * 20 + 20 - fastParticles; i < mover * 20 + 20; i++)      // the last of their region
                    state.velocities[i] = new float4(
                        (i % 2 == 0 ? 1.2f : -1.2f) * JitterRatio * SleepDisplacement / TimeStep, 0f, 0f, 0f);
                stage.Set(state);
                Assert.That(stage.Run(1), Is.EqualTo(Enumerable.Range(0, total).Select(region => Around(region, mover, counts)).ToArray()),
                    "fast particles whose velocities cancel");
            }
        }

        [TestCase(1)]
        [TestCase(3)]
        public void Half_a_second_at_rest_is_as_long_in_substeps(int substeps)
        {
            using (var stage = new Stage(Jittering(new float3(40, 48, 40), new int3(5, 6, 5), 20), substeps))
            {
                Assert.That(stage.Run(30 * substeps - 1), Is.All.EqualTo(Awake));
                Assert.That(stage.Run(4), Is.All.EqualTo(Asleep));
            }
        }

        // Ten floats, as snapshots have it from before there was a tension.
        [Test]
        public void A_material_without_tension_has_the_checksum_that_it_had_before_there_was_any()
        {
            FluidMaterial water = FluidMaterial.Water, tense = water;
            var floats = new[] { water.density, water.velocitySmoothing, water.dynamicViscosity, water.wallFriction, water.vorticity,
                water.artificialPressure, water.artificialPressureDistance, water.allowedTension, water.shearModulus, water.relaxationTime };
            Assert.That(RestingRegions.Checksum(water), Is.EqualTo(Crc32C.Of(floats.SelectMany(System.BitConverter.GetBytes).ToArray())));
            tense.surfaceTension = 0.1f;
            uint checksum = RestingRegions.Checksum(tense);
            Assert.That(checksum, Is.Not.EqualTo(RestingRegions.Checksum(water)));
            tense.contactAngle = 120f;
            Assert.That(RestingRegions.Checksum(tense), Is.Not.EqualTo(checksum));
            Assert.That(RestingRegions.Checksum(tense), Is.EqualTo(Crc32C.Of(floats.Append(0.1f).Append(120f).SelectMany(System.BitConverter.GetBytes)
                .ToArray())), "as before there was friction");
            tense.frictionAngle = 30f;
            checksum = RestingRegions.Checksum(tense);
            tense.cohesion = 100f;
            Assert.That(RestingRegions.Checksum(tense), Is.Not.EqualTo(checksum));
            Assert.That(RestingRegions.Checksum(tense), Is.EqualTo(Crc32C.Of(floats.Concat(new[] { 0.1f, 120f, 30f, 100f })
                .SelectMany(System.BitConverter.GetBytes).ToArray())), "as before there were contacts");
            checksum = RestingRegions.Checksum(water);
            water.contacts = true;
            Assert.That(RestingRegions.Checksum(water), Is.Not.EqualTo(checksum));
        }

        [Test, Category("LongRun")]
        public void A_pool_at_rest_falls_asleep_stays_as_it_is_and_measures_as_the_one_awake()
        {
            using (TestFluid sleeping = Pool(SleepSpeed), awake = Pool(0f))
            {
                int steps = FallAsleep(sleeping);
                ParticleState before = sleeping.Read();
                Assert.That(before.velocities.Select(v => v.xyz), Is.All.EqualTo(float3.zero));
                TestFluid.AssertSame(sleeping.Step(30).Read(), before);

                FluidStatistics rested = sleeping.MeasureWhole(), moved = awake.Step(steps + 30).MeasureWhole();
                TestContext.Out.WriteLine($"asleep after {steps} steps; C+ {100f * rested.densityError:0.000} % asleep, " +
                    $"{100f * moved.densityError:0.000} % awake; volume {rested.volumeRatio:0.0000}, {moved.volumeRatio:0.0000}; noise " +
                    $"awake {moved.speed:0.000} m/s");
                Assert.That(moved.speed, Is.GreaterThan(0f));
                Assert.That(rested.densityError, Is.EqualTo(moved.densityError).Within(0.005f));
                Assert.That(rested.volumeRatio, Is.EqualTo(moved.volumeRatio).Within(0.01f));
            }
        }

        [Test, Category("LongRun")]
        public void What_falls_into_it_wakes_what_it_hits_and_brings_no_energy()
        {
            using (TestFluid fluid = Pool(SleepSpeed))
            {
                FallAsleep(fluid);
                fluid.AddBlock(new float3(1f, 74f, 2f) * Spacing, 4f * Spacing);
                float last = fluid.Measure().Energy, first = last;
                var underIt = new List<uint>();
                var asleep = new List<float>();
                for (int part = 0; part < 16; part++)
                {
                    float energy = fluid.Step(5).Measure().Energy;
                    Assert.That(energy, Is.LessThan(last + 0.005f * first), $"after {5 * part + 5} steps");
                    last = energy;
                    uint[] states = States(fluid);
                    underIt.Add(states[0]);
                    asleep.Add(states.Count(s => s != Awake) / (float)states.Length);
                }
                TestContext.Out.WriteLine("asleep " + string.Join(" ", asleep.Select(fraction => fraction.ToString("0.00"))) + "; under it "
                    + string.Join(" ", underIt));
                fluid.MeasureWhole();
                int slept = underIt.FindIndex(state => state != Awake);
                Assert.That(slept, Is.GreaterThan(0), "the pool slept while the block fell");
                Assert.That(underIt.Skip(slept), Has.Some.EqualTo(Awake), "and was woken");
            }
        }

        [Test]
        public void Other_gravity_wakes_it_and_it_flows()
        {
            using (TestFluid fluid = Pool(SleepSpeed))
            {
                FallAsleep(fluid);
                fluid.Input.gravity = new float3(3f, -9.4f, 0f);
                Assert.That(States(fluid.Step()), Is.All.EqualTo(Awake));
                float3 speed = fluid.Step(10).MeasureWhole().momentum;
                float free = fluid.Alive * 1000f * Spacing * Spacing * Spacing * 3f * 11f / 60f;        // without walls, N s
                Assert.That(speed.x, Is.InRange(0.5f * free, free));
                Assert.That(States(fluid), Is.All.EqualTo(Awake));
            }
        }

        // By less than a hundredth with each step.
        [Test]
        public void Gravity_that_turns_slowly_wakes_it_once_it_is_a_hundredth_off()
        {
            using (var stage = new Stage(Jittering(new float3(40, 48, 40), new int3(5, 6, 5), 20)))
            {
                StepInput input = stage.Input;
                for (int turns = 0; turns < 2; turns++)
                {
                    input.gravity = new float3(0.03f * 9.81f * turns, -9.81f, 0f);
                    stage.Input = input;
                    stage.Run(StepsToSleep + 1);
                    for (int step = 1; step <= 3; step++)
                    {
                        input.gravity.x += 0.004f * 9.81f;
                        stage.Input = input;
                        Assert.That(stage.Run(1), Is.All.EqualTo(step < 3 ? Asleep : Awake), $"turned {step} times");
                    }
                }
            }
        }

        // A field that is added to one of the structs is a case of its own.
        [Test]
        public void Every_field_of_the_input_that_rest_depends_on_wakes_it([ValueSource(nameof(FieldsOfTheInput))] string path)
        {
            using (var stage = new Stage(Jittering(new float3(40, 48, 40), new int3(5, 6, 5), 20)))
            {
                stage.Run(StepsToSleep + 1);
                Assert.That(stage.Run(1), Is.All.EqualTo(Asleep), "before");
                stage.Input = (StepInput)Changed(stage.Input, path.Split('.'));
                Assert.That(stage.Run(1), Is.All.EqualTo(Awake));
            }
        }

        [Test]
        public void A_gel_asleep_wakes_when_its_density_changes()
        {
            using (TestFluid fluid = Pool(SleepSpeed))
            {
                fluid.Input.material.shearModulus = 50f;
                FallAsleep(fluid);
                fluid.Input.material.density *= 0.5f;
                Assert.That(States(fluid.Step()), Is.All.EqualTo(Awake));
            }
        }

        [Test]
        public void Borders_that_come_change_or_go_wake_the_water()
        {
            using (TestFluid fluid = Pool(SleepSpeed))
            {
                var borders = new[] { (BorderKind.Absorbing, 0.2f), (BorderKind.Absorbing, 0.3f), (BorderKind.Wall, 0.3f) };
                foreach ((BorderKind kind, float width) in borders)
                {
                    FallAsleep(fluid);
                    fluid.Input.borders.minX = new FluidBorder { kind = kind, width = width };
                    Assert.That(States(fluid.Step()), Is.All.EqualTo(Awake), $"{kind} {width} m");
                }
            }
        }

        [Test]
        public void Sleep_comes_and_goes_beside_a_collider()
        {
            using (TestFluid fluid = Pool(SleepSpeed))
            {
                ColliderTests.Use(fluid, ColliderTests.Still(ColliderShape.Sphere, 3f, new float3(24f, 20f, 4f), quaternion.identity));
                fluid.Step();
                fluid.Input.settings.sleepSpeed = 0f;
                fluid.Step();
                fluid.Input.settings.sleepSpeed = SleepSpeed;
                fluid.Step();
                Assert.That(States(fluid), Is.All.EqualTo(Awake));
            }
        }

        // The set's version says that a collider came, went or changed: one that sets out is none of that.
        [Test]
        public void A_collider_that_sets_out_wakes_what_slept_beside_it()
        {
            using (TestFluid fluid = Pool(SleepSpeed))
            {
                ColliderTests.Use(fluid, ColliderTests.Still(ColliderShape.Sphere, 3f, new float3(24f, 20f, 4f), quaternion.identity));
                FallAsleep(fluid);
                Assert.That(States(fluid.Step()), Is.All.EqualTo(Asleep), "beside one that stands");
                fluid.Input.colliders.Items[0].end.position.y -= 0.01f;
                Assert.That(States(fluid.Step()), Is.All.EqualTo(Awake));
            }
        }

        // The low end is cut off, and the high end has lost its wall.
        [Test]
        public void A_box_that_moves_off_its_water_wakes_all_of_it()
        {
            using (TestFluid fluid = Pool(SleepSpeed))
            {
                FallAsleep(fluid);
                fluid.Solver.Shift(new float3(-6f, 0f, 0f));
                Assert.That(States(fluid.Step()), Is.All.EqualTo(Awake));
                Assert.That(fluid.Step(20).Read().positions.Max(p => p.x), Is.GreaterThan(44f), "d: it ended at 42");
            }
        }

        [Test]
        public void What_is_added_wakes_it_and_clearing_forgets_what_slept()
        {
            using (TestFluid fluid = Pool(SleepSpeed))
            {
                FallAsleep(fluid);
                fluid.Add(new[] { new float3(1f, 1f, 0.2f) });
                Assert.That(States(fluid.Step()), Is.All.EqualTo(Awake));
                fluid.Step(60);
                fluid.Solver.Clear();
                fluid.Add(new[] { new float3(1f, 1f, 0.2f) }).Step(10);
                Assert.That(fluid.Read().velocities[0].y * Spacing, Is.EqualTo(-9.81f * 10f * TimeStep).Within(1e-3f));
            }
        }

        [Test]
        public void A_deep_column_sleeps_at_its_height()
        {
            SolverSettings settings = Sleeping(SleepSpeed);
            settings.deepWater = DeepWater.On;
            settings.iterations = 2;
            using (var fluid = new TestFluid(new float3(8f, 28f, 8f) * Spacing, Spacing, 8 * 20 * 8, settings)
                .AddBlock(0f, new float3(8f, 20f, 8f) * Spacing))
            {
                FluidStatistics statistics = fluid.Step(120).MeasureWhole();
                uint[] states = States(fluid);
                TestContext.Out.WriteLine(
                    $"states {string.Join(" ", states)}; C+ {100f * statistics.densityError:0.000} %, volume {statistics.volumeRatio:0.000}");
                Assert.That(states, Is.All.EqualTo(Asleep));
                Assert.That(statistics.densityError, Is.LessThan(0.01f));
                Assert.That(statistics.volumeRatio, Is.InRange(0.97f, 1.03f));
            }
        }

        [TestCase(DeepWater.Off)]
        [TestCase(DeepWater.On)]
        public void While_nothing_sleeps_every_bit_is_as_without(DeepWater deepWater)
        {
            using (TestFluid with = Dam(SleepSpeed), without = Dam(0f))
            {
                TestFluid.AssertSame(with.Step(20).Read(), without.Step(20).Read());
                Assert.That(States(with), Has.Some.EqualTo(Awake));
                Assert.That(without.Solver.Resting, Is.Null);
            }

            TestFluid Dam(float sleepSpeed)
            {
                SolverSettings settings = Sleeping(sleepSpeed);
                settings.deepWater = deepWater;
                return new TestFluid(new float3(1f, 0.6f, 0.4f), Spacing, 512, settings).AddBlock(0f, 0.4f);
            }
        }

        // Inputs that do not change how particles at rest move: readers of them, and what wakes regions by itself.
        // those that are removed wake what is around them, and a connected fluid does not sleep
        static readonly string[] Others = { "needsDensity", "colliders", "frameFrom", "frameTo", "sources", "foam", "foamSeed", "hasSmoke", "smoke",
            "removesKilled", "tracksPhases", "connections", "takesParticles", "borders" };

        static IEnumerable<string> FieldsOfTheInput() => typeof(StepInput).GetFields().Where(field => !Others.Contains(field.Name))
            .SelectMany(field => field.FieldType == typeof(SolverSettings) || field.FieldType == typeof(FluidMaterial)
                ? field.FieldType.GetFields(BindingFlags.Public | BindingFlags.Instance).Select(part => field.Name + "." + part.Name)
                    : new[] { field.Name });

        static object Changed(object value, IEnumerable<string> path)
        {
            if (path.Any())
            {
                FieldInfo field = value.GetType().GetField(path.First());
                field.SetValue(value, Changed(field.GetValue(value), path.Skip(1)));
                return value;
            }
            switch (value)
            {
                case float number: return number + 0.5f;
                case int number: return number + 1;
                case bool on: return !on;
                case float3 vector: return vector + new float3(0f, 1f, 0f);
                case DeepWater mode: return mode == DeepWater.On ? DeepWater.Off : DeepWater.On;
                case PhaseMaterials phases:
                    phases.Set(1, 500f, 0f);
                    return phases;
                default: throw new System.NotSupportedException($"a change of a {value.GetType()}");
            }
        }

        // Regions numbered x first: awake within one of the mover, at the edge within two.
        static uint Around(int region, int mover, int3 counts)
        {
            int3 Coordinates(int r) => new int3(r % counts.x, r / counts.x % counts.y, r / (counts.x * counts.y));
            int away = math.cmax(math.abs(Coordinates(region) - Coordinates(mover)));
            return away <= 1 ? Awake : away == 2 ? AtEdge : Asleep;
        }

        // So many particles in each region, region by region, whose velocities are large and cancel in the mean.
        static ParticleState Jittering(float3 box, int3 counts, int each)
        {
            var random = new Unity.Mathematics.Random(99u);
            var positions = new List<float3>();
            for (int i = 0; i < counts.x * counts.y * counts.z; i++)
            {
                float3 low = 8f * new float3(i % counts.x, i / counts.x % counts.y, i / (counts.x * counts.y));
                for (int k = 0; k < each; k++)
                    positions.Add(random.NextFloat3(low, math.min(low + 8f, box)));
            }
            var state = new ParticleState(box, positions.ToArray());
            for (int i = 0; i < state.Count; i += 2)
            {
                float3 velocity = random.NextFloat3Direction() * (0.5f * JitterRatio * SleepDisplacement / TimeStep);
                state.velocities[i] = new float4(velocity, 1f);
                state.velocities[i + 1] = new float4(-velocity, 1f);
            }
            return state;
        }

        // 48 x 4 x 8 particles on the floor of a tall box that they fill.
        static TestFluid Pool(float sleepSpeed)
        {
            return new TestFluid(new float3(48f, 80f, 8f) * Spacing, Spacing, 2000, Sleeping(sleepSpeed))
                .AddBlock(0f, new float3(48f, 4f, 8f) * Spacing);
        }

        // The steps that it took.
        static int FallAsleep(TestFluid fluid)
        {
            for (int steps = 10; steps <= 240; steps += 10)
                if (States(fluid.Step(10)).All(state => state == Asleep))
                    return steps;
            Assert.Fail("after 240 steps still awake: " + string.Join(" ", States(fluid)));
            return 0;
        }

        static SolverSettings Sleeping(float speed)
        {
            SolverSettings settings = SolverSettings.Default;
            settings.sleepSpeed = speed;
            return settings;
        }

        static uint[] States(TestFluid fluid) => GpuTest.Read<uint>(fluid.Solver.Resting.States, fluid.Solver.Resting.States.count);

        /// <summary>The stage alone over particles that stay.</summary>
        sealed class Stage : System.IDisposable
        {
            readonly RestingRegions regions;
            readonly ParticleBuffers particles;
            readonly SolverLayout layout;
            readonly GraphicsBuffer constants;
            StepInput input;

            public Stage(ParticleState state, int substeps = 1)
            {
                input = SolverStages.Still(Sleeping(SleepSpeed), FluidMaterial.Water);
                input.settings.substeps = substeps;
                layout = new SolverLayout(state.box * Spacing, Spacing, state.Count, 16, 1f);
                particles = new ParticleBuffers(state.Count);
                constants = GpuTest.UploadConstants(SolverConstants.For(layout, input, 1));
                regions = new RestingRegions(layout);
                Set(state);
            }

            public void Set(ParticleState state) => state.WriteTo(particles);

            /// <summary>Input of the next steps.</summary>
            public StepInput Input { get => input; set => input = value; }

            public uint[] Run(int steps)
            {
                for (int i = 0; i < steps; i++)
                    GpuTest.Run(cmd => regions.Record(new StepContext(cmd, constants, particles, null, null, layout, input)));
                return GpuTest.Read<uint>(regions.States, regions.States.count);
            }

            public void Dispose()
            {
                regions.Dispose();
                particles.Dispose();
                constants.Release();
            }
        }
    }
}
