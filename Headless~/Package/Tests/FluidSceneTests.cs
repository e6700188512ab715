using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Rill;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.SceneManagement;
using UnityEngine.TestTools;

namespace Host.Tests
{
    /// <summary>Compares the package's own figures with the work of the device and the memory that is alive.</summary>
    public class FluidSceneTests : GraphicsFixture
    {
        const float FrameTime = 1f / 60f;

        static readonly (string Name, Action<FluidSimulation> Change, bool Particles, bool Domain)[] Scenes =
        {
            ("everything off", Both(WithDeepWater((ref SolverSettings s) => s.deepWater = DeepWater.Off),
                WithMaterial((ref FluidMaterial m) => { })), false, false),
            ("viscosity", WithMaterial((ref FluidMaterial m) => m.velocitySmoothing = 0.01f), false, false),
            ("vorticity", WithMaterial((ref FluidMaterial m) => m.vorticity = 1f), false, false),
            ("dynamic viscosity", WithMaterial((ref FluidMaterial m) => m.dynamicViscosity = 10f), false, false),
            ("dynamic viscosity and sleep in deep water, two substeps",
                Both(WithDeepWater((ref SolverSettings s) => { s.sleepSpeed = 0.02f; s.substeps = 2; }),
                WithMaterial((ref FluidMaterial m) => m.dynamicViscosity = 10f)), false, false),
            ("grains", WithMaterial((ref FluidMaterial m) => (m.frictionAngle, m.cohesion) = (30f, 100f)), false, false),
            ("viscous grains that sleep, two substeps", Both(WithDeepWater((ref SolverSettings s) => { s.sleepSpeed = 0.02f; s.substeps = 2; }),
                WithMaterial((ref FluidMaterial m) => (m.frictionAngle, m.dynamicViscosity) = (30f, 10f))), false, false),
            ("contacts", WithMaterial((ref FluidMaterial m) => m.contacts = true), false, false),
            ("contacts of two materials that sleep, two substeps",
                Both(WithDeepWater((ref SolverSettings s) => { s.sleepSpeed = 0.02f; s.substeps = 2; }),
                Both(s => s.PhaseMaterials = new[] { FluidMaterialAsset.Create("Cork", 500f) },
                WithMaterial((ref FluidMaterial m) => (m.contacts, m.surfaceTension, m.frictionAngle) = (true, 1f, 30f)))), false, false),
            ("elasticity", WithMaterial((ref FluidMaterial m) => m.shearModulus = 100f), false, false),
            ("elasticity and sleep in deep water, two substeps",
                Both(WithDeepWater((ref SolverSettings s) => { s.sleepSpeed = 0.02f; s.substeps = 2; }),
                WithMaterial((ref FluidMaterial m) => m.shearModulus = 100f)), false, false),
            ("artificial pressure", WithMaterial((ref FluidMaterial m) => m.artificialPressure = 0.1f), false, false),
            ("surface tension", WithMaterial((ref FluidMaterial m) => m.surfaceTension = 1f), false, false),
            ("surface tension beside one iteration", Both(s => s.Settings = WithCounts(s.Settings, substeps: 1, iterations: 1),
                WithMaterial((ref FluidMaterial m) => m.surfaceTension = 1f)), false, false),
            ("surface tension of deep water that sleeps", Both(WithDeepWater((ref SolverSettings s) => s.sleepSpeed = 0.02f),
                WithMaterial((ref FluidMaterial m) => m.surfaceTension = 1f)), false, false),
            ("two liquids", s => s.PhaseMaterials = new[] { FluidMaterialAsset.Create("Oil", 500f) }, false, false),
            ("two liquids that mix", s =>
            {
                s.PhaseMaterials = new[] { FluidMaterialAsset.Create("Dye", 1000f) };
                s.MaterialPairs = new[] { FluidMaterialPair.Mixing(null, s.PhaseMaterials[0], 0.001f) };
            }, false, false),
            ("two liquids of different densities that mix and sleep, two substeps",
                Both(WithDeepWater((ref SolverSettings s) => { s.sleepSpeed = 0.02f; s.substeps = 2; }), s =>
            {
                s.PhaseMaterials = new[] { FluidMaterialAsset.Create("Spirit", 800f) };
                s.MaterialPairs = new[] { FluidMaterialPair.Mixing(s.PhaseMaterials[0], null, 0.001f) };
            }), false, false),
            ("two viscous liquids in deep water that sleeps",
                Both(WithDeepWater((ref SolverSettings s) => { s.sleepSpeed = 0.02f; s.substeps = 2; }),
                s => s.PhaseMaterials = new[] { FluidMaterialAsset.Create("Oil", 20f, 1f) }), false, false),
            ("two liquids with surface tension, less damping",
                Both(s => s.PhaseMaterials = new[] { FluidMaterialAsset.Create("Oil", 500f) },
                Both(s => s.Settings = WithDamping(s.Settings), WithMaterial((ref FluidMaterial m) => m.surfaceTension = 1f))), false, false),
            ("three substeps of one iteration", s => s.Settings = WithCounts(s.Settings, substeps: 3, iterations: 1), false, false),
            ("deep water", WithDeepWater((ref SolverSettings s) => { }), false, false),
            ("deep water, one iteration", WithDeepWater((ref SolverSettings s) => s.iterations = 1), false, false),
            ("deep water, three substeps", WithDeepWater((ref SolverSettings s) => s.substeps = 3), false, false),
            ("deep water and artificial pressure",
                Both(WithDeepWater((ref SolverSettings s) => { }), WithMaterial((ref FluidMaterial m) => m.artificialPressure = 0.1f)),
                false, false),
            ("deep water in a large box", Both(WithDeepWater((ref SolverSettings s) => { }),
                s => s.Configure(new Vector3(12f, 12f, 12f), 0.1f, 600)), false, false),
            ("sleep in deep water", WithDeepWater((ref SolverSettings s) => s.sleepSpeed = 0.02f), false, false),
            ("less damping", s => s.Settings = WithDamping(s.Settings), false, false),
            ("less damping of water with vorticity",
                Both(s => s.Settings = WithDamping(s.Settings), WithMaterial((ref FluidMaterial m) => m.vorticity = 1f)), false, false),
            ("less damping of deep water that sleeps, two substeps",
                Both(s => s.Settings = WithDamping(s.Settings),
                WithDeepWater((ref SolverSettings s) => { s.sleepSpeed = 0.02f; s.substeps = 2; })), false, false),
            ("particles drawn", s => { }, true, false),
            ("particles and domain drawn", s => { }, true, true),
        };

        public static IEnumerable<string> SceneNames => Scenes.Select(scene => scene.Name);

        [TestCaseSource(nameof(SceneNames))]
        public void A_step_dispatches_what_is_explained_and_nothing_else(string name)
        {
            FluidSimulation simulation = Build(name);
            PlayerLoop.Frame(FrameTime);

            List<string> asked = Footprint.Of(() => PlayerLoop.Frame(FrameTime)).Work;

            Assert.That(asked, Is.EqualTo(Footprint.Explained(simulation.Results.Describe())));
        }

        [TestCaseSource(nameof(SceneNames))]
        public void The_buffers_alive_are_those_explained(string name)
        {
            FluidSimulation simulation = Build(name);
            PlayerLoop.Frame(FrameTime);
            PlayerLoop.Frame(FrameTime);

            var alive = BufferStorage.Live.Select(buffer => $"{buffer.Name} {buffer.Bytes}").OrderBy(entry => entry);
            var explained = simulation.Results.Describe().SelectMany(stage => stage.Buffers).Select(buffer => $"{buffer.name} {buffer.bytes}")
                .OrderBy(entry => entry);
            Assert.That(alive, Is.EqualTo(explained));
        }

        [Test]
        public void A_stage_that_is_off_has_no_kernel_and_no_buffer()
        {
            FluidSimulation simulation = Build("everything off");
            PlayerLoop.Frame(FrameTime);
            List<StageDescription> off = simulation.Results.Describe().Where(stage => !stage.IsUsed).ToList();
            Assert.That(off.Select(stage => stage.Name),
                Is.EquivalentTo(new[] { "Particle access", "Drains", "Transfer", "Resting regions", "Force fields", "Borders",
                "Coarse correction", "Colliders", "Particle tags", "Materials", "Implicit viscosity", "Grain friction", "Contacts", "Viscoelasticity",
                "Velocity extrapolation", "Vorticity confinement", "Diffusion", "Foam", "Smoke", "Emitters", "Queries",
                "Query batches", "Recording", "Statistics", "Surface particles", "Surface mesh", "Budget", "Rendering" }));
            Assert.That(off.SelectMany(stage => stage.Kernels), Is.Empty);
            Assert.That(off.SelectMany(stage => stage.Buffers), Is.Empty);
        }

        [Test]
        public void Deep_water_takes_buffers_and_kernels_only_while_it_is_on()
        {
            FluidSimulation simulation = Build("deep water in a large box");
            PlayerLoop.Frame(FrameTime);
            StageDescription stage = simulation.Results.Describe().Single(s => s.Name == "Coarse correction");
            Assert.That(stage.Kernels.Select(kernel => kernel.kernel), Has.Member("CoarseSolver.compute: SmoothLevel"),
                "a box with levels above the tail");

            SolverSettings settings = simulation.Settings;
            settings.deepWater = DeepWater.Off;
            simulation.Settings = settings;
            PlayerLoop.Frame(FrameTime);
            Assert.That(BufferStorage.Live.Select(buffer => buffer.Name), Has.None.Contains("Coarse"));
            GpuWork.Log = new List<string>();
            PlayerLoop.Frame(FrameTime);
            List<string> asked = GpuWork.Log;
            GpuWork.Log = null;
            Assert.That(asked, Is.Not.Empty.And.None.Contains("Coarse").And.None.Contains("Deep"));

            settings.deepWater = DeepWater.On;
            simulation.Settings = settings;
            for (int i = 0; i < 3; i++)
                PlayerLoop.Frame(FrameTime);
            Assert.That(BufferStorage.Live.Count(buffer => buffer.Name.Contains("Rill.Coarse")), Is.EqualTo(stage.Buffers.Count));
        }

        [Test]
        public void Measuring_takes_buffers_only_while_it_is_on()
        {
            FluidSimulation simulation = Build("everything off");
            simulation.StatisticsInterval = 1;
            for (int i = 0; i < 6; i++)
                PlayerLoop.Frame(FrameTime);
            Assert.That(simulation.TryGetStatistics(out FluidStatistics statistics), Is.True);
            Assert.That(statistics.particles, Is.EqualTo(512));
            Assert.That(BufferStorage.Live.Select(buffer => buffer.Name), Has.Member("Rill.Statistics.Results"));

            simulation.StatisticsInterval = 0;
            PlayerLoop.Frame(FrameTime);
            Assert.That(BufferStorage.Live.Select(buffer => buffer.Name), Has.No.Member("Rill.Statistics.Results"));
        }

        [Test]
        public void Twenty_cycles_of_enabling_leave_nothing_alive()
        {
            FluidSimulation simulation = Build("particles and domain drawn");
            simulation.KeepStateOnDisable = false;
            PlayerLoop.Frame(FrameTime);
            simulation.gameObject.SetActive(false);
            PlayerLoop.Frame(FrameTime);
            int idle = LiveObjects.Count;
            Assert.That(BufferStorage.Live, Is.Empty);
            for (int i = 0; i < 20; i++)
            {
                simulation.gameObject.SetActive(true);
                PlayerLoop.Frame(FrameTime);
                Assert.That(BufferStorage.Live, Is.Not.Empty);
                simulation.gameObject.SetActive(false);
                PlayerLoop.Frame(FrameTime);
                Assert.That(BufferStorage.Live, Is.Empty, $"cycle {i}");
                Assert.That(LiveObjects.Count, Is.EqualTo(idle), $"cycle {i}: " + string.Join(", ", LiveObjects.Report()));
            }
        }

        [Test]
        public void Loading_a_sample_scene_again_leaves_one_set_of_objects_and_unloading_it_none()
        {
            using (var sample = new SampleScene("Column"))
            {
                PlayerLoop.Frame(FrameTime);
                List<string> once = LiveObjects.Report();
                Assert.That(once.Count(entry => entry.Contains("Rill.PositionsA")), Is.EqualTo(1));

                sample.Load();
                PlayerLoop.Frame(FrameTime);
                Assert.That(LiveObjects.Report(), Is.EquivalentTo(once));

                SceneManager.UnloadEverything();
                Assert.That(BufferStorage.Live, Is.Empty);
            }
        }

        [Test]
        public void A_machine_without_compute_shaders_is_told_and_the_scene_goes_on()
        {
            LogAssert.Expect(LogType.Error, new Regex("'Fluid' is off: this device .* has no compute shaders.*Run on"));
            Player.PretendNoCompute = true;
            FluidSimulation simulation = Build("particles drawn");
            PlayerLoop.Frame(FrameTime);
            Player.PretendNoCompute = false;
            Assert.That(simulation.IsRunning, Is.False);
            Assert.That(Logged.Count(entry => entry.Contains("no compute shaders")), Is.EqualTo(1), string.Join("\n", Logged));
            Assert.That(BufferStorage.Live, Is.Empty);
        }

        delegate void MaterialChange(ref FluidMaterial material);

        static Action<FluidSimulation> WithMaterial(MaterialChange change) => simulation =>
        {
            FluidMaterial material = simulation.Material;
            material.velocitySmoothing = 0f;
            change(ref material);
            simulation.Material = material;
        };

        delegate void SettingsChange(ref SolverSettings settings);

        static Action<FluidSimulation> WithDeepWater(SettingsChange change) => simulation =>
        {
            SolverSettings settings = simulation.Settings;
            settings.deepWater = DeepWater.On;
            change(ref settings);
            simulation.Settings = settings;
        };

        static Action<FluidSimulation> Both(Action<FluidSimulation> first, Action<FluidSimulation> second) => first + second;

        static SolverSettings WithDamping(SolverSettings settings)
        {
            settings.numericalDamping = 0.5f;
            return settings;
        }

        static SolverSettings WithCounts(SolverSettings settings, int substeps, int iterations)
        {
            settings.substeps = substeps;
            settings.iterations = iterations;
            return settings;
        }

        // 8 x 8 x 8 particles in the center of a box, seen by a camera, measured never.
        internal static FluidSimulation Build(string name)
        {
            var scene = Scenes.Single(candidate => candidate.Name == name);
            var fluid = new GameObject("Fluid");
            fluid.SetActive(false);
            var simulation = fluid.AddComponent<FluidSimulation>();
            simulation.Configure(new Vector3(1.6f, 1.6f, 1.6f), 0.1f, 600);
            simulation.StatisticsInterval = 0;
            scene.Change(simulation);
            fluid.AddComponent<FluidVolume>().Size = new Vector3(0.8f, 0.8f, 0.8f);
            if (scene.Particles)
            {
                fluid.AddComponent<ParticleRenderer>();
                new GameObject("Camera").AddComponent<Camera>().transform.position = new Vector3(0f, 0f, -4f);
            }
            if (scene.Domain)
                fluid.AddComponent<DomainRenderer>();
            fluid.SetActive(true);
            return simulation;
        }
    }
}
