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
        const float Away = 3f - (WaterScene.Depth - 0.5f);      // m, from the camera to the water

        static readonly float3 Fog = new float3(0.2f, 0.4f, 0.6f);

        WaterScene scene;

        [SetUp]
        public void Make()
        {
            scene = new WaterScene(32);
            scene.Camera.backgroundColor = Color.black;
            scene.AddSun();
            scene.Surface.Preset = SurfacePreset.Milk;
            RenderSettings.fogColor = WaterScene.Encoded(Fog);
        }

        [UnityTearDown]
        public IEnumerator LeaveNothing()
        {
            yield return scene.End();
        }

        [UnityTest, Category("LongRun")]
        public IEnumerator Water_is_seen_through_the_fog_in_front_of_it([Values] FogMode mode, [Values] bool refraction)
        {
            scene.Surface.Refraction = refraction;
            yield return scene.Settle();
            float3 clear = scene.At(0f);
            Assert.That(math.cmin(clear), Is.GreaterThan(0.1f));

            const float density = 0.2f, start = 1f, end = 5f;
            RenderSettings.fog = true;
            RenderSettings.fogMode = mode;
            RenderSettings.fogDensity = density;
            RenderSettings.fogStartDistance = start;
            RenderSettings.fogEndDistance = end;
            yield return WaterScene.Frames(2);
            float seen = mode == FogMode.Linear ? (end - Away) / (end - start) : mode == FogMode.Exponential ? math.exp(-density * Away)
                : math.exp(-density * density * Away * Away);
            Assert.That(math.cmax(math.abs(scene.At(0f) - math.lerp(Fog, clear, seen))), Is.LessThan(0.01f));
        }
    }
}
