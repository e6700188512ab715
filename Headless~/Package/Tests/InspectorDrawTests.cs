using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Rill;
using Rill.Editor;
using UnityEditor;
using UnityEditor.IMGUI.Controls;
using UnityEngine;
using UnityEngine.Headless;
using Object = UnityEngine.Object;

namespace Host.Tests
{
    /// <summary>That the package's inspectors and handles draw what their plain classes say, without a fault.</summary>
    public class InspectorDrawTests : InspectorFixture
    {
        static IEnumerable<Type> Inspected => Inspectors.Where(pair => typeof(RillEditor).IsAssignableFrom(pair.editor))
            .Select(pair => pair.inspected);

        [Test]
        public void Every_component_and_asset_of_the_package_has_an_inspector()
        {
            var inspected = new HashSet<Type>(Inspectors.Select(pair => pair.inspected));
            var wanted = new[] { typeof(FluidSimulation).Assembly, typeof(FluidBuoyancy).Assembly,
                typeof(FluidTerrain).Assembly }.SelectMany(assembly => assembly.GetTypes())
                .Where(type => type.IsPublic && !type.IsAbstract
                    && (typeof(MonoBehaviour).IsAssignableFrom(type) || typeof(ScriptableObject).IsAssignableFrom(type)));
            // The asset of a bake has its own kind of inspector.
            Assert.That(wanted.Where(type => type != typeof(SignedDistanceField)), Is.SubsetOf(inspected));
        }

        [Test]
        public void The_inspector_of_a_snapshot_says_why_it_cannot_be_used()
        {
            var asset = ScriptableObject.CreateInstance<FluidSnapshotAsset>();
            try
            {
                Draw(Inspect(asset));
                Assert.That(GuiTrace.HelpBoxes.Select(box => box.text), Has.Some.Contain("holds no snapshot: save one into it"));
            }
            finally
            {
                Object.DestroyImmediate(asset);
            }
        }

        [TestCaseSource(nameof(Inspected))]
        public void An_inspector_of_one_and_of_two_draws_the_fields_that_have_a_meaning(Type type)
        {
            foreach (int count in new[] { 1, 2 })
            {
                var editor = (RillEditor)Inspect(Enumerable.Range(0, count).Select(_ => Make(type)).ToArray());
                Draw(editor);
                string[] expected = editor.Sections.SelectMany(section => section.Shown(editor.serializedObject))
                    .Select(field => field.Path).ToArray();
                Assert.That(GuiTrace.Fields.Select(field => field.path), Is.EqualTo(expected));
                Assert.That(GuiTrace.Fields.Any(field => field.mixed), Is.False);
                DrawHandles(editor);
            }
        }

        [Test]
        public void No_inspector_clips_a_text_at_300_pixels([ValueSource(nameof(Inspected))] Type type, [Values(300f, 350f)] float width)
        {
            EditorGUIUtility.currentViewWidth = width;
            Draw(Inspect(Make(type)));
            Assert.That(GuiDrawing.Labels, Is.Not.Empty);
            Assert.That(GuiDrawing.Clipped(), Is.Empty);
        }

        [TestCase(EventType.Repaint)]
        [TestCase(EventType.Layout)]
        public void A_row_that_one_pass_alone_draws_is_seen(EventType pass)
        {
            Assert.That(GuiPasses.Draw(() => GUILayout.Button("Always")), Is.Null);
            Assert.That(GuiPasses.Draw(() =>
            {
                if (Event.current.type == pass)
                    GUILayout.Button("Now and then");
            }), Does.Contain("button 0"));
        }

        [Test]
        public void A_text_that_is_clipped_is_seen()
        {
            EditorGUIUtility.currentViewWidth = 300f;
            EditorGUILayout.LabelField("Density error C+", "mean 0.20 %, 99.9 % below 1.3 %, most 4 %");
            EditorGUI.PropertyField(new Rect(0f, 0f, 250f, 18f),
                new SerializedObject(Make(typeof(FluidSimulation))).FindProperty("material.artificialPressureDistance"),
                new GUIContent("Artificial Pressure Distance (support radii)"));
            Assert.That(GuiDrawing.Clipped().Count(), Is.EqualTo(2));
        }

        [Test]
        public void The_inspector_of_a_running_fluid_clips_no_text_at_300_pixels()
        {
            Player.GpuTimes = GpuTimes.Samples;
            EditorGUIUtility.currentViewWidth = 300f;
            var fluid = SceneSetup.CreateFluid(null).GetComponent<FluidSimulation>();
            fluid.Configure(fluid.DomainSize, 0.1f, 2000);
            SolverBudget budget = SolverBudget.Default;
            budget.mode = BudgetMode.Milliseconds;
            fluid.Budget = budget;
            Editor editor = Inspect(fluid);
            for (int i = 0; i < 25; i++)
            {
                PlayerLoop.Frame(1f / 60f);
                Player.Device.WaitIdle();
                Draw(editor);
            }
            Assert.That(GuiDrawing.Labels.Select(label => label.text),
                Has.Some.StartWith("mean ").And.Some.EndWith(" ms").And.Some.EqualTo("Density error C+"));
            Assert.That(GuiDrawing.Clipped(), Is.Empty);
        }

        [Test]
        public void A_bare_fluid_offers_what_it_lacks_and_a_click_adds_it()
        {
            var bare = new GameObject("Bare");
            var fluid = bare.AddComponent<FluidSimulation>();
            Selection.activeGameObject = bare;
            Editor editor = Inspect(fluid);
            Draw(editor);
            Assert.That(GuiDrawing.Buttons, Is.SupersetOf(new[] { "Add Fluid Surface", "Add Fluid Volume" }));
            Assert.That(GuiTrace.HelpBoxes.Select(box => box.text), Has.Some.StartWith("Nothing draws").And.Some.Contain("fills this fluid"));

            foreach (string button in new[] { "Add Fluid Surface", "Add Fluid Volume" })
            {
                Undo.IncrementCurrentGroup();
                GuiDrawing.Press = text => text == button;
                Draw(editor);
                GuiDrawing.Press = null;
                Draw(editor);
                Assert.That(GuiDrawing.Buttons, Has.No.Member(button));
                Assert.That(Undo.GetCurrentGroupName(), Is.EqualTo(button));
            }
            Assert.That(bare.GetComponent<FluidSurface>() != null && bare.GetComponentInChildren<FluidVolume>() != null);
            Assert.That(Selection.activeGameObject, Is.SameAs(bare), "so that the other can be added too");
            Undo.PerformUndo();
            Undo.PerformUndo();
            Draw(editor);
            Assert.That(GuiDrawing.Buttons, Is.SupersetOf(new[] { "Add Fluid Surface", "Add Fluid Volume" }), "both were undone");
        }

        [Test]
        public void The_inspector_of_a_fluid_begins_with_Simulate_and_Deep_Water()
        {
            EditMode.IsOn = true;
            try
            {
                var fluid = SceneSetup.CreateFluid(null).GetComponent<FluidSimulation>();
                Draw(Inspect(fluid));
                Assert.That(GuiDrawing.Buttons, Has.Member("Simulate"));
                string[] labels = GuiDrawing.Labels.Select(label => label.text).ToArray();
                int line = Array.IndexOf(labels, "Deep Water");
                Assert.That(line, Is.GreaterThanOrEqualTo(0).And.LessThan(Array.IndexOf(labels, "Domain Size")));
                Assert.That(labels[line + 1], Does.StartWith("on: water 37 layers deep, more than 4"));      // the drop reaches up to 1.12 m
            }
            finally
            {
                EditMode.IsOn = false;
            }
        }

        [Test]
        public void A_body_in_deep_water_without_Deep_Water_has_a_warning_in_its_inspector()
        {
            var fluid = SceneSetup.CreateFluid(null).GetComponent<FluidSimulation>();
            fluid.Configure(fluid.DomainSize, 0.07f, 4000);
            GameObject body = SceneSetup.CreateCollider(fluid.gameObject);
            Object buoyancy = body.AddComponent<FluidBuoyancy>();
            var colliders = fluid.gameObject.AddComponent<FluidPhysicsColliders>();
            colliders.FloatingLayers = 1;
            foreach ((DeepWater mode, bool warns) in new[] { (DeepWater.Automatic, false), (DeepWater.Off, true) })
                foreach (Object inspected in new[] { buoyancy, colliders })
                {
                    fluid.DeepWater = mode;
                    PlayerLoop.Frame(1f / 60f);
                    Draw(Inspect(inspected));
                    Assert.That(GuiTrace.HelpBoxes.Any(box => box.text.Contains("Above 14 layers")), Is.EqualTo(warns), $"{inspected} {mode}");
                }
            colliders.FloatingLayers = 0;
            Draw(Inspect(colliders));
            Assert.That(GuiTrace.HelpBoxes.Select(box => box.text), Has.None.Contain("14 layers"), "it carries nothing");
        }

        [Test]
        public void An_emitter_draws_its_particles_a_second()
        {
            var fluid = SceneSetup.CreateFluid(null);
            Draw(Inspect(SceneSetup.CreateEmitter(fluid).GetComponent<FluidEmitter>()));
            string[] labels = GuiDrawing.Labels.Select(label => label.text).ToArray();
            Assert.That(labels[Array.IndexOf(labels, "Lets in") + 1], Does.EndWith(" particles a second"));
            Assert.That(labels[Array.IndexOf(labels, "Capacity") + 1], Does.Contain(" of 50,000 left, full after "));
        }

        [Test]
        public void Fields_in_which_objects_differ_are_drawn_as_mixed()
        {
            var first = (FluidDrain)Make(typeof(FluidDrain));
            var second = (FluidDrain)Make(typeof(FluidDrain));
            second.RateLimit = 2f;
            Draw(Inspect(first, second));
            Assert.That(GuiTrace.Fields.Where(field => field.mixed).Select(field => field.path), Is.EqualTo(new[] { "rateLimit" }));
            Assert.That(first.RateLimit, Is.Zero, "drawing changes nothing");
        }

        [Test]
        public void What_is_typed_into_a_field_reaches_all_objects_and_is_undone()
        {
            var first = (FluidDrain)Make(typeof(FluidDrain));
            var second = (FluidDrain)Make(typeof(FluidDrain));
            second.RateLimit = 2f;
            Undo.IncrementCurrentGroup();
            GuiTrace.Edit = property =>
            {
                if (property.propertyPath != "rateLimit")
                    return false;
                property.floatValue = 3f;
                return true;
            };
            Draw(Inspect(first, second));
            Assert.That((first.RateLimit, second.RateLimit), Is.EqualTo((3f, 3f)));
            Undo.PerformUndo();
            Assert.That((first.RateLimit, second.RateLimit), Is.EqualTo((0f, 2f)));
        }

        [Test]
        public void Problems_are_drawn_as_help_boxes()
        {
            Draw(Inspect(Make(typeof(FluidDrain))));
            Assert.That(GuiTrace.HelpBoxes.Select(box => box.text), Has.Some.StartWith("There is no FluidSimulation"));
        }

        [Test]
        public void The_inspector_of_a_running_fluid_draws_measurements_times_and_memory()
        {
            Player.GpuTimes = GpuTimes.Samples;
            var fluid = SceneSetup.CreateFluid(null).GetComponent<FluidSimulation>();
            fluid.Configure(fluid.DomainSize, 0.1f, 2000);
            var editor = Inspect(fluid);
            Draw(editor);
            for (int i = 0; i < 25; i++)
            {
                PlayerLoop.Frame(1f / 60f);
                Player.Device.WaitIdle();
                Draw(editor);
            }
            Assert.That(GuiTrace.HelpBoxes.Select(box => box.text), Has.None.Contain("yet").And.None.Contain("tells no GPU time"));
            Assert.That(Logged, Is.Empty);
        }

        [Test]
        public void Inspectors_of_what_acts_on_a_running_fluid_tell_what_it_did()
        {
            GameObject root = SceneSetup.CreateFluid(null);
            var fluid = root.GetComponent<FluidSimulation>();
            fluid.Configure(fluid.DomainSize, 0.1f, 2000);
            var emitter = SceneSetup.CreateEmitter(root).GetComponent<FluidEmitter>();
            var drain = SceneSetup.CreateDrain(root).GetComponent<FluidDrain>();
            drain.Size = fluid.DomainSize;
            var collider = SceneSetup.CreateCollider(root).GetComponent<FluidCollider>();
            collider.MeasuresForce = true;
            for (int i = 0; i < 30; i++)
                PlayerLoop.Frame(1f / 60f);
            Assert.That(Live(emitter)["State"], Is.EqualTo("lets fluid in"));
            Assert.That(Live(emitter)["Emitted"], Does.StartWith($"{emitter.Emitted:N0} particles").And.Not.StartWith("0 "));
            Assert.That(Live(drain)["Drained"], Is.EqualTo($"{drain.Drained:N0} particles").And.Not.StartWith("0 "));
            Assert.That(Live(collider)["Force"], Does.EndWith(" N"));
            emitter.StopEmission();
            Assert.That(Live(emitter)["State"], Is.EqualTo("off"));
        }

        Dictionary<string, string> Live(Object target)
        {
            var editor = (RillEditor)Inspect(target);
            Draw(editor);
            var rows = new List<(string label, string text)>();
            editor.ListLive(rows);
            return rows.ToDictionary(row => row.label, row => row.text);
        }

        [Test]
        public void The_chart_of_times_has_the_stages_that_ran()
        {
            Player.GpuTimes = GpuTimes.Samples;
            using (var times = new StageTimes())
            {
                var fluid = SceneSetup.CreateFluid(null).GetComponent<FluidSimulation>();
                fluid.Configure(fluid.DomainSize, 0.1f, 2000);
                for (int i = 0; i < 8; i++)
                {
                    PlayerLoop.Frame(1f / 60f);
                    Player.Device.WaitIdle();
                    times.Update(Time.frameCount);
                }
                Assert.That(times.Rows.Select(row => row.Label),
                    Is.SupersetOf(new[] { "Sort", "Neighbor list", "Pressure", "Displacement",
                    "Velocity, smoothing" }).And.No.Member("Vorticity").And.No.Member("Emitters"));
                Assert.That(times.Rows.Max(row => row.Fraction), Is.EqualTo(1f));
            }
        }

        [Test]
        public void Dragging_a_face_of_a_box_changes_its_size_and_is_undone()
        {
            var drain = (FluidDrain)Make(typeof(FluidDrain));
            drain.Size = new Vector3(1f, 1f, 1f);
            Editor editor = Inspect(drain);
            Undo.IncrementCurrentGroup();
            DrawHandles(editor);
            Assert.That(drain.Size, Is.EqualTo(Vector3.one), "a handle that no one drags");
            PrimitiveBoundsHandle.Drag = handle =>
            {
                var box = (BoxBoundsHandle)handle;
                box.center = new Vector3(0f, 0.5f, 0f);
                box.size = new Vector3(1f, 2f, 1f);
                return true;
            };
            DrawHandles(editor);
            Assert.That(drain.Size, Is.EqualTo(new Vector3(1f, 3f, 1f)));
            Undo.PerformUndo();
            Assert.That(drain.Size, Is.EqualTo(Vector3.one));
        }

        [Test]
        public void A_jets_box_keeps_its_depth_when_its_cross_section_is_dragged()
        {
            var emitter = (FluidEmitter)Make(typeof(FluidEmitter));
            emitter.Shape = EmitterShape.Box;
            emitter.Size = new Vector3(0.2f, 0.3f, 0.4f);
            PrimitiveBoundsHandle.Drag = handle =>
            {
                Assert.That(handle.axes, Is.EqualTo(PrimitiveBoundsHandle.Axes.X | PrimitiveBoundsHandle.Axes.Y));
                ((BoxBoundsHandle)handle).size = new Vector3(1f, 1f, 0f);
                return true;
            };
            DrawHandles(Inspect(emitter));
            Assert.That(emitter.Size, Is.EqualTo(new Vector3(1f, 1f, 0.4f)));
        }

        [Test]
        public void A_radius_is_dragged_where_a_shape_has_one()
        {
            var volume = (FluidVolume)Make(typeof(FluidVolume));
            volume.Shape = VolumeShape.Sphere;
            var field = (FluidForceField)Make(typeof(FluidForceField));
            field.Bounds = ForceFieldBounds.Sphere;
            var emitter = (FluidEmitter)Make(typeof(FluidEmitter));
            PrimitiveBoundsHandle.Drag = handle =>
            {
                ((SphereBoundsHandle)handle).radius = 0.75f;
                return true;
            };
            foreach (Component one in new Component[] { volume, field, emitter })
                DrawHandles(Inspect(one));
            Assert.That(new[] { volume.Radius, field.Radius, emitter.Radius }, Is.EqualTo(new[] { 0.75f, 0.75f, 0.75f }));
        }

        [Test]
        public void A_colliders_handles_are_where_it_is_in_a_scaled_tree()
        {
            var parent = new GameObject("Parent");
            parent.transform.localScale = new Vector3(2f, 4f, 3f);
            var collider = (FluidCollider)Make(typeof(FluidCollider));
            collider.transform.SetParent(parent.transform, false);
            collider.Center = new Vector3(0.5f, 0f, 0f);
            PrimitiveBoundsHandle.Drag = handle =>
            {
                var box = (BoxBoundsHandle)handle;
                Assert.That((box.center, box.size), Is.EqualTo((new Vector3(1f, 0f, 0f), new Vector3(2f, 4f, 3f))));
                box.center = new Vector3(2f, 2f, 0f);
                box.size = new Vector3(4f, 8f, 3f);
                return true;
            };
            DrawHandles(Inspect(collider));
            Assert.That((collider.Center, collider.Size), Is.EqualTo((new Vector3(1f, 0.5f, 0f), new Vector3(2f, 2f, 1f))));

            collider.Shape = ColliderShape.Capsule;
            collider.Center = Vector3.zero;
            PrimitiveBoundsHandle.Drag = handle =>
            {
                var capsule = (CapsuleBoundsHandle)handle;
                Assert.That((capsule.radius, capsule.height), Is.EqualTo((1.5f, 8f)));
                capsule.radius = 3f;
                capsule.height = 12f;
                return true;
            };
            DrawHandles(Inspect(collider));
            Assert.That((collider.Radius, collider.Height), Is.EqualTo((1f, 3f)));

            PrimitiveBoundsHandle.Drag = handle => throw new InvalidOperationException("a plane has no handle");
            collider.Shape = ColliderShape.Plane;
            DrawHandles(Inspect(collider));
        }

        static Object Make(Type type)
        {
            if (typeof(ScriptableObject).IsAssignableFrom(type))
                return ScriptableObject.CreateInstance(type);
            var made = new GameObject(type.Name);
            made.SetActive(false);
            return made.AddComponent(type);
        }
    }
}
