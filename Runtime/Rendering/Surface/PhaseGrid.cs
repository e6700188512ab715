using System;
using Unity.Mathematics;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Tells which phases the water of a mesh is of, found once a frame for all cameras; see WaterPhases.compute.</summary>
    sealed class PhaseGrid : IDisposable
    {
        /// <summary>phases that have looks of their own, those beyond counting as the last</summary>
        [GenerateHlsl("PhaseGrid")] public const int MaxPhases = 4;

        const float MinCell = 2f;           // d
        const int MaxNodes = 1 << 21;

        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.Water.Phases");

        readonly ComputeShader shader = StageShader.LoadCompute("WaterInside");
        readonly CommandBuffer commands = new CommandBuffer { name = "Rill.Water.Phases" };
        readonly Kernel count, store;
        readonly float3 domainSize;
        readonly int3 nodes;
        readonly Vector4 size;
        GraphicsBuffer counts;
        RenderTexture texture;

        /// <param name="domainSize">d.</param>
        public PhaseGrid(float3 domainSize)
        {
            this.domainSize = domainSize;
            count = new Kernel(shader, "CountPhases");
            store = new Kernel(shader, "StorePhases");
            float cell = CellFor(domainSize, SystemInfo.maxTexture3DSize);
            nodes = NodesOf(domainSize, cell);
            size = new Vector4(nodes.x, nodes.y, nodes.z, cell);
            texture = GpuTexture.Create("Rill.Water.PhaseGrid", new RenderTextureDescriptor(nodes.x, nodes.y, GraphicsFormat.R16G16B16A16_SFloat,
                GraphicsFormat.None)
            { dimension = TextureDimension.Tex3D, volumeDepth = nodes.z, enableRandomWrite = true }, FilterMode.Bilinear);
            counts = GpuBuffer.Structured<uint>("Rill.Water.PhaseCounts", (long)MaxPhases * nodes.x * nodes.y * nodes.z);
            BufferClear.Now(counts);
        }

        /// <summary>Half floats, see PhaseGrid.hlsl.</summary>
        public RenderTexture Texture => texture;

        /// <summary>Distance between the nodes of a box, d: wider where there would be too many.</summary>
        /// <param name="domainSize">d.</param>
        /// <param name="maxAcross">Most of them along an axis.</param>
        public static float CellFor(float3 domainSize, int maxAcross)
        {
            float cell = MinCell;
            for (int3 nodes = NodesOf(domainSize, cell); math.cmax(nodes) > maxAcross || (long)nodes.x * nodes.y * nodes.z > MaxNodes;
                nodes = NodesOf(domainSize, cell))
                cell *= 1.25f;
            return cell;
        }

        /// <summary>Whether it is the grid of a box.</summary>
        /// <param name="box">d.</param>
        public bool IsOf(float3 box) => math.all(box == domainSize);

        /// <summary>Finds the phases of this frame, at once.</summary>
        public void Update(PbfSolver solver)
        {
            commands.Clear();
            commands.BeginSample(Marker);
            commands.SetComputeVectorParam(shader, Ids.Size, size);
            commands.SetComputeBufferParam(shader, count, ParticleIds.Positions, solver.Positions);
            commands.SetComputeBufferParam(shader, count, ParticleIds.Counters, solver.Counters);
            commands.SetComputeBufferParam(shader, count, ParticleTags.Ids.Tags, solver.Tags);
            commands.SetComputeBufferParam(shader, count, Ids.Counts, counts);
            commands.DispatchCompute(shader, count, solver.DrawArguments, GpuBuffer.DispatchArgumentsAt);
            commands.SetComputeBufferParam(shader, store, Ids.Counts, counts);
            commands.SetComputeTextureParam(shader, store, Ids.GridOut, texture);
            shader.GetKernelThreadGroupSizes(store, out uint x, out uint y, out uint z);
            int3 groups = (nodes + new int3((int)x, (int)y, (int)z) - 1) / new int3((int)x, (int)y, (int)z);
            commands.DispatchCompute(shader, store, groups.x, groups.y, groups.z);
            commands.EndSample(Marker);
            Graphics.ExecuteCommandBuffer(commands);
        }

        /// <summary>Sets what PhaseGrid.hlsl reads for a draw.</summary>
        /// <param name="grid">Null where all phases look alike.</param>
        /// <param name="unread">A 3D texture that stands for it then.</param>
        public static void SetOn(MaterialPropertyBlock block, PhaseGrid grid, Texture unread)
        {
            block.SetTexture(Ids.Grid, grid != null ? grid.texture : unread);
            block.SetVector(Ids.Size, grid != null ? grid.size : Vector4.one);
        }

        /// <summary>Sets what PhaseGrid.hlsl reads for a kernel.</summary>
        public void SetOn(CommandBuffer cmd, ComputeShader target, int kernel)
        {
            cmd.SetComputeTextureParam(target, kernel, Ids.Grid, texture);
            cmd.SetComputeVectorParam(target, Ids.Size, size);
        }

        public void Describe(StageDescription stage)
        {
            stage.Kernel(count, 1);
            stage.Kernel(store, 1);
            stage.Buffer("Rill.Water.PhaseCounts", counts);
            stage.Texture(texture);
        }

        public void Dispose()
        {
            commands.Dispose();
            GpuBuffer.Release(ref counts);
            EngineObject.Release(ref texture);
        }

        // The first lie in the walls, the last in them or beyond.
        static int3 NodesOf(float3 domainSize, float cell) => (int3)math.ceil(domainSize / cell) + 1;

        static class Ids
        {
            public static readonly int Counts = Shader.PropertyToID("_PhaseCounts");
            public static readonly int Grid = Shader.PropertyToID("_PhaseGrid");
            public static readonly int GridOut = Shader.PropertyToID("_PhaseGridOut");
            public static readonly int Size = Shader.PropertyToID("_PhaseGridSize");
        }
    }
}
