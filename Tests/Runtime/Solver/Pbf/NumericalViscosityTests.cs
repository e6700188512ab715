using System.Linq;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>
    /// How fast still-standing motion dies that nothing but the solver brakes: the slowest vortex of a square tank, by its amplitude
    /// in the particles' velocities. Ideal water keeps it; a viscosity ν takes 2 ν (π/L)² of it in a second.
    /// </summary>
    public class NumericalViscosityTests
    {
        const float Spacing = 0.05f, Speed = 0.5f;
        const int Side = 20, Layers = 16, Steps = 60;

        [Test, Category("LongRun")]
        public void A_vortex_in_deep_water_keeps_most_of_its_motion_for_a_second()
        {
            var settings = SolverSettings.Default;
            settings.deepWater = DeepWater.On;
            settings.iterations = 2;
            ParticleState still;
            using (var fluid = new TestFluid(Side * Spacing, Spacing, Side * Side * Layers, settings))
                still = fluid.AddBlock(0f, new float3(Side, Layers, Side) * Spacing).Step(60).Read();
            using (var fluid = new TestFluid(Side * Spacing, Spacing, Side * Side * Layers, settings))
            {
                using (var positions = new NativeArray<float4>(still.positions.Select(p => new float4(p.xyz * Spacing, 0f)).ToArray(),
                    Allocator.Persistent))
                using (var velocities = new NativeArray<float4>(still.positions.Select(p => new float4(Speed * Vortex(p.xyz), 0f))
                    .ToArray(), Allocator.Persistent))
                    fluid.Solver.Add(positions, velocities);
                float amplitude = Amplitude(fluid.Step(Steps).Read()) * Spacing / Speed;
                float wave = math.PI / Side;
                TestContext.Out.WriteLine($"amplitude {amplitude:0.000} of the start's after {Steps} steps: a viscosity of " +
                    $"{-math.log(amplitude) / (2f * wave * wave * Steps):0.000} d² a step");
                Assert.That(amplitude, Is.InRange(0.7f, 1f));
            }
        }

        // Flow along the walls, in turns about the vertical; places in d, velocities of the state in d/s.
        static float3 Vortex(float3 p)
        {
            float3 a = p * (math.PI / Side);
            return new float3(math.sin(a.x) * math.cos(a.z), 0f, -math.cos(a.x) * math.sin(a.z));
        }

        static float Amplitude(ParticleState state)
        {
            double along = 0.0, all = 0.0;
            for (int i = 0; i < state.Count; i++)
            {
                float3 vortex = Vortex(state.positions[i].xyz);
                along += math.dot(vortex, state.velocities[i].xyz);
                all += math.dot(vortex, vortex);
            }
            return (float)(along / all);
        }
    }
}
