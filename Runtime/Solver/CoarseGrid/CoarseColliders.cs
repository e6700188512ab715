using System;
using Unity.Mathematics;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Fractions of the coarse grid that solid colliders leave open, for its solves. Made when deep water has colliders.</summary>
    sealed class CoarseColliders : IDisposable
    {
        /// <summary>cells of a group of OpenCells</summary>
        [GenerateHlsl("CoarseGrid")] const int OpenCellsPerGroup = 8;

        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.CoarseColliders");

        readonly ComputeShader shader = StageShader.LoadCompute("CoarseColliders");
        readonly CoarseGrid grid;
        readonly Kernel openCells, linkCells;
        readonly LocalKeyword deforming;
        int seen = -1;
        bool recorded;
        Colliders volume;
        readonly BufferSet buffers = new BufferSet();
        readonly GraphicsBuffer raw, open, centers, flow;

        public CoarseColliders(CoarseGrid grid)
        {
            this.grid = grid;
            openCells = new Kernel(shader, "OpenCells");
            linkCells = new Kernel(shader, "LinkCells");
            deforming = new LocalKeyword(shader, Rill.Colliders.DeformingKeyword);
            raw = buffers.Structured<uint2>("Rill.Coarse.RawOpenFractions", grid.Total, "_RawCells");
            open = buffers.Structured<uint2>("Rill.Coarse.OpenFractions", grid.Total);
            centers = buffers.Structured<uint4>("Rill.Coarse.OpenCenters", grid.Total);
            flow = buffers.Structured<float4>("Rill.Coarse.ColliderFlow", grid.Total);
        }

        /// <summary>uint2 [cells], see PackFaces and PackOpen in CoarseColliders.hlsl.</summary>
        public GraphicsBuffer Open => open;

        /// <summary>uint4 [cells], centers of what is open of a cell and of its low faces, see PackCenter.</summary>
        public GraphicsBuffer Centers => centers;

        /// <summary>float4 [cells], xyz displacement of the solid at the low faces in the substep, d.</summary>
        public GraphicsBuffer Flow => flow;

        /// <summary>Records what is open in this substep: nothing where all colliders rest as they did.</summary>
        public void Record(in StepContext step, GraphicsBuffer coarseConstants)
        {
            CommandBuffer cmd = step.Commands;
            Colliders colliders = step.Colliders;
            volume = colliders;
            Reacting = colliders.Reactions != null ? colliders : null;
            recorded = colliders.Changes != seen;
            if (!recorded)
                return;
            seen = colliders.Changes;
            cmd.BeginSample(Marker);
            cmd.SetKeyword(shader, deforming, colliders.HasDeforming);
            step.BindConstants(shader);
            cmd.SetComputeConstantBufferParam(shader, CoarseIds.Constants, coarseConstants, 0, coarseConstants.stride);
            colliders.BindShapes(cmd, shader, openCells);
            Ids.Open.Bind(cmd, shader, openCells, raw, centers, flow);
            ThreadGroups.Dispatch(cmd, shader, openCells, (grid.Total + OpenCellsPerGroup - 1) / OpenCellsPerGroup);
            buffers.Bind(cmd, shader, linkCells);
            cmd.SetComputeBufferParam(shader, linkCells, Ids.OpenCells, open);
            CoarseGrid.Dispatch(cmd, shader, linkCells, grid.Total);
            cmd.EndSample(Marker);
        }

        /// <summary>Records what a kernel of the coarse grid reads.</summary>
        public void Bind(CommandBuffer cmd, ComputeShader reader, int kernel) => buffers.Bind(cmd, reader, kernel);

        /// <summary>Records how much of the domain the colliders leave, as a kernel reads it.</summary>
        public void BindVolume(CommandBuffer cmd, ComputeShader reader, int kernel) => volume.Bind(cmd, reader, kernel);

        /// <summary>Sums the pressure on the solids; null where none wants to know.</summary>
        public Colliders Reacting { get; private set; }

        public void Describe(StageDescription description, int substeps)
        {
            if (recorded)
            {
                string variant = volume.HasDeforming ? Rill.Colliders.DeformingKeyword : null;
                description.Kernel(openCells, substeps, variant);
                description.Kernel(linkCells, substeps, variant);
            }
            buffers.Describe(description);
        }

        public void Dispose() => buffers.Dispose();

        static class Ids
        {
            public static readonly int OpenCells = Shader.PropertyToID("_OpenCells");
            public static readonly ShaderParameters Open = new ShaderParameters("_OpenCells", "_CellCenters", "_CellFlow");
        }
    }
}
