using System;
using System.Collections;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>State of a fluid while it or its object is disabled.</summary>
    public class DisabledFluidTests : PlayedFluidFixture
    {
        static readonly Vector3 Box = new Vector3(1f, 0.6f, 0.5f);

        [UnityTest]
        public IEnumerator A_fluid_that_is_enabled_again_goes_on_as_if_it_had_never_stopped([Values(false, true)] bool byObject)
        {
            FluidSimulation fluid = Dam(AddPost), always = Dam(AddPost);
            yield return Frames(5);
            ParticleState before = State(fluid);
            double time = fluid.FluidTime;
            Switch(fluid, byObject, false);
            Assert.That(fluid.IsRunning, Is.False);
            Assert.That(fluid.HasKeptState);
            always.Paused = true;
            yield return Frames(7);
            Switch(fluid, byObject, true);
            always.Paused = false;
            Assert.That(fluid.IsRunning);
            Assert.That(fluid.HasKeptState, Is.False);
            Assert.That(fluid.StepCount, Is.EqualTo(5));
            Assert.That(fluid.FluidTime, Is.EqualTo(time));
            TestFluid.AssertSame(State(fluid), before);
            yield return Frames(6);
            Assert.That(fluid.StepCount, Is.EqualTo(11));
            TestFluid.AssertSame(State(fluid), State(always));
        }

        [UnityTest]
        public IEnumerator A_box_that_is_put_elsewhere_while_disabled_takes_its_water_along_without_a_push()
        {
            FluidSimulation fluid = Dam(), always = Dam();
            yield return Frames(5);
            fluid.gameObject.SetActive(false);
            always.Paused = true;
            yield return Frames(2);
            fluid.transform.position = new Vector3(40f, 3f, -7f);
            fluid.gameObject.SetActive(true);
            always.Paused = false;
            yield return Frames(3);
            TestFluid.AssertSame(State(fluid), State(always));
        }

        [UnityTest]
        public IEnumerator Told_to_drop_its_water_it_gives_its_memory_back_and_begins_again()
        {
            FluidSimulation fluid = Dam(f => f.KeepStateOnDisable = false);
            yield return Frames(5);
            GraphicsBuffer positions = fluid.Solver.Positions;
            fluid.enabled = false;
            Assert.That(fluid.HasKeptState, Is.False);
            Assert.That(positions.IsValid(), Is.False);
            fluid.enabled = true;
            Assert.That(fluid.StepCount, Is.Zero);
        }

        public enum Release { Setting, Restart, Destroy }

        [UnityTest]
        public IEnumerator What_a_disabled_fluid_keeps_goes_when_it_is_told_restarted_or_destroyed([Values] Release why)
        {
            FluidSimulation fluid = Dam();
            yield return Frames(3);
            GraphicsBuffer positions = fluid.Solver.Positions;
            fluid.gameObject.SetActive(false);
            Assert.That(positions.IsValid());
            switch (why)
            {
                case Release.Setting: fluid.KeepStateOnDisable = false; break;
                case Release.Restart: fluid.Restart(); break;
                case Release.Destroy: Object.DestroyImmediate(fluid.gameObject); break;
            }
            Assert.That(positions.IsValid(), Is.False);
            if (why == Release.Destroy)
                yield break;
            fluid.gameObject.SetActive(true);
            yield return Frames(2);
            Assert.That(fluid.StepCount, Is.EqualTo(2));
            Assert.That(State(fluid).Count, Is.EqualTo(800));
        }

        [UnityTest]
        public IEnumerator A_fluid_whose_capacity_changed_while_disabled_begins_again()
        {
            FluidSimulation fluid = Dam();
            yield return Frames(3);
            GraphicsBuffer positions = fluid.Solver.Positions;
            fluid.enabled = false;
            fluid.Capacity = 900;
            fluid.enabled = true;
            Assert.That(positions.IsValid(), Is.False);
            yield return Frames(2);
            Assert.That(fluid.StepCount, Is.EqualTo(2));
            Assert.That(fluid.Solver.Layout.Capacity, Is.EqualTo(900));
        }

        static void Switch(FluidSimulation fluid, bool byObject, bool on)
        {
            if (byObject)
                fluid.gameObject.SetActive(on);
            else
                fluid.enabled = on;
        }

        // Adds a post that blocks the water; its force is measured.
        static void AddPost(FluidSimulation fluid)
        {
            var post = new GameObject("Post");
            post.transform.SetParent(fluid.transform, false);
            post.transform.localPosition = new Vector3(0.2f, -0.2f, 0f);
            var collider = post.AddComponent<FluidCollider>();
            collider.Size = new Vector3(0.1f, 0.3f, 0.2f);
            collider.MeasuresForce = true;
        }

        FluidSimulation Dam(Action<FluidSimulation> setUp = null) => Fluid("Dam", Box, 0.05f, 1000, new Vector3(0.5f, 0.4f, 0.5f), setUp);

        static ParticleState State(FluidSimulation fluid) => TestFluid.Read(fluid.Solver);
    }
}
