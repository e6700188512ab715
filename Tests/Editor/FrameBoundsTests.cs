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
    /// <summary>Bounds that F frames in the scene view. Unity asks each inspector of the selection by name, and so does this.</summary>
    public class FrameBoundsTests
    {
        // Finds messages like Unity's SceneView: private methods of a base class are not found.
        const BindingFlags AsUnityLooks = BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.Instance | BindingFlags.FlattenHierarchy;
        const float Turn = 0.70710678f;     // sine and cosine of 45 degrees

        EditorScene scene;

        [SetUp]
        public void MakeScene() => scene = new EditorScene();

        [TearDown]
        public void DestroyScene() => scene.Dispose();

        static IEnumerable<TestCaseData> Shapes()
        {
            TestCaseData Case<T>(string name, Vector3 size, Action<T> set, Vector3 center = default) where T : Component =>
                new TestCaseData(typeof(T), (Action<Component>)(one => set((T)one)), size, center).SetName("Framed_" + name);
            Vector3 box = new Vector3(2f, 1f, 4f), turned = new Vector3(6f * Turn, 1f, 6f * Turn), ball = 3f * Vector3.one;
            yield return Case<FluidSimulation>("fluid", turned, fluid => fluid.Configure(box, 0.1f, 1000));
            yield return Case<FluidVolume>("box_of_water", turned, volume => volume.Size = box);
            yield return Case<FluidVolume>("ball_of_water", ball, volume => (volume.Shape, volume.Radius) = (VolumeShape.Sphere, 1.5f));
            yield return Case<FluidEmitter>("disc", new Vector3(3f * Turn, 3f, 3f * Turn), emitter => emitter.Radius = 1.5f);
            yield return Case<FluidEmitter>("box_that_fills", turned,
                emitter => (emitter.Shape, emitter.Mode, emitter.Size) = (EmitterShape.Box, EmitterMode.Fill, box));
            yield return Case<FluidEmitter>("slot", new Vector3(2f * Turn, 1f, 2f * Turn),
                emitter => (emitter.Shape, emitter.Size) = (EmitterShape.Box, box));
            yield return Case<FluidDrain>("drain", turned, drain => (drain.Shape, drain.Size) = (DrainShape.Box, box));
            yield return Case<FluidDetector>("capsule_of_a_detector", new Vector3(2f, 5f, 2f),
                detector => (detector.Shape, detector.Radius, detector.Height) = (DetectorShape.Capsule, 1f, 5f));
            yield return Case<FluidForceField>("field", ball, field => (field.Bounds, field.Radius) = (ForceFieldBounds.Sphere, 1.5f));
            yield return Case<FluidProbe>("probe", 0.5f * Vector3.one, probe => probe.Radius = 0.25f);
            yield return Case<FluidCollider>("box_of_a_collider_with_its_scale", 2f * turned, collider =>
            {
                (collider.Shape, collider.Size) = (ColliderShape.Box, box);
                collider.transform.localScale = new Vector3(2f, -2f, 2f);
            });
            yield return Case<FluidCollider>("capsule_beside_its_object", new Vector3(2f, 5f, 2f), collider =>
            {
                (collider.Shape, collider.Radius, collider.Height) = (ColliderShape.Capsule, 1f, 5f);
                collider.Center = Vector3.right;
            }, new Vector3(Turn, 0f, -Turn));
        }

        [TestCaseSource(nameof(Shapes))]
        public void The_shape_of_a_turned_object_is_framed(Type type, Action<Component> set, Vector3 size, Vector3 center)
        {
            Component one = Placed(type, new Vector3(10f, 20f, 30f));
            set(one);
            Assert.That(TryFrame(out Bounds bounds, one));
            AssertBounds(bounds, new Vector3(10f, 20f, 30f) + center, size);
        }

        [Test]
        public void Several_objects_are_framed_together()
        {
            var drains = new[] { Placed(typeof(FluidDrain), Vector3.zero), Placed(typeof(FluidDrain), new Vector3(10f, 0f, 0f)) };
            foreach (Component drain in drains)
            {
                ((FluidDrain)drain).Shape = DrainShape.Sphere;
                ((FluidDrain)drain).Radius = 1f;
            }
            Assert.That(TryFrame(out Bounds bounds, drains));
            AssertBounds(bounds, new Vector3(5f, 0f, 0f), new Vector3(12f, 2f, 2f));
        }

        [Test]
        public void Both_fluids_of_a_connection_are_framed()
        {
            var connection = (FluidConnection)Placed(typeof(FluidConnection), Vector3.zero);
            FluidSimulation Fluid(float x)
            {
                var fluid = scene.Add<FluidSimulation>();
                fluid.transform.position = x * Vector3.right;
                fluid.Configure(2f * Vector3.one, 0.1f, 1000);
                return fluid;
            }
            connection.First = Fluid(0f);
            connection.Second = Fluid(1.5f);
            Assert.That(TryFrame(out Bounds bounds, connection));
            AssertBounds(bounds, new Vector3(0.75f, 0f, 0f), new Vector3(3.5f, 2f, 2f));
        }

        [Test]
        public void What_has_no_size_leaves_the_frame_to_Unity()
        {
            var plane = (FluidCollider)Placed(typeof(FluidCollider), Vector3.zero);
            plane.Shape = ColliderShape.Plane;
            var mesh = (FluidCollider)Placed(typeof(FluidCollider), Vector3.zero);
            mesh.Shape = ColliderShape.Mesh;
            foreach (Component one in new[] { plane, mesh, Placed(typeof(FluidForceField), Vector3.zero),
                Placed(typeof(FluidConnection), Vector3.zero) })
                Assert.That(TryFrame(out _, one), Is.False, one.GetType().Name);
        }

        // Turned by 45 degrees about y: x goes to x and -z.
        Component Placed(Type type, Vector3 position)
        {
            Component one = scene.Add(type);
            one.transform.SetPositionAndRotation(position, Quaternion.Euler(0f, 45f, 0f));
            return one;
        }

        bool TryFrame(out Bounds bounds, params Component[] selected)
        {
            UnityEditor.Editor editor = scene.Inspect(selected.Cast<Object>().ToArray());
            bounds = (Bounds)editor.GetType().GetMethod("OnGetFrameBounds", AsUnityLooks).Invoke(editor, null);
            return (bool)editor.GetType().GetMethod("HasFrameBounds", AsUnityLooks).Invoke(editor, null);
        }

        static void AssertBounds(Bounds bounds, Vector3 center, Vector3 size)
        {
            Assert.That(Vector3.Distance(bounds.center, center), Is.LessThan(1e-4f), $"center {bounds.center}");
            Assert.That(Vector3.Distance(bounds.size, size), Is.LessThan(1e-4f), $"size {bounds.size}");
        }
    }
}
