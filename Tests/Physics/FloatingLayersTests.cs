using System.Collections;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Bodies that water carries by layer, and contacts of colliders that it takes by layer.</summary>
    public class FloatingLayersTests
    {
        const int Layer = 8;

        readonly List<GameObject> made = new List<GameObject>();
        FloatingScene scene;
        float fixedDeltaTime;

        [UnitySetUp]
        public IEnumerator OneStepAFrame()
        {
            fixedDeltaTime = Time.fixedDeltaTime;
            Time.fixedDeltaTime = FloatingScene.Frame;      // of the physics too
            yield return PhysicsClock.Begin(FloatingScene.Frame);
        }

        [UnityTearDown]
        public IEnumerator LeaveNothing()
        {
            scene?.Dispose();
            scene = null;
            foreach (GameObject gameObject in made)
                Object.Destroy(gameObject);
            made.Clear();
            Time.captureDeltaTime = 0f;
            Time.fixedDeltaTime = fixedDeltaTime;
            yield return null;
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator A_body_by_layer_moves_as_one_with_a_Fluid_Buoyancy([Values(ColliderShape.Sphere, ColliderShape.Box)] ColliderShape shape)
        {
            float[][] heights = new float[2][];
            for (int i = 0; i < 2; i++)
            {
                scene = new FloatingScene(shape, new Vector3(0.3f, 0.25f, 0.3f), 0.5f, 0.45f, 8, 14, byLayer: i == 1);
                yield return scene.Play(0.6f);
                heights[i] = scene.Heights.ToArray();
                scene.Dispose();
                yield return null;
            }
            TestContext.Out.WriteLine($"{string.Join(" ", heights[0])}\n{string.Join(" ", heights[1])}");
            Assert.That(heights[0].Last(), Is.InRange(0.3f, 0.44f), "it fell, and the water caught it");
            Assert.That(heights[1], Is.EqualTo(heights[0]), "to the bit");
        }

        [UnityTest]
        public IEnumerator All_colliders_of_a_body_on_floating_layers_carry_it_together()
        {
            FluidPhysicsColliders colliders = Pool();
            GameObject raft = Make("Raft", Vector3.zero);
            raft.AddComponent<BoxCollider>().size = 0.1f * Vector3.one;
            raft.AddComponent<Rigidbody>().useGravity = false;
            GameObject mast = Make("Mast", new Vector3(0f, 0.1f, 0f)), flag = Make("Flag", new Vector3(0f, 0.2f, 0f));
            foreach (GameObject part in new[] { mast, flag })
            {
                part.transform.SetParent(raft.transform);
                part.AddComponent<SphereCollider>().radius = 0.05f;
            }
            flag.layer = Layer + 1;
            colliders.ColliderLayers = 1 << Layer | 1 << Layer + 1;
            yield return Frames(4);
            Assert.That(colliders.GetComponent<FluidSimulation>().Inputs.Colliders.Set.Count, Is.EqualTo(3));
            foreach (IFluidCollider collider in colliders.Taken)
                Assert.That(collider.MeasuresForce, Is.EqualTo(collider.Name != "Flag"), collider.Name);
            Assert.That(colliders.Bodies.Count, Is.EqualTo(1));
            Assert.That(colliders.Bodies[0].Parts.Count, Is.EqualTo(2));
            mast.transform.SetParent(null);
            yield return Frames(2);
            Assert.That(colliders.Bodies[0].Parts.Count, Is.EqualTo(1), "it is of no body now");
            raft.GetComponent<Rigidbody>().isKinematic = true;
            yield return Frames(2);
            Assert.That(colliders.Bodies, Is.Empty);
        }

        [UnityTest]
        public IEnumerator Kinematic_bodies_and_other_layers_are_pushed_by_nothing()
        {
            FluidPhysicsColliders colliders = Pool();
            Body("Kinematic").isKinematic = true;
            colliders.FloatingLayers = 1 << Layer + 1;
            Body("Other").transform.position = new Vector3(0.2f, -0.2f, 0f);
            yield return Frames(2);
            Assert.That(colliders.GetComponent<FluidSimulation>().Inputs.Colliders.Set.Count, Is.EqualTo(2));
            foreach (IFluidCollider collider in colliders.Taken)
                Assert.That(collider.MeasuresForce, Is.False, collider.Name);
            colliders.FloatingLayers = 1 << Layer;
            yield return Frames(2);
            foreach (IFluidCollider collider in colliders.Taken)
                Assert.That(collider.MeasuresForce, Is.EqualTo(collider.Name == "Other"), collider.Name);
        }

        [UnityTest]
        public IEnumerator A_floating_layer_need_not_be_a_collider_layer_too([Values(0, 1 << Layer + 1)] int colliderLayers)
        {
            FluidPhysicsColliders colliders = Pool();
            colliders.ColliderLayers = colliderLayers;
            Body("Ball");
            yield return Frames(2);
            Assert.That(colliders.GetComponent<FluidSimulation>().Inputs.Colliders.Set.Count, Is.EqualTo(1));
            Assert.That(colliders.Bodies.Count, Is.EqualTo(1));
            var problems = new List<string>();
            ((IHasProblems)colliders).ListProblems(problems);
            Assert.That(problems, Is.Empty);
            colliders.FloatingLayers = 0;
            yield return Frames(2);
            Assert.That(colliders.Taken, Is.Empty);
        }

        [UnityTest]
        public IEnumerator One_event_tells_of_the_contacts_of_all_colliders()
        {
            var told = new List<string>();
            FluidPhysicsColliders colliders = Pool();
            GameObject wet = Make("Wet", new Vector3(0f, -0.2f, 0f)), dry = Make("Dry", new Vector3(0f, 0.25f, 0f));
            var box = wet.AddComponent<BoxCollider>();
            box.size = 0.1f * Vector3.one;
            dry.AddComponent<SphereCollider>().radius = 0.05f;
            colliders.OnEnter += contact => told.Add($"{contact.Collider.name} touched");
            colliders.OnExit += contact => told.Add($"{contact.Collider.name} left");
            yield return Frames(10);
            Assert.That(told, Is.EqualTo(new[] { "Wet touched" }));
            wet.transform.position = new Vector3(20f, 0f, 0f);
            UnityEngine.Physics.SyncTransforms();
            yield return Frames(3);
            Assert.That(told, Is.EqualTo(new[] { "Wet touched", "Wet left" }));
        }

        FluidPhysicsColliders Pool()
        {
            GameObject pool = Make("Pool", Vector3.zero);
            pool.SetActive(false);
            var fluid = pool.AddComponent<FluidSimulation>();
            fluid.Configure(0.6f * Vector3.one, FloatingScene.Spacing, 1000);
            var water = new GameObject("Water");
            water.transform.SetParent(pool.transform, false);
            water.transform.localPosition = new Vector3(0f, -0.15f, 0f);
            water.AddComponent<FluidVolume>().Size = new Vector3(0.6f, 0.3f, 0.6f);
            var colliders = pool.AddComponent<FluidPhysicsColliders>();
            colliders.ColliderLayers = colliders.FloatingLayers = 1 << Layer;
            pool.SetActive(true);
            return colliders;
        }

        Rigidbody Body(string name)
        {
            GameObject thing = Make(name, new Vector3(-0.2f, -0.2f, 0f));
            thing.AddComponent<SphereCollider>().radius = 0.05f;
            var body = thing.AddComponent<Rigidbody>();
            body.useGravity = false;
            return body;
        }

        GameObject Make(string name, Vector3 position)
        {
            var thing = new GameObject(name) { layer = Layer };
            thing.transform.position = position;
            made.Add(thing);
            return thing;
        }

        static IEnumerator Frames(int count)
        {
            for (int i = 0; i < count; i++)
                yield return null;
        }
    }
}
