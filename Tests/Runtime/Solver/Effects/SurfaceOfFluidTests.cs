using System.Collections;
using System.Linq;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>When a fluid finds its surface, and what it costs one that nothing draws.</summary>
    public class SurfaceOfFluidTests
    {
        const float Step = 1f / 60f;

        FluidSimulation fluid;

        // Fluids take their steps when a test asks for them and at no other time.
        [SetUp]
        public void Make()
        {
            Time.timeScale = 0f;
            var gameObject = new GameObject("Fluid");
            gameObject.SetActive(false);
            fluid = gameObject.AddComponent<FluidSimulation>();
            fluid.Configure(new Vector3(1f, 1f, 1f), 0.05f, 1000);
            var volume = new GameObject("Volume").AddComponent<FluidVolume>();
            volume.transform.SetParent(gameObject.transform, false);
            volume.Size = 0.4f * Vector3.one;
            gameObject.SetActive(true);
        }

        [UnityTearDown]
        public IEnumerator LeaveNothing()
        {
            Object.Destroy(fluid.gameObject);
            Time.timeScale = 1f;
            yield return null;
        }

        void Frame(bool draws, float time = Step)
        {
            fluid.Results.Surface.IsNeeded = draws;
            fluid.Advance(time);
        }

        StageDescription Description => fluid.Results.Describe().Single(stage => stage.Name == "Surface particles");

        [Test]
        public void A_fluid_whose_surface_nothing_draws_has_no_buffer_and_no_dispatch_for_it()
        {
            Frame(draws: false);
            Assert.That(fluid.Solver.Surface, Is.Null);
            Assert.That(Description.IsUsed, Is.False);
            Assert.That(Description.Bytes, Is.Zero);
            Assert.That(Description.Kernels, Is.Empty);
        }

        [Test]
        public void The_surface_is_there_from_the_frame_on_that_asks_for_it_with_its_bytes_told()
        {
            Frame(draws: true);
            Assert.That(SurfaceShape.Read(fluid.Solver).Length, Is.EqualTo(8 * 8 * 8 - 6 * 6 * 6), "of the block that the volume fills");
            Assert.That(Description.IsUsed);
            // 32 bytes for each particle and for what covers the walls of 20 x 20 x 20 d, twice 8 for planes, 16 for those of the surface before.
            Assert.That(Description.Bytes, Is.EqualTo(32 * (1000 + 3000) + 32 * 1000 + 12 + 64));
            Assert.That(Description.Kernels.Select(kernel => kernel.kernel), Has.Some.Contains("Estimate").And.Some.Contains("Shape"));
        }

        [Test]
        public void A_paused_fluid_that_is_drawn_for_the_first_time_has_its_surface()
        {
            Frame(draws: false);
            fluid.Paused = true;
            Frame(draws: true);
            Assert.That(fluid.StepCount, Is.EqualTo(1));
            Assert.That(SurfaceShape.Read(fluid.Solver).Max(shape => shape.semiAxes.x), Is.GreaterThan(1.0),
                "made of the neighbors that the step has left");
        }

        [Test]
        public void What_is_added_between_steps_is_drawn_at_once()
        {
            Frame(draws: true);
            fluid.Paused = true;
            int before = SurfaceShape.Read(fluid.Solver).Length;
            using (var positions = new NativeArray<float3>(new[] { new float3(0.4f, 0.4f, 0.4f) }, Allocator.Temp))
            using (var velocities = new NativeArray<float3>(1, Allocator.Temp))
                fluid.AddParticles(positions, velocities);
            Frame(draws: true);
            Assert.That(SurfaceShape.Read(fluid.Solver).Length, Is.EqualTo(before + 1));
        }

        [Test]
        public void What_is_removed_between_steps_leaves_numbers_to_draw_also_where_the_surface_is_found_again()
        {
            Frame(draws: true);
            fluid.Paused = true;
            int before = SurfaceShape.Read(fluid.Solver).Length;
            ParticleState state = TestFluid.Read(fluid.Solver);
            Vector3 center = fluid.DomainToWorld.MultiplyPoint3x4(state.positions.Aggregate(float4.zero, (sum, p) => sum + p / state.Count).xyz);
            fluid.RemoveInside(FluidShape.Sphere(center + 2f * fluid.ParticleSpacing * Vector3.up, 3f * fluid.ParticleSpacing));
            Frame(draws: true);
            Assert.That(SurfaceShape.Read(fluid.Solver).Length, Is.EqualTo(before), "as it was, until the next step");
            using (var positions = new NativeArray<float3>(new[] { new float3(0.4f, 0.4f, 0.4f) }, Allocator.Temp))
            using (var velocities = new NativeArray<float3>(1, Allocator.Temp))
                fluid.AddParticles(positions, velocities);
            Frame(draws: true);
            int left = TestFluid.Read(fluid.Solver).positions.Count(p => math.all(math.isfinite(p.xyz)));
            Assert.That(left, Is.InRange(350, 480));
            Assert.That(SurfaceShape.Read(fluid.Solver).Length, Is.EqualTo(left), "drops");
            Assert.That(SurfaceShape.Read(fluid.Solver).All(shape => math.all(math.isfinite(shape.center))
                && math.all(math.isfinite(shape.semiAxes))));
        }

        [Test]
        public void A_restart_brings_the_surface_of_what_is_filled_in_again()
        {
            for (int frame = 0; frame < 20; frame++)
                Frame(draws: true);
            fluid.Paused = true;
            fluid.Restart();
            Frame(draws: true);
            Assert.That(SurfaceShape.Read(fluid.Solver).Length, Is.EqualTo(512), "spheres, before the first step");
        }

        [Test]
        public void A_frame_without_a_step_keeps_the_surface_as_it_is()
        {
            Frame(draws: true);
            GpuTest.FillWithGarbage(fluid.Solver.Surface.Particles);
            Frame(draws: true, time: 0f);
            Assert.That(GpuTest.Read<uint4>(fluid.Solver.Surface.Particles, 2)[0].x, Is.EqualTo(GpuTest.Garbage), "nothing is written again");
            Frame(draws: true);
            Assert.That(GpuTest.Read<uint4>(fluid.Solver.Surface.Particles, 2)[0].x, Is.Not.EqualTo(GpuTest.Garbage));
        }

        [Test]
        public void What_nothing_draws_any_more_is_given_back_after_a_while()
        {
            Frame(draws: true);
            for (int frame = 0; frame < 29; frame++)
                Frame(draws: false);
            Assert.That(fluid.Solver.Surface, Is.Not.Null, "a camera may look away for a moment");
            Frame(draws: false);
            Assert.That(fluid.Solver.Surface, Is.Null);
            Frame(draws: true);
            Assert.That(fluid.Solver.Surface, Is.Not.Null);
        }

        [Test, Category("LongRun")]
        public void Statistics_in_the_same_frame_change_nothing_of_it()
        {
            SolverSettings settings = fluid.Settings;
            settings.sleepSpeed = 1f;
            fluid.Settings = settings;
            fluid.StatisticsInterval = 0;
            for (int frame = 0; frame < 200; frame++)
                Frame(draws: true);
            SurfaceShape[] without = SurfaceShape.Read(fluid.Solver);
            fluid.StatisticsInterval = 1;
            Frame(draws: true);
            Assert.That(GpuTest.Read<uint>(fluid.Solver.Resting.States, 27), Is.All.Zero, "asleep: the cells of the sort are walked");
            // But for the last of the mean over time.
            SurfaceShape[] with = SurfaceShape.Read(fluid.Solver);
            Assert.That(with.Select(shape => shape.particle), Is.EqualTo(without.Select(shape => shape.particle)));
            Assert.That(with.Zip(without, (a, b) => math.distance(a.center, b.center)), Is.All.LessThan(1e-3));
        }
    }
}
