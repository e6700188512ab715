using System.Collections;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Bodies that water carries or covers meet what Unity's physics has them meet.</summary>
    public class FloatingContactTests
    {
        const int Quay = 8;
        const float Spacing = 0.05f, Side = 0.2f;

        readonly List<GameObject> made = new List<GameObject>();

        [UnitySetUp]
        public IEnumerator OneStepAFrame() => PhysicsClock.Begin(Time.fixedDeltaTime);

        [UnityTearDown]
        public IEnumerator LeaveNothing()
        {
            foreach (GameObject gameObject in made)
                Object.Destroy(gameObject);
            made.Clear();
            Time.captureDeltaTime = 0f;
            yield return null;
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator A_floating_body_that_is_pushed_against_a_quay_lies_against_it_and_floats()
        {
            const float quay = 0.2f;        // where it begins, m
            FluidSimulation fluid = Fluid((-0.4f, quay));
            Solid(new Vector3(quay + 0.2f, 0.4f, 0f), new Vector3(0.4f, 0.8f, 1f));
            Rigidbody body = Body(new Vector3(-0.1f, 0.4f, 0f), 500f);
            fluid.gameObject.SetActive(true);
            var buoyancy = body.GetComponent<FluidBuoyancy>();
            float farthest = float.NegativeInfinity, longest = 0f, submerged = 0f;
            for (int i = 0; i < 180; i++)
            {
                float before = Front(body);
                body.AddForce(new Vector3(2f, 0f, 0f), ForceMode.Acceleration);
                yield return null;
                farthest = Mathf.Max(farthest, Front(body));
                longest = Mathf.Max(longest, Front(body) - before);
                submerged += i < 120 ? 0f : buoyancy.SubmergedFraction / 60f;
            }
            Assert.That(longest, Is.LessThan(0.05f), "of a step, m");
            Assert.That(farthest, Is.LessThan(quay + longest + 0.005f), "into the quay: as it comes, by a step's travel");
            Assert.That(Front(body), Is.GreaterThan(quay - 0.02f), "it lies against the quay");
            Assert.That(body.position.y, Is.InRange(0.25f, 0.5f), "and floats");
            // Archimedes' half, a spacing (a quarter of the side) up or down, and what friction holds: the water presses the
            // body to the quay by 36 N, 0.6 of it is 0.28 of the body's buoyancy.
            Assert.That(submerged, Is.InRange(0.25f, 0.99f), "mean of a second");
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator A_stack_of_boxes_on_the_floor_of_a_pool_stays()
        {
            FluidSimulation fluid = Fluid((-0.4f, -0.15f), (0.15f, 0.4f));
            Solid(new Vector3(0f, -0.5f, 0f), new Vector3(4f, 1f, 4f));
            Rigidbody low = Body(new Vector3(0f, 0.5f * Side, 0f), 2500f), high = Body(new Vector3(0f, 1.5f * Side, 0f), 2500f);
            fluid.gameObject.SetActive(true);
            for (int i = 0; i < 120; i++)
                yield return null;
            foreach (Rigidbody body in new[] { low, high })
            {
                Assert.That(new Vector2(body.position.x, body.position.z).magnitude, Is.LessThan(0.03f));
                Assert.That(Vector3.Angle(body.rotation * Vector3.up, Vector3.up), Is.LessThan(3f));
            }
            Assert.That(low.position.y, Is.EqualTo(0.5f * Side).Within(0.01f));
            Assert.That(high.position.y, Is.EqualTo(1.5f * Side).Within(0.01f));
            Assert.That(low.GetComponent<FluidBuoyancy>().SubmergedFraction, Is.GreaterThan(0.5f), "the water has come");
        }

        static float Front(Rigidbody body) => body.GetComponent<Collider>().bounds.max.x;

        // 0.4 m of water between the given x, over a floor at 0. Not active yet.
        FluidSimulation Fluid(params (float From, float To)[] water)
        {
            GameObject thing = Make("Fluid", new Vector3(0f, 0.4f, 0f));
            thing.SetActive(false);
            var fluid = thing.AddComponent<FluidSimulation>();
            fluid.Configure(Vector3.one * 0.8f, Spacing, 4096);
            foreach ((float from, float to) in water)
            {
                var child = new GameObject("Water");
                child.transform.SetParent(thing.transform, false);
                child.transform.localPosition = new Vector3(0.5f * (from + to), -0.2f, 0f);
                child.AddComponent<FluidVolume>().Size = new Vector3(to - from, 0.4f, 0.8f);
            }
            thing.AddComponent<FluidPhysicsColliders>().ColliderLayers = 1 << Quay;
            return fluid;
        }

        void Solid(Vector3 position, Vector3 size)
        {
            GameObject thing = Make("Solid", position);
            thing.layer = Quay;
            thing.AddComponent<BoxCollider>().size = size;
        }

        Rigidbody Body(Vector3 position, float density)
        {
            GameObject thing = Make("Body", position);
            thing.AddComponent<BoxCollider>().size = Vector3.one * Side;
            var collider = thing.AddComponent<FluidCollider>();
            collider.Shape = ColliderShape.Box;
            collider.Size = Vector3.one * Side;
            var body = thing.AddComponent<Rigidbody>();
            body.mass = density * Side * Side * Side;
            thing.AddComponent<FluidBuoyancy>();
            return body;
        }

        GameObject Make(string name, Vector3 position)
        {
            var thing = new GameObject(name);
            thing.transform.position = position;
            made.Add(thing);
            return thing;
        }
    }
}
