using System;
using System.Collections.Generic;
using System.Linq;
using Rill;
using Unity.Mathematics;

namespace Host.Report.Obstacles
{
    /// <summary>
    /// Water in a cylinder that turns with it: its surface is the parabola z = z0 + Ω² r² / 2 g (Lamb, Hydrodynamics, §26).
    /// </summary>
    /// <remarks>
    /// Water is set turning by its first velocity and the wall, which turns as fast and does not slip, goes on with it: spinning it up
    /// from rest through the wall alone takes minutes. The floor is the domain's, which slips.
    /// A particle's new velocity is the chord of its path, and what holds it on a circle pushes along the radius at the path's end: it loses
    /// Ω² Δt of its turning in a second, Δt the substep, see <see cref="TurningLeft"/>. So the surface is also compared with that of the
    /// turning that the water has.
    /// How the bucket lies in the grid's cells shifts what a small one shows: of 12 particles across the radius, three cells, by up to a
    /// tenth. So means are over several positions, see <see cref="PositionsFor"/>.
    /// </remarks>
    sealed class RotatingBucket
    {
        public const double Radius = 0.6, Depth = 0.6;      // m
        public const int Rings = 6;                         // of equal width
        const int AverageEvery = 3;
        const float CellSide = 4f;                          // of the coarse grid, d

        /// <summary>Mean over a ring of r², as a radius, m; twice the mean height of what is in it, m; how fast it turns, rad/s; the
        /// theory's surface for the bucket's Ω and for the turning seen, m.</summary>
        public readonly List<(double Radius, double Height, double Turning, double Theory, double OwnTheory)> Profile = new();
        /// <summary>Angular velocity of the water over the bucket's, from its moment of momentum.</summary>
        public double Turning { get; private set; }
        /// <summary>Slope of the height over r², over the theory's for the bucket's Ω, and for the turning seen.</summary>
        public double Steepness { get; private set; }
        public double OwnSteepness { get; private set; }
        /// <summary>Largest distance of a ring's height from the theory's, over the theory's rise from the center to the wall.</summary>
        public double MaxError { get; private set; }
        public int Particles { get; private set; }
        /// <summary>Depth of as much water at rest, m.</summary>
        public double RestDepth { get; init; }

        /// <summary>Rise of the surface from the center to the wall, m.</summary>
        public static double Rise(double speed) => speed * speed * Radius * Radius / (2 * FluidRun.Gravity);

        /// <summary>Height of the theory's surface, m.</summary>
        /// <param name="depth">Of as much water at rest, m.</param>
        public static double Surface(double depth, double speed, double r)
            => depth + speed * speed / (2 * FluidRun.Gravity) * (r * r - Radius * Radius / 2);

        /// <summary>Fraction of its turning that water keeps without a wall that drives it: of dΩ/dt = -Ω³ Δt, the first order of the step.</summary>
        /// <param name="speed">Ω at first, rad/s.</param>
        /// <param name="substep">Δt, s.</param>
        /// <param name="time">s.</param>
        public static double TurningLeft(double speed, double substep, double time) => 1 / Math.Sqrt(1 + 2 * speed * speed * substep * time);

        /// <summary>In how many positions a bucket is looked at: 8 of one with 12 particles across its radius, 2 of one with 48.</summary>
        public static int PositionsFor(int across) => Math.Max(1, 96 / across);

        /// <param name="across">Particles across the radius.</param>
        /// <param name="speed">Ω, rad/s.</param>
        /// <param name="flat">Whether the water starts level, and not as the parabola.</param>
        /// <param name="settle">Before the mean over <paramref name="seconds"/>, s.</param>
        /// <param name="friction">Of the wall: 0 slips and acts by its pressure alone, 1 sticks.</param>
        /// <param name="still">Whether the water starts still, in a bucket that turns.</param>
        /// <param name="runs">Each in another position on the coarse grid; the mean is over all.</param>
        public static RotatingBucket Run(int across, double speed, bool flat, StepInput input, double settle, double seconds,
            float friction = 1f, bool still = false, int runs = 1)
        {
            float spacing = (float)(Radius / across), side = 2f * across + 2f + (runs > 1 ? CellSide : 0f);
            List<float3> lattice = TurningTank.Lattice(across, r => (flat ? Depth : Surface(Depth, speed, r * spacing)) / spacing);
            float height = (float)(Surface(Depth, speed, Radius) / spacing) + across;
            double[] heights = new double[Rings], counts = new double[Rings], momenta = new double[Rings], moments = new double[Rings];
            for (int number = 0; number < runs; number++)
            {
                float2 shift = CellSide * math.frac(number * new float2(0.7549f, 0.5698f)), center = across + 1f + shift;
                float3 Velocity(float3 at) => (still ? 0f : (float)speed) * spacing * new float3(at.z - center.y, 0f, center.x - at.x);
                using var run = new FluidRun("bucket", new float3(side, height, side), spacing,
                    lattice.Select(at => at + new float3(shift.x, 0f, shift.y)).ToList(), Velocity, input);
                ColliderMotion wall = Solids.RoundTank(across, height, new float3(center.x, height / 2f, center.y));
                wall.friction = friction;
                while (run.Time < settle + seconds)
                {
                    wall.start = wall.end;
                    wall.end.rotation = math.mul(quaternion.RotateY((float)(speed * run.Input.timeStep)), wall.start.rotation);
                    run.Use(wall);
                    run.Step();
                    if (run.Time <= settle || run.Steps % AverageEvery != 0)
                        continue;
                    float4[] positions = run.ReadPositions(), velocities = run.ReadVelocities();
                    for (int p = 0; p < positions.Length; p++)
                    {
                        float2 arm = positions[p].xz - center;
                        int ring = math.min((int)(math.length(arm) / across * Rings), Rings - 1);
                        counts[ring]++;
                        heights[ring] += 2 * positions[p].y * spacing;
                        momenta[ring] += arm.y * velocities[p].x - arm.x * velocities[p].z;
                        moments[ring] += math.lengthsq(arm);
                    }
                }
            }

            var bucket = new RotatingBucket
            {
                Particles = lattice.Count,
                RestDepth = lattice.Count * Math.Pow(spacing, 3) / (Math.PI * Radius * Radius),
                Turning = momenta.Sum() / moments.Sum() / speed,
            };
            bucket.Compare(speed, Enumerable.Range(0, Rings)
                .Select(i => (Math.Sqrt(moments[i] / counts[i]) * spacing, heights[i] / counts[i], momenta[i] / moments[i])).ToArray());
            return bucket;
        }

        /// <param name="speed">Of the bucket, rad/s.</param>
        /// <param name="rings">Radius and height, m; turning, rad/s.</param>
        public void Compare(double speed, (double Radius, double Height, double Turning)[] rings)
        {
            // dz/dr = Ω(r)² r / g from ring to ring; its constant is that of the same mean over the floor.
            var own = new double[Rings];
            for (int i = 1; i < Rings; i++)
                own[i] = own[i - 1] + (Squared(rings[i].Turning) + Squared(rings[i - 1].Turning)) / 2
                    * (Squared(rings[i].Radius) - Squared(rings[i - 1].Radius)) / (2 * FluidRun.Gravity);
            double Mean(Func<int, double> value) => Enumerable.Range(0, Rings).Sum(i => (2 * i + 1) * value(i)) / (Rings * Rings);
            double shift = Mean(i => rings[i].Height) - Mean(i => own[i]);
            for (int i = 0; i < Rings; i++)
                Profile.Add((rings[i].Radius, rings[i].Height, rings[i].Turning, Surface(RestDepth, speed, rings[i].Radius), own[i] + shift));
            Steepness = Slope(p => p.Height) / Slope(p => p.Theory);
            OwnSteepness = Slope(p => p.Height) / Slope(p => p.OwnTheory);
            MaxError = Profile.Max(p => Math.Abs(p.Height - p.Theory)) / Rise(speed);
        }

        // Over r².
        double Slope(Func<(double Radius, double Height, double Turning, double Theory, double OwnTheory), double> height)
        {
            double square = Profile.Average(p => Squared(p.Radius)), mean = Profile.Average(height);
            return Profile.Sum(p => (Squared(p.Radius) - square) * (height(p) - mean)) / Profile.Sum(p => Squared(Squared(p.Radius) - square));
        }

        static double Squared(double value) => value * value;
    }
}
