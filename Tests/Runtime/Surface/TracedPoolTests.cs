using System;
using System.Collections;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>
    /// Still water over a floor of squares with a ball in it, seen from an angle, against a ray tracer in double precision: Snell's law, Schlick's
    /// reflectance, Beer and Lambert along the refracted ray.
    /// </summary>
    public class TracedPoolTests
    {
        const int Pixels = 128, Rays = 3;        // of the picture, and of a pixel along x and y
        const float Size = 3f, Fill = 0.4f, Floor = -0.4f, Square = 0.25f, Index = 1.333f;

        // linear
        static readonly double3 Dark = new double3(0.08, 0.1, 0.3), Bright = new double3(0.9, 0.8, 0.6), Ball = new double3(0.8, 0.1, 0.05);
        static readonly double3 Left = new double3(0.4, 0.75, 0.85);        // of white after 1 m
        static readonly double3 BallCenter = new double3(0.1, Floor + 0.15, 0.1);
        const double BallRadius = 0.14;

        WaterScene scene;
        Camera camera;

        [SetUp]
        public void Make()
        {
            scene = new WaterScene(Pixels, new Vector3(Size, 0.8f, Size), Fill, 40000);
            camera = scene.Camera;
            camera.orthographic = false;
            camera.fieldOfView = 26f;
            camera.nearClipPlane = 0.1f;
            camera.backgroundColor = Color.black;
            camera.transform.position = new Vector3(0f, 1.5f, -1.7f);
            camera.transform.LookAt(new Vector3(0f, Floor + 0.5f * Fill, 0f));
            scene.AddSun().intensity = 0f;
            scene.Surface.CastShadows = UnityEngine.Rendering.ShadowCastingMode.Off;
            scene.Surface.Look = Look(Index);

            Material dark = Unlit(Dark), bright = Unlit(Bright);
            int half = (int)(0.5f * Size / Square);
            for (int x = -half; x < half; x++)
                for (int z = -half; z < half; z++)
                {
                    GameObject square = scene.NewPrimitive(PrimitiveType.Quad, (x + z & 1) == 0 ? dark : bright);
                    square.transform.position = new Vector3((x + 0.5f) * Square, Floor, (z + 0.5f) * Square);
                    square.transform.rotation = Quaternion.LookRotation(Vector3.down);
                    square.transform.localScale = new Vector3(Square, Square, 1f);
                }
            GameObject ball = scene.NewPrimitive(PrimitiveType.Sphere, Unlit(Ball));
            ball.transform.position = (float3)BallCenter;
            ball.transform.localScale = Vector3.one * (float)(2.0 * BallRadius);
        }

        [UnityTearDown]
        public IEnumerator LeaveNothing() => scene.End();

        [UnityTest]
        public IEnumerator A_pool_looks_as_a_ray_tracer_draws_it()
        {
            yield return scene.Settle(6);
            double[] traced = Luminance(Trace()), drawn = Luminance(Read());
            double likeness = Ssim.Mean(drawn, traced, Pixels, Pixels);
            scene.Surface.Look = Look(1f);
            yield return null;
            yield return null;
            double straight = Ssim.Mean(Luminance(Read()), traced, Pixels, Pixels);
            TestContext.Out.WriteLine($"SSIM {likeness:0.000}; {straight:0.000} where nothing is refracted");
            Assert.That(likeness, Is.GreaterThan(0.9));
            Assert.That(straight, Is.LessThan(0.7), "it can tell");
        }

        // In the depth texture, as Unlit/Color is not; all light, so that no lamp adds to it.
        Material Unlit(double3 linear)
        {
            Material material = scene.Keep(new Material(Shader.Find("Rill/Solid")));
            material.SetColor("_Color", WaterScene.Encoded((float3)linear));
            material.SetColor("_Ambient", Color.white);
            return material;
        }

        static SurfaceLook Look(float index)
        {
            SurfaceLook look = WaterScene.Absorbing((float3)Left, 1f);
            look.refractionIndex = index;
            return look;
        }

        double3[] Trace()
        {
            var picture = new double3[Pixels * Pixels];
            for (int y = 0; y < Pixels; y++)
                for (int x = 0; x < Pixels; x++)
                    for (int i = 0; i < Rays * Rays; i++)
                    {
                        Ray ray = camera.ViewportPointToRay(new Vector3((x + (i % Rays + 0.5f) / Rays) / Pixels,
                            (y + (i / Rays + 0.5f) / Rays) / Pixels, 0f));
                        picture[y * Pixels + x] += Seen(new double3((float3)ray.origin), math.normalize(new double3((float3)ray.direction)))
                            / (Rays * Rays);
                    }
            return picture;
        }

        static double3 Seen(double3 origin, double3 direction)
        {
            double3 water = origin + direction * ((Floor + Fill - origin.y) / direction.y);
            double cosine = -direction.y, ratio = 1.0 / Index, inside = Math.Sqrt(1.0 - ratio * ratio * (1.0 - cosine * cosine));
            double3 bent = direction * ratio + new double3(0.0, ratio * cosine - inside, 0.0);
            double length = (Floor - water.y) / bent.y;
            double3 floor = water + bent * length;
            double3 color = ((int)Math.Floor(floor.x / Square) + (int)Math.Floor(floor.z / Square) & 1) == 0 ? Dark : Bright;
            double3 toBall = BallCenter - water;
            double nearest = math.dot(toBall, bent), square = math.lengthsq(toBall) - nearest * nearest;
            if (square < BallRadius * BallRadius)
            {
                length = nearest - Math.Sqrt(BallRadius * BallRadius - square);
                color = Ball;
            }
            double normal = Math.Pow((Index - 1.0) / (Index + 1.0), 2.0), reflectance = normal + (1.0 - normal) * Math.Pow(1.0 - cosine, 5.0);
            return color * math.pow(Left, length) * (1.0 - reflectance);
        }

        double3[] Read() => Array.ConvertAll(scene.Pixels(), pixel => new double3(pixel.xyz));

        static double[] Luminance(double3[] picture) => Array.ConvertAll(picture, Ssim.Luminance);
    }
}
