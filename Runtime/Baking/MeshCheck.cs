using System;
using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>Looks a mesh through before it is baked: what is wrong, how often, and what the baker will do about it.</summary>
    public static class MeshCheck
    {
        /// <summary>Pairs of triangles that are tested for crossing each other at most, unless told otherwise.</summary>
        public const long MostCrossingTests = 20_000_000;

        /// <exception cref="ArgumentException">The mesh cannot be read by scripts.</exception>
        public static MeshReport Run(Mesh mesh, long mostCrossingTests = MostCrossingTests) => Run(TriangleMesh.Of(mesh), mostCrossingTests);

        /// <param name="mostCrossingTests">Bounds the time for meshes whose triangles crowd; 0 looks for no crossings.</param>
        public static MeshReport Run(TriangleMesh mesh, long mostCrossingTests = MostCrossingTests)
        {
            if (mesh == null)
                throw new ArgumentNullException(nameof(mesh));
            var edges = new MeshEdges(new BakedTriangles(mesh));
            int nonFinite = 0;
            foreach (Vector3 vertex in mesh.Vertices)
                nonFinite += math.all(math.isfinite((float3)vertex)) ? 0 : 1;
            return new MeshReport(mesh, edges, nonFinite, SelfIntersections.Find(edges, mostCrossingTests));
        }
    }
}
