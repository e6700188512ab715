using System;
using System.Linq;
using Rill.Tests.Reference;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>
    /// A coarse correction alone over given particles: its two halves run at once, all that they have to write garbage before.
    /// The sort that takes up the projection runs with it; the density constraint's errors are binned here.
    /// </summary>
    sealed class CoarseStages : IDisposable
    {
        public const float TimeStep = 1f / 60f;

        public readonly CoarseCorrection Correction;
        readonly ParticleState state;
        readonly ParticleBuffers particles;
        readonly NeighborSearch search;
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
            search = new NeighborSearch(layout);
            constants = GpuTest.UploadConstants(SolverConstants.For(layout, input, 1));
            Correction = new CoarseCorrection(layout, cellSize);
            foreach (GraphicsBuffer buffer in new[] { Correction.Cells.flow, Correction.Cells.fill, Correction.Cells.source, Correction.Cells.diagonal, Correction.Displacements })
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
        public uint[] Bins => GpuTest.Read<uint>(Correction.Bins, Correction.Bins.count);

        public CoarseStages Project()
        {
            GpuTest.Run(cmd =>
            {
                Correction.RecordProjection(cmd, constants, particles);
                search.RecordSort(cmd, constants, particles, Correction);
            });
            return this;
        }

        public CoarseStages CorrectDensity(float[] errors)
        {
            Correction.Bins.SetData(ErrorBins(Grid, state.box, state.positions, errors));
            GpuTest.Run(cmd => Correction.RecordDensity(cmd, constants));
            return this;
        }

        public void Dispose()
        {
            Correction.Dispose();
            particles.Dispose();
            search.Dispose();
            constants.Release();
        }

        /// <summary>What CoarseBins.hlsl sums for density errors: in a cell's 8 words their number and 64 bits of the sum.</summary>
        public static uint[] ErrorBins(CoarseGrid grid, float3 box, float4[] positions, float[] errors)
        {
            var bins = new uint[grid.Total * 8];
            for (int i = 0; i < positions.Length; i++)
            {
                int3 cell = math.min((int3)(positions[i].xyz / box * grid.Counts), grid.Counts - 1);
                int bin = ((cell.z * grid.Counts.y + cell.y) * grid.Counts.x + cell.x) * 8;
                ulong sum = ((ulong)bins[bin + 2] << 32 | bins[bin + 1]) + (ulong)Math.Round((Math.Min(Math.Max(errors[i], -0.1), 8.0) + 0.1) * 65536.0);
                bins[bin]++;
                bins[bin + 1] = (uint)sum;
                bins[bin + 2] = (uint)(sum >> 32);
            }
            return bins;
        }

        float[] Read(GraphicsBuffer buffer) => GpuTest.Read<float>(buffer, Grid.Total);
    }
}
