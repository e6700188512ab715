using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill.Tests
{
    /// <summary>Wetted areas of curved shapes from points at random in the two spacings before their surface, against the geometry. Lengths
    /// in d.</summary>
    public class WettedShapesTests
    {
        const float Spacing = 0.05f, Reach = 2f;
        const int Density = 16;      // points in a d³, each of which counts for a particle

        static readonly float3 Box = 28f, Center = new float3(13.5f, 14.2f, 14f);

        readonly List<Object> made = new List<Object>();

        [TearDown]
        public void DestroyFields()
        {
            made.ForEach(Object.DestroyImmediate);
            made.Clear();
        }

        [Test]
        public void A_shape_under_water_is_wet_on_all_of_its_surface([Values(ColliderShape.Sphere, ColliderShape.Capsule, ColliderShape.Mesh)]
            ColliderShape kind, [Values] bool insideOut)
        {
            const float radius = 5f, half = 5f;
            float area = 4f * math.PI * radius * radius + (kind == ColliderShape.Capsule ? 4f * math.PI * radius * half : 0f);
            ColliderMotion shape = Shape(kind, radius, half), ideal = shape;
            shape.insideOut = ideal.insideOut = insideOut;
            if (kind == ColliderShape.Mesh)
                (ideal.shape, ideal.size) = (ColliderShape.Sphere, radius);
            (double found, double3 normal, double3 point) = Wetted(shape, p => Reference.Shapes.Distance(ideal, p));
            TestContext.Out.WriteLine($"{found:0.0} of {area:0.0} d², mean normal {math.length(normal):0.000}, center off by " +
                $"{math.length(point):0.00} d");
            Assert.That(found, Is.EqualTo(area).Within((kind == ColliderShape.Mesh ? 0.06f : 0.03f) * area));
            Assert.That(math.length(normal), Is.LessThan(0.04), "it faces all sides");
            Assert.That(math.length(point), Is.LessThan(0.25), "d, around its center");
        }

        ColliderMotion Shape(ColliderShape kind, float radius, float half)
        {
            ColliderMotion shape = ColliderTests.Still(kind, new float3(radius, half, 0f), Center, quaternion.Euler(0.4f, 0.3f, 0.9f));
            shape.reacts = shape.tellsWettedArea = true;
            if (kind != ColliderShape.Mesh)
                return shape;
            MeshSdfSettings settings = MeshSdfSettings.Default;
            settings.resolution = 32;
            settings.padding = 8;
            SignedDistanceField field = SignedDistanceField.Create(MeshSdfBaker.Bake(TestMeshes.Sphere(radius, 24, Vector3.zero), settings));
            made.Add(field.Texture);
            made.Add(field);
            shape.fieldUnit = 1f;
            var placement = ColliderTransform.Origin;
            RigidPose pose = shape.end;
            Assert.That(placement.DescribeField(field, ref shape, ref pose), Is.Null);
            return shape;
        }

        // Wet area of the only collider, mean of its normals, and the center from the collider's.
        static (double area, double3 normal, double3 point) Wetted(ColliderMotion shape, System.Func<float3, double> distance)
        {
            var random = new Unity.Mathematics.Random(77u);
            float4[] points = Enumerable.Range(0, (int)(Density * Box.x * Box.y * Box.z)).Select(_ => random.NextFloat3(0f, Box))
                .Where(p => distance(p) > 0.0 && distance(p) < Reach).Select(p => new float4(p, 0f)).ToArray();
            using (var fluid = new TestFluid(Box * Spacing, Spacing, points.Length))
            {
                var counts = new int3(28, (points.Length + 783) / 784, 28);
                fluid.Add(ParticleState.Lattice(0f, 0.5f, counts, 0.02f).positions.Take(points.Length).Select(p => p.xyz * Spacing).ToArray());
                ColliderTests.Use(fluid, shape);
                fluid.Step();
                Assert.That(fluid.Alive, Is.EqualTo(points.Length));
                fluid.Solver.Positions.SetData(points);
                ColliderReactions reactions = fluid.Solver.Reactions;
                GpuTest.Run(cmd =>
                {
                    fluid.Solver.RecordWettedAreas(cmd);
                    reactions.RecordTake(cmd);
                });
                reactions.Request();
                AsyncGPUReadback.WaitAllRequests();
                double area = reactions.WettedArea(0, out double3 normal, out double3 position);
                return (area / Density, normal / area, position * shape.MomentArm / area);
            }
        }
    }
}
