using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Headless;
using Object = UnityEngine.Object;

namespace Host.Tests
{
    /// <summary>Queries find what they touch and respect layers and triggers.</summary>
    public class EngineQueryTests : EngineFixture
    {
        [Test]
        public void Overlaps_find_what_touches_and_no_more()
        {
            Collider box = At<BoxCollider>("Box", Vector3.zero), ball = At<SphereCollider>("Ball", new Vector3(2f, 0f, 0f));
            Assert.That(Physics.OverlapBox(new Vector3(1f, 0f, 0f), Vector3.one * 0.6f), Is.EqualTo(new[] { box, ball }));
            Assert.That(Physics.OverlapSphere(new Vector3(1f, 0f, 0f), 0.45f), Is.Empty);
            Assert.That(Physics.OverlapSphere(new Vector3(1.1f, 0f, 0f), 0.45f), Is.EqualTo(new[] { ball }));
            Assert.That(Physics.OverlapCapsule(new Vector3(0f, -2f, 0f), new Vector3(0f, 2f, 0f), 0.1f), Is.EqualTo(new[] { box }));
            Assert.That(Physics.OverlapSphere(Vector3.zero, 0.01f), Is.EqualTo(new[] { box }), "all of it inside");
            Assert.That(Physics.CheckBox(new Vector3(0f, 5f, 0f), Vector3.one), Is.False);
            Assert.That(Physics.CheckCapsule(new Vector3(-3f, 0f, 0f), new Vector3(3f, 0f, 0f), 0.1f));
            Assert.That(Physics.CheckSphere(new Vector3(2f, 0.7f, 0f), 0.25f));
            Assert.That(Physics.OverlapSphereNonAlloc(Vector3.zero, 5f, new Collider[1]), Is.EqualTo(1));
        }

        [Test]
        public void Overlaps_and_rays_respect_layers_and_triggers()
        {
            Collider solid = At<BoxCollider>("Solid", Vector3.zero), zone = At<BoxCollider>("Zone", Vector3.zero);
            solid.gameObject.layer = 6;
            zone.isTrigger = true;
            Assert.That(Physics.OverlapBox(Vector3.zero, Vector3.one, Quaternion.identity, 1 << 6), Is.EqualTo(new[] { solid }));
            Assert.That(Physics.OverlapBox(Vector3.zero, Vector3.one, Quaternion.identity, ~0, QueryTriggerInteraction.Ignore),
                Is.EqualTo(new[] { solid }));
            Physics.queriesHitTriggers = false;
            Assert.That(Physics.OverlapBox(Vector3.zero, Vector3.one), Is.EqualTo(new[] { solid }));
            Assert.That(Physics.Raycast(new Vector3(-5f, 0f, 0f), Vector3.right, 20f, 1 << 0), Is.False);
            Physics.queriesHitTriggers = true;
            Assert.That(Physics.Raycast(new Vector3(-5f, 0f, 0f), Vector3.right, out RaycastHit hit, 20f, 1 << 0));
            Assert.That(hit.collider, Is.SameAs(zone));
            solid.gameObject.layer = 2;
            Assert.That(Physics.RaycastAll(new Vector3(-5f, 0f, 0f), Vector3.right).Select(h => h.collider), Is.EqualTo(new[] { zone }),
                "Ignore Raycast");
        }

        [TestCase(typeof(BoxCollider), 4.5f)]
        [TestCase(typeof(SphereCollider), 4.5f)]
        [TestCase(typeof(CapsuleCollider), 4f)]
        public void A_ray_hits_where_the_shape_begins(System.Type shape, float distance)
        {
            var thing = new GameObject("Thing");
            thing.transform.position = new Vector3(0f, -5f, 0f);
            var collider = (Collider)thing.AddComponent(shape);
            Assert.That(Physics.Raycast(new Ray(Vector3.zero, Vector3.down), out RaycastHit hit));
            Assert.That(hit.distance, Is.EqualTo(distance).Within(1e-3f));
            Assert.That((hit.point - new Vector3(0f, -distance, 0f)).magnitude, Is.LessThan(1e-3f));
            Assert.That((hit.normal - Vector3.up).magnitude, Is.LessThan(1e-2f));
            Assert.That(hit.collider, Is.SameAs(collider));
            Assert.That(Physics.Raycast(Vector3.zero, Vector3.down, distance - 0.01f), Is.False);
            Assert.That(Physics.Linecast(Vector3.zero, new Vector3(0f, -distance - 0.01f, 0f)));
            Assert.That(Physics.Raycast(thing.transform.position, Vector3.up), Is.False, "it begins inside");
            Assert.That(collider.Raycast(new Ray(Vector3.zero, Vector3.down), out hit, 10f));
        }

        [Test]
        public void Rays_come_back_nearest_first()
        {
            Collider far = At<BoxCollider>("Far", new Vector3(8f, 0f, 0f)), near = At<BoxCollider>("Near", new Vector3(3f, 0f, 0f));
            Assert.That(Physics.RaycastAll(Vector3.zero, Vector3.right).Select(h => h.collider), Is.EqualTo(new[] { near, far }));
            Assert.That(Physics.RaycastNonAlloc(Vector3.zero, Vector3.right, new RaycastHit[1]), Is.EqualTo(1));
        }

        [Test]
        public void A_ray_hits_a_mesh_on_its_front_unless_it_is_to_hit_backs()
        {
            var mesh = new Mesh
            {
                vertices = new[] { new Vector3(-5f, 0f, -5f), new Vector3(-5f, 0f, 5f), new Vector3(5f, 0f, 5f), new Vector3(5f, 0f, -5f) },
                triangles = new[] { 0, 1, 2, 0, 2, 3 },
            };
            At<MeshCollider>("Ground", Vector3.zero).sharedMesh = mesh;
            Assert.That(Physics.Raycast(new Vector3(1f, 2f, 0f), Vector3.down, out RaycastHit hit));
            Assert.That(hit.distance, Is.EqualTo(2f).Within(1e-3f));
            Assert.That((hit.normal - Vector3.up).magnitude, Is.LessThan(1e-3f));
            Assert.That(Physics.Raycast(new Vector3(1f, -2f, 0f), Vector3.up), Is.False);
            Physics.queriesHitBackfaces = true;
            Assert.That(Physics.Raycast(new Vector3(1f, -2f, 0f), Vector3.up));
            Assert.That(Physics.CheckBox(new Vector3(1f, 0.4f, 0f), Vector3.one * 0.5f));
            Assert.That(Physics.CheckBox(new Vector3(1f, 0.6f, 0f), Vector3.one * 0.5f), Is.False, "its box is flat");
            Object.DestroyImmediate(mesh);
        }

        [Test]
        public void A_moved_shape_stops_by_its_size()
        {
            At<BoxCollider>("Wall", new Vector3(5f, 0f, 0f));
            Assert.That(Physics.SphereCast(Vector3.zero, 0.5f, Vector3.right, out RaycastHit hit));
            Assert.That(hit.distance, Is.EqualTo(4f).Within(0.01f));
            Assert.That(hit.point.x, Is.EqualTo(4.5f).Within(0.01f));
            Assert.That(Physics.BoxCast(Vector3.zero, Vector3.one, Vector3.right, out hit));
            Assert.That(hit.distance, Is.EqualTo(3.5f).Within(0.01f));
            Assert.That(Physics.CapsuleCast(Vector3.up, Vector3.down, 0.25f, Vector3.right, 4.2f), Is.False);
            Rigidbody body = new GameObject("Body").AddComponent<Rigidbody>();
            body.gameObject.AddComponent<SphereCollider>();
            Assert.That(body.SweepTest(Vector3.right, out hit, 10f));
            Assert.That(hit.distance, Is.EqualTo(4f).Within(0.01f));
        }

        [Test]
        public void Penetration_and_the_closest_point_are_those_of_the_shapes()
        {
            Collider one = At<BoxCollider>("One", Vector3.zero), other = At<SphereCollider>("Other", new Vector3(0f, 0.8f, 0f));
            Assert.That(Physics.ComputePenetration(other, other.transform.position, Quaternion.identity, one, Vector3.zero, Quaternion.identity,
                out Vector3 direction, out float distance));
            Assert.That(distance, Is.EqualTo(0.2f).Within(0.005f));
            Assert.That((direction - Vector3.up).magnitude, Is.LessThan(0.01f));
            Assert.That(Physics.ComputePenetration(other, new Vector3(0f, 2f, 0f), Quaternion.identity, one, Vector3.zero, Quaternion.identity,
                out _, out _), Is.False);
            Assert.That((one.ClosestPoint(new Vector3(3f, 0.2f, 0f)) - new Vector3(0.5f, 0.2f, 0f)).magnitude, Is.LessThan(0.01f));
            Assert.That(one.ClosestPoint(new Vector3(0.1f, 0.2f, 0f)), Is.EqualTo(new Vector3(0.1f, 0.2f, 0f)), "inside");
            Assert.That((other.bounds.center - new Vector3(0f, 0.8f, 0f)).magnitude + (other.bounds.size - Vector3.one).magnitude,
                Is.LessThan(1e-5f));
        }

        static T At<T>(string name, Vector3 position) where T : Collider
        {
            var thing = new GameObject(name);
            thing.transform.position = position;
            return thing.AddComponent<T>();
        }
    }
}
