using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Rill.Tests.Reference;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>Whole fluids with a shear modulus: they spring back, swing at their own frequency, and nothing that is asked of them blows
    /// them up.</summary>
    [Category("LongRun")]
    public class ElasticFluidTests
    {
        const float Spacing = 0.05f, TimeStep = 1f / 60f;
        const float Stretch = 1.5f;

        // A ball is drawn out to one and a half times its length and let go: within a quarter of a swing the return is as the modulus.
        [Test]
        public void A_stretched_ball_springs_back_by_its_modulus_and_one_without_stays()
        {
            float none = Recovered(0f), soft = Recovered(5f), firm = Recovered(50f), stiff = Recovered(500f);
            TestContext.Out.WriteLine(
                $"recovered after 0.25 s: {none:0.0000} without, {soft:0.0000} with 5 Pa, {firm:0.000} with 50 Pa, {stiff:0.00} with 500 Pa");
            Assert.That(none, Is.EqualTo(0f).Within(1e-4f));
            Assert.That(firm / soft, Is.InRange(7f, 11f), "short of a swing the displacement is proportional to the modulus");
            Assert.That(stiff, Is.GreaterThan(0.6f));
        }

        [Test]
        public void What_springs_back_is_the_stretch_and_not_the_shape()
        {
            float never = Recovered(500f, stretched: false), forgotten = Recovered(500f, relaxationTime: 0.02f), kept = Recovered(500f);
            TestContext.Out.WriteLine($"recovered after 0.25 s: {never:0.000} of what was always as long, {forgotten:0.000} of what " +
                $"forgets in 0.02 s, {kept:0.00} of what remembers");
            Assert.That(never, Is.EqualTo(0f).Within(0.01f));
            Assert.That(forgotten, Is.LessThan(0.5f * kept));
        }

        // Free torsion of a cylinder about its axis moves no volume: standing waves at half the length, f = √(G/ρ) / (2 L).
        [Test]
        public void A_twisted_cylinder_swings_at_the_speed_of_shear_waves()
        {
            const int Length = 14;
            const float Radius = 7f, Modulus = 400f;
            using (var fluid = Free(Modulus))
            {
                float3 center = 20f;
                float3[] positions = Points(p => math.length(p.xy) < Radius && math.abs(p.z) < 0.5f * Length)
                    .Select(p => (center + p) * Spacing).ToArray();
                fluid.Add(positions, p => 0.5f * Along(p) * math.cross(new float3(0f, 0f, 1f), p - center * Spacing));
                var crossings = new List<double>();
                double last = 0.0;
                for (int step = 1; crossings.Count < 3 && step < 240; step++)
                {
                    ParticleState state = fluid.Step().Read();
                    double spin = Enumerable.Range(0, state.Count)
                        .Sum(i => Along(state.positions[i].xyz * Spacing) * math.cross(state.positions[i].xyz - center,
                        state.velocities[i].xyz).z);
                    if (step > 1 && spin * last < 0.0)
                        crossings.Add((step - spin / (spin - last)) * TimeStep);
                    last = spin;
                }
                double frequency = 1.0 / (crossings[2] - crossings[0]), expected = Math.Sqrt(Modulus / 1000.0) / (2.0 * Length * Spacing);
                TestContext.Out.WriteLine($"{positions.Length} particles swing at {frequency:0.0000} Hz, " +
                    $"{100.0 * (frequency / expected - 1.0):0.0} % off √(G/ρ) / 2L = {expected:0.0000} Hz");
                Assert.That(frequency, Is.EqualTo(expected).Within(0.1 * expected),
                    "a gradient at the surface is that half a neighborhood further in, so it swings slower");

                float Along(float3 p) => (float)Math.Cos(Math.PI * (p.z / Spacing - center.z + 0.5f * Length) / Length);
            }
        }

        [Test]
        public void A_swing_dies_down([Values(500f, 1e6f)] float modulus)
        {
            using (var fluid = Ball(modulus, 1000f, true))
            {
                float swings = fluid.Step(15).Measure().speed, later = fluid.Step(105).MeasureWhole().speed;
                TestContext.Out.WriteLine($"rms speed {swings:0.000} m/s after 0.25 s, {later:0.000} m/s after 2 s");
                Assert.That(swings, Is.GreaterThan(0.1f));
                Assert.That(later, Is.LessThan(0.5f * swings));
            }
        }

        [Test]
        public void Momentum_stays_and_spin_nearly_does()
        {
            using (var fluid = Ball(500f, 1000f, true))
            {
                ParticleState state = fluid.Step(30).Read();
                float3 momentum = 0f, spin = 0f;
                float size = 0f;
                for (int i = 0; i < state.Count; i++)
                {
                    momentum += state.velocities[i].xyz;
                    spin += math.cross(state.positions[i].xyz - 20f, state.velocities[i].xyz);
                    size += math.length(state.velocities[i].xyz);
                }
                TestContext.Out.WriteLine(
                    $"momentum {math.length(momentum) / size:g3} of the speeds' sum {size:g3} d/s, spin {math.length(spin) / size:g3} d");
                Assert.That(size / state.Count, Is.GreaterThan(1f), "d/s: it swings");
                Assert.That(math.length(momentum), Is.LessThan(1e-4f * size));
                Assert.That(math.length(spin), Is.LessThan(0.05f * size));
            }
        }

        // A block dropped onto the floor of a small box. Any values, long and short substeps.
        [Test]
        public void No_modulus_time_or_step_blows_it_up(
            [Values(1f, 1e6f)] float modulus, [Values(0.001f, 1000f)] float relaxationTime, [Values(1f / 15f, 1f / 60f, 1f / 480f)] float timeStep)
        {
            AssertBounded(modulus, relaxationTime, timeStep, DeepWater.Off, m => m);
        }

        // Noise of the particles stretches what is stretched, which would push them on: a film that never forgets would boil.
        [TestCase(200f)]
        [TestCase(1e6f)]
        public void What_is_dropped_comes_to_rest(float modulus)
        {
            SolverSettings settings = SolverSettings.Default;
            settings.deepWater = DeepWater.Off;
            settings.substeps = 8;
            using (var fluid = new TestFluid(16f * Spacing, Spacing, 512, settings).AddBlock(4f * Spacing, 8f * Spacing, new float3(0.5f, -3f, 0f)))
            {
                fluid.Input.timeStep = 1f / 15f;
                fluid.Input.material.shearModulus = modulus;
                fluid.Input.material.relaxationTime = 1000f;
                float start = fluid.Measure().Energy, left = fluid.Step(120).MeasureWhole().kineticEnergy;
                TestContext.Out.WriteLine($"after 8 s {left / start:0.0000} of the energy is motion");
                Assert.That(left, Is.LessThan(0.01f * start));
            }
        }

        [TestCase(DeepWater.On, 0f, 0f)]
        [TestCase(DeepWater.Off, 0.1f, 0f)]
        [TestCase(DeepWater.Off, 0f, 0.1f)]
        [TestCase(DeepWater.On, 0.02f, 0.05f)]
        public void Nor_does_what_is_on_besides(DeepWater deepWater, float tension, float artificialPressure)
        {
            AssertBounded(1e6f, 1000f, TimeStep, deepWater, material =>
            {
                material.allowedTension = tension;
                material.artificialPressure = artificialPressure;
                return material;
            });
        }

        static void AssertBounded(float modulus, float relaxationTime, float timeStep, DeepWater deepWater, Func<FluidMaterial, FluidMaterial> change)
        {
            SolverSettings settings = SolverSettings.Default;
            settings.deepWater = deepWater;
            settings.relaxation = 0.8f;
            settings.substeps = timeStep > 0.05f ? 8 : 1;
            using (var fluid = new TestFluid(16f * Spacing, Spacing, 512, settings).AddBlock(4f * Spacing, 8f * Spacing, new float3(0.5f, -3f, 0f)))
            {
                fluid.Input.timeStep = timeStep;
                fluid.Input.material.shearModulus = modulus;
                fluid.Input.material.relaxationTime = relaxationTime;
                fluid.Input.material = change(fluid.Input.material);
                float start = fluid.Measure().Energy, highest = 0f, fastest = 0f;
                for (int part = 0; part < 6; part++)
                {
                    FluidStatistics s = fluid.Step(10).MeasureWhole();
                    highest = math.max(highest, s.Energy);
                    fastest = math.max(fastest, s.speedMax);
                    Assert.That(ReadStretch(fluid.Solver).Values.All(b => (Tensor.Identity + b).IsPositive));
                }
                TestContext.Out.WriteLine($"{modulus} Pa, {relaxationTime} s, {timeStep:0.0000} s a step: highest energy " +
                    $"{highest / start:0.000} of the start's, {fluid.Measure().Energy / start:0.000} at the end; fastest {fastest:0.0} m/s");
                Assert.That(highest, Is.LessThan(1.02f * start), "what was put into it is all that there is");
                Assert.That(fastest, Is.LessThan(12f), "m/s; it falls at 3");
            }
        }

        [Test]
        public void Stretch_stays_with_its_particle_and_what_is_new_has_none()
        {
            uint first = 0;
            using (var scene = new SourceScene(2f * Vector3.one, Spacing, 3000))
            {
                scene.Fluid.Gravity = Vector3.zero;
                FluidMaterial material = FluidMaterial.Water;
                material.shearModulus = 1e-3f;      // too little to move anything
                material.relaxationTime = 1000f;
                scene.Fluid.Material = material;
                float3[] positions = Points(p => math.cmax(math.abs(p)) < 5f).Select(p => p * Spacing).ToArray();
                first = (uint)positions.Length;
                AddTo(scene.Fluid, positions, new float3(1.2f, 0.6f, 0f));
                scene.Step();
                uint[] ids = scene.Read().ids;
                scene.Fluid.Solver.Viscoelasticity.Conformation.SetData(
                    ids.Select(id => new Viscoelasticity.Symmetric { diagonal = Mark(id) }).ToArray(), 0, 0, ids.Length);
                scene.Add<FluidDrain>(new Vector3(0.35f, 0.1f, 0f), Vector3.up, drain => drain.Size = 0.2f * Vector3.one);
                scene.Add<FluidEmitter>(new Vector3(-0.8f, 0.8f, 0f), Vector3.down, emitter => emitter.Rate = 0.02f);
                int gone = 0, come = 0;
                double worst = 0.0;
                for (int i = 0; i < 8; i++)
                {
                    scene.Step();
                    Dictionary<uint, Tensor> stretch = ReadStretch(scene.Fluid.Solver);
                    gone = positions.Length - stretch.Keys.Count(id => id < first);
                    come = stretch.Keys.Count(id => id >= first);
                    worst = Math.Max(worst, stretch.Max(b => Off(b.Key, b.Value)));
                }
                TestContext.Out.WriteLine($"{gone} gone, {come} come, off by at most {worst:0.00}: the block comes apart a little");
                Assert.That(worst, Is.LessThan(0.5), "marks are 1 apart");
                Assert.That(gone, Is.GreaterThan(20));
                Assert.That(come, Is.GreaterThan(10));
                scene.Fluid.Restart();
                Assert.That(scene.Fluid.Solver.Viscoelasticity, Is.Null, "the next fluid begins without stretch");
            }

            float3 Mark(uint id) => new float3(id % 2, id / 2 % 2, id / 4 % 2);

            double Off(uint id, Tensor stretch) => (stretch - Tensor.Symmetric(id < first ? Mark(id) : 0f, 0.0)).Length;
        }

        // A cube of half a meter under its own weight. Where it slides freely, an incompressible neo-Hookean column is shortened by λ
        // with 1/λ² − λ = ρ g (H − Z) / G, and its center lies as high as the mean of (H − Z) λ / H: 3.34 d, 5 d unloaded.
        [TestCase(DeepWater.Off)]
        [TestCase(DeepWater.On)]
        public void A_gel_stands_where_water_runs_out(DeepWater deepWater)
        {
            float gel = MiddleAfterTwoSeconds(2000f), water = MiddleAfterTwoSeconds(0f);
            TestContext.Out.WriteLine($"the center is {gel:0.00} d high, without elasticity {water:0.00} d");
            Assert.That(gel, Is.EqualTo(3.34f).Within(0.25f * 3.34f), "it yields by what the passes leave of compression, and creeps");
            Assert.That(water, Is.LessThan(1.7f));

            float MiddleAfterTwoSeconds(float modulus)
            {
                SolverSettings settings = SolverSettings.Default;
                settings.substeps = 2;
                settings.deepWater = deepWater;
                using (var fluid = new TestFluid(24f * Spacing, Spacing, 1000, settings).AddBlock(new float3(7f, 0f, 7f) * Spacing, 10f * Spacing))
                {
                    fluid.Input.material.shearModulus = modulus;
                    fluid.Input.material.relaxationTime = 1000f;
                    fluid.Input.material.allowedTension = 0.05f;
                    fluid.Input.material.artificialPressure = 0.1f;
                    return fluid.Step(120).MeasureWhole().centerOfMass.y / Spacing;
                }
            }
        }

        [Test]
        public void What_is_no_number_is_removed_and_spoils_nothing()
        {
            using (var fluid = Ball(500f, 1000f, true))
            {
                int count = fluid.Alive;
                fluid.Add(new[] { new float3(float.NaN, 1f, 1f), new float3(1f, 1f, 1f) }, p => float.PositiveInfinity);
                FluidStatistics statistics = fluid.Step(5).MeasureWhole();
                Assert.That(statistics.nonFinite, Is.EqualTo(2));
                Assert.That(fluid.Alive, Is.EqualTo(count));
                Assert.That(ReadStretch(fluid.Solver).Values.All(b => (Tensor.Identity + b).IsPositive));
            }
        }

        [Test]
        public void It_takes_buffers_only_while_it_is_on()
        {
            using (var fluid = Ball(0f, 1f, false))
            {
                Assert.That(fluid.Solver.Viscoelasticity, Is.Null);
                fluid.Input.material.shearModulus = 1f;
                fluid.Step();
                Assert.That(fluid.Solver.Viscoelasticity, Is.Not.Null);
                fluid.Input.material.shearModulus = 0f;
                fluid.Step();
                Assert.That(fluid.Solver.Viscoelasticity, Is.Null);
            }
        }

        [Test]
        public void A_gel_at_rest_sleeps_with_its_stretch_and_is_woken()
        {
            SolverSettings settings = SolverSettings.Default;
            settings.sleepSpeed = 0.02f;
            using (var fluid = new TestFluid(new float3(16f, 40f, 16f) * Spacing, Spacing, 2000, settings)
                .AddBlock(0f, new float3(16f, 4f, 16f) * Spacing))
            {
                fluid.Input.material.shearModulus = 300f;
                fluid.Input.material.relaxationTime = 0.5f;
                int steps = 0;
                for (; ReadStates(fluid).Any(state => state != 0) && steps < 300; steps += 10)
                    fluid.Step(10);
                TestContext.Out.WriteLine($"asleep after {steps} steps, largest stretch {ReadStretch(fluid.Solver).Values.Max(b => b.Length):0.000}");
                Assert.That(steps, Is.LessThan(300));
                Dictionary<uint, Tensor> before = ReadStretch(fluid.Solver);
                ParticleState state = fluid.Read();
                TestFluid.AssertSame(fluid.Step(10).Read(), state);
                Assert.That(ReadStretch(fluid.Solver), Is.EqualTo(before));
                fluid.Input.material.shearModulus = 400f;
                Assert.That(ReadStates(fluid.Step()), Is.All.EqualTo(2u), "another material");
                fluid.Step(20).MeasureWhole();
            }
        }

        // A long pool of gel with a drop at one end: the far end falls asleep first.
        [Test]
        public void What_sleeps_beside_what_swings_is_not_pushed()
        {
            SolverSettings settings = SolverSettings.Default;
            settings.sleepSpeed = 0.1f;
            int3 regions = new int3(8, 3, 1);
            using (var fluid = new TestFluid(new float3(64f, 24f, 8f) * Spacing, Spacing, 3000, settings)
                .AddBlock(0f, new float3(64f, 4f, 8f) * Spacing).AddBlock(new float3(0f, 6f, 0f) * Spacing,
                new float3(4f, 4f, 8f) * Spacing))
            {
                fluid.Input.material.shearModulus = 1000f;
                fluid.Input.material.relaxationTime = 10f;
                int asleep = 0, moving = 0;
                for (int part = 0; part < 12; part++)
                {
                    uint[] states = ReadStates(fluid.Step(5));
                    if (states.All(state => state != 1))
                        continue;       // nothing sleeps beside what does not
                    ParticleState state = fluid.Read();
                    for (int i = 0; i < state.Count; i++)
                    {
                        int3 region = (int3)(state.positions[i].xyz / RestingRegions.RegionSize);
                        if (states[(region.z * regions.y + region.y) * regions.x + region.x] != 1)
                            continue;
                        asleep++;
                        moving += math.any(state.velocities[i].xyz != 0f) ? 1 : 0;
                    }
                }
                TestContext.Out.WriteLine($"{moving} of {asleep} move");
                Assert.That(asleep, Is.GreaterThan(200));
                Assert.That(moving, Is.LessThan(0.05f * asleep), "but for what came from beside in that step");
            }
        }

        [Test]
        public void A_gel_stays_outside_a_collider()
        {
            using (var scene = new SourceScene(1.2f * Vector3.one, Spacing, 3000))
            {
                FluidMaterial material = FluidMaterial.Water;
                material.shearModulus = 500f;
                material.relaxationTime = 10f;
                scene.Fluid.Material = material;
                var ball = new GameObject("Ball").AddComponent<FluidCollider>();
                try
                {
                    ball.transform.SetParent(scene.Fluid.transform, false);
                    ball.transform.localPosition = new Vector3(0f, -0.3f, 0f);
                    ball.Shape = ColliderShape.Sphere;
                    ball.Radius = 0.25f;
                    AddTo(scene.Fluid, Points(p => math.cmax(math.abs(p)) < 5f).Select(p => p * Spacing + new float3(0f, 0.3f, 0f)).ToArray(), 0f);
                    scene.Step(60);
                    scene.AssertConserved();
                    float3 center = new float3(0.6f, 0.3f, 0.6f) / Spacing;
                    float nearest = scene.Read().positions.Min(p => math.distance(p.xyz, center)) - 0.25f / Spacing;
                    TestContext.Out.WriteLine($"nearest {nearest:0.000} d from the surface");
                    Assert.That(nearest, Is.GreaterThan(0.4f), "half a spacing but for what a pass leaves");
                }
                finally
                {
                    Object.DestroyImmediate(ball.gameObject);
                }
            }
        }

        // Fraction of the stretch beyond round that a quarter of a second takes back.
        static float Recovered(float modulus, float relaxationTime = 1000f, bool stretched = true)
        {
            using (var fluid = Ball(modulus, relaxationTime, stretched))
            {
                float before = Elongation(fluid);
                return (before - Elongation(fluid.Step(15))) / (before - 1f);
            }
        }

        // A ball drawn out along x, at rest far from everything.
        static TestFluid Ball(float modulus, float relaxationTime, bool stretched)
        {
            TestFluid fluid = Free(modulus);
            fluid.Input.material.relaxationTime = relaxationTime;
            var draw = new float3(Stretch, 1f / math.sqrt(Stretch), 1f / math.sqrt(Stretch));
            fluid.Add(Points(p => math.length(p) < 6f).Select(p => (20f + draw * p) * Spacing).ToArray());
            fluid.Step();       // nothing moves yet: it is stretched no closer than it rests
            if (stretched && fluid.Solver.Viscoelasticity != null)
                fluid.Solver.Viscoelasticity.Conformation.SetData(
                    Enumerable.Repeat(new Viscoelasticity.Symmetric { diagonal = draw * draw - 1f }, fluid.Alive).ToArray(), 0, 0,
                    fluid.Alive);
            return fluid;
        }

        static TestFluid Free(float modulus)
        {
            var fluid = new TestFluid(40f * Spacing, Spacing, 4000);
            fluid.Input.gravity = 0f;
            fluid.Input.material.shearModulus = modulus;
            fluid.Input.material.relaxationTime = 1000f;
            return fluid;
        }

        static void AddTo(FluidSimulation fluid, float3[] points, float3 velocity)
        {
            using (var positions = new NativeArray<float3>(points, Allocator.Persistent))
            using (var velocities = new NativeArray<float3>(points.Select(_ => velocity).ToArray(), Allocator.Persistent))
                fluid.AddParticles(positions, velocities);
        }

        // Points of a lattice around 0, d.
        static IEnumerable<float3> Points(Func<float3, bool> inside)
        {
            ParticleState lattice = ParticleState.Lattice(0f, -9.5f, 20, jitter: 0.02f);
            return lattice.positions.Select(p => p.xyz).Where(inside);
        }

        static float Elongation(TestFluid fluid)
        {
            float4[] positions = fluid.Read().positions;
            float4 center = positions.Aggregate((a, b) => a + b) / positions.Length;
            float4 squares = positions.Select(p => (p - center) * (p - center)).Aggregate((a, b) => a + b);
            return math.sqrt(squares.x / squares.y);
        }

        static uint[] ReadStates(TestFluid fluid) => fluid.Solver.Resting == null ? new[] { 2u }
            : GpuTest.Read<uint>(fluid.Solver.Resting.States, fluid.Solver.Resting.States.count);

        // By id, of the particles that took part in the last step.
        static Dictionary<uint, Tensor> ReadStretch(PbfSolver solver)
        {
            int moved = (int)GpuTest.Read<uint>(solver.Counters, ParticleBuffers.CounterCount)[(int)ParticleCounter.Moved];
            uint[] ids = GpuTest.Read<uint>(solver.ParticleIds, moved);
            Viscoelasticity.Symmetric[] stretch = GpuTest.Read<Viscoelasticity.Symmetric>(solver.Viscoelasticity.Conformation, moved);
            return Enumerable.Range(0, moved).ToDictionary(i => ids[i], i => Tensor.Symmetric(stretch[i].diagonal, stretch[i].others));
        }
    }
}
