using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Rill.Editor.Tests
{
    /// <summary>Offers of the inspector of a fluid that shows or holds nothing.</summary>
    public class MissingPartTests
    {
        EditorScene scene;

        [SetUp]
        public void MakeScene() => scene = new EditorScene();

        [TearDown]
        public void DestroyScene() => scene.Dispose();

        static string[] Offers(FluidSimulation fluid) => MissingPart.Of(fluid).Select(part => part.Button).ToArray();

        [Test]
        public void A_whole_fluid_lacks_nothing()
        {
            Assert.That(MissingPart.Of(scene.Keep(SceneSetup.CreateFluid(null)).GetComponent<FluidSimulation>()), Is.Empty);
        }

        [Test]
        public void What_is_added_is_no_longer_missing_and_can_be_undone()
        {
            var fluid = scene.Add<FluidSimulation>();
            Assert.That(Offers(fluid), Is.EqualTo(new[] { "Add Fluid Surface", "Add Fluid Volume" }));
            foreach (int expected in new[] { 1, 0 })
            {
                Undo.IncrementCurrentGroup();
                MissingPart.Of(fluid)[0].Add();
                Assert.That(MissingPart.Of(fluid).Count, Is.EqualTo(expected));
            }
            var volume = fluid.GetComponentInChildren<FluidVolume>(true);
            Assert.That(volume.gameObject != fluid.gameObject && volume.gameObject.activeSelf, "a child, switched on");
            Undo.PerformUndo();
            Undo.PerformUndo();
            Assert.That(Offers(fluid).Length, Is.EqualTo(2));
        }

        [Test]
        public void The_box_alone_shows_no_fluid()
        {
            var fluid = scene.Add<FluidSimulation>();
            fluid.gameObject.AddComponent<DomainRenderer>();
            Assert.That(Offers(fluid), Has.Member("Add Fluid Surface"));
        }

        [Test]
        public void A_mesh_for_the_renderer_shows_it()
        {
            var fluid = scene.Add<FluidSimulation>();
            fluid.gameObject.AddComponent<FluidSurfaceMesh>();
            Assert.That(Offers(fluid), Is.EqualTo(new[] { "Add Fluid Volume" }));
        }

        [Test]
        public void An_emitter_fills_a_fluid_from_below_it_or_by_reference()
        {
            FluidSimulation below = scene.Add<FluidSimulation>("Below"), referred = scene.Add<FluidSimulation>("Referred"),
                neither = scene.Add<FluidSimulation>("Neither");
            var child = new GameObject("Tap");
            child.transform.SetParent(below.transform, false);
            child.AddComponent<FluidEmitter>();
            var serialized = new SerializedObject(scene.Add<FluidEmitter>("Elsewhere"));
            serialized.FindProperty("simulation").objectReferenceValue = referred;
            serialized.ApplyModifiedProperties();
            Assert.That(Offers(below), Has.No.Member("Add Fluid Volume"));
            Assert.That(Offers(referred), Has.No.Member("Add Fluid Volume"));
            Assert.That(Offers(neither), Has.Member("Add Fluid Volume"));
        }
    }
}
