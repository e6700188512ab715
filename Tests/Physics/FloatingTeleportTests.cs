using System.Collections;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>A floating body in a scene that is shifted, as by a floating origin.</summary>
    public class FloatingTeleportTests
    {
        FloatingScene scene;

        [UnitySetUp]
        public IEnumerator OneStepAFrame() => PhysicsClock.Begin(FloatingScene.Frame);

        [UnityTearDown]
        public IEnumerator LeaveNothing()
        {
            scene?.Dispose();
            scene = null;
            Time.captureDeltaTime = 0f;
            yield return null;
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator A_body_floats_on_where_the_scene_is_shifted()
        {
            scene = new FloatingScene(ColliderShape.Box, new Vector3(0.4f, 0.3f, 0.4f), 0.5f, 0.45f, layers: 8, side: 16);
            yield return scene.Play(1.2f);
            float before = scene.Heights.Last();
            int count = scene.Speeds.Count;
            var shift = new Vector3(512f, 64f, -256f);
            scene.Fluid.transform.position += shift;
            scene.Body.transform.position += shift;
            scene.Fluid.Teleport();
            float submerged = scene.Buoyancy.SubmergedFraction;
            for (int frame = 0; frame < 18; frame++)
            {
                yield return scene.Play(FloatingScene.Frame);
                Assert.That(scene.Buoyancy.SubmergedFraction, Is.EqualTo(submerged).Within(0.1f), $"frame {frame}: it took the level along");
            }
            float fastest = scene.Speeds.Skip(count).Max(), fastestBefore = scene.Speeds.Skip(count - 20).Take(20).Max();
            Assert.That(fastest, Is.LessThan(fastestBefore + 0.1f), "a body that falls, or is lifted by all its water, is at 1 m/s by then");
            Assert.That(scene.Heights.Last() - shift.y, Is.EqualTo(before).Within(0.06f));
        }
    }
}
