using System.Collections;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>The shadow of water that is drawn as a mesh, on what stands between two slabs of it and on the floor below both.</summary>
    public class WaterShadowTests
    {
        const float Spacing = 0.05f, Degrees = 20f;
        const int Few = 96;     // pixels along a side: each sees one hole of the pattern, or none
        const float Step = 1f / 16f;        // of the pattern

        MeshScene scene;
        AmbientMode mode;
        Color sky;
        ShadowResolution resolution;

        [SetUp]
        public void Begin()
        {
            (mode, sky, resolution) = (RenderSettings.ambientMode, RenderSettings.ambientSkyColor, QualitySettings.shadowResolution);
            (RenderSettings.ambientMode, RenderSettings.ambientSkyColor) = (AmbientMode.Flat, Color.black);
            QualitySettings.shadowResolution = ShadowResolution.Medium;
        }

        [TearDown]
        public void End()
        {
            scene?.Dispose();
            scene = null;
            Time.captureDeltaTime = 0f;
            (RenderSettings.ambientMode, RenderSettings.ambientSkyColor, QualitySettings.shadowResolution) = (mode, sky, resolution);
        }

        // One spacing of water above the plate and two below it; four take all the light.
        [UnityTest]
        public IEnumerator Each_place_gets_the_light_that_the_water_above_it_leaves([Values(true, false)] bool isSunKnown)
        {
            scene = new MeshScene(Few, new Vector3(2f, 1.2f, 2f), Spacing, 0f);
            scene.Camera.orthographic = true;
            scene.Camera.orthographicSize = 0.2f;
            scene.Camera.nearClipPlane = 0.02f;
            scene.Camera.transform.SetPositionAndRotation(new Vector3(0f, 0.2f, 0f), Quaternion.LookRotation(Vector3.down, Vector3.forward));
            Part(new Vector3(0f, -0.7f, 0f), new Vector3(4f, 0.1f, 4f));
            Part(new Vector3(0.5f, 0f, 0f), new Vector3(0.9f, 0.02f, 4f));
            Light sun = scene.Surface.Sun;
            sun.intensity = 0.5f;
            sun.shadows = LightShadows.Hard;
            sun.transform.rotation = Quaternion.Euler(90f - Degrees, 0f, 0f);
            scene.Surface.Sun = isSunKnown ? sun : null;
            scene.Surface.ShadowOpacity = 1f;
            scene.Surface.Caustics = false;
            scene.Put(p => math.max(0.5f * Spacing - math.abs(p.y - 0.3f), Spacing - math.abs(p.y + 0.35f)));
            yield return Frames();
            (float plate, float floor) none = Sides();
            scene.Surface.CastShadows = ShadowCastingMode.On;
            yield return Frames();
            (float plate, float floor) plain = Sides();
            scene.Surface.Caustics = true;
            yield return Frames();
            (float plate, float floor) behind = Sides();
            float longer = 1f / math.cos(math.radians(Degrees));
            TestContext.Out.WriteLine($"no shadow {none}, a shadow {plain}, one behind all water {behind}");
            Assert.That(math.min(none.plate, none.floor), Is.GreaterThan(0.1f));
            Assert.That(plain.plate / none.plate, Is.EqualTo(1f - longer / 4f).Within(Step));
            Assert.That(plain.floor / none.floor, Is.EqualTo(1f - 3f * longer / 4f).Within(Step));
            if (!isSunKnown)
                yield break;
            Assert.That(behind.plate / none.plate, Is.EqualTo(1f).Within(0.02f), "light is gathered there instead");
            Assert.That(behind.floor / none.floor, Is.EqualTo(plain.floor / none.floor).Within(0.03f));
        }

        void Part(Vector3 position, Vector3 scale)
        {
            GameObject part = scene.Add(PrimitiveType.Cube, 0.5f, position, Quaternion.identity, scale);
            part.GetComponent<MeshRenderer>().sharedMaterial.SetColor("_Ambient", Color.black);
        }

        // The means of the plate on the right, and of the floor on the left.
        (float plate, float floor) Sides()
        {
            float3[] pixels = scene.Pixels();
            float plate = 0f, floor = 0f;
            for (int i = 0; i < pixels.Length; i++)
            {
                floor += i % Few < Few / 3 ? pixels[i].y : 0f;
                plate += i % Few >= 2 * Few / 3 ? pixels[i].y : 0f;
            }
            return (plate / (Few * Few / 3), floor / (Few * Few / 3));
        }

        static IEnumerator Frames()
        {
            Time.captureDeltaTime = 1f / 60f;
            yield return null;
            yield return null;
        }
    }
}
