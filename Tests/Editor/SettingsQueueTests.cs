using System;
using System.Linq;
using System.Reflection;
using System.Text.RegularExpressions;
using System.Threading;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Rill.Editor.Tests
{
    /// <summary>Effects of changed settings: in the Editor's next update where Unity validates, at once where a script sets them.</summary>
    public class SettingsQueueTests
    {
        EditorScene scene;
        FluidSimulation fluid;

        [SetUp]
        public void MakeFluid()
        {
            scene = new EditorScene();
            fluid = scene.Add<FluidSimulation>("Fluid");
            SettingsQueue.Apply();
        }

        [TearDown]
        public void RemoveIt() => scene.Dispose();

        [Test]
        public void A_change_in_the_inspector_and_its_undo_are_followed_by_the_stages_in_the_next_update()
        {
            Change(fluid, "material.vorticity", property => property.floatValue = 1f);
            Assert.That(Stored(fluid), Has.No.Member("VorticityConfinement"), "nothing in OnValidate");
            SettingsQueue.Apply();
            Assert.That(Stored(fluid), Has.Member("VorticityConfinement"));
            Undo.PerformUndo();
            SettingsQueue.Apply();
            Assert.That(Stored(fluid), Has.No.Member("VorticityConfinement"));
        }

        [Test]
        public void A_script_s_change_is_followed_at_once()
        {
            fluid.ShadersInBuild = ShadersInBuild.AllFeatures;
            Assert.That(Stored(fluid), Has.Member("Colliders"));
        }

        [Test]
        public void Stages_that_alone_were_put_back_are_stored_again()
        {
            // Changes like Revert on the hidden field of a prefab instance, or by pasted values of an older component.
            Change(fluid, "shaders.stages", property => property.arraySize = 1);
            SettingsQueue.Apply();
            Assert.That(Stored(fluid), Has.Member("ParticleUpload").And.Member("Statistics"));
        }

        [Test]
        public void What_was_clamped_is_logged_once_and_by_name()
        {
            var collider = scene.Add<FluidCollider>("Rock");
            Change(collider, "friction", property => property.floatValue = 7f);
            Assert.That(collider.Friction, Is.EqualTo(1f), "clamped at once");
            LogAssert.NoUnexpectedReceived();
            LogAssert.Expect(LogType.Warning, new Regex("FluidCollider 'Rock': friction 7 is outside 0 to 1; using 1"));
            SettingsQueue.Apply();
            Change(collider, "friction", property => property.floatValue = 0.5f);
            SettingsQueue.Apply();
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void What_was_clamped_stays_to_be_logged_where_nothing_is_clamped_after_it()
        {
            var collider = scene.Add<FluidCollider>("Rock");
            Change(collider, "friction", property => property.floatValue = 7f);
            Change(collider, "bounciness", property => property.floatValue = 0.5f);
            LogAssert.Expect(LogType.Warning, new Regex("friction 7 is outside"));
            SettingsQueue.Apply();
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void A_component_that_is_destroyed_first_is_left_out()
        {
            Change(fluid, "material.vorticity", property => property.floatValue = 1f);
            Object.DestroyImmediate(fluid.gameObject);
            Assert.That(SettingsQueue.Apply, Throws.Nothing);
        }

        [Test]
        public void OnValidate_of_every_component_runs_on_another_thread()
        {
            MethodInfo Validation(Type type)
            {
                MethodInfo found = null;
                for (; type != null && found == null; type = type.BaseType)
                    found = type.GetMethod("OnValidate", BindingFlags.Instance | BindingFlags.NonPublic | BindingFlags.DeclaredOnly);
                return found;
            }
            Component[] components = typeof(FluidSimulation).Assembly.GetTypes()
                .Where(type => typeof(MonoBehaviour).IsAssignableFrom(type) && !type.IsAbstract && Validation(type) != null)
                .Select(type => scene.Add(type)).ToArray();
            Assert.That(components, Has.Length.GreaterThan(12));
            SettingsQueue.Apply();
            Exception thrown = null;
            var thread = new Thread(() =>
            {
                try
                {
                    foreach (Component component in components)
                        Validation(component.GetType()).Invoke(component, null);
                }
                catch (Exception e)
                {
                    thrown = e;
                }
            });
            thread.Start();
            thread.Join();
            Assert.That(thrown, Is.Null);
            SettingsQueue.Apply();
        }

        static void Change(Object target, string path, Action<SerializedProperty> set)
        {
            var serialized = new SerializedObject(target);
            set(serialized.FindProperty(path));
            serialized.ApplyModifiedProperties();
        }

        static string[] Stored(IUsesFeatures user) => Array.ConvertAll(user.StageReferences.Stages, stage => stage.name);
    }
}
