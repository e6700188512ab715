using System;
using System.Collections.Generic;
using System.Linq;
using Rill;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace Host.Bench
{
    /// <summary>
    /// Times the step that a fluid would take from the same state without its colliders: what these cost is the difference. Water that never met
    /// colliders moves otherwise, and takes another time by itself.
    /// </summary>
    sealed class SameWater : IDisposable
    {
        readonly PbfSolver solver;
        readonly StepInput input;
        readonly CommandBuffer cmd = new CommandBuffer { name = "bench" };
        readonly float4[] vectors;
        readonly uint[] ids;
        readonly List<double> milliseconds = new List<double>();

        /// <param name="input">Of the step; its colliders are left out.</param>
        /// <param name="positions">m, as many as the fluid has particles, anywhere.</param>
        /// <param name="velocities">m/s.</param>
        public SameWater(SolverLayout layout, StepInput input, NativeArray<float4> positions, NativeArray<float4> velocities)
        {
            this.input = input;
            this.input.colliders = null;
            vectors = new float4[positions.Length];
            ids = new uint[positions.Length];
            solver = new PbfSolver(layout);
            solver.Add(positions, velocities);
            StepTimes.Time(Player.Device, cmd, solver, this.input);        // makes its stages
        }

        public StepTimes.Spread Times => StepTimes.Spread.Of(milliseconds);

        /// <summary>Takes over the state of a fluid and times its next step.</summary>
        public void Time(PbfSolver among)
        {
            Copy(among.Positions, solver.Positions, vectors);
            Copy(among.Velocities, solver.Velocities, vectors);
            Copy(among.ParticleIds, solver.ParticleIds, ids);
            if (among.Coarse != null && solver.Coarse != null)
            {
                var cells = new float[among.Coarse.Grid.Total];
                Copy(among.Coarse.Cells.lastErrors, solver.Coarse.Cells.lastErrors, cells);
                Copy(among.Coarse.Cells.flowPotential, solver.Coarse.Cells.flowPotential, cells);
                Copy(among.Coarse.Cells.errorPotential, solver.Coarse.Cells.errorPotential, cells);
            }
            milliseconds.Add(StepTimes.Time(Player.Device, cmd, solver, input).First(sample => sample.Name == StepTimes.Step).Milliseconds);
        }

        public void Dispose()
        {
            solver.Dispose();
            cmd.Dispose();
        }

        static void Copy<T>(GraphicsBuffer from, GraphicsBuffer to, T[] through) where T : struct
        {
            from.GetData(through, 0, 0, through.Length);
            to.SetData(through, 0, 0, through.Length);
        }
    }
}
