using System;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Exclusive prefix sum of unsigned counts on the GPU, recorded into the caller's command buffer.</summary>
    /// <remarks>
    /// Reduce-then-scan in two dispatches, three above <see cref="FewTiles"/> tiles; any count from 0 to the capacity. Sums wrap at 2^32.
    /// The counts are cleared
    /// as they are read. Owns only its scratch: one uint per <see cref="Tile"/> elements.
    /// </remarks>
    sealed class PrefixSum : IDisposable
    {
        /// <summary>elements that one thread group scans</summary>
        [GenerateHlsl("PrefixSum")] public const int Tile = 2048;

        /// <summary>Tiles whose sums every group can add up by itself: eight for each of its threads.</summary>
        public const int FewTiles = Tile;

        /// <summary>Most elements one instance can take: a tile for each of the 65,535 groups of a dispatch.</summary>
        public const int MaxCapacity = ThreadGroups.MaxGroups * Tile;

        readonly ComputeShader shader;
        readonly Kernel sumTiles, scanTileSums, scanTiles, scanFewTiles;
        GraphicsBuffer tileSums;

        /// <param name="shader">PrefixSum.compute.</param>
        /// <param name="capacity">Most elements of a later <see cref="Record"/>, 1 to <see cref="MaxCapacity"/>.</param>
        /// <exception cref="ArgumentOutOfRangeException">The capacity is out of range.</exception>
        public PrefixSum(ComputeShader shader, int capacity)
        {
            if (capacity < 1 || capacity > MaxCapacity)
                throw Limit.OutOfRange(nameof(capacity), capacity, Invariant($"A prefix sum takes 1 to {MaxCapacity:N0} ") +
                    "elements.");

            this.shader = shader;
            Capacity = capacity;
            sumTiles = new Kernel(shader, "SumTiles");
            scanTileSums = new Kernel(shader, "ScanTileSums");
            scanTiles = new Kernel(shader, "ScanTiles");
            scanFewTiles = new Kernel(shader, "ScanFewTiles");
            tileSums = GpuBuffer.Structured<uint>("Rill.PrefixSum.TileSums", TileCount(capacity) + 1);
        }

        public int Capacity { get; }

        /// <summary>Records <c>sums[i] = counts[0] + ... + counts[i - 1]</c>, then <c>counts[i] = 0</c>, for i in [0, count).</summary>
        /// <param name="counts">uint, at least <paramref name="count"/> elements.</param>
        /// <param name="sums">uint, at least <paramref name="count"/> elements; must not be <paramref name="counts"/>.</param>
        /// <exception cref="ArgumentOutOfRangeException">More elements than the capacity.</exception>
        public void Record(CommandBuffer cmd, GraphicsBuffer counts, GraphicsBuffer sums, int count)
        {
            if (count < 0 || count > Capacity)
                throw Limit.OutOfRange(nameof(count), count, "This prefix sum was created for up to " +
                    Invariant($"{Capacity:N0} elements."));
            if (count == 0)
                return;

            int tiles = TileCount(count);
            Ids.Sum.Bind(cmd, shader, sumTiles, count, tiles, counts, tileSums);
            cmd.DispatchCompute(shader, sumTiles, tiles, 1, 1);

            bool few = IsFew(tiles);
            if (!few)
            {
                cmd.SetComputeBufferParam(shader, scanTileSums, Ids.TileSums, tileSums);
                cmd.DispatchCompute(shader, scanTileSums, 1, 1, 1);
            }

            int scan = few ? scanFewTiles : scanTiles;
            Ids.Scan.Bind(cmd, shader, scan, counts, tileSums, sums);
            cmd.DispatchCompute(shader, scan, tiles, 1, 1);
        }

        public void Dispose() => GpuBuffer.Release(ref tileSums);

        public void Describe(StageDescription stage, int perStep)
        {
            DescribeKernels(stage, perStep);
            stage.Buffer("Rill.PrefixSum.TileSums", tileSums);
        }

        /// <summary>For sums of as many elements as the capacity.</summary>
        public void DescribeKernels(StageDescription stage, int perStep)
        {
            stage.Kernel(sumTiles, perStep);
            bool few = IsFew(TileCount(Capacity));
            if (!few)
                stage.Kernel(scanTileSums, perStep);
            stage.Kernel(few ? scanFewTiles : scanTiles, perStep);
        }

        static bool IsFew(int tiles) => tiles <= FewTiles;

        static int TileCount(int count) => (count + Tile - 1) / Tile;

        static class Ids
        {
            public static readonly ShaderParameters Sum = new ShaderParameters("_Count", "_TileCount", "_Counts", "_TileSums");
            public static readonly ShaderParameters Scan = new ShaderParameters("_Counts", "_TileSums", "_Sums");
            public static readonly int TileSums = Shader.PropertyToID("_TileSums");
        }
    }
}
