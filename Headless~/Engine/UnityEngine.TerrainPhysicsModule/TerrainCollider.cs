namespace UnityEngine
{
    /// <summary>
    /// The ground of a terrain at its object's position, whatever its rotation and scale. Queries find the box around the patches below and
    /// over the queried one, where Unity finds the patches.
    /// </summary>
    public class TerrainCollider : Collider
    {
        public TerrainData terrainData { get; set; }

        internal override bool Overlaps(Vector3 center, Vector3 half, Quaternion rotation)
        {
            if (terrainData == null)
                return false;
            Vector3 reach = Reach(half, rotation), size = terrainData.size, from = center - reach - Position, to = center + reach - Position;
            if (to.x < 0f || to.z < 0f || from.x > size.x || from.z > size.z)
                return false;
            int last = terrainData.heightmapResolution - 1;
            float lowest = float.PositiveInfinity, highest = float.NegativeInfinity;
            for (int z = First(from.z, size.z, last); z <= Last(to.z, size.z, last); z++)
                for (int x = First(from.x, size.x, last); x <= Last(to.x, size.x, last); x++)
                {
                    float height = terrainData.HeightAt(x, z);
                    lowest = Mathf.Min(lowest, height);
                    highest = Mathf.Max(highest, height);
                }
            return lowest <= to.y && highest >= from.y;
        }

        // Of the heights whose patches the box stands over or below.
        static int First(float from, float size, int last) => Mathf.Clamp(Mathf.FloorToInt(from / size * last), 0, last);

        static int Last(float to, float size, int last) => Mathf.Clamp(Mathf.CeilToInt(to / size * last), 0, last);

        // Half sides of the upright box around a box.
        static Vector3 Reach(Vector3 half, Quaternion rotation)
        {
            Vector3 reach = Vector3.zero;
            for (int i = 0; i < 3; i++)
            {
                Vector3 side = Vector3.zero;
                side[i] = half[i];
                side = rotation * side;
                reach += new Vector3(Mathf.Abs(side.x), Mathf.Abs(side.y), Mathf.Abs(side.z));
            }
            return reach;
        }
    }
}
