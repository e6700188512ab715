using NUnit.Framework;
using Unity.Mathematics;
using static Rill.LatticeKernels;

namespace Rill.Tests
{
    /// <summary>Numbers that papers, measurements and decisions give, once as literals: other tests read some of them from the code.</summary>
    public class DecidedNumbersTests
    {
        // Sums over the cubic lattice of Müller et al. 2003, eq. 20 and 21, with h = 2 d, summed by another program.
        [Test]
        public void The_kernels_sum_to_these_numbers_on_the_lattice()
        {
            Assert.That(Support, Is.EqualTo(2.0));
            Assert.That(RestDensity, Is.EqualTo(1.0097751668946853).Within(1e-12));
            Assert.That(ReferenceSquares, Is.EqualTo(0.36620016388965343).Within(1e-12));
            Assert.That(Poly6Spread, Is.EqualTo(21.0 / 55.0).Within(1e-12));
            Assert.That(StressMultiplier, Is.EqualTo(55.0 / 29.0).Within(1e-12));
            Assert.That(ViscosityBlend, Is.EqualTo(3.0 / 7.0).Within(1e-12));
            Assert.That(ViscosityMoment, Is.EqualTo(5280.0 / 7.0).Within(1e-9));
            Assert.That(ViscositySquares, Is.EqualTo(3168.0 / 7.0).Within(1e-9));
            Assert.That(ViscosityScale, Is.EqualTo(30.0));
            Assert.That(ViscosityEigenvalue, Is.EqualTo(12.0).Within(1e-9));
            Assert.That(ViscosityWallHold, Is.EqualTo(0.0002890722211334741).Within(1e-12));
            Assert.That(ViscosityWallMoment, Is.EqualTo(0.06957725077359875).Within(1e-12));
            Assert.That(ViscosityWallSquares, Is.EqualTo(0.03679566146680703).Within(1e-12));
            Assert.That(ViscosityWallLean, Is.EqualTo(0.03679566146680703).Within(1e-12));
            Assert.That(ViscositySurface, Is.EqualTo(3.4374304163883287).Within(1e-9));
            Assert.That(ViscosityDisorder, Is.EqualTo(0.008));
            Assert.That(HalfSpaceDensity(0.0), Is.EqualTo(0.5).Within(1e-12));
            Assert.That(HalfSpaceDensity(0.5), Is.EqualTo(0.21661801636219033).Within(1e-12));
            Assert.That(WallScale, Is.EqualTo(0.8813167718694571).Within(1e-12));
        }

        // Research~/foam-study.md. Water 20 spacings of 5 cm deep at 9.81 m/s²: waves of 62.64 spacings a second.
        [Test]
        public void Foam_has_the_limits_and_rates_of_its_page()
        {
            FoamSettings settings = FoamSettings.Default;
            settings.amount = 1f;
            var scales = new FoamScales(settings, 9.81, 20.0, 0.05, 1.0 / 60.0, 2);
            Assert.That(scales.Speed, Is.EqualTo(62.6418390534633).Within(1e-9));
            Assert.That(scales.Depth, Is.EqualTo(20.0));
            AssertNear(scales.Limits, 245.25, 1.0 / 735.75, 6.26418390534633, 9.0);
            AssertNear(scales.Rates, 0.81564894600, 0.81564894600, 0.1, 2.5);
            Assert.That(FoamScales.Rise, Is.EqualTo(0.1));

            settings.referenceDepth = 1.5f;
            settings.referenceSpeed = 3f;
            settings.amount = 2f;
            scales = new FoamScales(settings, 9.81, 20.0, 0.05, 1.0 / 120.0, 1);
            Assert.That(scales.Speed, Is.EqualTo(60.0).Within(1e-4));
            Assert.That(scales.Depth, Is.EqualTo(30.0).Within(1e-4));
            AssertNear(scales.Limits, 225.0, 1.0 / 675.0, 4.0, 9.0);
            AssertNear(scales.Rates, 0.15432098765, 0.15432098765, 0.1, 2.5);
        }

        [Test]
        public void Water_sleeps_as_its_setting_says()
        {
            Assert.That(RestingRegions.Delay, Is.EqualTo(0.5f), "s");
            Assert.That(RestingRegions.JitterRatio, Is.EqualTo(25f));
            Assert.That(RestingRegions.RegionSize, Is.EqualTo(8f), "d");
        }

        // Measured: see Research~/solver-study.md.
        [TestCase(1, false, 0.3f)]
        [TestCase(1, true, 0.8f)]
        [TestCase(2, false, 1f)]
        [TestCase(2, true, 1f)]
        [TestCase(3, false, 1.2f)]
        [TestCase(7, false, 1.2f)]
        [TestCase(8, false, 1.3f)]
        [TestCase(16, true, 1.3f)]
        public void No_more_relaxation_than_this_is_stable(int iterations, bool deepWater, float relaxation)
            => Assert.That(SolverSettings.MaxRelaxation(iterations, deepWater), Is.EqualTo(relaxation));

        // Beyond 0.6 spacings in a step as many substeps as leave 0.3 of them.
        [TestCase(0.6f, 1)]
        [TestCase(0.61f, 2)]
        [TestCase(1.19f, 2)]
        [TestCase(1.21f, 3)]
        [TestCase(1000f, 16)]
        public void Gravity_stays_small_in_a_substep(float gravityStep, int substeps)
            => Assert.That(SolverSettings.MinSubsteps(gravityStep), Is.EqualTo(substeps));

        // At 20 °C, but for mercury (25 °C) and lava (1200 °C); kg/m³, Pa s, Pa and s. The sources are in Documentation~/editor.md.
        [TestCase("Water", 1000f, 0f, 0f, 1f)]
        [TestCase("Seawater", 1025f, 0f, 0f, 1f)]
        [TestCase("Mercury", 13534f, 0f, 0f, 1f)]
        [TestCase("Olive oil", 910f, 0.084f, 0f, 1f)]
        [TestCase("Glycerol", 1260f, 1.41f, 0f, 1f)]
        [TestCase("Honey", 1420f, 10f, 0f, 1f)]
        [TestCase("Basaltic lava", 2700f, 100f, 0f, 1f)]
        [TestCase("Slime", 1000f, 0f, 300f, 0.5f)]
        [TestCase("Gel", 1000f, 0f, 400f, 1000f)]
        public void A_material_has_the_figures_of_its_fluid(string name, float density, float viscosity, float shearModulus, float relaxationTime)
        {
            FluidMaterial material = name == "Water" ? FluidMaterial.Water : name == "Seawater" ? FluidMaterial.Seawater
                : name == "Mercury" ? FluidMaterial.Mercury : name == "Olive oil" ? FluidMaterial.OliveOil
                : name == "Glycerol" ? FluidMaterial.Glycerol : name == "Honey" ? FluidMaterial.Honey
                : name == "Basaltic lava" ? FluidMaterial.BasalticLava : name == "Slime" ? FluidMaterial.ViscoelasticSlime
                : FluidMaterial.PectinGel;
            Assert.That((material.density, material.dynamicViscosity, material.shearModulus, material.relaxationTime),
                Is.EqualTo((density, viscosity, shearModulus, relaxationTime)));
            bool isHeld = viscosity >= 5f || shearModulus > 0f;
            bool isThin = viscosity == 0f;
            Assert.That((material.allowedTension, material.artificialPressure), Is.EqualTo(isHeld ? (0.05f, 0.1f) : (0f, 0f)));
            Assert.That(material.artificialPressureDistance, Is.EqualTo(0.2f));
            Assert.That((material.wallFriction, material.vorticity), Is.EqualTo((1f, 0f)));
            Assert.That(material.velocitySmoothing, Is.EqualTo(isThin ? 0.01f : 0f));
            Assert.That((material.surfaceTension, material.contactAngle), Is.EqualTo(name == "Mercury" ? (0.485f, 140f) : (0f, 90f)));
        }

        // kg/m³, degrees and Pa: rounded, as tables of soils have them.
        [TestCase("Dry sand", 1600f, 33f, 0f)]
        [TestCase("Damp sand", 1900f, 33f, 1500f)]
        public void Sand_has_the_figures_of_soil_mechanics(string name, float density, float frictionAngle, float cohesion)
        {
            FluidMaterial expected = FluidMaterial.Water;
            (expected.density, expected.frictionAngle, expected.cohesion) = (density, frictionAngle, cohesion);
            Assert.That(name == "Dry sand" ? FluidMaterial.DrySand : FluidMaterial.DampSand, Is.EqualTo(expected));
        }

        // Fractions of ρ d³ / Δt², which is 3.6 N/m at 1 cm and 1/60 s.
        [TestCase(1, true, 0.0)]
        [TestCase(2, false, 0.02)]
        [TestCase(2, true, 0.05)]
        [TestCase(3, false, 0.05)]
        [TestCase(8, true, 0.05)]
        public void No_more_surface_tension_than_this_is_stable(int iterations, bool deepWater, double strength)
        {
            Assert.That(SurfaceTension.MaxStrength(iterations, deepWater), Is.EqualTo(strength));
            Assert.That(FluidMaterial.Water.MaxSurfaceTension(0.01f, 1f / 60f, iterations, deepWater), Is.EqualTo(3.6 * strength).Within(1e-5));
            Assert.That(FluidMaterial.Mercury.MaxSurfaceTension(0.02f, 1f / 120f, iterations, deepWater),
                Is.EqualTo(3.6 * 13.534 * 8.0 * 4.0 * strength).Within(1e-3));
        }

        // Over what as much of the fluid itself would attract.
        [TestCase(180f, 0.0)]
        [TestCase(120f, 0.353553)]
        [TestCase(90f, 0.5)]
        [TestCase(60f, 1.25)]
        [TestCase(30f, 1.799038)]
        [TestCase(0f, 2.0)]
        public void A_wall_attracts_by_the_contact_angle(float angle, double fraction)
            => Assert.That(SurfaceTension.WallFraction(angle), Is.EqualTo(fraction).Within(1e-6));

        [Test]
        public void Settings_begin_as_their_pages_say()
        {
            SolverSettings solver = SolverSettings.Default;
            Assert.That((solver.iterations, solver.relaxation, solver.substeps, solver.softness), Is.EqualTo((4, 0.8f, 1, 1e-3f)));
            Assert.That((solver.listMargin, solver.neighborCapacity, solver.sleepSpeed, solver.numericalDamping), Is.EqualTo((1f, 64, 0f, 1f)));
            Assert.That(solver.deepWater, Is.EqualTo(DeepWater.Automatic));
            SolverBudget budget = SolverBudget.Default;
            Assert.That((budget.mode, budget.milliseconds, budget.fraction, budget.frameRate, budget.targetError),
                Is.EqualTo((BudgetMode.Off, 2f, 0.15f, 60f, 0.005f)));
            Assert.That((budget.minIterations, budget.maxIterations, budget.minSubsteps, budget.maxSubsteps), Is.EqualTo((1, 16, 1, 4)));
            FoamSettings foam = FoamSettings.Default;
            Assert.That((foam.amount, foam.budget, foam.lifetime, foam.kinds, foam.referenceDepth, foam.referenceSpeed),
                Is.EqualTo((1f, 100000, 4f, FoamKinds.All, 0f, 0f)));
        }

        [Test]
        public void Numbers_of_parts_and_of_what_a_fluid_holds_are_those_of_the_manual()
        {
            Assert.That(SolverLayout.MaxCapacity, Is.EqualTo(16777216));
            Assert.That((StepSources.MaxEmitters, StepSources.MaxDrains, StepSources.MaxFields), Is.EqualTo((32, 32, 32)));
            Assert.That((Queries.MaxProbes, Queries.MaxDetectors, Queries.Phases), Is.EqualTo((64, 32, 8)));
            Assert.That((ColliderSet.MaxCount, FoamSettings.MaxBudget, ParticleTransfer.MaxTransfers), Is.EqualTo((256, 4194304, 16)));
            Assert.That(FluidConnection.MinOverlap, Is.EqualTo(4f), "d");
            Assert.That(StatisticsPass.EscapedBeyond, Is.EqualTo(0.1f), "d");
            Assert.That(ForceFields.MaxAcceleration, Is.EqualTo(1000f), "m/s²");
        }

        static void AssertNear(float4 found, double x, double y, double z, double w)
        {
            Assert.That(found.x, Is.EqualTo(x).Within(1e-4).Percent);
            Assert.That(found.y, Is.EqualTo(y).Within(1e-4).Percent);
            Assert.That(found.z, Is.EqualTo(z).Within(1e-4).Percent);
            Assert.That(found.w, Is.EqualTo(w).Within(1e-4).Percent);
        }
    }
}
