using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>A box that follows a target.</summary>
    public class FluidFollowTests : PlayedFluidFixture
    {
        const float Spacing = 0.1f;

        static readonly Vector3 Box = new Vector3(1f, 1f, 0.6f);

        [UnityTest]
        public IEnumerator The_box_follows_along_the_free_axes_once_the_target_is_far_enough()
        {
            (FluidSimulation fluid, FluidFollow follow, Transform target) = Make(f => f.LockZ = true);
            yield return Frames(2);
            target.position = new Vector3(0.39f, 3f, 2f);
            yield return null;
            Assert.That(fluid.transform.position, Is.EqualTo(Vector3.zero), "nearer than four spacings along x");
            target.position = new Vector3(0.45f, 3f, 2f);
            yield return null;
            Assert.That(fluid.transform.position, Is.EqualTo(new Vector3(0.45f, 0f, 0f)));
            follow.LockY = false;
            yield return null;
            Assert.That(fluid.transform.position, Is.EqualTo(new Vector3(0.45f, 3f, 0f)));
        }

        [UnityTest]
        public IEnumerator What_is_left_behind_becomes_what_was_asked([Values] LeavingParticles leaving, [Values] bool handsOver)
        {
            FluidSimulation lake = null;
            if (handsOver)
            {
                lake = Fluid("Lake", 3f * Vector3.one, Spacing, 2000, Vector3.zero, Quiet);
                lake.transform.position = new Vector3(-1.5f, 0f, 0f);       // up to the center of the box
            }
            (FluidSimulation fluid, FluidFollow follow, Transform target) = Make(f => f.Leaving = leaving);
            follow.HandOverTo = lake;
            yield return Frames(3);
            int all = Count(fluid);
            target.position = 1.5f * Vector3.right;
            yield return Frames(4);
            UnityEngine.Rendering.AsyncGPUReadback.WaitAllRequests();
            yield return Frames(2);
            UnityEngine.Rendering.AsyncGPUReadback.WaitAllRequests();
            int over = handsOver ? Count(lake) : 0;
            Assert.That(Count(fluid), Is.Zero);
            Assert.That(over, handsOver ? Is.EqualTo(all / 2).Within(all / 8) : Is.Zero);
            Assert.That(fluid.KeptParticleCount, Is.EqualTo(leaving == LeavingParticles.Keep ? all - over : 0));
        }

        [UnityTest]
        public IEnumerator A_volume_below_the_box_fills_what_is_new_after_each_move()
        {
            (FluidSimulation fluid, FluidFollow follow, Transform target) = Make();
            follow.Refill = fluid.GetComponentInChildren<FluidVolume>();
            yield return Frames(2);
            int all = Count(fluid);
            for (int move = 1; move <= 3; move++)
            {
                target.position += 0.5f * Vector3.right;
                yield return null;
                Assert.That(fluid.transform.position.x, Is.EqualTo(0.5f * move).Within(1e-5f));
                Assert.That(Count(fluid), Is.EqualTo(all).Within(all / 8), $"after move {move}");
            }
        }

        [UnityTest]
        public IEnumerator What_keeps_the_box_where_it_is_is_said_once([Values(0, 1)] int fault)
        {
            (FluidSimulation fluid, FluidFollow follow, Transform target) = Make();
            target.position = Vector3.right;
            follow.Target = fault == 0 ? null : fluid.transform.GetChild(0);
            string expected = fault == 0 ? "it has no target. Set Target" : "its target 'Water' is on or below the fluid";
            LogAssert.Expect(LogType.Warning, new Regex("^Rill: FluidFollow 'Fluid': " + expected));
            yield return Frames(3);
            Assert.That(fluid.transform.position, Is.EqualTo(Vector3.zero));
            Assert.That(Problems(follow), Has.Exactly(1).Contains(expected));
            LogAssert.NoUnexpectedReceived();
        }

        [UnityTest]
        public IEnumerator What_it_cannot_hand_over_to_or_fill_is_said_once_and_the_box_goes_on([Values(0, 1)] int fault)
        {
            (FluidSimulation fluid, FluidFollow follow, Transform target) = Make();
            if (fault == 0)
                follow.HandOverTo = Fluid("Lake", Box, 0.05f, 100, Vector3.zero, Quiet);
            else
                follow.Refill = TooLarge();
            string expected = fault == 0 ? "it hands nothing over: 'Fluid' has a particle spacing of 0.1 m and 'Lake' one of 0.05 m"
                : "it fills nothing: ";
            LogAssert.Expect(LogType.Warning, new Regex("^Rill: FluidFollow 'Fluid': " + Regex.Escape(expected)));
            for (int move = 1; move <= 2; move++)
            {
                target.position += Vector3.right;
                yield return null;
                Assert.That(fluid.transform.position.x, Is.EqualTo(move));
            }
            Assert.That(Problems(follow), Has.Exactly(1).Contains(expected));
            LogAssert.NoUnexpectedReceived();
        }

        [Test]
        public void A_distance_out_of_range_is_clamped_and_said()
        {
            (_, FluidFollow follow, _) = Make();
            LogAssert.Expect(LogType.Warning, new Regex("^Rill: FluidFollow 'Fluid': .*distance"));
            follow.Distance = 0.2f;
            Assert.That(follow.Distance, Is.EqualTo(1f));
            LogAssert.NoUnexpectedReceived();
        }

        // ---- helpers

        // A box at the origin with water 4 spacings deep, and its target.
        (FluidSimulation fluid, FluidFollow follow, Transform target) Make(Action<FluidFollow> setUp = null)
        {
            var target = new GameObject("Target");
            made.Add(target);
            FluidFollow follow = null;
            FluidSimulation fluid = Fluid("Fluid", Box, Spacing, 1000, new Vector3(Box.x, 0.4f, Box.z), made =>
            {
                Quiet(made);
                follow = made.gameObject.AddComponent<FluidFollow>();
                follow.Target = target.transform;
                setUp?.Invoke(follow);
            });
            return (fluid, follow, target.transform);
        }

        FluidVolume TooLarge()
        {
            var gameObject = new GameObject("Ocean");
            made.Add(gameObject);
            FluidVolume volume = gameObject.AddComponent<FluidVolume>();
            volume.Size = 1000f * Vector3.one;
            return volume;
        }

        static void Quiet(FluidSimulation fluid) => fluid.StatisticsInterval = 0;

        static int Count(FluidSimulation fluid) => TestFluid.Read(fluid.Solver).positions.Count(p => math.all(math.isfinite(p.xyz)));

        static List<string> Problems(IHasProblems component)
        {
            var problems = new List<string>();
            component.ListProblems(problems);
            return problems;
        }
    }
}
