using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Rill;
using Rill.Editor;
using Unity.Mathematics;
using UnityEditor;
using UnityEngine;
using UnityEngine.Headless;
using Object = UnityEngine.Object;

namespace Host.Tests
{
    /// <summary>Preview of volumes in the scene view before anything plays.</summary>
    public class VolumePreviewTests : GraphicsFixture
    {
        [TearDown]
        public void Clear()
        {
            SceneSimulation.Stop();
            VolumePreview.Clear();
        }

        [TestCase(VolumeShape.Box)]
        [TestCase(VolumeShape.Sphere)]
        public void The_particles_that_are_shown_are_those_that_play_mode_begins_with(VolumeShape shape)
        {
            var playing = new EditModeScene(plays: true);
            Turn(playing, shape);
            playing.Fluid.Restart();
            List<float3> played = EditModeScene.Particles(playing.Fluid).Select(particle => particle.position.xyz).ToList();
            PlayerLoop.Reset();

            var scene = new EditModeScene();
            Turn(scene, shape);
            List<float3> shown = Shown(VolumePreview.MeshOf(scene.Volume, scene.Fluid));
            Assert.That(shown.Count, Is.EqualTo(played.Count).And.GreaterThan(50));
            for (int i = 0; i < shown.Count; i++)
                Assert.That(math.distance(shown[i], played[i]), Is.LessThan(1e-4f), $"particle {i}, spacings");
        }

        [Test]
        public void Drawing_again_makes_nothing_until_something_changes()
        {
            var scene = new EditModeScene();
            VolumePreview.Draw(scene.Volume);
            int made = VolumePreview.MadeCount;
            for (int i = 0; i < 5; i++)
                VolumePreview.Draw(scene.Volume);
            scene.Fluid.transform.position += Vector3.right;        // its volumes come along
            VolumePreview.Draw(scene.Volume);
            Assert.That(VolumePreview.MadeCount, Is.EqualTo(made));
            foreach (System.Action change in new System.Action[]
            {
                () => scene.Volume.Size *= 0.9f, () => scene.Volume.transform.position += 0.01f * Vector3.up,
                () => scene.Volume.transform.Rotate(0f, 5f, 0f), () => scene.Volume.Shape = VolumeShape.Sphere,
                () => scene.Volume.Radius = 0.3f, () => scene.Fluid.Seed++,
                () => scene.Fluid.Configure(new Vector3(1f, 0.9f, 0.8f), 0.1f, 2000),
                () => scene.Fluid.Configure(new Vector3(1f, 0.9f, 0.8f), 0.09f, 2000),
            })
            {
                change();
                VolumePreview.Draw(scene.Volume);
                Assert.That(VolumePreview.MadeCount, Is.EqualTo(++made));
            }
        }

        [Test]
        public void Only_volumes_that_fill_an_enabled_fluid_show_particles()
        {
            var scene = new EditModeScene();
            FluidSimulation Of() => VolumePreview.FluidOf(scene.Volume);
            Assert.That(Of(), Is.SameAs(scene.Fluid));
            scene.Fluid.enabled = false;
            Assert.That(Of(), Is.Null, "a fluid that is disabled");
            scene.Fluid.enabled = true;
            scene.Volume.enabled = false;
            Assert.That(Of(), Is.Null, "a volume that is disabled");
            scene.Volume.enabled = true;
            scene.Simulate();
            Assert.That(Of(), Is.Null, "one whose water is simulated");
            SceneSimulation.Stop();
            var state = ScriptableObject.CreateInstance<FluidSnapshotAsset>();
            scene.Fluid.StartState = state;
            Assert.That(Of(), Is.Null, "a fluid that starts with a state");
            scene.Fluid.StartState = null;
            Object.DestroyImmediate(state, true);
            EditMode.IsOn = false;
            Assert.That(Of(), Is.Null, "in play mode");
        }

        [Test]
        public void Of_many_particles_some_are_drawn_and_the_inspector_says_so()
        {
            var scene = new EditModeScene(capacity: 100000);
            Assert.That(VolumePreview.HiddenNote(scene.Volume), Is.Null);
            scene.Fluid.Configure(new Vector3(1f, 1f, 0.8f), 0.016f, 100000);
            Assert.That(VolumePreview.HiddenNote(scene.Volume),
                Is.EqualTo("The scene view shows every 3rd of its particles, since it draws at most 20,000."));
            Assert.That(Shown(VolumePreview.MeshOf(scene.Volume, scene.Fluid)).Count,
                Is.LessThanOrEqualTo(VolumePreview.MaxDrawn).And.GreaterThan(VolumePreview.MaxDrawn / 2));
            scene.Fluid.Configure(new Vector3(1f, 1f, 0.8f), 0.005f, 100000);
            Assert.That(VolumePreview.HiddenNote(scene.Volume), Does.Contain("does not show its particles: more than 1,000,000"));
            Assert.That(VolumePreview.MeshOf(scene.Volume, scene.Fluid), Is.Null);
        }

        [Test]
        public void A_volume_that_cannot_be_filled_shows_nothing()
        {
            var scene = new EditModeScene();
            scene.Volume.Shape = VolumeShape.SignedDistanceField;
            Assert.That(VolumePreview.MeshOf(scene.Volume, scene.Fluid), Is.Null);
        }

        [Test]
        public void Meshes_of_volumes_that_are_gone_and_of_entering_Play_are_given_back()
        {
            var scene = new EditModeScene();
            Mesh mesh = VolumePreview.MeshOf(scene.Volume, scene.Fluid);
            Assert.That((bool)mesh);
            Object.DestroyImmediate(scene.Volume.gameObject);
            EditorApplication.RaiseHierarchyChanged();
            Assert.That((bool)mesh, Is.False);
            PlayerLoop.Reset();

            scene = new EditModeScene();
            mesh = VolumePreview.MeshOf(scene.Volume, scene.Fluid);
            EditorApplication.RaisePlayMode(PlayModeStateChange.ExitingEditMode);
            Assert.That((bool)mesh, Is.False);
        }

        static void Turn(EditModeScene scene, VolumeShape shape)
        {
            scene.Fluid.transform.SetPositionAndRotation(new Vector3(3f, 1f, -2f), Quaternion.Euler(0f, 20f, 10f));
            scene.Volume.Shape = shape;
            scene.Volume.Radius = 0.4f;         // a part of it lies outside the box
            scene.Volume.transform.Rotate(0f, 15f, 0f);
        }

        // Middles of the octahedra.
        static List<float3> Shown(Mesh mesh)
        {
            Vector3[] corners = mesh.vertices;
            return Enumerable.Range(0, corners.Length / ParticleMesh.Corners)
                .Select(i => (float3)(0.5f * (corners[i * ParticleMesh.Corners] + corners[i * ParticleMesh.Corners + 1]))).ToList();
        }
    }
}
