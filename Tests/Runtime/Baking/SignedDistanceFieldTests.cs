using System;
using System.Reflection;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Rill.Tests
{
    public class SignedDistanceFieldTests
    {
        SignedDistanceField field;

        static SdfBake Box(float size, int resolution, SdfFormat format)
        {
            MeshSdfSettings settings = MeshSdfSettings.Default;
            settings.resolution = resolution;
            settings.format = format;
            return MeshSdfBaker.Bake(TestMeshes.Box(size * Vector3.one, new Vector3(3f, 4f, 5f)), settings);
        }

        [SetUp]
        public void Bake() => field = SignedDistanceField.Create(Box(1f, 16, SdfFormat.Float), "0123456789abcdef0123456789abcdef");

        [TearDown]
        public void Destroy()
        {
            UnityEngine.Object.DestroyImmediate(field.Texture);
            UnityEngine.Object.DestroyImmediate(field);
        }

        float Sample(float3 at)
        {
            Assert.That(field.TrySample(at, out float distance), $"at {at}");
            return distance;
        }

        [TestCase(SdfFormat.Float)]
        [TestCase(SdfFormat.Half)]
        public void Samples_at_the_center_of_a_voxel_are_its_distance(SdfFormat format)
        {
            SdfBake bake = Box(1f, 16, format);
            DestroyReplaced(field.Apply(bake));
            Assert.That(field.Texture.format, Is.EqualTo(format == SdfFormat.Half ? TextureFormat.RHalf : TextureFormat.RFloat));
            Assert.That(field.StorageError, Is.EqualTo(bake.StorageError));
            for (int i = 0; i < bake.Distances.Length; i += 7)
                Assert.That(Sample((float3)BakeError.CenterOf(bake, i)), Is.EqualTo(bake.Distances[i]).Within(bake.StorageError + 1e-6f),
                    $"voxel {i}");
        }

        [Test]
        public void Samples_between_voxels_are_trilinear()
        {
            Vector3Int n = field.Resolution;
            SdfBake bake = Box(1f, 16, SdfFormat.Float);
            float At(int x, int y, int z) => bake.Distances[(z * n.y + y) * n.x + x];
            float3 weight = new float3(0.25f, 0.5f, 0.875f);
            float expected = 0f;
            for (int k = 0; k < 8; k++)
            {
                int3 up = new int3(k & 1, k >> 1 & 1, k >> 2);
                expected += Product(math.select(1f - weight, weight, up == 1)) * At(2 + up.x, 3 + up.y, 4 + up.z);
            }
            Assert.That(Sample((float3)field.Bounds.min + field.VoxelSize * (new float3(2, 3, 4) + 0.5f + weight)),
                Is.EqualTo(expected).Within(1e-5f));
        }

        static float Product(float3 v) => v.x * v.y * v.z;

        [Test]
        public void Samples_outside_of_the_bounds_add_the_distance_to_them()
        {
            Bounds bounds = field.Bounds;
            float3 face = new float3(bounds.max.x, bounds.center.y, bounds.center.z);
            Assert.That(Sample(face + new float3(2f, 0f, 0f)), Is.EqualTo(Sample(face) + 2f).Within(1e-5f));
            Assert.That(Sample((float3)bounds.min - new float3(3f, 4f, 0f)), Is.EqualTo(Sample(bounds.min) + 5f).Within(1e-5f));
        }

        [Test]
        public void Places_that_are_no_numbers_have_no_distance()
        {
            Assert.That(field.TrySample(new float3(0f, float.NaN, 0f), out float distance), Is.False);
            Assert.That(distance, Is.EqualTo(float.PositiveInfinity));
            Assert.That(field.TrySample(new float3(0f, 0f, float.NegativeInfinity), out _), Is.False);
        }

        [Test]
        public void It_tells_what_it_was_baked_from()
        {
            Assert.That(field.SourceMesh, Is.EqualTo("0123456789abcdef0123456789abcdef"));
            Assert.That(field.Settings.resolution, Is.EqualTo(16));
            Assert.That(field.Sign, Is.EqualTo(MeshSdfSign.WindingNumber));
            Assert.That(field.Version, Is.EqualTo(SignedDistanceField.CurrentVersion));
            Assert.That(field.Resolution, Is.EqualTo(16 * Vector3Int.one));
            Assert.That(Vector3.Distance(field.Bounds.center, new Vector3(3f, 4f, 5f)), Is.LessThan(1e-5f));
            Assert.That(field.Validate(out string problem), problem);
        }

        [Test]
        public void A_bake_of_the_same_size_replaces_the_content_of_asset_and_texture()
        {
            Texture3D texture = field.Texture;
            float before = Sample(new float3(3f, 4f, 5f));
            Assert.That(field.Apply(Box(2f, 16, SdfFormat.Float), "other"), Is.Null);
            Assert.That(field.Texture, Is.SameAs(texture));
            Assert.That(Sample(new float3(3f, 4f, 5f)), Is.EqualTo(2 * before).Within(1e-5f));
            Assert.That(field.SourceMesh, Is.EqualTo("other"));
        }

        [Test]
        public void A_bake_of_another_size_hands_the_old_texture_out()
        {
            Texture3D texture = field.Texture, replaced = field.Apply(Box(1f, 20, SdfFormat.Float));
            Assert.That(replaced, Is.SameAs(texture));
            Assert.That(field.Resolution, Is.EqualTo(20 * Vector3Int.one));
            Assert.That(field.Validate(out string problem), problem);
            DestroyReplaced(replaced);
        }

        [Test]
        public void A_field_without_a_bake_says_so()
        {
            var empty = ScriptableObject.CreateInstance<SignedDistanceField>();
            empty.name = "Empty";
            Assert.That(empty.Validate(out string problem), Is.False);
            Assert.That(problem, Does.Contain("'Empty' has no distances").And.Contain("bake"));
            Assert.That(empty.TrySample(float3.zero, out _), Is.False);
            Assert.That(empty.Resolution, Is.EqualTo(Vector3Int.zero));
            Assert.Throws<ArgumentNullException>(() => empty.Apply(null));
            UnityEngine.Object.DestroyImmediate(empty);
        }

        [Test]
        public void A_field_of_a_newer_version_is_refused_and_one_of_an_older_is_brought_up()
        {
            JsonUtility.FromJsonOverwrite("{\"version\": 2}", field);
            Assert.That(field.Validate(out string problem), Is.False);
            Assert.That(problem, Does.Contain("version 2").And.Contain("up to 1").And.Contain("update the package"));
            JsonUtility.FromJsonOverwrite("{\"version\": 0}", field);
            Assert.That(field.Version, Is.EqualTo(1));
            Assert.That(field.StorageError, Is.NaN, "not known");
            Assert.That(field.Validate(out problem), problem);
        }

        [Test]
        public void Bounds_that_the_voxels_do_not_fill_are_found()
        {
            JsonUtility.FromJsonOverwrite("{\"voxelSize\": 0.5}", field);
            Assert.That(field.Validate(out string problem), Is.False);
            Assert.That(problem, Does.Contain("do not fill").And.Contain("bake it again"));
        }

        [TestCase("voxelSize", 0f)]
        [TestCase("voxelSize", -0.1f)]
        [TestCase("voxelSize", float.NaN)]
        [TestCase("voxelSize", float.PositiveInfinity)]
        [TestCase("center.x", float.NaN)]
        [TestCase("center.y", float.PositiveInfinity)]
        [TestCase("center.z", float.NegativeInfinity)]
        [TestCase("size.x", float.NaN)]
        [TestCase("size.x", 1.001f)]
        [TestCase("size.y", 1.001f)]
        [TestCase("size.z", 0.999f)]
        public void A_field_of_a_file_with_a_number_that_cannot_be_is_found(string what, float value)
        {
            Bounds bounds = field.Bounds;
            if (what == "voxelSize")
                Set("voxelSize", value);
            else
            {
                int axis = what[what.Length - 1] - 'x';
                Vector3 center = bounds.center, size = bounds.size;
                if (what[0] == 'c')
                    center[axis] = value;
                else
                    size[axis] *= value;
                Set("bounds", new Bounds(center, size));
            }
            Assert.That(field.Validate(out string problem), Is.False);
            Assert.That(problem, Does.Contain("do not fill").And.Contain("bake it again"));
        }

        void Set(string name, object value) => typeof(SignedDistanceField).GetField(name, BindingFlags.Instance | BindingFlags.NonPublic)
            .SetValue(field, value);

        static void DestroyReplaced(Texture3D texture)
        {
            if (texture != null)
                UnityEngine.Object.DestroyImmediate(texture);
        }
    }
}
