using System;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>How a mesh is turned into a distance field.</summary>
    [Serializable]
    public struct MeshSdfSettings
    {
        /// <summary>Fewest and most voxels along the longest side of the mesh.</summary>
        public const int MinResolution = 8, MaxResolution = 1024;
        /// <summary>Most voxels added around the mesh on each side.</summary>
        public const int MaxPadding = 64;

        /// <summary>Edge of a voxel, m. 0: from the resolution.</summary>
        [Tooltip("Edge of a voxel, m. 0: from the resolution.")]
        public float voxelSize;

        /// <summary>Voxels along the longest axis, padding included, where no voxel size is given. 8 to 1024.</summary>
        [Tooltip("Voxels along the longest axis, padding included, where no voxel size is given. 8 to 1024.")]
        [Range(MinResolution, MaxResolution)] public int resolution;

        /// <summary>Voxels around the mesh on every side. 1 to 64.</summary>
        [Tooltip("Voxels around the mesh on every side. 1 to 64.")]
        [Range(1, MaxPadding)] public int padding;

        /// <summary>Most memory that a bake may take, MiB, on the GPU and off it together. A bake that needs more is refused before it
        /// starts.</summary>
        [Tooltip("Most memory that a bake may take, MiB, on the GPU and off it together. A bake that needs more is refused before it starts.")]
        public int memoryCap;

        /// <summary>How inside is told from outside. Automatic: by the winding number, or as a shell where the mesh is open.</summary>
        [Tooltip("How inside is told from outside. Automatic: by the winding number, or as a shell where the mesh is open.")]
        public MeshSdfSign sign;

        /// <summary>Thickness of the shell that an open surface becomes, m. 0: two voxels, the least that the grid resolves.</summary>
        [Tooltip("Thickness of the shell that an open surface becomes, m. 0: two voxels, the least that the grid resolves.")]
        public float shellThickness;

        /// <summary>How voxels are stored. Automatic: 16 bits where that is accurate enough, else 32.</summary>
        [Tooltip("How voxels are stored. Automatic: 16 bits where that is accurate enough, else 32.")]
        public SdfFormat format;

        /// <summary>Leaves out small parts far from the others, and triangles at a corner that strayed: what makes the box around the mesh
        /// much larger though it holds at most a hundredth of the surface.</summary>
        [Tooltip("Leaves out small parts far from the others, and triangles at a corner that strayed: what makes the box around the mesh much " +
            "larger though it holds at most a hundredth of the surface.")]
        public bool leaveOutFar;

        /// <summary>The settings of a new bake.</summary>
        public static MeshSdfSettings Default => new MeshSdfSettings
        {
            resolution = 64,
            padding = 3,
            memoryCap = 1024,
            sign = MeshSdfSign.Automatic,
            format = SdfFormat.Automatic,
        };

        /// <summary>Whether a bake can run with these settings. Nothing is changed: a bake with others is refused.</summary>
        /// <param name="problem">What is wrong, the limit and the remedy; null if nothing is.</param>
        public readonly bool Validate(out string problem)
        {
            problem = null;
            if (!IsFinite(voxelSize) || voxelSize < 0f)
                Limit.Append(ref problem, Invariant($"Voxel size {voxelSize} m must be above 0, or 0 to take it from the resolution."));
            if (resolution < MinResolution || resolution > MaxResolution)
                Limit.Append(ref problem, Invariant($"Resolution {resolution} is outside {MinResolution} to {MaxResolution}: set it ") +
                    "within.");
            if (padding < 1 || padding > MaxPadding)
                Limit.Append(ref problem, Invariant($"Padding {padding} is outside 1 to {MaxPadding} voxels: set it within."));
            if (memoryCap < 1)
                Limit.Append(ref problem, Invariant($"Memory cap {memoryCap} MiB must be at least 1."));
            if (!IsFinite(shellThickness) || shellThickness < 0f)
                Limit.Append(ref problem, Invariant($"Shell thickness {shellThickness} m must be above 0, or 0 for two voxels."));
            return problem == null;
        }

        static bool IsFinite(float value) => !float.IsNaN(value) && !float.IsInfinity(value);
    }
}
