using System.Collections;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>The rays that a camera sees through a ball of water before a board, against the same water seen otherwise.</summary>
    public class WaterRaysTests
    {
        const float Spacing = 0.05f, Radius = 0.5f;
        const int Across = 96;

        MeshScene scene;

        [SetUp]
        public void Begin()
        {
            scene = new MeshScene(Across, Vector3.one * 1.6f, Spacing, 0.5f);
            scene.Camera.transform.position = new Vector3(0f, 0f, -4f);
            scene.Camera.fieldOfView = 22f;
        }

        void AddBoard() => scene.AddBoard(new Vector3(0f, 0f, 3f), Vector3.right, Vector3.up, 0.5f, 24, 0.8f, 0.1f);

        [TearDown]
        public void End()
        {
            scene?.Dispose();
            scene = null;
            Time.captureDeltaTime = 0f;
        }

        // Drawing runs ahead of the field: rays go through that where it is.
        [UnityTest]
        public IEnumerator Water_that_has_gone_on_since_its_step_bends_light_as_water_that_is_there()
        {
            AddBoard();
            float3 gone = new float3(0.08f, -0.05f, 0.02f);
            scene.Put(p => Radius - math.length(p - gone));
            yield return Frames();
            float3[] there = scene.Pixels();
            scene.Put(p => Radius - math.length(p), displacement: gone / (2f * Spacing), lag: 2f);
            yield return Frames();
            float3[] goneOn = scene.Pixels();
            scene.Put(p => Radius - math.length(p));
            yield return Frames();
            float different = Difference(goneOn, there), moved = Difference(scene.Pixels(), there);
            TestContext.Out.WriteLine($"rms difference {different:F4}, of what has not moved {moved:F4}");
            Assert.That(moved, Is.GreaterThan(0.1f), "it is to be seen");
            Assert.That(different, Is.LessThan(0.25f * moved));
        }

        [UnityTest]
        public IEnumerator Textures_of_half_the_width_show_nearly_the_same()
        {
            AddBoard();
            scene.Put(p => Radius - math.length(p));
            yield return Frames();
            float3[] whole = scene.Pixels();
            MeshFrame frame = scene.Surface.Mesh.Value;
            frame.rayScale = 0.5f;
            scene.Surface.Mesh = frame;
            yield return Frames();
            float different = Difference(scene.Pixels(), whole);
            TestContext.Out.WriteLine($"rms difference {different:F4}");
            Assert.That(different, Is.InRange(1e-4f, 0.15f));
        }

        // The outline of the water stays as fine as the picture.
        [UnityTest]
        public IEnumerator On_a_fine_picture_fewer_rays_show_nearly_the_same([Values(2, 4)] int across)
        {
            AddBoard();
            scene.Put(p => Radius - math.length(p));
            yield return Frames();
            float3[] whole = scene.Pixels();
            MeshFrame frame = scene.Surface.Mesh.Value;
            frame.fineLines = Across / across;
            scene.Surface.Mesh = frame;
            yield return Frames();
            float different = Difference(scene.Pixels(), whole);
            frame.rayScale = 1f / across;
            scene.Surface.Mesh = frame;
            yield return Frames();
            float coarse = Difference(scene.Pixels(), whole);
            TestContext.Out.WriteLine($"rms difference {different:F4}; with faces as coarse {coarse:F4}");
            Assert.That(different, Is.InRange(1e-4f, 0.75f * coarse));
        }

        // In a furnace: all that faces mirror, let through and turn back adds up to the light around.
        [UnityTest]
        public IEnumerator Clear_water_in_a_world_that_is_equally_bright_everywhere_is_not_to_be_seen()
        {
            scene.Put(p => math.max(Radius - math.length(p - new float3(0.1f, 0f, 0f)), 0.12f - math.length(p.xz - new float2(-0.6f, 0.3f))));
            yield return Frames();
            float low = 1f, high = 0f;
            foreach (float3 pixel in scene.Pixels())
                (low, high) = (math.min(low, pixel.y), math.max(high, pixel.y));
            TestContext.Out.WriteLine($"{low:F4} to {high:F4}, due 0.5");
            Assert.That(low, Is.GreaterThan(0.49f));
            Assert.That(high, Is.LessThan(0.51f));
        }

        [UnityTest]
        public IEnumerator Without_refraction_water_hides_what_stands_in_it_by_what_is_in_front_of_it()
        {
            const float leftPerMeter = 0.3f, deep = 0.3f, all = 1.2f;     // m
            scene.Surface.Look = WaterScene.Absorbing(leftPerMeter, 1f);
            scene.Surface.Refraction = false;
            scene.Camera.orthographic = true;
            scene.Camera.orthographicSize = 0.3f;
            scene.Put(p => 0.6f - math.abs(p.z));
            scene.Add(PrimitiveType.Cube, 0.8f, new Vector3(0.5f, 0f, deep - 0.55f), Quaternion.identity, new Vector3(1f, 2f, 0.1f));
            scene.Add(PrimitiveType.Cube, 0.8f, new Vector3(0f, 0f, 2f), Quaternion.identity, new Vector3(4f, 4f, 0.1f));
            yield return Frames();
            float3[] pixels = scene.Pixels();
            int center = Across / 2 * Across;
            float near = pixels[center + Across - 8].y, far = pixels[center + 8].y;
            TestContext.Out.WriteLine($"behind {deep} m {near:F4}, behind {all} m {far:F4}");
            float mirrored = 0.0204f * 0.5f, through = (1f - 0.0204f) * 0.8f;
            Assert.That(near, Is.EqualTo(mirrored + through * math.pow(leftPerMeter, deep)).Within(0.01f));
            Assert.That(far, Is.EqualTo(mirrored + through * math.pow(leftPerMeter, all)).Within(0.01f));
        }

        // Waves of two pixels, whose highlights are thinner than one: seen from far away they glitter as much as from near by.
        [UnityTest]
        public IEnumerator Highlights_of_waves_that_pixels_are_too_wide_for_are_as_bright_in_the_mean()
        {
            var means = new float[2];
            for (int i = 0; i < 2; i++)
            {
                scene?.Dispose();
                scene = new MeshScene(i == 0 ? 16 : 512, new Vector3(1.6f, 0.6f, 1.6f), Spacing, 0f);
                scene.Camera.orthographic = true;
                scene.Camera.orthographicSize = 0.7f;
                scene.Camera.transform.SetPositionAndRotation(new Vector3(0.013f, 1f, 0.007f),
                    Quaternion.LookRotation(Vector3.down, Vector3.forward));
                scene.Surface.Sun.intensity = 1f;
                scene.Surface.Sun.transform.rotation = Quaternion.Euler(80f, 30f, 0f);
                scene.Put(p => 0.01f * math.sin(2f * math.PI / 0.19f * p.x) + 0.01f * math.sin(2f * math.PI / 0.23f * p.z) - p.y);
                yield return Frames();
                foreach (float3 pixel in scene.Pixels())
                    means[i] += pixel.y / scene.Target.width / scene.Target.width;
            }
            TestContext.Out.WriteLine($"mean {means[0]:F4} at 16 pixels, {means[1]:F4} at 512");
            Assert.That(means[0] / means[1], Is.InRange(0.6f, 1.7f));
        }

        static float Difference(float3[] a, float3[] b)
        {
            float sum = 0f;
            for (int i = 0; i < a.Length; i++)
                sum += math.dot(a[i] - b[i], a[i] - b[i]) / 3f;
            return math.sqrt(sum / a.Length);
        }

        static IEnumerator Frames()
        {
            Time.captureDeltaTime = 1f / 60f;
            yield return null;
            yield return null;
        }
    }
}
