using System.Collections.Generic;
using Unity.Mathematics;

namespace Rill
{
    /// <summary>
    /// A full tree over triangles in order: leaves of four triangles, parents of four children, one root. Levels lie one
    /// after the other, so that child and parent follow from the index alone.
    /// </summary>
    static class ClusterLevels
    {
        /// <summary>triangles of a leaf and children of a cluster</summary>
        [GenerateHlsl("MeshSdf")] public const int Fan = 4;

        /// <summary>First cluster of each level and how many there are, leaves first.</summary>
        public static uint2[] Of(int triangles)
        {
            var levels = new List<uint2>();
            uint first = 0, count = (uint)triangles;
            do
            {
                count = (count + Fan - 1) / Fan;
                levels.Add(new uint2(first, count));
                first += count;
            }
            while (count > 1);
            return levels.ToArray();
        }
    }
}
