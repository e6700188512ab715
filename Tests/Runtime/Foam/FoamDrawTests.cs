using System.Collections;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>Coverage of a picture by foam that is drawn as particles.</summary>
    public class FoamDrawTests
    {
        const float Spacing = 0.05f;
        const float MiddleAge = 0.5f;       // of its life: neither coming nor going
        const float Half = 0.1f;            // half the height of what the camera sees, m
        static readonly float3 Box = new float3(1.2f, 0.8f, 0.4f);

        readonly List<GameObject> made = new List<GameObject>();
        FluidSimulation simulation;
        FluidFoam foam;
        Camera camera;
        RenderTexture target;

        [UnityTearDown]
        public IEnumerator LeaveNothing()
        {
            Time.captureDeltaTime = 0f;
            foreach (GameObject thing in made)
                Object.Destroy(thing);
            made.Clear();
            yield return null;
            if (target != null)
                target.Release();
        }

        // From a quarter of a pixel at 720p, where it is fainter and larger than it is, to seven pixels at 4K, where its cells are seen.
        [UnityTest, Category("LongRun")]
        public IEnumerator Foam_covers_as_much_at_720p_as_at_1080p_and_at_4K([Values(FoamKinds.Foam, FoamKinds.Spray)] FoamKinds kind,
            [Values(0.25f, 2.4f)] float pixels)
        {
            yield return Begin(pixels * 2f * Half / 720f);
            Plant(kind, 600, 0.6f * Half, new float3(3f, 4f, 0f) / Spacing);
            var covered = new List<float>();
            foreach (int height in new[] { 720, 1080, 2160 })
            {
                yield return Picture(height / 2, height);
                covered.Add(Pixels().Average());
            }
            TestContext.Out.WriteLine($"covered {string.Join(", ", covered.Select(part => $"{part:0.00000}"))}");
            Assert.That(covered[2], Is.GreaterThan(0.00005f));
            Assert.That(covered[0], Is.EqualTo(covered[2]).Within(0.02f * covered[2]));
            Assert.That(covered[1], Is.EqualTo(covered[2]).Within(0.02f * covered[2]));
        }

        [UnityTest]
        public IEnumerator Spray_is_a_streak_of_its_way_in_half_a_step_that_covers_what_it_did()
        {
            yield return Begin(0.002f);
            yield return Look(float3.zero);
            (float covered, float wide, float high) = Extent();
            const float speed = 6f;
            yield return Look(new float3(speed / Spacing, 0f, 0f));
            (float inMotion, float length, float thick) = Extent();
            float path = 0.5f * speed / 60f;
            TestContext.Out.WriteLine($"at rest {wide:0.0000} x {high:0.0000} m, at {speed} m/s {length:0.0000} x {thick:0.0000} m, and covers " +
                $"{inMotion / covered:0.000} of what it did");
            Assert.That(length - wide, Is.EqualTo(path).Within(0.1f * path));
            Assert.That(thick, Is.EqualTo(high).Within(0.0005f));
            Assert.That(inMotion, Is.EqualTo(covered).Within(0.03f * covered));

            IEnumerator Look(float3 velocity)
            {
                Plant(FoamKinds.Spray, 1, 0f, velocity);
                yield return Picture(540, 540);
            }
        }

        [UnityTest]
        public IEnumerator Foam_that_ages_opens_in_cells_and_does_not_turn_to_glass()
        {
            yield return Begin(0.06f);
            foam.Opacity = 1f;
            Plant(FoamKinds.Foam, 1, 0f, float3.zero);
            yield return Picture(256, 256);
            float young = Pixels().Sum();
            Assert.That(Open(), Is.LessThan(0.02f));
            Plant(FoamKinds.Foam, 1, 0f, float3.zero, 0.8f);
            yield return Picture(256, 256);
            TestContext.Out.WriteLine($"{Pixels().Sum() / young:0.000} of it at four fifths of its life, {Open():0.000} of its center open");
            Assert.That(Pixels().Sum() / young, Is.EqualTo(0.5f).Within(0.1f), "half of the time in which it goes is over");
            Assert.That(Open(), Is.InRange(0.25f, 0.65f), "and not half as dense everywhere");

            // Open fraction of the inner half of the particle, whose radius is 77 pixels.
            float Open()
            {
                float[] all = Pixels();
                float[] inner = Enumerable.Range(0, all.Length).Where(i => math.length(new float2(i % 256 - 127.5f, i / 256 - 127.5f)) < 38f)
                    .Select(i => all[i]).ToArray();
                return inner.Count(part => part < 0.02f) / (float)inner.Length;
            }
        }

        (float covered, float wide, float high) Extent()
        {
            float[] all = Pixels();
            int side = target.width;
            float least = 0.05f * all.Max(), meter = 2f * Half / side;
            int[] lit = Enumerable.Range(0, all.Length).Where(i => all[i] > least).ToArray();
            return (all.Sum(), (lit.Max(i => i % side) - lit.Min(i => i % side) + 1) * meter,
                (lit.Max(i => i / side) - lit.Min(i => i / side) + 1) * meter);
        }

        IEnumerator Begin(float radius)
        {
            GameObject fluid = Make("Fluid");
            fluid.SetActive(false);
            simulation = fluid.AddComponent<FluidSimulation>();
            simulation.Configure(Box, Spacing, 3000);
            GameObject water = Make("Volume");
            water.transform.SetParent(fluid.transform, false);
            water.transform.localPosition = new Vector3(-0.5f, 0f, 0f);
            water.AddComponent<FluidVolume>().Size = new Vector3(0.2f, 0.8f, 0.4f);
            foam = fluid.AddComponent<FluidFoam>();
            FoamSettings settings = foam.Settings;
            settings.amount = 0f;
            foam.Settings = settings;
            foam.Radius = radius;
            foam.Opacity = 0.5f;
            foam.Ambient = Color.black;
            foam.Sun = Make("Sun").AddComponent<Light>();
            foam.Sun.type = LightType.Directional;
            foam.Sun.transform.rotation = Quaternion.LookRotation(Vector3.down);
            fluid.SetActive(true);
            Time.captureDeltaTime = 1f / 60f;
            yield return null;
            yield return null;
            simulation.Paused = true;
        }

        /// <summary>Puts particles around the center of the box, at a part of their life.</summary>
        void Plant(FoamKinds kind, int count, float around, float3 velocity, float part = MiddleAge)
        {
            var random = new Unity.Mathematics.Random(7);
            const float life = 10f;
            FoamStage.Plant(simulation.Solver.Foam, Enumerable.Range(0, count).Select(i => FoamStage.Particle(
                (0.5f * Box + around * random.NextFloat3(-1f, 1f)) / Spacing, velocity, kind, part * life, life, random.NextUInt(256u))).ToArray());
        }

        IEnumerator Picture(int width, int height)
        {
            if (target != null)
                target.Release();
            target = new RenderTexture(width, height, 24, RenderTextureFormat.ARGBFloat);
            if (camera == null)
            {
                camera = Make("Camera").AddComponent<Camera>();
                camera.transform.position = new Vector3(0f, 0f, -5f);
                camera.orthographic = true;
                camera.orthographicSize = Half;
                camera.clearFlags = CameraClearFlags.SolidColor;
                camera.backgroundColor = Color.black;
            }
            camera.targetTexture = target;
            yield return null;
            yield return null;
        }

        // Green over that of foam that covers all.
        float[] Pixels()
        {
            var picture = new Texture2D(target.width, target.height, TextureFormat.RGBAFloat, false, true);
            RenderTexture.active = target;
            picture.ReadPixels(new Rect(0, 0, target.width, target.height), 0, 0);
            RenderTexture.active = null;
            float[] all = picture.GetPixels().Select(pixel => pixel.g / 0.8f).ToArray();
            Object.Destroy(picture);
            return all;
        }

        GameObject Make(string name)
        {
            var gameObject = new GameObject(name);
            made.Add(gameObject);
            return gameObject;
        }
    }
}
