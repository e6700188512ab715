using System.Collections;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>The fluid steps after what moves colliders, and is drawn after it has stepped.</summary>
    public class StepOrderTests
    {
        [UnityTest]
        public IEnumerator What_a_script_moves_in_LateUpdate_acts_where_it_is_in_that_frame()
        {
            using (var scene = new SourceScene(new Vector3(2f, 1f, 1f), 0.05f, 2000).Fill(0.2f))
            {
                var collider = new GameObject("Collider");
                collider.AddComponent<FluidCollider>();
                var mover = collider.AddComponent<LateMover>();
                int steps = scene.Fluid.StepCount, compared = 0;
                collider.AddComponent<LateWitness>().Look = () =>
                {
                    bool stepped = scene.Fluid.StepCount > steps;
                    steps = scene.Fluid.StepCount;
                    if (!stepped)
                        return;
                    float3 seen = scene.Fluid.DomainToWorld.MultiplyPoint3x4(scene.Fluid.Input.colliders.Items[0].seen.position);
                    Assert.That(math.distance(seen, mover.Position), Is.LessThan(1e-5f), $"frame {mover.Frames}");
                    compared++;
                };
                for (int frame = 0; frame < 60 && compared < 5; frame++)
                    yield return null;
                Assert.That(compared, Is.GreaterThanOrEqualTo(5), "frames with steps");
                Object.DestroyImmediate(collider);
            }
        }

        [Test]
        public void Renderers_draw_after_the_step()
        {
            foreach (System.Type type in new[] { typeof(ParticleRenderer), typeof(DomainRenderer) })
            {
                var order = (DefaultExecutionOrder)System.Attribute.GetCustomAttribute(type, typeof(DefaultExecutionOrder), true);
                Assert.That(order.order, Is.GreaterThan(FluidSimulation.ExecutionOrder), type.Name);
            }
        }
    }
}
