using System.Linq;
using NUnit.Framework;
using Rill;
using UnityEngine;
using UnityEngine.Headless;

namespace Host.Tests
{
    /// <summary>Bodies of a scene file, and what the sample's water does to them.</summary>
    public class FloatingSceneTests : GraphicsFixture
    {
        [Test]
        public void The_floating_bodies_of_the_sample_are_as_its_file_says_and_learn_what_the_water_does()
        {
            using (new SampleScene("Floating Bodies"))
            {
                Rigidbody ball = PhysicsWorld.Bodies.Single(body => body.name == "Ball");
                Assert.That(PhysicsWorld.Bodies.Count, Is.EqualTo(4));
                Assert.That(ball.mass, Is.EqualTo(0.1f * 1000f * Mathf.PI / 6f * 0.4f * 0.4f * 0.4f).Within(1e-3f));
                Assert.That(ball.inertiaTensor.x, Is.EqualTo(0.1f * ball.mass * 0.4f * 0.4f).Within(1e-4f));
                Assert.That(ball.interpolation, Is.EqualTo(RigidbodyInterpolation.Interpolate));
                for (int i = 0; i < 6; i++)
                    PlayerLoop.Frame(1f / 60f);
                Assert.That(ball.GetComponent<FluidCollider>().TryGetForce(out _, out _), Is.True);
                Assert.That(ball.velocity.y, Is.LessThan(-0.5f));
            }
        }
    }
}
