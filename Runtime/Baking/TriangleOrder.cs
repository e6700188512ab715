using System;
using Unity.Mathematics;

namespace Rill
{
    /// <summary>
    /// The triangles of a bake along a Hilbert curve: those that follow each other lie together, so that runs of them are
    /// small. Along a Morton curve, which jumps, spheres around runs are wider and a sum over them takes twice as many.
    /// </summary>
    static class TriangleOrder
    {
        const int Bits = 10, Buckets = 1 << Bits;       // of the curve per axis, and of a round of the sort
        const int States = 24;

        // By state and octant of the curve: rank of the octant along it, and the state within.
        static readonly byte[] Ranks = new byte[8 * States], Next = new byte[8 * States];

        // Compact Hilbert indices (Hamilton and Rau-Chaplin 2008), algorithm 2, with e and d as one state.
        static TriangleOrder()
        {
            for (int entry = 0; entry < 8; entry++)
                for (int direction = 0; direction < 3; direction++)
                    for (int octant = 0; octant < 8; octant++)
                    {
                        int gray = RotateRight(octant ^ entry, direction + 1), rank = gray ^ gray >> 1 ^ gray >> 2;
                        int from = rank == 0 ? 0 : Gray((rank - 1) / 2 * 2);
                        int axis = rank == 0 ? 0 : TrailingOnes(rank % 2 == 0 ? rank - 1 : rank) % 3;
                        int inner = entry ^ RotateRight(from, 3 - (direction + 1) % 3);
                        int at = (entry * 3 + direction) * 8 + octant;
                        Ranks[at] = (byte)rank;
                        Next[at] = (byte)(inner * 3 + (direction + axis + 1) % 3);
                    }
        }

        static int Gray(int i) => i ^ i >> 1;
        static int RotateRight(int bits, int by) => (bits >> by % 3 | bits << 3 - by % 3) & 7;
        static int TrailingOnes(int i) => math.tzcnt(~i);

        /// <summary>Indices of the mesh's triangles that take part, by the centers of their boxes along the curve; those at one position as in
        /// the mesh.</summary>
        public static uint[] Of(BakedTriangles part)
        {
            float scale = ScaleOf(part);
            float3 low = part.Bounds.min;
            int triangles = part.Mesh.TriangleCount, chunks = Chunks.Of(triangles);
            var firsts = new int[chunks + 1];
            Chunks.Run(triangles, (chunk, first, end) =>
            {
                int count = 0;
                for (int t = first; t < end; t++)
                    count += part.TakesPart(t) ? 1 : 0;
                firsts[chunk + 1] = count;
            });
            for (int chunk = 0; chunk < chunks; chunk++)
                firsts[chunk + 1] += firsts[chunk];

            var items = new ulong[part.Count];
            Chunks.Run(triangles, (chunk, first, end) =>
            {
                int next = firsts[chunk];
                for (int t = first; t < end; t++)
                    if (part.TakesPart(t))
                        items[next++] = (ulong)KeyOf(CenterOf(part.Mesh, t, low, scale)) << 32 | (uint)t;
            });

            items = Sorted(items);
            var order = new uint[items.Length];
            Chunks.Run(order.Length, (chunk, first, end) =>
            {
                for (int i = first; i < end; i++)
                    order[i] = (uint)items[i];
            });
            return order;
        }

        internal static float ScaleOf(BakedTriangles part) => Buckets / math.max(math.cmax((float3)part.Bounds.size), float.Epsilon) / 2f;

        // Center of the box, which is the same to the last bit for a triangle that is turned over.
        internal static float3 CenterOf(TriangleMesh mesh, int triangle, float3 low, float scale)
        {
            float3 a = mesh.Corner(triangle, 0), b = mesh.Corner(triangle, 1), c = mesh.Corner(triangle, 2);
            return (math.min(a, math.min(b, c)) - low + (math.max(a, math.max(b, c)) - low)) * scale;
        }

        /// <param name="center">0 to 1024.</param>
        internal static uint KeyOf(float3 center)
        {
            uint x = CellOf(center.x), y = CellOf(center.y), z = CellOf(center.z), key = 0;
            int state = 0;
            for (int bit = Bits - 1; bit >= 0; bit--)
            {
                int at = state * 8 + (int)(x >> bit & 1 | (y >> bit & 1) << 1 | (z >> bit & 1) << 2);
                key = key << 3 | Ranks[at];
                state = Next[at];
            }
            return key;
        }

        static uint CellOf(float coordinate) => (uint)math.clamp((int)coordinate, 0, Buckets - 1);

        // Radix sort by the 30 bits of the key, which are the upper ones: stable, so that the order is the same on every machine.
        static ulong[] Sorted(ulong[] items)
        {
            int chunks = Chunks.Of(items.Length);
            var sorted = new ulong[items.Length];
            var starts = new int[chunks * Buckets];
            for (int shift = 32; shift < 32 + 3 * Bits; shift += Bits)
            {
                Round(items, sorted, starts, shift);
                (items, sorted) = (sorted, items);
            }
            return items;
        }

        // Every chunk counts its items by bucket, and then puts them behind those of the chunks before it.
        static void Round(ulong[] from, ulong[] to, int[] starts, int shift)
        {
            Array.Clear(starts, 0, starts.Length);
            Chunks.Run(from.Length, (chunk, first, end) => CountBuckets(from, starts, chunk * Buckets, shift, first, end));
            for (int bucket = 0, next = 0; bucket < Buckets; bucket++)
                for (int at = bucket; at < starts.Length; at += Buckets)
                {
                    int count = starts[at];
                    starts[at] = next;
                    next += count;
                }
            Chunks.Run(from.Length, (chunk, first, end) => Scatter(from, to, starts, chunk * Buckets, shift, first, end));
        }

        static void CountBuckets(ulong[] from, int[] counts, int own, int shift, int first, int end)
        {
            for (int i = first; i < end; i++)
                counts[own + ((int)(from[i] >> shift) & (Buckets - 1))]++;
        }

        static void Scatter(ulong[] from, ulong[] to, int[] starts, int own, int shift, int first, int end)
        {
            for (int i = first; i < end; i++)
                to[starts[own + ((int)(from[i] >> shift) & (Buckets - 1))]++] = from[i];
        }
    }
}
