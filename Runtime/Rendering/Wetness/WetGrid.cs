using System;
using Unity.Mathematics;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Holds when water was last at each node of a grid over a fluid's box; see Wetness.compute.</summary>
    sealed class WetGrid : IDisposable
    {
        /// <summary>stamps in a second of the fluid's time; a stamp has room for 24 days</summary>
        [GenerateHlsl("Wetness")] public const int WetTicks = 1024;

        /// <summary>threads of a group that shifts nodes</summary>
        [GenerateHlsl("Wetness")] const int WetGroup = 64;

        /// <summary>wetness below which a surface counts as dry: less than a step of an 8-bit color</summary>
        [GenerateHlsl("Wetness")] public const float Dry = 1f / 512f;

        const float MinCell = 1f;           // d
        const int MaxNodes = 1 << 21;

        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.Wetness");

        readonly ComputeShader shader = StageShader.LoadCompute("Wetness");
        readonly CommandBuffer commands = new CommandBuffer { name = "Rill.Wetness" };
        readonly Kernel mark, shift;
        readonly BufferClear clear = new BufferClear();
        readonly float3 domainSize;
        readonly int3 nodes;
        readonly Vector4 size;
        float3 origin;          // of the first node, d: -cell to 0
        float3 shifted;         // by all shifts, d
        GraphicsBuffer stamps;
        uint newest;            // stamp of the state that was marked last; 0: none yet

        /// <param name="domainSize">d.</param>
        /// <exception cref="InvalidOperationException">The kernels are not there.</exception>
        public WetGrid(float3 domainSize)
        {
            this.domainSize = domainSize;
            mark = new Kernel(shader, "MarkWet");
            shift = new Kernel(shader, "ShiftWetness");
            float cell = CellFor(domainSize);
            nodes = NodesOf(domainSize, cell);
            size = new Vector4(nodes.x, nodes.y, nodes.z, cell);
            stamps = NewStamps();
            BufferClear.Now(stamps);
        }

        /// <summary>Whether any water was marked yet.</summary>
        public bool HasWater => newest > 0;

        /// <summary>Distance between the nodes of a box, d: wider where there would be too many.</summary>
        /// <param name="domainSize">d.</param>
        public static float CellFor(float3 domainSize)
        {
            float cell = MinCell;
            for (int3 nodes = NodesOf(domainSize, cell); (long)nodes.x * nodes.y * nodes.z > MaxNodes; nodes = NodesOf(domainSize, cell))
                cell *= 1.25f;
            return cell;
        }

        /// <summary>Whether it is the grid of a box.</summary>
        /// <param name="box">d.</param>
        public bool IsOf(float3 box) => math.all(box == domainSize);

        /// <summary>Marks where the water is, at once; does nothing where it was marked at that time already. As time goes back, all dries
        /// first.</summary>
        /// <param name="time">Time of the solver's newest state, s.</param>
        public void Mark(PbfSolver solver, double time)
        {
            uint stamp = StampOf(time);
            if (stamp == newest)
                return;
            commands.Clear();
            commands.BeginSample(Marker);
            if (stamp < newest)
                clear.Record(commands, stamps);
            newest = stamp;
            Ids.Grid.Bind(commands, shader, mark, stamps, size, origin);
            Ids.Mark.Bind(commands, shader, mark, stamp, solver.Positions, solver.Counters);
            commands.DispatchCompute(shader, mark, solver.DrawArguments, GpuBuffer.DispatchArgumentsAt);
            commands.EndSample(Marker);
            Graphics.ExecuteCommandBuffer(commands);
        }

        /// <summary>Follows a box that was put elsewhere and left the water: what lies in it moves on by that much, at once.</summary>
        /// <param name="by">d.</param>
        public void Shift(float3 by)
        {
            float cell = size.w;
            shifted += by;
            float3 moved = math.clamp((origin + by) / cell, -1e6f, 1e6f);
            int3 whole = (int3)math.ceil(moved);
            origin = (moved - whole) * cell;
            if (math.all(whole == 0) || !HasWater)
                return;
            GraphicsBuffer before = stamps;
            stamps = NewStamps();
            commands.Clear();
            commands.BeginSample(Marker);
            Ids.Grid.Bind(commands, shader, shift, stamps, size, origin);
            Ids.Shift.Bind(commands, shader, shift, (float3)whole, before);
            ThreadGroups.Dispatch(commands, shader, shift, ((long)stamps.count + WetGroup - 1) / WetGroup);
            commands.EndSample(Marker);
            Graphics.ExecuteCommandBuffer(commands);
            GpuBuffer.Release(ref before);
        }

        /// <summary>Sets what Wetness.hlsl reads of it.</summary>
        /// <param name="time">Time of the frame, s.</param>
        public void SetOn(MaterialPropertyBlock block, double time)
        {
            Ids.Grid.Set(block, stamps, size, origin);
            Ids.Draw.Set(block, shifted, StampOf(time), newest);
        }

        public void Describe(StageDescription stage)
        {
            stage.Kernel(mark, 1);
            stage.Buffer("Rill.Wetness.Stamps", stamps);
        }

        public void Dispose()
        {
            commands.Dispose();
            GpuBuffer.Release(ref stamps);
        }

        GraphicsBuffer NewStamps() => GpuBuffer.Structured<uint>("Rill.Wetness.Stamps", (long)nodes.x * nodes.y * nodes.z);

        static uint StampOf(double time) => 1u + (uint)Math.Min(Math.Max(time, 0.0) * WetTicks, int.MaxValue - 2);

        // One more than the box needs: the first may lie before it.
        static int3 NodesOf(float3 domainSize, float cell) => (int3)math.ceil(domainSize / cell) + 2;

        static class Ids
        {
            public static readonly ShaderParameters Grid = new ShaderParameters("_WetStamps", "_WetGridSize", "_WetGridOrigin");
            public static readonly ShaderParameters Mark = new ShaderParameters("_WetStamp", "_Positions", "_Counters");
            public static readonly ShaderParameters Shift = new ShaderParameters("_WetShift", "_WetStampsIn");
            public static readonly ShaderParameters Draw = new ShaderParameters("_WetGridShifted", "_WetNow", "_WetStamp");
        }
    }
}
