using System;
using System.Collections;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>The water's shader draws meshes of known shapes as optics has it: Beer and Lambert, Snell, Fresnel, and what water mirrors.</summary>
    public class WaterMeshTests
    {
        const float Index = 1.333f;
        static readonly float3 Left = new float3(0.2f, 0.5f, 0.8f);     // of white after 0.5 m

        MeshScene scene;

        [TearDown]
        public void End()
        {
            scene?.Dispose();
            scene = null;
            Time.captureDeltaTime = 0f;
        }

        static IEnumerator Frames()
        {
            Time.captureDeltaTime = 1f / 60f;
            yield return null;
            yield return null;
            yield return null;
        }

        // Transmittance of light that falls straight on the surface.
        static float Straight => 1f - math.pow((Index - 1f) / (Index + 1f), 2f);

        void LookDown(float size)
        {
            scene.Camera.orthographic = true;
            scene.Camera.orthographicSize = size;
            scene.Camera.transform.SetPositionAndRotation(new Vector3(0f, 2f, 0f), Quaternion.LookRotation(Vector3.down, Vector3.forward));
        }

        float3 Center()
        {
            float3[] pixels = scene.Pixels();
            int width = scene.Target.width;
            return pixels[width / 2 * width + width / 2];
        }

        [UnityTest]
        public IEnumerator A_drop_before_a_pool_takes_as_much_light_as_its_own_water_and_the_pools()
        {
            scene = new MeshScene(64, new Vector3(1f, 1.6f, 1f), 0.05f, 0f);
            LookDown(0.1f);
            scene.Add(PrimitiveType.Cube, 0.8f, new Vector3(0f, -0.85f, 0f), Quaternion.identity, new Vector3(4f, 0.1f, 4f));
            scene.Surface.Look = Absorbing();
            const float radius = 0.2f, depth = 0.5f;
            scene.Put(p => math.max(radius - math.distance(p, new float3(0f, 0.3f, 0f)), -0.8f + depth - p.y));
            yield return Frames();
            float3 behindDrop = Center();
            scene.Put(p => -0.8f + depth - p.y);
            yield return Frames();
            float3 pool = Center();
            float3 expectedPool = 0.8f * Straight * math.pow(Left, depth / 0.5f),
                expectedDrop = expectedPool * Straight * Straight * math.pow(Left, 2f * radius / 0.5f);
            TestContext.Out.WriteLine($"pool {pool} of {expectedPool}, behind a drop {behindDrop} of {expectedDrop}");
            for (int i = 0; i < 3; i++)
            {
                Assert.That(pool[i], Is.EqualTo(expectedPool[i]).Within(0.03f * expectedPool[i]));
                Assert.That(behindDrop[i], Is.EqualTo(expectedDrop[i]).Within(0.03f * expectedDrop[i]));
            }
        }

        [UnityTest]
        public IEnumerator A_clear_jet_does_not_darken_the_pool_behind_it()
        {
            scene = new MeshScene(64, new Vector3(1f, 1.6f, 1f), 0.05f, 0f);
            LookDown(0.4f);
            scene.Add(PrimitiveType.Cube, 0.8f, new Vector3(0f, -0.85f, 0f), Quaternion.identity, new Vector3(4f, 0.1f, 4f));
            scene.Surface.Look = Absorbing();
            scene.Put(p => -0.3f - p.y);
            yield return Frames();
            float3 pool = Center();
            scene.Put(p => math.max(0.08f - math.length(p.xy - new float2(0f, 0.3f)), -0.3f - p.y));
            yield return Frames();
            float3 jet = Center(), expected = 0.8f * Left * math.pow(Straight, 3f) * math.pow(Left, 0.16f / 0.5f);
            TestContext.Out.WriteLine($"pool {pool}, through the jet {jet} of {expected}");
            for (int i = 0; i < 3; i++)
                Assert.That(jet[i], Is.EqualTo(expected[i]).Within(0.03f * expected[i]));
        }

        [UnityTest]
        public IEnumerator An_eye_in_the_water_sees_all_above_it_in_a_window_of_97_degrees()
        {
            const int pixels = 256;
            scene = new MeshScene(pixels, new Vector3(4f, 1f, 4f), 0.05f, 1f);
            scene.Camera.fieldOfView = 120f;
            scene.Camera.nearClipPlane = 0.02f;
            scene.Camera.transform.SetPositionAndRotation(new Vector3(0f, -0.4f, 0f), Quaternion.LookRotation(Vector3.up, Vector3.forward));
            SurfaceLook dark = MeshScene.Clear;
            dark.scattering = Color.black;
            scene.Surface.Look = dark;
            scene.Put(p => 0.2f - p.y);
            yield return Frames();
            float3[] seen = scene.Pixels();
            int rim = 0, row = pixels / 2 * pixels;
            while (rim < pixels / 2 && seen[row + pixels / 2 + rim].x > 0.25f)
                rim++;
            float angle = math.degrees(math.atan(math.tan(math.radians(60f)) * rim / (pixels / 2f)));
            float center = seen[row + pixels / 2].x, beyond = seen[row + pixels - 8].x;
            TestContext.Out.WriteLine($"rim at {angle:0.00} degrees; center {center:0.000}, beyond {beyond:0.000}");
            Assert.That(angle, Is.EqualTo(48.6f).Within(0.5f));
            Assert.That(center, Is.EqualTo(Straight).Within(0.03f));
            Assert.That(beyond, Is.LessThan(0.02f), "mirrored water, which is dark");
        }

        [UnityTest]
        public IEnumerator An_eye_above_the_water_does_not_see_from_within()
        {
            scene = new MeshScene(32, new Vector3(4f, 1f, 4f), 0.05f, 1f);
            scene.Camera.transform.SetPositionAndRotation(new Vector3(0f, 0.4f, 0f), Quaternion.LookRotation(Vector3.up, Vector3.forward));
            scene.Put(p => 0.2f - p.y);
            yield return Frames();
            Assert.That(Center().x, Is.EqualTo(1f).Within(1e-3f));
        }

        [UnityTest]
        public IEnumerator Water_that_does_not_refract_blends_once_whatever_the_order_of_its_triangles()
        {
            scene = new MeshScene(64, new Vector3(1f, 1.6f, 1f), 0.05f, 0f);
            LookDown(0.1f);
            scene.Add(PrimitiveType.Cube, 0.8f, new Vector3(0f, -0.85f, 0f), Quaternion.identity, new Vector3(4f, 0.1f, 4f));
            scene.Surface.Look = Absorbing();
            scene.Surface.Refraction = false;
            // The lower one first, or last: by where they lie among the cells.
            scene.Put(p => math.max(0.1f - math.distance(p, new float3(0f, 0.3f, 0f)), 0.1f - math.distance(p, new float3(0f, -0.3f, 0f))));
            yield return Frames();
            float3 through = Center();
            float expected = 0.8f * Straight * math.csum(math.pow(Left, 0.2f / 0.5f)) / 3f;
            Assert.That(through.x, Is.EqualTo(expected).Within(0.03f * expected), "the nearest alone");
        }

        [UnityTest]
        public IEnumerator The_mesh_goes_on_along_its_displacement()
        {
            scene = new MeshScene(64, new Vector3(1f, 1f, 1f), 0.05f, 0f);
            LookDown(0.5f);
            scene.Add(PrimitiveType.Cube, 0.8f, new Vector3(0f, -0.55f, 0f), Quaternion.identity, new Vector3(4f, 0.1f, 4f));
            scene.Surface.Look = Absorbing();
            var centers = new float2[2];
            for (int i = 0; i < 2; i++)
            {
                scene.Put(p => 0.15f - math.length(p), displacement: new Vector3(3f, 0f, 0f), lag: i);
                yield return Frames();
                float3[] pixels = scene.Pixels();
                float weight = 0f;
                for (int at = 0; at < pixels.Length; at++)
                {
                    float dark = math.saturate(0.8f - pixels[at].x);
                    centers[i] += dark * new float2(at % 64, at / 64);
                    weight += dark;
                }
                centers[i] /= weight;
            }
            // 0.15 m, of 1 m on 64 pixels.
            Assert.That(centers[1].x - centers[0].x, Is.EqualTo(9.6f).Within(0.4f));
            Assert.That(centers[1].y - centers[0].y, Is.EqualTo(0f).Within(0.2f));
        }

        // Waves of 0.2 m, five pixels long, whose slopes are up to 0.1; the sun is mirrored where they are 0.03. A mirror shows it in a few
        // pixels, each as bright as on flat water.
        [UnityTest]
        public IEnumerator A_highlight_widens_over_ripples_that_are_as_fine_as_pixels()
        {
            const float wave = 2f * math.PI / 0.2f, slope = 0.1f, mirrors = 0.03f;
            scene = new MeshScene(64, new Vector3(3f, 0.4f, 3f), 0.05f, 0f);
            LookDown(1.2f);
            scene.Surface.Sun.intensity = 1f;
            scene.Surface.Sun.transform.rotation = Quaternion.Euler(90f - 2f * math.degrees(math.atan(mirrors)), 90f, 0f);
            scene.Surface.Look = Absorbing();
            scene.Put(p => 0.1f + slope / wave * math.sin(wave * (p.x + 0.3f * p.z)) - p.y);
            yield return Frames();
            float brightest = 0f, mean = 0f;
            float3[] pixels = scene.Pixels();
            foreach (float3 pixel in pixels)
            {
                brightest = math.max(brightest, pixel.x);
                mean += pixel.x / pixels.Length;
            }
            TestContext.Out.WriteLine($"mean {mean:0.0000}, brightest {brightest:0.0000}");
            Assert.That(mean, Is.GreaterThan(1e-3f), "the sun is mirrored");
            Assert.That(brightest, Is.LessThan(6f * mean));
        }

        static SurfaceLook Absorbing()
        {
            SurfaceLook look = WaterScene.Absorbing(Left, 0.5f);
            look.roughness = 0f;
            return look;
        }
    }
}
