using System;
using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>Looks a mesh through before it is baked: what is wrong, how often, and what the baker will do about it.</summary>
    public static class MeshCheck
    {
        /// <summary>Pairs of triangles that are tested for crossing each other at most, unless told otherwise.</summary>
        public const long MaxCrossingTests = 20_000_000;

        /// <exception cref="ArgumentException">The mesh cannot be read by scripts.</exception>
        public static MeshReport Run(Mesh mesh, long maxCrossingTests = MaxCrossingTests) => Run(TriangleMesh.Of(mesh), maxCrossingTests);

        /// <param name="maxCrossingTests">Bounds the time for meshes whose triangles crowd; 0 looks for no crossings.</param>
        public static MeshReport Run(TriangleMesh mesh, long maxCrossingTests = MaxCrossingTests) => Run(mesh, maxCrossingTests, null);

        /// <summary>Checks on any thread, with progress.</summary>
        /// <param name="maxCrossingTests">Bounds the time for meshes whose triangles crowd; 0 looks for no crossings.</param>
        /// <param name="progress">Told the fraction that is done, 0 to 1, and the stage, and asked whether to go on. Null for none.</param>
        /// <returns>Null if it was canceled.</returns>
        public static MeshReport Run(TriangleMesh mesh, long maxCrossingTests, Func<float, string, bool> progress)
        {
            const float EdgesFraction = 0.2f, CrossingsFraction = 0.5f;
            if (mesh == null)
                throw new ArgumentNullException(nameof(mesh));
            if (progress != null && !progress(0f, "Checking edges"))
                return null;
            bool GoOn(float from, float to, float fraction, string stage) => progress == null || progress(math.lerp(from, to, fraction), stage);
            var edges = new MeshEdges(new BakedTriangles(mesh));
            int nonFinite = 0;
            foreach (Vector3 vertex in mesh.Vertices)
                nonFinite += math.all(math.isfinite((float3)vertex)) ? 0 : 1;
            SelfIntersections.Count? crossing = SelfIntersections.Find(edges, maxCrossingTests,
                fraction => GoOn(EdgesFraction, EdgesFraction + CrossingsFraction, fraction, "Looking for triangles that cross"));
            if (crossing == null)
                return null;
            float[] thickness = MeshThickness.Of(edges, fraction => GoOn(EdgesFraction + CrossingsFraction, 1f, fraction, "Measuring thickness"));
            if (thickness == null)
                return null;
            FarTriangles far = FarTriangles.Of(edges);
            MeshReport near = far == null ? null : Run(far.LeaveOut(mesh), maxCrossingTests, progress == null ? (Func<float, string, bool>)null
                : (fraction, stage) => progress(1f, stage));
            return far != null && near == null ? null
                : new MeshReport(mesh, edges, nonFinite, crossing.Value, new MeshLosses(edges, thickness, far), near);
        }
    }
}
