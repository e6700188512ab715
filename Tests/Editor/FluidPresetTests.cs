using System.Linq;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Rill.Editor.Tests
{
    public class FluidPresetTests
    {
        EditorScene scene;

        [SetUp]
        public void MakeScene() => scene = new EditorScene();

        [TearDown]
        public void DestroyScene() => scene.Dispose();

        [Test]
        public void Every_preset_gives_a_valid_material_at_every_spacing()
        {
            foreach (FluidPreset preset in FluidPresets.All)
                foreach (float spacing in new[] { 0.001f, 0.01f, 0.05f, 0.2f, 1f })
                {
                    FluidMaterial material = preset.MaterialAt(spacing);
                    Assert.That(material.Validate(out string problem), $"{preset.Name} at {spacing}: {problem}");
                    Assert.That(FluidPresets.IndexOf(material, spacing), Is.GreaterThanOrEqualTo(0));
                }
            Assert.That(FluidPresets.Names, Is.Unique);
        }

        [Test]
        public void A_fluid_within_what_the_solver_expresses_has_its_own_viscosity()
        {
            FluidPreset honey = FluidPresets.All.Single(preset => preset.Name == "Honey");
            Assert.That(honey.MaterialAt(0.05f).DynamicViscosity(0.05f), Is.EqualTo(honey.Viscosity).Within(1e-3f));
            Assert.That(honey.Describe(0.05f), Does.Contain("10 Pa s").And.Not.Contain("spacing"));
        }

        [Test]
        public void A_fluid_beyond_what_the_solver_expresses_says_what_it_acts_like()
        {
            FluidPreset water = FluidPresets.All.Single(preset => preset.Name == "Water"), honey = FluidPresets.All.Single(preset => preset.Name == "Honey");
            Assert.That(water.MaterialAt(0.05f).viscosity, Is.EqualTo(FluidMaterial.Water.viscosity));
            Assert.That(water.Describe(0.05f), Does.Contain($"no less than {water.MaterialAt(0.05f).DynamicViscosity(0.05f):G3} Pa s"));
            Assert.That(honey.MaterialAt(0.01f).viscosity, Is.EqualTo(1f));
            Assert.That(honey.Describe(0.01f), Does.Contain($"no more than {honey.MaterialAt(0.01f).DynamicViscosity(0.01f):G3} Pa s"));
        }

        [Test]
        public void An_elastic_fluid_has_its_modulus_and_what_keeps_it_whole_and_says_how_many_substeps_it_takes()
        {
            FluidPreset[] elastic = FluidPresets.All.Where(preset => preset.ShearModulus > 0f).ToArray();
            Assert.That(elastic.Select(preset => preset.Name), Has.Member("Viscoelastic slime").And.Member("Pectin gel"));
            foreach (FluidPreset preset in elastic)
            {
                FluidMaterial material = preset.MaterialAt(0.01f);
                Assert.That(material.shearModulus, Is.EqualTo(preset.ShearModulus));
                Assert.That(material.relaxationTime, Is.EqualTo(preset.RelaxationTime));
                Assert.That(material.allowedTension, Is.GreaterThan(0f));
                Assert.That(material.artificialPressure, Is.GreaterThan(0f));
                int substeps = (int)Mathf.Ceil(Mathf.Sqrt(3f * preset.ShearModulus / material.LargestShearModulus(0.01f, 1f / 60f)));
                Assert.That(preset.Describe(0.01f), Does.Contain($"{preset.ShearModulus} Pa").And.Contain($" {substeps} substeps"));
                Assert.That(material.LargestShearModulus(0.01f, 1f / 60f / substeps), Is.GreaterThanOrEqualTo(3f * preset.ShearModulus));
                Assert.That(preset.Describe(1f), Does.Contain(" 1 substeps"));
            }
            Assert.That(FluidPresets.All.Where(preset => preset.ShearModulus == 0f).Select(preset => preset.MaterialAt(0.05f).shearModulus), Is.All.EqualTo(0f));
        }

        [Test]
        public void Applying_a_preset_to_several_fluids_gives_each_its_own_setting_and_is_one_step_of_undo()
        {
            FluidSimulation coarse = scene.Add<FluidSimulation>(), fine = scene.Add<FluidSimulation>();
            coarse.Configure(Vector3.one, 0.1f, 1000);
            fine.Configure(Vector3.one, 0.05f, 1000);
            FluidMaterial before = coarse.Material;
            FluidPreset honey = FluidPresets.All.Single(preset => preset.Name == "Honey");
            Undo.IncrementCurrentGroup();
            FluidPresets.Apply(honey, new Object[] { coarse, fine });
            Assert.That(Undo.GetCurrentGroupName(), Is.EqualTo("Fluid preset Honey"));
            Assert.That(FluidPresets.All[FluidPresets.IndexOf(coarse.Material, 0.1f)], Is.SameAs(honey));
            Assert.That(FluidPresets.All[FluidPresets.IndexOf(fine.Material, 0.05f)], Is.SameAs(honey));
            Assert.That(fine.Material.viscosity, Is.EqualTo(4f * coarse.Material.viscosity).Within(1e-5f));
            Undo.PerformUndo();
            Assert.That(coarse.Material, Is.EqualTo(before));
            Assert.That(fine.Material, Is.EqualTo(before));
        }

        [Test]
        public void A_material_of_ones_own_is_no_preset()
        {
            FluidMaterial own = FluidMaterial.Water;
            own.viscosity = 0.3f;
            Assert.That(FluidPresets.IndexOf(own, 0.05f), Is.EqualTo(-1));
        }
    }
}
