using System.Collections;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>Ripples on a flat pool that a camera sees from straight above, by a sky that it mirrors and whose brightness tells the slope along
    /// x.</summary>
    public class WaterRipplesTests
    {
        const int Pixels = 96;
        const float Spacing = 0.05f, Half = 0.15f;      // m; half the height of the picture
        const float TexelsPerSpacing = Pixels * Spacing / (2f * Half);
        const float Highest = 0.15f;        // slope, rms
        const float Reflectance = 0.020395f;
        const float Fast = 0.25f;       // displacement in a substep that has the highest ripples, d

        MeshScene scene;

        [SetUp]
        public void Begin()
        {
            Time.captureDeltaTime = 1f / 60f;
            scene = MeshScene.FromAbove(Pixels, Spacing, Half);
            scene.Surface.Reflection = Sky();
            scene.Surface.Ripples = 1f;
        }

        [TearDown]
        public void End()
        {
            scene.Dispose();
            Time.captureDeltaTime = 0f;
        }

        [UnityTest]
        public IEnumerator Water_that_stands_still_has_none_and_fast_water_the_highest()
        {
            yield return Put(0f);
            Assert.That(Slopes().Max(slope => math.abs(slope)), Is.LessThan(0.002f), "still");
            yield return Put(0.5f * Fast);
            float slow = Rms(Slopes());
            yield return Put(Fast);
            float fast = Rms(Slopes());
            scene.Surface.Ripples = 0.5f;
            yield return WaterScene.Frames(1);
            float half = Rms(Slopes());
            scene.Surface.Ripples = 0f;
            yield return WaterScene.Frames(1);
            TestContext.Out.WriteLine($"slopes rms: slow {slow}, fast {fast}, half as high {half}");
            Assert.That(fast, Is.EqualTo(Highest).Within(0.2f * Highest), "of a few ripples");
            Assert.That(half / fast, Is.EqualTo(0.5f).Within(0.1f));
            Assert.That(slow, Is.LessThan(0.7f * fast));
            Assert.That(Slopes().Max(slope => math.abs(slope)), Is.LessThan(0.002f), "off");
        }

        [UnityTest]
        public IEnumerator The_flow_carries_them()
        {
            yield return Put(Fast);
            float[] before = Slopes();
            yield return WaterScene.Frames(1);
            float[] after = Slopes();
            int shift = (int)math.round(Fast * TexelsPerSpacing);
            Assert.That(shift, Is.EqualTo(4));
            float carried = MeshScene.Likeness(before, after, shift), stayed = MeshScene.Likeness(before, after, 0);
            float against = MeshScene.Likeness(before, after, -shift);
            TestContext.Out.WriteLine($"alike where the flow has carried them: {carried}, where they were: {stayed}, against the flow: {against}");
            Assert.That(carried, Is.GreaterThan(0.97f));
            Assert.That(stayed, Is.LessThan(0.93f));
            Assert.That(against, Is.LessThan(0.75f));
        }

        // They are roughness instead.
        [UnityTest]
        public IEnumerator Those_that_are_smaller_than_some_texels_are_not_seen_one_by_one()
        {
            scene.Camera.orthographicSize = 8f * Half;
            yield return Put(Fast);
            Assert.That(Slopes(Pixels / 4).Max(slope => math.abs(slope)), Is.LessThan(0.002f));
        }

        IEnumerator Put(float displacement)
        {
            scene.Put(p => -p.y, displacement: new Vector3(displacement, 0f, 0f));
            yield return WaterScene.Frames(3);
        }

        // Along x, of each pixel of the center of the picture; before what stands in the water, which is black.
        float[] Slopes(int size = Pixels)
        {
            float3[] pixels = scene.Pixels();
            int first = (Pixels - size) / 2;
            return Enumerable.Range(0, size * size)
                .Select(i => 0.5f - pixels[(first + i / size) * Pixels + first + i % size].y / Reflectance).ToArray();
        }

        static float Rms(float[] slopes) => math.sqrt(slopes.Average(slope => slope * slope));

        // Brightness 0.5 straight above and 0.5 more for each unit along x: a slope of s, which mirrors what is 2 s towards -x, shows s less.
        Cubemap Sky()
        {
            const int size = 128;
            var cube = scene.Keep(new Cubemap(size, TextureFormat.RGBAHalf, false));
            var face = new Color[size * size];
            for (int i = 0; i < face.Length; i++)
            {
                // Position on the upper face, whose rows go along z.
                float x = (i % size + 0.5f) / size * 2f - 1f, z = (i / size + 0.5f) / size * 2f - 1f;
                float value = 0.5f + 0.5f * x / math.sqrt(1f + x * x + z * z);
                face[i] = new Color(value, value, value, 1f);
            }
            for (int side = 0; side < 6; side++)
                cube.SetPixels(face, (CubemapFace)side);
            cube.Apply();
            return cube;
        }
    }
}
