using System.Collections;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>The scene's fog in front of the water, seen from above over black.</summary>
    public class FogTests
    {
        const float Height = 3f, Depth = 0.6f, Away = Height - (Depth - 0.5f);      // m, of the camera; of the water; between them
        const int Pixels = 32;

        static readonly float3 Fog = new float3(0.2f, 0.4f, 0.6f);

        GameObject root;
        FluidSimulation fluid;
        Camera camera;
        RenderTexture target;

        [SetUp]
        public void Make()
        {
            target = new RenderTexture(Pixels, Pixels, 24, RenderTextureFormat.ARGBFloat, RenderTextureReadWrite.Linear);
            camera = new GameObject("Camera").AddComponent<Camera>();
            camera.orthographic = true;
            camera.orthographicSize = 0.3f;
            camera.farClipPlane = 10f;
            camera.clearFlags = CameraClearFlags.SolidColor;
            camera.backgroundColor = Color.black;
            camera.allowHDR = true;
            camera.targetTexture = target;
            camera.transform.position = new Vector3(0f, Height, 0f);
            camera.transform.LookAt(Vector3.zero, Vector3.forward);

            root = new GameObject("Fluid");
            root.SetActive(false);
            fluid = root.AddComponent<FluidSimulation>();
            fluid.Configure(Vector3.one, 0.05f, 8000);
            fluid.StatisticsInterval = 0;
            var volume = new GameObject("Water").AddComponent<FluidVolume>();
            volume.transform.SetParent(root.transform, false);
            volume.transform.localPosition = new Vector3(0f, 0.5f * (Depth - 1f), 0f);
            volume.Size = new Vector3(1f, Depth, 1f);
            var sun = new GameObject("Sun").AddComponent<Light>();
            sun.transform.SetParent(root.transform, false);
            sun.transform.rotation = Quaternion.LookRotation(new Vector3(-0.8f, -0.6f, 0f));
            sun.enabled = false;
            var surface = root.AddComponent<FluidSurface>();
            surface.Preset = SurfacePreset.Milk;
            surface.ReflectionStrength = 0f;
            surface.Sun = sun;
            RenderSettings.fogColor = QualitySettings.activeColorSpace == ColorSpace.Linear ? new Color(Fog.x, Fog.y, Fog.z).gamma : new Color(Fog.x, Fog.y, Fog.z);
        }

        [UnityTearDown]
        public IEnumerator LeaveNothing()
        {
            RenderSettings.fog = false;
            Time.captureDeltaTime = 0f;
            Object.Destroy(root);
            Object.Destroy(camera.gameObject);
            yield return null;
            target.Release();
        }

        [UnityTest]
        public IEnumerator Water_is_seen_through_the_fog_in_front_of_it([Values] FogMode mode, [Values] bool refraction)
        {
            root.GetComponent<FluidSurface>().Refraction = refraction;
            Time.captureDeltaTime = 1f / 60f;
            root.SetActive(true);
            yield return Frames(20);
            fluid.Paused = true;
            yield return Frames(2);
            float3 clear = Middle();
            Assert.That(math.cmin(clear), Is.GreaterThan(0.1f));

            const float density = 0.2f, start = 1f, end = 5f;
            RenderSettings.fog = true;
            RenderSettings.fogMode = mode;
            RenderSettings.fogDensity = density;
            RenderSettings.fogStartDistance = start;
            RenderSettings.fogEndDistance = end;
            yield return Frames(2);
            float seen = mode == FogMode.Linear ? (end - Away) / (end - start) : mode == FogMode.Exponential ? math.exp(-density * Away) : math.exp(-density * density * Away * Away);
            Assert.That(math.cmax(math.abs(Middle() - math.lerp(Fog, clear, seen))), Is.LessThan(0.01f));
        }

        static IEnumerator Frames(int count)
        {
            for (int i = 0; i < count; i++)
                yield return null;
        }

        float3 Middle()
        {
            var picture = new Texture2D(Pixels, Pixels, TextureFormat.RGBAFloat, false, true);
            RenderTexture.active = target;
            picture.ReadPixels(new Rect(0, 0, Pixels, Pixels), 0, 0);
            RenderTexture.active = null;
            Color seen = picture.GetPixel(Pixels / 2, Pixels / 2);
            Object.DestroyImmediate(picture);
            return new float3(seen.r, seen.g, seen.b);
        }
    }
}
