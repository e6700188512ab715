using System;
using NUnit.Framework;

namespace Rill.Tests
{
    /// <summary>Materials of the phases as one value: what differs, and the largest of each.</summary>
    public class PhaseMaterialsTests
    {
        static FluidMaterial Own(float density = 1000f, float viscosity = 2f, float tension = 0.07f, float angle = 60f)
        {
            FluidMaterial own = FluidMaterial.Water;
            (own.density, own.dynamicViscosity, own.surfaceTension, own.contactAngle) = (density, viscosity, tension, angle);
            return own;
        }

        static PhaseMaterials Only(int phase, float density, float viscosity, float tension, float angle)
        {
            var phases = new PhaseMaterials();
            phases.Set(phase, density, viscosity, tension, angle);
            return phases;
        }

        // Phases without a material of their own act as the fluid's own.
        [Test]
        public void A_pair_is_the_same_from_both_sides_and_others_have_none([Values(0, 2, 3, 7)] int first, [Values(1, 4, 5)] int second)
        {
            var phases = new PhaseMaterials();
            foreach (int phase in new[] { 1, 2, 3, 4, 5, 7 })
                phases.Set(phase, 1000f, 0f);
            phases.SetPair(first, second, 0.5f, 0.25f);
            for (int a = 0; a < PhaseMaterials.Phases; a++)
            {
                for (int b = 0; b < PhaseMaterials.Phases; b++)
                {
                    int x = a == 6 ? 0 : a, y = b == 6 ? 0 : b;
                    bool isPair = x == first && y == second || x == second && y == first;
                    Assert.That((phases.Diffusion(a, b), phases.InterfaceTension(a, b)), Is.EqualTo(isPair ? (0.5f, 0.25f) : (0f, 0f)), $"{a}, {b}");
                    Assert.That(phases.AreMixing(x, y), Is.EqualTo(isPair || x == y), $"{a}, {b}");
                }
            }
            Assert.That((phases.MaxDiffusion, phases.WithoutDiffusion().MaxDiffusion), Is.EqualTo((0.5f, 0f)));
            Assert.That(phases.WithoutDiffusion().InterfaceTension(second, first), Is.EqualTo(0.25f));
            Assert.That(phases.Differ(FluidMaterial.Water), "the tension between them");
        }

        [Test]
        public void Phases_mix_through_others()
        {
            var phases = new PhaseMaterials();
            for (int phase = 1; phase < 6; phase++)
                phases.Set(phase, 1000f, 0f);
            phases.SetPair(0, 3, 0.1f);
            phases.SetPair(3, 5, 0.1f);
            phases.SetPair(1, 2, 0.1f);
            Assert.That(phases.AreMixing(5, 0) && phases.AreMixing(0, 5));
            Assert.That(phases.AreMixing(5, 1) || phases.AreMixing(0, 4), Is.False);
        }

        [TestCase(1000f, 2f, 0.07f, 60f, ExpectedResult = false)]
        [TestCase(900f, 2f, 0.07f, 60f, ExpectedResult = true)]
        [TestCase(1000f, 3f, 0.07f, 60f, ExpectedResult = true)]
        [TestCase(1000f, 2f, 0.08f, 60f, ExpectedResult = true)]
        [TestCase(1000f, 2f, 0f, 60f, ExpectedResult = true)]
        [TestCase(1000f, 2f, 0.07f, 120f, ExpectedResult = true, TestName = "It differs by its contact angle alone")]
        public bool A_phase_differs_by_each_of_its_figures(float density, float viscosity, float tension, float angle)
        {
            bool differ = Only(1, density, viscosity, tension, angle).Differ(Own());
            Assert.That(Only(7, density, viscosity, tension, angle).Differ(Own()), Is.EqualTo(differ), "the last phase as the first");
            return differ;
        }

        [Test]
        public void Without_tension_a_contact_angle_makes_no_difference()
            => Assert.That(Only(3, 1000f, 2f, 0f, 120f).Differ(Own(tension: 0f)), Is.False);

        [Test]
        public void The_tension_of_any_phase_counts([Values(1, 3, 7)] int phase)
        {
            Assert.That(Only(phase, 1000f, 0f, 0.01f, 90f).HaveTension(Own(tension: 0f)), Is.True);
            Assert.That(Only(phase, 1000f, 0f, 0f, 90f).HaveTension(Own(tension: 0f)), Is.False);
            Assert.That(Only(phase, 1000f, 0f, 0f, 90f).HaveTension(Own()), Is.True, "the fluid's own");
        }

        [Test]
        public void The_heaviest_the_thickest_and_the_most_viscous_by_its_density_are_found()
        {
            var phases = new PhaseMaterials();
            phases.Set(2, 500f, 3f);        // 0.006 m²/s
            phases.Set(5, 4000f, 8f);       // 0.002 m²/s
            FluidMaterial own = Own();      // 0.002 m²/s
            Assert.That((phases.Last, phases.Heaviest(own), phases.Ratio(own), phases.MaxViscosity(own)), Is.EqualTo((5, 4000f, 8f, 8f)));
            Assert.That(phases.MaxKinematicViscosity(own), Is.EqualTo(0.006).Within(1e-9));
            Assert.That(phases.MaxKinematicViscosity(Own(viscosity: 10f)), Is.EqualTo(0.01).Within(1e-9));
            Assert.That((phases.Density(3, own), phases.Viscosity(3, own), phases.Density(5, own)), Is.EqualTo((1000f, 2f, 4000f)),
                "a phase between, without a material");
        }

        [TestCase(30f, 0f)]
        [TestCase(0f, 500f)]
        public void Grains_of_any_phase_count_and_differ_from_a_liquid(float friction, float cohesion)
        {
            FluidMaterial own = Own();
            foreach (int phase in new[] { 1, 7 })
            {
                var phases = new PhaseMaterials();
                phases.Set(phase, own.density, own.dynamicViscosity, own.surfaceTension, own.contactAngle, friction, cohesion);
                Assert.That((phases.Differ(own), phases.HaveGrains(own)), Is.EqualTo((true, true)), $"phase {phase}");
                Assert.That((phases.MaxFrictionAngle(own), phases.MaxCohesion(own)), Is.EqualTo((friction, cohesion)));
                Assert.That((phases.FrictionAngle(2, own), phases.Cohesion(2, own)), Is.EqualTo((0f, 0f)), "a phase without a material");
                PhaseMaterials liquid = phases.WithoutFriction();
                Assert.That((liquid.HaveGrains(own), liquid.Tension(phase, own)), Is.EqualTo((false, own.surfaceTension)));
                Assert.That(phases.HaveGrains(own), "of the others nothing changed");
            }
            (own.frictionAngle, own.cohesion) = (friction, cohesion);
            Assert.That(new PhaseMaterials().HaveGrains(own), "the fluid's own");
        }

        [Test]
        public void Without_viscosity_all_else_stays()
        {
            var phases = new PhaseMaterials();
            phases.Set(1, 500f, 3f, 0.02f, 30f);
            phases.Set(4, 4000f, 8f, 0.4f, 140f);
            PhaseMaterials thin = phases.WithoutViscosity();
            FluidMaterial own = Own();
            foreach ((int phase, float density, float tension, float angle) in new[] { (1, 500f, 0.02f, 30f), (4, 4000f, 0.4f, 140f) })
                Assert.That((thin.Density(phase, own), thin.Viscosity(phase, own), thin.Tension(phase, own), thin.Angle(phase, own)),
                    Is.EqualTo((density, 0f, tension, angle)), $"phase {phase}");
            Assert.That(phases.Viscosity(4, own), Is.EqualTo(8f), "of the others nothing changed");
        }

        [Test]
        public void Phases_are_0_to_7()
        {
            var phases = new PhaseMaterials();
            Assert.Throws<ArgumentOutOfRangeException>(() => phases.Set(8, 1f, 0f));
            Assert.Throws<ArgumentOutOfRangeException>(() => phases.Set(0, 1f, 0f));
        }
    }
}
