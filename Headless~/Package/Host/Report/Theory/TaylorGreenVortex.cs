using System;
using System.Collections.Generic;
using System.Linq;
using Rill;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Host.Report
{
    /// <summary>
    /// The slowest flow along the walls of a flat square box full of water: u = U (sin x cos z, 0, -cos x sin z), one cell of a
    /// Taylor-Green vortex (1937), that turns about the vertical. It has no surface, and its walls are the domain's.
    /// </summary>
    /// <remarks>
    /// A first-order step takes Δt times the mean of the squared acceleration from the energy in a second: dU/dt = -Δt k² U³ / 2, k = π/L.
    /// </remarks>
    sealed class TaylorGreenVortex
    {
        const float Spacing = 0.05f;        // m
        const float SettlingTime = 1f;      // s

        /// <summary>Fraction of the amplitude at the end.</summary>
        public double Left { get; private set; }
        /// <summary>Fraction of the amplitude if the step is of first order and nothing else damps.</summary>
        public double LeftAtFirstOrder { get; private set; }
        /// <summary>Loss over that of a first-order step: c in U = U0 / √(1 + c k² U0² Δt t).</summary>
        public double Damping { get; private set; }
        /// <summary>Over that at the start.</summary>
        public double MaxEnergy { get; private set; }
        public double Time { get; private set; }

        /// <param name="side">Of the box, d.</param>
        /// <param name="layers">Its height, d.</param>
        /// <param name="speed">U, m/s.</param>
        public static TaylorGreenVortex Run(int side, int layers, float speed, in StepInput input, double seconds)
        {
            float wave = math.PI / side;
            float3 Flow(float3 p) => new float3(math.sin(wave * p.x) * math.cos(wave * p.z), 0f, -math.cos(wave * p.x) * math.sin(wave * p.z));
            float3 box = new float3(side, layers, side);
            using var run = new FluidRun("vortex", box, Spacing, Settled(side, layers, box, input), p => speed * Flow(p), input);
            double highest = 0, start = run.Measure().Energy;
            while (run.Time < seconds)
            {
                run.Step();
                highest = Math.Max(highest, run.Measure().Energy);
            }
            float4[] positions = run.ReadPositions(), velocities = run.ReadVelocities();
            double amplitude = Enumerable.Range(0, positions.Length).Sum(i => (double)math.dot(velocities[i].xyz, Flow(positions[i].xyz)))
                / positions.Sum(p => math.lengthsq(Flow(p.xyz))) * Spacing;
            double left = amplitude / speed, k = wave / Spacing, first = k * k * speed * speed * run.Substep * run.Time;
            return new TaylorGreenVortex { Left = left, LeftAtFirstOrder = 1 / Math.Sqrt(1 + first),
                Damping = (1 / (left * left) - 1) / first, MaxEnergy = highest / start, Time = run.Time };
        }

        static List<float3> Settled(int side, int layers, float3 box, in StepInput input)
        {
            var positions = new List<float3>();
            var random = new Random(7);
            for (int i = 0; i < side * side * layers; i++)
                positions.Add(new float3(i % side, i / (side * side), i / side % side) + 0.5f + random.NextFloat3(-0.02f, 0.02f));
            using var settling = new FluidRun("vortex", box, Spacing, positions, _ => 0f, input);
            while (settling.Time < SettlingTime)
                settling.Step();
            return settling.ReadPositions().Select(p => p.xyz).ToList();
        }
    }
}
