using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>The mesh and the field of water of a known shape, in the buffers that the water's shaders read: surface nets on the nodes of the
    /// field, with vertices put on the shape itself.</summary>
    sealed class ShapeMesh : IDisposable
    {
        const float Far = 2f;
        const int Side = 5, AlongField = 32;       // texels of a brick in the field, bricks along x and y

        /// <summary>Distance to the surface at a point of the domain, d, above 0 in water.</summary>
        public delegate float Shape(float3 p);

        readonly Shape shape;
        readonly float3 size;
        readonly float cell;
        readonly int3 bricks, cells;
        readonly List<uint> vertices = new List<uint>();
        readonly List<int> triangles = new List<int>();
        GraphicsBuffer vertexBuffer, indexBuffer, arguments, top;
        Texture3D field;

        /// <param name="size">Of the domain, d.</param>
        /// <param name="cell">Distance between nodes, d.</param>
        /// <param name="displacement">Of all vertices in the last substep, d.</param>
        public ShapeMesh(Vector3 size, Shape shape, float cell = 0.75f, Vector3 displacement = default)
        {
            this.size = size;
            this.shape = shape;
            this.cell = cell;
            // Nodes from half a cell before the domain to the first beyond it.
            cells = (int3)math.floor(this.size / cell + 0.5f) + 1;
            bricks = (cells + 4) / 4;
            MakeField();
            MakeSurface(displacement);
            vertexBuffer = Raw("Rill.Tests.Vertices", GraphicsBuffer.Target.Raw, vertices.ToArray());
            indexBuffer = Raw("Rill.Tests.Indices", GraphicsBuffer.Target.Index | GraphicsBuffer.Target.Raw, triangles.ToArray());
            arguments = Raw("Rill.Tests.Arguments", GraphicsBuffer.Target.IndirectArguments | GraphicsBuffer.Target.Raw,
                new[] { triangles.Count, 1, 0, 0, 0 });
        }

        public int Triangles => triangles.Count / 3;

        /// <param name="spacing">m.</param>
        public MeshFrame Frame(Matrix4x4 domainToWorld, float spacing, float lag = 0f) => new MeshFrame
        {
            rayScale = 1f, fineLines = 1440,
            vertices = vertexBuffer, indices = indexBuffer, arguments = arguments, top = top, field = field, cell = cell,
            fieldTexel = new Vector4(1f / field.width, 1f / field.height, 1f / field.depth),
            bricks = new Vector3Int(bricks.x, bricks.y, bricks.z), domainToWorld = domainToWorld, domainSize = size, spacing = spacing,
            lag = new Vector4(lag, 0f, 0f, 0f),
            bounds = new Bounds(domainToWorld.MultiplyPoint3x4(0.5f * size), Vector3.one * (math.length(size) * spacing)),
        };

        public void Dispose()
        {
            GpuBuffer.Release(ref vertexBuffer);
            GpuBuffer.Release(ref indexBuffer);
            GpuBuffer.Release(ref arguments);
            GpuBuffer.Release(ref top);
            UnityEngine.Object.DestroyImmediate(field);
        }

        // Shapes, for those that have no own.

        public static float Ball(float3 p, float3 center, float radius) => radius - math.distance(p, center);

        public static float Box(float3 p, float3 half)
        {
            float3 q = math.abs(p) - half;
            return -(math.length(math.max(q, 0f)) + math.min(math.cmax(q), 0f));
        }

        static GraphicsBuffer Raw<T>(string name, GraphicsBuffer.Target target, T[] values) where T : struct
        {
            var buffer = new GraphicsBuffer(target, Math.Max(values.Length, 4), sizeof(uint)) { name = name };
            if (values.Length > 0)
                buffer.SetData(values);
            return buffer;
        }

        float3 At(int3 node) => ((float3)node - 0.5f) * cell;

        bool IsInDomain(float3 p) => math.all(p >= 0f) && math.all(p <= size);

        float Value(int3 node)
        {
            float3 p = At(node);
            return IsInDomain(p) ? math.clamp(shape(p), -Far, Far) : -Far;
        }

        void MakeField()
        {
            var tops = new uint[bricks.x * bricks.y * bricks.z];
            var stored = new List<int3>();      // the first nodes of bricks
            for (int i = 0; i < tops.Length; i++)
            {
                int3 first = 4 * new int3(i % bricks.x, i / bricks.x % bricks.y, i / (bricks.x * bricks.y));
                bool isAir = true, isWater = true;
                for (int l = 0; l < 64; l++)
                {
                    float value = Value(first + new int3(l & 3, l >> 2 & 3, l >> 4));
                    isAir &= value <= -Far;
                    isWater &= value >= Far;
                }
                tops[i] = isAir ? 0u : isWater ? 1u : (uint)(stored.Count + 2);
                if (!isAir && !isWater)
                    stored.Add(first);
            }
            top = GpuBuffer.Structured<uint>("Rill.Tests.Top", tops.Length);
            top.SetData(tops);
            const int width = Side * AlongField, perLayer = AlongField * AlongField;
            field = new Texture3D(width, width, Side * math.max((stored.Count + perLayer - 1) / perLayer, 1), TextureFormat.RHalf, false)
            {
                filterMode = FilterMode.Bilinear, wrapMode = TextureWrapMode.Clamp,
            };
            var texels = new ushort[width * width * field.depth];
            for (int i = 0; i < stored.Count; i++)
                for (int t = 0; t < Side * Side * Side; t++)
                {
                    int3 local = new int3(t % Side, t / Side % Side, t / (Side * Side));
                    int3 at = Side * new int3(i % AlongField, i / AlongField % AlongField, i / perLayer) + local;
                    texels[(at.z * width + at.y) * width + at.x] = Mathf.FloatToHalf(Value(stored[i] + local));
                }
            field.SetPixelData(texels, 0);
            field.Apply(false);
        }

        float3 Normal(float3 p)
        {
            const float h = 0.02f;
            float3 x = new float3(h, 0f, 0f), y = new float3(0f, h, 0f), z = new float3(0f, 0f, h);
            return -math.normalizesafe(new float3(shape(p + x) - shape(p - x), shape(p + y) - shape(p - y), shape(p + z) - shape(p - z)), math.up());
        }

        // Point of a cell whose nodes differ: the mean of where its edges are crossed, then on the surface; at a wall of the domain on that.
        float3 Point(int3 of)
        {
            float3 sum = 0f;
            int count = 0;
            for (int edge = 0; edge < 12; edge++)
            {
                int axis = edge / 4, u = (axis + 1) % 3, v = (axis + 2) % 3;
                int3 a = of;
                a[u] += edge & 1;
                a[v] += edge >> 1 & 1;
                int3 b = a;
                b[axis]++;
                float atA = Value(a), atB = Value(b);
                if (atA > 0f == atB > 0f)
                    continue;
                sum += math.lerp(At(a), At(b), atA / (atA - atB));
                count++;
            }
            float3 p = sum / math.max(count, 1);
            for (int i = 0; i < 4; i++)
            {
                float3 inside = math.clamp(p, 0f, size);
                p = inside + math.clamp(shape(inside), -cell, cell) * (IsAtWall(of) ? 0f : 1f) * Normal(inside);
            }
            for (int axis = 0; axis < 3; axis++)
            {
                if (of[axis] == 0)
                    p[axis] = 0f;
                else if (of[axis] == cells[axis] - 1)
                    p[axis] = size[axis];
            }
            return p;
        }

        bool IsAtWall(int3 of) => math.any(of == 0) || math.any(of == cells - 1);

        void MakeSurface(float3 displacement)
        {
            var known = new Dictionary<int4, int>();
            for (int z = 0; z < cells.z; z++)
                for (int y = 0; y < cells.y; y++)
                    for (int x = 0; x < cells.x; x++)
                        for (int axis = 0; axis < 3; axis++)
                            Quad(new int3(x, y, z), axis, displacement, known);
        }

        // Around an edge from a node to the next along an axis, if one end is in water.
        void Quad(int3 a, int axis, float3 displacement, Dictionary<int4, int> known)
        {
            int3 b = a;
            b[axis]++;
            bool isWater = Value(a) > 0f;
            int u = (axis + 1) % 3, v = (axis + 2) % 3;
            if (isWater == Value(b) > 0f || a[u] == 0 || a[v] == 0)
                return;
            int wall = IsInDomain(At(a)) && IsInDomain(At(b)) ? 0 : 1 + 2 * axis + (isWater ? 1 : 0);
            var corners = new int[4];
            for (int i = 0; i < 4; i++)
            {
                int3 of = a;
                of[u] -= i == 0 || i == 3 ? 1 : 0;
                of[v] -= i < 2 ? 1 : 0;
                corners[i] = Vertex(of, wall, displacement, known);
            }
            int second = isWater ? 3 : 1, third = isWater ? 1 : 3;
            // Unity's front faces are clockwise.
            triangles.AddRange(new[] { corners[0], corners[third], corners[2], corners[0], corners[2], corners[second] });
        }

        int Vertex(int3 of, int wall, float3 displacement, Dictionary<int4, int> known)
        {
            if (known.TryGetValue(new int4(of, wall), out int index))
                return index;
            index = known.Count;
            known.Add(new int4(of, wall), index);
            float3 p = Point(of), normal = Normal(p);
            if (wall > 0)
            {
                normal = 0f;
                normal[(wall - 1) / 2] = (wall - 1) % 2 == 1 ? 1f : -1f;
            }
            vertices.Add(math.asuint(p.x));
            vertices.Add(math.asuint(p.y));
            vertices.Add(math.asuint(p.z));
            vertices.Add(Snorm(normal.x) | Snorm(normal.y) << 16);
            vertices.Add(Snorm(normal.z));
            vertices.Add(Mathf.FloatToHalf(displacement.x) | (uint)Mathf.FloatToHalf(displacement.y) << 16);
            vertices.Add(Mathf.FloatToHalf(displacement.z) | (uint)Mathf.FloatToHalf(wall > 0 ? 1f : 0f) << 16);
            return index;
        }

        static uint Snorm(float value) => (uint)(ushort)(short)math.round(math.clamp(value, -1f, 1f) * 32767f);
    }
}
