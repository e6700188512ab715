using System;
using System.Collections.Generic;
using System.Linq;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>Drops of water by themselves and what is measured of them. Lengths in d, velocities in d/s.</summary>
    static class FreeDrop
    {
        public const float Spacing = 0.01f, TimeStep = 1f / 60f;

        /// <summary>Tension, N/m, of water whose Σ in a substep is this at these steps.</summary>
        public static float Tension(double strength, float timeStep = TimeStep)
            => (float)(strength * 1000.0 * Math.Pow(Spacing, 3.0) / ((double)timeStep * timeStep));

        /// <summary>Makes a fluid without gravity of the points of a lattice of which a shape is true; 0 is the center of the box.</summary>
        /// <param name="strength">Σ of a substep.</param>
        /// <param name="floor">Height above which the shape stands, 0 of which is there then; below 0 for none.</param>
        public static TestFluid Make(float3 box, Func<float3, bool> isIn, double strength, int iterations, float contactAngle = 90f,
            float floor = -1f, float jitter = 0.02f)
        {
            SolverSettings settings = SolverSettings.Default;
            settings.iterations = iterations;
            settings.deepWater = DeepWater.Off;
            var random = new Unity.Mathematics.Random(7u);
            var points = new List<float3>();
            float3 center = math.floor(0.5f * box);
            int3 half = (int3)center, low = -half, high = half;
            if (floor >= 0f)
            {
                center.y = floor;
                low.y = 0;
                high.y = (int)(box.y - floor);
            }
            for (int z = low.z; z < high.z; z++)
                for (int y = low.y; y < high.y; y++)
                    for (int x = low.x; x < high.x; x++)
                    {
                        float3 p = new float3(x, y, z) + 0.5f;
                        if (isIn(p))
                            points.Add((center + p + random.NextFloat3(-jitter, jitter)) * Spacing);
                    }
            var fluid = new TestFluid(box * Spacing, Spacing, Math.Max(points.Count, 2), settings);
            fluid.Input.timeStep = TimeStep;
            fluid.Input.gravity = 0f;
            fluid.Input.material.surfaceTension = Tension(strength);
            fluid.Input.material.contactAngle = contactAngle;
            return fluid.Add(points.ToArray());
        }

        public static double3 Center(ParticleState state) => Sum(state, i => (double3)state.positions[i].xyz) / state.Count;

        /// <summary>Mean velocity.</summary>
        public static double3 Drift(ParticleState state) => Sum(state, i => (double3)state.velocities[i].xyz) / state.Count;

        /// <summary>Mean of the squared velocity, halved, d²/s².</summary>
        public static double Kinetic(ParticleState state) => 0.5 * state.velocities.Average(v => math.lengthsq(v.xyz));

        /// <summary>Reach from the center of mass in the direction in which it is shortest, over that in which it is longest.</summary>
        public static double Roundness(ParticleState state)
        {
            const int Directions = 200;
            double3 center = Center(state);
            double least = double.MaxValue, most = 0.0;
            for (int k = 0; k < Directions; k++)
            {
                double z = 1.0 - 2.0 * (k + 0.5) / Directions, angle = 2.39996 * k, ring = Math.Sqrt(1.0 - z * z);
                var direction = new double3(ring * Math.Cos(angle), ring * Math.Sin(angle), z);
                double reach = state.positions.Max(p => math.dot((double3)p.xyz - center, direction));
                least = Math.Min(least, reach);
                most = Math.Max(most, reach);
            }
            return least / most;
        }

        /// <summary>How much longer it is along y than across: 0 for a ball.</summary>
        public static double Ellipticity(ParticleState state)
        {
            double3 center = Center(state);
            double3 squares = Sum(state, i => ((double3)state.positions[i].xyz - center) * ((double3)state.positions[i].xyz - center));
            return 3.0 * (squares.y - 0.5 * (squares.x + squares.z)) / math.csum(squares);
        }

        /// <summary>Contact angle, degrees, of the cap of a ball on the floor that has the drop's volume and mean height.</summary>
        /// <param name="floor">Its height.</param>
        public static double Angle(ParticleState state, double floor = 0.0)
        {
            double height = state.positions.Average(p => (double)p.y) - floor, best = double.MaxValue, angle = 0.0;
            for (double degrees = 3.0; degrees <= 178.0; degrees += 0.5)
            {
                double cosine = Math.Cos(degrees * Math.PI / 180.0);
                double radius = Math.Pow(state.Count / (Math.PI / 3.0 * (2.0 - 3.0 * cosine + cosine * cosine * cosine)), 1.0 / 3.0);
                double cap = radius * (1.0 - cosine);
                double center = cap * (4.0 * radius - cap) / (4.0 * (3.0 * radius - cap));
                if (Math.Abs(center - height) >= best)
                    continue;
                best = Math.Abs(center - height);
                angle = degrees;
            }
            return angle;
        }

        /// <summary>Frequency of a damped oscillation about any mean, over an expected one, by least squares.</summary>
        /// <param name="values">One a step.</param>
        /// <param name="expected">1/s.</param>
        public static (double Ratio, double Damping, double Mean) Fit(double[] values, double timeStep, double expected)
        {
            (double, double, double) best = default;
            double least = double.MaxValue;
            for (double ratio = 0.3; ratio <= 2.6; ratio += 0.04)
                for (double damping = 0.0; damping <= 0.8; damping += 0.04)
                {
                    double w = 2.0 * Math.PI * expected * ratio, g = damping * w;
                    var normal = new double[4, 4];      // of f_a f_b; f_3 is the values
                    for (int n = 0; n < values.Length; n++)
                    {
                        double t = (n + 1) * timeStep, fade = Math.Exp(-g * t);
                        var f = new[] { fade * Math.Cos(w * t), fade * Math.Sin(w * t), 1.0, values[n] };
                        for (int a = 0; a < 4; a++)
                            for (int b = 0; b < 4; b++)
                                normal[a, b] += f[a] * f[b];
                    }
                    // Elimination leaves the error in the last corner, and the mean in the row above.
                    for (int pivot = 0; pivot < 3; pivot++)
                        for (int a = pivot + 1; a < 4; a++)
                        {
                            double factor = normal[a, pivot] / (normal[pivot, pivot] + 1e-12);
                            for (int b = pivot; b < 4; b++)
                                normal[a, b] -= factor * normal[pivot, b];
                        }
                    double error = normal[3, 3], mean = normal[2, 3] / (normal[2, 2] + 1e-12);
                    if (error >= least)
                        continue;
                    least = error;
                    best = (ratio, damping, mean);
                }
            return best;
        }

        static double3 Sum(ParticleState state, Func<int, double3> value)
        {
            double3 sum = default;
            for (int i = 0; i < state.Count; i++)
                sum += value(i);
            return sum;
        }
    }
}
