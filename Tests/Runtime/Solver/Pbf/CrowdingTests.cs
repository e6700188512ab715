using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>Particles nearer to each other than a fluid can be, with the correction for deep water and without.</summary>
    [Category("LongRun")]
    public class CrowdingTests
    {
        const float Spacing = 0.05f;

        [Test]
        public void Pairs_in_one_place_far_from_all_others_come_apart([Values(DeepWater.On, DeepWater.Off)] DeepWater deepWater)
        {
            float3[] positions = Enumerable.Range(0, 27).Select(i => (3f + 4f * new float3(i % 3, i / 3 % 3, i / 9)) * Spacing).ToArray();
            using (var fluid = new TestFluid(14f * Spacing, Spacing, 54, Settings(deepWater)).Add(positions).Add(positions))
            {
                fluid.Input.gravity = 0f;
                Assert.That(fluid.Measure().coincident, Is.EqualTo(54));
                FluidStatistics statistics = fluid.Step(10).MeasureWhole();
                Assert.That(statistics.coincident, Is.Zero);
                // Twice what the passes of one step add to a pair that begins with all it lacks, and no push by the constraint.
                Assert.That(statistics.speedMax, Is.InRange(1e-3f, 0.2f * Spacing * 60f));
                Assert.That(math.length(statistics.momentum), Is.LessThan(1e-4f));
            }
        }

        [Test]
        public void Pairs_in_one_place_in_still_water_come_apart([Values(DeepWater.On, DeepWater.Off)] DeepWater deepWater)
        {
            using (var fluid = new TestFluid(new float3(8f, 16f, 8f) * Spacing, Spacing, 500, Settings(deepWater))
                .AddBlock(0f, new float3(8f, 6f, 8f) * Spacing))
            {
                fluid.Add(fluid.Read().positions.Where((_, i) => i % 8 == 0).Select(p => p.xyz * Spacing).ToArray());
                FluidStatistics statistics = fluid.Step(60).MeasureWhole();
                Assert.That(statistics.coincident, Is.Zero);
                Assert.That(statistics.densityError999, Is.LessThan(0.2f));
            }
        }

        [Test]
        public void A_block_at_eight_times_the_density_comes_apart_without_an_explosion([Values(DeepWater.On, DeepWater.Off)] DeepWater deepWater)
        {
            float3[] positions = Enumerable.Range(0, 512).Select(i => (8f + 0.5f * new float3(i % 8, i / 8 % 8, i / 64)) * Spacing).ToArray();
            using (var fluid = new TestFluid(20f * Spacing, Spacing, 512, Settings(deepWater)).Add(positions))
            {
                fluid.Input.gravity = 0f;
                float fastest = 0f;
                for (int part = 0; part < 10; part++)
                    fastest = math.max(fastest, fluid.Step(3).MeasureWhole().speedMax);
                FluidStatistics statistics = fluid.Measure();
                TestContext.Out.WriteLine(
                    $"speed at most {fastest:0.0} m/s, p99.9 {statistics.densityError999:0.000}, coincident {statistics.coincident}");
                Assert.That(fastest, Is.LessThan(LimitOfTwoSteps(fluid)));
                Assert.That(statistics.densityError999, Is.LessThan(0.1f));
                Assert.That(statistics.coincident, Is.Zero);
            }
        }

        [Test]
        public void A_thousand_particles_in_one_cell_overflow_the_lists_are_reported_and_recover(
            [Values(DeepWater.On, DeepWater.Off)] DeepWater deepWater)
        {
            var random = new Random(3);
            float3[] positions = Enumerable.Range(0, 1000).Select(_ => (10f + random.NextFloat3()) * Spacing).ToArray();
            using (var fluid = new TestFluid(20f * Spacing, Spacing, 1000, Settings(deepWater)).Add(positions))
            {
                FluidStatistics first = fluid.Step().MeasureWhole();
                Assert.That(first.neighborOverflow, Is.EqualTo(1000));
                Assert.That(first.neighborOverflowMax, Is.EqualTo(999));
                FluidStatistics last = fluid.Step(60).MeasureWhole();
                Assert.That(last.neighborOverflow, Is.Zero);
                Assert.That(last.neighborOverflowMax, Is.Zero);
                Assert.That(last.densityError999, Is.LessThan(0.2f));
            }
        }

        // 25 layers where 20 fit.
        [Test]
        public void A_closed_box_with_too_many_particles_shares_the_error_among_all_and_calms_down(
            [Values(DeepWater.On, DeepWater.Off)] DeepWater deepWater)
        {
            float3[] positions = Enumerable.Range(0, 6 * 25 * 6)
                .Select(i => (new float3(i % 6, i / 6 % 25 * 0.8f, i / 150) + new float3(0.5f, 0.4f, 0.5f)) * Spacing).ToArray();
            using (var fluid = new TestFluid(new float3(6f, 20f, 6f) * Spacing, Spacing, positions.Length, Settings(deepWater)).Add(positions))
            {
                FluidStatistics statistics = fluid.Step(60).MeasureWhole();
                TestContext.Out.WriteLine(
                    $"C+ {statistics.densityError:0.000}, p99.9 {statistics.densityError999:0.000}, jitter {statistics.jitter:0.000} m/s");
                Assert.That(statistics.densityError, Is.InRange(0.2f, 0.32f));
                Assert.That(statistics.densityError999, Is.LessThan(2f * statistics.densityError));
                Assert.That(statistics.jitter, Is.LessThan(0.1f));
                if (deepWater == DeepWater.On)
                    Assert.That(statistics.volumeRatio, Is.EqualTo(0.8f).Within(0.02f));
            }
        }

        // 60 layers where 50 fit: the water is under pressure up to the lid and does not fall off it.
        [Test]
        public void A_deep_closed_box_with_too_many_particles_is_as_calm_as_an_open_one()
        {
            using (TestFluid fluid = OverfullBox(8, 60))
            {
                FluidStatistics statistics = fluid.Step(120).MeasureWhole();
                TestContext.Out.WriteLine(
                    $"C+ {statistics.densityError:0.000}, p99.9 {statistics.densityError999:0.000}, jitter {statistics.jitter:0.000} m/s");
                Assert.That(statistics.densityError, Is.InRange(0.1f, 0.26f));
                Assert.That(statistics.densityError999, Is.LessThan(1.5f * statistics.densityError));
                Assert.That(statistics.jitter, Is.LessThan(0.045f));
            }
        }

        [TestCase(51)]
        [TestCase(60)]
        public void Such_a_box_comes_to_rest(int layers)
        {
            using (TestFluid fluid = OverfullBox(12, layers))
            {
                float jitter = 0f;
                fluid.Step(200);
                for (int part = 0; part < 8; part++)
                    jitter += fluid.Step(5).Measure().jitter / 8f;
                TestContext.Out.WriteLine($"jitter {jitter:0.0000} m/s");
                Assert.That(jitter, Is.LessThan(0.01f));
            }
        }

        // In the corners of a box at an angle are cells of the coarse grid with little room, few particles and hardly an open face. What its walls
        // push around there must not throw the water about, which at rest in the box moves at 1.2 m/s. Beside the wall of a ball are coarser
        // cells without water, which are not a surface either.
        [TestCase(ColliderShape.Box, 3f, 3f)]
        [TestCase(ColliderShape.Sphere, 0f, 0.5f)]
        public void A_vessel_that_holds_a_fifth_too_much_does_not_burst(ColliderShape shape, float turning, float fastest)
        {
            const float half = 11f;
            RigidPose Pose(float time) => new RigidPose(20f, quaternion.Euler(0.3f + turning * time, 0.4f, 0.5f + 0.1f * turning * time));
            quaternion back = math.conjugate(Pose(0f).rotation);
            float pitch = math.pow(1.2f, -1f / 3f);
            float3[] positions = Enumerable.Range(0, 43 * 43 * 43).Select(i => (new float3(i % 43, i / 43 % 43, i / (43 * 43)) - 21f) * pitch)
                .Where(p => (shape == ColliderShape.Box ? math.cmax(math.abs(math.mul(back, p))) : math.length(p)) < half - 0.45f)
                .Select(p => (p + 20f) * Spacing).ToArray();
            ColliderMotion vessel = ColliderTests.Still(shape, half, 20f, quaternion.identity);
            vessel.insideOut = true;
            vessel.end = Pose(0f);
            SolverSettings settings = Settings(DeepWater.On);
            settings.iterations = 2;
            using (TestFluid fluid = new TestFluid(40f * Spacing, Spacing, positions.Length, settings).Add(positions))
            {
                float speed = 0f;
                for (int step = 1; step <= 60; step++)
                {
                    vessel.start = vessel.end;
                    vessel.end = Pose(step * fluid.Input.timeStep);
                    ColliderTests.Use(fluid, vessel);
                    fluid.Step();
                    if (step % 10 == 0)
                        speed = math.max(speed, fluid.Measure().speed);
                }
                TestContext.Out.WriteLine($"{positions.Length} particles, mean speed at most {speed:0.00} m/s");
                Assert.That(speed, Is.LessThan(fastest));
            }
        }

        // Has room for 50 layers.
        static TestFluid OverfullBox(int side, int layers)
        {
            float3[] positions = Enumerable.Range(0, side * layers * side)
                .Select(i => (new float3(i % side, i / side % layers, i / (side * layers)) + 0.5f) * new float3(1f, 50f / layers, 1f) * Spacing)
                .ToArray();
            SolverSettings settings = Settings(DeepWater.On);
            settings.iterations = 2;
            return new TestFluid(new float3(side, 50f, side) * Spacing, Spacing, positions.Length, settings).Add(positions);
        }

        // m/s: each pass moves a particle half a spacing at most, the grid's density correction two spacings.
        static float LimitOfTwoSteps(TestFluid fluid)
        {
            SolverSettings settings = fluid.Input.settings;
            return 2f * (0.5f * settings.iterations + (settings.deepWater == DeepWater.On ? 2f : 0f)) * Spacing * 60f;
        }

        static SolverSettings Settings(DeepWater deepWater)
        {
            SolverSettings settings = SolverSettings.Default;
            settings.deepWater = deepWater;
            return settings;
        }
    }
}
