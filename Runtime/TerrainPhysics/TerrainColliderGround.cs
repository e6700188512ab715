using UnityEngine;

namespace Rill
{
    /// <summary>The ground of a Terrain Collider that a fluid takes by layer.</summary>
    sealed class TerrainColliderGround : IColliderGround
    {
        readonly TerrainCollider collider;
        TerrainData used;       // null for none

        public TerrainColliderGround(TerrainCollider collider) => this.collider = collider;

        public string LeftOut { get; private set; }

        public HeightField GetHeights(out string problem)
        {
            TerrainData data = collider.terrainData;
            if (!ReferenceEquals(data, used))
                Use(data);
            LeftOut = null;
            if (data == null)
            {
                problem = "its Terrain Collider has no terrain data. Assign some.";
                return null;
            }
            TerrainHeights heights = TerrainHeightsCache.Of(data);
            LeftOut = heights.HasHoles ? TerrainHeights.HolesProblem : null;
            problem = heights.Problem;
            return heights.Field;
        }

        public void Dispose() => Use(null);

        void Use(TerrainData data)
        {
            if (!ReferenceEquals(used, null))
                TerrainHeightsCache.Release(used);
            used = data != null ? data : null;
            if (used != null)
                TerrainHeightsCache.Use(used);
        }
    }
}
