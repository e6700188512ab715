using System;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.SceneManagement;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Host.Tests
{
    /// <summary>A scene with local physics: what is in it and what is not do not know of each other.</summary>
    public class EnginePhysicsSceneTests : EngineFixture
    {
        readonly Collider[] found = new Collider[8];

        [Test]
        public void Each_physics_scene_finds_its_own_colliders()
        {
            Scene local = Local();
            BoxCollider here = new GameObject("Here").AddComponent<BoxCollider>(), there = new GameObject("There").AddComponent<BoxCollider>();
            SceneManager.MoveGameObjectToScene(there.gameObject, local);
            Assert.That(Count(local.GetPhysicsScene()), Is.EqualTo(1));
            Assert.That(found[0], Is.SameAs(there));
            Assert.That(Count(Physics.defaultPhysicsScene), Is.EqualTo(1));
            Assert.That(found[0], Is.SameAs(here));
            Assert.That(Physics.OverlapBoxNonAlloc(Vector3.zero, Vector3.one, found, Quaternion.identity, ~0, QueryTriggerInteraction.Ignore),
                Is.EqualTo(1));
            SceneManager.MoveGameObjectToScene(there.gameObject, SceneManager.GetActiveScene());
            Assert.That(Count(Physics.defaultPhysicsScene), Is.EqualTo(2));
            Assert.That(local.GetPhysicsScene().IsEmpty());
        }

        [Test]
        public void Without_local_physics_a_scene_has_the_default()
        {
            Assert.That(SceneManager.CreateScene("Plain").GetPhysicsScene(), Is.EqualTo(Physics.defaultPhysicsScene));
            Assert.That(SceneManager.CreateScene("Flat", new CreateSceneParameters(LocalPhysicsMode.Physics2D)).GetPhysicsScene()
                == Physics.defaultPhysicsScene);
            Assert.That(Local().GetPhysicsScene() != Physics.defaultPhysicsScene);
            Assert.Throws<ArgumentException>(() => default(Scene).GetPhysicsScene());
        }

        [TestCase(LocalPhysicsMode.None, false)]
        [TestCase(LocalPhysicsMode.Physics3D, true)]
        public void A_scene_is_loaded_with_the_physics_that_was_asked_for(LocalPhysicsMode mode, bool isLocal)
        {
            SceneManager.GetActiveScene();
            SceneManager.SceneLoader = name => SceneManager.CreateForLoading(name, name);
            SceneManager.LoadSceneAsync("Loaded", new LoadSceneParameters(LoadSceneMode.Additive, mode));
            PlayerLoop.Frame(0.02f);
            Assert.That(SceneManager.GetSceneByName("Loaded").GetPhysicsScene() != Physics.defaultPhysicsScene, Is.EqualTo(isLocal));
        }

        [TestCase(SimulationMode.FixedUpdate, 4)]
        [TestCase(SimulationMode.Update, 1)]
        [TestCase(SimulationMode.Script, 0)]
        public void The_simulation_mode_says_when_bodies_move(SimulationMode mode, int steps)
        {
            Physics.simulationMode = mode;
            var body = new GameObject("Body").AddComponent<Rigidbody>();
            body.useGravity = false;
            body.AddForce(Vector3.right, ForceMode.Impulse);
            Time.fixedDeltaTime = 0.005f;
            PlayerLoop.Frame(0.02f);
            float each = mode == SimulationMode.Update ? 0.02f : 0.005f;
            Assert.That(body.position.x, Is.EqualTo(steps * each).Within(1e-5f));
            if (mode != SimulationMode.Script)
                LogAssert.Expect(LogType.Warning, new System.Text.RegularExpressions.Regex("simulation mode is not set to Script"));
            Physics.Simulate(0.1f);
            Assert.That(body.position.x, Is.EqualTo(mode == SimulationMode.Script ? 0.1f : steps * each).Within(1e-5f));
        }

        [Test]
        public void Bodies_of_local_physics_move_by_Simulate_alone()
        {
            Scene local = Local();
            Rigidbody here = new GameObject("Here").AddComponent<Rigidbody>(), there = new GameObject("There").AddComponent<Rigidbody>();
            SceneManager.MoveGameObjectToScene(there.gameObject, local);
            var box = there.gameObject.AddComponent<BoxCollider>();
            PlayerLoop.Frame(0.02f);
            Assert.That(here.transform.position.y, Is.LessThan(0f));
            Assert.That(there.transform.position.y, Is.Zero);
            float fallen = here.transform.position.y;
            there.transform.position = 5f * Vector3.up;
            Assert.That(Count(local.GetPhysicsScene()), Is.EqualTo(1), "its colliders are where its last step left them");
            local.GetPhysicsScene().Simulate(0.02f);
            Assert.That(there.transform.position.y, Is.EqualTo(5f + fallen).Within(1e-6f));
            Assert.That(here.transform.position.y, Is.EqualTo(fallen));
            Assert.That(Count(local.GetPhysicsScene()), Is.Zero);
            Object.DestroyImmediate(box);
        }

        [Test]
        public void What_cannot_be_stepped_says_so()
        {
            var log = new System.Collections.Generic.List<string>();
            Application.LogCallback listen = (message, stack, type) => log.Add(message);
            Application.logMessageReceived += listen;
            Physics.defaultPhysicsScene.Simulate(0.02f);
            Application.logMessageReceived -= listen;
            Assert.That(log, Has.Count.EqualTo(1));
            Assert.That(log[0], Does.Contain("simulation mode is not set to Script"));

            PhysicsScene physics = Local().GetPhysicsScene();
            SceneManager.UnloadSceneAsync("Local");
            PlayerLoop.Frame(0.02f);
            Assert.That(physics.IsValid(), Is.False);
            Assert.Throws<InvalidOperationException>(() => physics.Simulate(0.02f));
        }

        static Scene Local()
        {
            SceneManager.GetActiveScene();
            return SceneManager.CreateScene("Local", new CreateSceneParameters(LocalPhysicsMode.Physics3D));
        }

        int Count(PhysicsScene physics) => physics.OverlapBox(Vector3.zero, Vector3.one, found);
    }
}
