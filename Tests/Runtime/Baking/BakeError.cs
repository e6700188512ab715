using System;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>A bake against an oracle, in voxels: within two voxels of the surface, and beyond.</summary>
    sealed class BakeError
    {
        public double Band, Beyond, BeyondMean;
        public int BandVoxels, BeyondVoxels;
        /// <summary>Voxels more than one from the surface, and those of them on the wrong side.</summary>
        public int Signs, WrongSigns;

        /// <param name="every">1 looks at every voxel, 7 at every seventh.</param>
        /// <param name="distance">Unsigned, m, at a point.</param>
        /// <param name="isInside">Null compares no signs.</param>
        public static BakeError Of(SdfBake bake, int every, Func<double3, double> distance, Func<double3, bool> isInside)
        {
            var error = new BakeError();
            double sum = 0;
            for (int i = 0; i < bake.Distances.Length; i += every)
            {
                double3 p = CenterOf(bake, i);
                double expected = distance(p) / bake.VoxelSize;
                double off = Math.Abs(Math.Abs(bake.Distances[i]) / (double)bake.VoxelSize - expected);
                // No comparison with a distance that is NaN may pass.
                off = double.IsNaN(off) ? double.PositiveInfinity : off;
                if (expected <= 2)
                {
                    error.Band = Math.Max(error.Band, off);
                    error.BandVoxels++;
                }
                else
                {
                    error.Beyond = Math.Max(error.Beyond, off);
                    error.BeyondVoxels++;
                    sum += off;
                }
                if (isInside != null && expected > 1)
                {
                    error.Signs++;
                    error.WrongSigns += isInside(p) != bake.Distances[i] < 0 ? 1 : 0;
                }
            }
            error.BeyondMean = sum / Math.Max(error.BeyondVoxels, 1);
            return error;
        }

        /// <summary>Against all triangles, one after the other.</summary>
        public static BakeError OfTriangles(SdfBake bake, TriangleMesh mesh, int every, bool signs = true)
        {
            return Of(bake, every, p => MeshDistance.Unsigned(mesh, p), signs ? p => MeshDistance.Winding(mesh, p) > 0.5 : (Func<double3, bool>)null);
        }

        public static double3 CenterOf(SdfBake bake, int index)
        {
            Vector3Int n = bake.Resolution;
            return (double3)(float3)bake.Bounds.min + (double)bake.VoxelSize * (new double3(index % n.x, index / n.x % n.y, index / n.x / n.y) + 0.5);
        }

        public override string ToString() => $"band {Band:E1} of {BandVoxels}, beyond {Beyond:E1}, mean {BeyondMean:E1} of " +
            $"{BeyondVoxels}, signs wrong {WrongSigns} of {Signs}";
    }
}
