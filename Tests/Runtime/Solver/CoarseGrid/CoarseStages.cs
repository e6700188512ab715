using System;
using System.Linq;
using Rill.Tests.Reference;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill.Tests
{
    /// <summary>
    /// A coarse correction alone over given particles: its two halves run at once, all that they have to write garbage before.
    /// The sort that takes up the projection runs with it; the density constraint's errors are binned here.
    /// </summary>
    sealed class CoarseStages : IDisposable
    {
        public const float TimeStep = 1f / 60f;
        const uint SurfaceFlags = 15;       // kSurfaceFlags

        public readonly CoarseCorrection Correction;
        readonly ParticleState state;
        readonly SolverLayout layout;
        readonly StepInput input;
        readonly ParticleBuffers particles;
        readonly NeighborSearch search;
        readonly GraphicsBuffer constants;
        readonly Colliders colliders;
        bool isProjected;

        /// <param name="gravity">m/s².</param>
        /// <param name="substeps">In which the device takes <see cref="TimeStep"/>; what this class computes itself is for one.</param>
        /// <param name="openFaces">Ends of the box that neighbors cover, see SolverConstants.openFaces.</param>
        /// <param name="solids">d; null for none.</param>
        public CoarseStages(ParticleState state, float3 gravity = default, float cellSize = 4f, int substeps = 1, uint openFaces = 0,
            ColliderMotion[] solids = null)
        {
            this.state = state;
            Gravity = gravity;
            input = SolverStages.Still();
            input.timeStep = TimeStep;
            input.settings.substeps = substeps;
            input.gravity = gravity;
            layout = new SolverLayout(state.box * SolverStages.Spacing, SolverStages.Spacing, state.Count + 5, 96, 1f);
            if (solids != null)
            {
                (input.colliders, input.frameTo) = (new ColliderSet { Count = solids.Length, Version = 1 }, 1f);
                solids.CopyTo(input.colliders.Items, 0);
                colliders = new Colliders(layout);
            }
            particles = new ParticleBuffers(state.Count + 5);
            state.WriteTo(particles);
            search = new NeighborSearch(layout);
            SolverConstants values = SolverConstants.For(layout, input, 1);
            values.openFaces = openFaces;
            constants = GpuTest.UploadConstants(values);
            Correction = new CoarseCorrection(layout, cellSize);
            foreach (GraphicsBuffer buffer in new[] { Correction.Cells.flow, Correction.Cells.fill, Correction.Cells.source,
                Correction.Cells.diagonal, Correction.Displacements })
                GpuTest.FillWithGarbage(buffer);
        }

        /// <summary>m/s².</summary>
        public float3 Gravity { get; }

        public CoarseGrid Grid => Correction.Grid;

        /// <summary>The reference's cells over the same particles.</summary>
        public CoarseCells Cells => new CoarseCells(state.box, Grid.Counts).Fill(Compare.Points(state.positions));

        /// <summary>Those of the projection: over where the particles' flow takes them; those that are not finite are in none.</summary>
        public CoarseCells FlowCells => new CoarseCells(state.box, Grid.Counts).Fill(AlongFlow.Where(p => math.all(math.isfinite(p))).ToArray());

        /// <summary>Position to which flow alone takes each particle in the substep, d; not finite if one of its numbers is not.</summary>
        public double3[] AlongFlow => state.positions.Select((p, i) => AlongFlowOf(p.xyz, state.velocities[i].xyz, state.box, Gravity)).ToArray();

        /// <param name="p">d, <paramref name="velocity"/> d/s, <paramref name="gravity"/> m/s².</param>
        public static double3 AlongFlowOf(float3 p, float3 velocity, float3 box, float3 gravity) =>
            math.all(math.isfinite(p)) && math.all(math.isfinite(velocity))
                ? math.clamp((double3)p + (double3)velocity * TimeStep + (double3)gravity / SolverStages.Spacing * TimeStep * TimeStep,
                    new double3(0.5), (double3)box - 0.5)
                : new double3(double.NaN);

        public float[] Fill => Read(Correction.Cells.fill);
        public float[] SurfaceFill => GpuTest.Read<uint>(Correction.Cells.surface, Grid.Total)
            .Select(surface => math.asfloat(surface & ~SurfaceFlags)).ToArray();
        public float[] Source => Read(Correction.Cells.source);
        public float[] Diagonal => Read(Correction.Cells.diagonal);
        public float[] LastErrors => Read(Correction.Cells.lastErrors);
        public float[] FlowPotential => Read(Correction.Cells.flowPotential);
        public float[] ErrorPotential => Read(Correction.Cells.errorPotential);
        public float4[] Flow => GpuTest.Read<float4>(Correction.Cells.flow, Grid.Total);
        public float4[] Displacements => GpuTest.Read<float4>(Correction.Displacements, Grid.Total);
        public float4[] Velocities => GpuTest.Read<float4>(particles.Velocities, state.Count);
        public uint[] Bins => GpuTest.Read<uint>(Correction.Bins, Correction.Bins.count);

        StepContext Context(CommandBuffer cmd)
            => new StepContext(cmd, constants, particles, search, null, layout, input, Correction, colliders: colliders);

        /// <summary>Projects beside the solids, and leaves the particles as they are.</summary>
        public CoarseStages ProjectBesideSolids()
        {
            GpuTest.Run(cmd =>
            {
                StepContext step = Context(cmd);
                colliders.RecordSubstep(step, 0);
                Correction.RecordColliders(step);
                Correction.RecordProjection(step);
            });
            return this;
        }

        public CoarseStages Project()
        {
            isProjected = true;
            GpuTest.Run(cmd =>
            {
                StepContext step = Context(cmd);
                Correction.RecordProjection(step);
                search.RecordSort(step, takesProjection: true);
            });
            return this;
        }

        public CoarseStages CorrectDensity(float[] errors)
        {
            if (!isProjected)       // which finds the surface for both
                Correction.Cells.surface.SetData(Cells.fill.Select(fill => math.asuint((float)fill) & ~SurfaceFlags).ToArray());
            Correction.Bins.SetData(ErrorBins(Grid, state.box, state.positions, errors));
            GpuTest.Run(cmd => Correction.RecordDensity(Context(cmd)));
            return this;
        }

        public void Dispose()
        {
            Correction.Dispose();
            colliders?.Dispose();
            particles.Dispose();
            search.Dispose();
            constants.Release();
        }

        /// <summary>Sums by CoarseBins.hlsl for density errors: in a cell's 8 words their number and 64 bits of the sum.</summary>
        public static uint[] ErrorBins(CoarseGrid grid, float3 box, float4[] positions, float[] errors)
        {
            var bins = new uint[grid.Total * 8];
            for (int i = 0; i < positions.Length; i++)
            {
                int3 cell = math.min((int3)(positions[i].xyz / box * grid.Counts), grid.Counts - 1);
                int bin = ((cell.z * grid.Counts.y + cell.y) * grid.Counts.x + cell.x) * 8;
                ulong sum = ((ulong)bins[bin + 2] << 32 | bins[bin + 1])
                    + (ulong)Math.Round((Math.Min(Math.Max(errors[i], -0.1), 8.0) + 0.1) * 65536.0);
                bins[bin]++;
                bins[bin + 1] = (uint)sum;
                bins[bin + 2] = (uint)(sum >> 32);
            }
            return bins;
        }

        float[] Read(GraphicsBuffer buffer) => GpuTest.Read<float>(buffer, Grid.Total);
    }
}
