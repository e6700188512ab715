using System;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>What solid obstacles leave open of the coarse grid, for its solves: made when deep water and colliders meet.</summary>
    sealed class CoarseSolids : IDisposable
    {
        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.CoarseSolids");

        readonly ComputeShader shader = StageShader.LoadCompute("CoarseSolids");
        readonly CoarseGrid grid;
        readonly int openCells;
        int seen = -1;
        bool recorded;
        GraphicsBuffer open, flow, surfaces;

        public CoarseSolids(CoarseGrid grid)
        {
            this.grid = grid;
            openCells = shader.FindKernel("OpenCells");
            open = GpuBuffer.Structured<uint>("Rill.Coarse.OpenShares", grid.Total);
            flow = GpuBuffer.Structured<Unity.Mathematics.float4>("Rill.Coarse.SolidFlow", grid.Total);
            surfaces = GpuBuffer.Structured<Unity.Mathematics.float4>("Rill.Coarse.SolidSurfaces", grid.Total);
        }

        /// <summary>uint [cells], see PackOpen in CoarseSolids.hlsl.</summary>
        public GraphicsBuffer Open => open;

        /// <summary>float4 [cells], xyz displacement of the solid at the low faces in the substep, d.</summary>
        public GraphicsBuffer Flow => flow;

        /// <summary>Records what is open in this substep: nothing where all obstacles rest as they did.</summary>
        public void Record(CommandBuffer cmd, GraphicsBuffer constants, GraphicsBuffer coarseConstants, Colliders colliders)
        {
            Reacting = colliders.Reactions != null ? colliders : null;
            recorded = colliders.Changes != seen;
            if (!recorded)
                return;
            seen = colliders.Changes;
            cmd.BeginSample(Marker);
            cmd.SetComputeConstantBufferParam(shader, SolverIds.Constants, constants, 0, constants.stride);
            cmd.SetComputeConstantBufferParam(shader, CoarseIds.Constants, coarseConstants, 0, coarseConstants.stride);
            colliders.BindShapes(cmd, shader, openCells);
            cmd.SetComputeBufferParam(shader, openCells, Ids.OpenCells, open);
            cmd.SetComputeBufferParam(shader, openCells, Ids.CellFlow, flow);
            cmd.SetComputeBufferParam(shader, openCells, Ids.CellSurfaces, surfaces);
            CoarseGrid.Dispatch(cmd, shader, openCells, grid.Total);
            cmd.EndSample(Marker);
        }

        /// <summary>Records what a kernel of the coarse grid reads.</summary>
        public void Bind(CommandBuffer cmd, ComputeShader reader, int kernel)
        {
            cmd.SetComputeBufferParam(reader, kernel, Ids.OpenShares, open);
            cmd.SetComputeBufferParam(reader, kernel, Ids.SolidFlow, flow);
            cmd.SetComputeBufferParam(reader, kernel, Ids.SolidSurfaces, surfaces);
        }

        /// <summary>Sums the pressure on the solids; null where none wants to know.</summary>
        public Colliders Reacting { get; private set; }

        public void Describe(StageDescription description, int substeps)
        {
            if (recorded)
                description.Kernel("CoarseSolids", "OpenCells", substeps);
            description.Buffer("Rill.Coarse.OpenShares", open);
            description.Buffer("Rill.Coarse.SolidFlow", flow);
            description.Buffer("Rill.Coarse.SolidSurfaces", surfaces);
        }

        public void Dispose()
        {
            GpuBuffer.Release(ref open);
            GpuBuffer.Release(ref flow);
            GpuBuffer.Release(ref surfaces);
        }

        static class Ids
        {
            public static readonly int OpenCells = Shader.PropertyToID("_OpenCells");
            public static readonly int CellFlow = Shader.PropertyToID("_CellFlow");
            public static readonly int CellSurfaces = Shader.PropertyToID("_CellSurfaces");
            public static readonly int OpenShares = Shader.PropertyToID("_OpenShares");
            public static readonly int SolidFlow = Shader.PropertyToID("_SolidFlow");
            public static readonly int SolidSurfaces = Shader.PropertyToID("_SolidSurfaces");
        }
    }
}
