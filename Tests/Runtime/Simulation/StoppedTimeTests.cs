using System;
using System.Collections;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Objects that move or turn while a fluid's time stands, whatever stops it, have not moved through the water; and queries are
    /// answered.</summary>
    public class StoppedTimeTests : PlayedFluidFixture
    {
        const float Spacing = 0.05f;

        static readonly Vector3 Box = new Vector3(1.2f, 0.8f, 0.6f);

        public enum Stop { TimeScale, Paused, Culled, Disabled, Inactive }

        public enum Moved { Ball, TurnedPlate, Box, TurnedBox, Emitter, Drain, Nothing }

        [TearDown]
        public void LetTimeGoOn() => Time.timeScale = 1f;

        // A collider that has come into the water pushes it out, however time stood: that is the measure.
        [UnityTest, Category("LongRun")]
        public IEnumerator What_moves_while_time_stands_pushes_the_water_no_more_than_under_Paused(
            [Values(Stop.TimeScale, Stop.Culled, Stop.Disabled, Stop.Inactive)] Stop stop, [Values] Moved moved)
        {
            float paused = 0f, fastest = 0f;
            yield return MoveWhileItStands(Stop.Paused, moved, speed => paused = speed);
            yield return MoveWhileItStands(stop, moved, speed => fastest = speed);
            Assert.That(fastest, Is.LessThan(1.5f * paused));
            Assert.That(paused, Is.LessThan(8f), "a path of 0.5 m in a step is 30 m/s");
        }

        IEnumerator MoveWhileItStands(Stop stop, Moved moved, Action<float> done)
        {
            Camera camera = Eye();
            Transform mover = null;
            FluidSimulation fluid = Fluid("Basin", Box, Spacing, 6000, new Vector3(Box.x, 0.4f, Box.z), f =>
            {
                f.CullingMode = stop == Stop.Culled ? FluidCullingMode.Pause : FluidCullingMode.AlwaysSimulate;
                mover = Make(f, moved);
            });
            yield return Frames(20);
            float fastest = 0f;
            for (int i = 0; i < 2; i++)     // to and fro
            {
                Set(fluid, camera, stop, stands: true);
                yield return Frames(2);
                int steps = fluid.StepCount;
                for (int frame = 0; frame < 3; frame++)
                {
                    Move(fluid, mover, moved, i % 2 == 0 ? 1f : -1f);
                    yield return null;
                }
                Assert.That(fluid.StepCount, Is.EqualTo(steps));
                Set(fluid, camera, stop, stands: false);
                for (int frame = 0; frame < 6; frame++)
                {
                    yield return null;
                    if (fluid.StepCount > steps)
                        fastest = math.max(fastest, Fastest(fluid));
                }
                Assert.That(fluid.StepCount, Is.GreaterThan(steps + 3));
            }
            UnityEngine.Object.DestroyImmediate(fluid.gameObject);
            UnityEngine.Object.DestroyImmediate(camera.gameObject);
            if (mover != null)
                UnityEngine.Object.DestroyImmediate(mover.gameObject);
            done(fastest);
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator What_moves_in_the_frame_in_which_time_goes_on_does_not_push_the_water([Values(Stop.TimeScale, Stop.Paused)] Stop stop,
            [Values(Moved.Ball, Moved.Box)] Moved moved)
        {
            Camera camera = Eye();
            Transform mover = null;
            FluidSimulation fluid = Fluid("Basin", Box, Spacing, 6000, new Vector3(Box.x, 0.4f, Box.z), f => mover = Make(f, moved));
            yield return Frames(20);
            Set(fluid, camera, stop, stands: true);
            yield return Frames(2);
            Move(fluid, mover, moved, 3f);
            Set(fluid, camera, stop, stands: false);
            float fastest = 0f;
            for (int frame = 0; frame < 6; frame++)
            {
                yield return null;
                fastest = math.max(fastest, Fastest(fluid));
            }
            Assert.That(fastest, Is.LessThan(moved == Moved.Box ? 0.5f : 8f));
        }

        // Out of sight, at a quarter of its steps: what moves between two of them has not moved through the water at four times its speed.
        [UnityTest]
        public IEnumerator What_moves_while_a_fluid_is_slowed_does_not_throw_its_water([Values(Moved.Ball, Moved.Box)] Moved moved)
        {
            Camera camera = Eye();
            Transform mover = null;
            FluidSimulation fluid = Fluid("Basin", Box, Spacing, 6000, new Vector3(Box.x, 0.4f, Box.z), f =>
            {
                (f.CullingMode, f.CulledRate) = (FluidCullingMode.Slow, 0.25f);
                mover = Make(f, moved);
            });
            yield return Frames(20);
            Set(fluid, camera, Stop.Culled, stands: true);
            yield return Frames(4);
            int steps = fluid.StepCount;
            float fastest = 0f;
            for (int frame = 0; frame < 16; frame++)
            {
                Move(fluid, mover, moved, frame / 4 % 2 == 0 ? 0.4f : -0.4f);
                yield return null;
                fastest = math.max(fastest, Fastest(fluid));
            }
            TestContext.Out.WriteLine($"{fastest} m/s");
            Assert.That(fluid.StepCount - steps, Is.EqualTo(4));
            Assert.That(fastest, Is.LessThan(moved == Moved.Box ? 0.5f : 4f));
        }

        [UnityTest]
        public IEnumerator A_box_that_drives_on_after_a_stop_does_not_shake_its_water([Values(Stop.TimeScale, Stop.Paused, Stop.Inactive)] Stop stop)
        {
            const float speed = 10f;
            Camera camera = Eye();
            FluidSimulation fluid = Fluid("Tank", Box, Spacing, 6000, new Vector3(Box.x, 0.4f, Box.z));
            IEnumerator Drive(int frames)
            {
                for (int frame = 0; frame < frames; frame++)
                {
                    yield return null;
                    fluid.transform.position += new Vector3(speed * Time.deltaTime, 0f, 0f);
                }
            }
            yield return Drive(20);      // from the first frame on: it does not start from rest either
            Assert.That(Fastest(fluid), Is.LessThan(0.5f), "at the start");
            Set(fluid, camera, stop, stands: true);
            yield return Drive(4);
            Set(fluid, camera, stop, stands: false);
            yield return Drive(6);
            Assert.That(Fastest(fluid), Is.LessThan(0.5f), "after the stop");
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator Probes_points_and_rays_are_answered_while_time_stands([Values(Stop.TimeScale, Stop.Paused, Stop.Culled)] Stop stop,
            [Values] bool measures)
        {
            Camera camera = Eye();
            FluidProbe probe = null;
            FluidDetector detector = null;
            FluidSimulation fluid = Fluid("Basin", Box, Spacing, 6000, new Vector3(Box.x, 0.4f, Box.z), f =>
            {
                f.CullingMode = stop == Stop.Culled ? FluidCullingMode.Pause : FluidCullingMode.AlwaysSimulate;
                f.StatisticsInterval = measures ? 1 : 0;        // which sorts again
                probe = Child<FluidProbe>(f, new Vector3(-0.3f, 0.3f, 0f));
                detector = Child<FluidDetector>(f, new Vector3(0f, 0.2f, 0f));
                detector.Size = Vector3.one * 0.2f;
            });
            using (var batch = new FluidQueryBatch(fluid, 1, 1) { Repeats = false })
            {
                yield return Frames(30);
                Set(fluid, camera, stop, stands: true);
                yield return Frames(5);
                int steps = fluid.StepCount;
                Assert.That(probe.Latest.density, Is.Zero, "in the air");
                Assert.That(detector.Latest.fill, Is.Zero);

                probe.transform.localPosition = new Vector3(0.2f, -0.3f, 0f);
                detector.transform.localPosition = new Vector3(0f, -0.2f, 0f);
                batch.SetPoints(new[] { new Vector3(0.1f, -0.2f, 0.1f) }, 0, 1);
                batch.SetRays(new[] { new FluidRay(new Vector3(0f, 0.3f, 0f), Vector3.down) }, 0, 1);
                Assert.That(batch.IsPending);
                yield return Frames(4);
                Assert.That(fluid.StepCount, Is.EqualTo(steps));
                Assert.That(probe.Latest.density, Is.EqualTo(1f).Within(0.1f));
                Assert.That(probe.Latest.depth, Is.EqualTo(0.3f).Within(0.06f));
                Assert.That(detector.Latest.fill, Is.EqualTo(1f).Within(0.05f));
                Assert.That(batch.IsPending, Is.False);
                Assert.That(batch.TryGetSample(0, out FluidProbeSample sample));
                Assert.That(sample.density, Is.EqualTo(1f).Within(0.1f));
                Assert.That(batch.TryGetHit(0, out FluidRayHit hit) && hit.hit);
                Assert.That(hit.point.y, Is.EqualTo(0f).Within(0.06f));

                // Changes by scripts while time stands are visible, too.
                fluid.RemoveInside(FluidShape.Box(new Vector3(0f, -0.2f, 0f), Box));
                yield return Frames(4);
                Assert.That(probe.Latest.density, Is.Zero);
                Assert.That(probe.Latest.hasSurface, Is.False);
                Assert.That(detector.Latest.fill, Is.Zero);
                fluid.Fill(FluidShape.Box(new Vector3(0f, -0.2f, 0f), new Vector3(Box.x, 0.4f, Box.z)));
                yield return Frames(4);
                Assert.That(probe.Latest.density, Is.EqualTo(1f).Within(0.1f));
                Assert.That(detector.Latest.fill, Is.EqualTo(1f).Within(0.05f));
                Assert.That(fluid.StepCount, Is.EqualTo(steps));
            }
        }

        [UnityTest]
        public IEnumerator A_box_put_elsewhere_while_time_stands_is_asked_where_its_water_is()
        {
            FluidProbe probe = null;
            FluidSimulation fluid = Fluid("Basin", Box, Spacing, 6000, new Vector3(Box.x, 0.4f, Box.z),
                f => probe = Child<FluidProbe>(f, new Vector3(0f, 0.1f, 0f)));
            yield return Frames(10);
            fluid.Paused = true;
            yield return Frames(4);
            Assert.That(probe.Latest.density, Is.Zero);
            fluid.Recenter(new Vector3(0f, -0.3f, 0f));     // the probe goes along, to 0.2 m below the surface
            yield return Frames(4);
            Assert.That(probe.Latest.density, Is.EqualTo(1f).Within(0.1f));
            Assert.That(probe.Latest.depth, Is.EqualTo(0.2f).Within(0.06f));
        }

        [UnityTest]
        public IEnumerator Probes_are_answered_before_the_first_step()
        {
            FluidProbe probe = null;
            FluidSimulation fluid = Fluid("Basin", Box, Spacing, 6000, new Vector3(Box.x, 0.4f, Box.z), f =>
            {
                f.Paused = true;
                probe = Child<FluidProbe>(f, new Vector3(0f, -0.2f, 0f));
            });
            yield return Frames(4);
            Assert.That(fluid.StepCount, Is.Zero);
            Assert.That(probe.Latest.density, Is.EqualTo(1f).Within(0.1f));
        }

        [UnityTest]
        public IEnumerator Probes_are_answered_while_time_crawls()
        {
            FluidProbe probe = null;
            FluidSimulation fluid = Fluid("Basin", Box, Spacing, 6000, new Vector3(Box.x, 0.4f, Box.z),
                f => probe = Child<FluidProbe>(f, new Vector3(0f, 0.3f, 0f)));
            yield return Frames(10);
            Time.timeScale = 0.001f;
            yield return Frames(3);
            int steps = fluid.StepCount;
            probe.transform.localPosition = new Vector3(0f, -0.2f, 0f);
            yield return Frames(6);
            Assert.That(fluid.StepCount, Is.EqualTo(steps));
            Assert.That(probe.Latest.density, Is.EqualTo(1f).Within(0.1f));
        }

        Camera Eye()
        {
            var eye = new GameObject("Eye", typeof(Camera));
            made.Add(eye);
            eye.transform.position = new Vector3(0f, 0f, -3f);
            return eye.GetComponent<Camera>();
        }

        static void Set(FluidSimulation fluid, Camera camera, Stop stop, bool stands)
        {
            switch (stop)
            {
                case Stop.TimeScale: Time.timeScale = stands ? 0f : 1f; break;
                case Stop.Paused: fluid.Paused = stands; break;
                case Stop.Culled: camera.transform.rotation = Quaternion.Euler(0f, stands ? 180f : 0f, 0f); break;
                case Stop.Disabled: fluid.enabled = !stands; break;
                case Stop.Inactive: fluid.gameObject.SetActive(!stands); break;
            }
        }

        Transform Make(FluidSimulation fluid, Moved moved)
        {
            switch (moved)
            {
                case Moved.Ball: return Collider(new Vector3(-0.25f, -0.1f, 0f), c => (c.Shape, c.Radius) = (ColliderShape.Sphere, 0.1f));
                case Moved.TurnedPlate:
                    return Collider(new Vector3(0f, -0.1f, 0f), c => (c.Shape, c.Size) = (ColliderShape.Box, new Vector3(0.8f, 0.3f, 0.1f)));
                case Moved.Emitter:
                    return Child<FluidEmitter>(fluid, new Vector3(-0.25f, 0.2f, 0f), e => (e.Rate, e.Speed) = (0.002f, 0.5f)).transform;
                case Moved.Drain:
                    return Child<FluidDrain>(fluid, new Vector3(-0.25f, -0.3f, 0f), d => d.Size = Vector3.one * 0.1f).transform;
                default: return fluid.transform;
            }
        }

        static void Move(FluidSimulation fluid, Transform mover, Moved moved, float sign)
        {
            switch (moved)
            {
                case Moved.Ball:
                case Moved.Emitter:
                case Moved.Drain: mover.position += new Vector3(sign * 0.17f, 0f, 0f); break;
                case Moved.TurnedPlate: mover.rotation *= Quaternion.Euler(0f, sign * 30f, 0f); break;
                case Moved.Box: fluid.transform.position += new Vector3(sign * 0.5f, 0f, sign * 2f); break;
                case Moved.TurnedBox: fluid.transform.rotation *= Quaternion.Euler(0f, sign * 40f, 0f); break;
            }
        }

        Transform Collider(Vector3 position, Action<FluidCollider> set)
        {
            var gameObject = new GameObject("Collider");
            made.Add(gameObject);
            gameObject.SetActive(false);
            gameObject.transform.position = position;
            set(gameObject.AddComponent<FluidCollider>());
            gameObject.SetActive(true);
            return gameObject.transform;
        }

        static T Child<T>(FluidSimulation fluid, Vector3 position, Action<T> set = null) where T : Component
        {
            var child = new GameObject(typeof(T).Name);
            child.SetActive(false);
            child.transform.SetParent(fluid.transform, false);
            child.transform.localPosition = position;
            child.transform.localRotation = Quaternion.LookRotation(Vector3.down, Vector3.forward);
            T component = child.AddComponent<T>();
            set?.Invoke(component);
            child.SetActive(true);
            return component;
        }

        static float Fastest(FluidSimulation fluid) => fluid.Results.Measurements.MeasureNow().speedMax;
    }
}
