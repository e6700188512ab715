using System;
using System.Linq;
using Host.Experiments;
using Rill;
using Unity.Mathematics;

namespace Host.Report
{
    /// <summary>A cube of water that falls freely: how far, against g t²/2, and whether it keeps its shape.</summary>
    sealed class FreeFall
    {
        const int Side = 12;
        const double Distance = 1.2;        // m, by theory

        /// <summary>s.</summary>
        public double Time { get; private set; }
        /// <summary>m.</summary>
        public double Fallen { get; private set; }
        /// <summary>g t²/2, m.</summary>
        public double Theory { get; private set; }
        /// <summary>Distance in steps of Δt that first speed up and then move: g t (t + Δt)/2, m.</summary>
        public double Discrete { get; private set; }
        /// <summary>Rms distance from the center of mass, over that at the start.</summary>
        public double RadiusRatio { get; private set; }

        public double Error => Fallen / Theory - 1;
        /// <summary>Error relative to the distance that the integrator should have made.</summary>
        public double DiscreteError => Fallen / Discrete - 1;

        public static FreeFall Run(in StepInput input, float spacing)
        {
            int3 box = new int3(3 * Side, (int)Math.Ceiling(1.3 * Distance / spacing) + 2 * Side, 3 * Side);
            ExperimentScene scene = ExperimentScene.Block("free fall", new int3(Side, box.y - 3 * Side / 2, Side), Side, box, spacing);
            using var run = new FluidRun(scene, input);
            (double3 center, double radius) start = Shape(run);
            while (FluidRun.Gravity * run.Time * run.Time / 2 < Distance)
                run.Step();
            (double3 center, double radius) end = Shape(run);
            return new FreeFall
            {
                Time = run.Time,
                Fallen = (start.center.y - end.center.y) * spacing,
                Theory = FluidRun.Gravity * run.Time * run.Time / 2,
                Discrete = FluidRun.Gravity * run.Time * (run.Time + run.Substep) / 2,
                RadiusRatio = end.radius / start.radius,
            };
        }

        static (double3 center, double radius) Shape(FluidRun run)
        {
            double3[] positions = run.ReadPositions().Select(p => (double3)p.xyz).ToArray();
            double3 center = positions.Aggregate((a, b) => a + b) / positions.Length;
            return (center, Math.Sqrt(positions.Average(p => math.lengthsq(p - center))));
        }
    }
}
