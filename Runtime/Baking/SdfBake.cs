using System;
using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>Result of a bake, as plain numbers. <see cref="SignedDistanceField.Apply"/> puts them into an asset.</summary>
    public sealed class SdfBake
    {
        // Distance from the surface within which the choice of a format is strict, voxels; what rounding may cost there and elsewhere, voxels.
        const float StrictDistance = 2f, StrictError = 1e-3f, LooseError = 0.05f;

        internal SdfBake(string name, in SdfGrid grid, float[] distances, in MeshSdfSettings settings, MeshSdfSign sign, int triangles,
            ulong sourceHash = 0)
        {
            Name = name;
            Resolution = new Vector3Int(grid.Resolution.x, grid.Resolution.y, grid.Resolution.z);
            VoxelSize = grid.VoxelSize;
            Bounds = grid.Bounds;
            Distances = distances;
            Settings = settings;
            Sign = sign;
            ShellThickness = grid.Thickness;
            TriangleCount = triangles;
            SourceHash = sourceHash;

            HalfError = MeasureHalfError(out float near);
            bool accurate = near <= StrictError * VoxelSize && HalfError <= LooseError * VoxelSize;
            Format = settings.format != SdfFormat.Automatic ? settings.format : accurate ? SdfFormat.Half : SdfFormat.Float;
        }

        /// <summary>Name of the mesh.</summary>
        public string Name { get; }

        /// <summary>Voxels along each axis.</summary>
        public Vector3Int Resolution { get; }

        /// <summary>Edge of a voxel, m.</summary>
        public float VoxelSize { get; }

        /// <summary>The volume that the voxels fill, m: the center of voxel i is at min + (i + 0.5) <see cref="VoxelSize"/>.</summary>
        public Bounds Bounds { get; }

        /// <summary>Distance to the surface at the voxels' centers, m, negative inside; [(z * height + y) * width + x]. Not a copy.</summary>
        public float[] Distances { get; }

        /// <summary>Settings that were given.</summary>
        public MeshSdfSettings Settings { get; }

        /// <summary>The method that was used; never automatic.</summary>
        public MeshSdfSign Sign { get; }

        /// <summary>Thickness of the shell that an open surface became, m; 0 for a solid.</summary>
        public float ShellThickness { get; }

        /// <summary>Triangles that were baked, without those of zero area.</summary>
        public int TriangleCount { get; }

        /// <summary><see cref="TriangleMesh.Hash"/> of the mesh.</summary>
        public ulong SourceHash { get; }

        /// <summary>Largest error of any voxel that 16 bits make, m.</summary>
        public float HalfError { get; }

        /// <summary>How the voxels are stored; never automatic.</summary>
        public SdfFormat Format { get; }

        /// <summary>Largest error of any voxel that storing makes, m.</summary>
        public float StorageError => Format == SdfFormat.Half ? HalfError : 0f;

        /// <summary>The voxels as bits of 16, as <see cref="SdfFormat.Half"/> stores them.</summary>
        public ushort[] ToHalf()
        {
            var bits = new ushort[Distances.Length];
            Chunks.Run(bits.Length, (chunk, first, end) =>
            {
                for (int i = first; i < end; i++)
                    bits[i] = Mathf.FloatToHalf(Distances[i]);
            });
            return bits;
        }

        float MeasureHalfError(out float near)
        {
            float[] distances = Distances;
            float strict = StrictDistance * VoxelSize;
            var most = new float2[Chunks.Of(distances.Length)];
            Chunks.Run(distances.Length, (chunk, first, end) =>
            {
                float loose = 0f, close = 0f;
                for (int i = first; i < end; i++)
                {
                    float error = HalfErrorOf(distances[i]);
                    if (error > loose)
                        loose = error;
                    if (error > close && math.abs(distances[i]) <= strict)
                        close = error;
                }
                most[chunk] = new float2(loose, close);
            });
            float2 all = 0f;
            foreach (float2 found in most)
                all = math.max(all, found);
            near = all.y;
            return all.x;
        }

        /// <summary>Error of rounding to the nearest of 16 bits, without doing it, which takes ten times as long: halves have 13 binary
        /// digits fewer.</summary>
        internal static float HalfErrorOf(float value)
        {
            const uint least = 0x38800000, infinite = 0x477FF000;      // 2^-14, and 65520, which rounds to more than a half can be
            uint bits = math.asuint(value) & 0x7FFFFFFF;
            if (bits >= infinite)
                return float.PositiveInfinity;
            if (bits < least)
            {
                float steps = math.asfloat(bits) * 16777216f;           // of 2^-24
                return math.abs(steps - math.round(steps)) / 16777216f;
            }
            uint cut = bits & 0x1FFF;
            return math.min(cut, 0x2000 - cut) * math.asfloat((bits & 0x7F800000) - (23u << 23));
        }
    }
}
