using System.Collections;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.SceneManagement;
using UnityEngine.TestTools;
using UnityEngine.TestTools.Constraints;
using Is = NUnit.Framework.Is;

namespace Rill.Tests
{
    /// <summary>A fluid takes the colliders of its own physics scene.</summary>
    public class LocalPhysicsTests
    {
        const int Layer = 8;

        readonly List<GameObject> made = new List<GameObject>();
        Scene local;

        [SetUp]
        public void MakeScene()
            => local = SceneManager.CreateScene("Local Physics Test", new CreateSceneParameters(LocalPhysicsMode.Physics3D));

        [UnityTearDown]
        public IEnumerator LeaveNothing()
        {
            foreach (GameObject gameObject in made)
                Object.DestroyImmediate(gameObject);
            made.Clear();
            yield return SceneManager.UnloadSceneAsync(local);
        }

        [Test]
        public void A_fluid_takes_the_colliders_of_its_own_physics_scene_and_no_others()
        {
            FluidPhysicsColliders here = Pool(false), there = Pool(true);
            Collider stone = Stone(false), rock = Stone(true);
            Assert.That(Gather(here), Is.EqualTo(new[] { stone }));
            Assert.That(Gather(there), Is.EqualTo(new[] { rock }));

            SceneManager.MoveGameObjectToScene(stone.gameObject, local);
            Assert.That(Gather(here), Is.Empty);
            Assert.That(Gather(there), Is.EquivalentTo(new[] { rock, stone }));
            SceneManager.MoveGameObjectToScene(here.gameObject, local);
            Assert.That(Gather(here), Is.EquivalentTo(new[] { rock, stone }), "the fluid has come after it");
        }

        [Test]
        public void Colliders_of_local_physics_are_found_where_its_last_step_left_them()
        {
            FluidPhysicsColliders there = Pool(true);
            Collider rock = Stone(true);
            rock.transform.position = new Vector3(20f, 0f, 0f);
            Assert.That(Gather(there), Is.EqualTo(new[] { rock }));
            local.GetPhysicsScene().Simulate(Time.fixedDeltaTime);
            Assert.That(Gather(there), Is.Empty);
        }

        [Test]
        public void Asking_local_physics_allocates_no_managed_memory()
        {
            var there = (IColliderSource)Pool(true);
            Stone(true);
            TestDelegate frame = () => there.Gather(Vector3.zero, Quaternion.identity, Vector3.one, 0.05f);
            frame();
            Assert.That(frame, Is.Not.AllocatingGCMemory());
        }

        static List<Collider> Gather(FluidPhysicsColliders of)
            => ((IColliderSource)of).Gather(Vector3.zero, Quaternion.identity, Vector3.one, 0.05f)
                .ConvertAll(collider => ((GatheredCollider)collider).Collider);

        // Inactive: no fluid runs, and the test asks instead.
        FluidPhysicsColliders Pool(bool isLocal)
        {
            GameObject pool = Make("Pool", isLocal);
            pool.SetActive(false);
            var colliders = pool.AddComponent<FluidPhysicsColliders>();
            colliders.ColliderLayers = 1 << Layer;
            return colliders;
        }

        Collider Stone(bool isLocal)
        {
            GameObject stone = Make("Stone", isLocal);
            stone.layer = Layer;
            return stone.AddComponent<BoxCollider>();
        }

        GameObject Make(string name, bool isLocal)
        {
            var thing = new GameObject(name);
            made.Add(thing);
            if (isLocal)
                SceneManager.MoveGameObjectToScene(thing, local);
            return thing;
        }
    }
}
