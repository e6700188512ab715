using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using NUnit.Framework;
using Rill;
using Rill.Editor;
using Rill.Tests;
using UnityEditor;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace Host.Tests
{
    /// <summary>Scripts are reloaded with each component of the package, each of its inspectors and its window: in edit mode, while a fluid is
    /// simulated there, and during play. Nothing is logged, nothing is left on the GPU, and all goes on.</summary>
    public class ReloadTests : InspectorFixture
    {
        static readonly string[] Runtime = { "Rill", "Rill.Physics", "Rill.Terrain", "Rill.TerrainPhysics", "Rill.Timeline" };

        readonly List<Object> held = new List<Object>();        // that no scene holds
        string folder;
        EditModeScene scene;

        static IEnumerable<Type> Types(params string[] assemblies)
            => assemblies.SelectMany(name => Assembly.Load(name).GetTypes()).Where(type => !type.IsAbstract);

        /// <summary>The components of the package, those of its optional assemblies too.</summary>
        static IEnumerable<Type> Components => Types(Runtime).Where(typeof(MonoBehaviour).IsAssignableFrom);

        static IEnumerable<Type> Assets => Types(Runtime).Where(typeof(ScriptableObject).IsAssignableFrom);

        static IEnumerable<string> SamplesWithScripts
            => Directory.GetDirectories(Path.Combine(Session.Root(), "Samples~")).Where(folder => Directory.GetFiles(folder, "*.cs").Length > 0)
                .Select(Path.GetFileName).OrderBy(name => name, StringComparer.Ordinal);

        [OneTimeSetUp]
        public void LoadScripts()
        {
            EditorInitializers.Run();
            foreach (string editor in new[] { "Rill.Editor", "Rill.Physics.Editor", "Rill.Terrain.Editor", "Rill.TerrainPhysics.Editor" })
                Assembly.Load(editor);
            folder = Path.Combine(Path.GetTempPath(), "rill-reload-" + Guid.NewGuid().ToString("N"));
            Directory.CreateDirectory(folder);
        }

        [OneTimeTearDown]
        public void DeleteRecordings() => Directory.Delete(folder, true);

        [TearDown]
        public void EndScene()
        {
            SceneSimulation.Stop();
            PlayerLoop.Reset();
            foreach (Object one in held)
                Object.DestroyImmediate(one);
            held.Clear();
        }

        [TestCaseSource(nameof(Components))]
        public void An_idle_component_is_as_before_in_edit_mode(Type type)
        {
            MonoBehaviour component = Make(type, false);
            Editor inspector = Inspect(component);
            Draw(inspector);
            VolumePreview.Draw(scene.Volume);
            VolumePreview.Clear();
            List<string> before = Alive(), stored = EditModeScene.Stored();
            VolumePreview.Draw(scene.Volume);
            for (int time = 0; time < 2; time++)
            {
                Reload();
                Assert.That(Alive(), Is.EqualTo(before));
                Assert.That(EditModeScene.Stored(), Is.EqualTo(stored));
                Draw(inspector);
                DrawHandles(inspector);
            }
        }

        [TestCaseSource(nameof(Components))]
        public void A_simulation_without_Play_ends_and_can_begin_again(Type type)
        {
            MonoBehaviour component = Make(type, false);
            Editor inspector = Inspect(component);
            List<string> before = Alive();
            for (int time = 0; time < 2; time++)
            {
                scene.Simulate();
                EditModeScene.Step(2);
                Draw(inspector);
                Reload();
                Assert.That(SceneSimulation.Current, Is.Null);
                Assert.That(component.runInEditMode, Is.False);
                Assert.That(Alive(), Is.EqualTo(before));
                Draw(inspector);
            }
        }

        [TestCaseSource(nameof(Components))]
        public void In_play_mode_it_goes_on_and_a_disabled_one_holds_nothing(Type type)
        {
            MonoBehaviour component = Make(type, true);
            Editor inspector = Inspect(component);
            Play(3);
            List<string> before = Alive();
            for (int time = 1; time <= 2; time++)
            {
                for (int i = 0; i < time; i++)
                    Reload();
                AssertRecorded(component as FluidRecorder);
                Begin(component);
                Draw(inspector);
                Play(3);
                AssertRuns();
                Assert.That(Alive(), Is.EqualTo(before));
            }
            FluidSimulation[] fluids = Object.FindObjectsByType<FluidSimulation>(FindObjectsSortMode.None);
            Enable(component, false);
            Play(1);
            foreach (FluidSimulation fluid in fluids)
                fluid.gameObject.SetActive(false);
            Reload();
            Assert.That(fluids.Any(fluid => fluid.HasKeptState), Is.False);
            Assert.That(BufferStorage.Live.Select(buffer => buffer.Name), Is.Empty);
            foreach (FluidSimulation fluid in fluids)
                fluid.gameObject.SetActive(true);
            Enable(component, true);
            Play(1);
            AssertRuns();
        }

        [TestCaseSource(nameof(Assets))]
        public void An_asset_and_its_inspector_are_as_before(Type type)
        {
            EditMode.IsOn = true;
            ScriptableObject asset = ScriptableObject.CreateInstance(type);
            try
            {
                Editor inspector = Inspect(asset);
                Draw(inspector);
                List<string> before = Alive();
                for (int time = 0; time < 2; time++)
                {
                    Reload();
                    Draw(inspector);
                    Assert.That(Alive(), Is.EqualTo(before));
                }
            }
            finally
            {
                Object.DestroyImmediate(asset);
            }
        }

        [TestCaseSource(nameof(SamplesWithScripts))]
        public void A_sample_goes_on_in_play_mode(string sample)
        {
            using var played = new SampleScene(sample);
            foreach (FluidSimulation large in Object.FindObjectsByType<FluidSimulation>(FindObjectsSortMode.None))
                large.Configure(large.DomainSize, large.ParticleSpacing, Math.Min(large.Capacity, 3000));
            Play(2);
            List<string> before = null;     // some of it comes once a fluid has begun during play
            for (int time = 0; time < 3; time++)
            {
                Reload();
                Play(2);
                before ??= Alive();
                Assert.That(Alive(), Is.EqualTo(before));
            }
        }

        [Test]
        public void Every_script_of_the_samples_is_in_one_of_their_scenes()
        {
            var played = new HashSet<Type>();
            foreach (string sample in SamplesWithScripts)
                using (new SampleScene(sample))
                    played.UnionWith(Resources.FindObjectsOfTypeAll<MonoBehaviour>().Select(script => script.GetType()));
            Assert.That(Types("Rill.Samples").Where(typeof(MonoBehaviour).IsAssignableFrom), Is.SubsetOf(played));
        }

        [Test]
        public void The_bake_window_keeps_the_meshes_that_were_chosen()
        {
            EditMode.IsOn = true;
            GameObject cube = GameObject.CreatePrimitive(PrimitiveType.Cube), ball = GameObject.CreatePrimitive(PrimitiveType.Sphere);
            BakeWindow window = BakeWindow.Open(new Object[] { cube });
            try
            {
                Selection.activeObject = ball;
                window.Choose(new Object[] { cube });
                Reload();
                Assert.That(window.Plan.Items.Select(item => item.Mesh.name), Is.EqualTo(new[] { "Cube" }));
                Assert.That(GuiPasses.Draw(() => Call(window, "OnGUI")), Is.Null);
                window.Choose(new Object[0]);
                Reload();
                Assert.That(window.Plan.Items.Select(item => item.Mesh.name), Is.EqualTo(new[] { "Sphere" }), "as a window that opens");
            }
            finally
            {
                window.Close();
            }
        }

        [Test]
        public void The_inspector_of_a_field_keeps_the_settings_that_were_typed()
        {
            EditMode.IsOn = true;
            var field = ScriptableObject.CreateInstance<SignedDistanceField>();
            held.Add(field);
            Editor inspector = Inspect(field);
            var typed = new SerializedObject(inspector);
            typed.FindProperty("settings.resolution").intValue = 37;
            typed.ApplyModifiedProperties();
            Reload();
            Assert.That(new SerializedObject(inspector).FindProperty("settings.resolution").intValue, Is.EqualTo(37));
            Draw(inspector);
        }

        [Test]
        public void After_a_reload_in_play_mode_the_end_of_play_waits_for_what_is_pending()
        {
            scene = new EditModeScene(plays: true, surface: false);
            scene.Fluid.StatisticsInterval = 1;
            scene.Fluid.KeepStateOnDisable = false;
            Reload();
            EditModeScene.Play(1);
            scene.Fluid.enabled = false;
            Assert.That(PendingReadbacks.Count, Is.GreaterThan(0));
            Application.RaiseQuitting();
            Assert.That(PendingReadbacks.Count, Is.Zero);
        }

        // All that is alive: on the GPU, in native memory, and of the engine's objects. Assets and the engine's own textures and materials come
        // as they are asked for.
        static List<string> Alive()
            => LiveObjects.Report().Concat(Resources.FindObjectsOfTypeAll<Object>().Where(o => !IsOnDemand(o))
                .Select(o => $"{o.GetType().Name} '{o.name}'")).OrderBy(line => line, StringComparer.Ordinal).ToList();

        static bool IsOnDemand(Object o)
            => o is ComputeShader || o is Shader || EditorUtility.IsPersistent(o) || o is Texture && !o.name.StartsWith("Rill")
                || o is Material && o.name.StartsWith("Hidden/") && !o.name.StartsWith("Hidden/Rill/") || o is Mesh mesh && mesh.IsBuiltIn;

        // With what it needs beside it, which would miss it.
        void Enable(MonoBehaviour component, bool on)
        {
            foreach (MonoBehaviour script in component.GetComponents<MonoBehaviour>())
                if (ReferenceEquals(script, component) || !component.TryGetComponent(out FluidSimulation _))
                    script.enabled = on;
        }

        void Reload()
        {
            EditorReload.Run();
            AssertNoErrors();
        }

        void Play(int frames)
        {
            EditModeScene.Play(frames);
            AsyncGPUReadback.WaitAllRequests();
            AssertNoErrors();
        }

        static void Call(object on, string method) => on.GetType().GetMethod(method, BindingFlags.Instance | BindingFlags.NonPublic).Invoke(on, null);

        void AssertRuns() => Assert.That(scene.Fluid.StepCount > 0 || scene.Fluid.IsPlayedBack);

        void AssertNoErrors()
            => Assert.That(Logged.Where(line => !line.StartsWith("Log") && !line.StartsWith("Warning")), Is.Empty);

        // A scene with one of the type where it belongs, on the fluid or on an object in its box, and with what it needs to have something
        // to hold.
        MonoBehaviour Make(Type type, bool plays)
        {
            if (type == typeof(FluidPlayback))
                RecordOnce();
            bool isDrawn = type == typeof(FluidSimulation) || typeof(FluidRenderer).IsAssignableFrom(type);
            scene = new EditModeScene(plays, surface: isDrawn);
            if (isDrawn)
                Show();
            bool isOfFluid = type.GetCustomAttributes<RequireComponent>(true).Any(needs => needs.m_Type0 == typeof(FluidSimulation));
            if (scene.Fluid.GetComponentInChildren(type) is MonoBehaviour there)
                return there;
            GameObject on = isOfFluid ? scene.Fluid.gameObject : NeedsSkin(type) ? Hold(new SkinnedArm()).Object : new GameObject(type.Name);
            on.SetActive(false);
            if (!isOfFluid)
                on.transform.SetParent(scene.Fluid.transform, false);
            if (type == typeof(FluidTerrain))
                on.AddComponent<Terrain>().terrainData = Ground();
            var made = (MonoBehaviour)on.AddComponent(type);
            switch (made)
            {
                case FluidPhysicsColliders colliders:
                    colliders.ColliderLayers = 1;
                    Child("Box").AddComponent<BoxCollider>().size = 0.2f * Vector3.one;
                    Child("Ground").AddComponent<TerrainCollider>().terrainData = Ground();
                    break;
                case FluidBuoyancy body:
                    var part = body.gameObject.AddComponent<FluidCollider>();
                    part.Shape = ColliderShape.Sphere;
                    part.Radius = 0.1f;
                    break;
                case FluidConnection connection:
                    connection.First = scene.Fluid;
                    connection.Second = Neighbor();
                    break;
                case FluidFollow follow:
                    follow.Target = new GameObject("Target").transform;
                    follow.Target.position = new Vector3(0.3f, 0f, 0f);
                    break;
                case FluidPlayback playback:
                    playback.Recording = Recording;
                    break;
            }
            on.SetActive(true);
            if (made is FluidBoneColliders bones)
                Assert.That(bones.Fit(), Is.EqualTo(2));
            Begin(made);
            return made;
        }

        // A reload ends a recording.
        void Begin(MonoBehaviour made)
        {
            if (made is FluidRecorder recorder && Application.isPlaying)
                recorder.Record(Recorded);
        }

        // The file of before is whole.
        void AssertRecorded(FluidRecorder recorder)
        {
            if (recorder == null)
                return;
            Assert.That(recorder.IsRecording, Is.False);
            using (RecordingReader reader = new RecordingReader(File.OpenRead(Recorded)))
                Assert.That((reader.FrameCount > 0, reader.WasCutShort), Is.EqualTo((true, false)));
        }

        string Recorded => Path.Combine(folder, "recorded.rillrec");

        static bool NeedsSkin(Type type) => type == typeof(FluidDeformingMesh) || type == typeof(FluidBoneColliders);

        // Shows what it is drawn into, and a shadow on it.
        void Show()
        {
            new GameObject("Camera").AddComponent<Camera>().transform.position = new Vector3(0f, 0f, -3f);
            Light sun = new GameObject("Sun").AddComponent<Light>();
            (sun.type, sun.shadows) = (LightType.Directional, LightShadows.Hard);
            scene.Fluid.GetComponent<FluidSurface>().ReceiveShadows = true;
            PlayerLoop.Frame(0f);       // the sky is there
        }

        GameObject Child(string name)
        {
            var child = new GameObject(name);
            child.transform.SetParent(scene.Fluid.transform, false);
            return child;
        }

        FluidSimulation Neighbor()
        {
            var other = new GameObject("Neighbor");
            other.SetActive(false);
            other.transform.position = new Vector3(0.5f, 0f, 0f);
            var fluid = other.AddComponent<FluidSimulation>();
            fluid.Configure(scene.Fluid.DomainSize, scene.Fluid.ParticleSpacing, scene.Fluid.Capacity);
            other.AddComponent<FluidVolume>().Size = new Vector3(0.5f, 0.5f, 0.8f);
            other.SetActive(true);
            return fluid;
        }

        TerrainData Ground()
        {
            var data = new TerrainData { heightmapResolution = 33, size = new Vector3(1f, 0.2f, 1f) };
            held.Add(data);
            return data;
        }

        SkinnedArm Hold(SkinnedArm arm)
        {
            held.Add(arm.Mesh);
            return arm;
        }

        string Recording => Path.Combine(folder, "played.rillrec");

        // Records six frames.
        void RecordOnce()
        {
            if (File.Exists(Recording))
                return;
            FluidRecorder recorder = new EditModeScene(plays: true, surface: false).Fluid.gameObject.AddComponent<FluidRecorder>();
            recorder.Record(Recording);
            Play(6);
            PlayerLoop.Reset();
        }
    }
}
