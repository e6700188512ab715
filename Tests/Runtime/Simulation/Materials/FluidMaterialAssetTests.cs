using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using NUnit.Framework.Constraints;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>Liquids of several materials in one fluid: of emitters, volumes, scripts and the list of the fluid.</summary>
    public class FluidMaterialAssetTests
    {
        const float Spacing = 0.05f;
        static readonly Vector3 Box = new Vector3(1f, 1f, 1f);

        readonly List<FluidMaterialAsset> made = new List<FluidMaterialAsset>();

        [TearDown]
        public void Destroy()
        {
            foreach (FluidMaterialAsset material in made)
                Object.DestroyImmediate(material);
            made.Clear();
        }

        FluidMaterialAsset Material(string name, float density, float viscosity = 0f)
        {
            FluidMaterialAsset material = FluidMaterialAsset.Create(name, density, viscosity);
            made.Add(material);
            return material;
        }

        static uint[] Phases(SourceScene scene)
            => GpuTest.Read<uint>(scene.Fluid.Solver.Tags, scene.Read().Count).Select(tag => tag >> ParticleTags.PhaseShift).ToArray();

        static FluidVolume AddVolume(SourceScene scene, Vector3 size, Vector3 position, FluidMaterialAsset material)
        {
            FluidVolume volume = new GameObject("Volume").AddComponent<FluidVolume>();
            volume.transform.SetParent(scene.Fluid.transform, false);
            volume.transform.position = position;
            volume.Size = size;
            volume.Material = material;
            return volume;
        }

        [Test]
        public void Emitters_volumes_and_scripts_give_particles_the_phase_of_their_material()
        {
            FluidMaterialAsset oil = Material("Oil", 900f, 0.08f), honey = Material("Honey", 1400f), tar = Material("Tar", 1100f);
            using (var scene = new SourceScene(Box, Spacing, 3000))
            {
                scene.Fluid.PhaseMaterials = new[] { oil };
                AddVolume(scene, new Vector3(0.5f, 0.1f, 0.5f), new Vector3(0f, -0.45f, 0f), honey);
                scene.Fluid.Restart();
                scene.Add<FluidEmitter>(new Vector3(0f, 0.4f, 0f), Vector3.down, e => (e.Rate, e.Radius, e.Material) = (0.01f, 0.15f, oil));
                scene.Step(10);
                scene.Fluid.Fill(FluidShape.Box(new Vector3(0.3f, 0f, 0.3f), new Vector3(0.2f, 0.2f, 0.2f)), Vector3.zero, tar);
                scene.Step();
                Assert.That(scene.Fluid.PhaseOf(oil), Is.EqualTo(1));
                Assert.That(scene.Fluid.PhaseOf(honey), Is.EqualTo(2));
                Assert.That(scene.Fluid.PhaseOf(tar), Is.EqualTo(3));
                Assert.That(Phases(scene).Distinct(), Is.EquivalentTo(new[] { 1u, 2u, 3u }));
                Assert.That(Phases(scene).Count(phase => phase == 2), Is.EqualTo(200));
            }
        }

        [Test]
        public void A_volume_fills_a_running_fluid_with_its_material_and_else_with_the_phase_that_is_asked_for()
        {
            using (var scene = new SourceScene(Box, Spacing, 3000))
            {
                FluidVolume oil = AddVolume(scene, new Vector3(0.2f, 0.2f, 0.2f), new Vector3(0f, -0.3f, 0f), Material("Oil", 900f));
                FluidVolume other = AddVolume(scene, new Vector3(0.2f, 0.2f, 0.2f), new Vector3(0f, 0.3f, 0f), null);
                scene.Fluid.Fill(oil);
                scene.Fluid.Fill(other, phase: 3);
                scene.Step();
                Assert.That(Phases(scene).Count(phase => phase == 1), Is.EqualTo(64), "of the material");
                Assert.That(Phases(scene).Count(phase => phase == 3), Is.EqualTo(64));
                Assert.That(Phases(scene).Length, Is.EqualTo(128));
            }
        }

        [Test]
        public void A_phase_that_an_emitter_names_by_its_number_is_left_to_it()
        {
            using (var scene = new SourceScene(Box, Spacing, 100))
            {
                scene.Add<FluidEmitter>(Vector3.zero, Vector3.down, e => e.Phase = 1);
                Assert.That(scene.Fluid.PhaseOf(Material("Oil", 900f)), Is.EqualTo(2));
            }
        }

        [Test]
        public void An_eighth_material_is_refused_by_name_and_the_seven_go_on()
        {
            using (var scene = new SourceScene(Box, Spacing, 100))
            {
                for (int i = 1; i < PhaseMaterials.Phases; i++)
                    Assert.That(scene.Fluid.PhaseOf(Material($"Liquid {i}", 800f + i)), Is.EqualTo(i));
                LogAssert.Expect(LogType.Warning, new Regex("FluidSimulation 'Fluid': it has no phase left for the material 'Lava', and uses " +
                    "its own instead: a fluid holds 7 materials besides its own, and has 'Liquid 1', 'Liquid 2'"));
                FluidMaterialAsset lava = Material("Lava", 2500f);
                Assert.That(scene.Fluid.PhaseOf(lava), Is.Zero);
                Assert.That(scene.Fluid.PhaseOf(lava), Is.Zero);      // and is logged once
                Assert.That(scene.Fluid.PhaseOf(made[3]), Is.EqualTo(4));
                Assert.That(ProblemsOf(scene.Fluid), Has.Some.Contains("'Lava'"));
                BeginAgain(scene.Fluid);
                Assert.That(ProblemsOf(scene.Fluid), Is.Empty);
                for (int i = 1; i < PhaseMaterials.Phases; i++)
                    scene.Fluid.PhaseOf(made[i - 1]);
                LogAssert.Expect(LogType.Warning, new Regex("no phase left for the material 'Lava'"));
                scene.Fluid.PhaseOf(lava);
            }
        }

        [Test]
        public void A_build_has_what_the_materials_of_volumes_and_emitters_need()
        {
            bool HasViscosity(IUsesFeatures part) => part.UsedFeatures.HasAll(Features.Materials | Features.Viscosity);
            using (var scene = new SourceScene(Box, Spacing, 100))
            {
                FluidEmitter emitter = scene.Add<FluidEmitter>(Vector3.zero, Vector3.down);
                Assert.That(HasViscosity(scene.Fluid) || HasViscosity(emitter), Is.False);
                AddVolume(scene, Vector3.one, Vector3.zero, Material("Honey", 1400f, 10f));
                Assert.That(HasViscosity(scene.Fluid));
                emitter.Material = Material("Oil", 900f, 0.08f);
                Assert.That(HasViscosity(emitter));
                FluidMaterialAsset sand = Material("Sand", 1600f, 0f);
                sand.Cohesion = 100f;
                emitter.Material = sand;
                Assert.That(((IUsesFeatures)emitter).UsedFeatures.HasAll(Features.Materials | Features.GrainFriction | Features.DeepWater));
                Assert.That(((IUsesFeatures)scene.Fluid).UsedFeatures.Has(Features.Diffusion), Is.False);
                FluidMaterialAsset dye = Material("Dye", 1000f);       // which a script brings
                scene.Fluid.MaterialPairs = new[] { FluidMaterialPair.Mixing(null, dye, 0.001f), FluidMaterialPair.Mixing(sand, dye, 0f) };
                Assert.That(((IUsesFeatures)scene.Fluid).UsedFeatures.Has(Features.Diffusion));
            }
        }

        static void BeginAgain(FluidSimulation fluid)
        {
            fluid.KeepStateOnDisable = false;
            fluid.enabled = false;
            fluid.enabled = true;
        }

        static List<string> ProblemsOf(FluidSimulation fluid)
        {
            var problems = new List<string>();
            ((IHasProblems)fluid).ListProblems(problems);
            return problems;
        }

        [Test]
        public void Grains_whose_pressure_nothing_finds_are_said_to_flow()
        {
            using (SourceScene scene = new SourceScene(Box, Spacing, 2000).Fill(0.2f))
            {
                FluidMaterial sand = scene.Fluid.Material;
                sand.frictionAngle = 30f;
                scene.Fluid.Material = sand;
                SolverSettings settings = scene.Fluid.Settings;
                settings.deepWater = DeepWater.Automatic;
                scene.Fluid.Settings = settings;
                scene.Step(2);
                Assert.That(scene.Fluid.Solver.Coarse, Is.Not.Null, "grains turn deep water on");
                Assert.That(ProblemsOf(scene.Fluid), Is.Empty);
                settings.deepWater = DeepWater.Off;
                scene.Fluid.Settings = settings;
                LogAssert.Expect(LogType.Warning, new Regex("FluidSimulation 'Fluid': its grains flow as a liquid.*Set Deep Water to Automatic"));
                scene.Step(3);
                Assert.That(ProblemsOf(scene.Fluid), Has.Some.Contains("its grains flow as a liquid"));
            }
        }

        [Test]
        public void A_liquid_much_lighter_than_another_is_said_by_name_and_acts_as_light_as_can_be()
        {
            using (SourceScene scene = new SourceScene(Box, Spacing, 2000).Fill(0.2f))
            {
                scene.Fluid.PhaseMaterials = new[] { Material("Air", 0.2f) };
                LogAssert.Expect(LogType.Warning, new Regex("FluidSimulation 'Fluid': its material 'Air' is lighter than 1/1000 of its heaviest, " +
                    "and acts as one of 1 kg/m³"));
                scene.Step(3);
                Assert.That(scene.Fluid.Input.phases.Ratio(scene.Fluid.Material), Is.EqualTo(1000f).Within(0.1f));
            }
        }

        [Test]
        public void A_tension_that_is_too_strong_is_logged_by_the_name_of_its_material()
        {
            using (SourceScene scene = new SourceScene(Box, Spacing, 2000, DeepWater.On).Fill(0.2f))
            {
                FluidMaterialAsset mercury = Material("Mercury", 13500f);
                mercury.SurfaceTension = 900f;
                scene.Fluid.PhaseMaterials = new[] { mercury };
                LogAssert.Expect(LogType.Warning, new Regex("FluidSimulation 'Fluid': the surface tension of its material 'Mercury', 900 N/m, " +
                    "acts like 304 N/m: more is not stable at this spacing and substep. Take 2 substeps"));
                scene.Step(2);
                Assert.That(ProblemsOf(scene.Fluid), Has.Some.Contains("'Mercury'"));
                mercury.SurfaceTension = 200f;
                scene.Step();
                Assert.That(ProblemsOf(scene.Fluid), Is.Empty);
                mercury.SurfaceTension = 900f;
                BeginAgain(scene.Fluid);
                LogAssert.Expect(LogType.Warning, new Regex("the surface tension of its material 'Mercury', 900 N/m, acts like 304 N/m"));
                scene.Step(2);
            }
        }

        // Mercury has the larger one, and its limit is larger still: 304 N/m, against 11.25 N/m of a liquid of 500 kg/m³.
        [Test]
        public void Of_two_tensions_the_one_that_is_further_beyond_its_limit_is_logged()
        {
            using (SourceScene scene = new SourceScene(Box, Spacing, 2000, DeepWater.On).Fill(0.2f))
            {
                FluidMaterialAsset mercury = Material("Mercury", 13500f), spirit = Material("Spirit", 500f);
                (mercury.SurfaceTension, spirit.SurfaceTension) = (250f, 20f);
                scene.Fluid.PhaseMaterials = new[] { mercury, spirit };
                LogAssert.Expect(LogType.Warning, new Regex("FluidSimulation 'Fluid': the surface tension of its material 'Spirit', 20 N/m, " +
                    "acts like 11.[23] N/m: more is not stable"));
                scene.Step(2);
                Assert.That(ProblemsOf(scene.Fluid), Has.Some.Contains("'Spirit'").And.None.Contains("'Mercury'"));
            }
        }

        [Test]
        public void Values_out_of_range_are_clamped_and_said()
        {
            FluidMaterialAsset oil = Material("Oil", 900f);
            LogAssert.Expect(LogType.Warning, new Regex("FluidMaterialAsset 'Oil'.*density"));
            oil.Density = -5f;
            Assert.That(oil.Density, Is.EqualTo(1e-3f));
            LogAssert.Expect(LogType.Warning, new Regex("FluidMaterialAsset 'Oil'.*surface tension"));
            oil.SurfaceTension = 2000f;
            Assert.That(oil.SurfaceTension, Is.EqualTo(1000f));
            LogAssert.Expect(LogType.Warning, new Regex("FluidMaterialAsset 'Oil'.*contact angle"));
            oil.ContactAngle = 200f;
            Assert.That(oil.ContactAngle, Is.EqualTo(180f));
        }

        // Dye fills the half at x > 0, brine would be the fluid's third liquid and is not in it.
        SourceScene Dyed(FluidMaterialAsset dye, params FluidMaterialPair[] pairs)
        {
            var scene = new SourceScene(new Vector3(1f, 0.5f, 0.5f), Spacing, 3000);
            var half = new Vector3(0.5f, 0.4f, 0.5f);
            AddVolume(scene, half, new Vector3(-0.25f, -0.05f, 0f), null);
            AddVolume(scene, half, new Vector3(0.25f, -0.05f, 0f), dye);
            scene.Fluid.Gravity = Vector3.zero;
            scene.Fluid.MaterialPairs = pairs;
            scene.Fluid.Restart();
            return scene;
        }

        static int CountAcross(SourceScene scene, float near)
        {
            uint[] phases = Phases(scene);
            return scene.Read().positions.Where((p, i) => phases[i] == 1 && p.x * Spacing < 0.5f - near).Count();
        }

        [Test]
        public void A_pair_mixes_once_both_are_in_the_fluid_whichever_is_named_first([Values] bool isFirst, [Values] bool isOwn)
        {
            FluidMaterialAsset dye = Material("Dye", 1000f), other = isOwn ? null : Material("Brine", 1000f);
            FluidMaterialPair pair = isFirst ? FluidMaterialPair.Mixing(dye, other, 0.005f) : FluidMaterialPair.Mixing(other, dye, 0.005f);
            using (SourceScene scene = Dyed(dye, pair))
            {
                Assert.That(CountAcross(scene.Step(30), 0.02f), isOwn ? Is.GreaterThan(10) : (IResolveConstraint)Is.Zero);
                scene.Fluid.MaterialPairs = null;
                uint[] before = Phases(scene);
                Assert.That(Phases(scene.Step(5)).Count(phase => phase == 1), Is.EqualTo(before.Count(phase => phase == 1)));
                Assert.That(scene.Fluid.Solver.Describe(scene.Fluid.Input, 0).Single(stage => stage.Name == "Diffusion").IsUsed, Is.False);
            }
        }

        [Test]
        public void Diffusion_beyond_its_limit_is_logged_once_with_the_substeps_that_reach_it()
        {
            FluidMaterialAsset dye = Material("Dye", 1000f);
            using (SourceScene scene = Dyed(dye, FluidMaterialPair.Mixing(null, dye, 0.04f)))
            {
                LogAssert.Expect(LogType.Warning, new Regex("FluidSimulation 'Fluid': its diffusion of 0.04 m²/s acts like 0.015 m²/s, the most at " +
                    "this spacing and substep. Take 3 substeps, or a particle spacing of 0.0816 m, or lower it"));
                scene.Step(3);
                Assert.That(ProblemsOf(scene.Fluid), Has.Some.Contains("its diffusion of 0.04 m²/s"));
                scene.Fluid.Settings = With(scene.Fluid.Settings, 3);
                scene.Step(2);
                Assert.That(ProblemsOf(scene.Fluid), Is.Empty);
            }
        }

        static SolverSettings With(SolverSettings settings, int substeps)
        {
            settings.substeps = substeps;
            return settings;
        }

        [Test]
        public void A_pair_out_of_range_is_clamped_and_one_of_a_single_material_is_said()
        {
            FluidMaterialAsset dye = Material("Dye", 1000f);
            using (var scene = new SourceScene(Box, Spacing, 100))
            {
                LogAssert.Expect(LogType.Warning, new Regex("FluidSimulation 'Fluid'.*material pair 0: diffusion.*100"));
                scene.Fluid.MaterialPairs = new[] { FluidMaterialPair.Mixing(null, dye, 1000f) };
                Assert.That(scene.Fluid.MaterialPairs[0].diffusion, Is.EqualTo(100f));
                LogAssert.Expect(LogType.Warning, new Regex("FluidSimulation 'Fluid'.*material pair 1: both materials are the same"));
                scene.Fluid.MaterialPairs = new[] { FluidMaterialPair.Mixing(null, dye, 0.001f), FluidMaterialPair.Mixing(dye, dye, 0.001f) };
            }
        }

        static float MeanHeight(SourceScene scene, uint phase)
        {
            uint[] phases = Phases(scene);
            return scene.Read().positions.Where((p, i) => phases[i] == phase).Average(p => p.y) * Spacing;
        }

        [Test, Category("LongRun")]
        public void Oil_beside_water_comes_to_lie_on_it_and_a_change_of_its_density_acts_at_once()
        {
            FluidMaterialAsset oil = Material("Oil", 500f);
            using (var scene = new SourceScene(new Vector3(0.6f, 1f, 0.6f), Spacing, 3000, DeepWater.On))
            {
                var half = new Vector3(0.3f, 0.4f, 0.6f);
                AddVolume(scene, half, new Vector3(-0.15f, -0.3f, 0f), oil);
                AddVolume(scene, half, new Vector3(0.15f, -0.3f, 0f), null);
                scene.Fluid.Restart();
                float above = MeanHeight(scene.Step(120), 1), water = MeanHeight(scene, 0);
                oil.Density = 2000f;
                float below = MeanHeight(scene.Step(240), 1);
                TestContext.Out.WriteLine($"oil at {above:0.000} m and water at {water:0.000} m, then oil at {below:0.000} m");
                Assert.That(above, Is.GreaterThan(0.27f), "lighter than water");
                Assert.That(water, Is.LessThan(0.13f));
                Assert.That(below, Is.LessThan(0.13f), "heavier than water");
            }
        }

        [Test]
        public void A_liquid_presses_on_a_collider_by_its_own_density([Values(500f, 2000f)] float density)
        {
            using (var scene = new SourceScene(new Vector3(0.8f, 1f, 0.8f), Spacing, 6000, DeepWater.On))
            {
                AddVolume(scene, new Vector3(0.8f, 0.7f, 0.8f), new Vector3(0f, -0.15f, 0f), Material("Liquid", density));
                scene.Fluid.Restart();
                FluidCollider ball = new GameObject("Ball").AddComponent<FluidCollider>();
                try
                {
                    ball.transform.position = new Vector3(0f, -0.15f, 0f);
                    ball.Shape = ColliderShape.Sphere;
                    ball.Radius = 0.2f;
                    ball.MeasuresForce = true;
                    scene.Step(90);
                    double lift = 0.0;
                    for (int i = 0; i < 30; i++)
                    {
                        scene.Step();
                        UnityEngine.Rendering.AsyncGPUReadback.WaitAllRequests();
                        Assert.That(ball.TryGetForce(out Vector3 force, out _));
                        lift += force.y / 30.0;
                    }
                    double expected = density * 9.81 * 4.0 / 3.0 * math.PI * 0.2 * 0.2 * 0.2;
                    TestContext.Out.WriteLine($"lift {lift:0.0} N, {expected:0.0} N of what it displaces");
                    Assert.That(lift / expected, Is.InRange(0.85, 1.15));
                }
                finally
                {
                    Object.DestroyImmediate(ball.gameObject);
                }
            }
        }

        [Test]
        public void Statistics_weigh_each_particle_by_its_material()
        {
            FluidMaterialAsset oil = Material("Oil", 500f), brine = Material("Brine", 1500f);
            using (var scene = new SourceScene(Box, Spacing, 6000, DeepWater.On))
            {
                AddVolume(scene, new Vector3(0.4f, 0.3f, 0.6f), new Vector3(-0.3f, -0.35f, 0f), oil);
                AddVolume(scene, new Vector3(0.3f, 0.5f, 0.5f), new Vector3(0.2f, -0.2f, 0.1f), brine);
                AddVolume(scene, new Vector3(0.2f, 0.2f, 0.2f), new Vector3(-0.3f, 0.2f, -0.3f), null);
                scene.Fluid.Restart();
                scene.Step(20);
                FluidStatistics measured = scene.Measure();
                ParticleState state = scene.Read();
                uint[] phases = Phases(scene);
                var density = new[] { 1000.0, 500.0, 1500.0 };
                double mass = 0.0, energy = 0.0;
                double3 center = 0.0, momentum = 0.0;
                for (int i = 0; i < state.Count; i++)
                {
                    double particle = density[phases[i]] * Spacing * Spacing * Spacing;
                    double3 v = (double3)state.velocities[i].xyz * Spacing;
                    mass += particle;
                    energy += 0.5 * particle * math.dot(v, v);
                    momentum += particle * v;
                    center += particle * Spacing * (double3)state.positions[i].xyz;
                }
                center /= mass;
                Assert.That(measured.mass, Is.EqualTo(mass).Within(1e-5 * mass));
                Assert.That(measured.kineticEnergy, Is.EqualTo(energy).Within(1e-4 * energy));
                Assert.That(math.distance(measured.momentum, momentum), Is.LessThan(1e-4 * math.length(momentum)));
                Assert.That(math.distance(measured.centerOfMass, center), Is.LessThan(1e-5));
                Assert.That(measured.potentialEnergy, Is.EqualTo(mass * 9.81 * center.y).Within(1e-4 * mass));
                for (int phase = 0; phase < PhaseMaterials.Phases; phase++)
                    Assert.That(measured.VolumeOf(phase), Is.EqualTo(phases.Count(p => p == phase) * scene.ParticleVolume).Within(1e-6));
            }
        }

        [Test]
        public void Statistics_of_one_liquid_count_all_of_it_as_phase_0()
        {
            using (SourceScene scene = new SourceScene(Box, Spacing, 4000).Fill(0.2f))
            {
                FluidStatistics measured = scene.Step(5).Measure();
                Assert.That(measured.VolumeOf(0), Is.EqualTo(1600 * scene.ParticleVolume).Within(1e-5));
                Assert.That(measured.VolumeOf(1), Is.Zero);
                Assert.That(measured.mass, Is.EqualTo(1600 * 1000f * scene.ParticleVolume).Within(1e-2));
            }
        }

        [Test]
        public void Statistics_of_phases_of_one_material_count_each_where_phases_are_tracked([Values] bool areTracked)
        {
            using (var scene = new SourceScene(Box, Spacing, 4000))
            {
                scene.Fluid.TrackPhases = areTracked;
                scene.Step();
                scene.Fluid.Fill(FluidShape.Box(new Vector3(-0.3f, -0.4f, 0f), new Vector3(0.2f, 0.2f, 0.5f)), phase: 3);
                scene.Fluid.Fill(FluidShape.Box(new Vector3(0.3f, -0.4f, 0f), new Vector3(0.2f, 0.2f, 0.2f)));
                FluidStatistics measured = scene.Step().Measure();
                Assert.That((measured.VolumeOf(0), measured.VolumeOf(3)),
                    Is.EqualTo(((areTracked ? 64 : 224) * scene.ParticleVolume, (areTracked ? 160 : 0) * scene.ParticleVolume)).Within(1e-6));
                Assert.That(measured.mass, Is.EqualTo(224 * 1000f * scene.ParticleVolume).Within(1e-2));
            }
        }

        // Nothing of the measurement before, which knew two.
        [Test]
        public void Statistics_of_liquids_that_became_alike_count_all_as_phase_0()
        {
            FluidMaterialAsset oil = Material("Oil", 500f);
            using (var scene = new SourceScene(Box, Spacing, 4000))
            {
                AddVolume(scene, new Vector3(0.4f, 0.2f, 0.5f), new Vector3(-0.3f, -0.4f, 0f), oil);
                AddVolume(scene, new Vector3(0.4f, 0.2f, 0.5f), new Vector3(0.3f, -0.4f, 0f), null);
                scene.Fluid.StatisticsInterval = 1000;      // so that they stay
                scene.Fluid.Restart();
                Assert.That(scene.Step().Measure().VolumeOf(1), Is.EqualTo(320 * scene.ParticleVolume).Within(1e-6));
                oil.Density = scene.Fluid.Material.density;
                FluidStatistics alike = scene.Step().Measure();
                Assert.That((alike.VolumeOf(0), alike.VolumeOf(1)), Is.EqualTo((640 * scene.ParticleVolume, 0f)).Within(1e-6));
                Assert.That(alike.mass, Is.EqualTo(640 * 1000f * scene.ParticleVolume).Within(1e-2));
            }
        }

        [Test]
        public void A_detector_weighs_each_liquid_by_its_material()
        {
            FluidMaterialAsset oil = Material("Oil", 500f);
            using (var scene = new SourceScene(Box, Spacing, 4000))
            {
                AddVolume(scene, new Vector3(0.5f, 0.2f, 0.5f), new Vector3(-0.25f, -0.4f, 0f), oil);
                AddVolume(scene, new Vector3(0.25f, 0.2f, 0.5f), new Vector3(0.2f, -0.4f, 0f), null);
                foreach (FluidVolume volume in scene.Fluid.GetComponentsInChildren<FluidVolume>())
                    volume.Velocity = new Vector3(0f, 0f, 0.4f);
                scene.Fluid.Restart();
                FluidDetector detector = scene.Add<FluidDetector>(Vector3.zero, Vector3.forward, d => d.Size = Box);
                Assert.That(detector.MeasureNow().MassOf(1), Is.EqualTo(500f * 0.05f).Within(0.1f), "before the first step");
                scene.Step();
                FluidDetectorSample sample = detector.MeasureNow();
                Assert.That(sample.velocity.z, Is.EqualTo(0.4f).Within(0.05f));
                Assert.That(sample.momentum.z, Is.EqualTo(50f * sample.velocity.z).Within(0.05f), "kg m/s");
                Assert.That(sample.MassOf(1), Is.EqualTo(500f * 0.05f).Within(0.01f));
                Assert.That(sample.MassOf(0), Is.EqualTo(1000f * 0.025f).Within(0.01f));
                Assert.That(sample.mass, Is.EqualTo(50f).Within(0.02f));
                Assert.That(() => sample.MassOf(8), Throws.TypeOf<ArgumentOutOfRangeException>());
            }
        }

        [Test]
        public void Exported_particles_have_the_density_of_their_material()
        {
            FluidMaterialAsset oil = Material("Oil", 500f);
            using (var scene = new SourceScene(Box, Spacing, 4000))
            {
                AddVolume(scene, new Vector3(0.4f, 0.4f, 0.4f), new Vector3(-0.3f, -0.3f, 0f), oil);
                AddVolume(scene, new Vector3(0.4f, 0.4f, 0.4f), new Vector3(0.3f, -0.3f, 0f), null);
                scene.Fluid.Restart();
                scene.Step(2);
                ParticleFrame frame = null;
                ParticleExport.Request(scene.Fluid, (got, problem) => frame = got);
                UnityEngine.Rendering.AsyncGPUReadback.WaitAllRequests();
                Assert.That(frame, Is.Not.Null);
                float Mean(int phase) => frame.Densities.Where((density, i) => frame.Phases[i] == phase).Average();
                Assert.That(Mean(1) / Mean(0), Is.EqualTo(0.5f).Within(0.02f), "of equal cubes");
            }
        }
    }
}
