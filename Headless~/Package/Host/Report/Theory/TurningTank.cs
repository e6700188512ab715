using System;
using System.Collections.Generic;
using Host.Report.Obstacles;
using Rill;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Host.Report
{
    /// <summary>Water that turns in a round tank without friction, under the parabola of its turning: ideal water would turn on.</summary>
    sealed class TurningTank
    {
        const float Spacing = 0.025f;       // m

        /// <summary>Fraction of its turning at the end.</summary>
        public double Left { get; private set; }
        /// <summary>Fraction if the step is of first order and nothing else damps, see <see cref="RotatingBucket.TurningLeft"/>.</summary>
        public double LeftAtFirstOrder { get; private set; }
        /// <summary>Loss over that of a first-order step: c in Ω = Ω0 / √(1 + 2 c Ω0² Δt t).</summary>
        public double Damping { get; private set; }
        /// <summary>m/s.</summary>
        public double Jitter { get; private set; }
        public double Time { get; private set; }

        /// <summary>At which the water's parabola touches the floor, rad/s.</summary>
        /// <param name="radius">Of the tank, d.</param>
        /// <param name="layers">Of as much water at rest.</param>
        public static double MaxSpeed(double radius, double layers) => Math.Sqrt(4 * FluidRun.Gravity * layers / Spacing) / radius;

        /// <param name="radius">Of the tank, d.</param>
        /// <param name="layers">Of as much water at rest.</param>
        /// <param name="speed">Ω, rad/s.</param>
        public static TurningTank Run(int radius, int layers, double speed, in StepInput input, double seconds)
        {
            float center = radius + 1f;
            double Surface(double r) => layers + speed * speed / (2 * FluidRun.Gravity) * (r * r - radius * radius / 2.0) * Spacing;
            float height = (float)Surface(radius) + radius;
            using var run = new FluidRun("tank", new float3(2f * center, height, 2f * center), Spacing, Lattice(radius, Surface),
                p => (float)speed * Spacing * new float3(p.z - center, 0f, center - p.x), input);
            run.Use(Solids.RoundTank(radius, height, new float3(center, height / 2f, center)));
            while (run.Time < seconds)
                run.Step();
            float4[] positions = run.ReadPositions(), velocities = run.ReadVelocities();
            double momentum = 0, moment = 0;
            for (int i = 0; i < positions.Length; i++)
            {
                float2 arm = positions[i].xz - center;
                momentum += arm.y * velocities[i].x - arm.x * velocities[i].z;
                moment += math.lengthsq(arm);
            }
            double left = momentum / moment / speed;
            return new TurningTank
            {
                Left = left,
                LeftAtFirstOrder = RotatingBucket.TurningLeft(speed, run.Substep, run.Time),
                Damping = (1 / (left * left) - 1) / (2 * speed * speed * run.Substep * run.Time),
                Jitter = run.Measure().jitter,
                Time = run.Time,
            };
        }

        /// <summary>Particles within a round tank whose axis is a spacing further from the domain's corner than its radius, d.</summary>
        /// <param name="surface">Height of the surface at a distance from the axis, both in d.</param>
        public static List<float3> Lattice(int radius, Func<double, double> surface)
        {
            var random = new Random(7);
            var positions = new List<float3>();
            for (int x = -radius; x < radius; x++)
                for (int z = -radius; z < radius; z++)
                {
                    double r = Math.Sqrt((x + 0.5) * (x + 0.5) + (z + 0.5) * (z + 0.5));
                    int layers = (int)Math.Round(surface(r));
                    for (int y = 0; y < layers && r <= radius - 0.3; y++)
                        positions.Add(new float3(radius + 1f + x + 0.5f, y + 0.5f, radius + 1f + z + 0.5f) + random.NextFloat3(-0.02f, 0.02f));
                }
            return positions;
        }
    }
}
