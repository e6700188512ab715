using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Headless;

namespace Host.Tests
{
    /// <summary>Joints hold what they are to hold.</summary>
    public class EngineJointTests : EngineFixture
    {
        [Test]
        public void A_hinge_holds_its_anchor_and_turns_about_its_axis_alone()
        {
            Rigidbody door = Box(new Vector3(1f, 0f, 0f));
            HingeJoint hinge = door.gameObject.AddComponent<HingeJoint>();
            hinge.anchor = new Vector3(-1f, 0f, 0f);
            hinge.axis = Vector3.forward;
            float lowest = 0f;
            for (int i = 0; i < 100; i++)
            {
                Frames(1);
                lowest = Mathf.Min(lowest, door.position.y);
                Assert.That((door.position + door.rotation * hinge.anchor).magnitude, Is.LessThan(0.02f), $"step {i}");
                Assert.That(Mathf.Abs(door.position.z), Is.LessThan(0.005f));
            }
            Assert.That(lowest, Is.LessThan(-0.95f), "it swung down");
            Assert.That(hinge.connectedAnchor, Is.EqualTo(Vector3.zero));
        }

        // Falling turns it about z by negative angles.
        [Test]
        public void A_hinge_stops_at_its_limits()
        {
            Rigidbody door = Box(new Vector3(1f, 0f, 0f));
            HingeJoint hinge = door.gameObject.AddComponent<HingeJoint>();
            hinge.anchor = new Vector3(-1f, 0f, 0f);
            hinge.axis = Vector3.forward;
            hinge.limits = new JointLimits { min = -30f, max = 10f };
            hinge.useLimits = true;
            Frames(200);
            Assert.That(hinge.angle, Is.EqualTo(-30f).Within(1.5f));
            Assert.That(door.position.y, Is.EqualTo(-0.5f).Within(0.03f), "sin(30)");
        }

        [TestCase(90f)]
        [TestCase(-90f)]
        public void A_hinges_motor_turns_it_at_its_speed(float speed)
        {
            Rigidbody wheel = Box(Vector3.zero);
            wheel.useGravity = false;
            HingeJoint hinge = wheel.gameObject.AddComponent<HingeJoint>();
            hinge.axis = Vector3.up;
            hinge.motor = new JointMotor { targetVelocity = speed, force = 100f };
            hinge.useMotor = true;
            Frames(50);
            Assert.That(wheel.angularVelocity.y, Is.EqualTo(speed * Mathf.Deg2Rad).Within(0.05f));
            Assert.That(hinge.velocity, Is.EqualTo(speed).Within(3f));
        }

        [Test]
        public void A_fixed_joint_carries_a_body_with_another()
        {
            Rigidbody carrier = Box(Vector3.zero), load = Box(new Vector3(2f, 0f, 0f));
            carrier.isKinematic = true;
            load.gameObject.AddComponent<FixedJoint>().connectedBody = carrier;
            for (int i = 1; i <= 100; i++)
            {
                carrier.MoveRotation(Quaternion.Euler(0f, -i * 0.9f, 0f));
                Frames(1);
            }
            Frames(20);
            Assert.That((load.position - new Vector3(0f, 0f, 2f)).magnitude, Is.LessThan(0.05f), "a quarter turn");
        }

        [Test]
        public void A_fixed_joint_to_the_world_holds_a_body_in_the_air_until_it_breaks()
        {
            Rigidbody body = Box(new Vector3(0f, 3f, 0f));
            body.gameObject.AddComponent<Broken>();
            FixedJoint joint = body.gameObject.AddComponent<FixedJoint>();
            joint.breakForce = 50f;
            Frames(50);
            Assert.That(body.position.y, Is.EqualTo(3f).Within(0.01f));
            Assert.That(joint.currentForce.magnitude, Is.EqualTo(9.81f).Within(0.5f), "its weight");
            body.AddForce(new Vector3(0f, -200f, 0f));
            Frames(30);
            Assert.That(Story.Take(), Is.EqualTo(new[] { "broken" }));
            Assert.That(joint == null);
            Assert.That(body.position.y, Is.LessThan(2.5f));
        }

        sealed class Broken : MonoBehaviour
        {
            void OnJointBreak(float force) => Story.Tell(force > 50f ? "broken" : $"at {force}");
        }

        // k x = m g: 9.81 / 100.
        [TestCase(100f)]
        [TestCase(1e6f)]
        public void A_spring_hangs_where_it_balances_the_weight(float stiffness)
        {
            Rigidbody body = Box(new Vector3(0f, -1f, 0f));
            SpringJoint spring = body.gameObject.AddComponent<SpringJoint>();
            spring.autoConfigureConnectedAnchor = false;
            spring.connectedAnchor = Vector3.zero;
            spring.minDistance = spring.maxDistance = 1f;
            spring.spring = stiffness;
            spring.damper = 5f;
            Frames(400);
            Assert.That(body.position.y, Is.EqualTo(-1f - 9.81f / stiffness).Within(0.005f));
            Assert.That(body.velocity.magnitude, Is.LessThan(0.02f));
        }

        [Test]
        public void Bodies_of_one_joint_pass_through_each_other_unless_it_lets_them_meet()
        {
            foreach (bool meet in new[] { false, true })
            {
                Rigidbody one = Box(Vector3.zero), other = Box(new Vector3(0.6f, 0f, 0f));
                one.useGravity = other.useGravity = false;
                SpringJoint spring = other.gameObject.AddComponent<SpringJoint>();
                FixedJoint joint = other.gameObject.AddComponent<FixedJoint>();
                joint.connectedBody = spring.connectedBody = one;
                joint.enableCollision = meet;
                Object.DestroyImmediate(spring);
                Frames(10);
                Assert.That(one.position.magnitude > 1e-4f, Is.EqualTo(meet));
                Object.DestroyImmediate(one.gameObject);
                Object.DestroyImmediate(other.gameObject);
            }
        }

        [Test]
        public void A_clone_is_joined_to_the_clone_of_the_other_body()
        {
            var boat = new GameObject("Boat");
            Rigidbody hull = Box(Vector3.zero), rudder = Box(new Vector3(0f, 0f, -2f));
            hull.transform.SetParent(boat.transform);
            rudder.transform.SetParent(boat.transform);
            hull.mass = 70f;
            HingeJoint hinge = rudder.gameObject.AddComponent<HingeJoint>();
            hinge.connectedBody = hull;
            hinge.axis = Vector3.up;
            hinge.anchor = new Vector3(0f, 0f, 0.5f);
            GameObject clone = Object.Instantiate(boat);
            HingeJoint copy = clone.GetComponentInChildren<HingeJoint>();
            Assert.That(copy.connectedBody, Is.SameAs(clone.transform.GetChild(0).GetComponent<Rigidbody>()));
            Assert.That(copy.axis, Is.EqualTo(Vector3.up));
            Assert.That(copy.anchor, Is.EqualTo(hinge.anchor));
            Assert.That(copy.connectedBody.mass, Is.EqualTo(70f));
            Assert.That(copy.connectedBody.GetComponent<BoxCollider>().size, Is.EqualTo(Vector3.one));
        }

        [Test]
        public void A_joint_brings_the_body_that_it_needs()
        {
            var thing = new GameObject("Thing");
            thing.AddComponent<HingeJoint>();
            Assert.That(thing.GetComponent<Rigidbody>(), Is.Not.Null);
        }

        static Rigidbody Box(Vector3 position)
        {
            var thing = new GameObject("Box");
            thing.transform.position = position;
            thing.AddComponent<BoxCollider>();
            return thing.AddComponent<Rigidbody>();
        }
    }
}
