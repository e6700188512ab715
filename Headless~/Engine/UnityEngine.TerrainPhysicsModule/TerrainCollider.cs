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

        public void Read(out Vector3[] points, out int[] indices)
        {
            int side = Data.heightmapResolution;
            Vector3 size = Data.size;
            bool[,] ground = Data.GetHoles(0, 0, side - 1, side - 1);
            points = new Vector3[side * side];
            var corners = new List<int>(6 * side * side);
            for (int z = 0; z < side; z++)
                for (int x = 0; x < side; x++)
                {
                    int at = z * side + x;
                    points[at] = new Vector3(size.x * x / (side - 1), Data.HeightAt(x, z), size.z * z / (side - 1));
                    if (x == side - 1 || z == side - 1 || !ground[z, x])
                        continue;
                    corners.AddRange(new[] { at, at + side, at + side + 1, at, at + side + 1, at + 1 });
                }
            indices = corners.ToArray();
        }
    }
}
