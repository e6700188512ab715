using System;
using System.Collections.Generic;
using System.Linq;
using Host.Report.Extremes;
using Rill;
using Unity.Mathematics;

namespace Host.Report.Obstacles
{
    /// <summary>
    /// Water that runs out of a tank through a square hole in its floor, against Torricelli: a jet at z below the level is as fast
    /// as what has fallen by z, v² = 2 g z.
    /// </summary>
    /// <remarks>
    /// The jet is narrower than the hole, so the rate is the hole's area times the speed times a coefficient that the theory of an
    /// ideal fluid gives for a slot, π/(π + 2) (Lamb, Hydrodynamics, §75), and experiments on sharp edges put at 0.60 to 0.62. It is measured, not
    /// put in: with it √level falls evenly in time.
    /// </remarks>
    sealed class OrificeFlow
    {
        public const double SlotCoefficient = Math.PI / (Math.PI + 2);
        public const double Hole = 0.3, Side = 4 * Hole, Level = 1, Plate = Hole / 6, Fall = 5 * Hole;     // m
        const double Settle = 0.5;      // s with the hole closed
        const double Warm = 0.4;        // s until the jet stands

        /// <summary>Since the hole was opened, s; level of the water over the hole's upper edge, m.</summary>
        public readonly List<(double Time, double Level)> Levels = new();
        /// <summary>Mean over the jet of speed over √(2 g z), z below the level.</summary>
        public double SpeedRatio { get; private set; }
        /// <summary>Rate over hole · √(2 g level).</summary>
        public double Discharge { get; private set; }
        /// <summary>Largest distance of the levels from the parabola with that coefficient, over the first level.</summary>
        public double Misfit { get; private set; }
        /// <summary>Particles that got through the plate beside the hole.</summary>
        public int Leaked { get; private set; }
        public int Particles { get; private set; }

        double firstRoot;

        /// <param name="across">Particles across the hole, a multiple of 6.</param>
        /// <param name="seconds">With the hole open.</param>
        public static OrificeFlow Run(int across, StepInput input, double seconds)
        {
            float spacing = (float)(Hole / across);
            int side = 4 * across, layers = (int)Math.Round(Level / spacing);
            float plate = across / 6f, top = (float)(Fall / spacing) + plate, center = side / 2f, half = across / 2f, beyond = side;
            float3[] points = ExtremeFluid.Lattice(new float3(0f, top, 0f), new int3(side, layers, side)).ToArray();
            using var run = new FluidRun("orifice", new float3(side, top + layers + across, side), spacing, points, _ => 0f, input);
            ColliderMotion Slab(float x0, float x1, float z0, float z1) => Solids.Box(new float3(x0, top - plate, z0), new float3(x1, top, z1));
            run.Use(Slab(-beyond, side + beyond, -beyond, side + beyond));
            while (run.Time < Settle)
                run.Step();

            run.Use(Slab(-beyond, center - half, -beyond, side + beyond), Slab(center + half, side + beyond, -beyond, side + beyond),
                Slab(center - half, center + half, -beyond, center - half), Slab(center - half, center + half, center + half, side + beyond));
            var flow = new OrificeFlow { Particles = points.Length };
            double ratios = 0;
            long jet = 0;
            while (run.Time < Settle + seconds)
            {
                run.Step();
                if (run.Steps % 3 != 0)
                    continue;
                float4[] positions = run.ReadPositions(), velocities = run.ReadVelocities();
                float[] above = positions.Where(p => p.y > top).Select(p => p.y - top).ToArray();
                double level = above.Length * Math.Pow(spacing, 3) / (Side * Side), time = run.Time - Settle;
                flow.Levels.Add((time, level));
                flow.Leaked = Math.Max(flow.Leaked,
                    positions.Count(p => p.y < top - 0.5f * plate && p.y > top - plate
                    && math.cmax(math.abs(p.xz - center)) > half + 0.1f));
                if (time < Warm)
                    continue;
                // Half to one width below the hole, where the jet has drawn together and its pressure is that of the air.
                double surface = 2 * above.Average() * spacing;
                for (int i = 0; i < positions.Length; i++)
                {
                    double below = (top - plate - positions[i].y) / across;
                    if (below < 0.5 || below > 1 || math.cmax(math.abs(positions[i].xz - center)) > half)
                        continue;
                    ratios += math.length(velocities[i].xyz) * spacing
                        / Math.Sqrt(2 * FluidRun.Gravity * (surface + (top - positions[i].y) * spacing));
                    jet++;
                }
            }
            flow.SpeedRatio = jet > 0 ? ratios / jet : double.NaN;
            flow.FitLevel();
            return flow;
        }

        /// <summary>Level by the fitted parabola, m.</summary>
        public double LevelAt(double time)
        {
            double root = firstRoot - Discharge * Hole * Hole / (Side * Side) * Math.Sqrt(FluidRun.Gravity / 2.0) * time;
            return root * Math.Max(root, 0);
        }

        /// <summary>√level = √first − coefficient · hole/floor · √(g/2) · t, by least squares over the time in which the jet stands.</summary>
        public void FitLevel()
        {
            (double Time, double Level)[] steady = Levels.Where(sample => sample.Time >= Warm).ToArray();
            double time = steady.Average(s => s.Time), root = steady.Average(s => Math.Sqrt(s.Level));
            double slope = steady.Sum(s => (s.Time - time) * (Math.Sqrt(s.Level) - root)) / steady.Sum(s => (s.Time - time) * (s.Time - time));
            firstRoot = root - slope * time;
            Discharge = -slope * Side * Side / (Hole * Hole) / Math.Sqrt(FluidRun.Gravity / 2.0);
            Misfit = steady.Max(s => Math.Abs(s.Level - LevelAt(s.Time))) / Level;
        }
    }
}
