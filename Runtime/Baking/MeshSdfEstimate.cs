using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Estimate of what a bake makes and needs, before it starts.</summary>
    public readonly struct MeshSdfEstimate
    {
        // Two words a voxel on the GPU, one read back and one handed out.
        const long WorkBytesPerVoxel = 16;
        // On the GPU corners, spheres, order, indices, vertices and clusters; off it the order and the welded edges.
        const long WorkBytesPerTriangle = 48 + 16 + 4 + 12 + 36 + 19 + 20 + 150;

        internal MeshSdfEstimate(in SdfGrid grid, int triangles, in MeshSdfSettings settings)
        {
            Resolution = new Vector3Int(grid.Resolution.x, grid.Resolution.y, grid.Resolution.z);
            VoxelSize = grid.VoxelSize;
            Bounds = grid.Bounds;
            TextureBytes = grid.VoxelCount * (settings.format == SdfFormat.Half ? 2 : 4);
            WorkBytes = grid.VoxelCount * WorkBytesPerVoxel + triangles * WorkBytesPerTriangle;

            Problem = null;
            int largest = Mathf.Max(Resolution.x, Mathf.Max(Resolution.y, Resolution.z));
            int most = Mathf.Min(MeshSdfSettings.MaxResolution, SystemInfo.maxTexture3DSize);
            long bytes = TotalBytes, cap = settings.memoryCap * 1024L * 1024L;
            string size = Invariant($"{Resolution.x} x {Resolution.y} x {Resolution.z} voxels of {VoxelSize} m");
            if (!(VoxelSize > 0f))
                Problem = "The mesh has no size: its triangles lie in one point.";
            else if (largest > most)
                Problem = Invariant($"{size} are more than {most} a side: use larger voxels or a lower resolution.");
            else if (bytes > cap)
                Problem = Invariant($"{size} take {Mega(bytes)} MiB, more than the memory cap of {settings.memoryCap} MiB: use larger ") +
                    "voxels or a lower resolution, or raise the cap.";
            else if (grid.VoxelCount * sizeof(uint) > GpuBuffer.MaxBinding)
                Problem = $"{size} need a buffer of {Mega(grid.VoxelCount * sizeof(uint))} MiB, but this device binds " +
                    $"{Mega(GpuBuffer.MaxBinding)} MiB: use larger voxels or a lower resolution.";
            else if ((long)triangles * MeshSdfPasses.BytesOfTriangle > GpuBuffer.MaxBinding)
                Problem = Invariant($"{triangles:N0} triangles need a buffer of {Mega((long)triangles * MeshSdfPasses.BytesOfTriangle)} ") +
                    $"MiB, but this device binds {Mega(GpuBuffer.MaxBinding)} MiB: bake a mesh of fewer triangles.";
        }

        /// <summary>Voxels along each axis.</summary>
        public Vector3Int Resolution { get; }

        /// <summary>Edge of a voxel, m.</summary>
        public float VoxelSize { get; }

        /// <summary>The volume that the voxels fill, m, in the frame of the mesh.</summary>
        public Bounds Bounds { get; }

        /// <summary>Size of the voxels in the asset on the GPU, and again in main memory; with 32 bits a voxel if the format is automatic.</summary>
        public long TextureBytes { get; }

        /// <summary>Taken by the bake and given back after it, on the GPU and off it.</summary>
        public long WorkBytes { get; }

        /// <summary>The most that is taken at once.</summary>
        public long TotalBytes => WorkBytes + 2 * TextureBytes;

        /// <summary>Why it cannot be baked, with the limit and the remedy; null if it can.</summary>
        public string Problem { get; }

        static string Mega(long bytes) => Invariant($"{bytes / (1024.0 * 1024.0):N1}");
    }
}
