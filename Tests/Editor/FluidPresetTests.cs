using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Rill.Tests;
using UnityEditor;
using UnityEngine;
using UnityEngine.TestTools;
using static System.FormattableString;

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
        public void Every_preset_gives_a_valid_material_that_is_found_again()
        {
            FluidSimulation fluid = scene.Add<FluidSimulation>();
            Assert.That(FluidPresets.All.Count, Is.GreaterThanOrEqualTo(11));
            for (int i = 0; i < FluidPresets.All.Count; i++)
            {
                FluidMaterial material = FluidPresets.All[i].Material;
                Assert.That(material.Validate(out string problem), $"{FluidPresets.All[i].name}: {problem}");
                FluidPresets.All[i].Look.Validate(out problem);
                Assert.That(problem, Is.Null, FluidPresets.All[i].name);
                fluid.Material = material;
                Assert.That(FluidPresets.IndexOf(fluid), Is.EqualTo(i));
            }
            Assert.That(FluidPresets.Names, Is.Unique);
        }

        [TestCase("Olive oil", 0.084f, false)]
        [TestCase("Glycerol", 1.41f, false)]
        [TestCase("Honey", 10f, true)]
        [TestCase("Basaltic lava", 100f, true)]
        public void A_thick_fluid_has_its_viscosity_in_Pa_s_and_no_smoothing(string name, float viscosity, bool drawsThreads)
        {
            FluidMaterial material = Named(name).Material;
            Assert.That(material.dynamicViscosity, Is.EqualTo(viscosity));
            Assert.That(material.velocitySmoothing, Is.Zero);
            Assert.That(material.wallFriction, Is.EqualTo(1f));
            Assert.That(material.allowedTension > 0f && material.artificialPressure > 0f, Is.EqualTo(drawsThreads));
        }

        [TestCase("Water")]
        [TestCase("Seawater")]
        [TestCase("Mercury")]
        public void A_thin_fluid_is_as_water_but_for_its_density(string name)
        {
            FluidMaterial expected = FluidMaterial.Water;
            expected.density = Named(name).Material.density;
            if (name == "Mercury")
                (expected.surfaceTension, expected.contactAngle) = (0.485f, 140f);
            Assert.That(Named(name).Material, Is.EqualTo(expected));
        }

        [Test]
        public void A_spacing_too_coarse_for_a_viscosity_is_named_with_what_the_solver_damps()
        {
            Assert.That(Described("Honey", 0.01f), Does.Contain("10 Pa s").And.Not.Contain("solver"));
            Assert.That(Described("Honey", 0.05f), Does.Contain("damps eddies as 15 Pa s"));
            Assert.That(Described("Water", 0.02f), Does.Contain("damps eddies as 1.7 Pa s"));
        }

        // Over what the solver itself damps, which is subtracted.
        [Test, Category("LongRun")]
        public void A_fluid_is_as_viscous_at_half_the_spacing([Values("Glycerol", "Honey", "Basaltic lava")] string name)
        {
            const float Coarse = 0.02f, TimeStep = 1f / 60f;
            double coarse = Decay(new ViscousEddy(20, 4f), Coarse), fine = Decay(new ViscousEddy(40, 8f), 0.5f * Coarse);
            TestContext.Out.WriteLine($"an eddy of {4f * Coarse} m decays by {coarse:g4} at {Coarse} m and {fine:g4} at {0.5f * Coarse} m");
            Assert.That(coarse, Is.EqualTo(fine).Within(0.03 * fine));

            double Decay(ViscousEddy eddy, float spacing)
            {
                FluidMaterial viscous = Named(name).Material, inviscid = viscous;
                inviscid.dynamicViscosity = 0f;
                return System.Math.Log(eddy.Left(eddy.Lattice, inviscid, spacing, TimeStep, 2) / eddy.Left(eddy.Lattice, viscous, spacing,
                    TimeStep, 2));
            }
        }

        [Test]
        public void An_elastic_fluid_has_its_modulus_and_what_keeps_it_whole_and_says_how_many_substeps_it_takes()
        {
            FluidPreset[] elastic = FluidPresets.All.Where(preset => preset.Material.shearModulus > 0f).ToArray();
            Assert.That(elastic.Select(preset => preset.name), Has.Member("Viscoelastic slime").And.Member("Pectin gel"));
            foreach (FluidPreset preset in elastic)
            {
                FluidMaterial material = preset.Material;
                Assert.That(material.allowedTension, Is.GreaterThan(0f));
                Assert.That(material.artificialPressure, Is.GreaterThan(0f));
                int substeps = (int)Mathf.Ceil(Mathf.Sqrt(3f * preset.Material.shearModulus / material.MaxShearModulus(0.01f, 1f / 60f)));
                Assert.That(PresetText.Describe(preset, 0.01f), Does.Contain(Invariant($"{preset.Material.shearModulus} Pa"))
                    .And.Contain(Invariant($" {substeps} substeps")));
                Assert.That(material.MaxShearModulus(0.01f, 1f / 60f / substeps), Is.GreaterThanOrEqualTo(3f * preset.Material.shearModulus));
                Assert.That(PresetText.Describe(preset, 1f), Does.Contain(" 1 substeps"));
            }
        }

        // At 1 cm, 60 steps a second and 4 iterations up to 0.18 N/m act of water.
        [TestCase(0.072f, 4, "0.072 N/m acts (Σ 0.02 of at most 0.05) over 2.7 mm, 0.27 spacings")]
        [TestCase(0.036f, 4, "over 1.9 mm, 0.19 spacings: not seen at this spacing, where 0.036 to 0.18 N/m look like small drops")]
        [TestCase(0.72f, 4, "0.72 N/m acts like 0.18 N/m (Σ 0.05 of at most 0.05) over 4.3 mm, 0.43 spacings; 2 substeps would reach it")]
        [TestCase(0.72f, 1, "0.72 N/m does not act with fewer than 2 iterations")]
        public void What_acts_of_a_surface_tension_is_said_with_what_would_make_it_act(float tension, int iterations, string expected)
        {
            FluidMaterial material = FluidMaterial.Water;
            material.surfaceTension = tension;
            SolverSettings settings = SolverSettings.Default;
            settings.iterations = iterations;
            Assert.That(PresetText.TensionText(material, settings, 0.01f, 1f / 60f), Does.EndWith(expected));
        }

        // Figures as the manual's table of presets has them: shear modulus in Pa, time in s.
        [TestCase("Viscoelastic slime", 300f, 0.5f)]
        [TestCase("Pectin gel", 400f, 1000f)]
        public void An_elastic_fluid_has_the_modulus_and_the_time_that_the_manual_says(string name, float modulus, float time)
        {
            FluidMaterial material = Named(name).Material;
            Assert.That((material.shearModulus, material.relaxationTime, material.density), Is.EqualTo((modulus, time, 1000f)));
        }

        [TestCase("Dry sand", "1600 kg/m³, friction angle 33°, cohesion 0 Pa")]
        [TestCase("Damp sand", "1900 kg/m³, friction angle 33°, cohesion 1500 Pa")]
        public void Grains_are_told_by_their_friction_and_no_viscosity(string name, string expected)
            => Assert.That(Described(name, 0.02f), Does.StartWith($"{name}: {expected}").And.Not.Contain("Pa s").And.Not.Contain("solver"));

        [Test]
        public void A_material_from_code_is_the_preset_of_that_name_in_the_inspector()
        {
            PropertyInfo[] fromCode = typeof(FluidMaterial).GetProperties(BindingFlags.Public | BindingFlags.Static);
            Assert.That(fromCode.Select(property => property.Name), Is.EquivalentTo(Shipped.Select(preset => NameInCode(preset.name))));
            foreach (PropertyInfo property in fromCode)
                foreach (FieldInfo field in Fields)
                    Assert.That(field.GetValue(Shipped.Single(preset => NameInCode(preset.name) == property.Name).Material),
                        Is.EqualTo(field.GetValue(property.GetValue(null))), $"{field.Name} in the asset of {property.Name}");

            string NameInCode(string name)
                => string.Concat(name.Split(' ').Select(word => word.Substring(0, 1).ToUpperInvariant() + word.Substring(1)));
        }

        [Test]
        public void Applying_a_preset_to_several_fluids_gives_each_the_same_material_and_is_one_step_of_undo()
        {
            FluidSimulation coarse = scene.Add<FluidSimulation>(), fine = scene.Add<FluidSimulation>();
            coarse.Configure(Vector3.one, 0.1f, 1000);
            fine.Configure(Vector3.one, 0.05f, 1000);
            FluidMaterial before = coarse.Material;
            Undo.IncrementCurrentGroup();
            FluidPresets.Apply(Named("Honey"), new Object[] { coarse, fine });
            Assert.That(Undo.GetCurrentGroupName(), Is.EqualTo("Fluid preset Honey"));
            Assert.That(coarse.Material, Is.EqualTo(Named("Honey").Material));
            Assert.That(fine.Material, Is.EqualTo(Named("Honey").Material));
            Undo.PerformUndo();
            Assert.That(coarse.Material, Is.EqualTo(before));
            Assert.That(fine.Material, Is.EqualTo(before));
        }

        [Test]
        public void Applying_a_preset_leaves_nothing_of_the_material_before()
        {
            FluidSimulation fluid = scene.Add<FluidSimulation>();
            fluid.Configure(Vector3.one, 0.1f, 1000);
            foreach (FieldInfo field in Fields)
            {
                fluid.Material = Changed(field);
                Assert.That(field.GetValue(fluid.Material), Is.Not.EqualTo(field.GetValue(FluidMaterial.Water)), field.Name);
                FluidPresets.Apply(Named("Water"), new Object[] { fluid });
                Assert.That(fluid.Material, Is.EqualTo(FluidMaterial.Water), field.Name);
            }
        }

        [Test]
        public void A_material_of_ones_own_is_no_preset()
        {
            FluidSimulation fluid = scene.Add<FluidSimulation>();
            foreach (FieldInfo field in Fields)
            {
                fluid.Material = Changed(field);
                Assert.That(FluidPresets.IndexOf(fluid), Is.EqualTo(-1), field.Name);
            }
        }

        [Test]
        public void A_preset_sets_the_look_with_the_material_in_one_step_of_undo([Values] bool fromCode)
        {
            FluidSimulation fluid = scene.Add<FluidSimulation>();
            FluidSurface surface = fluid.gameObject.AddComponent<FluidSurface>();
            SurfaceLook water = surface.Look;
            Undo.IncrementCurrentGroup();
            foreach (FluidPreset preset in Shipped)
            {
                if (fromCode)
                    preset.ApplyTo(fluid);
                else
                    FluidPresets.Apply(preset, new Object[] { fluid });
                Assert.That(fluid.Material, Is.EqualTo(preset.Material), preset.name);
                Assert.That((surface.Preset, surface.Look), Is.EqualTo((preset.Surface, preset.Look)), preset.name);
                Assert.That(FluidPresets.IndexOf(fluid), Is.EqualTo(FluidPresets.All.ToList().IndexOf(preset)));
            }
            FluidPresets.Apply(Named("Honey"), new Object[] { fluid });
            Assert.That(surface.Preset, Is.EqualTo(SurfacePreset.Honey));
            surface.Preset = SurfacePreset.Milk;
            Assert.That(FluidPresets.IndexOf(fluid), Is.EqualTo(-1), "honey that looks like milk");
            if (fromCode)
                return;
            Undo.PerformUndo();
            Assert.That(fluid.Material, Is.EqualTo(FluidMaterial.Water));
            Assert.That((surface.Preset, surface.Look), Is.EqualTo((SurfacePreset.Water, water)));
        }

        [Test]
        public void Fluids_of_the_package_that_differ_look_different()
        {
            string[] same = Shipped.GroupBy(preset => preset.Look).Where(group => group.Count() > 1)
                .Select(group => string.Join(", ", group.Select(preset => preset.name).OrderBy(name => name))).ToArray();
            Assert.That(same, Is.EqualTo(new[] { "Seawater, Water" }));
        }

        [Test]
        public void A_fluid_that_is_saved_as_a_preset_is_among_them_and_gives_the_same_again()
        {
            FluidSimulation fluid = scene.Add<FluidSimulation>(), other = scene.Add<FluidSimulation>();
            FluidSurface surface = fluid.gameObject.AddComponent<FluidSurface>(), drawn = other.gameObject.AddComponent<FluidSurface>();
            FluidMaterial material = FluidMaterial.Viscous(1100f, 3f);
            SurfaceLook look = SurfaceLook.Of(SurfacePreset.Wine);
            look.roughness = 0.2f;
            (fluid.Material, surface.Look) = (material, look);
            const string Path = "Assets/Honey.asset";
            try
            {
                FluidPreset saved = FluidPresets.Save(fluid, Path);
                Assert.That(FluidPresets.All.Last(), Is.SameAs(saved), "after those of the package");
                Assert.That(FluidPresets.Names, Is.Unique.And.Member("Honey (Assets∕Honey.asset)"), "another Honey");
                FluidPresets.All.Last().ApplyTo(other);
                Assert.That((other.Material, drawn.Preset, drawn.Look), Is.EqualTo((material, SurfacePreset.Custom, look)));
                fluid.Material = FluidMaterial.Viscous(1200f, 3f);
                Assert.That(FluidPresets.Save(fluid, Path), Is.SameAs(saved), "references to it stay");
                Assert.That(saved.Material.density, Is.EqualTo(1200f));
            }
            finally
            {
                AssetDatabase.DeleteAsset(Path);
            }
            Assert.That(FluidPresets.All, Is.EquivalentTo(Shipped), "a deleted one is gone");
        }

        [Test]
        public void A_preset_out_of_range_is_brought_back_with_a_warning_by_name()
        {
            var preset = ScriptableObject.CreateInstance<FluidPreset>();
            try
            {
                preset.name = "Mine";
                FluidMaterial material = FluidMaterial.Water;
                material.density = -5f;
                LogAssert.Expect(LogType.Warning, new Regex("FluidPreset 'Mine': density"));
                preset.Material = material;
                Assert.That(preset.Material.density, Is.EqualTo(1e-3f));
                Assert.That(ProblemList.Of(new Object[] { preset }), Has.Exactly(1).Contains("Density"));
                Assert.That(() => preset.ApplyTo(null), Throws.ArgumentNullException);
            }
            finally
            {
                Object.DestroyImmediate(preset);
            }
        }

        static IEnumerable<FluidPreset> Shipped
            => FluidPresets.All.Where(preset => AssetDatabase.GetAssetPath(preset).StartsWith(FluidPresets.Folder));

        static FieldInfo[] Fields => typeof(FluidMaterial).GetFields(BindingFlags.Public | BindingFlags.Instance);

        // Water but for one of its values.
        static FluidMaterial Changed(FieldInfo field)
        {
            object material = FluidMaterial.Water;
            object before = field.GetValue(material);
            field.SetValue(material, before is bool on ? !on : (object)(0.5f * (float)before + 0.01f));
            return (FluidMaterial)material;
        }

        static string Described(string name, float spacing) => PresetText.Describe(Named(name), spacing);

        static FluidPreset Named(string name) => Shipped.Single(preset => preset.name == name);
    }
}
