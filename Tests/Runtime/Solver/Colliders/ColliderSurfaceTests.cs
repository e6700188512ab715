using System.Collections.Generic;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>Surfaces and distances of colliders on the CPU.</summary>
    public class ColliderSurfaceTests
    {
        static readonly RigidPose Pose = new RigidPose(new float3(3f, -1f, 2f), quaternion.Euler(0.4f, 1.1f, -0.3f));

        readonly List<Object> made = new List<Object>();

        [TearDown]
        public void LeaveNothing()
        {
            foreach (Object thing in made)
                Object.DestroyImmediate(thing);
            made.Clear();
        }

        [Test]
        public void Samples_of_a_surface_add_up_to_its_area_and_its_volume([Values(ColliderShape.Sphere, ColliderShape.Box, ColliderShape.Capsule,
            ColliderShape.Mesh)] ColliderShape shape)
        {
            ColliderMotion motion = Motion(shape, out SignedDistanceField field);
            var samples = new List<SurfaceSample>();
            SurfaceSamples.Append(samples, motion, field, 0.05f);
            float area = 0f, volume = 0f;
            float3 sum = 0f;
            foreach (SurfaceSample sample in samples)
            {
                area += math.length(sample.area);
                sum += sample.area;
                volume += math.dot(sample.position - Pose.position, sample.area) / 3f;      // divergence theorem
            }
            float error = shape == ColliderShape.Mesh ? 0.06f : 0.01f;
            Assert.That(area, Is.EqualTo(Area(shape)).Within(error * Area(shape)));
            Assert.That(volume, Is.EqualTo(Volume(shape)).Within(error * Volume(shape)));
            Assert.That(math.length(sum), Is.LessThan(0.5f * error * area));
        }

        [Test]
        public void Distances_are_those_of_the_shape([Values] ColliderShape shape, [Values(false, true)] bool insideOut)
        {
            ColliderMotion motion = Motion(shape, out _);
            motion.insideOut = insideOut;
            Assert.That(ColliderDistance.TryMake(motion, out ColliderDistance distance), Is.True);
            float sign = insideOut ? -1f : 1f, error = shape == ColliderShape.Mesh ? 0.01f : 1e-4f;
            foreach ((float3 local, float expected) in Points(shape))
                Assert.That(distance.At(Pose.position + math.mul(Pose.rotation, local)), Is.EqualTo(sign * expected).Within(error), $"{local}");
        }

        [Test]
        public void A_mesh_that_deforms_and_a_texture_that_cannot_be_read_have_no_distances()
        {
            ColliderMotion motion = Motion(ColliderShape.Mesh, out _);
            motion.field = new Texture3D(2, 2, 2, TextureFormat.RFloat, false);
            motion.field.Apply(false, true);
            made.Add(motion.field);
            Assert.That(ColliderDistance.TryMake(motion, out _), Is.False);
            motion.field = null;
            Assert.That(ColliderDistance.TryMake(motion, out _), Is.False);
        }

        // Distances from the surface at places in the shape's own frame.
        static IEnumerable<(float3, float)> Points(ColliderShape shape)
        {
            switch (shape)
            {
                case ColliderShape.Sphere:
                    return new[] { (new float3(0.6f, 0f, 0f), 0.3f), (new float3(0f, 0.1f, 0f), -0.2f) };
                case ColliderShape.Capsule:
                    return new[] { (new float3(0.5f, 0.2f, 0f), 0.2f), (new float3(0f, 0.9f, 0f), 0.2f), (new float3(0f, 0.3f, 0.1f), -0.2f) };
                case ColliderShape.Plane:
                    return new[] { (new float3(5f, 0.7f, -3f), 0.7f), (new float3(1f, -0.2f, 1f), -0.2f) };
                case ColliderShape.HeightField:     // y = 0.5 x over its center: a slope of 0.5, half sides of 1 and 2
                    float upright = 1f / math.sqrt(1.25f);
                    return new[] { (new float3(0.2f, 0.5f, 0.7f), 0.4f * upright), (new float3(-0.9f, -1f, -1.5f), -0.55f * upright),
                        (new float3(2f, 0.5f, 0f), 1f) };
                default:        // half sides of 0.2, 0.3 and 0.4
                    return new[] { (new float3(0.25f, 0f, 0f), 0.05f), (new float3(0f, 0.25f, 0f), -0.05f), (new float3(0f, 0f, -0.44f), 0.04f) };
            }
        }

        static float Area(ColliderShape shape)
            => shape == ColliderShape.Sphere ? 4f * math.PI * 0.09f
            : shape == ColliderShape.Capsule ? 4f * math.PI * 0.09f + 2f * math.PI * 0.3f * 0.8f : 8f * (0.06f + 0.12f + 0.08f);

        static float Volume(ColliderShape shape)
            => shape == ColliderShape.Sphere ? 4f / 3f * math.PI * 0.027f
            : shape == ColliderShape.Capsule ? 4f / 3f * math.PI * 0.027f + math.PI * 0.09f * 0.8f : 8f * 0.024f;

        ColliderMotion Motion(ColliderShape shape, out SignedDistanceField field)
        {
            field = null;
            var motion = new ColliderMotion { shape = shape, start = Pose, end = Pose, size = new float3(0.2f, 0.3f, 0.4f), fieldUnit = 1f };
            switch (shape)
            {
                case ColliderShape.Sphere:
                    motion.size = 0.3f;
                    break;
                case ColliderShape.Capsule:
                    motion.size = new float3(0.3f, 0.4f, 0f);
                    break;
                case ColliderShape.HeightField:
                    var heights = new HeightField(new[,] { { -0.5f, 0f, 0.5f }, { -0.5f, 0f, 0.5f } }, 2f, 4f);
                    made.Add(heights.Texture);
                    motion.size = heights.Extents;
                    motion.field = heights.Texture;
                    break;
                case ColliderShape.Mesh:
                    MeshSdfSettings settings = MeshSdfSettings.Default;
                    settings.resolution = 32;
                    field = SignedDistanceField.Create(MeshSdfBaker.Bake(TestMeshes.Box(new Vector3(0.4f, 0.6f, 0.8f), Vector3.zero), settings));
                    made.Add(field.Texture);
                    made.Add(field);
                    var position = ColliderTransform.Origin;
                    RigidPose pose = Pose;
                    Assert.That(position.DescribeField(field, ref motion, ref pose), Is.Null);
                    break;
            }
            return motion;
        }
    }
}
