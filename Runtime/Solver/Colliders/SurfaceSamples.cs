using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>Samples the surfaces of shapes.</summary>
    static class SurfaceSamples
    {
        const float Step = 1.5f;                // d between samples, as far as their number allows
        const int MinAlong = 2, MaxAlong = 8;   // samples along a side
        const float GoldenAngle = 2.3999632f;

        /// <summary>Appends samples of a shape's surface: their areas add up to that of the shape, and as vectors to none.</summary>
        /// <param name="shape">World space, m.</param>
        /// <param name="field">Field of a mesh; null for other shapes.</param>
        /// <param name="spacing">Spacing of the particles, m.</param>
        public static void Append(List<SurfaceSample> to, in ColliderMotion shape, SignedDistanceField field, float spacing)
        {
            int first = to.Count;
            switch (shape.shape)
            {
                case ColliderShape.Box:
                    AppendBox(to, shape.size, spacing);
                    break;
                case ColliderShape.Sphere:
                    AppendBall(to, shape.size.x, 0f, spacing);
                    break;
                case ColliderShape.Capsule:
                    AppendBall(to, shape.size.x, shape.size.y, spacing);
                    AppendTube(to, shape.size.x, shape.size.y, spacing);
                    break;
                case ColliderShape.Mesh when field != null:
                    AppendMesh(to, shape, field);
                    break;
            }
            for (int i = first; i < to.Count; i++)
                to[i] = new SurfaceSample
                {
                    position = shape.end.position + math.mul(shape.end.rotation, to[i].position),
                    area = math.mul(shape.end.rotation, to[i].area),
                };
        }

        static int Along(float side, float spacing) => (int)math.clamp(math.ceil(side / (Step * spacing)), MinAlong, MaxAlong);

        static void AppendBox(List<SurfaceSample> to, float3 half, float spacing)
        {
            for (int axis = 0; axis < 3; axis++)
            {
                int u = (axis + 1) % 3, v = (axis + 2) % 3;
                int countU = Along(2f * half[u], spacing), countV = Along(2f * half[v], spacing);
                float area = 4f * half[u] * half[v] / (countU * countV);
                for (int i = 0; i < countU; i++)
                    for (int j = 0; j < countV; j++)
                        for (int side = -1; side <= 1; side += 2)
                        {
                            SurfaceSample sample = default;
                            sample.position[axis] = side * half[axis];
                            sample.position[u] = half[u] * ((2f * i + 1f) / countU - 1f);
                            sample.position[v] = half[v] * ((2f * j + 1f) / countV - 1f);
                            sample.area[axis] = side * area;
                            to.Add(sample);
                        }
            }
        }

        // Appends both ends of a capsule, each half of a ball.
        static void AppendBall(List<SurfaceSample> to, float radius, float halfStraight, float spacing)
        {
            float whole = 4f * math.PI * radius * radius;
            int pairs = (int)math.clamp(0.5f * whole / (Step * spacing * Step * spacing), 32f, 128f);
            for (int i = 0; i < pairs; i++)
            {
                float y = (i + 0.5f) / pairs;
                math.sincos(i * GoldenAngle, out float sine, out float cosine);
                float across = math.sqrt(1f - y * y);
                var normal = new float3(across * cosine, y, across * sine);
                for (int side = -1; side <= 1; side += 2)
                    to.Add(new SurfaceSample
                    {
                        position = side * (radius * normal + new float3(0f, halfStraight, 0f)),
                        area = side * whole / (2 * pairs) * normal,
                    });
            }
        }

        static void AppendTube(List<SurfaceSample> to, float radius, float halfStraight, float spacing)
        {
            int around = 2 * Along(math.PI * radius, spacing), along = Along(2f * halfStraight, spacing);
            float area = 4f * math.PI * radius * halfStraight / (around * along);
            for (int i = 0; i < around; i++)
            {
                math.sincos(2f * math.PI * (i + 0.5f) / around, out float sine, out float cosine);
                var normal = new float3(cosine, 0f, sine);
                for (int j = 0; j < along; j++)
                    to.Add(new SurfaceSample
                    {
                        position = radius * normal + new float3(0f, halfStraight * ((2f * j + 1f) / along - 1f), 0f),
                        area = area * normal,
                    });
            }
        }

        static void AppendMesh(List<SurfaceSample> to, in ColliderMotion shape, SignedDistanceField field)
        {
            float scale = shape.fieldUnit;
            float3 center = field.Bounds.center;
            float3 mirror = math.select(new float3(1f), new float3(-1f), shape.mirrored);
            foreach (SurfaceSample patch in field.SurfacePatches)
                to.Add(new SurfaceSample
                {
                    position = mirror * (patch.position - center) * scale,
                    area = mirror * patch.area * (scale * scale),
                });
        }
    }
}
