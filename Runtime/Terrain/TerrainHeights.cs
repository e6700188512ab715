using System;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>The heights of a part of a terrain as a collider has them, and whether they were edited since.</summary>
    sealed class TerrainHeights : IDisposable
    {
        public const string HolesProblem = "its Terrain has holes, which are closed to water. Lower the ground there, or leave the " +
            "terrain out and put Fluid Colliders where it is.";

        readonly TerrainData data;
        readonly RectInt taken;     // of the terrain's heights
        readonly Vector3 size;      // m
        readonly int resolution;    // heights along a side
        bool isEdited;

        /// <param name="data">Not null.</param>
        /// <param name="part">As fractions of the terrain's sides, 0 to 1.</param>
        public TerrainHeights(TerrainData data, Rect part)
        {
            this.data = data;
            size = data.size;
            resolution = data.heightmapResolution;
            int last = resolution - 1;
            int x = Mathf.FloorToInt(part.xMin * last), z = Mathf.FloorToInt(part.yMin * last);
            taken = new RectInt(x, z, Mathf.CeilToInt(part.xMax * last) - x + 1, Mathf.CeilToInt(part.yMax * last) - z + 1);
            TerrainCallbacks.heightmapChanged += OnHeightsChanged;
            TerrainCallbacks.textureChanged += OnTextureChanged;
            if (Mathf.Max(taken.width, taken.height) > HeightField.MaxHeights)
            {
                Problem = Invariant($"it has {taken.width} x {taken.height} heights, and {HeightField.MaxHeights} along a side can be ") +
                    "taken. Set Part of a Fluid Terrain on it to where the fluid gets, or lower the terrain's heightmap resolution.";
                return;
            }
            HasHoles = FindHoles();
            ReadHeights();
        }

        /// <summary>Null where there are none: see <see cref="Problem"/>.</summary>
        public HeightField Field { get; private set; }

        /// <summary>Reason why no heights can be read; null if they can.</summary>
        public string Problem { get; private set; }

        /// <summary>Whether the part has holes, which are closed to water.</summary>
        public bool HasHoles { get; }

        /// <summary>Whether heights or holes of the part were edited since, or the terrain's size or resolution changed.</summary>
        public bool IsStale => data != null && (isEdited || data.size != size || data.heightmapResolution != resolution);

        public void Dispose()
        {
            TerrainCallbacks.heightmapChanged -= OnHeightsChanged;
            TerrainCallbacks.textureChanged -= OnTextureChanged;
            Field?.Dispose();
            Field = null;
        }

        void ReadHeights()
        {
            Vector3 spacing = size / (resolution - 1);
            float[,] heights = data.GetHeights(taken.x, taken.y, taken.width, taken.height);
            for (int i = 0; i < taken.height; i++)
                for (int k = 0; k < taken.width; k++)
                    heights[i, k] *= size.y;
            try
            {
                Field = new HeightField(heights, (taken.width - 1) * spacing.x, (taken.height - 1) * spacing.z,
                    new Vector3(taken.x * spacing.x, 0f, taken.y * spacing.z));
            }
            catch (ArgumentException e)
            {
                Problem = e.Message;
            }
        }

        // A hole is false, between four heights.
        bool FindHoles()
        {
            int last = data.holesResolution;
            int width = Mathf.Min(taken.xMax, last) - taken.xMin, length = Mathf.Min(taken.yMax, last) - taken.yMin;
            if (width <= 0 || length <= 0)
                return false;
            foreach (bool isGround in data.GetHoles(taken.xMin, taken.yMin, width, length))
                if (!isGround)
                    return true;
            return false;
        }

        // Edits on the GPU reach the CPU later, which raises another event.
        void OnHeightsChanged(Terrain changed, RectInt region, bool synched)
            => isEdited |= synched && changed.terrainData == data && region.Overlaps(taken);

        void OnTextureChanged(Terrain changed, string texture, RectInt region, bool synched)
            => isEdited |= synched && changed.terrainData == data && texture == TerrainData.HolesTextureName && region.Overlaps(taken);
    }
}
