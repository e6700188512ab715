using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;
using Rill.Testing;

namespace Rill.Tests
{
    /// <summary>Two fluids whose boxes overlap along x, and the water that flows between them.</summary>
    public class FluidConnectionTests : PlayedFluidFixture
    {
        const float Spacing = 0.1f, Overlap = 8f * Spacing;

        static readonly Vector3 Box = new Vector3(2f, 1.2f, 0.5f);

        [UnityTest]
        public IEnumerator Water_flows_into_an_empty_box_until_both_are_level_and_none_is_lost([Values] DeepWater deepWater)
        {
            (FluidSimulation left, FluidSimulation right) = Pair(new Vector3(1.2f, 0.8f, 0.5f), Vector3.zero, deepWater);
            FluidConnection connection = Connect(left, right);
            int all = 12 * 8 * 5;
            for (int frame = 0; frame < 240; frame++)
            {
                yield return null;
                Assert.That(Own(left).Length + Own(right).Length, Is.EqualTo(all), $"particles of both in frame {frame}");
            }
            AsyncGPUReadback.WaitAllRequests();
            FluidAssert.NothingLost(left);
            FluidAssert.NothingLost(right);
            FluidStatistics onLeft = FluidAssert.Measure(left), onRight = FluidAssert.Measure(right);
            float levelLeft = Level(left, -1.4f, -0.2f), levelRight = Level(right, 0.2f, 1.4f);
            TestContext.Out.WriteLine($"{onLeft.particles} left, {onRight.particles} right, {connection.HandedToSecond} over, " +
                $"{connection.HandedToFirst} back; levels {levelLeft:0.000} and {levelRight:0.000} m, rms speed {onLeft.speed:0.000} and " +
                $"{onRight.speed:0.000} m/s, density error {onLeft.densityError:0.0000} and {onRight.densityError:0.0000}");
            Assert.That(onLeft.handedOut - onLeft.handedIn, Is.EqualTo(onRight.particles));
            Assert.That(levelLeft, Is.EqualTo(levelRight).Within(0.5f * Spacing));
        }

        [UnityTest]
        public IEnumerator Water_at_rest_in_both_boxes_stays_level_and_calm([Values] DeepWater deepWater)
        {
            (FluidSimulation left, FluidSimulation right) = Pair(new Vector3(2f, 0.8f, 0.5f), new Vector3(2f, 0.8f, 0.5f), deepWater);
            Connect(left, right);
            yield return Frames(1);
            int all = Own(left).Length + Own(right).Length;
            Assert.That(all, Is.EqualTo(32 * 8 * 5), "what both were filled with is there once");
            yield return Frames(120);
            FluidStatistics onLeft = FluidAssert.Measure(left), onRight = FluidAssert.Measure(right);
            float levelLeft = Level(left, -1.4f, -0.2f), levelRight = Level(right, 0.2f, 1.4f), between = Level(left, -0.2f, 0f);
            TestContext.Out.WriteLine($"{onLeft.particles} left, {onRight.particles} right; levels {levelLeft:0.000}, {between:0.000} and " +
                $"{levelRight:0.000} m, rms speed {onLeft.speed:0.000} and {onRight.speed:0.000} m/s, density error " +
                $"{onLeft.densityError:0.0000} and {onRight.densityError:0.0000}");
            Assert.That(onLeft.particles + onRight.particles, Is.EqualTo(all));
            Assert.That(levelLeft, Is.EqualTo(levelRight).Within(0.3f * Spacing));
            Assert.That(math.max(onLeft.speed, onRight.speed), Is.LessThan(0.1f));
        }

        // ---- helpers

        // One box on each side of x = 0, overlapping by 8 spacings around it; water from the outer end of each.
        (FluidSimulation left, FluidSimulation right) Pair(Vector3 waterLeft, Vector3 waterRight, DeepWater deepWater = DeepWater.Off,
            Action<FluidSimulation> setUp = null, int capacity = 4000)
        {
            void SetUp(FluidSimulation fluid, float side, Vector3 water)
            {
                fluid.StatisticsInterval = 0;
                SolverSettings settings = fluid.Settings;
                settings.deepWater = deepWater;
                fluid.Settings = settings;
                fluid.transform.position = new Vector3(side * 0.5f * (Box.x - Overlap), 0f, 0f);
                if (water != Vector3.zero)
                    AddWater(fluid, water, new Vector3(side * 0.5f * (Box.x - water.x), 0.5f * (water.y - Box.y), 0.5f * (water.z - Box.z)));
                setUp?.Invoke(fluid);
            }
            return (Fluid("Left", Box, Spacing, capacity, Vector3.zero, fluid => SetUp(fluid, -1f, waterLeft)),
                Fluid("Right", Box, Spacing, capacity, Vector3.zero, fluid => SetUp(fluid, 1f, waterRight)));
        }

        FluidConnection Connect(FluidSimulation first, FluidSimulation second)
        {
            var gameObject = new GameObject("Opening");
            made.Add(gameObject);
            gameObject.SetActive(false);
            var connection = gameObject.AddComponent<FluidConnection>();
            connection.First = first;
            connection.Second = second;
            gameObject.SetActive(true);
            return connection;
        }

        // Positions in world space of the particles that are a fluid's own.
        static Vector3[] Own(FluidSimulation fluid)
        {
            ParticleState state = TestFluid.Read(fluid.Solver);
            Matrix4x4 toWorld = fluid.DomainToWorld;
            return state.positions.Where(p => math.all(math.isfinite(p.xyz))).Select(p => toWorld.MultiplyPoint3x4(p.xyz)).ToArray();
        }

        // Height of the water's surface over the floor between two places along x: twice that of its centre of mass.
        static float Level(FluidSimulation fluid, float from, float to)
        {
            float[] heights = Own(fluid).Where(p => p.x >= from && p.x < to).Select(p => p.y + 0.5f * Box.y).ToArray();
            return heights.Length == 0 ? 0f : 2f * heights.Average();
        }
    }
}
