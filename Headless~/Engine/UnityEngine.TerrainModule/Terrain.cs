using System;
using System.Collections.Generic;

namespace UnityEngine
{
    /// <summary>
    /// Host's part of it: terrain data; nothing is drawn. In an assembly of its own, for the package alone: scripts of other
    /// projects find the stub with all members of Unity's, which throws.
    /// </summary>
    public sealed class Terrain : Behaviour
    {
        internal static readonly List<Terrain> Active = new List<Terrain>();

        public TerrainData terrainData { get; set; }

        internal override void OnActivated() => Active.Add(this);
        internal override void OnDeactivated() => Active.Remove(this);

        /// <summary>A terrain follows its object's position alone.</summary>
        public Vector3 GetPosition() => transform.position;
    }

    /// <summary>Heights of a terrain as fractions of its height, kept in steps of 1/32766 as in Unity's heightmap.</summary>
    public sealed class TerrainData : Object
    {
        const int Steps = 32766, MinResolution = 33, MaxResolution = 4097;

        float[,] heights = new float[MinResolution, MinResolution];
        bool[,] ground;     // null without holes
        Vector3 scale = new Vector3(1f, 600f, 1f);

        /// <summary>Heights along a side: 33, 65 and so on to 4,097; other numbers become the next of these. A change clears the heights
        /// and keeps their distance, so that the size changes: set the size after it.</summary>
        public int heightmapResolution
        {
            get => heights.GetLength(0);
            set
            {
                int resolution = MinResolution;
                while (resolution < value && resolution < MaxResolution)
                    resolution = 2 * resolution - 1;
                heights = new float[resolution, resolution];
                ground = null;
                Version++;
            }
        }

        /// <summary>m; y that of a fraction of 1.</summary>
        public Vector3 size
        {
            get => new Vector3(scale.x * (heightmapResolution - 1), scale.y, scale.z * (heightmapResolution - 1));
            set
            {
                scale = new Vector3(value.x / (heightmapResolution - 1), value.y, value.z / (heightmapResolution - 1));
                Version++;
            }
        }

        /// <summary>Changes with the ground.</summary>
        internal int Version { get; private set; }

        /// <summary>m.</summary>
        internal float HeightAt(int x, int z) => heights[z, x] * scale.y;

        /// <summary>[z, x] fractions of the height, from a place on.</summary>
        public float[,] GetHeights(int xBase, int yBase, int width, int height)
        {
            Check(xBase, yBase, width, height);
            var part = new float[height, width];
            for (int z = 0; z < height; z++)
                for (int x = 0; x < width; x++)
                    part[z, x] = heights[yBase + z, xBase + x];
            return part;
        }

        /// <param name="heights">[z, x] fractions of the height, 0 to 1.</param>
        public void SetHeights(int xBase, int yBase, float[,] heights)
        {
            if (heights == null)
                throw new NullReferenceException();
            Check(xBase, yBase, heights.GetLength(1), heights.GetLength(0));
            for (int z = 0; z < heights.GetLength(0); z++)
                for (int x = 0; x < heights.GetLength(1); x++)
                    this.heights[yBase + z, xBase + x] = (float)Math.Round(Mathf.Clamp01(heights[z, x]) * Steps) / Steps;
            Version++;
            TerrainCallbacks.Tell(this, new RectInt(xBase, yBase, heights.GetLength(1), heights.GetLength(0)));
        }

        public static string HolesTextureName => "holes";

        /// <summary>Along a side: one between each two heights.</summary>
        public int holesResolution => heightmapResolution - 1;

        /// <summary>[z, x] whether there is ground, from a place on.</summary>
        public bool[,] GetHoles(int xBase, int yBase, int width, int height)
        {
            CheckHoles(xBase, yBase, width, height);
            var part = new bool[height, width];
            for (int z = 0; z < height; z++)
                for (int x = 0; x < width; x++)
                    part[z, x] = ground == null || ground[yBase + z, xBase + x];
            return part;
        }

        /// <param name="holes">[z, x] whether there is ground.</param>
        public void SetHoles(int xBase, int yBase, bool[,] holes)
        {
            CheckHoles(xBase, yBase, holes.GetLength(1), holes.GetLength(0));
            ground = GetHoles(0, 0, holesResolution, holesResolution);
            for (int z = 0; z < holes.GetLength(0); z++)
                for (int x = 0; x < holes.GetLength(1); x++)
                    ground[yBase + z, xBase + x] = holes[z, x];
            Version++;
            TerrainCallbacks.RaiseTextureChanged(this, HolesTextureName, new RectInt(xBase, yBase, holes.GetLength(1), holes.GetLength(0)));
        }

        void CheckHoles(int x, int z, int width, int length)
        {
            if (x < 0 || z < 0 || width < 0 || length < 0 || x + width > holesResolution || z + length > holesResolution)
                throw new ArgumentException(
                    $"The part {x}, {z} with {width} x {length} holes does not lie within the {holesResolution} of the terrain.");
        }

        void Check(int x, int z, int width, int length)
        {
            if (x < 0 || z < 0 || width < 0 || length < 0 || x + width > heightmapResolution || z + length > heightmapResolution)
                throw new ArgumentException(
                    $"The part {x}, {z} with {width} x {length} heights does not lie within the {heightmapResolution} of the terrain.");
        }
    }

    /// <summary>Tells of changed heights and holes, all of which are on the CPU here.</summary>
    public static class TerrainCallbacks
    {
        public delegate void HeightmapChangedCallback(Terrain terrain, RectInt heightRegion, bool synched);

        public delegate void TextureChangedCallback(Terrain terrain, string textureName, RectInt texelRegion, bool synched);

        public static event HeightmapChangedCallback heightmapChanged;
        public static event TextureChangedCallback textureChanged;

        internal static void Tell(TerrainData data, RectInt region)
        {
            foreach (Terrain terrain in Terrain.Active.ToArray())
                if (ReferenceEquals(terrain.terrainData, data))
                    heightmapChanged?.Invoke(terrain, region, true);
        }

        internal static void RaiseTextureChanged(TerrainData data, string name, RectInt region)
        {
            foreach (Terrain terrain in Terrain.Active.ToArray())
                if (ReferenceEquals(terrain.terrainData, data))
                    textureChanged?.Invoke(terrain, name, region, true);
        }
    }
}
