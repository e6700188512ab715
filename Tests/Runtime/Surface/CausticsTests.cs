using System;
using System.Collections;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Sunlight on a floor under water of a known surface, seen by a camera in the water or above it, against photons in double
    /// precision.</summary>
    public class CausticsTests
    {
        const int Square = 2, Across = 48, Few = 8;     // pixels whose mean is taken, along a side; so many of them across the picture
        const float Floor = -0.5f, Half = 0.5f;     // m: height, and half of the width that is seen
        const double Index = 1.333;
        static readonly double3 Left = new double3(0.2, 0.5, 0.8);      // of white after 0.5 m

        MeshScene scene;
        GameObject floor;
        AmbientMode mode;
        Color sky;

        [SetUp]
        public void Begin()
        {
            (mode, sky) = (RenderSettings.ambientMode, RenderSettings.ambientSkyColor);
            (RenderSettings.ambientMode, RenderSettings.ambientSkyColor) = (AmbientMode.Flat, Color.black);
        }

        [TearDown]
        public void End()
        {
            scene?.Dispose();
            scene = null;
            Time.captureDeltaTime = 0f;
            (RenderSettings.ambientMode, RenderSettings.ambientSkyColor) = (mode, sky);
        }

        // Two trains of waves; the light comes to a focus above the floor, and below it for the longer one.
        static double Waves(double2 at) => 0.1 + 0.012 * math.sin(2.0 * Math.PI / 0.32 * math.dot(at, new double2(0.8, 0.6)))
            + 0.010 * math.sin(2.0 * Math.PI / 0.45 * math.dot(at, new double2(-0.5, 0.866)));

        static double Calm(double2 at) => 0.1;

        [UnityTest, Category("LongRun")]
        public IEnumerator Light_gathers_on_the_floor_as_photons_do([Values(0f, 40f)] float degrees)
        {
            Make(degrees, Waves, Across, 0.05f);
            yield return Frames();
            float3[] with = scene.Pixels(Square);
            scene.Surface.Caustics = false;
            yield return Frames();
            float3[] without = scene.Pixels(Square);
            double3[] traced = Photons(Waves, Toward(degrees));
            double3 mean = 0.0, expected = 0.0;
            var drawn = new double[with.Length];
            var right = new double[with.Length];
            var flat = new double[with.Length];
            for (int i = 0; i < with.Length; i++)
            {
                Assert.That(without[i].y, Is.GreaterThan(0.01f));
                double3 factor = (double3)with[i] / (double3)without[i];
                mean += factor / with.Length;
                expected += traced[i] / with.Length;
                drawn[i] = Math.Pow(Math.Min(0.5 * factor.y, 1.0), 1.0 / 2.2);
                right[i] = Math.Pow(Math.Min(0.5 * traced[i].y, 1.0), 1.0 / 2.2);
            }
            for (int i = 0; i < with.Length; i++)
                flat[i] = Math.Pow(0.5 * expected.y, 1.0 / 2.2);
            Save("caustics", degrees, drawn);
            Save("photons", degrees, right);
            double likeness = Ssim.Mean(drawn, right, Across, Across), without0 = Ssim.Mean(flat, right, Across, Across);
            TestContext.Out.WriteLine($"SSIM {likeness:0.000}, {without0:0.000} of an even floor; mean {mean} of {expected}");
            Assert.That(likeness, Is.GreaterThan(0.8));
            for (int channel = 0; channel < 3; channel++)
                Assert.That(mean[channel], Is.EqualTo(expected[channel]).Within(0.03 * expected[channel]));
        }

        [UnityTest]
        public IEnumerator Under_calm_water_the_floor_is_evenly_lit_by_what_comes_through([Values(0f, 40f)] float degrees)
        {
            Make(degrees, Calm, Few, 0.1f);
            return IsEvenlyLit(degrees);
        }

        [UnityTest]
        public IEnumerator The_floor_under_calm_water_is_evenly_lit_seen_from_above_too()
        {
            Make(40f, Calm, Few, 0.1f);
            LookFromAbove();
            return IsEvenlyLit(40f);
        }

        IEnumerator IsEvenlyLit(float degrees)
        {
            yield return Frames();
            float3[] with = scene.Pixels(Square);
            scene.Surface.Caustics = false;
            yield return Frames();
            float3[] without = scene.Pixels(Square);
            double beyond = Math.Cos(Math.Asin(Math.Sin(math.radians((double)degrees)) / Index));
            double3 expected = (1.0 - Fresnel(Math.Cos(math.radians((double)degrees)))) * math.pow(Left, (0.1 - Floor) / beyond / 0.5);
            double3 low = double.MaxValue, high = 0.0;
            for (int i = 0; i < with.Length; i++)
            {
                double3 factor = (double3)with[i] / (double3)without[i];
                low = math.min(low, factor);
                high = math.max(high, factor);
            }
            TestContext.Out.WriteLine($"{low} to {high} of {expected}");
            for (int channel = 0; channel < 3; channel++)
            {
                Assert.That(low[channel], Is.EqualTo(expected[channel]).Within(0.02 * expected[channel]));
                Assert.That(high[channel], Is.EqualTo(low[channel]).Within(0.01 * low[channel]), "no pattern");
            }
        }

        // The light is found for each ray, and lies between those on the picture.
        [UnityTest]
        public IEnumerator On_a_fine_picture_fewer_rays_show_nearly_the_same_light([Values(2, 4)] int across)
        {
            Make(0f, Waves, Across, 0.05f);
            LookFromAbove();
            yield return Frames();
            float3[] whole = scene.Pixels();
            MeshFrame frame = scene.Surface.Mesh.Value;
            frame.fineLines = Across * Square / across;
            scene.Surface.Mesh = frame;
            yield return Frames();
            float3[] coarse = scene.Pixels();
            float mean = 0f, pattern = 0f, different = 0f;
            foreach (float3 pixel in whole)
                mean += pixel.y / whole.Length;
            for (int i = 0; i < whole.Length; i++)
            {
                pattern += math.pow(whole[i].y - mean, 2f) / whole.Length;
                different += math.pow(coarse[i].y - whole[i].y, 2f) / whole.Length;
            }
            (pattern, different) = (math.sqrt(pattern), math.sqrt(different));
            TestContext.Out.WriteLine($"rms difference {different:F4}, of the pattern {pattern:F4}, mean {mean:F4}");
            Assert.That(pattern, Is.GreaterThan(0.2f * mean), "it is to be seen");
            Assert.That(different, Is.InRange(1e-4f, (across == 2 ? 0.12f : 0.2f) * pattern));
        }

        // Opaque water, as far as its shadow goes, in the shadow of a board on one side.
        [UnityTest]
        public IEnumerator The_waters_own_shadow_does_not_fall_on_what_it_gathers_light_on_but_that_of_others_does()
        {
            Make(0f, Calm, Few, 0.1f);
            floor.GetComponent<MeshRenderer>().sharedMaterial.SetColor("_Ambient", Color.black);
            scene.Add(PrimitiveType.Cube, 0.5f, new Vector3(0.5f, 0.8f, 0f), Quaternion.identity, new Vector3(1f, 0.05f, 3f));
            scene.Surface.Sun.shadows = LightShadows.Hard;
            scene.Surface.ShadowOpacity = 1f;
            yield return Frames();
            (float lit, float dark) noShadow = Sides();
            scene.Surface.CastShadows = ShadowCastingMode.On;
            yield return Frames();
            (float lit, float dark) withShadow = Sides();
            scene.Surface.Caustics = false;
            yield return Frames();
            (float lit, float dark) plain = Sides();
            TestContext.Out.WriteLine($"without a shadow {noShadow}, with one {withShadow}, without caustics {plain}");
            Assert.That(plain.lit, Is.LessThan(0.05f * noShadow.lit), "the shadow is there");
            Assert.That(noShadow.lit, Is.GreaterThan(0.02f));
            Assert.That(withShadow.lit, Is.EqualTo(noShadow.lit).Within(0.02f * noShadow.lit));
            Assert.That(noShadow.dark, Is.LessThan(0.02f * noShadow.lit));
            Assert.That(withShadow.dark, Is.LessThan(0.02f * noShadow.lit));
        }

        [UnityTest]
        public IEnumerator Off_or_without_a_sun_there_is_neither_a_map_nor_another_picture()
        {
            Make(0f, Calm, Few, 0.1f);
            Light sun = scene.Surface.Sun;
            yield return Frames();
            float3 with = Center();
            scene.Surface.Caustics = false;
            yield return Frames();
            float3 without = Center();
            Assert.That(with.y, Is.LessThan(0.6f * without.y));
            var switches = new (string name, Action off, Action on)[]
            {
                ("Caustics off", () => scene.Surface.Caustics = false, () => scene.Surface.Caustics = true),
                ("the sun off", () => sun.enabled = false, () => sun.enabled = true),
                ("a sun without light", () => sun.intensity = 0f, () => sun.intensity = 0.5f),
                ("a point light", () => sun.type = LightType.Point, () => sun.type = LightType.Directional),
                ("no sun", () => scene.Surface.Sun = null, () => scene.Surface.Sun = sun),
            };
            foreach ((string name, Action off, Action on) in switches)
            {
                scene.Surface.Caustics = true;
                yield return Frames();
                RenderTexture map = scene.Surface.CausticMap.Texture;
                Assert.That(map.IsCreated(), name);
                off();
                yield return Frames();
                Assert.That(scene.Surface.CausticMap, Is.Null, name);
                Assert.That(map == null, name);
                Assert.That(math.distance(Center(), without), Is.LessThan(1e-3f), name);
                on();
            }
            scene.Surface.Refraction = false;
            yield return Frames();
            Assert.That(scene.Surface.CausticMap, Is.Null, "without refraction");
        }

        float3 Center() => scene.Pixels(Square)[Few / 2 * Few + Few / 2];

        // Light of the floor left and right of the center.
        (float lit, float dark) Sides()
        {
            float3[] pixels = scene.Pixels(Square);
            return (pixels[Few / 2 * Few + 1].y, pixels[Few / 2 * Few + Few - 2].y);
        }

        // Photons from straight above the surface, evenly over what may reach the part of the floor that is seen.
        static double3[] Photons(Func<double2, double> height, double3 toLight)
        {
            const int rays = 900;
            const double span = 1.3;
            var sums = new double3[Across * Across];
            double3 calm = Bend(toLight, math.up());
            double2 center = calm.xz / calm.y * (0.1 - Floor);
            double3 absorption = -math.log(Left) / 0.5;
            for (int i = 0; i < rays * rays; i++)
            {
                // At a height of 0.1 m, then along the light to the surface.
                double2 start = (new double2(i % rays + 0.5, i / rays + 0.5) / rays - 0.5) * span + center;
                double3 p = new double3(start.x, 0.1, start.y);
                for (int k = 0; k < 12; k++)
                    p += toLight / toLight.y * (height(p.xz) - p.y);
                const double h = 1e-5;
                double2 x = new double2(h, 0.0), z = new double2(0.0, h);
                double3 normal = math.normalize(new double3(height(p.xz - x) - height(p.xz + x), 2.0 * h, height(p.xz - z) - height(p.xz + z)));
                double3 along = Bend(toLight, normal);
                double reach = (p.y - Floor) / -along.y;
                double3 landed = p + along * reach;
                int2 bin = (int2)math.floor((landed.xz + Half) / (2.0 * Half) * Across);
                if (math.any(bin < 0) || math.any(bin >= Across))
                    continue;
                sums[bin.y * Across + bin.x] += (1.0 - Fresnel(math.dot(normal, toLight))) * math.exp(-absorption * reach);
            }
            double each = span * span / ((double)rays * rays) / Math.Pow(2.0 * Half / Across, 2.0);
            for (int i = 0; i < sums.Length; i++)
                sums[i] *= each;
            return sums;
        }

        static double3 Bend(double3 toLight, double3 normal)
        {
            double cosine = math.dot(toLight, normal), ratio = 1.0 / Index;
            return -toLight * ratio + normal * (ratio * cosine - Math.Sqrt(1.0 - ratio * ratio * (1.0 - cosine * cosine)));
        }

        static double Fresnel(double cosine)
        {
            double beyond = Math.Sqrt(1.0 - (1.0 - cosine * cosine) / (Index * Index));
            double across = (cosine - Index * beyond) / (cosine + Index * beyond), along = (Index * cosine - beyond) / (Index * cosine + beyond);
            return 0.5 * (across * across + along * along);
        }

        static double3 Toward(float degrees)
        {
            double angle = math.radians((double)degrees);
            return new double3(Math.Sin(angle) * 0.6, Math.Cos(angle), Math.Sin(angle) * 0.8);
        }

        void Make(float degrees, Func<double2, double> height, int across, float spacing)
        {
            scene = new MeshScene(across * Square, new Vector3(2f, 1f, 2f), spacing, 0f);
            scene.Camera.orthographic = true;
            scene.Camera.orthographicSize = Half;
            scene.Camera.nearClipPlane = 0.02f;
            scene.Camera.transform.SetPositionAndRotation(new Vector3(0f, -0.2f, 0f), Quaternion.LookRotation(Vector3.down, Vector3.forward));
            floor = scene.Add(PrimitiveType.Cube, 0.5f, new Vector3(0f, Floor - 0.05f, 0f), Quaternion.identity, new Vector3(4f, 0.1f, 4f));
            SurfaceLook look = WaterScene.Absorbing((float3)Left, 0.5f);
            look.refractionIndex = (float)Index;
            scene.Surface.Look = look;
            Light sun = scene.Surface.Sun;
            sun.intensity = 0.5f;
            sun.transform.rotation = Quaternion.LookRotation(-(Vector3)(float3)Toward(degrees), Vector3.right);
            scene.Put(p => (float)height(new double2(p.x, p.z)) - p.y);
        }

        void LookFromAbove()
        {
            scene.Surface.ReflectionStrength = 0f;
            scene.Camera.transform.SetPositionAndRotation(new Vector3(0f, 1f, 0f), Quaternion.LookRotation(Vector3.down, Vector3.forward));
        }

        static IEnumerator Frames()
        {
            Time.captureDeltaTime = 1f / 60f;
            yield return null;
            yield return null;
        }

        static void Save(string name, float degrees, double[] shown)
            => MeshScene.Save($"{name}_{degrees:0}", Array.ConvertAll(shown, value => (float3)(float)Math.Pow(value, 2.2)));
    }
}
