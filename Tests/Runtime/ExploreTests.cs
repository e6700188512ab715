using System;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
namespace Rill.Tests
{
    public class ExploreTests
    {
        [Test]
        public void Explore_sway([Values(0.01f, 0f)] float viscosity, [Values(0.05f, 1f / 30f, 0.025f)] float spacing)
        {
            SolverSettings settings = SolverSettings.Default;
            settings.substeps = 4;
            using (var fluid = new TestFluid(new float3(1f, 1f, 0.2f), spacing, 20000, settings).AddBlock(0f, new float3(0.5f, 0.5f, 0.2f)))
            {
                fluid.Input.material.viscosity = viscosity;
                float[] peaks = new float[12], until = new float[4];
                for (int i = 0; i < 120; i++)
                {
                    var s = fluid.Step(6).Measure();
                    float mass = s.particles * 1000f * spacing * spacing * spacing;
                    float u = math.abs(s.momentum.x) / mass;
                    peaks[i / 10] = math.max(peaks[i / 10], u);
                    for (int k = 0; k < 4; k++) if (u > new[] { 0.2f, 0.1f, 0.05f, 0.02f }[k]) until[k] = (float)s.time;
                }
                System.IO.File.AppendAllText("/tmp/explore.log", $"visc {viscosity} d {spacing:0.000} peaks a second {string.Join(" ", peaks.Select(p => p.ToString("0.00")))} until {string.Join(" ", until.Select(p => p.ToString("0.0")))}\n");
            }
        }
    }
}
