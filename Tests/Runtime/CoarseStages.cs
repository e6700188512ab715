using System;
using System.Linq;
using Rill.Tests.Reference;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>A coarse correction alone over given particles: its two halves run at once, all that they have to write garbage before.</summary>
    sealed class CoarseStages : IDisposable
    {
        public const float TimeStep = 1f / 60f;

        public readonly CoarseCorrection Correction;
        readonly ParticleState state;
        readonly ParticleBuffers particles;
        readonly GraphicsBuffer constants;

        /// <param name="gravity">m/s².</param>
        public CoarseStages(ParticleState state, float3 gravity = default, float cellSize = 4f)
        {
            this.state = state;
            var input = SolverStages.Still();
            input.timeStep = TimeStep;
            input.gravity = gravity;
            var layout = new SolverLayout(state.box * SolverStages.Spacing, SolverStages.Spacing, state.Count + 5, 96, 1f);
            particles = new ParticleBuffers(state.Count + 5);
            state.WriteTo(particles);
            uint[] counters = GpuTest.Read<uint>(particles.Counters, ParticleBuffers.CounterCount);
            counters[(int)ParticleCounter.Sorted] = (uint)state.Count;
            particles.Counters.SetData(counters);
            particles.SortedArguments.SetData(ParticleState.ArgumentsFor(state.Count));
            constants = GpuTest.UploadConstants(SolverConstants.For(layout, input, 1));
            Correction = new CoarseCorrection(layout, cellSize);
            foreach (GraphicsBuffer buffer in new[] { Correction.Cells.flow, Correction.Cells.fill, Correction.Cells.source, Correction.Cells.diagonal, Correction.Displacements, Correction.DensityErrors })
                GpuTest.FillWithGarbage(buffer);
        }

        public CoarseGrid Grid => Correction.Grid;

        /// <summary>The reference's cells over the same particles; those that are not finite are in none.</summary>
        public CoarseCells Cells
        {
            get
            {
                double3[] finite = Compare.Points(state.positions.Where((p, i) => math.all(math.isfinite(p.xyz)) && math.all(math.isfinite(state.velocities[i].xyz))).ToArray());
                return new CoarseCells(state.box, Grid.Counts).Fill(finite);
            }
        }

        public float[] Fill => Read(Correction.Cells.fill);
        public float[] Source => Read(Correction.Cells.source);
        public float[] Diagonal => Read(Correction.Cells.diagonal);
        public float[] LastErrors => Read(Correction.Cells.lastErrors);
        public float[] FlowPotential => Read(Correction.Cells.flowPotential);
        public float[] ErrorPotential => Read(Correction.Cells.errorPotential);
        public float4[] Flow => GpuTest.Read<float4>(Correction.Cells.flow, Grid.Total);
        public float4[] Displacements => GpuTest.Read<float4>(Correction.Displacements, Grid.Total);
        public float4[] Velocities => GpuTest.Read<float4>(particles.Velocities, state.Count);
        public uint[] Bins => GpuTest.Read<uint>(Correction.Cells.bins, Correction.Cells.bins.count);

        public CoarseStages Project()
        {
            GpuTest.Run(cmd => Correction.RecordProjection(cmd, constants, particles));
            return this;
        }

        public CoarseStages CorrectDensity(float[] errors)
        {
            if (errors.Length > 0)
                Correction.DensityErrors.SetData(errors, 0, 0, errors.Length);
            GpuTest.Run(cmd => Correction.RecordDensity(cmd, constants, particles, particles.Current));
            return this;
        }

        public void Dispose()
        {
            Correction.Dispose();
            particles.Dispose();
            constants.Release();
        }

        float[] Read(GraphicsBuffer buffer) => GpuTest.Read<float>(buffer, Grid.Total);
    }
}
