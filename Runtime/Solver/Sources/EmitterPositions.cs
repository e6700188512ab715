using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;
using Random = Unity.Mathematics.Random;
using static System.FormattableString;

namespace Rill
{
    /// <summary>
    /// Positions at which an emitter puts particles: those of a cross-section, which the flow fills again and again, or those of a
    /// volume. Spacings, in the emitter's frame; made again when its shape changes.
    /// </summary>
    sealed class EmitterPositions
    {
        /// <summary>Most positions of an emitter: more are more than any step could try.</summary>
        public const int MaxPositions = 1 << 20;

        const float SurfaceClearance = 0.85f;       // d, between two positions of a surface
        const int DartsPerPlace = 8;
        const uint Seed = 0x6E624EB7u;

        EmitterPositions(List<float3> positions, List<float3> directions)
        {
            Data = new float4[2 * positions.Count];
            for (int i = 0; i < positions.Count; i++)
            {
                Data[2 * i] = new float4(positions[i], 0f);
                Data[2 * i + 1] = new float4(directions != null ? directions[i] : new float3(0f, 0f, 1f), 0f);
                Radius = math.max(Radius, math.length(positions[i]));
                HalfExtent = math.max(HalfExtent, math.abs(positions[i]));
            }
        }

        /// <summary>Position and direction of flow, xyz each, one after the other.</summary>
        public float4[] Data { get; }
        public int Count => Data.Length / 2;
        /// <summary>Furthest position from the origin, d.</summary>
        public float Radius { get; }
        /// <summary>Furthest positions from the origin along each axis, d.</summary>
        public float3 HalfExtent { get; }
        /// <summary>Half of what the positions of a plane cross-section take, along x and y, d; y is 0 for a round one, whose radius x is. 0 for a
        /// volume and for a surface.</summary>
        public float2 HalfSection { get; private set; }
        /// <summary>Whether they fill a volume, not a cross-section.</summary>
        public bool FillsVolume { get; private set; }
        /// <summary>Whether a low rate uses all of the cross-section's positions in turn, not only the innermost.</summary>
        public bool UsesAllPositions { get; private set; }

        /// <param name="size">Size of a box, m.</param>
        /// <param name="radius">Radius of a sphere or disc, m.</param>
        /// <param name="mesh">Mesh of a surface.</param>
        /// <param name="scale">Scale of the mesh.</param>
        /// <param name="spacing">m.</param>
        /// <param name="problem">What is wrong with the shape, and null where nothing is.</param>
        /// <returns>Null where there is a problem.</returns>
        public static EmitterPositions Of(EmitterShape shape, EmitterMode mode, float3 size, float radius, Mesh mesh, float3 scale,
            float spacing, out string problem)
        {
            problem = shape == EmitterShape.MeshSurface ? ProblemOf(mesh, scale) : ProblemOf(shape, size, radius, mode);
            if (problem != null)
                return null;
            size /= spacing;
            radius /= spacing;
            if (shape == EmitterShape.MeshSurface)
                return OfSurface(mesh, scale / spacing, out problem);

            bool round = shape != EmitterShape.Box;
            float extent = round ? 2f * radius : math.cmax(size);
            float3 across = round ? 2f * radius : size;
            double positions = mode == EmitterMode.Fill && shape != EmitterShape.Disc ? (double)across.x * across.y * across.z
                : (double)across.x * across.y;
            if (positions > MaxPositions || extent > SolverLayout.MaxSpacingsAcross)
            {
                problem = Invariant($"its shape has room for more than {MaxPositions:N0} particles at once. Shrink it or raise the ") +
                    "particle spacing.";
                return null;
            }
            if (mode == EmitterMode.Fill)
                return new EmitterPositions(Volume(shape, size, radius), null) { FillsVolume = true };

            List<float3> section = round ? Disc(radius) : Rectangle(size.xy);
            if (mode == EmitterMode.Spray)
                Shuffle(section, null);
            float2 half = round ? new float2(math.sqrt(section.Count / math.PI), 0f) : 0.5f * (float2)CountsOf(size.xy);
            return new EmitterPositions(section, null) { UsesAllPositions = mode == EmitterMode.Spray, HalfSection = half };
        }

        static string ProblemOf(EmitterShape shape, float3 size, float radius, EmitterMode mode)
        {
            if (shape == EmitterShape.Box)
            {
                float3 needed = mode == EmitterMode.Fill ? size : new float3(size.xy, 1f);
                return math.cmin(needed) > 0f ? null : Invariant($"its box of {size.x} x {size.y} x {size.z} m has no size. Set its ") +
                    "sides above 0.";
            }
            return radius > 0f ? null : Invariant($"its {shape} has the radius {radius} m. Set it above 0.");
        }

        static string ProblemOf(Mesh mesh, float3 scale)
        {
            if (mesh == null)
                return "it has no mesh. Set one or choose another shape.";
            if (!mesh.isReadable)
                return $"its mesh '{mesh.name}' cannot be read. Turn on Read/Write in the mesh's import settings.";
            if (mesh.triangles.Length == 0)
                return $"its mesh '{mesh.name}' has no triangles. Choose another.";
            return math.all(math.isfinite(scale)) ? null : Invariant($"its scale {scale} is not finite. Set it to numbers.");
        }

        // A spiral of even density, from the center on (Vogel 1979): a low rate uses the inner ones.
        static List<float3> Disc(float radius)
        {
            const float GoldenAngle = 2.39996323f;
            int count = math.max((int)math.floor(math.PI * radius * radius), 1);
            var positions = new List<float3>(count);
            for (int i = 0; i < count; i++)
            {
                float r = count > 1 ? math.sqrt((i + 0.5f) / math.PI) : 0f;
                positions.Add(new float3(r * math.cos(i * GoldenAngle), r * math.sin(i * GoldenAngle), 0f));
            }
            return positions;
        }

        static int2 CountsOf(float2 size) => math.max((int2)math.floor(size + 1e-3f), 1);

        // A square lattice, from the center on.
        static List<float3> Rectangle(float2 size)
        {
            int2 counts = CountsOf(size);
            var positions = new List<float3>(counts.x * counts.y);
            for (int y = 0; y < counts.y; y++)
                for (int x = 0; x < counts.x; x++)
                    positions.Add(new float3(new float2(x, y) - (float2)(counts - 1) * 0.5f, 0f));
            positions.Sort((a, b) => Ring(a).CompareTo(Ring(b)));
            return positions;

            // The fraction of the rectangle's size at which a position lies, and then its direction, so that no two are equal.
            double Ring(float3 position)
            {
                float2 fraction = math.abs(position.xy) / (float2)counts;
                return math.round(math.max(fraction.x, fraction.y) * 1e6) + (math.atan2(position.y, position.x) + math.PI) * 0.1;
            }
        }

        // A cubic lattice, from the bottom up.
        static List<float3> Volume(EmitterShape shape, float3 size, float radius)
        {
            if (shape != EmitterShape.Box)
                size = new float3(2f * radius, 2f * radius, shape == EmitterShape.Disc ? 1f : 2f * radius);
            int3 counts = math.max((int3)math.floor(size + 1e-3f), 1);
            var positions = new List<float3>();
            for (int y = 0; y < counts.y; y++)
                for (int z = 0; z < counts.z; z++)
                    for (int x = 0; x < counts.x; x++)
                    {
                        float3 position = new float3(x, y, z) - (float3)(counts - 1) * 0.5f;
                        if (shape == EmitterShape.Box || math.length(position) <= math.max(radius - 0.5f, 0.87f))
                            positions.Add(position);
                    }
            return positions;
        }

        // Points anywhere on the triangles, by area, none nearer than a particle to another.
        static EmitterPositions OfSurface(Mesh mesh, float3 scale, out string problem)
        {
            Vector3[] vertices = mesh.vertices;
            int[] triangles = mesh.triangles;
            var positions = new List<float3>();
            var normals = new List<float3>();
            var taken = new Dictionary<int3, List<int>>();
            var random = new Random(Seed);
            double total = 0.0;
            var darts = new List<int>();        // triangle of each
            for (int t = 0; t < triangles.Length; t += 3)
            {
                float area = math.length(Normal(t)) * 0.5f;
                if (!math.isfinite(area))
                    continue;
                total += area;
                if (total > MaxPositions / DartsPerPlace)
                {
                    problem = $"the surface of its mesh '{mesh.name}' has room for more than " +
                        Invariant($"{MaxPositions / DartsPerPlace:N0} particles at once. Scale it down or raise the particle spacing.");
                    return null;
                }
                float wanted = area * DartsPerPlace;
                int count = (int)wanted + (random.NextFloat() < wanted - (int)wanted ? 1 : 0);
                for (int i = 0; i < count; i++)
                    darts.Add(t);
            }
            for (int i = darts.Count - 1; i > 0; i--)
            {
                int other = random.NextInt(i + 1);
                (darts[i], darts[other]) = (darts[other], darts[i]);
            }
            foreach (int t in darts)
                Throw(t);
            problem = positions.Count > 0 ? null
                : $"the surface of its mesh '{mesh.name}' is too small for a particle. Scale it up or lower the particle spacing.";
            return positions.Count > 0 ? new EmitterPositions(positions, normals) { UsesAllPositions = true } : null;

            float3 Vertex(int corner) => (float3)vertices[triangles[corner]] * scale;

            float3 Normal(int t) => math.cross(Vertex(t + 1) - Vertex(t), Vertex(t + 2) - Vertex(t));

            void Throw(int t)
            {
                float2 uv = random.NextFloat2();
                if (uv.x + uv.y > 1f)
                    uv = 1f - uv;
                float3 position = Vertex(t) + uv.x * (Vertex(t + 1) - Vertex(t)) + uv.y * (Vertex(t + 2) - Vertex(t));
                int3 cell = (int3)math.floor(position / SurfaceClearance);
                for (int n = 0; n < 27; n++)
                {
                    if (!taken.TryGetValue(cell + new int3(n % 3, n / 3 % 3, n / 9) - 1, out List<int> near))
                        continue;
                    foreach (int i in near)
                        if (math.distancesq(positions[i], position) < SurfaceClearance * SurfaceClearance)
                            return;
                }
                if (!taken.TryGetValue(cell, out List<int> own))
                    taken[cell] = own = new List<int>();
                own.Add(positions.Count);
                positions.Add(position);
                normals.Add(math.normalizesafe(Normal(t), new float3(0f, 0f, 1f)));
            }
        }

        static void Shuffle(List<float3> positions, List<float3> directions)
        {
            var random = new Random(Seed);
            for (int i = positions.Count - 1; i > 0; i--)
            {
                int other = random.NextInt(i + 1);
                (positions[i], positions[other]) = (positions[other], positions[i]);
                if (directions != null)
                    (directions[i], directions[other]) = (directions[other], directions[i]);
            }
        }
    }
}
