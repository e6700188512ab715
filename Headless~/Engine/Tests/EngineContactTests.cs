using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Headless;
using Object = UnityEngine.Object;

namespace Host.Tests
{
    /// <summary>Bodies meet floors, each other and static colliders, as in Unity.</summary>
    public class EngineContactTests : EngineFixture
    {
        const float Step = 0.02f;
        const float Tolerance = 0.005f;         // m, half of Unity's contact offset

        [Test]
        public void A_box_rests_on_a_floor()
        {
            Floor();
            Rigidbody box = Box(new Vector3(0f, 1.2f, 0f));
            Frames(150);
            Assert.That(box.position.y, Is.EqualTo(0.5f).Within(Tolerance));
            Assert.That(new Vector2(box.position.x, box.position.z).magnitude, Is.LessThan(Tolerance));
            Assert.That(box.velocity.magnitude, Is.LessThan(0.01f));
        }

        [Test]
        public void A_box_falls_freely_until_it_touches()
        {
            Floor();
            Rigidbody box = Box(new Vector3(0f, 20f, 0f)), free = Box(new Vector3(50f, 20f, 0f));
            Object.DestroyImmediate(free.GetComponent<BoxCollider>());
            Frames(60);
            Assert.That(box.velocity, Is.EqualTo(free.velocity), "to the last digit");
            Assert.That(box.position.y, Is.EqualTo(20f - 9.81f * Step * Step * 60f * 61f / 2f).Within(1e-3f));
        }

        [Test]
        public void A_stack_of_three_boxes_stays()
        {
            Floor();
            var stack = new Rigidbody[3];
            for (int i = 0; i < 3; i++)
                stack[i] = Box(new Vector3(0f, 0.5f + i, 0f));
            Frames(500);
            for (int i = 0; i < 3; i++)
            {
                Assert.That(stack[i].position.y, Is.EqualTo(0.5f + i).Within(Tolerance), $"box {i}");
                Assert.That(new Vector2(stack[i].position.x, stack[i].position.z).magnitude, Is.LessThan(Tolerance), $"box {i}");
            }
        }

        // A solid ball that rolls without slip: 5/7 g sin(a) (a standard result of mechanics).
        [Test]
        public void A_ball_rolls_down_a_ramp_as_a_solid_ball_does()
        {
            const float angle = 20f;
            Collider ramp = Solid(Vector3.zero, new Vector3(40f, 1f, 10f));
            ramp.transform.rotation = Quaternion.Euler(0f, 0f, -angle);
            Vector3 up = ramp.transform.rotation * Vector3.up, down = ramp.transform.rotation * Vector3.right;
            Rigidbody ball = Ball(up, 0.5f);
            ball.angularDrag = 0f;
            ball.maxAngularVelocity = 100f;
            Frames(100);
            Vector3 path = ball.position - up;
            float expected = 5f / 7f * 9.81f * Mathf.Sin(angle * Mathf.Deg2Rad) * 0.5f * 2f * 2f;
            Assert.That(Vector3.Dot(path, down), Is.EqualTo(expected).Within(0.04f * expected));
            Assert.That(Vector3.Dot(path, up), Is.EqualTo(0f).Within(Tolerance), "it stays on the ramp");
            Assert.That(ball.angularVelocity.magnitude * 0.5f, Is.EqualTo(ball.velocity.magnitude).Within(0.03f * ball.velocity.magnitude));
        }

        [TestCase(0.6f, false)]
        [TestCase(0.2f, true)]
        public void Friction_holds_a_box_on_a_ramp_up_to_its_angle(float friction, bool slides)
        {
            Collider ramp = Solid(Vector3.zero, new Vector3(60f, 1f, 10f));
            ramp.transform.rotation = Quaternion.Euler(0f, 0f, -20f);           // its tangent is 0.364
            Rigidbody box = Box(ramp.transform.rotation * Vector3.up);
            box.rotation = ramp.transform.rotation;
            var material = new PhysicMaterial { dynamicFriction = friction, staticFriction = friction };
            ramp.sharedMaterial = box.GetComponent<Collider>().sharedMaterial = material;
            Vector3 start = box.position;
            Frames(100);
            float path = (box.position - start).magnitude, free = 0.5f * 9.81f * 4f * (0.342f - friction * 0.940f);
            if (slides)
                Assert.That(path, Is.EqualTo(free).Within(0.05f * free));
            else
                Assert.That(path, Is.LessThan(0.02f));
        }

        [TestCase(PhysicMaterialCombine.Average, 0.5f)]
        [TestCase(PhysicMaterialCombine.Maximum, 1f)]
        [TestCase(PhysicMaterialCombine.Minimum, 0f)]
        [TestCase(PhysicMaterialCombine.Multiply, 0f)]
        public void A_ball_bounces_as_the_two_materials_say(PhysicMaterialCombine combine, float expected)
        {
            Floor().sharedMaterial = new PhysicMaterial { bounciness = 0f };
            Rigidbody ball = Ball(new Vector3(0f, 3f, 0f), 0.5f);
            ball.GetComponent<Collider>().sharedMaterial = new PhysicMaterial { bounciness = 1f, bounceCombine = combine };
            float fastest = 0f, after = 0f;
            for (int i = 0; i < 60; i++)
            {
                Frames(1);
                fastest = Mathf.Min(fastest, ball.velocity.y);
                after = Mathf.Max(after, ball.velocity.y);
            }
            Assert.That(after, Is.EqualTo(-expected * fastest).Within(0.05f * -fastest));
        }

        [Test]
        public void What_is_slower_than_the_threshold_does_not_bounce()
        {
            Floor();
            Rigidbody ball = Ball(new Vector3(0f, 0.6f, 0f), 0.5f);
            ball.GetComponent<Collider>().sharedMaterial = new PhysicMaterial { bounciness = 1f, bounceCombine = PhysicMaterialCombine.Maximum };
            Frames(50);
            Assert.That(ball.position.y, Is.EqualTo(0.5f).Within(Tolerance), "1.4 m/s, and the threshold is 2");
        }

        [Test]
        public void A_boat_of_several_colliders_does_not_pass_a_quay()
        {
            Floor();
            Solid(new Vector3(3f, 1f, 0f), new Vector3(2f, 2f, 6f));
            var boat = new GameObject("Boat").AddComponent<Rigidbody>();
            boat.mass = 400f;
            foreach (float side in new[] { -0.5f, 0.5f })
            {
                var hull = new GameObject("Hull").AddComponent<BoxCollider>();
                hull.transform.SetParent(boat.transform);
                hull.transform.localPosition = new Vector3(0f, 0f, side);
                hull.size = new Vector3(2f, 0.5f, 0.4f);
            }
            boat.position = new Vector3(-1f, 0.25f, 0f);
            for (int i = 0; i < 150; i++)
            {
                boat.AddForce(new Vector3(4000f, 0f, 0f));
                Frames(1);
                Assert.That(boat.position.x, Is.LessThan(1.1f), "its bow is 1 m ahead of its center, the quay begins at 2");
            }
            Assert.That(boat.position.x, Is.EqualTo(1f).Within(Tolerance), "it lies against the quay");
        }

        [Test]
        public void A_kinematic_body_pushes_and_is_not_pushed()
        {
            Floor();
            Rigidbody box = Box(new Vector3(0f, 0.5f, 0f)), pusher = Box(new Vector3(-2f, 0.5f, 0f));
            pusher.isKinematic = true;
            for (int i = 1; i <= 100; i++)
            {
                pusher.MovePosition(new Vector3(-2f + 0.02f * i, 0.5f, 0f));
                Frames(1);
            }
            Assert.That(pusher.position.x, Is.EqualTo(0f).Within(1e-5f));
            Assert.That(box.position.x, Is.GreaterThanOrEqualTo(1f - Tolerance));
        }

        [Test]
        public void Layers_and_pairs_that_are_ignored_pass_through_each_other()
        {
            Collider floor = Floor();
            Rigidbody meets = Box(new Vector3(0f, 1f, 0f)), layered = Box(new Vector3(5f, 1f, 0f)), paired = Box(new Vector3(-5f, 1f, 0f));
            layered.gameObject.layer = 7;
            Physics.IgnoreLayerCollision(7, 0);
            Physics.IgnoreCollision(paired.GetComponent<Collider>(), floor);
            Assert.That(Physics.GetIgnoreLayerCollision(0, 7));
            Frames(100);
            Assert.That(meets.position.y, Is.EqualTo(0.5f).Within(Tolerance));
            Assert.That(layered.position.y, Is.LessThan(-5f));
            Assert.That(paired.position.y, Is.LessThan(-5f));
        }

        [Test]
        public void A_ball_rests_on_a_mesh_and_passes_it_from_behind()
        {
            var plane = new Mesh
            {
                vertices = new[] { new Vector3(-5f, 0f, -5f), new Vector3(-5f, 0f, 5f), new Vector3(5f, 0f, 5f), new Vector3(5f, 0f, -5f) },
                triangles = new[] { 0, 1, 2, 0, 2, 3 },
            };
            var ground = new GameObject("Ground").AddComponent<MeshCollider>();
            ground.sharedMesh = plane;
            Rigidbody ball = Ball(new Vector3(0.3f, 1f, 0.3f), 0.5f), below = Ball(new Vector3(3f, -1f, 0f), 0.5f),
                box = Box(new Vector3(-3f, 1f, 0f));
            below.useGravity = false;
            below.velocity = new Vector3(0f, 2f, 0f);
            Frames(100);
            Assert.That(ball.position.y, Is.EqualTo(0.5f).Within(Tolerance));
            Assert.That(box.position.y, Is.EqualTo(0.5f).Within(Tolerance));
            Assert.That(below.position.y, Is.GreaterThan(1f), "triangles are met on their front");
            Object.DestroyImmediate(plane);
        }

        [Test]
        public void A_convex_mesh_rests_where_its_points_are()
        {
            Floor();
            Mesh wedge = Wedge();
            var body = new GameObject("Wedge").AddComponent<Rigidbody>();
            var hull = body.gameObject.AddComponent<MeshCollider>();
            hull.sharedMesh = wedge;
            hull.convex = true;
            body.position = new Vector3(0f, 0.5f, 0f);
            Frames(150);
            Assert.That(body.position.y, Is.EqualTo(0f).Within(Tolerance), "its lowest points are at 0");
            Assert.That(Vector3.Angle(body.rotation * Vector3.up, Vector3.up), Is.LessThan(1f));
            Object.DestroyImmediate(wedge);
        }

        [Test]
        public void A_mesh_that_is_not_convex_on_a_free_body_is_an_error_and_meets_nothing()
        {
            Floor();
            Mesh wedge = Wedge();
            var body = new GameObject("Wedge").AddComponent<Rigidbody>();
            body.gameObject.AddComponent<MeshCollider>().sharedMesh = wedge;
            body.position = new Vector3(0f, 1f, 0f);
            Frames(100);
            Assert.That(Errors(), Has.Count.EqualTo(1).And.Some.Contains("Non-convex MeshCollider with non-kinematic Rigidbody"));
            Assert.That(body.position.y, Is.LessThan(-5f));
            Object.DestroyImmediate(wedge);
        }

        [Test]
        public void A_body_that_rests_falls_asleep_and_wakes_as_its_floor_goes()
        {
            Collider floor = Floor();
            Rigidbody box = Box(new Vector3(0f, 0.5f, 0f));
            Frames(100);
            Assert.That(box.IsSleeping());
            Assert.That(box.velocity, Is.EqualTo(Vector3.zero));
            floor.enabled = false;
            Frames(50);
            Assert.That(box.IsSleeping(), Is.False);
            Assert.That(box.position.y, Is.LessThan(-1f));
        }

        [Test]
        public void A_sleeping_body_wakes_as_another_hits_it()
        {
            Floor();
            Rigidbody box = Box(new Vector3(0f, 0.5f, 0f));
            Frames(100);
            Rigidbody ball = Ball(new Vector3(-3f, 0.5f, 0f), 0.5f);
            ball.velocity = new Vector3(8f, 0f, 0f);
            Frames(30);
            Assert.That(box.position.x, Is.GreaterThan(0.05f));
        }

        [Test]
        public void A_fast_body_with_continuous_detection_stops_at_a_thin_wall()
        {
            Solid(new Vector3(10f, 0f, 0f), new Vector3(0.1f, 10f, 10f));
            Rigidbody fast = Ball(Vector3.zero, 0.1f), through = Ball(new Vector3(0f, 2f, 0f), 0.1f);
            fast.collisionDetectionMode = CollisionDetectionMode.Continuous;
            foreach (Rigidbody ball in new[] { fast, through })
            {
                ball.useGravity = false;
                ball.velocity = new Vector3(97f, 0f, 0f);
            }
            Frames(20);
            Assert.That(fast.position.x, Is.LessThan(10f));
            Assert.That(through.position.x, Is.GreaterThan(10f), "as discrete detection does at 1.9 m a step");
        }

        [Test]
        public void The_same_scene_comes_out_the_same_to_the_last_digit()
        {
            List<Vector3> first = Tumble();
            StopPlayer();
            StartPlayer();
            Assert.That(Tumble(), Is.EqualTo(first));
        }

        List<Vector3> Tumble()
        {
            Floor();
            var bodies = new List<Rigidbody>();
            for (int i = 0; i < 12; i++)
            {
                Rigidbody body = i % 2 == 0 ? Box(new Vector3(0.3f * (i % 3), 1f + 1.1f * i, 0.2f * i))
                    : Ball(new Vector3(0.1f * i, 1f + 1.1f * i, 0f), 0.5f);
                body.rotation = Quaternion.Euler(10f * i, 20f * i, 0f);
                bodies.Add(body);
            }
            Frames(200);
            return bodies.ConvertAll(body => body.position);
        }

        [Test]
        public void A_bodys_center_and_tensor_are_those_of_its_colliders()
        {
            Rigidbody body = Box(Vector3.zero);
            body.mass = 12f;
            Assert.That((body.inertiaTensor - Vector3.one * 2f).magnitude, Is.LessThan(1e-4f), "12/12 * (1 + 1)");
            var second = new GameObject("Second").AddComponent<BoxCollider>();
            second.transform.SetParent(body.transform);
            second.transform.localPosition = new Vector3(1f, 0f, 0f);
            Assert.That((body.centerOfMass - new Vector3(0.5f, 0f, 0f)).magnitude, Is.LessThan(1e-6f));
            Assert.That((body.inertiaTensor - new Vector3(2f, 5f, 5f)).magnitude, Is.LessThan(1e-4f), "a box of 2 x 1 x 1 m");
            body.SetDensity(100f);
            Assert.That(body.mass, Is.EqualTo(200f).Within(1e-3f));
            second.isTrigger = true;
            Assert.That(body.centerOfMass, Is.EqualTo(Vector3.zero));
        }

        [Test]
        public void Primitives_come_with_the_colliders_that_Unity_gives_them()
        {
            var primitive = new GameObject("Cube");
            PhysicsLoop.Current.AddCollider(primitive, PrimitiveType.Cube);
            Assert.That(primitive.GetComponent<BoxCollider>(), Is.Not.Null);
            PhysicsLoop.Current.AddCollider(primitive, PrimitiveType.Cylinder);
            Assert.That(primitive.GetComponent<CapsuleCollider>(), Is.Not.Null);
        }

        // A roof's shape: three points wide, flat below.
        static Mesh Wedge() => new Mesh
        {
            vertices = new[] { new Vector3(-1f, 0f, -1f), new Vector3(1f, 0f, -1f), new Vector3(1f, 0f, 1f), new Vector3(-1f, 0f, 1f),
                new Vector3(0f, 1f, -1f), new Vector3(0f, 1f, 1f) },
            triangles = new[] { 0, 1, 2, 0, 2, 3, 0, 4, 1, 3, 2, 5, 0, 3, 5, 0, 5, 4, 1, 4, 5, 1, 5, 2 },
        };

        // Its top is at 0.
        static Collider Floor() => Solid(new Vector3(0f, -0.5f, 0f), new Vector3(40f, 1f, 40f));

        static Collider Solid(Vector3 position, Vector3 size)
        {
            var thing = new GameObject("Solid");
            thing.transform.position = position;
            var box = thing.AddComponent<BoxCollider>();
            box.size = size;
            return box;
        }

        static Rigidbody Box(Vector3 position)
        {
            var thing = new GameObject("Box");
            thing.transform.position = position;
            thing.AddComponent<BoxCollider>();
            return thing.AddComponent<Rigidbody>();
        }

        static Rigidbody Ball(Vector3 position, float radius)
        {
            var thing = new GameObject("Ball");
            thing.transform.position = position;
            thing.AddComponent<SphereCollider>().radius = radius;
            return thing.AddComponent<Rigidbody>();
        }
    }
}
