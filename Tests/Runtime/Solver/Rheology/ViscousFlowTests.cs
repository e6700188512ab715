using System;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>Fluids of a given viscosity in flows whose answer is known, by the whole solver.</summary>
    [Category("LongRun")]
    public class ViscousFlowTests
    {
        const int Side = 30;            // d, of a block
        const double Reaches = 4.0;     // ν Δt/d² from which on the eddy reaches the block's surface in two steps

        static readonly ViscousEddy Whirl = new ViscousEddy(Side, 6f);

        static float3[] flowed;

        // v = z x r exp(-r²/w²) spreads as heat does, without pressure: shear waves of all lengths, most of them of 2.8 w. A step that is
        // solved implicitly takes 1 / (1 + ν k² Δt) of each. The lattice itself leaves 1.3 % of waves so short.
        [Test]
        public void An_eddy_decays_by_its_viscosity_at_every_spacing_and_step(
            [Values(0.001f, 0.01f, 0.1f, 1f)] float viscosity, [Values(0.05f, 0.025f)] float spacing, [Values(0.004f, 0.016f)] float timeStep)
        {
            AssertDecays(Whirl.Lattice, viscosity, spacing, timeStep);
        }

        [Test]
        public void And_so_it_does_in_water_that_has_flowed([Values(0.001f, 0.1f)] float viscosity, [Values(0.05f, 0.025f)] float spacing)
        {
            AssertDecays(Flowed, viscosity, spacing, 0.016f);
        }

        // Without pressure around it or tension a ball that turns flies apart: by 1 + Ω² t² where nothing holds it.
        [TestCase(0f)]
        [TestCase(0.1f)]
        [TestCase(1f)]
        public void What_turns_freely_keeps_its_spin(float viscosity)
        {
            const float Spacing = 0.05f, Rate = 2f, Radius = 5f, Box = 16f;
            const int Steps = 24;
            using (var fluid = new TestFluid(Box * Spacing, Spacing, 1000))
            {
                fluid.Input.gravity = 0f;
                fluid.Input.material.dynamicViscosity = viscosity * fluid.Input.material.density;
                fluid.Input.material.velocitySmoothing = 0f;        // it takes spin
                float3[] ball = ParticleState.Lattice(0f, 0.5f, (int)Box).positions.Select(p => p.xyz)
                .Where(p => math.distance(p, 0.5f * Box) < Radius).ToArray();
                fluid.Add(ball.Select(p => p * Spacing).ToArray(), p => math.cross(new float3(0f, Rate, 0f), p - 0.5f * Box * Spacing));
                Turning start = TurningOf(fluid.Read()), end = TurningOf(fluid.Step(Steps).Read());
                double spin = end.spin / start.spin, inertia = end.inertia / start.inertia,
                    strain = end.energy * end.inertia / (end.spin * end.spin) - 1.0;
                TestContext.Out.WriteLine($"{viscosity} m²/s: spin {spin:0.00000} of the start's, inertia {inertia:0.000}, energy of " +
                    $"other motion {strain:0.0000} of the turning's");
                Assert.That(spin, Is.EqualTo(1.0).Within(2e-4));
                if (viscosity >= 1f)
                    Assert.That(strain, Is.LessThan(0.005), "turns as a rigid body");
            }
        }

        [Test]
        public void A_viscosity_of_next_to_nothing_changes_no_bit([Values(DeepWater.Off, DeepWater.On)] DeepWater deepWater)
        {
            TestFluid Dam(float dynamicViscosity)
            {
                var settings = SolverSettings.Default;
                settings.deepWater = deepWater;
                settings.substeps = 2;
                var fluid = new TestFluid(new float3(1f, 1f, 0.5f), 0.05f, 2000, settings);
                fluid.Input.material.dynamicViscosity = dynamicViscosity;
                return fluid.AddBlock(0f, new float3(0.5f, 0.6f, 0.5f)).Step(5).AddBlock(new float3(0.5f, 0f, 0f),
                    new float3(0.2f, 0.2f, 0.5f)).Step(10);
            }
            using (TestFluid without = Dam(0f), with = Dam(1e-20f))
                TestFluid.AssertSame(with.Read(), without.Read());
        }

        // Honey in half a box of water's depth, more of it added meanwhile.
        [Test]
        public void Viscous_fluid_comes_to_rest_whole([Values(DeepWater.Off, DeepWater.On)] DeepWater deepWater,
            [Values(10f, 1e6f)] float dynamicViscosity)
        {
            var settings = SolverSettings.Default;
            settings.deepWater = deepWater;
            using (var fluid = new TestFluid(new float3(1f, 1f, 0.5f), 0.05f, 2000, settings))
            {
                fluid.Input.material.dynamicViscosity = dynamicViscosity;
                fluid.AddBlock(0f, new float3(0.5f, 0.6f, 0.5f)).Step(5).AddBlock(new float3(0.5f, 0f, 0f), new float3(0.2f, 0.2f, 0.5f));
                float start = fluid.Measure().Energy;
                FluidStatistics end = fluid.Step(60).MeasureWhole();
                TestContext.Out.WriteLine($"C+ {end.densityError:0.0000}, volume {end.volumeRatio:0.000}, speed {end.speed:0.0000} " +
                    $"m/s, jitter {end.jitter:0.0000} m/s, energy {end.Energy / start:0.000}, last change {end.viscosityChange:g3} m/s");
                Assert.That(end.Energy, Is.LessThan(start));
                // Honey is solved. Of 1e6 Pa s slow motion is left by any number of passes, each of which takes more of it than the one
                // before: 48 end in a last change of 0.13 to 0.18 m/s, 96 of 0.24. The statistics have to show that.
                Assert.That(end.viscosityChange, dynamicViscosity < 100f ? Is.InRange(1e-6f, 1e-3f) : Is.InRange(0.01f, 0.5f));
            }
        }

        static void AssertDecays(float3[] positions, float viscosity, float spacing, float timeStep)
        {
            const int Steps = 2;
            double strength = viscosity * timeStep / (spacing * spacing);
            double without = Whirl.Left(positions, 0f, spacing, timeStep, Steps), left = Whirl.Left(positions, viscosity, spacing, timeStep, Steps);
            double decay = Math.Log(without / left), expected = -Math.Log(Whirl.Expected(strength, Steps));
            double inBlock = strength > Reaches ? -Math.Log(Whirl.ExpectedInBlock(strength, Steps)) : expected;
            TestContext.Out.WriteLine($"ν Δt/d² {strength:g3}, {ImplicitViscosity.PassesFor(strength)} passes: " +
                $"{100.0 * (decay / expected - 1.0):0.0} % off {expected:g4}, {100.0 * (decay / inBlock - 1.0):0.0} % off {inBlock:g4} " +
                $"in the block; {-Math.Log(without):g3} without viscosity");
            Assert.That(decay, Is.EqualTo(inBlock).Within(0.03 * inBlock));
        }

        // A block that has run out over the floor of a narrow tank and come to rest.
        static float3[] Flowed
        {
            get
            {
                if (flowed != null)
                    return flowed;
                var settings = SolverSettings.Default;
                settings.deepWater = DeepWater.On;
                using (var fluid = new TestFluid(new float3(Side + 2f, 2f * Side, Side) * 0.05f, 0.05f, Side * Side * Side, settings))
                {
                    fluid.AddBlock(new float3(0f, 5f, 0f) * 0.05f, (float3)Side * 0.05f).Step(90);
                    float3[] positions = fluid.Read().positions.Select(p => p.xyz).ToArray();
                    float3 center = positions.Aggregate((a, b) => a + b) / positions.Length;
                    return flowed = positions.Select(p => p - center + 0.5f * Side).ToArray();
                }
            }
        }

        struct Turning
        {
            public double spin, inertia, energy;
        }

        // About the vertical through the center: Σ r v, Σ r², Σ v², d and s.
        static Turning TurningOf(ParticleState state)
        {
            float3 center = state.positions.Aggregate((a, b) => a + b).xyz / state.Count;
            var turning = new Turning();
            for (int i = 0; i < state.Count; i++)
            {
                float3 arm = state.positions[i].xyz - center;
                turning.spin += math.cross(arm, state.velocities[i].xyz).y;
                turning.inertia += math.lengthsq(arm.xz);
                turning.energy += math.lengthsq(state.velocities[i].xyz);
            }
            return turning;
        }
    }
}
