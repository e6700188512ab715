using System;
using System.Collections;
using System.Linq;
using NUnit.Framework;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;
using static Rill.Tests.WaterScene;
using Random = Unity.Mathematics.Random;

namespace Rill.Tests
{
    /// <summary>Droplets and foam beside water that is drawn as a mesh, under a camera that looks straight down.</summary>
    public class WaterSprayTests
    {
        const float Picture = 0.6f;     // m
        const int Droplets = 12;
        const float FirstRadius = 0.3694f, LastRadius = 0.45f * FirstRadius;     // d, of the droplets of a particle
        const float Small = 6f, Shaped = 10f;       // texels: those up to here are added up, and those from here on are seen as they are
        const float MaxDropRadius = 0.01f;            // radius, m: larger ones burst
        const float Forward = 0.8f;     // cosine of the angle by which light has to be turned to come to the camera

        WaterScene scene;
        float scale;            // of the scene of drops
        float3 velocity;        // of the drops, m/s
        AmbientMode mode;
        Color sky;

        [SetUp]
        public void Begin()
        {
            velocity = 0f;
            scale = 0.4f;
            (mode, sky) = (RenderSettings.ambientMode, RenderSettings.ambientSkyColor);
            (RenderSettings.ambientMode, RenderSettings.ambientSkyColor) = (AmbientMode.Flat, Color.black);
        }

        [UnityTearDown]
        public IEnumerator End()
        {
            (RenderSettings.ambientMode, RenderSettings.ambientSkyColor) = (mode, sky);
            yield return scene.End();
        }

        // A cubic meter in smaller drops covers more.
        [UnityTest]
        public IEnumerator Droplets_that_are_too_large_to_be_whole_have_burst_into_smaller_ones([Values(24, 96, 288)] int pixels)
        {
            scale = 1f;
            yield return PutDrops(pixels);
            float texel = Picture / pixels, area = 0f;
            for (int k = 0; k < Droplets; k++)
            {
                float radius = FirstRadius * Spacing * math.pow(LastRadius / FirstRadius, k / (Droplets - 1f));
                area += 3f * math.PI * radius * radius * math.max(radius / MaxDropRadius, 1f);
            }
            float seen = Sum(), expected = area / (texel * texel) * ThroughBall(Forward);
            TestContext.Out.WriteLine($"light of {seen} pixels, due {expected}");
            Assert.That(seen / expected, Is.EqualTo(1f).Within(0.08f));
        }

        // The texel's width goes from half a spacing to a 24th, where the larger droplets are drawn by themselves. What flies is drawn out along
        // its path, and no brighter.
        [UnityTest]
        public IEnumerator Droplets_send_on_as_much_light_however_large_the_picture_is([Values(24, 48, 96, 288)] int pixels, [Values] bool fly)
        {
            velocity = fly ? new float3(1.6f, 0f, 0.8f) : 0f;
            yield return PutDrops(pixels);
            float texel = Picture / pixels / Spacing, area = 0f, bar = 0f;
            for (int k = 0; k < Droplets; k++)
            {
                float radius = FirstRadius * math.pow(LastRadius / FirstRadius, k / (Droplets - 1f));
                area += 3f * math.PI * radius * radius * (1f - math.smoothstep(Small, Shaped, radius / texel));
                bar += radius >= Small * texel ? 0.1f : 0.02f;      // of those that are drawn by themselves, whole pixels are
            }
            float seen = Sum(), expected = area / (texel * texel) * ThroughBall(Forward);
            TestContext.Out.WriteLine($"light of {seen} pixels, due {expected}");
            Assert.That(seen / expected, Is.EqualTo(1f).Within(0.06f + bar / Droplets));
        }

        [UnityTest]
        public IEnumerator Droplets_behind_a_part_of_the_scene_are_not_seen()
        {
            yield return PutDrops(48);
            Assert.That(Sum(), Is.GreaterThan(1f));
            GameObject plate = scene.NewUnlit(PrimitiveType.Quad, 0f);
            plate.GetComponent<MeshRenderer>().sharedMaterial = scene.Keep(new Material(Shader.Find("Rill/Solid")));
            plate.GetComponent<MeshRenderer>().sharedMaterial.color = Color.black;
            plate.transform.position = new Vector3(0f, scale * 0.3f, 0f);
            plate.transform.rotation = Quaternion.LookRotation(Vector3.down);
            yield return Frames(2);
            Assert.That(Sum(), Is.LessThan(0.01f));
        }

        // Pictures like those of 720, 1080 and 2160 lines: a particle is from two thirds of a texel to two.
        [UnityTest, Category("LongRun")]
        public IEnumerator Foam_covers_as_much_of_the_picture_however_large_it_is(
            [Values(0.3f, 0.6f, 0.9f)] float opacity, [Values] bool isUnderWater)
        {
            scene = new WaterScene(96);
            scene.Surface.CastShadows = ShadowCastingMode.Off;
            scene.Camera.backgroundColor = Color.black;
            scene.AddSun();
            FluidFoam foam = scene.Root.AddComponent<FluidFoam>();
            foam.Radius = 0.004f;
            foam.Opacity = opacity;
            FoamSettings settings = foam.Settings;
            settings.amount = 0f;
            foam.Settings = settings;
            yield return scene.Settle();
            const int sets = 3;
            var random = new Random(5);
            var covered = new float[3];
            for (int set = 0; set < sets; set++)
            {
                scene.Fluid.Paused = false;
                yield return Frames(isUnderWater ? 1 : 31);     // until its cells are others
                scene.Fluid.Paused = true;
                yield return Frames(1);
                FoamStage.Plant(scene.Fluid.Solver.Foam, Enumerable.Range(0, 1600).Select(_ =>
                {
                    float3 at = new float3(random.NextFloat(0.25f, 0.75f), Depth - (isUnderWater ? 0.1f : 0f), random.NextFloat(0.25f, 0.75f));
                    FoamParticle particle = FoamStage.Particle(at / Spacing, 0f, isUnderWater ? FoamKinds.Bubbles : FoamKinds.Foam, 20f, 100f);
                    particle.b.w |= (uint)random.NextInt(256) << 24;
                    return particle;
                }).ToArray());
                for (int i = 0; i < 3; i++)
                {
                    int size = 96 * (i == 0 ? 2 : i == 1 ? 3 : 6) / 2;
                    RenderTexture target = scene.NewTarget(size, size);
                    scene.Camera.targetTexture = target;
                    yield return Frames(2);
                    float4[] first = Pixels(target);
                    covered[i] += first.Average(pixel => pixel.y) / sets;
                    yield return Frames(1);
                    Assert.That(Pixels(target), Is.EqualTo(first), "the order of the particles does not matter");
                }
            }
            TestContext.Out.WriteLine($"covered {covered[0]}, {covered[1]}, {covered[2]}");
            Assert.That(covered[0], Is.GreaterThan((isUnderWater ? 0.09f : 0.1f) * opacity), "what is under water is darker");
            Assert.That(covered[1] / covered[0], Is.EqualTo(1f).Within(0.02f));
            Assert.That(covered[2] / covered[0], Is.EqualTo(1f).Within(0.02f));
        }

        // On a floor that is equally bright everywhere a cap is seen by what it mirrors, which is nothing: it is darker.
        [UnityTest]
        public IEnumerator A_particle_that_lies_on_a_collider_is_a_cap([Values(false, true)] bool fromTheSide)
        {
            const int pixels = 192;
            const float gray = 0.5f;
            scale = 1f;
            yield return PutDrops(pixels, new float3(0f, 0.5f * Spacing, 0f));
            GameObject floor = scene.NewPrimitive(PrimitiveType.Cube, scene.Keep(new Material(Shader.Find("Rill/Solid"))));
            floor.GetComponent<MeshRenderer>().sharedMaterial.SetColor("_Color", Encoded(gray));
            floor.GetComponent<MeshRenderer>().sharedMaterial.SetColor("_Ambient", Color.white);
            floor.transform.localScale = new Vector3(4f, 0.02f, 4f);
            floor.transform.position = new Vector3(0f, -0.01f, 0f);     // thinner than the ball that it is a cap of
            scene.Camera.backgroundColor = Encoded(gray);
            scene.Surface.Sun.intensity = 0f;
            scene.Camera.orthographicSize = 0.15f;
            if (fromTheSide)
                Look(scene.Camera, new Vector3(0f, 0f, -1f));
            yield return Frames(2);
            float4[] without = scene.Pixels();
            floor.AddComponent<FluidCollider>();
            scene.Fluid.Paused = false;
            yield return Frames(1);
            scene.Fluid.Paused = true;
            yield return Frames(2);
            float4[] pixelsOfCap = scene.Pixels();
            float meter = 0.3f / pixels, area = 0f, height = 0f, lowest = 0f;
            for (int i = 0; i < pixelsOfCap.Length; i++)
            {
                if (math.abs(pixelsOfCap[i].y - gray) < 0.002f)
                    continue;
                area += meter * meter;
                height = math.max(height, (i / pixels + 0.5f) * meter - 0.15f);
                lowest = math.min(lowest, (i / pixels + 0.5f) * meter - 0.15f);
            }
            float radius = 1.188f * Spacing, top = 0.432f * Spacing;
            TestContext.Out.WriteLine($"area {area}, of a cap seen from above {math.PI * radius * radius}; height {height}, {top}");
            Assert.That(without, Is.Not.EqualTo(pixelsOfCap));
            if (fromTheSide)
            {
                Assert.That(height, Is.EqualTo(top).Within(2f * meter));
                Assert.That(lowest, Is.GreaterThan(-2f * meter), "nothing is seen under the plate");
            }
            else
                Assert.That(area / (math.PI * radius * radius), Is.EqualTo(1f).Within(0.05f));
        }

        // Three particles that fly by themselves and stand still, lit from below and from the side, before black.
        IEnumerator PutDrops(int pixels, params float3[] points)
        {
            if (points.Length == 0)
                points = new[] { new float3(-0.15f, 0f, -0.15f), new float3(0.15f, 0.1f, -0.15f), new float3(0.15f, -0.1f, 0.15f) };
            scene = new WaterScene(pixels, new Vector3(0.6f, 0.5f, 0.6f), 0f, 64);
            scene.Fluid.Configure(scale * new Vector3(0.6f, 0.5f, 0.6f), scale * Spacing, 64);
            scene.Camera.orthographicSize *= scale;
            scene.Surface.CastShadows = ShadowCastingMode.Off;
            scene.Camera.backgroundColor = Color.black;
            Light sun = scene.AddSun();
            sun.transform.rotation = Quaternion.LookRotation(new Vector3(-math.sqrt(1f - Forward * Forward), Forward, 0f));
            scene.Fluid.Gravity = Vector3.zero;
            Time.captureDeltaTime = 1f / 60f;
            scene.Root.SetActive(true);
            yield return Frames(1);
            using (var positions = new NativeArray<float3>(points.Select(point => scale * point).ToArray(), Allocator.Temp))
            using (var velocities = new NativeArray<float3>(Enumerable.Repeat(scale * velocity, points.Length).ToArray(), Allocator.Temp))
                scene.Fluid.AddParticles(positions, velocities);
            yield return Frames(4);
            scene.Fluid.Paused = true;
            yield return Frames(2);
        }

        float Sum() => scene.Pixels().Sum(pixel => pixel.y);

        // Light that a ball of water bends twice by an angle, mean over its disc, where a white surface sends 1: geometric optics
        // (van de Hulst 1957, 12.2), and what it mirrors.
        static float ThroughBall(float cosine)
        {
            const double index = 1.333;
            double turned = Math.Acos(cosine), low = 0.0, high = 0.5 * Math.PI;
            for (int i = 0; i < 60; i++)
            {
                double mid = 0.5 * (low + high);
                if (2.0 * (mid - Math.Asin(Math.Sin(mid) / index)) < turned)
                    low = mid;
                else
                    high = mid;
            }
            double inner = Math.Asin(Math.Sin(low) / index), change = 2.0 * (1.0 - Math.Cos(low) / (index * Math.Cos(inner)));
            double through = 1.0 - Reflectance(low, inner);
            double mirrored = 0.5 * (Math.PI - turned);
            return (float)(through * through * Math.Sin(low) * Math.Cos(low) / (Math.Sin(turned) * change)
                + 0.25 * Reflectance(mirrored, Math.Asin(Math.Sin(mirrored) / index)));
        }

        static double Reflectance(double angle, double inner)
        {
            double across = Math.Sin(angle - inner) / Math.Sin(angle + inner), along = Math.Tan(angle - inner) / Math.Tan(angle + inner);
            return 0.5 * (across * across + along * along);
        }
    }
}
