using System;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using static System.FormattableString;

namespace Rill.Tests
{
    public class BordersTests
    {
        [TestCase(20f, 0f), TestCase(20f, 20f), TestCase(40f, 0f), TestCase(40f, 20f), TestCase(40f, 40f)]
        public void Study(float length, float width)
        {
            float amplitude = 3f;
            using (var tank = new WaveTank(length, 16, amplitude, width > 0f ? BorderKind.Absorbing : BorderKind.Wall, width))
            {
                (double incident, double reflected) = tank.Run();
                TestContext.WriteLine(Invariant($"length {length} band {width}: incident {incident:G4} reflected {100 * reflected:0.0} %"));
            }
        }

        [TestCase(0.4f), TestCase(0f)]
        public void Channel(float speed)
        {
            using (var scene = new SourceScene(new Vector3(6f, 1f, 0.4f), 0.05f, 20000, DeepWater.Automatic))
            {
                scene.Fill(0.6f);
                FluidBorders borders = FluidBorders.Default;
                borders.minX = new FluidBorder { kind = BorderKind.Open, width = 1f, velocity = speed, level = 0.6f };
                borders.maxX = new FluidBorder { kind = BorderKind.Open, width = 1f, velocity = -speed, level = 0.6f };
                scene.Fluid.Borders = borders;
                for (int second = 0; second < 6; second++)
                {
                    scene.Step(60);
                    ParticleState state = scene.Read();
                    var level = new double[12];
                    var flow = new double[12];
                    for (int i = 0; i < state.Count; i++)
                    {
                        int bin = (int)(state.positions[i].x / 10f);
                        level[bin] += 1.0 / 80;
                        flow[bin] += state.velocities[i].x * 0.05 / 80;
                    }
                    TestContext.WriteLine($"{second + 1} s {state.Count} level " + string.Join(" ", level.Select(l => l.ToString("0.0"))) +
                        " u " + string.Join(" ", flow.Select((f, b) => (f / level[b]).ToString("0.00"))));
                }
                FluidStatistics s = scene.Measure();
                TestContext.WriteLine($"emitted {s.emitted} drained {s.drained} blocked {s.blocked} waiting {s.waiting} refused {s.refused}");
            }
        }
    }
}
