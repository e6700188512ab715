using System;
using System.Collections;
using System.Collections.Generic;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>Content of a built player: the stages that its components refer to, and nothing of the Editor's.</summary>
    public class ShadersInBuildTests
    {
        readonly List<Object> made = new List<Object>();
        Func<string, StageShader> editorFind;

        [SetUp]
        public void RemoveEditor()
        {
            Time.captureDeltaTime = 1f / 60f;
            editorFind = StageShader.EditorFind;
            StageShader.EditorFind = null;
        }

        [UnityTearDown]
        public IEnumerator GiveItBack()
        {
            foreach (Object one in made)
                Object.Destroy(one);
            made.Clear();
            StageShader.EditorFind = editorFind;
            Time.captureDeltaTime = 0f;
            yield return null;
        }

        [UnityTest]
        public IEnumerator A_fluid_of_the_scene_runs_on_the_stages_that_it_refers_to()
        {
            FluidSimulation fluid = Fluid();
            Build(fluid.gameObject);
            fluid.gameObject.SetActive(true);
            yield return Frames(3);
            Assert.That(fluid.StepCount, Is.EqualTo(3));
        }

        [UnityTest]
        public IEnumerator A_fluid_that_a_script_adds_is_off_after_one_error_that_names_the_stage_and_the_remedy()
        {
            FluidSimulation fluid = Fluid();
            LogAssert.Expect(LogType.Error, new Regex(
                "^Rill: FluidSimulation 'Fluid' is off: the shaders of the stage 'ParticleUpload' .* Shaders In Build .* FluidShaders " +
                ".* Preloaded Assets"));
            fluid.gameObject.SetActive(true);
            yield return Frames(3);
            Assert.That(fluid.IsRunning, Is.False);
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void A_bake_without_its_stage_is_not_sent_to_a_setting_that_does_not_bring_it()
        {
            string error = Assert.Throws<InvalidOperationException>(() => StageShader.LoadCompute("MeshSdf")).Message;
            Assert.That(error, Does.Contain("'MeshSdf'").And.Contain("Put the package's asset FluidShaders").And.Not.Contain("All Features"));
        }

        [UnityTest]
        public IEnumerator A_fluid_that_a_script_adds_runs_on_the_stages_of_a_loaded_asset()
        {
            FluidSimulation fluid = Fluid();
            var shaders = ScriptableObject.CreateInstance<FluidShaders>();
            made.Add(shaders);
            shaders.Stages = All(Features.Core | Features.DeepWater | Features.Statistics);
            fluid.gameObject.SetActive(true);
            yield return Frames(3);
            Assert.That(fluid.StepCount, Is.EqualTo(3));
        }

        [UnityTest]
        public IEnumerator What_is_switched_on_without_its_stage_stays_off_after_one_error_and_the_fluid_goes_on(
            [Values("ImplicitViscosity", "Viscoelasticity", "Contacts", "VorticityConfinement", "RestingRegions", "Statistics", "CoarseGrid",
            "Colliders", "Emitters", "Drains", "ForceFields", "Borders", "ParticleAccess", "ParticleEdits", "Queries")] string stage)
        {
            FluidSimulation fluid = Fluid();
            fluid.StatisticsInterval = 0;
            fluid.Settings = With(fluid.Settings, DeepWater.Off, 0f);
            Build(fluid.gameObject);
            fluid.gameObject.SetActive(true);
            yield return Frames(2);

            LogAssert.Expect(LogType.Error, new Regex(
                $"^Rill: FluidSimulation 'Fluid' goes on without .*: the shaders of the stage '{stage}' .* Shaders In Build"));
            SwitchOn(stage, fluid);
            yield return Frames(4);
            Assert.That(fluid.StepCount, Is.EqualTo(6));
            var problems = new List<string>();
            ((IHasProblems)fluid).ListProblems(problems);
            Assert.That(problems, Has.Exactly(1).Contains($"'{stage}'"), "in the inspector");
            LogAssert.NoUnexpectedReceived();
        }

        [UnityTest]
        public IEnumerator What_came_without_its_stage_acts_once_the_stage_is_loaded()
        {
            FluidSimulation fluid = Fluid();
            Build(fluid.gameObject);
            fluid.gameObject.SetActive(true);
            LogAssert.Expect(LogType.Error, new Regex("goes on without colliders"));
            SwitchOn("Colliders", fluid);
            yield return Frames(2);
            Assert.That(fluid.Solver.Colliders, Is.Null);

            FluidCollider built = Off<FluidCollider>("Built");
            Build(built.gameObject);
            built.gameObject.SetActive(true);
            yield return Frames(2);
            Assert.That(fluid.Solver.Colliders, Is.Not.Null);
            Assert.That(fluid.Inputs.Colliders.Set.Count, Is.EqualTo(2));
        }

        [UnityTest]
        public IEnumerator All_features_bring_the_stages_of_all_that_a_script_can_add()
        {
            FluidSimulation fluid = Fluid();
            fluid.ShadersInBuild = ShadersInBuild.AllFeatures;
            Build(fluid.gameObject);
            fluid.gameObject.SetActive(true);
            foreach (string stage in new[] { "ImplicitViscosity", "GrainFriction", "Viscoelasticity", "Contacts", "Statistics", "CoarseGrid",
                "Colliders", "Emitters",
                "Drains", "ForceFields", "Borders", "ParticleAccess", "ParticleEdits", "Queries" })
                SwitchOn(stage, fluid);
            fluid.gameObject.AddComponent<ParticleRenderer>();
            fluid.gameObject.AddComponent<DomainRenderer>();
            yield return Frames(4);
            Assert.That(fluid.StepCount, Is.EqualTo(4));
            LogAssert.NoUnexpectedReceived();
        }

        [UnityTest]
        public IEnumerator A_renderer_without_its_stage_is_off_after_one_error()
        {
            FluidSimulation fluid = Fluid();
            Build(fluid.gameObject);
            fluid.gameObject.SetActive(true);
            LogAssert.Expect(LogType.Error, new Regex("^Rill: ParticleRenderer 'Fluid' is off: the shaders of the stage 'ParticleRenderer'"));
            var renderer = fluid.gameObject.AddComponent<ParticleRenderer>();
            yield return Frames(3);
            Assert.That(renderer.enabled, Is.False);
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void A_fluid_refers_to_the_stages_of_its_settings_and_to_no_others()
        {
            FluidSimulation fluid = Fluid();
            fluid.StatisticsInterval = 0;
            fluid.Settings = With(fluid.Settings, DeepWater.Off, 0f);
            Assert.That(Used(fluid), Is.EqualTo((FeatureSet)Features.Core));
            fluid.StatisticsInterval = 5;
            Assert.That(Used(fluid), Is.EqualTo(Features.Core | Features.Statistics));
            fluid.Settings = With(fluid.Settings, DeepWater.Automatic, 0.1f);
            Assert.That(Used(fluid), Is.EqualTo(Features.Core | Features.Statistics | Features.DeepWater | Features.Sleep));
            FluidMaterial material = fluid.Material;
            material.frictionAngle = 30f;
            fluid.Material = material;
            Assert.That(Used(fluid), Is.EqualTo(Features.Core | Features.Statistics | Features.DeepWater | Features.Sleep | Features.GrainFriction));
            fluid.Settings = With(fluid.Settings, DeepWater.Off, 0.1f);
            Assert.That(Used(fluid), Is.EqualTo(Features.Core | Features.Statistics | Features.Sleep), "nothing finds the pressure of grains");
            fluid.Settings = With(fluid.Settings, DeepWater.Automatic, 0.1f);
            material.frictionAngle = 0f;
            material.shearModulus = 100f;
            material.dynamicViscosity = 1f;
            material.vorticity = 1f;        // nothing sleeps beside it
            fluid.Material = material;
            Assert.That(Used(fluid), Is.EqualTo(Features.Core | Features.Statistics | Features.DeepWater | Features.Viscosity
                | Features.Elasticity | Features.Vorticity));
            material = FluidMaterial.Water;
            material.contacts = true;       // without a pressure
            fluid.Material = material;
            Assert.That(Used(fluid), Is.EqualTo(Features.Core | Features.Statistics | Features.Sleep | Features.Contacts));
        }

        [Test]
        public void An_open_border_refers_to_what_holds_its_level_too()
        {
            FluidSimulation fluid = Fluid();
            fluid.StatisticsInterval = 0;
            fluid.Settings = With(fluid.Settings, DeepWater.Off, 0f);
            SetBorder(fluid, BorderKind.Absorbing);
            Assert.That(Used(fluid), Is.EqualTo(Features.Core | Features.Borders));
            SetBorder(fluid, BorderKind.Open);
            Assert.That(Used(fluid), Is.EqualTo(Features.Core | Features.Borders | Features.Emitters | Features.Drains));
        }

        static void SetBorder(FluidSimulation fluid, BorderKind kind)
        {
            FluidBorders borders = FluidBorders.Default;
            borders.maxX.kind = kind;
            fluid.Borders = borders;
        }

        [Test]
        public void An_emitter_refers_to_the_drains_stage_only_where_its_particles_have_a_lifetime()
        {
            var emitter = Off<FluidEmitter>("Emitter");
            Assert.That(Used(emitter), Is.EqualTo((FeatureSet)Features.Emitters));
            emitter.Lifetime = 2f;
            Assert.That(Used(emitter), Is.EqualTo(Features.Emitters | Features.Drains));
        }

        [Test]
        public void A_stage_is_found_for_as_long_as_anything_enabled_refers_to_it()
        {
            FluidCollider first = Off<FluidCollider>("First"), second = Off<FluidCollider>("Second");
            Build(first.gameObject);
            Build(second.gameObject);
            Assert.That(StageShader.Find("Colliders"), Is.Null);
            first.gameObject.SetActive(true);
            second.gameObject.SetActive(true);
            first.gameObject.SetActive(false);
            Assert.That(StageShader.Find("Colliders"), Is.Not.Null);
            second.gameObject.SetActive(false);
            Assert.That(StageShader.Find("Colliders"), Is.Null);
        }

        static FeatureSet Used(IUsesFeatures user) => user.UsedFeatures;

        static SolverSettings With(SolverSettings settings, DeepWater deepWater, float sleepSpeed)
        {
            settings.deepWater = deepWater;
            settings.sleepSpeed = sleepSpeed;
            return settings;
        }

        void SwitchOn(string stage, FluidSimulation fluid)
        {
            FluidMaterial material = fluid.Material;
            switch (stage)
            {
                case "ImplicitViscosity": material.dynamicViscosity = 1f; fluid.Material = material; break;
                case "GrainFriction": material.frictionAngle = 30f; fluid.Material = material; break;
                case "Contacts": material.contacts = true; fluid.Material = material; break;
                case "Viscoelasticity": material.shearModulus = 100f; fluid.Material = material; break;
                case "VorticityConfinement": material.vorticity = 1f; fluid.Material = material; break;
                case "RestingRegions": fluid.Settings = With(fluid.Settings, fluid.Settings.deepWater, 0.1f); break;
                case "Statistics": fluid.StatisticsInterval = 1; break;
                case "CoarseGrid": fluid.Settings = With(fluid.Settings, DeepWater.On, 0f); break;
                case "ParticleAccess": fluid.BeforeStep += (commands, particles) => { }; break;
                case "ParticleEdits": fluid.Fill(FluidShape.Sphere(fluid.transform.position, 0.2f)); break;
                case "Colliders": Add<FluidCollider>(null); break;
                case "Emitters": Add<FluidEmitter>(fluid.transform); break;
                case "Drains": Add<FluidDrain>(fluid.transform); break;
                case "Queries": Add<FluidProbe>(fluid.transform); break;
                case "Borders": SetBorder(fluid, BorderKind.Absorbing); break;
                case "ForceFields": Add<FluidForceField>(fluid.transform, field => field.Bounds = ForceFieldBounds.Sphere); break;
                default: throw new ArgumentException(stage);
            }
        }

        void Add<T>(Transform parent, Action<T> change = null) where T : Component
        {
            T added = Off<T>(typeof(T).Name);
            change?.Invoke(added);
            added.transform.SetParent(parent, false);
            added.gameObject.SetActive(true);
        }

        // Builds like the Editor, which stores an object so that it refers to the stages that it uses.
        void Build(GameObject gameObject)
        {
            StageShader.EditorFind = editorFind;
            foreach (IUsesFeatures user in gameObject.GetComponents<IUsesFeatures>())
                user.StageReferences.Update(user.UsedFeatures);
            StageShader.EditorFind = null;
        }

        StageShader[] All(FeatureSet features)
        {
            var stages = new List<StageShader>();
            foreach (Feature feature in Features.All)
                foreach (string name in feature.Stages)
                    if (features.Has(feature))
                        stages.Add(editorFind(name));
            return stages.ToArray();
        }

        FluidSimulation Fluid()
        {
            FluidSimulation fluid = Off<FluidSimulation>("Fluid");
            fluid.Configure(new Vector3(1f, 0.6f, 0.5f), 0.05f, 1000);
            FluidVolume water = new GameObject("Water").AddComponent<FluidVolume>();
            water.Size = new Vector3(0.5f, 0.4f, 0.4f);
            water.transform.SetParent(fluid.transform, false);
            return fluid;
        }

        T Off<T>(string name) where T : Component
        {
            var gameObject = new GameObject(name);
            gameObject.SetActive(false);
            made.Add(gameObject);
            return gameObject.AddComponent<T>();
        }

        static IEnumerator Frames(int count)
        {
            for (int i = 0; i < count; i++)
                yield return null;
        }
    }
}
