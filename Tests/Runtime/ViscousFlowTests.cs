using System;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>Fluids of a given viscosity in flows whose answer is known, by the whole solver.</summary>
    public class ViscousFlowTests
    {
        const int Side = 30;            // d, of a block

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

        [Test]
        public void What_turns_as_a_rigid_body_is_not_braked_by_viscosity()
        {
            float without = Turning(0f), viscous = Turning(1f);
            TestContext.Out.WriteLine($"turns at {viscous:0.0000} of its start after a second, {without:0.0000} without viscosity");
            // A step of the solver leaves 1 / sqrt(1 + 2 Ω² Δt t) of a turn, 0.94; without viscosity the particles' jitter takes more.
            Assert.That(viscous, Is.GreaterThan(without - 0.01f).And.InRange(0.85f, 0.94f));
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
                return fluid.AddBlock(0f, new float3(0.5f, 0.6f, 0.5f)).Step(5).AddBlock(new float3(0.5f, 0f, 0f), new float3(0.2f, 0.2f, 0.5f)).Step(10);
            }
            using (TestFluid without = Dam(0f), with = Dam(1e-20f))
                TestFluid.AssertSame(with.Read(), without.Read());
        }

        // Honey in half a box of water's depth, more of it added on the way.
        [Test]
        public void Viscous_fluid_comes_to_rest_whole([Values(DeepWater.Off, DeepWater.On)] DeepWater deepWater, [Values(10f, 1e6f)] float dynamicViscosity)
        {
            var settings = SolverSettings.Default;
            settings.deepWater = deepWater;
            using (var fluid = new TestFluid(new float3(1f, 1f, 0.5f), 0.05f, 2000, settings))
            {
                fluid.Input.material.dynamicViscosity = dynamicViscosity;
                fluid.AddBlock(0f, new float3(0.5f, 0.6f, 0.5f)).Step(5).AddBlock(new float3(0.5f, 0f, 0f), new float3(0.2f, 0.2f, 0.5f));
                float start = fluid.Measure().Energy;
                FluidStatistics end = fluid.Step(60).MeasureWhole();
                TestContext.Out.WriteLine($"C+ {end.densityError:0.0000}, volume {end.volumeRatio:0.000}, speed {end.speed:0.0000} m/s, jitter {end.jitter:0.0000} m/s, energy {end.Energy / start:0.000}, last change {end.viscosityChange:g3} m/s");
                Assert.That(end.Energy, Is.LessThan(start));
                Assert.That(end.viscosityChange, Is.GreaterThan(0f).And.LessThan(0.2f));
            }
        }

        static void AssertDecays(float3[] places, float viscosity, float spacing, float timeStep)
        {
            const int Steps = 2;
            double strength = viscosity * timeStep / (spacing * spacing);
            double without = Whirl.Left(places, 0f, spacing, timeStep, Steps), left = Whirl.Left(places, viscosity, spacing, timeStep, Steps);
            double decay = Math.Log(without / left), expected = -Math.Log(Whirl.Expected(strength, Steps));
            TestContext.Out.WriteLine($"ν Δt/d² {strength:g3}, {ImplicitViscosity.PassesFor(strength)} passes: {100.0 * (decay / expected - 1.0):0.0} % off {expected:g4}; {-Math.Log(without):g3} without viscosity");
            // At ν Δt / d² = 25 a step reaches 5 d, and two reach the surface.
            Assert.That(decay, Is.EqualTo(expected).Within((strength > 10.0 ? 0.15 : 0.03) * expected));
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
                    float3[] places = fluid.Read().positions.Select(p => p.xyz).ToArray();
                    float3 center = places.Aggregate((a, b) => a + b) / places.Length;
                    return flowed = places.Select(p => p - center + 0.5f * Side).ToArray();
                }
            }
        }

        // Of a free ball, after a second.
        static float Turning(float viscosity)
        {
            const float Spacing = 0.05f, Rate = 2f, Radius = 5f, Box = 16f;
            using (var fluid = new TestFluid(Box * Spacing, Spacing, 1000))
            {
                fluid.Input.gravity = 0f;
                fluid.Input.material.dynamicViscosity = viscosity * fluid.Input.material.density;
                float3[] ball = ParticleState.Lattice(0f, 0.5f, (int)Box).positions.Select(p => p.xyz).Where(p => math.distance(p, 0.5f * Box) < Radius).ToArray();
                ParticleState state = fluid.Add(ball.Select(p => p * Spacing).ToArray(), p => math.cross(new float3(0f, Rate, 0f), p - 0.5f * Box * Spacing)).Step(60).Read();
                float3 center = state.positions.Aggregate((a, b) => a + b).xyz / state.Count;
                float3 spin = 0f;
                float squares = 0f;
                for (int i = 0; i < state.Count; i++)
                {
                    float3 arm = state.positions[i].xyz - center;
                    spin += math.cross(arm, state.velocities[i].xyz);
                    squares += math.lengthsq(arm.xz);
                }
                return spin.y / squares / Rate;
            }
        }
    }
}
