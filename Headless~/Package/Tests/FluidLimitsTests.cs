using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Rill;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.TestTools;

namespace Host.Tests
{
    /// <summary>Fluids on devices that grant less than Direct3D 11.</summary>
    public class FluidLimitsTests : GraphicsFixture
    {
        const float FrameTime = 1f / 60f;

        ApiLimits before;

        [SetUp]
        public void Remember() => before = Player.Limits;

        [TearDown]
        public void Restore() => Player.Limits = before;

        static readonly string[] Names = ApiLimits.All.Select(limits => limits.Name).ToArray();
        static readonly string[] Scenes = { "everything off", "viscosity", "deep water in a large box", "particles and domain drawn" };

        static ApiLimits Named(string name) => ApiLimits.All.Single(limits => limits.Name == name);

        static FluidCollider AddCollider(FluidSimulation simulation)
        {
            var collider = new GameObject("Ball").AddComponent<FluidCollider>();
            collider.transform.position = simulation.transform.position;
            return collider;
        }

        static List<string> Problems(FluidSimulation simulation)
        {
            var problems = new List<string>();
            ((IHasProblems)simulation).ListProblems(problems);
            return problems;
        }

        [Test]
        public void A_step_dispatches_what_is_explained_within_each_limits([ValueSource(nameof(Names))] string limits,
            [ValueSource(nameof(Scenes))] string scene)
        {
            Player.Limits = Named(limits);
            FluidSimulation simulation = FluidSceneTests.Build(scene);
            PlayerLoop.Frame(FrameTime);
            List<string> asked = Footprint.Of(() => PlayerLoop.Frame(FrameTime)).Work;
            Assert.That(simulation.IsRunning, Is.True);
            Assert.That(asked, Is.EqualTo(Footprint.Explained(simulation.Results.Describe())));
            Assert.That(Problems(simulation), Is.Empty);
        }

        [Test]
        public void A_collider_that_arrives_on_a_device_too_small_for_it_is_left_out_by_name_and_the_fluid_goes_on()
        {
            Player.Limits = ApiLimits.WebGpu;
            FluidSimulation simulation = FluidSceneTests.Build("everything off");
            PlayerLoop.Frame(FrameTime);
            Assert.That(Problems(simulation), Is.Empty);

            LogAssert.Expect(LogType.Error, new Regex(
                "FluidSimulation 'Fluid' goes on without colliders: kernel '.*' of .*compute takes .* storage buffers, and this device has 8"));
            FluidCollider collider = AddCollider(simulation);
            for (int frame = 0; frame < 3; frame++)
                PlayerLoop.Frame(FrameTime);
            Assert.That(simulation.IsRunning, Is.True);
            Assert.That(Problems(simulation).Single(), Does.StartWith("goes on without colliders: "));

            collider.enabled = false;
            PlayerLoop.Frame(FrameTime);
            Assert.That(Problems(simulation), Is.Empty);
            collider.enabled = true;
            PlayerLoop.Frame(FrameTime);
            Assert.That(Logged.Count(entry => entry.Contains("goes on without")), Is.EqualTo(1), "each feature is logged once");
        }

        [Test]
        public void A_field_that_no_texture_can_hold_is_left_out_by_name_and_other_colliders_are_not()
        {
            Player.Limits = new ApiLimits { Title = "a device without halves to write", Type = ApiLimits.Mobile.Type, WritesSmallTexels = false,
                Threads = 1024, ThreadsZ = 64, GroupsharedBytes = 32768 };
            FluidSimulation simulation = FluidSceneTests.Build("everything off");
            FluidCollider ground = AddCollider(simulation);
            AddCollider(simulation);
            using var heights = new HeightField(new float[2, 2], 1f, 1f);
            ground.Shape = ColliderShape.HeightField;
            ground.Heights = heights;
            LogAssert.Expect(LogType.Error, new Regex("FluidCollider '.*this device \\(.*, Vulkan\\) has no textures of the format RHalf that " +
                "kernels write .*boxes, spheres and capsules"));
            for (int frame = 0; frame < 3; frame++)
                PlayerLoop.Frame(FrameTime);
            Assert.That(simulation.IsRunning, Is.True);
            Assert.That(simulation.Inputs.Colliders.Set.Count, Is.EqualTo(1));
        }

        [Test]
        public void A_surface_whose_mesh_no_texture_can_hold_is_off_by_name_and_the_fluid_goes_on()
        {
            Player.Limits = new ApiLimits { Title = "a device without halves to write", Type = ApiLimits.Mobile.Type, WritesSmallTexels = false,
                Threads = 1024, ThreadsZ = 64, GroupsharedBytes = 32768 };
            FluidSimulation simulation = FluidSceneTests.Build("everything off");
            const string why = " '.*' is off: this device \\(.*, Vulkan\\) has no textures of the format RHalf that kernels write .*Particle " +
                "Renderer";
            LogAssert.Expect(LogType.Error, new Regex("FluidSurface" + why));
            LogAssert.Expect(LogType.Error, new Regex("FluidSurfaceMesh" + why));
            var surface = simulation.gameObject.AddComponent<FluidSurface>();
            var mesh = simulation.gameObject.AddComponent<FluidSurfaceMesh>();
            for (int frame = 0; frame < 3; frame++)
                PlayerLoop.Frame(FrameTime);
            Assert.That(surface.enabled, Is.False);
            Assert.That(mesh.enabled, Is.False);
            Assert.That(simulation.Solver.Surface, Is.Null);
            Assert.That(simulation.StepCount, Is.GreaterThan(0));
        }

        [Test]
        public void What_is_switched_on_later_is_refused_when_it_comes()
        {
            Player.Limits = ApiLimits.WebGpu;
            FluidSimulation simulation = FluidSceneTests.Build("everything off");
            PlayerLoop.Frame(FrameTime);
            LogAssert.Expect(LogType.Error, new Regex("goes on without sleep: "));
            LogAssert.Expect(LogType.Error, new Regex("goes on without elasticity: "));
            SolverSettings settings = simulation.Settings;
            settings.sleepSpeed = 0.02f;
            simulation.Settings = settings;
            PlayerLoop.Frame(FrameTime);
            FluidMaterial material = simulation.Material;
            material.shearModulus = 100f;
            simulation.Material = material;
            PlayerLoop.Frame(FrameTime);
            Assert.That(Problems(simulation).Count, Is.EqualTo(2));
            Assert.That(simulation.IsRunning, Is.True);
        }

        [Test]
        public void Keywords_that_another_fluid_has_left_on_a_shared_shader_are_no_reason_to_refuse()
        {
            FluidSimulation large = FluidSceneTests.Build("sleep in deep water");
            PlayerLoop.Frame(FrameTime);
            ComputeShader shared = StageShader.Find("NeighborSearch").Compute;
            Assert.That(shared.IsKeywordEnabled("RILL_SLEEP"), Is.True, "the fluid that sleeps leaves no keyword");
            large.Paused = true;

            Player.Limits = ApiLimits.WebGpu;
            FluidSimulation small = FluidSceneTests.Build("everything off");
            PlayerLoop.Frame(FrameTime);
            Assert.That(small.IsRunning, Is.True);
            Assert.That(Problems(small), Is.Empty);
            Assert.That(shared.IsKeywordEnabled("RILL_SLEEP"), Is.False, "its step has set its own");
        }

        [Test]
        public void A_kernel_that_Unity_calls_unsupported_is_named_whatever_the_numbers_say()
        {
            Player.Limits = new ApiLimits { Title = "a device without textures", Type = ApiLimits.Mobile.Type, StorageBuffers = 16,
                StorageBuffersInGraphics = 16, Textures = 0, Threads = 1024, ThreadsZ = 64, GroupsharedBytes = 32768 };
            LogAssert.Expect(LogType.Error, new Regex(
                "goes on without colliders: kernel '.*' of Colliders.compute is not supported by this device " +
                "\\(ComputeShader.IsSupported\\)"));
            FluidSimulation simulation = FluidSceneTests.Build("everything off");
            AddCollider(simulation);
            PlayerLoop.Frame(FrameTime);
            Assert.That(simulation.IsRunning, Is.True);
        }

        [Test]
        public void A_device_with_seven_storage_buffers_is_refused_at_start_by_name()
        {
            Player.Limits = new ApiLimits { Title = "a small device", Type = ApiLimits.Mobile.Type, IsHandheld = true, StorageBuffers = 7,
                StorageBuffersInGraphics = 7, Threads = 256, ThreadsZ = 64, GroupsharedBytes = 16384 };
            LogAssert.Expect(LogType.Error, new Regex(
                "'Fluid' is off: kernel '.*' of .* takes 8 storage buffers, and this device has 7 " +
                "\\(SystemInfo.maxComputeBufferInputsCompute\\). Run on"));
            FluidSimulation simulation = FluidSceneTests.Build("everything off");
            PlayerLoop.Frame(FrameTime);
            Assert.That(simulation.IsRunning, Is.False);
            Assert.That(Problems(simulation).Single(), Does.Contain("this device has 7"));
            Assert.That(BufferStorage.Live, Is.Empty);
        }

        [Test]
        public void A_renderer_whose_vertex_stage_reads_no_buffers_there_is_off_by_name_and_the_fluid_runs()
        {
            Player.Limits = new ApiLimits { Title = "OpenGL ES on a Mali", Type = ApiLimits.OpenGlEs31.Type, IsHandheld = true,
                StorageBuffers = 24, StorageBuffersInGraphics = 0, Threads = 256, ThreadsZ = 64, GroupsharedBytes = 16384 };
            LogAssert.Expect(LogType.Error, new Regex(
                "ParticleRenderer '.*' is off: the vertex stage of Particles.shader reads .* storage buffers, and this device has 0 there"));
            FluidSimulation simulation = FluidSceneTests.Build("particles drawn");
            PlayerLoop.Frame(FrameTime);
            Assert.That(simulation.IsRunning, Is.True);
            Assert.That(simulation.GetComponent<ParticleRenderer>().enabled, Is.False);
        }
    }
}
