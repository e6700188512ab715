using System.Collections;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>The snippets of the manual that need the physics, as in ManualSnippets.</summary>
    public class PhysicsManualSnippets
    {
        static void UseColliders(FluidSimulation fluid)
        {
            #region Take the colliders of the physics
            var taken = fluid.gameObject.AddComponent<FluidPhysicsColliders>();
            taken.ColliderLayers = 1 << 0;                  // what the water meets: the layer Default
            taken.FloatingLayers = 1 << 8;                  // whose Rigidbodies it carries
            taken.OnEnter += contact => Debug.Log($"{contact.Collider.name} got wet in step {contact.Step}");
            #endregion
        }

        static GameObject FloatingBody()
        {
            #region Make a floating body (components.md)
            var boat = new GameObject("Boat");
            boat.transform.position = new Vector3(0.4f, -0.2f, -0.2f);
            boat.SetActive(false);                                      // nothing acts before all is set
            var hull = boat.AddComponent<FluidCollider>();              // colliders may also be on its children: they are one body
            hull.Shape = ColliderShape.Box;
            hull.Size = new Vector3(0.5f, 0.2f, 0.3f);                  // m
            var body = boat.AddComponent<Rigidbody>();
            body.mass = 0.4f * 1000f * 0.5f * 0.2f * 0.3f;              // kg: 0.4 of the water in its place
            var buoyancy = boat.AddComponent<FluidBuoyancy>();          // lets the water carry the body
            buoyancy.Damping = 0.1f;
            boat.SetActive(true);
            #endregion
            return boat;
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator The_snippet_of_the_manual_makes_a_body_that_floats()
        {
            GameObject lake = Lake(), boat = FloatingBody();
            yield return PhysicsClock.Begin(1f / 60f);
            try
            {
                for (int i = 0; i < 90; i++)
                    yield return null;
                Assert.That(boat.GetComponent<FluidBuoyancy>().SubmergedFraction, Is.InRange(0.2f, 0.7f), "it carries 0.4");
                Assert.That(boat.transform.position.y, Is.InRange(-0.45f, -0.15f), "at the surface, which is at -0.3");
            }
            finally
            {
                Time.captureDeltaTime = 0f;
                Object.DestroyImmediate(boat);
                Object.DestroyImmediate(lake);
            }
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator The_snippet_of_the_manual_meets_one_layer_and_carries_the_bodies_of_another()
        {
            GameObject lake = Lake(), crate = GameObject.CreatePrimitive(PrimitiveType.Cube), post = GameObject.CreatePrimitive(PrimitiveType.Cube);
            UseColliders(lake.GetComponent<FluidSimulation>());
            crate.layer = 8;
            crate.transform.localScale = new Vector3(0.5f, 0.2f, 0.3f);
            crate.transform.position = new Vector3(0.4f, -0.2f, -0.2f);
            crate.AddComponent<Rigidbody>().mass = 12f;
            post.transform.localScale = new Vector3(0.2f, 1.6f, 0.2f);
            post.transform.position = new Vector3(-0.6f, 0f, 0f);
            yield return PhysicsClock.Begin(1f / 60f);
            try
            {
                for (int i = 0; i < 90; i++)
                    yield return null;
                Assert.That(lake.GetComponent<FluidPhysicsColliders>().Taken.Count, Is.EqualTo(2));
                Assert.That(crate.transform.position.y, Is.InRange(-0.45f, -0.15f), "at the surface, which is at -0.3");
            }
            finally
            {
                Time.captureDeltaTime = 0f;
                Object.DestroyImmediate(crate);
                Object.DestroyImmediate(post);
                Object.DestroyImmediate(lake);
            }
        }

        // Its surface is at -0.3 m.
        static GameObject Lake()
        {
            var lake = new GameObject("Lake");
            lake.SetActive(false);
            lake.AddComponent<FluidSimulation>().Configure(new Vector3(2f, 1.6f, 1f), 0.05f, 20000);
            var water = new GameObject("Water");
            water.transform.SetParent(lake.transform, false);
            water.transform.localPosition = new Vector3(0f, -0.55f, 0f);
            water.AddComponent<FluidVolume>().Size = new Vector3(2f, 0.5f, 1f);
            lake.SetActive(true);
            return lake;
        }
    }
}
