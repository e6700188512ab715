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
