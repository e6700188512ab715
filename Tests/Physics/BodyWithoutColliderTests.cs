using System;
using System.Collections;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>Parts that a new Fluid Buoyancy adds, and its message for a body without a collider.</summary>
    public class BodyWithoutColliderTests
    {
        readonly List<GameObject> made = new List<GameObject>();
        Action<GameObject> addCollider;

        [SetUp]
        public void KeepHook() => addCollider = FluidBuoyancy.AddCollider;

        [TearDown]
        public void LeaveNothing()
        {
            FluidBuoyancy.AddCollider = addCollider;
            foreach (GameObject thing in made)
                Object.DestroyImmediate(thing);         // at once: what lies in a collider as a fluid begins is left out, also in the next test's
            made.Clear();
        }

        [Test]
        public void Code_that_adds_a_fluid_buoyancy_adds_no_collider()
        {
            GameObject boat = Make("Boat");
            Make("Hull", boat).AddComponent<FluidCollider>();
            boat.AddComponent<FluidBuoyancy>();
            Assert.That(boat.GetComponent<FluidCollider>() == null, "a shape that was not chosen");
            Assert.That(boat.GetComponent<Rigidbody>() != null, "what it carries");
        }

        [Test]
        public void The_Editor_adds_a_collider_to_a_new_body_that_has_none()
        {
            FluidBuoyancy.AddCollider = to => to.AddComponent<FluidCollider>();
            var crate = Make("Crate").AddComponent<FluidBuoyancy>();
            Make("Trailer", crate.gameObject).AddComponent<Rigidbody>().gameObject.AddComponent<FluidCollider>();
            crate.AddMissingCollider();
            Assert.That(crate.GetComponents<FluidCollider>(), Has.Length.EqualTo(1), "that of another body below does not count");
            crate.AddMissingCollider();
            Assert.That(crate.GetComponents<FluidCollider>(), Has.Length.EqualTo(1));

            GameObject boat = Make("Boat");
            Make("Hull", boat).AddComponent<FluidCollider>().enabled = false;
            boat.AddComponent<FluidBuoyancy>().AddMissingCollider();
            Assert.That(boat.GetComponent<FluidCollider>() == null, "it has its shapes below");
        }

        [UnityTest]
        public IEnumerator A_body_without_a_collider_says_so_once_and_names_the_remedy()
        {
            var said = new List<string>();
            Application.LogCallback hear = (text, trace, type) => said.Add(text);
            GameObject boat = Make("Boat");
            boat.AddComponent<FluidBuoyancy>();
            FluidCollider hull = Make("Hull", boat).AddComponent<FluidCollider>();      // before the first step of the physics
            Application.logMessageReceived += hear;
            yield return Steps(3);
            Assert.That(said, Is.Empty, "it has one");
            hull.enabled = false;
            yield return Steps(3);
            hull.enabled = true;
            yield return Steps(2);
            Object.Destroy(hull);
            yield return Steps(3);
            Application.logMessageReceived -= hear;
            Assert.That(said, Is.EqualTo(new[]
            {
                "Rill: FluidBuoyancy 'Boat' carries nothing: neither its object nor one below, without a Rigidbody of its own, has a Fluid " +
                "Collider that is enabled. Add one to each shape that shall float, or leave the body to Floating Layers of a Fluid Physics " +
                "Colliders."
            }));
        }

        static IEnumerator Steps(int count)
        {
            for (int i = 0; i < count; i++)
                yield return new WaitForFixedUpdate();
        }

        GameObject Make(string name, GameObject parent = null)
        {
            var thing = new GameObject(name);
            made.Add(thing);
            if (parent != null)
                thing.transform.SetParent(parent.transform, false);
            return thing;
        }
    }
}
