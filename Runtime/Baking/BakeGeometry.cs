using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>
    /// The triangles of a bake in units of voxels, without those of no area, turned to face outwards, in the order of a
    /// Morton curve; and the bricks of voxels that each of them reaches.
    /// </summary>
    sealed class BakeGeometry
    {
        /// <summary>Voxels along a brick; kBrick in MeshSdf.compute.</summary>
        public const int Brick = 4;

        /// <summary>Voxels around a triangle in which it is tested; kBand in MeshSdf.compute.</summary>
        public const int Band = 2;

        /// <summary>Triangle in Triangle.hlsl.</summary>
        [StructLayout(LayoutKind.Sequential)]
        public struct Triangle
        {
            public float3 a, b, c;
        }

        /// <summary>Consecutive pairs of triangles and bricks, for one dispatch.</summary>
        public readonly struct Slice
        {
            public readonly long First;
            public readonly int Count, LowTriangle, HighTriangle;
            public Slice(long first, int count, int lowTriangle, int highTriangle) => (First, Count, LowTriangle, HighTriangle) = (first, count, lowTriangle, highTriangle);
        }

        readonly long[] firstPairs;

        /// <param name="turned">By triangle of the mesh: those to turn over; null for none.</param>
        /// <param name="turnAll">Whether all triangles face the wrong side.</param>
        public BakeGeometry(BakedTriangles part, bool[] turned, in SdfGrid grid, bool turnAll)
        {
            TriangleMesh mesh = part.Mesh;
            var unordered = new Triangle[part.Count];
            var order = new ulong[part.Count];
            float perMetre = 1f / grid.VoxelSize, perVoxel = 1024f / math.cmax(grid.Resolution);
            for (int t = 0, next = 0; t < mesh.TriangleCount; t++)
            {
                if (!part.TakesPart(t))
                    continue;
                bool turn = (turned != null && turned[t]) != turnAll;
                var triangle = new Triangle
                {
                    a = ((float3)mesh.Corner(t, 0) - grid.Min) * perMetre,
                    b = ((float3)mesh.Corner(t, turn ? 2 : 1) - grid.Min) * perMetre,
                    c = ((float3)mesh.Corner(t, turn ? 1 : 2) - grid.Min) * perMetre,
                };
                unordered[next] = triangle;
                order[next] = (ulong)MortonKey((triangle.a + triangle.b + triangle.c) / 3f * perVoxel) << 32 | (uint)next;
                next++;
            }

            order = Sorted(order);
            Triangles = new Triangle[part.Count];
            FirstPairs = new uint[part.Count];
            firstPairs = new long[part.Count + 1];
            for (int i = 0; i < Triangles.Length; i++)
            {
                Triangles[i] = unordered[(uint)order[i]];
                int3 bricks = BricksOf(Triangles[i], grid.Resolution);
                FirstPairs[i] = unchecked((uint)firstPairs[i]);
                firstPairs[i + 1] = firstPairs[i] + (long)bricks.x * bricks.y * bricks.z;
            }
        }

        public Triangle[] Triangles { get; }

        /// <summary>Pairs before each triangle, modulo 2^32: a slice spans fewer.</summary>
        public uint[] FirstPairs { get; }

        public long PairCount => firstPairs[Triangles.Length];

        /// <summary>Bricks of a grid, those cut off by its end with them.</summary>
        public static int BrickCount(int3 resolution)
        {
            int3 bricks = (resolution + Brick - 1) / Brick;
            return bricks.x * bricks.y * bricks.z;
        }

        /// <summary>All pairs in runs of at most so many.</summary>
        public IEnumerable<Slice> Slices(int mostPairs)
        {
            int low = 0;
            for (long first = 0; first < PairCount; first += mostPairs)
            {
                int count = (int)Math.Min(mostPairs, PairCount - first);
                while (firstPairs[low + 1] <= first)
                    low++;
                int high = low;
                while (firstPairs[high + 1] < first + count)
                    high++;
                yield return new Slice(first, count, low, high);
            }
        }

        // In whole numbers, so that the kernel comes to the same.
        static int3 BricksOf(in Triangle t, int3 resolution)
        {
            int3 low = math.max((int3)math.floor(math.min(t.a, math.min(t.b, t.c))) - Band, 0) / Brick;
            int3 high = math.min((int3)math.floor(math.max(t.a, math.max(t.b, t.c))) + Band, resolution - 1) / Brick;
            return high - low + 1;
        }

        static uint MortonKey(float3 place)
        {
            uint3 cell = (uint3)math.clamp(place, 0f, 1023f);
            return Spread(cell.x) | Spread(cell.y) << 1 | Spread(cell.z) << 2;
        }

        // Ten bits, two zeros between each.
        static uint Spread(uint bits)
        {
            bits = (bits | bits << 16) & 0x030000FF;
            bits = (bits | bits << 8) & 0x0300F00F;
            bits = (bits | bits << 4) & 0x030C30C3;
            return (bits | bits << 2) & 0x09249249;
        }

        // Radix sort by the 30 bits of the key, which are the upper ones: stable, so that the order does not depend on the
        // runtime's own sort.
        static ulong[] Sorted(ulong[] items)
        {
            const int bits = 10, buckets = 1 << bits;
            var sorted = new ulong[items.Length];
            var starts = new int[buckets + 1];
            for (int shift = 32; shift < 32 + 3 * bits; shift += bits)
            {
                Array.Clear(starts, 0, starts.Length);
                foreach (ulong item in items)
                    starts[(int)(item >> shift & (buckets - 1)) + 1]++;
                for (int b = 0; b < buckets; b++)
                    starts[b + 1] += starts[b];
                foreach (ulong item in items)
                    sorted[starts[(int)(item >> shift & (buckets - 1))]++] = item;
                (items, sorted) = (sorted, items);
            }
            return items;
        }
    }
}
