using NUnit.Framework;
using static System.FormattableString;

namespace Rill.Tests
{
    public class SettingsTests
    {
        [Test]
        public void Defaults_are_valid()
        {
            SolverSettings settings = SolverSettings.Default;
            FluidMaterial water = FluidMaterial.Water;
            Assert.That(settings.Validate(out string problem), Is.True, problem);
            Assert.That(water.Validate(out problem), Is.True, problem);
            Assert.That(problem, Is.Null);
        }

        [TestCase(0, 1)]
        [TestCase(-5, 1)]
        [TestCase(51, 50)]
        [TestCase(50, 50)]
        public void Iterations_are_clamped(int given, int expected)
        {
            SolverSettings settings = SolverSettings.Default;
            settings.iterations = given;
            AssertClamped(settings.Validate(out string problem), problem, given != expected,
                Invariant($"iterations {given} is outside 1 to 50; using {expected}."));
            Assert.That(settings.iterations, Is.EqualTo(expected));
        }

        [TestCase(-0.1f, 0f)]
        [TestCase(0f, 0f)]
        [TestCase(2f, 2f)]
        [TestCase(5f, 2f)]
        [TestCase(float.NaN, 0.8f)]
        [TestCase(float.PositiveInfinity, 0.8f)]
        public void Relaxation_is_clamped_to_where_over_relaxation_ends(float given, float expected)
        {
            SolverSettings settings = SolverSettings.Default;
            settings.relaxation = given;
            AssertClamped(settings.Validate(out string problem), problem, given != expected,
                Invariant($"relaxation {given} is outside 0 to 2; using {expected}."));
            Assert.That(settings.relaxation, Is.EqualTo(expected));
        }

        [TestCase(-1f, 0f)]
        [TestCase(0.02f, 0.02f)]
        [TestCase(3f, 1f)]
        [TestCase(float.NaN, 0f)]
        public void The_speed_below_which_water_sleeps_is_clamped_and_never_by_default(float given, float expected)
        {
            SolverSettings settings = SolverSettings.Default;
            Assert.That(settings.sleepSpeed, Is.Zero);
            settings.sleepSpeed = given;
            AssertClamped(settings.Validate(out string problem), problem, given != expected,
                Invariant($"sleep speed {given} is outside 0 to 1; using {expected}."));
            Assert.That(settings.sleepSpeed, Is.EqualTo(expected));
        }

        [TestCase(-1f, 0f)]
        [TestCase(0f, 0f)]
        [TestCase(0.5f, 0.5f)]
        [TestCase(2f, 1f)]
        [TestCase(float.NaN, 1f)]
        public void Numerical_damping_is_clamped_and_a_first_order_steps_by_default(float given, float expected)
        {
            SolverSettings settings = SolverSettings.Default;
            Assert.That(settings.numericalDamping, Is.EqualTo(1f));
            settings.numericalDamping = given;
            AssertClamped(settings.Validate(out string problem), problem, given != expected,
                Invariant($"numerical damping {given} is outside 0 to 1; using {expected}."));
            Assert.That(settings.numericalDamping, Is.EqualTo(expected));
        }

        [TestCase(0f, 1, 1)]
        [TestCase(0.27f, 1, 1)]
        [TestCase(0.6f, 1, 1)]
        [TestCase(0.61f, 1, 2)]
        [TestCase(0.61f, 3, 3)]
        [TestCase(2.5f, 1, 3)]
        [TestCase(5.45f, 1, 5)]
        [TestCase(1e6f, 2, 16)]
        [TestCase(float.PositiveInfinity, 1, 16)]
        public void As_many_substeps_are_taken_as_keep_gravitys_way_in_one_short(float gravityStep, int asked, int taken)
        {
            SolverSettings settings = SolverSettings.Default;
            settings.substeps = asked;
            Assert.That(settings.StableSubsteps(gravityStep), Is.EqualTo(taken));
        }

        [TestCase(1, false, 0.3f)]
        [TestCase(1, true, 0.8f)]
        [TestCase(2, false, 1f)]
        [TestCase(2, true, 1f)]
        [TestCase(3, false, 1.2f)]
        [TestCase(7, true, 1.2f)]
        [TestCase(8, false, 1.3f)]
        [TestCase(50, true, 1.3f)]
        public void No_more_relaxation_is_used_than_stays_stable_with_the_iterations(int iterations, bool deepWater, float largest)
        {
            SolverSettings settings = SolverSettings.Default;
            settings.iterations = iterations;
            settings.relaxation = 2f;
            Assert.That(settings.StableRelaxation(deepWater), Is.EqualTo(largest));
            settings.relaxation = 0.3f;
            Assert.That(settings.StableRelaxation(deepWater), Is.EqualTo(0.3f));
        }

        [TestCase(0f)]
        [TestCase(0.29f)]
        public void In_deep_water_no_less_relaxation_is_used_than_parts_what_the_grid_presses_together(float asked)
        {
            SolverSettings settings = SolverSettings.Default;
            settings.relaxation = asked;
            Assert.That(settings.StableRelaxation(deepWater: true), Is.EqualTo(0.3f));
            Assert.That(settings.StableRelaxation(deepWater: false), Is.EqualTo(asked));
        }

        [TestCase(0, 1)]
        [TestCase(17, 16)]
        public void Substeps_are_clamped(int given, int expected)
        {
            SolverSettings settings = SolverSettings.Default;
            settings.substeps = given;
            AssertClamped(settings.Validate(out string problem), problem, true, Invariant($"substeps {given} is outside 1 to 16; using {expected}."));
            Assert.That(settings.substeps, Is.EqualTo(expected));
        }

        [Test]
        public void A_struct_of_zeros_becomes_valid_and_names_every_value()
        {
            SolverSettings settings = default;
            Assert.That(settings.Validate(out string problem), Is.False);
            foreach (string name in new[] { "iterations 0", "substeps 0", "softness 0", "list margin 0", "neighbor capacity 0" })
                Assert.That(problem, Does.Contain(name));
            Assert.That(settings.Validate(out problem), Is.True, problem);
        }

        [TestCase(float.NaN)]
        [TestCase(float.NegativeInfinity)]
        [TestCase(-1f)]
        [TestCase(2e6f)]
        public void A_material_out_of_range_becomes_valid_and_says_so(float bad)
        {
            var material = new FluidMaterial
            {
                density = bad, velocitySmoothing = bad, dynamicViscosity = bad, wallFriction = bad,
                vorticity = bad, artificialPressure = bad, artificialPressureDistance = bad, allowedTension = bad, shearModulus = bad,
                relaxationTime = bad, surfaceTension = bad, contactAngle = bad, frictionAngle = bad, cohesion = bad
            };
            Assert.That(material.Validate(out string problem), Is.False);
            foreach (string name in new[] { "density", "velocity smoothing", "dynamic viscosity", "wall friction", "vorticity",
                "artificial pressure", "artificial pressure distance", "allowed tension", "shear modulus", "relaxation time",
                "surface tension", "contact angle", "friction angle", "cohesion" })
                Assert.That(problem, Does.Contain(Invariant($"{name} {bad} is outside")));
            Assert.That(material.Validate(out problem), Is.True, problem);
        }

        [Test]
        public void A_value_that_is_no_number_becomes_that_of_water()
        {
            FluidMaterial material = FluidMaterial.Water;
            material.velocitySmoothing = float.NaN;
            material.Validate(out _);
            Assert.That(material.velocitySmoothing, Is.EqualTo(FluidMaterial.Water.velocitySmoothing));
        }

        static void AssertClamped(bool valid, string problem, bool clamped, string message)
        {
            Assert.That(valid, Is.EqualTo(!clamped));
            Assert.That(problem, clamped ? Is.EqualTo(message) : Is.Null);
        }
    }
}
