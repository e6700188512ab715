using System;
using System.Collections;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>A box that is put elsewhere with its water, alone or with the whole scene, as by a floating origin.</summary>
    public class TeleportTests : PlayedFluidFixture
    {
        const float Spacing = 0.05f;

        static readonly Vector3 Box = new Vector3(1.2f, 0.8f, 0.6f);

        // Whole numbers, so that what rounding changes is small.
        static readonly Vector3 Shift = new Vector3(512f, 64f, -256f);

        Transform root;
        FluidSimulation fluid;

        void Basin(Action<FluidSimulation> setUp = null)
        {
            root = new GameObject("Root").transform;
            made.Add(root.gameObject);
            fluid = Fluid("Basin", Box, Spacing, 6000, new Vector3(Box.x, 0.4f, Box.z), f =>
            {
                f.transform.SetParent(root, true);
                setUp?.Invoke(f);
            });
        }

        [UnityTest]
        public IEnumerator A_floating_origin_costs_nothing_but_the_shift([Values] bool tells)
        {
            Basin();
            FluidCollider paddle = Collider(new Vector3(-0.3f, -0.1f, 0f));
            var emitter = new GameObject("Emitter");
            emitter.transform.SetParent(root, true);
            emitter.transform.position = new Vector3(0.3f, 0.3f, 0f);
            emitter.transform.rotation = Quaternion.LookRotation(Vector3.down, Vector3.forward);
            var tap = emitter.AddComponent<FluidEmitter>();
            (tap.Simulation, tap.Rate, tap.Speed) = (fluid, 0.002f, 0.5f);
            FluidSimulation moved = fluid;
            // All of it drives along at 5 m/s, as on a ship, and the paddle turns.
            for (int frame = 0; frame < 24; frame++)
            {
                if (frame == 18)
                {
                    root.position += Shift;
                    if (tells)
                        moved.Teleport();
                }
                root.position += new Vector3(5f * Time.deltaTime, 0f, 0f);
                paddle.transform.localRotation *= Quaternion.Euler(0f, 3f, 0f);
                yield return null;
                float fastest = Fastest(moved);
                if (frame == 18 && !tells)
                {
                    Assert.That(fastest, Is.GreaterThan(20f), "else this test tells nothing");
                    yield break;
                }
                Assert.That(fastest, Is.LessThan(3f), $"frame {frame}");
            }
        }

        [UnityTest]
        public IEnumerator A_moving_collider_goes_on_through_the_water_in_the_frame_of_the_shift()
        {
            Basin();
            FluidCollider paddle = Collider(new Vector3(-0.3f, -0.1f, 0f));
            for (int frame = 0; frame < 8; frame++)
            {
                if (frame == 7)
                {
                    root.position += Shift;
                    fluid.Teleport();
                }
                paddle.transform.localPosition += new Vector3(0.01f, 0f, 0f);
                yield return null;
            }
            ColliderMotion motion = fluid.Input.colliders.Items[0];
            Assert.That(math.distance(motion.start.position, motion.end.position) * Spacing, Is.EqualTo(0.01f).Within(0.002f));
        }

        [UnityTest]
        public IEnumerator What_stayed_in_the_world_has_not_moved_through_the_water_of_a_box_that_was_put_elsewhere([Values] bool turns)
        {
            Basin();
            FluidCollider rock = Collider(new Vector3(-0.3f, -0.2f, 0f));
            rock.transform.SetParent(null, true);
            made.Add(rock.gameObject);
            var drain = new GameObject("Drain");
            made.Add(drain);
            drain.transform.position = new Vector3(0.4f, -0.3f, 0f);
            var outlet = drain.AddComponent<FluidDrain>();
            (outlet.Simulation, outlet.Size) = (fluid, Vector3.one * 0.1f);
            yield return Frames(20);
            int drained = (int)fluid.Results.Measurements.MeasureNow().drained;
            // The rock and the drain are at other places in the box then.
            fluid.transform.position += new Vector3(turns ? 0f : 0.45f, 0f, 0f);
            fluid.transform.rotation = Quaternion.Euler(0f, turns ? 180f : 0f, 0f);
            fluid.Teleport();
            float fastest = 0f;
            for (int frame = 0; frame < 4; frame++)
            {
                yield return null;
                fastest = math.max(fastest, Fastest(fluid));
            }
            Assert.That(fastest, Is.LessThan(8f), "pushed out of the rock; 0.4 m in a step are 24 m/s");
            Assert.That(fluid.Results.Measurements.MeasureNow().drained - drained, Is.LessThan(60), "a drain that sweeps 0.45 m takes over 70");
        }

        [UnityTest]
        public IEnumerator What_was_measured_before_is_where_it_is_now()
        {
            FluidProbe probe = null;
            FluidDetector detector = null;
            Basin(f =>
            {
                probe = Child<FluidProbe>(f, new Vector3(0.1f, -0.2f, 0f));
                detector = Child<FluidDetector>(f, new Vector3(0f, -0.2f, 0f));
            });
            using (var batch = new FluidQueryBatch(fluid, 1, 1))
            {
                batch.SetPoints(new[] { new Vector3(0.1f, -0.2f, 0.1f) }, 0, 1);
                batch.SetRays(new[] { new FluidRay(new Vector3(0f, 0.3f, 0f), Vector3.down) }, 0, 1);
                yield return Frames(20);
                Assert.That(probe.Latest.height, Is.EqualTo(0f).Within(0.06f));
                root.position += Shift;
                fluid.Teleport();
                batch.SetPoints(new[] { new Vector3(0.1f, -0.2f, 0.1f) + Shift }, 0, 1);
                batch.SetRays(new[] { new FluidRay(new Vector3(0f, 0.3f, 0f) + Shift, Vector3.down) }, 0, 1);
                for (int frame = 0; frame < 5; frame++)     // the same frame, results that were pending, and new ones
                {
                    Assert.That(probe.Latest.height, Is.EqualTo(Shift.y).Within(0.06f), $"frame {frame}");
                    Assert.That(probe.Latest.surfacePoint.x, Is.EqualTo(0.1f + Shift.x).Within(1e-3f));
                    Assert.That(Vector3.Distance(probe.Latest.position, probe.transform.position), Is.LessThan(1e-3f));
                    Assert.That(Vector3.Distance(detector.Latest.position, detector.transform.position), Is.LessThan(1e-3f));
                    Assert.That(batch.TryGetSample(0, out FluidProbeSample sample));
                    Assert.That(sample.height, Is.EqualTo(Shift.y).Within(0.06f));
                    Assert.That(batch.TryGetHit(0, out FluidRayHit hit) && hit.hit);
                    Assert.That(Vector3.Distance(hit.point, Shift), Is.LessThan(0.06f));
                    yield return null;
                }
            }
        }

        FluidCollider Collider(Vector3 position)
        {
            var gameObject = new GameObject("Plate");
            gameObject.SetActive(false);
            gameObject.transform.SetParent(root, false);
            gameObject.transform.localPosition = position;
            var collider = gameObject.AddComponent<FluidCollider>();
            (collider.Shape, collider.Size) = (ColliderShape.Box, new Vector3(0.1f, 0.2f, 0.2f));
            gameObject.SetActive(true);
            return collider;
        }

        static T Child<T>(FluidSimulation fluid, Vector3 position) where T : Component
        {
            var child = new GameObject(typeof(T).Name);
            child.transform.SetParent(fluid.transform, false);
            child.transform.localPosition = position;
            return child.AddComponent<T>();
        }

        static float Fastest(FluidSimulation fluid) => fluid.Results.Measurements.MeasureNow().speedMax;
    }
}
