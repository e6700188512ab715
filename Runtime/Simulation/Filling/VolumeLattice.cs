using System;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using Random = Unity.Mathematics.Random;

namespace Rill
{
    /// <summary>The cubic lattice around a volume, x first: the points inside are where its particles begin.</summary>
    readonly struct VolumeLattice
    {
        /// <summary>Offset of a particle from its point, spacings: breaks the symmetry that a perfect lattice would keep.</summary>
        [GenerateHlsl("Emitters")] const float Jitter = 0.02f;

        readonly int3 counts;
        readonly float spacing;
        readonly float3 first;      // point, spacings from the center

        public VolumeLattice(int3 counts, float spacing)
        {
            this.counts = math.max(counts, 0);
            this.spacing = spacing;
            first = (float3)(this.counts - 1) * -0.5f;
        }

        /// <summary>Points.</summary>
        public int Total => counts.x * counts.y * counts.z;

        /// <summary>Marks the points inside of a volume with 1 and the others with 0.</summary>
        /// <returns>How many are inside.</returns>
        public int Mark<T>(in T volume, Span<byte> marks) where T : struct, IVolume
        {
            T copy = volume;
            int inside = 0, point = 0;
            for (int z = 0; z < counts.z; z++)
                for (int y = 0; y < counts.y; y++)
                    for (int x = 0; x < counts.x; x++)
                    {
                        byte mark = copy.Contains((first + new float3(x, y, z)) * spacing) ? (byte)1 : (byte)0;
                        marks[point++] = mark;
                        inside += mark;
                    }
            return inside;
        }

        /// <summary>Writes the particles: each a little off its point.</summary>
        /// <param name="marks">By <see cref="Mark"/>; empty where all points are inside.</param>
        /// <param name="offset">Center of the lattice in the object's frame without its scale, m.</param>
        /// <param name="center">Position of the object, world space, m.</param>
        /// <param name="positions">xyz, world space, m; as many as are inside.</param>
        public void Fill(ReadOnlySpan<byte> marks, Random random, float3 offset, float3 center, Quaternion rotation, Span<float4> positions)
        {
            int point = 0, filled = 0;
            for (int z = 0; z < counts.z; z++)
                for (int y = 0; y < counts.y; y++)
                    for (int x = 0; x < counts.x; x++)
                    {
                        if (marks.Length > 0 && marks[point++] == 0)
                            continue;
                        float3 local = offset + (first + new float3(x, y, z) + random.NextFloat3(-Jitter, Jitter)) * spacing;
                        positions[filled++] = new float4(center + (float3)(rotation * (Vector3)local), 0f);
                    }
        }
    }
}
