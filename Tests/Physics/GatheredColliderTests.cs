using System.Collections.Generic;
using System.Reflection;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;
using UnityEngine.TestTools.Constraints;
using Is = NUnit.Framework.Is;

namespace Rill.Tests
{
    /// <summary>Which colliders of Unity's physics a fluid takes, and with which shapes.</summary>
    public class GatheredColliderTests
    {
        const int Layer = 8;

        readonly List<GameObject> made = new List<GameObject>();
        FluidPhysicsColliders colliders;

        // Inactive: no fluid runs, and the test asks instead.
        [SetUp]
        public void MakeSource()
        {
            GameObject fluid = Make("Pool");
            fluid.SetActive(false);
            colliders = fluid.AddComponent<FluidPhysicsColliders>();
            colliders.ColliderLayers = 1 << Layer;
        }

        [TearDown]
        public void DestroyAll()
        {
            foreach (GameObject gameObject in made)
                Object.DestroyImmediate(gameObject);
            made.Clear();
        }

        [Test]
        public void A_box_is_stretched_along_its_axes_and_mirrored()
        {
            var box = Add<BoxCollider>(new Vector3(0.1f, 0f, 0f), Quaternion.Euler(0f, 90f, 0f), new Vector3(1f, -2f, 3f));
            box.center = new Vector3(0.1f, 0.2f, 0.1f);
            box.size = new Vector3(0.2f, 0.3f, 0.4f);
            ColliderMotion motion = TheOnly();
            Assert.That(motion.shape, Is.EqualTo(ColliderShape.Box));
            AssertNear(motion.size, new Vector3(0.1f, 0.3f, 0.6f));
            AssertNear(motion.end.position, new Vector3(0.1f + 0.3f, -0.4f, -0.1f));
            AssertNear(math.mul(motion.end.rotation, new float3(0f, 0f, 1f)), Vector3.right);
        }

        [Test]
        public void A_sphere_grows_with_the_largest_scale()
        {
            var sphere = Add<SphereCollider>(Vector3.zero, Quaternion.identity, new Vector3(1f, -3f, 2f));
            sphere.radius = 0.2f;
            sphere.center = new Vector3(0f, 0.1f, 0f);
            ColliderMotion motion = TheOnly();
            Assert.That(motion.shape, Is.EqualTo(ColliderShape.Sphere));
            Assert.That(motion.size.x, Is.EqualTo(0.6f).Within(1e-6f));
            AssertNear(motion.end.position, new Vector3(0f, -0.3f, 0f));
        }

        [TestCase(0, 0.4f, 0.3f)]
        [TestCase(1, 0.2f, 0.4f)]
        [TestCase(2, 0.3f, 0.4f)]
        public void A_capsule_is_scaled_along_its_axis_and_by_the_larger_of_the_others(int direction, float radius, float halfHeight)
        {
            var capsule = Add<CapsuleCollider>(Vector3.zero, Quaternion.Euler(10f, 20f, 30f), new Vector3(2f, 3f, -4f));
            capsule.direction = direction;
            capsule.radius = radius / (direction == 2 ? 3f : 4f);
            capsule.height = 2f * (radius + halfHeight) / (direction + 2f);
            ColliderMotion motion = TheOnly();
            Assert.That(motion.shape, Is.EqualTo(ColliderShape.Capsule));
            AssertNear(motion.size, new Vector3(radius, halfHeight, 0f));
            Vector3 axis = Vector3.zero;
            axis[direction] = 1f;
            AssertNear(math.mul(motion.end.rotation, new float3(0f, 1f, 0f)), capsule.transform.rotation * axis);
        }

        [Test]
        public void A_character_stands_upright_however_its_object_is_turned()
        {
            var character = Add<CharacterController>(Vector3.zero, Quaternion.Euler(0f, 0f, 90f), Vector3.one);
            character.radius = 0.3f;
            character.height = 1.8f;
            ColliderMotion motion = TheOnly();
            Assert.That(motion.shape, Is.EqualTo(ColliderShape.Capsule));
            AssertNear(motion.size, new Vector3(0.3f, 0.6f, 0f));
            AssertNear(math.mul(motion.end.rotation, new float3(0f, 1f, 0f)), Vector3.up);
        }

        [Test]
        public void What_comes_goes_and_moves_is_noticed()
        {
            Assert.That(Gather(), Is.Empty);
            var first = Add<BoxCollider>(Vector3.zero);
            var second = Add<SphereCollider>(new Vector3(0.5f, 0f, 0f));
            var third = Add<BoxCollider>(new Vector3(-0.5f, 0f, 0f));
            List<IFluidCollider> taken = Gather();
            Assert.That(Objects(taken), Is.EqualTo(new Collider[] { first, second, third }));
            IFluidCollider last = taken[2];

            first.enabled = false;
            Assert.That(taken[0].IsAlive, Is.False, "at once");
            Assert.That(taken[0].TryDescribe(out _), Is.False);
            Assert.That(Objects(Gather()), Is.EqualTo(new Collider[] { second, third }), "in the same order");
            Assert.That(Gather()[1], Is.SameAs(last), "the same to the fluid");

            second.transform.position = new Vector3(100f, 0f, 0f);
            UnityEngine.Physics.SyncTransforms();
            Assert.That(Objects(Gather()), Is.EqualTo(new Collider[] { third }));
            second.transform.position = Vector3.zero;
            UnityEngine.Physics.SyncTransforms();
            third.gameObject.layer = 0;
            Assert.That(Objects(Gather()), Is.EqualTo(new Collider[] { second }));
            second.gameObject.SetActive(false);
            first.enabled = true;
            Assert.That(Objects(Gather()), Is.EqualTo(new Collider[] { first }));
            taken = Gather();
            IFluidCollider destroyed = taken[0];
            Object.DestroyImmediate(first.gameObject);
            Assert.That(destroyed.IsAlive, Is.False);
            Assert.That(destroyed.TryDescribe(out _), Is.False);
            Assert.That(Gather(), Is.Empty);
        }

        [Test]
        public void Triggers_other_layers_and_what_a_FluidCollider_stands_for_are_left_out()
        {
            Add<BoxCollider>(Vector3.zero).isTrigger = true;
            Add<BoxCollider>(Vector3.zero).gameObject.layer = Layer + 1;
            var own = Add<BoxCollider>(Vector3.zero);
            var fluidCollider = own.gameObject.AddComponent<FluidCollider>();
            var child = Add<SphereCollider>(Vector3.zero);
            child.transform.SetParent(own.transform);
            own.gameObject.AddComponent<Rigidbody>();
            Assert.That(Gather(), Is.Empty);
            fluidCollider.enabled = false;
            Assert.That(Gather().Count, Is.EqualTo(2), "with its body's child");
            var buoyancy = own.gameObject.AddComponent<FluidBuoyancy>();
            Assert.That(Gather(), Is.Empty, "carried by the Fluid Colliders of its body");
            buoyancy.enabled = false;
            Assert.That(Gather().Count, Is.EqualTo(2));
        }

        [Test]
        public void More_colliders_than_the_first_results_hold_are_all_found()
        {
            for (int i = 0; i < 150; i++)
                Add<SphereCollider>(Vector3.zero).radius = 0.01f;
            Assert.That(Gather().Count, Is.EqualTo(150));
        }

        [Test]
        public void A_query_without_room_for_results_makes_room()
        {
            Add<BoxCollider>(Vector3.zero);
            typeof(FluidPhysicsColliders).GetField("found", BindingFlags.Instance | BindingFlags.NonPublic).SetValue(colliders, new Collider[0]);
            Assert.That(Gather().Count, Is.EqualTo(1));
        }

        [Test]
        public void With_no_layers_the_physics_is_never_asked()
        {
            Add<BoxCollider>(Vector3.zero);
            colliders.ColliderLayers = 0;
            Assert.That(Gather(), Is.Empty);
            Assert.That(colliders.HasAsked, Is.False);
            TestDelegate ask = () => Gather();
            Assert.That(ask, Is.Not.AllocatingGCMemory());
            colliders.ColliderLayers = 1 << Layer;
            Assert.That(Gather(), Is.Not.Empty);
            colliders.ColliderLayers = 0;
            Assert.That(Gather(), Is.Empty, "what it had is given back");
        }

        [Test]
        public void Asking_again_allocates_no_managed_memory()
        {
            Add<BoxCollider>(Vector3.zero);
            Add<SphereCollider>(Vector3.zero);
            Add<CapsuleCollider>(Vector3.zero);
            TestDelegate frame = () =>
            {
                foreach (IFluidCollider collider in Gather())
                    collider.TryDescribe(out _);
            };
            frame();
            Assert.That(frame, Is.Not.AllocatingGCMemory());
        }

        [Test]
        public void What_cannot_be_taken_is_said_once_by_name()
        {
            var mesh = Add<MeshCollider>(Vector3.zero);
            mesh.sharedMesh = Cube();
            mesh.name = "Rock";
            LogAssert.Expect(LogType.Error, new Regex(
                "FluidPhysicsColliders 'Pool' leaves out the collider 'Rock': its mesh has no signed distance field. Bake one " +
                "and add both to Mesh Fields"));
            for (int i = 0; i < 2; i++)
                Assert.That(Gather()[0].TryDescribe(out _), Is.False);
            var box = Add<BoxCollider>(Vector3.zero);
            box.name = "Sheet";
            box.size = new Vector3(1f, 0f, 1f);
            LogAssert.Expect(LogType.Error, new Regex("FluidPhysicsColliders 'Pool' leaves out the collider 'Sheet': its size or scale is 0"));
            Assert.That(Gather()[1].TryDescribe(out _), Is.False);

            var problems = new List<string>();
            ((IHasProblems)colliders).ListProblems(problems);
            Assert.That(problems.Count, Is.EqualTo(2));
            colliders.ColliderLayers = 0;
            Gather();
            problems.Clear();
            ((IHasProblems)colliders).ListProblems(problems);
            Assert.That(problems, Is.EqualTo(new[] {
                "it takes no colliders: Collider Layers is Nothing. Choose the layers of what holds the water." }));
        }

        [Test]
        public void A_mesh_is_what_its_field_says()
        {
            Mesh cube = Cube();
            MeshSdfSettings settings = MeshSdfSettings.Default;
            settings.resolution = 16;
            SignedDistanceField field = SignedDistanceField.Create(MeshSdfBaker.Bake(cube, settings));
            var mesh = Add<MeshCollider>(new Vector3(0f, 0.2f, 0f), Quaternion.identity, new Vector3(-2f, 2f, 2f));
            mesh.sharedMesh = cube;
            colliders.MeshFields.Add(new MeshField(cube, field));
            ColliderMotion motion = TheOnly();
            Assert.That(motion.shape, Is.EqualTo(ColliderShape.Mesh));
            Assert.That(motion.field, Is.SameAs(field.Texture));
            Assert.That(motion.fieldUnit, Is.EqualTo(2f));
            Assert.That(motion.mirrored.x && !motion.mirrored.y && !motion.mirrored.z);
            AssertNear(motion.end.position, new Vector3(0f, 0.2f, 0f));

            mesh.transform.localScale = new Vector3(1f, 2f, 1f);
            LogAssert.Expect(LogType.Error, new Regex("its scale .* is not the same along all axes"));
            Assert.That(Gather()[0].TryDescribe(out _), Is.False);
            Object.DestroyImmediate(field.Texture);
            Object.DestroyImmediate(field);
            Object.DestroyImmediate(cube);
        }

        [Test]
        public void Meshes_near_the_box_without_a_field_are_listed_once()
        {
            Mesh cube = Cube(), other = Cube();
            var rock = Add<MeshCollider>(Vector3.zero);
            rock.sharedMesh = Add<MeshCollider>(Vector3.zero).sharedMesh = cube;
            Add<MeshCollider>(Vector3.zero).sharedMesh = other;
            Add<MeshCollider>(new Vector3(30f, 0f, 0f)).sharedMesh = Cube();
            var own = Add<MeshCollider>(Vector3.zero);
            own.sharedMesh = Cube();
            own.gameObject.AddComponent<FluidCollider>();
            Add<BoxCollider>(Vector3.zero);
            UnityEngine.Physics.SyncTransforms();
            Assert.That(Missing(), Is.EqualTo(new[] { cube, other }));
            SignedDistanceField field = ScriptableObject.CreateInstance<SignedDistanceField>();
            colliders.MeshFields.Add(new MeshField(other, null));
            colliders.MeshFields.Add(new MeshField(cube, field));
            Assert.That(Missing(), Is.EqualTo(new[] { other }), "a pair without a field is none");
            colliders.ColliderLayers = 1 << Layer + 1;
            Assert.That(Missing(), Is.Empty);
            Object.DestroyImmediate(field);
        }

        List<Mesh> Missing()
        {
            var missing = new List<Mesh>();
            colliders.ListMissingFields(missing);
            return missing;
        }

        [Test]
        public void Values_out_of_range_are_clamped_and_said()
        {
            LogAssert.Expect(LogType.Warning, new Regex("FluidPhysicsColliders 'Pool': friction 2 is outside 0 to 1"));
            colliders.Friction = 2f;
            Assert.That(colliders.Friction, Is.EqualTo(1f));
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void A_new_FluidCollider_fits_the_collider_that_is_there()
        {
            var box = Add<BoxCollider>(Vector3.zero);
            box.center = Vector3.up;
            box.size = new Vector3(1f, 2f, 3f);
            FluidCollider collider = Fitted(box);
            Assert.That((collider.Shape, collider.Center, collider.Size), Is.EqualTo((ColliderShape.Box, Vector3.up, box.size)));

            var sphere = Add<SphereCollider>(Vector3.zero);
            sphere.center = Vector3.left;
            sphere.radius = 0.3f;
            collider = Fitted(sphere);
            Assert.That((collider.Shape, collider.Center, collider.Radius), Is.EqualTo((ColliderShape.Sphere, Vector3.left, 0.3f)));

            var capsule = Add<CapsuleCollider>(Vector3.zero);
            capsule.radius = 0.2f;
            capsule.height = 1.5f;
            collider = Fitted(capsule);
            Assert.That((collider.Shape, collider.Radius, collider.Height), Is.EqualTo((ColliderShape.Capsule, 0.2f, 1.5f)));
            capsule.direction = 0;
            Assert.That(PhysicsFit.Fit(collider), Is.False, "a Fluid Collider's capsule is along y");

            Assert.That(Fitted(Add<MeshCollider>(Vector3.zero)).Shape, Is.EqualTo(ColliderShape.Mesh));
        }

        static FluidCollider Fitted(Collider own)
        {
            var collider = own.gameObject.AddComponent<FluidCollider>();
            Assert.That(PhysicsFit.Fit(collider), Is.True);
            return collider;
        }

        [Test]
        public void A_collider_whose_ground_throws_is_left_out_alone_and_logged_once()
        {
            System.Func<Collider, IColliderGround> installed = ColliderGround.Find;
            Add<BoxCollider>(Vector3.zero, Quaternion.identity, Vector3.one).name = "Whole";
            Add<SphereCollider>(Vector3.zero, Quaternion.identity, Vector3.one).name = "Faulty";
            colliders.gameObject.SetActive(true);
            try
            {
                ColliderGround.Find = collider => collider.name == "Faulty" ? throw new System.InvalidOperationException("planted") : null;
                LogAssert.Expect(LogType.Exception, new Regex("planted"));
                LogAssert.Expect(LogType.Warning, new Regex("FluidSimulation 'Pool' goes on without SphereCollider 'Faulty'"));
                for (int i = 0; i < 3; i++)
                    Assert.That(TheOnly().shape, Is.EqualTo(ColliderShape.Box));
            }
            finally
            {
                ColliderGround.Find = installed;
            }
            LogAssert.NoUnexpectedReceived();
        }

        List<IFluidCollider> Gather() => ((IColliderSource)colliders).Gather(Vector3.zero, Quaternion.identity, Vector3.one, 0.05f);

        ColliderMotion TheOnly()
        {
            UnityEngine.Physics.SyncTransforms();
            List<IFluidCollider> taken = Gather();
            Assert.That(taken.Count, Is.EqualTo(1));
            Assert.That(taken[0].TryDescribe(out ColliderMotion motion), Is.True);
            return motion;
        }

        static Collider[] Objects(List<IFluidCollider> taken) => taken.ConvertAll(collider => ((GatheredCollider)collider).Collider).ToArray();

        T Add<T>(Vector3 position) where T : Collider => Add<T>(position, Quaternion.identity, Vector3.one);

        T Add<T>(Vector3 position, Quaternion rotation, Vector3 scale) where T : Collider
        {
            GameObject thing = Make(typeof(T).Name);
            thing.layer = Layer;
            thing.transform.SetPositionAndRotation(position, rotation);
            thing.transform.localScale = scale;
            return thing.AddComponent<T>();
        }

        GameObject Make(string name)
        {
            var thing = new GameObject(name);
            made.Add(thing);
            return thing;
        }

        static Mesh Cube()
        {
            var corners = new Vector3[8];
            for (int i = 0; i < 8; i++)
                corners[i] = new Vector3(i & 1, i >> 1 & 1, i >> 2) * 0.5f - Vector3.one * 0.25f;
            int[] triangles = { 0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5 };
            return new Mesh { name = "Cube", vertices = corners, triangles = triangles };
        }

        static void AssertNear(float3 actual, Vector3 expected)
            => Assert.That(math.distance(actual, expected), Is.LessThan(1e-5f), $"{actual}, not {expected}");
    }
}
