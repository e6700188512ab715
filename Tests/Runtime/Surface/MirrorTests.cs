using System;
using System.Collections;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.TestTools;

namespace Rill.Tests
{
    /// <summary>A pool mirrors a wall and a ball that stand above it, and shows its floor, as a ray tracer in double precision draws it.</summary>
    public class MirrorTests
    {
        const int Pixels = 192, Rays = 3;
        const double Index = 1.333, Size = 3.0, Floor = -0.2, Level = 0.0, Square = 0.25, WallAt = 1.6, Around = 0.3;
        static readonly double3 Left = new double3(0.4, 0.75, 0.85), Dark = new double3(0.08, 0.1, 0.3), Bright = new double3(0.9, 0.8, 0.6),
            WallDark = new double3(0.5, 0.25, 0.1), WallBright = new double3(0.9, 0.7, 0.45), Ball = new double3(0.8, 0.1, 0.05),
            BallCenter = new double3(0.1, 0.45, 0.6);
        const double BallRadius = 0.25;

        MeshScene scene;

        [TearDown]
        public void End()
        {
            scene?.Dispose();
            scene = null;
            Time.captureDeltaTime = 0f;
        }

        [UnityTest]
        public IEnumerator A_pool_mirrors_what_stands_above_it()
        {
            scene = new MeshScene(2 * Pixels, new Vector3(3f, 0.4f, 3f), 0.05f, (float)Around);
            Camera camera = scene.Camera;
            camera.fieldOfView = 40f;
            camera.transform.position = new Vector3(0f, 0.55f, -2.2f);
            camera.transform.LookAt(new Vector3(0f, 0.15f, 0.5f));
            scene.AddBoard(new Vector3(0f, (float)Floor, 0f), Vector3.right, Vector3.forward, (float)Square, 24, (float3)Dark, (float3)Bright);
            scene.AddBoard(new Vector3(0f, 0f, (float)WallAt), Vector3.right, Vector3.up, (float)Square, 24, (float3)WallDark, (float3)WallBright);
            scene.Add(PrimitiveType.Sphere, (float3)Ball, (float3)BallCenter, Quaternion.identity, Vector3.one * (float)(2.0 * BallRadius));
            SurfaceLook look = WaterScene.Absorbing((float3)Left, 1f);
            look.roughness = 0f;
            scene.Surface.Look = look;
            scene.Put(p => (float)Level - p.y);
            Time.captureDeltaTime = 1f / 60f;
            yield return null;
            yield return null;
            yield return null;
            float3[] picture = scene.Pixels(2);
            double3[] tracedPicture = Trace(camera, true);
            MeshScene.Save("mirror", picture);
            MeshScene.Save("mirror_traced", Array.ConvertAll(tracedPicture, color => (float3)color));
            double[] drawn = Array.ConvertAll(picture, pixel => Ssim.Luminance(new double3(pixel)));
            double likeness = Ssim.Mean(drawn, Array.ConvertAll(tracedPicture, Ssim.Luminance), Pixels, Pixels);
            double without = Ssim.Mean(drawn, Array.ConvertAll(Trace(camera, false), Ssim.Luminance), Pixels, Pixels);
            TestContext.Out.WriteLine($"SSIM {likeness:0.000}; {without:0.000} of a pool that mirrors nothing");
            Assert.That(likeness, Is.GreaterThan(0.9));
            Assert.That(without, Is.LessThan(likeness - 0.03), "it can tell");
        }

        static double3[] Trace(Camera camera, bool mirrors)
        {
            var picture = new double3[Pixels * Pixels];
            for (int y = 0; y < Pixels; y++)
                for (int x = 0; x < Pixels; x++)
                {
                    double3 sum = 0.0;
                    for (int i = 0; i < Rays * Rays; i++)
                    {
                        Ray ray = camera.ViewportPointToRay(new Vector3((x + (i % Rays + 0.5f) / Rays) / Pixels, (y + (i / Rays + 0.5f) / Rays)
                            / Pixels, 0f));
                        sum += Seen(new double3((float3)ray.origin), math.normalize(new double3((float3)ray.direction)), mirrors) / (Rays * Rays);
                    }
                    picture[y * Pixels + x] = sum;
                }
            return picture;
        }

        static double3 Seen(double3 o, double3 d, bool mirrors)
        {
            double3 color = Scene(o, d, out double scene);
            double water = (Level - o.y) / d.y;
            double3 at = o + d * water;
            if (!(water > 0.0) || water > scene || Math.Max(Math.Abs(at.x), Math.Abs(at.z)) > 0.5 * Size)
                return color;
            double cosine = -d.y, ratio = 1.0 / Index, beyond = Math.Sqrt(1.0 - ratio * ratio * (1.0 - cosine * cosine));
            double across = (ratio * cosine - beyond) / (ratio * cosine + beyond), along = (cosine - ratio * beyond) / (cosine + ratio * beyond);
            double reflectance = mirrors ? 0.5 * (across * across + along * along) : 0.0;
            double3 bent = d * ratio + new double3(0.0, ratio * cosine - beyond, 0.0);
            double3 below = Scene(at + 1e-6 * bent, bent, out double path);
            return reflectance * Scene(at, new double3(d.x, -d.y, d.z), out _) + (1.0 - reflectance) * below * math.pow(Left, path);
        }

        static double3 Scene(double3 o, double3 d, out double distance)
        {
            distance = double.PositiveInfinity;
            double3 color = Around;
            double floor = (Floor - o.y) / d.y, wall = (WallAt - o.z) / d.z;
            if (floor > 0.0)
                (distance, color) = (floor, Squares(o + d * floor, 0, 2) ? Dark : Bright);
            if (wall > 0.0 && wall < distance)
                (distance, color) = (wall, Squares(o + d * wall, 0, 1) ? WallDark : WallBright);
            double3 to = BallCenter - o;
            double nearest = math.dot(to, d), square = math.lengthsq(to) - nearest * nearest;
            double ball = nearest - Math.Sqrt(Math.Max(BallRadius * BallRadius - square, 0.0));
            if (square < BallRadius * BallRadius && ball > 0.0 && ball < distance)
                (distance, color) = (ball, Ball);
            return color;
        }

        static bool Squares(double3 at, int u, int v) => ((int)Math.Floor(at[u] / Square) + (int)Math.Floor(at[v] / Square) & 1) == 0;
    }
}
