using System;
using System.Collections.Generic;
using Host.Report.Obstacles;
using Rill;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Host.Report
{
    /// <summary>
    /// Water in a U-shaped tube, let go with its two levels apart: two legs and a passage below, all of one width, around a box that
    /// stands off the floor. It swings as a whole; ideal water would swing on.
    /// </summary>
    static class UTube
    {
        /// <summary>From the front to the back wall, d.</summary>
        public const int Thickness = 8;

        /// <summary>
        /// Inertia of the square where two channels of one width meet at a right angle, over that of a straight square: 1 − 2 ln 2 / π.
        /// </summary>
        /// <remarks>
        /// A flow that starts from rest is a potential flow, and its inertia over a length is the drop of the potential at a flux of 1: the
        /// resistance of a conducting sheet of that shape, of which a corner square is 0.559 of a square (Hall 1967). The center line counts 1.
        /// </remarks>
        public static readonly double CornerFraction = 1 - 2 * Math.Log(2) / Math.PI;

        /// <summary>Length of the water along the center line, d.</summary>
        /// <param name="width">Of the legs and of the passage, d.</param>
        /// <param name="gap">Between the legs, d.</param>
        /// <param name="depth">In the legs where both are level, from the floor, d.</param>
        public static double MiddleLine(double width, double gap, double depth) => 2 * (depth - width / 2) + gap + width;

        /// <summary>Length of a straight tube with the same inertia, d.</summary>
        public static double StraightLength(double width, double gap, double depth)
            => MiddleLine(width, gap, depth) - 2 * (1 - CornerFraction) * width;

        /// <summary>T = 2π √(L / 2g), s.</summary>
        /// <param name="length">L, m.</param>
        public static double Period(double length) => 2 * Math.PI * Math.Sqrt(length / (2 * FluidRun.Gravity));

        /// <summary>How far the right level is above that of rest, d, over time, from the center of mass; s.</summary>
        /// <param name="height">Of the left level above that of rest at first, d.</param>
        /// <param name="spacing">m.</param>
        public static List<(double Time, double Value)> Run(int width, int gap, int depth, int height, float spacing, in StepInput input,
            double seconds)
        {
            int length = 2 * width + gap;
            var positions = new List<float3>();
            var random = new Random(7);
            FluidRun.AddBlock(positions, 0f, new int3(width, depth + height, Thickness), ref random);
            FluidRun.AddBlock(positions, new float3(width, 0f, 0f), new int3(gap, width, Thickness), ref random);
            FluidRun.AddBlock(positions, new float3(width + gap, 0f, 0f), new int3(width, depth - height, Thickness), ref random);
            float top = depth + 2 * height + width;
            using var run = new FluidRun("U-tube", new float3(length, top, Thickness), spacing, positions, _ => 0f, input);
            run.Use(Solids.Box(new float3(width, width, -width), new float3(width + gap, top + width, Thickness + width)));
            // Water that left one leg is in the other, as far away as their centers: that moves the center of mass.
            double perLevel = (double)width * Thickness * (width + gap) / positions.Count * spacing, center = length / 2.0 * spacing;
            var samples = new List<(double, double)>();
            while (run.Time < seconds)
            {
                run.Step();
                if (run.Steps % 2 == 0)
                    samples.Add((run.Time, (run.Measure().centerOfMass.x - center) / perLevel));
            }
            return samples;
        }
    }
}
