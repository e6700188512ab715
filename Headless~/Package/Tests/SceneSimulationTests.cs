using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using Host.Probing;
using NUnit.Framework;
using Rill;
using Rill.Editor;
using UnityEditor;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Rendering;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Host.Tests
{
    /// <summary>A fluid that is simulated without Play does as in play mode, and leaves nothing in the scene and on the GPU.</summary>
    public class SceneSimulationTests : GraphicsFixture
    {
        const int Steps = 8;

        [SetUp]
        public void ClearUndo() => Undo.ClearAll();

        [TearDown]
        public void StopSimulation() => SceneSimulation.Stop();

        [Test]
        public void Steps_without_Play_are_those_of_play_mode_bit_for_bit()
        {
            new EditModeScene(plays: true);
            EditModeScene.Play(Steps);
            string played = StateHash.OfScene();
            PlayerLoop.Reset();

            var scene = new EditModeScene();
            scene.Simulate();
            EditModeScene.Step(Steps);
            Assert.That(scene.Fluid.StepCount, Is.EqualTo(Steps));
            Assert.That(StateHash.OfScene(), Is.EqualTo(played));
        }

        [Test]
        public void Restart_begins_again_and_takes_the_same_steps()
        {
            SceneSimulation simulation = new EditModeScene().Simulate();
            EditModeScene.Step(Steps);
            string first = StateHash.OfScene();
            simulation.Restart();
            Assert.That(simulation.Fluid.StepCount, Is.Zero);
            EditModeScene.Step(Steps);
            Assert.That(StateHash.OfScene(), Is.EqualTo(first));
        }

        [Test]
        public void Without_Simulate_nothing_runs_and_nothing_is_on_the_GPU()
        {
            var scene = new EditModeScene();
            for (int i = 0; i < 3; i++)
                Update();
            Assert.That(scene.Fluid.IsRunning, Is.False);
            Assert.That(BufferStorage.Live, Is.Empty);
            Assert.That(SceneColliders.Enabled, Is.Empty);
        }

        [Test]
        public void Stop_gives_all_back()
        {
            var scene = new EditModeScene();
            List<string> before = LiveObjects.Report();
            for (int i = 0; i < 2; i++)
            {
                scene.Simulate();
                EditModeScene.Step(3);
                Assert.That(BufferStorage.Live, Is.Not.Empty);
                Assert.That(SceneColliders.Enabled.Count, Is.EqualTo(1));
                SceneSimulation.Stop();
                AssertGone(scene, before);
            }
        }

        [Test]
        public void Nothing_that_the_scene_stores_is_changed()
        {
            var scene = new EditModeScene();
            int undo = Undo.GetCurrentGroup();
            List<string> before = EditModeScene.Stored();
            scene.Simulate();
            EditModeScene.Step(3);
            Assert.That(EditModeScene.Stored(), Is.EqualTo(before), "while it runs");
            SceneSimulation.Stop();
            Assert.That(EditModeScene.Stored(), Is.EqualTo(before), "afterwards");
            Assert.That(Undo.GetCurrentGroup(), Is.EqualTo(undo));
        }

        [Test]
        public void Entering_Play_ends_it()
        {
            AssertEndsBy(scene => EditorApplication.RaisePlayMode(PlayModeStateChange.ExitingEditMode));
        }

        [Test]
        public void A_reload_of_scripts_ends_it()
        {
            AssertEndsBy(scene => AssemblyReloadEvents.RaiseBefore());
        }

        [Test]
        public void Another_fluid_ends_it()
        {
            AssertEndsBy(scene =>
            {
                SceneSimulation.Start(new GameObject("Other").AddComponent<FluidSimulation>());
                Assert.That(scene.Fluid.IsRunning, Is.False);
                SceneSimulation.Stop();
            });
        }

        [Test]
        public void A_fluid_that_is_disabled_gives_all_back_at_once()
        {
            AssertEndsBy(scene => scene.Fluid.gameObject.SetActive(false), () =>
            {
                AssertNoBuffers();
                Update();
                Assert.That(SceneSimulation.Problem, Does.Contain("disabled or deleted"));
            });
        }

        [Test]
        public void A_fluid_that_is_deleted_gives_all_back_at_once()
        {
            var scene = new EditModeScene();
            scene.Simulate();
            EditModeScene.Step(2);
            Object.DestroyImmediate(scene.Fluid.gameObject);
            AssertNoBuffers();
            Update();
            Assert.That(SceneSimulation.Current, Is.Null);
        }

        [Test]
        public void Objects_that_come_and_go_act_while_they_are_there()
        {
            var scene = new EditModeScene();
            scene.Simulate();
            Object.DestroyImmediate(scene.Collider.gameObject);
            var emitter = new GameObject("New").AddComponent<FluidEmitter>();
            emitter.transform.SetParent(scene.Fluid.transform, false);
            EditorApplication.RaiseHierarchyChanged();
            EditModeScene.Step(1);
            Assert.That(emitter.Simulation, Is.SameAs(scene.Fluid));
            Assert.That(scene.Fluid.Inputs.Colliders.Set.Count, Is.Zero);
        }

        [Test]
        public void A_part_of_another_fluid_stays_as_it_is()
        {
            var scene = new EditModeScene();
            var other = new GameObject("Other").AddComponent<FluidSimulation>();
            var part = new GameObject("Part").AddComponent<FluidEmitter>();
            part.transform.SetParent(other.transform, false);
            scene.Simulate();
            Assert.That(part.runInEditMode || other.runInEditMode, Is.False);
            Assert.That(other.IsRunning, Is.False);
        }

        [Test]
        public void Time_passes_as_the_editor_updates_and_a_hitch_is_left_out()
        {
            var scene = new EditModeScene();
            scene.Fluid.StatisticsInterval = 1;
            SceneSimulation simulation = scene.Simulate();
            simulation.IsPaused = false;
            double now = EditorApplication.timeSinceStartup + 1000.0;
            simulation.Advance(now);        // as after 1000 s
            PlayerLoop.Frame(0f);
            AsyncGPUReadback.WaitAllRequests();
            Assert.That(scene.Fluid.TryGetStatistics(out FluidStatistics statistics));
            Assert.That(statistics.droppedTime, Is.EqualTo(1.0 / 3.0 - 4.0 / 60.0).Within(0.02), "no more than a frame can bring");
            int after = scene.Fluid.StepCount;
            Assert.That(after, Is.EqualTo(4), "the most steps of a frame");
            PlayerLoop.Frame(0f);
            Assert.That(scene.Fluid.StepCount, Is.EqualTo(after), "a frame that the scene asked for brings no time");
            simulation.Advance(now + 2.0 / 60.0);
            PlayerLoop.Frame(0f);
            Assert.That(scene.Fluid.StepCount, Is.EqualTo(after + 2));
            simulation.IsPaused = true;
            simulation.Advance(now + 1.0);
            PlayerLoop.Frame(0f);
            Assert.That(scene.Fluid.StepCount, Is.EqualTo(after + 2), "paused");
        }

        [Test]
        public void Time_passes_at_the_chosen_speed_until_another_is_chosen()
        {
            SceneSimulation simulation = new EditModeScene().Simulate();
            simulation.IsPaused = false;
            double now = EditorApplication.timeSinceStartup + 1000.0;
            try
            {
                simulation.Advance(now);
                PlayerLoop.Frame(0f);
                foreach ((float speed, int steps) in new[] { (2f, 4), (0.5f, 1), (7f, 4), (1f, 2) })
                {
                    SceneSimulation.Speed = speed;
                    int before = simulation.Fluid.StepCount;
                    simulation.Advance(now += 2.0 / 60.0);
                    PlayerLoop.Frame(0f);
                    Assert.That(simulation.Fluid.StepCount, Is.EqualTo(before + steps), $"at {speed}");
                }
                SceneSimulation.Speed = 0f;
                Assert.That(SceneSimulation.Speed, Is.EqualTo(0.1f));
                SceneSimulation.Speed = 3f;
                Assert.That(SceneSimulation.Speed, Is.EqualTo(2f));
            }
            finally
            {
                SceneSimulation.Speed = 1f;
            }
        }

        [Test]
        public void The_depth_that_is_told_before_it_runs_is_that_of_the_solver()
        {
            var scene = new EditModeScene();
            float estimated = DeepWaterState.Layers(scene.Fluid);
            string line = DeepWaterState.Describe(scene.Fluid);
            scene.Simulate();
            EditModeScene.Step(8);      // until the emitter has let a particle in
            TestContext.Out.WriteLine($"{estimated} and {DeepWaterState.Layers(scene.Fluid)} layers: {line}");
            Assert.That(DeepWaterState.Layers(scene.Fluid), Is.EqualTo(estimated).Within(1f));
            Assert.That(line, Does.StartWith("on: water"));
            Assert.That(DeepWaterState.Describe(scene.Fluid), Does.StartWith("on: water"));
            Assert.That(scene.Fluid.Solver.Coarse, Is.Not.Null);
            scene.Fluid.DeepWater = DeepWater.Off;
            EditModeScene.Step(1);
            Assert.That(DeepWaterState.Describe(scene.Fluid), Does.StartWith("off: deep water is set to Off"));
        }

        [Test]
        public void A_paused_fluid_of_the_scene_is_simulated_where_no_camera_sees_it()
        {
            var scene = new EditModeScene();
            scene.Fluid.Paused = true;
            scene.Fluid.CullingMode = FluidCullingMode.Pause;
            scene.Simulate();
            EditModeScene.Step(2);
            Assert.That(scene.Fluid.StepCount, Is.EqualTo(2));
        }

        [Test]
        public void A_device_without_compute_shaders_is_told_and_the_component_stays_enabled()
        {
            var scene = new EditModeScene();
            List<string> before = LiveObjects.Report(), stored = EditModeScene.Stored();
            LogAssert.Expect(LogType.Error, new Regex("'Fluid' is off: this device .* has no compute shaders"));
            Player.PretendNoCompute = true;
            SceneSimulation.Start(scene.Fluid);
            Assert.That(SceneSimulation.Problem, Does.Contain("no compute shaders"));
            Player.PretendNoCompute = false;
            AssertGone(scene, before);
            Assert.That(EditModeScene.Stored(), Is.EqualTo(stored));
        }

        [Test]
        public void A_fluid_that_fails_while_it_runs_ends_with_its_problem_and_stays_enabled()
        {
            var scene = new EditModeScene();
            List<string> before = LiveObjects.Report();
            scene.Simulate();
            EditModeScene.Step(1);
            LogAssert.Expect(LogType.Error, new Regex("'Fluid' is off: "));
            scene.Fluid.Configure(new Vector3(1f, 1f, 0.8f), 0f, 2000);
            EditModeScene.Step(1);
            Update();
            Assert.That(SceneSimulation.Problem, Does.Contain("spacing"));
            Assert.That(scene.Fluid.enabled);
            AssertGone(scene, before);
        }

        [Test]
        public void What_cannot_be_simulated_is_said()
        {
            var scene = new EditModeScene();
            scene.Fluid.enabled = false;
            SceneSimulation.Start(scene.Fluid);
            Assert.That(SceneSimulation.Problem, Is.EqualTo("'Fluid' is disabled. Enable the component and its object."));
            EditMode.IsOn = false;
            SceneSimulation.Start(scene.Fluid);
            Assert.That(SceneSimulation.Problem, Does.Contain("play mode"));
        }

        [Test]
        public void The_state_that_is_saved_is_that_of_play_mode_and_the_next_Play_begins_with_it()
        {
            byte[] played;
            var playing = new EditModeScene(plays: true);
            EditModeScene.Play(Steps);
            FluidSnapshotRequest request = playing.Fluid.RequestSnapshot();
            AsyncGPUReadback.WaitAllRequests();
            played = request.Snapshot.ToBytes();
            PlayerLoop.Reset();

            const string Path = "Assets/Saved Start.asset";
            try
            {
                var scene = new EditModeScene();
                scene.Simulate();
                EditModeScene.Step(Steps);
                FluidSnapshotRequest saved = scene.Fluid.RequestSnapshot();
                AsyncGPUReadback.WaitAllRequests();
                Assert.That(saved.Snapshot.ToBytes(), Is.EqualTo(played));
                SnapshotAssets.SaveAsStart(scene.Fluid, saved.Snapshot, Path);
                FluidSnapshotAsset asset = scene.Fluid.StartState;
                Assert.That(AssetDatabase.GetAssetPath(asset), Is.EqualTo(Path));
                SceneSimulation.Stop();     // here an undo makes a fluid's references again, and nothing would give back what is held
                Undo.PerformUndo();
                Assert.That(scene.Fluid.StartState, Is.Null);
                Undo.PerformRedo();
                Assert.That(scene.Fluid.StartState, Is.SameAs(asset));

                // Again, from the buttons, into the same asset.
                scene.Simulate();
                EditModeScene.Step(1);
                SceneSimulation.Current.SaveAsStart();
                AsyncGPUReadback.WaitAllRequests();
                Update();
                Assert.That(SceneSimulation.Current.IsSaving, Is.False);
                Assert.That(scene.Fluid.StartState, Is.SameAs(asset), "in place");
                Assert.That(asset.Snapshot.StepCount, Is.EqualTo(1));
                var particles = EditModeScene.Particles(scene.Fluid);
                SceneSimulation.Stop();
                PlayerLoop.Reset();

                var next = new EditModeScene(plays: true);
                next.Fluid.StartState = asset;
                next.Fluid.Restart();
                Assert.That(next.Fluid.StepCount, Is.Zero);
                Assert.That(EditModeScene.Particles(next.Fluid), Is.EqualTo(particles));
            }
            finally
            {
                AssetDatabase.DeleteAsset(Path);
            }
        }

        [Test]
        public void A_state_that_is_on_its_way_when_the_simulation_ends_is_not_saved()
        {
            var scene = new EditModeScene();
            List<string> before = LiveObjects.Report();
            SceneSimulation simulation = scene.Simulate();
            EditModeScene.Step(1);
            simulation.SaveAsStart();
            SceneSimulation.Stop();
            Assert.That(Logged, Has.Some.Contain("the state was not saved: the simulation ended"));
            AsyncGPUReadback.WaitAllRequests();
            AssertGone(scene, before);
            Assert.That(scene.Fluid.StartState, Is.Null);
        }

        [Test]
        public void A_fluid_that_nothing_fills_is_named_in_the_scene_view()
        {
            var scene = new EditModeScene();
            Object.DestroyImmediate(scene.Volume.gameObject);
            Object.DestroyImmediate(scene.Emitter.gameObject);
            Selection.activeGameObject = scene.Fluid.gameObject;
            Assert.That(GuiPasses.Draw(new FluidOverlay().OnGUI), Is.Null);
            Assert.That(GuiTrace.HelpBoxes.Select(box => box.text), Has.Some.Contain("fills this fluid"));
            Selection.activeObject = null;
        }

        [Test]
        public void The_buttons_do_what_they_say()
        {
            var scene = new EditModeScene();
            Press(scene, "Simulate");
            Assert.That(SceneSimulation.Runs(scene.Fluid));
            Press(scene, "Pause");
            Assert.That(SceneSimulation.Current.IsPaused);
            Press(scene, "Step");
            Update();
            Assert.That(scene.Fluid.StepCount, Is.EqualTo(1));
            Press(scene, "Go On");
            Assert.That(SceneSimulation.Current.IsPaused, Is.False);
            Press(scene, "Restart");
            Assert.That(scene.Fluid.StepCount, Is.Zero);
            Press(scene, "Save as Start State");
            Assert.That(SceneSimulation.Current.IsSaving);
            AsyncGPUReadback.WaitAllRequests();
            Update();       // no file was named
            Assert.That(SceneSimulation.Current.IsSaving, Is.False);
            Assert.That(scene.Fluid.StartState, Is.Null);
            Press(scene, "Stop");
            Assert.That(SceneSimulation.Current, Is.Null);
        }

        [Test]
        public void The_scene_view_has_the_buttons_of_what_is_simulated_else_of_what_is_selected()
        {
            var overlay = new FluidOverlay();
            var scene = new EditModeScene();
            Selection.activeObject = null;
            Assert.That(overlay.visible, Is.False);
            Selection.activeGameObject = scene.Volume.gameObject;
            Assert.That(overlay.visible);
            Assert.That(GuiPasses.Draw(overlay.OnGUI), Is.Null);
            Assert.That(GuiDrawing.Buttons, Is.EqualTo(new[] { "Simulate" }));
            scene.Simulate();
            Selection.activeObject = null;
            Assert.That(overlay.visible, "also while something else is selected");
            Assert.That(GuiPasses.Draw(overlay.OnGUI), Is.Null);
            Assert.That(GuiDrawing.Buttons, Is.EqualTo(new[] { "Go On", "Step", "Restart", "Stop", "Save as Start State" }));
            Assert.That(GuiTrace.HelpBoxes.Single().text, Does.StartWith("Paused: 0.00 s, step 0."));
            SceneSimulation.Stop();
            EditMode.IsOn = false;
            Selection.activeGameObject = scene.Volume.gameObject;
            Assert.That(overlay.visible, Is.False, "in play mode");
            Selection.activeObject = null;
        }

        [Test]
        public void Colliders_of_the_physics_hold_the_water_where_they_are_dragged_to()
        {
            var scene = new EditModeScene();
            scene.Collider.enabled = false;
            scene.Fluid.gameObject.AddComponent<FluidPhysicsColliders>().ColliderLayers = 1;
            var box = new GameObject("Box").AddComponent<BoxCollider>();
            box.transform.position = 10f * Vector3.one;
            Physics.SyncTransforms();
            scene.Simulate();
            EditModeScene.Step(1);
            Assert.That(scene.Fluid.Inputs.Colliders.Set.Count, Is.Zero);
            box.transform.position = Vector3.zero;
            EditModeScene.Step(1);
            Assert.That(scene.Fluid.Inputs.Colliders.Set.Count, Is.EqualTo(1));
        }

        [Test]
        public void A_terrain_leaves_the_stored_shape_of_its_collider_as_it_was()
        {
            var scene = new EditModeScene();
            var ground = new GameObject("Ground");
            ground.SetActive(false);
            ground.AddComponent<Terrain>().terrainData = new TerrainData { heightmapResolution = 33, size = new Vector3(4f, 1f, 4f) };
            ground.AddComponent<FluidCollider>().Shape = ColliderShape.Sphere;
            ground.AddComponent<FluidTerrain>();
            ground.SetActive(true);
            scene.Simulate();
            Assert.That(ground.GetComponent<FluidCollider>().Shape, Is.EqualTo(ColliderShape.HeightField));
            SceneSimulation.Stop();
            Assert.That(ground.GetComponent<FluidCollider>().Shape, Is.EqualTo(ColliderShape.Sphere));
        }

        static void Press(EditModeScene scene, string button)
        {
            int pressed = 0;
            GuiDrawing.Press = text => text == button && pressed++ == 0;
            GuiPasses.Draw(() => SceneSimulationControls.Draw(scene.Fluid));
            GuiDrawing.Press = null;
            Assert.That(pressed, Is.GreaterThan(0), $"a button '{button}'");
        }

        static void AssertEndsBy(Action<EditModeScene> ending, Action then = null)
        {
            var scene = new EditModeScene();
            List<string> before = LiveObjects.Report();
            scene.Simulate();
            EditModeScene.Step(2);
            ending(scene);
            then?.Invoke();
            AssertGone(scene, before);
        }

        static void AssertGone(EditModeScene scene, List<string> before)
        {
            Assert.That(SceneSimulation.Current, Is.Null);
            Assert.That(scene.Fluid.IsRunning || scene.Fluid.HasKeptState, Is.False);
            Assert.That(Resources.FindObjectsOfTypeAll<MonoBehaviour>().Where(script => script.runInEditMode), Is.Empty);
            Assert.That(SceneColliders.Enabled, Is.Empty);
            Assert.That(FluidSurface.Active, Is.Empty);
            AssertNoBuffers();
            Assert.That(LiveObjects.Report(), Is.EqualTo(before));
        }

        // A buffer that the GPU has yet to read goes when that has come.
        static void AssertNoBuffers()
        {
            AsyncGPUReadback.WaitAllRequests();
            Assert.That(BufferStorage.Live.Select(buffer => buffer.Name), Is.Empty);
        }

        // Runs a tick of the editor, with a frame if one was requested.
        static void Update() => EditorTick.Run();
    }
}
