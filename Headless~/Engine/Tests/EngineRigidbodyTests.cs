using System.Collections;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Headless;

namespace Host.Tests
{
    /// <summary>Free bodies: integrated after FixedUpdate as Unity's physics does, and colliding with nothing.</summary>
    public class EngineRigidbodyTests : EngineFixture
    {
        const float Step = 0.02f;

        [Test]
        public void A_body_falls_by_gravity_one_step_after_the_other()
        {
            Rigidbody body = Body();
            for (int i = 1; i <= 10; i++)
            {
                PlayerLoop.Frame(Step);
                Assert.That(body.velocity.y, Is.EqualTo(-9.81f * Step * i).Within(1e-4f));
            }
            Assert.That(body.transform.position.y, Is.EqualTo(-9.81f * Step * Step * 55f).Within(1e-4f), "velocity first, then place");
        }

        [Test]
        public void What_acts_does_so_by_mass_and_tensor_as_its_mode_says()
        {
            Rigidbody body = Body();
            body.useGravity = false;
            body.angularDrag = 0f;
            body.mass = 4f;
            body.inertiaTensor = new Vector3(1f, 2f, 4f);
            body.AddForce(new Vector3(8f, 0f, 0f));
            body.AddForce(new Vector3(0f, 2f, 0f), ForceMode.Acceleration);
            body.AddForce(new Vector3(0f, 0f, 8f), ForceMode.Impulse);
            body.AddForce(new Vector3(0f, 0f, 1f), ForceMode.VelocityChange);
            body.AddTorque(new Vector3(3f, 0f, 0f));
            body.AddTorque(new Vector3(0f, 5f, 0f), ForceMode.Acceleration);
            body.AddTorque(new Vector3(0f, 0f, 2f), ForceMode.Impulse);
            PlayerLoop.Frame(Step);
            Assert.That((body.velocity - new Vector3(2f * Step, 2f * Step, 3f)).magnitude, Is.LessThan(1e-5f));
            Assert.That((body.angularVelocity - new Vector3(3f * Step, 5f * Step, 0.5f)).magnitude, Is.LessThan(1e-5f));
            PlayerLoop.Frame(Step);
            Assert.That(body.velocity.x, Is.EqualTo(2f * Step).Within(1e-6f), "a force acts once");
        }

        [Test]
        public void A_force_beside_the_center_of_mass_turns_the_body_about_it()
        {
            Rigidbody body = Body();
            body.useGravity = false;
            body.inertiaTensor = Vector3.one * 0.1f;
            body.centerOfMass = new Vector3(0.5f, 0f, 0f);
            body.AddForceAtPosition(new Vector3(0f, 0f, 1f), Vector3.zero);
            Vector3 center = body.worldCenterOfMass;
            PlayerLoop.Frame(Step);
            Assert.That(body.angularVelocity.y, Is.GreaterThan(0f));
            Assert.That((body.worldCenterOfMass - center - body.velocity * Step).magnitude, Is.LessThan(1e-5f));
        }

        [Test]
        public void Drag_constraints_and_limits_hold()
        {
            Rigidbody body = Body();
            body.drag = 10f;
            body.constraints = RigidbodyConstraints.FreezePositionX | RigidbodyConstraints.FreezeRotation;
            body.velocity = new Vector3(1f, 0f, 1f);
            body.useGravity = false;
            body.AddTorque(Vector3.one * 100f);
            PlayerLoop.Frame(Step);
            Assert.That((body.velocity - new Vector3(0f, 0f, 0.8f)).magnitude, Is.LessThan(1e-5f));
            Assert.That(body.angularVelocity, Is.EqualTo(Vector3.zero));
            body.constraints = RigidbodyConstraints.None;
            body.AddTorque(Vector3.one * 1e6f);
            PlayerLoop.Frame(Step);
            Assert.That(body.angularVelocity.magnitude, Is.EqualTo(7f).Within(1e-4f));
        }

        [Test]
        public void A_kinematic_body_goes_where_it_is_told_and_nowhere_else()
        {
            Rigidbody body = Body();
            body.isKinematic = true;
            body.AddForce(Vector3.one * 100f);
            body.MovePosition(new Vector3(1f, 0f, 0f));
            PlayerLoop.Frame(Step);
            Assert.That(body.transform.position, Is.EqualTo(new Vector3(1f, 0f, 0f)));
            Assert.That(body.velocity.x, Is.EqualTo(1f / Step).Within(0.01f));
        }

        [Test]
        public void An_interpolated_object_is_between_the_last_two_steps_and_its_scripts_find_it_at_the_last()
        {
            Rigidbody body = Body();
            body.interpolation = RigidbodyInterpolation.Interpolate;
            body.useGravity = false;
            body.velocity = new Vector3(1f, 0f, 0f);
            PlayerLoop.Frame(1.5f * Step);
            Assert.That(body.transform.position.x, Is.EqualTo(0.5f * Step).Within(1e-6f));
            Assert.That(body.position.x, Is.EqualTo(Step).Within(1e-6f));
            PlayerLoop.Frame(0.25f * Step);
            Assert.That(body.transform.position.x, Is.EqualTo(0.75f * Step).Within(1e-6f));
            body.transform.position = new Vector3(5f, 0f, 0f);
            PlayerLoop.Frame(Step);
            Assert.That(body.position.x, Is.EqualTo(5f + Step).Within(1e-5f), "a script that moves the object moves the body");
        }

        static Rigidbody Body() => new GameObject("Body").AddComponent<Rigidbody>();
    }
}
