using System.Collections;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;
using Rill.Testing;

namespace Rill.Tests
{
    /// <summary>Water through several connections, and where one of the fluids stands still or moves its box.</summary>
    public class FluidChainTests : ConnectedFluidFixture
    {
        [UnityTest, Category("LongRun")]
        public IEnumerator Three_fluids_in_a_chain_become_level_and_none_is_lost()
        {
            float apart = Box.x - Overlap;
            FluidSimulation a = Make("A", -apart, -1f, new Vector3(1.5f, 1f, 0.5f), DeepWater.On);
            FluidSimulation b = Make("B", 0f, -1f, Vector3.zero, DeepWater.On), c = Make("C", apart, -1f, Vector3.zero, DeepWater.On);
            Connect(a, b);
            Connect(b, c);
            int all = 15 * 10 * 5;
            for (int frame = 0; frame < 300; frame++)
            {
                yield return null;
                Assert.That(Own(a).Length + Own(b).Length + Own(c).Length, Is.EqualTo(all), $"particles of all in frame {frame}");
            }
            FluidAssert.NothingLost(a);
            FluidAssert.NothingLost(b);
            FluidAssert.NothingLost(c);
            float[] levels = { Level(a, -2.2f, -0.8f), Level(b, -0.4f, 0.4f), Level(c, 0.8f, 2.2f) };
            TestContext.Out.WriteLine($"levels {levels[0]:0.000}, {levels[1]:0.000} and {levels[2]:0.000} m");
            Assert.That(levels.Max() - levels.Min(), Is.LessThan(Spacing));
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator A_dam_breaks_through_an_opening_as_in_one_box_of_both([Values(DeepWater.Off, DeepWater.On)] DeepWater deepWater)
        {
            Vector3 water = new Vector3(1.2f, 0.8f, 0.5f), whole = new Vector3(2f * Box.x - Overlap, Box.y, Box.z), aside = 10f * Vector3.forward;
            (FluidSimulation left, FluidSimulation right) = Pair(water, Vector3.zero, deepWater);
            Connect(left, right);
            FluidSimulation one = Fluid("One", whole, Spacing, 4000, Vector3.zero, fluid =>
            {
                fluid.StatisticsInterval = 0;
                fluid.Settings = left.Settings;
                fluid.transform.position = aside;
                AddWater(fluid, water, new Vector3(0.5f * (water.x - whole.x), 0.5f * (water.y - whole.y), 0f));
            });
            float apart = 0f;
            for (int frame = 1; frame <= 48; frame++)
            {
                yield return null;
                if (frame % 6 != 0)
                    continue;
                float through = Front(Own(left).Concat(Own(right)).ToArray()), alone = Front(Own(one));
                TestContext.Out.WriteLine($"{frame / 60f:0.0} s: front at {through:0.00} m through the opening, {alone:0.00} m in one box");
                apart = Mathf.Max(apart, Mathf.Abs(through - alone));
            }
            Assert.That(apart, Is.LessThan(0.5f * Spacing), "m between the fronts");
            yield return Frames(192);
            float onLeft = Level(left, -1.4f, -0.2f), onRight = Level(right, 0.2f, 1.4f);
            float oneLeft = Level(one, -1.4f, -0.2f), oneRight = Level(one, 0.2f, 1.4f);
            TestContext.Out.WriteLine($"4.0 s: levels {onLeft:0.000} and {onRight:0.000} m, {oneLeft:0.000} and {oneRight:0.000} m in one box");
            Assert.That(onLeft, Is.EqualTo(oneLeft).Within(Spacing));
            Assert.That(onRight, Is.EqualTo(oneRight).Within(Spacing));
        }

        // How far along x the water is, but for a few drops: one particle in fifty is beyond.
        static float Front(Vector3[] positions) => positions.Select(p => p.x).OrderByDescending(x => x).ElementAt(positions.Length / 50);

        [UnityTest, Category("LongRun")]
        public IEnumerator Beside_a_fluid_that_stands_still_nothing_is_lost([Values] bool disabled)
        {
            (FluidSimulation left, FluidSimulation right) = Pair(new Vector3(1.2f, 0.8f, 0.5f), Vector3.zero);
            FluidConnection connection = Connect(left, right);
            int all = 12 * 8 * 5;
            yield return Frames(30);
            PbfSolver solver = right.Solver;
            if (disabled)
                right.gameObject.SetActive(false);
            else
                right.Paused = true;
            yield return null;      // in which the other still gets what crossed before
            int there = Finite(solver);
            for (int frame = 0; frame < 30; frame++)
            {
                yield return null;
                Assert.That(connection.IsOpen, Is.EqualTo(!disabled));
                Assert.That(Own(left).Length + Finite(solver), Is.EqualTo(all), $"particles of both in frame {frame}");
                Assert.That(Own(left).Max(p => p.x), Is.LessThanOrEqualTo(0.5f * Overlap), "in its box");
                Assert.That(Finite(solver), Is.EqualTo(there), "what stands still gives and takes nothing");
            }
            if (disabled)
                right.gameObject.SetActive(true);
            right.Paused = false;
            for (int frame = 0; frame < 120; frame++)
            {
                yield return null;
                Assert.That(Own(left).Length + Own(right).Length, Is.EqualTo(all), $"particles of both in frame {frame} after");
            }
            Assert.That(connection.IsOpen);
            FluidAssert.NothingLost(left);
            FluidAssert.NothingLost(right);
            Assert.That(Level(left, -1.4f, -0.2f), Is.EqualTo(Level(right, 0.2f, 1.4f)).Within(1.5f * Spacing));
        }

        [UnityTest]
        public IEnumerator A_connected_box_that_moves_hands_over_what_it_leaves_and_takes_what_it_finds()
        {
            (FluidSimulation left, FluidSimulation right) = Pair(new Vector3(2f, 0.6f, 0.5f), new Vector3(2f, 0.6f, 0.5f));
            Connect(left, right);
            yield return Frames(5);
            int all = Own(left).Length + Own(right).Length;
            Vector3 home = right.transform.position;
            foreach (float by in new[] { -0.4f, 0f, 0.3f })
            {
                right.Recenter(home + by * Vector3.right, LeavingParticles.Keep, left);
                AsyncGPUReadback.WaitAllRequests();
                yield return null;
                float center = 0.5f * by;
                Assert.That(Own(left).Max(p => p.x), Is.LessThan(center + Spacing), $"left of the center of the overlap, moved by {by} m");
                Assert.That(Own(right).Min(p => p.x), Is.GreaterThan(center - Spacing), $"right of it, moved by {by} m");
                yield return Frames(5);
                AsyncGPUReadback.WaitAllRequests();
                yield return Frames(2);
                AsyncGPUReadback.WaitAllRequests();
                Assert.That(Own(left).Length + Own(right).Length + right.KeptParticleCount, Is.EqualTo(all), $"moved by {by} m");
            }
            Assert.That(right.KeptParticleCount, Is.Zero);
        }

        static int Finite(PbfSolver solver) => TestFluid.Read(solver).positions.Count(p => !float.IsNaN(p.x));
    }
}
