using System.Collections;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.SceneManagement;

namespace Host.Tests
{
    /// <summary>Scripts hear of contacts and triggers, in Unity's order.</summary>
    public class EngineContactEventTests : EngineFixture
    {
        sealed class Listener : MonoBehaviour
        {
            public readonly List<Collision> Hits = new List<Collision>();
            public bool TellsOfSteps;

            void FixedUpdate() => Step("FixedUpdate");
            void OnCollisionEnter(Collision collision) { Hits.Add(collision); Story.Tell($"{name} enters {collision.gameObject.name}"); }
            void OnCollisionStay() => Step($"{name} stays");
            void OnCollisionExit(Collision collision) => Story.Tell($"{name} leaves {collision.gameObject.name}");
            void OnTriggerEnter(Collider other) => Story.Tell($"{name} enters trigger {other.name}");
            void OnTriggerStay(Collider other) => Step($"{name} stays in {other.name}");
            void OnTriggerExit(Collider other) => Story.Tell($"{name} leaves trigger {other.name}");

            public IEnumerator Steps()
            {
                yield return new WaitForFixedUpdate();
                Step("WaitForFixedUpdate");
            }

            void Step(string line)
            {
                if (TellsOfSteps)
                    Story.Tell(line);
            }
        }

        [Test]
        public void A_body_hears_once_that_it_meets_the_floor_and_that_it_leaves_it()
        {
            GameObject floor = Floor();
            Listener ball = Ball("Ball", new Vector3(0f, 1.5f, 0f));
            Frames(60);
            Assert.That(Story.Take(), Is.EqualTo(new[] { "Ball enters Floor" }));
            Collision hit = ball.Hits[0];
            Assert.That(hit.collider, Is.SameAs(floor.GetComponent<Collider>()));
            Assert.That(hit.relativeVelocity.y, Is.EqualTo(4.43f).Within(0.2f), "the floor's against the ball's: sqrt(2 * 9.81 * 1)");
            Assert.That(hit.contactCount, Is.GreaterThan(0));
            Assert.That((hit.GetContact(0).normal - Vector3.up).magnitude, Is.LessThan(1e-3f), "from the floor to the ball");
            Assert.That(hit.GetContact(0).thisCollider, Is.SameAs(ball.GetComponent<Collider>()));
            Assert.That(hit.GetContact(0).point.y, Is.EqualTo(0f).Within(0.1f));
            Assert.That(hit.impulse.y, Is.EqualTo(4.43f).Within(0.5f), "1 kg comes to rest");
            ball.GetComponent<Rigidbody>().velocity = new Vector3(0f, 5f, 0f);
            Frames(20);
            Assert.That(Story.Take(), Is.EqualTo(new[] { "Ball leaves Floor" }));
        }

        [Test]
        public void Without_callbacks_scripts_hear_of_triggers_alone()
        {
            Physics.invokeCollisionCallbacks = false;
            Floor();
            GameObject zone = new GameObject("Zone");
            zone.AddComponent<BoxCollider>().isTrigger = true;
            Ball("Ball", new Vector3(0f, 0.499f, 0f));
            Frames(3);
            Assert.That(Story.Take(), Is.EqualTo(new[] { "Ball enters trigger Zone" }));
        }

        [Test]
        public void Both_sides_hear_and_a_collider_below_a_body_speaks_for_it_too()
        {
            Listener floor = Floor().AddComponent<Listener>();
            Rigidbody body = new GameObject("Body").AddComponent<Rigidbody>();
            body.gameObject.AddComponent<Listener>();
            var part = new GameObject("Part").AddComponent<BoxCollider>();
            part.transform.SetParent(body.transform, false);
            part.gameObject.AddComponent<Listener>();
            body.position = new Vector3(0f, 0.55f, 0f);
            Frames(20);
            Assert.That(Story.Take(), Is.EquivalentTo(new[] { "Floor enters Body", "Part enters Floor", "Body enters Floor" }));
            Assert.That(floor.Hits[0].collider, Is.SameAs(part));
        }

        [Test]
        public void A_trigger_tells_of_what_comes_and_goes_and_holds_nothing_up()
        {
            GameObject zone = Floor();
            zone.name = "Zone";
            zone.GetComponent<Collider>().isTrigger = true;
            zone.AddComponent<Listener>();
            Listener ball = Ball("Ball", new Vector3(0f, 1f, 0f));
            Frames(100);
            Assert.That(ball.transform.position.y, Is.LessThan(-5f));
            Assert.That(Story.Take(), Is.EqualTo(new[] { "Zone enters trigger Ball", "Ball enters trigger Zone", "Zone leaves trigger Ball",
                "Ball leaves trigger Zone" }));
        }

        [TestCase(false, false, 0)]
        [TestCase(true, false, 0)]
        [TestCase(false, true, 2)]
        [TestCase(true, true, 2)]
        public void Two_bodies_that_are_not_moved_by_forces_hear_of_triggers_alone(bool bothKinematic, bool isTrigger, int lines)
        {
            GameObject solid = Floor();
            solid.AddComponent<Listener>();
            solid.GetComponent<Collider>().isTrigger = isTrigger;
            if (bothKinematic)
                solid.AddComponent<Rigidbody>().isKinematic = true;
            Listener ball = Ball("Ball", Vector3.zero);
            ball.GetComponent<Rigidbody>().isKinematic = true;
            Frames(3);
            Assert.That(Story.Take(), Has.Length.EqualTo(lines));
        }

        [Test]
        public void Colliders_without_a_body_hear_nothing()
        {
            Floor().AddComponent<Listener>();
            Floor().GetComponent<Collider>().isTrigger = true;
            Frames(3);
            Assert.That(Story.Take(), Is.Empty);
        }

        [Test]
        public void Triggers_and_collisions_come_between_FixedUpdate_and_those_who_wait_for_it()
        {
            GameObject zone = new GameObject("Zone");
            zone.AddComponent<BoxCollider>().isTrigger = true;
            Floor();
            Listener ball = Ball("Ball", new Vector3(0f, 0.499f, 0f));
            ball.TellsOfSteps = true;
            ball.StartCoroutine(ball.Steps());
            Frames(2);
            Assert.That(Story.Take(), Is.EqualTo(new[] { "FixedUpdate", "Ball enters trigger Zone", "Ball enters Floor", "WaitForFixedUpdate",
                "FixedUpdate", "Ball stays in Zone", "Ball stays" }));
        }

        [Test]
        public void A_script_that_steps_its_own_scene_hears_too()
        {
            SceneManager.GetActiveScene();
            Scene local = SceneManager.CreateScene("Local", new CreateSceneParameters(LocalPhysicsMode.Physics3D));
            GameObject floor = Floor();
            Listener ball = Ball("Ball", new Vector3(0f, 0.6f, 0f));
            SceneManager.MoveGameObjectToScene(floor, local);
            SceneManager.MoveGameObjectToScene(ball.gameObject, local);
            for (int i = 0; i < 30; i++)
                local.GetPhysicsScene().Simulate(0.02f);
            Assert.That(Story.Take(), Is.EqualTo(new[] { "Ball enters Floor" }));
            Assert.That(ball.transform.position.y, Is.EqualTo(0.5f).Within(0.005f));
        }

        [Test]
        public void What_is_destroyed_in_a_message_is_told_of_no_more()
        {
            Floor().AddComponent<Listener>();
            Ball("Ball", new Vector3(0f, 0.499f, 0f)).gameObject.AddComponent<Remover>();
            Frames(5);
            Assert.That(Story.Take().Length, Is.LessThanOrEqualTo(2));
            Assert.That(Object.FindObjectsOfType<Rigidbody>(), Is.Empty);
        }

        sealed class Remover : MonoBehaviour
        {
            void OnCollisionEnter() => DestroyImmediate(gameObject);
        }

        static GameObject Floor()
        {
            var floor = new GameObject("Floor");
            var box = floor.AddComponent<BoxCollider>();
            box.center = new Vector3(0f, -0.5f, 0f);
            box.size = new Vector3(10f, 1f, 10f);
            return floor;
        }

        static Listener Ball(string name, Vector3 position)
        {
            var ball = new GameObject(name);
            ball.transform.position = position;
            ball.AddComponent<SphereCollider>();
            ball.AddComponent<Rigidbody>();
            return ball.AddComponent<Listener>();
        }
    }
}
