using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Rill.Editor.Tests
{
    /// <summary>Contents of inspectors, without drawing them.</summary>
    public class InspectorTests
    {
        static readonly Type[] Components =
        {
            typeof(FluidSimulation), typeof(FluidEmitter), typeof(FluidDrain), typeof(FluidForceField), typeof(FluidProbe),
                typeof(FluidDetector), typeof(FluidVolume), typeof(FluidCollider), typeof(FluidConnection), typeof(FluidFollow),
                typeof(FluidBoneColliders), typeof(FluidDeformingMesh),
            typeof(ParticleRenderer), typeof(DomainRenderer), typeof(FluidFoam), typeof(FluidRecorder), typeof(FluidPlayback),
        };

        EditorScene scene;

        [SetUp]
        public void MakeScene() => scene = new EditorScene();

        [TearDown]
        public void DestroyScene() => scene.Dispose();

        [TestCaseSource(nameof(Components))]
        public void Every_serialized_field_of_a_component_is_in_one_section(Type component)
        {
            RillEditor editor = Inspect(scene.Add(component));
            string[] shown = editor.Sections.SelectMany(section => section.Fields).Select(field => field.Path).ToArray();
            Assert.That(shown, Is.EquivalentTo(Fields(component, "")));
            foreach (string path in shown)
                Assert.That(editor.serializedObject.FindProperty(path), Is.Not.Null, path);
        }

        [Test]
        public void Every_serialized_field_of_a_preset_is_in_one_section()
        {
            var preset = ScriptableObject.CreateInstance<FluidPreset>();
            try
            {
                RillEditor editor = Inspect(preset);
                Assert.That(editor.Sections.SelectMany(section => section.Fields).Select(field => field.Path),
                    Is.EquivalentTo(Fields(typeof(FluidPreset), "")));
                foreach (InspectorField field in editor.Sections.SelectMany(section => section.Fields))
                    Assert.That(editor.serializedObject.FindProperty(field.Path), Is.Not.Null, field.Path);
            }
            finally
            {
                Object.DestroyImmediate(preset);
            }
        }

        [Test]
        public void Values_of_structs_alike_are_labeled_with_their_struct()
        {
            RillEditor editor = Inspect(scene.Add(typeof(FluidSimulation)));
            string[] labels = editor.Sections.Single(section => section.Title == "Borders").Fields
                .Select(field => field.Label(editor.serializedObject, editor.serializedObject.FindProperty(field.Path)).text).ToArray();
            Assert.That(labels.Take(2), Is.EqualTo(new[] { "Min X Kind", "Min X Width" }));
            Assert.That(labels, Is.Unique);
        }

        [TestCaseSource(nameof(Components))]
        public void Several_of_a_kind_can_be_edited_together(Type component)
        {
            RillEditor editor = Inspect(scene.Add(component), scene.Add(component));
            Assert.That(editor.GetType().GetCustomAttributes(typeof(CanEditMultipleObjects), false), Is.Not.Empty);
            Assert.That(editor.serializedObject.isEditingMultipleObjects);
            Assert.That(editor.Sections.SelectMany(section => section.Shown(editor.serializedObject)), Is.Not.Empty);
        }

        [TestCaseSource(nameof(Components))]
        public void A_unit_behind_a_value_is_the_one_that_the_tooltip_gives(Type component)
        {
            RillEditor editor = Inspect(scene.Add(component));
            foreach (InspectorField field in editor.Sections.SelectMany(section => section.Fields))
            {
                SerializedProperty property = editor.serializedObject.FindProperty(field.Path);
                string unit = field.Unit(editor.serializedObject);
                GUIContent label = field.Label(editor.serializedObject, property);
                Assert.That(label.text, Does.EndWith(property.displayName));
                bool isSi = new[] { "m", "s", "m/s", "m/s²", "m³/s", "kg/m³", "ms", "1/s" }.Contains(unit);
                if (isSi && unit != "1/s")
                    Assert.That(label.tooltip, Does.Match($@"(^|[ (,]){unit}($|[ ,.:;)])"), field.Path);
            }
        }

        [TestCase(EmitterShape.Box, "size")]
        [TestCase(EmitterShape.Sphere, "radius")]
        [TestCase(EmitterShape.Disc, "radius")]
        [TestCase(EmitterShape.MeshSurface, "mesh")]
        public void Fields_that_a_shape_has_no_use_for_are_hidden(EmitterShape shape, string wanted)
        {
            var emitter = scene.Add<FluidEmitter>();
            Set(emitter, "shape", (int)shape);
            string[] shown = Shown(emitter);
            Assert.That(shown.Intersect(new[] { "size", "radius", "mesh" }), Is.EqualTo(new[] { wanted }));
            Assert.That(shown.Contains("mode"), Is.EqualTo(shape != EmitterShape.MeshSurface));
        }

        [Test]
        public void Objects_that_differ_in_a_choice_show_what_any_of_them_needs()
        {
            FluidDrain box = scene.Add<FluidDrain>(), ball = scene.Add<FluidDrain>();
            Set(ball, "shape", (int)DrainShape.Sphere);
            Assert.That(Shown(box), Has.Member("size").And.No.Member("radius"));
            Assert.That(Shown(ball), Has.Member("radius").And.No.Member("size"));
            Assert.That(Shown(box, ball), Has.Member("radius").And.Member("size"));
        }

        [Test]
        public void The_budgets_settings_are_there_only_while_it_is_on()
        {
            var fluid = scene.Add<FluidSimulation>();
            Assert.That(Shown(fluid).Where(path => path.StartsWith("budget.")), Is.EqualTo(new[] { "budget.mode" }));
            Set(fluid, "budget.mode", (int)BudgetMode.Milliseconds);
            Assert.That(Shown(fluid), Has.Member("budget.milliseconds").And.No.Member("budget.fraction"));
            Set(fluid, "budget.mode", (int)BudgetMode.FrameFraction);
            Assert.That(Shown(fluid), Has.Member("budget.fraction").And.Member("budget.frameRate").And.No.Member("budget.milliseconds"));
        }

        [Test]
        public void Solver_and_what_few_need_begin_folded()
        {
            RillEditor editor = Inspect(scene.Add<FluidSimulation>());
            Assert.That(editor.Sections.Where(section => section.StartsOpen).Select(section => section.Title),
                Is.EqualTo(new[] { "Domain", "Fluid" }));
            Assert.That(editor.Sections.Single(section => section.Title == "Advanced").Fields.Select(field => field.Path), Is.EquivalentTo(new[]
            {
                "material.artificialPressure", "material.artificialPressureDistance", "material.allowedTension", "solver.softness",
                "solver.listMargin", "solver.neighborCapacity",
            }));
        }

        [TestCase(0.02f, 0f, "about 125,000 particles a second", "50,000 of 50,000 left, full after 0.4 s of this emitter alone")]
        [TestCase(0.2f, 0f, "about 125 particles a second", "50,000 of 50,000 left, full after 7 min of this emitter alone")]
        [TestCase(0.2f, 100f, "about 125 particles a second", "50,000 of 50,000 left, enough for the 12,500 of its duration")]
        public void An_emitter_tells_its_particles_and_when_the_capacity_is_full(float spacing, float duration, string lets, string capacity)
        {
            var fluid = scene.Add<FluidSimulation>();
            fluid.Configure(Vector3.one, spacing, 50000);
            var emitter = scene.Add<FluidEmitter>();
            (emitter.Rate, emitter.Duration) = (1f, duration);
            Assert.That(EmissionEstimate.RateText(emitter, fluid), Is.EqualTo(lets));
            Assert.That(EmissionEstimate.CapacityText(emitter, fluid), Is.EqualTo(capacity));
        }

        [Test]
        public void What_volumes_fill_is_not_left_for_an_emitter()
        {
            var fluid = scene.Add<FluidSimulation>();
            fluid.gameObject.SetActive(true);
            fluid.Configure(Vector3.one, 0.1f, 1500);
            var volume = fluid.gameObject.AddComponent<FluidVolume>();
            volume.Size = Vector3.one;
            var emitter = scene.Add<FluidEmitter>();
            emitter.Rate = 0f;
            Assert.That(EmissionEstimate.CapacityText(emitter, fluid), Is.EqualTo("500 of 1,500 left"));
            fluid.Configure(Vector3.one, 0.1f, 1000);
            Assert.That(EmissionEstimate.CapacityText(emitter, fluid), Does.StartWith("0 of 1,000 left").And.Contain("Raise the capacity"));
        }

        [TestCase(ForceFieldKind.Direction, "m/s²")]
        [TestCase(ForceFieldKind.Wind, "m/s")]
        public void The_unit_of_a_strength_is_that_of_its_kind(ForceFieldKind kind, string unit)
        {
            var field = scene.Add<FluidForceField>();
            Set(field, "kind", (int)kind);
            RillEditor editor = Inspect(field);
            Assert.That(editor.Sections.SelectMany(section => section.Fields).Single(f => f.Path == "strength")
                .Unit(editor.serializedObject), Is.EqualTo(unit));
        }

        [Test]
        public void What_HDRP_leaves_out_is_said_where_it_would_be_missed()
        {
            Assert.That(FluidRendererEditor.PipelineNote("HDRenderPipelineAsset", FluidSurfaceEditor.LimitsInHighDefinition),
                Does.Contain("neither fog nor shadows"));
            Assert.That(FluidRendererEditor.PipelineNote("UniversalRenderPipelineAsset", FluidRendererEditor.UnlitInHighDefinition), Is.Null);
            Assert.That(FluidRendererEditor.PipelineNote(null, FluidRendererEditor.UnlitInHighDefinition), Is.Null);
        }

        [Test]
        public void Volumes_are_estimated_by_what_they_hold()
        {
            var box = scene.Add<FluidVolume>();
            box.Size = new Vector3(1f, 0.5f, 0.24f);
            Assert.That(FillEstimate.Particles(box, 0.05f), Is.EqualTo(20 * 10 * 4));
            box.Shape = VolumeShape.Sphere;
            box.Radius = 0.5f;
            Assert.That(FillEstimate.Particles(box, 0.05f), Is.EqualTo(4189).Within(1));
            Assert.That(FillEstimate.Particles(box, 0f), Is.Zero);
            box.Shape = VolumeShape.SignedDistanceField;
            Assert.That(FillEstimate.Particles(box, 0.05f), Is.Zero, "without a field");
        }

        static void Set(Object target, string path, int value)
        {
            var serialized = new SerializedObject(target);
            serialized.FindProperty(path).intValue = value;
            serialized.ApplyModifiedProperties();
        }

        RillEditor Inspect(params Object[] targets)
        {
            UnityEditor.Editor editor = scene.Inspect(targets);
            Assert.That(editor, Is.InstanceOf<RillEditor>());
            return (RillEditor)editor;
        }

        string[] Shown(params Object[] targets)
        {
            RillEditor editor = Inspect(targets);
            return editor.Sections.SelectMany(section => section.Shown(editor.serializedObject)).Select(field => field.Path).ToArray();
        }

        // Structs of the package one by one, as the sections name them.
        static IEnumerable<string> Fields(Type type, string prefix)
        {
            for (Type t = type; t != null && t != typeof(MonoBehaviour) && t != typeof(ScriptableObject) && t != typeof(ValueType); t = t.BaseType)
                foreach (FieldInfo field in t.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic
                    | BindingFlags.DeclaredOnly))
                {
                    if (!field.IsPublic && !field.IsDefined(typeof(SerializeField)) || field.IsDefined(typeof(HideInInspector)))
                        continue;
                    bool isOurs = field.FieldType.IsValueType && !field.FieldType.IsEnum
                        && field.FieldType.Assembly == typeof(FluidSimulation).Assembly;
                    if (!isOurs)
                        yield return prefix + field.Name;
                    else
                        foreach (string path in Fields(field.FieldType, prefix + field.Name + "."))
                            yield return path;
                }
        }
    }
}
