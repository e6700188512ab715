using System;
using System.Collections;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;
using UnityEngine.TestTools.Constraints;
using Is = NUnit.Framework.Is;

namespace Rill.Tests
{
    /// <summary>Fluids that rest while no camera sees them.</summary>
    public class CullingTests : PlayedFluidFixture
    {
        static readonly Vector3 Box = new Vector3(1f, 0.6f, 0.5f);

        [UnityTest]
        public IEnumerator A_paused_fluid_stands_still_out_of_sight_and_goes_on_as_if_nothing_had_been()
        {
            Camera camera = Eye();
            FluidSimulation fluid = Dam(f => f.CullingMode = FluidCullingMode.Pause), always = Dam(), paused = Dam();
            yield return Frames(3);
            Assert.That(fluid.IsCulled, Is.False);
            ParticleState before = State(fluid);
            paused.Paused = true;
            camera.transform.rotation = Quaternion.Euler(0f, 180f, 0f);
            yield return Frames(4);
            Assert.That(fluid.IsCulled);
            Assert.That(fluid.StepCount, Is.EqualTo(3));
            TestFluid.AssertSame(State(fluid), before);
            Assert.That(always.StepCount, Is.EqualTo(7));
            Assert.That(always.IsCulled, Is.False);

            camera.transform.rotation = Quaternion.identity;
            paused.Paused = false;
            yield return Frames(4);
            Assert.That(fluid.StepCount, Is.EqualTo(7));
            TestFluid.AssertSame(State(fluid), State(paused));
        }

        [UnityTest]
        public IEnumerator A_slowed_fluid_takes_a_fraction_of_the_steps()
        {
            Eye().transform.rotation = Quaternion.Euler(0f, 180f, 0f);
            FluidSimulation fluid = Dam(f => (f.CullingMode, f.CulledRate) = (FluidCullingMode.Slow, 0.25f));
            yield return Frames(20);
            Assert.That(fluid.StepCount, Is.EqualTo(5));
        }

        public enum Blind { Looks, Disabled, FarOff, OtherLayer, Gone }

        [UnityTest]
        public IEnumerator A_camera_counts_that_is_enabled_near_enough_and_draws_the_layer([Values] Blind why)
        {
            Camera camera = Eye();
            FluidSimulation fluid = Dam(f => (f.CullingMode, f.CullingDistance) = (FluidCullingMode.Pause, 5f));
            switch (why)
            {
                case Blind.Disabled: camera.enabled = false; break;
                case Blind.FarOff: camera.transform.position = new Vector3(0f, 0f, -5.4f); break;       // 5.05 m from the bounds
                case Blind.OtherLayer: camera.cullingMask = ~(1 << fluid.gameObject.layer); break;
                case Blind.Gone: UnityEngine.Object.Destroy(camera.gameObject); break;
            }
            yield return Frames(3);
            bool sees = why == Blind.Looks;
            Assert.That(fluid.IsCulled, Is.EqualTo(!sees));
            Assert.That(fluid.StepCount, sees ? Is.EqualTo(3) : Is.LessThanOrEqualTo(1));       // one before the camera was gone
            fluid.CullingDistance = 0f;
            yield return Frames(2);
            Assert.That(fluid.IsCulled, Is.EqualTo(!sees && why != Blind.FarOff), "without a distance");
        }

        // Along each axis of the world lies each of the box's own, of which one is long.
        [UnityTest]
        public IEnumerator A_turned_box_is_seen_where_it_reaches_to_and_nowhere_else([Values(0, 1, 2)] int own, [Values(0, 1, 2)] int world)
        {
            Vector3 size = 0.4f * Vector3.one, along = Axis(world), across = Axis((world + 2) % 3), sight = Axis((world + 1) % 3);
            size[own] = 3f;
            FluidSimulation fluid = Fluid("Long", size, 0.1f, 100, Vector3.zero, made =>
            {
                made.CullingMode = FluidCullingMode.Pause;
                made.transform.rotation = Quaternion.FromToRotation(Axis(own), along);
            });
            Camera camera = Eye();
            camera.fieldOfView = 5f;
            foreach (float end in new[] { 1.4f, -1.4f })
            {
                camera.transform.SetPositionAndRotation(end * along - 3f * sight, Quaternion.LookRotation(sight, along));
                yield return null;
                Assert.That(fluid.IsCulled, Is.False, $"its end at {end} m");
                camera.transform.position = end * across - 3f * sight;
                yield return null;
                Assert.That(fluid.IsCulled, Is.True, $"beside it, at {end} m");
            }
        }

        static Vector3 Axis(int axis) => new Vector3(axis == 0 ? 1f : 0f, axis == 1 ? 1f : 0f, axis == 2 ? 1f : 0f);

        // What is drawn of particles at a wall reaches beyond it.
        [UnityTest]
        public IEnumerator Two_spacings_around_the_box_count_as_the_box()
        {
            FluidSimulation fluid = Dam(f => f.CullingMode = FluidCullingMode.Pause);
            Camera camera = Eye();
            camera.orthographic = true;
            camera.orthographicSize = 0.005f;
            camera.aspect = 1f;
            foreach ((float beyond, bool sees) in new[] { (0.09f, true), (0.11f, false) })
            {
                camera.transform.position = new Vector3(0.5f + beyond, 0f, -3f);
                yield return null;
                Assert.That(fluid.IsCulled, Is.EqualTo(!sees), $"{beyond} m beyond the wall");
                camera.transform.position = new Vector3(0f, -0.3f - beyond, -3f);
                yield return null;
                Assert.That(fluid.IsCulled, Is.EqualTo(!sees), $"{beyond} m below the floor");
            }
        }

        [UnityTest]
        public IEnumerator One_camera_of_many_that_sees_it_is_enough_wherever_it_is_among_them()
        {
            Camera first = Eye(), last = first;
            FluidSimulation fluid = Dam(f => f.CullingMode = FluidCullingMode.Pause);
            yield return Frames(2);
            Assert.That(fluid.IsCulled, Is.False);
            for (int i = 0; i < 6; i++)
            {
                last = Eye();
                last.transform.rotation = Quaternion.Euler(0f, 180f, 0f);
            }
            yield return Frames(2);
            Assert.That(fluid.IsCulled, Is.False, "the first of seven");
            first.transform.rotation = Quaternion.Euler(0f, 180f, 0f);
            yield return null;
            Assert.That(fluid.IsCulled, Is.True, "none");
            last.transform.rotation = Quaternion.identity;
            yield return null;
            Assert.That(fluid.IsCulled, Is.False, "the last");
        }

        [UnityTest]
        public IEnumerator A_slowed_fluid_that_is_paused_takes_no_step()
        {
            Eye().transform.rotation = Quaternion.Euler(0f, 180f, 0f);
            FluidSimulation fluid = Dam(f => (f.CullingMode, f.CulledRate, f.Paused) = (FluidCullingMode.Slow, 0.5f, true));
            yield return Frames(6);
            Assert.That((fluid.IsCulled, fluid.StepCount), Is.EqualTo((true, 0)));
        }

        [Test]
        public void Looking_for_cameras_allocates_nothing()
        {
            Eye();
            using (var scene = new SourceScene(Box, 0.05f, 1000))
            {
                scene.Fluid.CullingMode = FluidCullingMode.Pause;
                for (int i = 0; i < 5; i++)
                    scene.Step();
                TestDelegate frame = () => scene.Fluid.Advance(SourceScene.Step60);
                Assert.That(frame, Is.Not.AllocatingGCMemory());
            }
        }

        // Before the box, which it sees.
        Camera Eye()
        {
            var gameObject = new GameObject("Eye");
            made.Add(gameObject);
            gameObject.transform.position = new Vector3(0f, 0f, -3f);
            return gameObject.AddComponent<Camera>();
        }

        FluidSimulation Dam(Action<FluidSimulation> setUp = null) => Fluid("Dam", Box, 0.05f, 1000, new Vector3(0.5f, 0.4f, 0.5f), setUp);

        static ParticleState State(FluidSimulation fluid) => TestFluid.Read(fluid.Solver);
    }
}
