using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>
    /// The triangles of a bake in their order, which of them are turned, and the bricks of voxels that each of the large
    /// ones reaches. Those of a few voxels are tested against the box around them.
    /// </summary>
    sealed class BakeGeometry
    {
        /// <summary>voxels along a brick</summary>
        [GenerateHlsl("MeshSdf")] public const int Brick = 4;

        /// <summary>voxels around a triangle with exact distances</summary>
        [GenerateHlsl("MeshSdf", Signed = true)] public const int Band = 2;

        /// <summary>Voxels of the box around a triangle that one group of threads takes at most; the boxes of larger ones are mostly far
        /// from them.</summary>
        const int SmallBox = 4096;

        /// <summary>in the bits below a triangle's number: it faces the wrong side</summary>
        [GenerateHlsl("MeshSdf")] const uint Turned = 1;

        /// <summary>and: it is in _Large</summary>
        [GenerateHlsl("MeshSdf")] const uint IsLarge = 2;

        /// <summary>A triangle that reaches more than a few voxels.</summary>
        [GenerateHlsl("MeshSdf")]
        [StructLayout(LayoutKind.Sequential)]
        public struct LargeTriangle
        {
            /// <summary>in the order, that of _Triangles</summary>
            public uint index;
            /// <summary>pairs with bricks of those before, modulo 2^32: a slice spans fewer</summary>
            public uint firstPair;
            public int3 low, bricks;
        }

        /// <summary>Consecutive pairs of large triangles and bricks, for one dispatch.</summary>
        public readonly struct Slice
        {
            public readonly long First;
            public readonly int Count, Low, High;
            public Slice(long first, int count, int low, int high) => (First, Count, Low, High) = (first, count, low, high);
        }

        readonly List<LargeTriangle> large = new List<LargeTriangle>();
        readonly List<long> firstPairs = new List<long> { 0 };

        /// <param name="order">Order of the triangles that take part. It becomes <see cref="Order"/>.</param>
        /// <param name="turned">By triangle of the mesh: those to turn over; null for none.</param>
        /// <param name="turnAll">Whether all triangles face the wrong side.</param>
        /// <param name="splitsLarge">Whether large triangles are taken brick by brick: not where they deform.</param>
        public BakeGeometry(TriangleMesh mesh, uint[] order, bool[] turned, in SdfGrid grid, bool turnAll, bool splitsLarge = true)
        {
            Mesh = mesh;
            Order = order;
            Vector3[] vertices = mesh.Vertices;
            int[] corners = mesh.Triangles;
            float3 min = grid.Min;
            float perMeter = 1f / grid.VoxelSize;
            int3 resolution = grid.Resolution;
            var found = new List<int>[Chunks.Of(order.Length)];
            Chunks.Run(order.Length, (chunk, first, end) =>
            {
                for (int i = first; i < end; i++)
                {
                    int t = (int)order[i];
                    uint flags = (turned != null && turned[t]) != turnAll ? Turned : 0;
                    float3 a = vertices[corners[3 * t]], b = vertices[corners[3 * t + 1]], c = vertices[corners[3 * t + 2]];
                    // At least as many voxels as the box has.
                    float3 size = (math.max(a, math.max(b, c)) - math.min(a, math.min(b, c))) * perMeter + (2 * Band + 2);
                    if (splitsLarge && size.x * size.y * size.z > SmallBox)
                    {
                        flags |= IsLarge;
                        (found[chunk] ??= new List<int>()).Add(i);
                    }
                    order[i] = (uint)t << 2 | flags;
                }
            });

            foreach (List<int> part in found)
                for (int k = 0; part != null && k < part.Count; k++)
                {
                    int t = (int)(order[part[k]] >> 2);
                    float3 a = vertices[corners[3 * t]], b = vertices[corners[3 * t + 1]], c = vertices[corners[3 * t + 2]];
                    int3 low = math.max((int3)math.floor((math.min(a, math.min(b, c)) - min) * perMeter) - Band, 0) / Brick;
                    int3 high = math.min((int3)math.floor((math.max(a, math.max(b, c)) - min) * perMeter) + Band, resolution - 1) / Brick;
                    long pairs = firstPairs[large.Count];
                    int3 bricks = high - low + 1;
                    large.Add(new LargeTriangle { index = (uint)part[k], firstPair = unchecked((uint)pairs), low = low, bricks = bricks });
                    firstPairs.Add(pairs + (long)bricks.x * bricks.y * bricks.z);
                }
            Large = large.ToArray();
        }

        public TriangleMesh Mesh { get; }

        /// <summary>Numbers of the mesh's triangles, along a curve; each above two bits that say whether it is turned and whether it is
        /// large.</summary>
        public uint[] Order { get; }

        public int TriangleCount => Order.Length;
        public LargeTriangle[] Large { get; }
        public long PairCount => firstPairs[large.Count];

        /// <summary>Bricks of a grid, those cut off by its end with them.</summary>
        public static int BrickCount(int3 resolution)
        {
            int3 bricks = (resolution + Brick - 1) / Brick;
            return bricks.x * bricks.y * bricks.z;
        }

        /// <summary>All pairs in runs of at most so many.</summary>
        public IEnumerable<Slice> Slices(int maxPairs)
        {
            int low = 0;
            for (long first = 0; first < PairCount; first += maxPairs)
            {
                int count = (int)Math.Min(maxPairs, PairCount - first);
                while (firstPairs[low + 1] <= first)
                    low++;
                int high = low;
                while (firstPairs[high + 1] < first + count)
                    high++;
                yield return new Slice(first, count, low, high);
            }
        }
    }
}
