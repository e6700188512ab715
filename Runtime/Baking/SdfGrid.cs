using System;
using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>The voxels of a bake: cubes that fill a box around the mesh, which sits in its center.</summary>
    readonly struct SdfGrid
    {
        /// <summary>A shell whose thickness is not given has this many voxels, the least that trilinear samples resolve.</summary>
        const float ShellVoxels = 2f;

        public readonly int3 Resolution;
        public readonly float VoxelSize;
        /// <summary>Lowest corner, m; the center of voxel i is at Min + (i + 0.5) VoxelSize.</summary>
        public readonly float3 Min;
        /// <summary>Thickness of the shell that an open surface becomes, m; 0 for solids.</summary>
        public readonly float Thickness;

        /// <param name="mesh">Bounds of the triangles, m.</param>
        /// <param name="settings">Valid ones.</param>
        public SdfGrid(Bounds mesh, in MeshSdfSettings settings, bool isShell)
        {
            float3 size = mesh.size;
            float longest = math.cmax(size);
            float inner = settings.resolution - 2 * settings.padding;
            bool wholeVoxels = isShell && settings.shellThickness == 0f;
            VoxelSize = settings.voxelSize > 0f ? settings.voxelSize
                : wholeVoxels ? longest / math.max(inner - ShellVoxels, 1f)
                : (longest + (isShell ? settings.shellThickness : 0f)) / math.max(inner, 1f);
            Thickness = !isShell ? 0f : wholeVoxels ? ShellVoxels * VoxelSize : settings.shellThickness;

            // A size of a whole number of voxels takes that many in spite of rounding. More than an int holds is refused later.
            float3 voxels = math.ceil((size + Thickness) / VoxelSize - 1e-3f) + 2 * settings.padding;
            Resolution = (int3)math.clamp(voxels, 1f, 1e6f);
            Min = (float3)mesh.center - 0.5f * VoxelSize * (float3)Resolution;
        }

        public long VoxelCount => (long)Resolution.x * Resolution.y * Resolution.z;

        public Bounds Bounds => new Bounds(Min + 0.5f * VoxelSize * (float3)Resolution, VoxelSize * (float3)Resolution);
    }
}
