using System;
using System.Collections.Generic;
using Host.Experiments;
using Rill;
using Unity.Mathematics;

namespace Host.Report
{
    /// <summary>
    /// The first sloshing mode of water in a box 1 m long: level water in gravity that leans a little swings about the
    /// surface that is level to that gravity, and its center of mass with it.
    /// </summary>
    static class Sloshing
    {
        const double Length = 1;

        /// <summary>From the front to the back wall, d.</summary>
        public const int Thickness = 8;

        /// <summary>Linear waves: ω² = g k tanh(k H), k = π/L (Lamb, Hydrodynamics, §257).</summary>
        public static double Period(double depth)
        {
            double k = Math.PI / Length;
            return 2 * Math.PI / Math.Sqrt(FluidRun.Gravity * k * Math.Tanh(k * depth));
        }

        /// <summary>Center of the box, m.</summary>
        public const double Center = Length / 2;

        /// <summary>How far from the center the center of mass lies under a surface that is level to leaning gravity, m.</summary>
        public static double Offset(double depth, double lean) => Length * Length * Math.Tan(lean) / (12 * depth);

        /// <summary>Height of the wave at the wall, from its center, m.</summary>
        public static double Wave(double lean) => Length / 2 * Math.Tan(lean);

        /// <summary>Layers of water that come nearest to a depth, which is a whole number of them.</summary>
        public static double NearestDepth(int particlesAlong, double depth) => Math.Round(depth * particlesAlong) / particlesAlong * Length;

        /// <summary>The center of mass along the box over time, m.</summary>
        /// <param name="depth">m, a multiple of the spacing.</param>
        /// <param name="lean">Of gravity from the vertical, rad.</param>
        public static List<(double Time, double Value)> Run(int particlesAlong, double depth, double lean, StepInput input, double seconds)
        {
            float spacing = (float)(Length / particlesAlong);
            int layers = (int)Math.Round(depth / Length * particlesAlong);
            input.gravity = FluidRun.Gravity * new float3((float)Math.Sin(lean), (float)-Math.Cos(lean), 0f);
            using var run = new FluidRun(ExperimentScene.Block("sloshing", new int3(particlesAlong, layers, Thickness),
                new int3(particlesAlong, layers + particlesAlong / 4, Thickness), spacing), input);
            var samples = new List<(double, double)>();
            while (run.Time < seconds)
            {
                run.Step();
                if (run.Steps % 2 == 0)
                    samples.Add((run.Time, run.Measure().centerOfMass.x));
            }
            return samples;
        }
    }
}
