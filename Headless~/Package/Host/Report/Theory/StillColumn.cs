using System;
using System.Collections.Generic;
using System.Linq;
using Host.Experiments;
using Rill;
using Unity.Mathematics;

namespace Host.Report
{
    /// <summary>
    /// Water that fills a box at rest: its pressure against rest density times g times depth, and its height.
    /// </summary>
    /// <remarks>
    /// A potential φ displaces by −∇φ within a substep, which changes the velocity by −∇φ/Δt, as a pressure does in Δt by
    /// −∇p Δt/ρ: p = ρ φ/Δt². Both potentials act so, and what the Jacobi iterations push is not in it. φ is in d² on the GPU.
    /// </remarks>
    sealed class StillColumn
    {
        const double AverageSeconds = 1;
        const int AverageEvery = 3;

        /// <summary>Height of a layer of coarse cells' centers, m; pressure from the potentials and rest density · g · depth, Pa.</summary>
        public readonly List<(double Height, double Pressure, double Theory)> Layers = new();
        /// <summary>Height as twice that of the center of mass, over the initial one.</summary>
        public double HeightRatio { get; private set; }
        /// <summary>Pressure on the floor by theory, Pa.</summary>
        public double BottomPressure { get; private set; }

        /// <summary>Error of the lowest layer of cells, over the pressure on the floor.</summary>
        public double BottomError => (Layers[0].Pressure - Layers[0].Theory) / BottomPressure;
        /// <summary>Largest of all layers but the one at the surface, over the pressure on the floor.</summary>
        public double MaxError => Layers.Max(layer => Math.Abs(layer.Pressure - layer.Theory)) / BottomPressure;

        /// <param name="settle">Fluid time before the second over which is averaged, s.</param>
        public static StillColumn Run(int layers, int width, float spacing, in StepInput input, double settle)
        {
            var scene = ExperimentScene.Block("column", new int3(width, layers, width), new int3(width, layers * 3 / 2, width), spacing);
            using var run = new FluidRun(scene, input);
            var column = new StillColumn();
            double rest = layers * spacing, height = 0;
            double[] sums = null;
            int samples = 0;
            while (run.Time < settle + AverageSeconds)
            {
                run.Step();
                if (run.Time <= settle || run.Steps % AverageEvery != 0)
                    continue;
                double[] pressures = Pressures(run);
                sums = sums == null ? pressures : sums.Zip(pressures, (a, b) => a + b).ToArray();
                height += 2 * run.Measure().centerOfMass.y;
                samples++;
            }
            double cell = run.Solver.Coarse.Grid.CellSize.y * spacing, weight = input.material.density * FluidRun.Gravity;
            for (int y = 0; y < sums.Length && (y + 1) * cell <= rest; y++)
                column.Layers.Add(((y + 0.5) * cell, sums[y] / samples, weight * (rest - (y + 0.5) * cell)));
            column.HeightRatio = height / samples / rest;
            column.BottomPressure = weight * rest;
            return column;
        }

        // Mean over each layer of coarse cells, Pa.
        static double[] Pressures(FluidRun run)
        {
            CoarseCorrection coarse = run.Solver.Coarse
                ?? throw new HostException("The column's pressure is that of the coarse grid: turn deep water on.");
            float[] flow = FluidRun.Read<float>(coarse.Cells.flowPotential, coarse.Grid.Total);
            float[] error = FluidRun.Read<float>(coarse.Cells.errorPotential, coarse.Grid.Total);
            double perPotential = run.Input.material.density * Math.Pow(run.Solver.Layout.Spacing / run.Substep, 2);
            int3 counts = coarse.Grid.Counts;
            var pressures = new double[counts.y];
            for (int cell = 0; cell < coarse.Grid.Total; cell++)
                pressures[cell / counts.x % counts.y] += perPotential * (flow[cell] + error[cell]) / (counts.x * counts.z);
            return pressures;
        }
    }
}
