using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests.Reference
{
    /// <summary>A cup that is open above and shaken, as a mesh. Lengths in d, in the cup's frame: the axis is y, the floor's upper side at
    /// 0.</summary>
    sealed class OpenCup
    {
        public const float Radius = 7f, Depth = 14f, Filled = 6f;       // inside
        public static readonly float3 Box = new float3(34f, 30f, 34f);  // in which it is shaken
        const int Sides = 48;

        readonly float wallMiddle, floorMiddle;

        OpenCup(TriangleMesh mesh, float wall, float shell)
        {
            Mesh = mesh;
            ShellThickness = shell;
            wallMiddle = Radius + 0.5f * wall;
            floorMiddle = -0.5f * wall;
        }

        public TriangleMesh Mesh { get; }
        /// <summary>For the bake; 0 for a solid wall.</summary>
        public float ShellThickness { get; }

        /// <summary>With a wall and a floor of this thickness, a closed mesh.</summary>
        public static OpenCup Solid(float wall) =>
            new OpenCup(Turned($"Cup {wall}", new float2(0f, -wall), new float2(Radius + wall, -wall), new float2(Radius + wall, Depth),
            new float2(Radius, Depth), new float2(Radius, 0f), new float2(0f, 0f)), wall, 0f);

        /// <summary>A surface without a thickness, which the bake gives this one: half of it to each side.</summary>
        public static OpenCup Shell(float thickness)
            => new OpenCup(Turned("Cup", new float2(0f, 0f), new float2(Radius, 0f), new float2(Radius, Depth)), 0f, thickness);

        /// <param name="voxel">d; a shell is at least two of them thick.</param>
        public SignedDistanceField Bake(float voxel)
        {
            MeshSdfSettings settings = MeshSdfSettings.Default;
            settings.voxelSize = voxel;
            settings.shellThickness = ShellThickness;
            return SignedDistanceField.Create(MeshSdfBaker.Bake(Mesh, settings));
        }

        /// <summary>The collider at rest at a pose. The field's volume need not be about the cup's origin.</summary>
        public static ColliderMotion Obstacle(SignedDistanceField field, RigidPose cup)
        {
            Bounds bounds = field.Bounds;
            RigidPose pose = OfField(field, cup);
            return new ColliderMotion
            {
                shape = ColliderShape.Mesh, size = bounds.extents, start = pose, end = pose,
                contributesDensity = true, field = field.Texture, voxel = field.VoxelSize, fieldUnit = 1f
            };
        }

        public static RigidPose OfField(SignedDistanceField field, RigidPose cup)
            => new RigidPose(cup.position + math.mul(cup.rotation, field.Bounds.center), cup.rotation);

        /// <summary>Up to 0.2 g and 7 degrees: level enough that nothing comes near the rim.</summary>
        public static RigidPose Gently(float time)
        {
            float ease = math.saturate(0.5f * time);
            return Pose(ease * new float3(2.4f * math.sin(4f * time), 1f * math.sin(5f * time), 1.5f * math.sin(3f * time)),
                ease * new float3(0.12f * math.sin(2f * time), 0.5f * time, 0.12f * math.sin(3f * time)));
        }

        /// <summary>Up to 4 g, and tilted by up to half a right angle: most of the water is thrown out.</summary>
        public static RigidPose Hard(float time)
        {
            float ease = math.saturate(2f * time);
            return Pose(ease * new float3(6f * math.sin(11f * time), 3f * math.sin(17f * time), 4f * math.sin(7f * time)),
                ease * new float3(0.5f * math.sin(2f * time), 0.7f * time, 0.8f * math.sin(3f * time)));
        }

        static RigidPose Pose(float3 path, float3 turn) => new RigidPose(new float3(0.5f, 0.3f, 0.5f) * Box + path, quaternion.Euler(turn));

        /// <summary>Positions of water at rest in the cup at a pose, on a lattice.</summary>
        public static float3[] Water(RigidPose cup)
        {
            var random = new Unity.Mathematics.Random(7u);
            var positions = new List<float3>();
            for (float y = 0.5f; y < Filled; y++)
                for (float x = 0.5f - Radius; x < Radius; x++)
                    for (float z = 0.5f - Radius; z < Radius; z++)
                        if (math.sqrt(x * x + z * z) <= Radius - 0.6f)
                            positions.Add(cup.position + math.mul(cup.rotation, new float3(x, y, z) + random.NextFloat3(-0.02f, 0.02f)));
            return positions.ToArray();
        }

        /// <summary>How each particle came from one side of the wall and floor to the other, step by step.</summary>
        public sealed class Tracer
        {
            enum Side : byte { Unknown, Inside, Above, Outside }

            readonly OpenCup cup;
            readonly Dictionary<uint, Side> last = new Dictionary<uint, Side>();
            readonly HashSet<uint> risen = new HashSet<uint>();

            public Tracer(OpenCup cup) => this.cup = cup;

            /// <summary>Particles that were on one side below the rim's plane in one step and on the other in the next: they went through.</summary>
            public int Through { get; private set; }
            /// <summary>Particles that were inside and rose through the rim's plane, at least once.</summary>
            public int OverTheRim => risen.Count;
            /// <summary>Particles inside and below the rim at the last step.</summary>
            public int Inside { get; private set; }

            /// <param name="positions">d, in the domain's frame, by <paramref name="ids"/>.</param>
            public void Observe(IReadOnlyList<uint> ids, IReadOnlyList<float4> positions, RigidPose pose)
            {
                Inside = 0;
                for (int i = 0; i < ids.Count; i++)
                {
                    float3 local = math.mul(math.conjugate(pose.rotation), positions[i].xyz - pose.position);
                    Side now = local.y >= Depth ? Side.Above : math.length(local.xz) < cup.wallMiddle && local.y > cup.floorMiddle
                        ? Side.Inside : Side.Outside;
                    last.TryGetValue(ids[i], out Side before);
                    if (before == Side.Inside && now == Side.Outside || before == Side.Outside && now == Side.Inside)
                        Through++;
                    if (before == Side.Inside && now == Side.Above)
                        risen.Add(ids[i]);
                    Inside += now == Side.Inside ? 1 : 0;
                    last[ids[i]] = now;
                }
            }
        }

        // The surface that a line of points (radius, height) sweeps about the axis, facing right of the line's direction.
        static TriangleMesh Turned(string name, params float2[] line)
        {
            var vertices = new List<Vector3>();
            var triangles = new List<int>();
            foreach (float2 point in line)
                for (int i = 0; i < Sides; i++)
                {
                    double angle = 2 * Math.PI * i / Sides;
                    vertices.Add(new Vector3(point.x * (float)Math.Cos(angle), point.y, point.x * (float)Math.Sin(angle)));
                }
            for (int ring = 0; ring + 1 < line.Length; ring++)
                for (int i = 0; i < Sides; i++)
                {
                    int a = ring * Sides + i, b = ring * Sides + (i + 1) % Sides, c = a + Sides, d = b + Sides;
                    if (line[ring].x > 0f)      // on the axis two corners are one
                        triangles.AddRange(new[] { a, c, b });
                    if (line[ring + 1].x > 0f)
                        triangles.AddRange(new[] { b, c, d });
                }
            return new TriangleMesh(name, vertices.ToArray(), triangles.ToArray());
        }
    }
}
