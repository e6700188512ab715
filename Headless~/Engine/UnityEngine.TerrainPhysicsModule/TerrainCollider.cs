using System.Collections.Generic;
using UnityEngine.Headless;

namespace UnityEngine
{
    /// <summary>The ground of a terrain at its object's position, whatever its rotation and scale, without what its holes leave out.</summary>
    public class TerrainCollider : Collider
    {
        TerrainTriangles triangles;

        public TerrainData terrainData { get; set; }

        private protected override bool Turns => false;
        private protected override bool IsScaled => false;

        internal override ShapeDescription Describe()
        {
            if (terrainData == null)
                return default;
            if (triangles == null || triangles.Data != terrainData)
                triangles = new TerrainTriangles(terrainData);
            return new ShapeDescription { Kind = ShapeKind.Triangles, Triangles = triangles, Version = terrainData.Version, Scale = Vector3.one };
        }
    }
}

namespace UnityEngine.Headless
{
    sealed class TerrainTriangles : ITriangles
    {
        public readonly TerrainData Data;

        public TerrainTriangles(TerrainData data) => Data = data;

        public Bounds Bounds => new Bounds(0.5f * Data.size, Data.size);

        // If MaxTriangles (1025 x 1025) do not hold all heights, reads each second, fourth and so on: a height may then be off by its neighbors'
        // slope.
        public void Read(out Vector3[] points, out int[] indices)
        {
            int side = Data.heightmapResolution, step = 1;
            while (2L * ((side - 1) / step) * ((side - 1) / step) > ShapeDescription.MaxTriangles)
                step *= 2;
            int cells = (side - 1) / step, across = cells + 1;
            Vector3 size = Data.size;
            bool[,] ground = Data.GetHoles(0, 0, side - 1, side - 1);
            points = new Vector3[across * across];
            var corners = new List<int>(6 * cells * cells);
            for (int z = 0; z <= cells; z++)
                for (int x = 0; x <= cells; x++)
                {
                    int at = z * across + x;
                    points[at] = new Vector3(size.x * x / cells, Data.HeightAt(x * step, z * step), size.z * z / cells);
                    if (x == cells || z == cells || !ground[z * step, x * step])
                        continue;
                    corners.AddRange(new[] { at, at + across, at + across + 1, at, at + across + 1, at + 1 });
                }
            indices = corners.ToArray();
        }
    }
}
