using System;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>Grains: slopes that stand, columns that collapse.</summary>
    public class GrainFrictionTests
    {
        [TestCase(0.6f, 1f, 16, 60, 0.01f)]
        public void Columns_collapse(float friction, float aspect, int radius, int rate, float d)
        {
            float size = float.Parse(Environment.GetEnvironmentVariable("RB") ?? "6");
            friction = float.Parse(Environment.GetEnvironmentVariable("RF") ?? "0.6");
            radius = int.Parse(Environment.GetEnvironmentVariable("RR") ?? "12");
            rate = int.Parse(Environment.GetEnvironmentVariable("RHZ") ?? "60");
            d = float.Parse(Environment.GetEnvironmentVariable("RD") ?? "0.01");
            aspect = float.Parse(Environment.GetEnvironmentVariable("RA") ?? "1");
            SolverSettings settings = SolverSettings.Default;
            settings.iterations = int.Parse(Environment.GetEnvironmentVariable("RK") ?? "2");
            settings.deepWater = DeepWater.On;
            settings.sleepSpeed = float.Parse(Environment.GetEnvironmentVariable("RSL") ?? "0");
            int side = (int)(size * radius) / 4 * 4, height = (int)math.round(aspect * radius);
            var box = new float3(side, 2 * height + 8, side);
            float3 middle = 0.5f * box;
            ParticleState block = ParticleState.Lattice(0f, 0.5f, new int3(side, height, side), 0.1f);
            float3[] points = block.positions.Select(p => p.xyz).Where(p => math.length((p - middle).xz) < radius).Select(p => p * d).ToArray();
            using (var fluid = new TestFluid(box * d, d, points.Length, settings))
            {
                fluid.Input.timeStep = 1f / rate;
                fluid.Input.material.frictionAngle = math.degrees(math.atan(friction));
                fluid.Input.material.wallFriction = 1f;
                fluid.Input.material.cohesion = float.Parse(Environment.GetEnvironmentVariable("RC") ?? "0");
                fluid.Add(points);
                fluid.Input.material.cohesion = 5000f;
                fluid.Step(int.Parse(Environment.GetEnvironmentVariable("RW") ?? "0") * rate / 60);
                fluid.Input.material.cohesion = 0f;
                float seconds = float.Parse(Environment.GetEnvironmentVariable("RT") ?? "2");
                if (Environment.GetEnvironmentVariable("RDBG") == "1")
                    for (int k = 0; k < 10; k++)
                    {
                        fluid.Step(1);
                        float phi = GpuTest.Read<float>(fluid.Solver.Coarse.Cells.flowPotential, fluid.Solver.Coarse.Grid.Total).Max();
                        TestContext.Out.WriteLine($"step {k} phi {phi:0.00} hydrostatic {9.81f / rate / rate / d * (height - 2):0.00}");
                        Profile(fluid, middle, radius, height, (k + 1f) / rate);
                    }
                for (int part = 0; part < (int)(seconds * 4); part++)
                {
                    fluid.Step(rate / 4);
                    Profile(fluid, middle, radius, height, (part + 1) * 0.25f);
                }
            }
        }

        [Test]
        public void Slope()
        {
            SolverSettings settings = SolverSettings.Default;
            settings.iterations = 2;
            settings.deepWater = DeepWater.On;
            settings.sleepSpeed = 0f;
            const float d = 0.01f;
            int depth = int.Parse(Environment.GetEnvironmentVariable("RH") ?? "12");
            foreach (float angle in new[] { 15f, 20f, 25f, 29f, 33f, 38f })
            using (var fluid = new TestFluid(new float3(80, 40, 8) * d, d, 80 * depth * 8, settings))
            {
                fluid.Input.material.frictionAngle = 31f;
                fluid.Input.gravity = 9.81f * new float3(math.sin(math.radians(angle)), -math.cos(math.radians(angle)), 0f);
                fluid.AddBlock(0f, new float3(80, depth, 8) * d);
                string line = "";
                for (int part = 0; part < 8; part++)
                {
                    fluid.Step(8);
                    ParticleState state = fluid.Read();
                    double v = 0, n = 0, top = 0;
                    for (int i = 0; i < state.Count; i++)
                        if (state.positions[i].x > 30 && state.positions[i].x < 50)
                        {
                            v += state.velocities[i].x * d;
                            n++;
                            if (state.positions[i].y > depth - 2)
                                top = Math.Max(top, state.velocities[i].x * d);
                        }
                    line += $"{v / n:0.000}/{top:0.000} ";
                }
                TestContext.Out.WriteLine($"{angle}: t mean/top " + line);
            }
        }

        static void Profile(TestFluid fluid, float3 middle, float radius, float height, float time)
        {
            ParticleState state = fluid.Read();
            var top = new float[200];
            var count = new int[200];
            double speed = 0.0, fast = 0.0;
            for (int i = 0; i < state.Count; i++)
            {
                float3 p = state.positions[i].xyz;
                int ring = (int)math.length((p - middle).xz);
                top[ring] = math.max(top[ring], p.y + 0.5f);
                count[ring]++;
                speed += math.lengthsq(state.velocities[i].xyz);
                fast = Math.Max(fast, math.length(state.velocities[i].xyz));
            }
            int last = 0;
            for (int ring = 0; ring < 200; ring++)
                if (count[ring] > 0.5 * Math.PI * (2 * ring + 1))
                    last = ring + 1;
            double s1 = 0, s2 = 0, s3 = 0, s4 = 0;
            int n = 0;
            for (int ring = 1; ring < last - 1; ring++, n++)
            {
                s1 += ring;
                s2 += top[ring];
                s3 += ring * ring;
                s4 += ring * top[ring];
            }
            double slope = n > 1 ? (n * s4 - s1 * s2) / (n * s3 - s1 * s1) : 0.0;
            TestContext.Out.WriteLine($"t {time:0.00} run-out {(last - radius) / radius:0.00} (Lube {1.24 * height / radius:0.00}) crest {top[0]:0.0} " +
                $"(Lube {0.88 * Math.Pow(height / radius, 1.0 / 6.0) * radius:0.0}) slope {Math.Atan(-slope) * 180.0 / Math.PI:0.0} rms " +
                $"{Math.Sqrt(speed / state.Count) * fluid.Spacing:0.0000} m/s max {fast * fluid.Spacing:0.000} N {state.Count}; " +
                string.Join(" ", Enumerable.Range(0, last).Where(r => r % 3 == 0).Select(r => top[r].ToString("0"))));
        }
    }
}
