using System;
using System.Collections.Generic;
using System.Linq;
using Host.Experiments;
using Rill;
using Unity.Mathematics;

namespace Host.Report
{
    /// <summary>The dam break of Martin and Moyce: a column 1 m wide and 2 m high onto the dry floor of a tank 10 m long, up to T = 2.8.</summary>
    sealed class DamBreakFront
    {
        /// <summary>Width of the water, from the wall at its back: a, m.</summary>
        public const double Width = 1;
        /// <summary>Fraction of the water that the front is ahead of: single particles that fly ahead are not a front.</summary>
        public const double Fraction = 0.995;
        public const double End = 2.8;

        /// <summary>After every step.</summary>
        public FrontSeries Front { get; private set; }
        /// <summary>Front of these states dated half a substep later: velocities of the solver are those of the midpoint of a substep.</summary>
        public FrontSeries FrontHalfStepLater { get; private set; }
        /// <summary>Kinetic and potential energy at the end over that at the start.</summary>
        public double EnergyRatio { get; private set; }

        /// <summary>T per second.</summary>
        public static double TimeScale => Math.Sqrt(2 * FluidRun.Gravity / Width);

        /// <param name="across">Particles across the water: a/d.</param>
        /// <param name="thickness">Particles from the front to the back wall.</param>
        public static ExperimentScene Scene(int across, int thickness = 8) => ExperimentScene.Block("dam break",
            new int3(across, 2 * across, thickness), new int3(10 * across, 5 * across / 2, thickness), (float)(Width / across));

        public static DamBreakFront Run(int across, in StepInput input, int thickness = 8)
        {
            using var run = new FluidRun(Scene(across, thickness), input);
            double start = run.Measure().Energy;
            var points = new List<(double T, double Z)> { (0, FrontOf(run, across)) };
            while (run.Time * TimeScale < End)
            {
                run.Step();
                points.Add((run.Time * TimeScale, FrontOf(run, across)));
            }
            double halfStep = 0.5 * run.Substep * TimeScale;
            return new DamBreakFront
            {
                Front = new FrontSeries("front", points),
                FrontHalfStepLater = new FrontSeries("front", points.Select(point => (point.T + halfStep, point.Z)).Prepend(points[0])),
                EnergyRatio = run.Measure().Energy / start,
            };
        }

        static double FrontOf(FluidRun run, int across) => Percentile.Of(run.ReadPositions().Select(p => p.x).ToArray(), Fraction) / across;
    }
}
