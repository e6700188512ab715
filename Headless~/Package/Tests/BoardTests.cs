using System;
using System.IO;
using Host.Assets;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Host.Tests
{
    /// <summary>The stored pictures of water before a checkerboard show what a ray tracer in double precision finds, which shares nothing with
    /// the path tracer that drew them but the scene's description.</summary>
    public class BoardTests
    {
        const int Pixels = 256, Rays = 4;       // of a pixel along x and y
        const double Index = 1.333, Ahead = 1e-9;

        delegate bool Shape(double3 origin, double3 direction, out double distance, out double3 normal);

        [TestCase("sphere")]
        [TestCase("cylinder")]
        [TestCase("sheet")]
        [TestCase("empty")]
        public void A_picture_of_water_before_a_board_is_what_a_ray_tracer_finds(string name)
        {
            double[] stored = Stored(name);
            double[] traced = Trace(ShapeOf(name));
            double error = Mean(stored, traced, out double bias);
            TestContext.Out.WriteLine($"{name}: mean difference {error:0.0000}, of the means {bias:0.0000}");
            Assert.That(error, Is.LessThan(0.007));
            Assert.That(bias, Is.EqualTo(0.0).Within(0.002));
        }

        // Upside down, without refraction, and with another index.
        [Test]
        public void The_comparison_tells_other_water()
        {
            double[] stored = Stored("sphere");
            Assert.That(Mean(stored, Trace(ShapeOf("empty")), out _), Is.GreaterThan(0.05));
            Assert.That(Mean(stored, Trace(ShapeOf("sphere"), 1.37), out _), Is.GreaterThan(0.015));
            Assert.That(Mean(Stored("sheet"), Trace((double3 o, double3 d, out double t, out double3 n) => Sheet(o, d, -30.0, out t, out n)), out _),
                Is.GreaterThan(0.05));
        }

        // sRGB from 0 to 1, the bottom row first.
        static double[] Stored(string name)
        {
            string file = Path.Combine(Session.Root(), "Headless~", "Package", "data", "boards", name + ".png");
            PngImage image = PngImage.Read(File.ReadAllBytes(file), file);
            Assert.That((image.Width, image.Height), Is.EqualTo((Pixels, Pixels)));
            var values = new double[Pixels * Pixels];
            for (int i = 0; i < values.Length; i++)
                values[i] = image.Pixels[i].r / 255.0;
            return values;
        }

        static double Mean(double[] a, double[] b, out double bias)
        {
            double sum = 0.0, signed = 0.0;
            for (int i = 0; i < a.Length; i++)
            {
                sum += Math.Abs(a[i] - b[i]);
                signed += a[i] - b[i];
            }
            bias = signed / a.Length;
            return sum / a.Length;
        }

        static double[] Trace(Shape shape, double index = Index)
        {
            var picture = new double[Pixels * Pixels];
            double half = Math.Tan(20.0 * Math.PI / 180.0);
            for (int y = 0; y < Pixels; y++)
                for (int x = 0; x < Pixels; x++)
                {
                    double sum = 0.0;
                    for (int i = 0; i < Rays * Rays; i++)
                    {
                        double across = (x + (i % Rays + 0.5) / Rays) / Pixels * 2.0 - 1.0;
                        double up = (y + (i / Rays + 0.5) / Rays) / Pixels * 2.0 - 1.0;
                        double3 direction = math.normalize(new double3(across * half, up * half, 1.0));
                        sum += Seen(shape, index, new double3(0.0, 0.0, -4.0), direction, false, 1.0);
                    }
                    double linear = sum / (Rays * Rays);
                    picture[y * Pixels + x] = linear <= 0.0031308 ? 12.92 * linear : 1.055 * Math.Pow(linear, 1.0 / 2.4) - 0.055;
                }
            return picture;
        }

        // Follows both rays at each surface, until what is left of the light cannot be seen.
        static double Seen(Shape shape, double index, double3 origin, double3 direction, bool inside, double weight)
        {
            if (weight < 1e-3)
                return 0.5;
            if (!shape(origin, direction, out double distance, out double3 normal))
            {
                double away = (3.0 - origin.z) / direction.z;
                if (!(away > 0.0) || double.IsInfinity(away))
                    return 0.5;
                double3 at = origin + away * direction;
                return ((long)Math.Floor(at.x / 0.5) + (long)Math.Floor(at.y / 0.5) & 1) == 0 ? 0.8 : 0.1;
            }
            double3 hit = origin + distance * direction;
            double cosine = -math.dot(normal, direction);
            if (cosine < 0.0)
                (normal, cosine) = (-normal, -cosine);
            double ratio = inside ? index : 1.0 / index, sine = ratio * ratio * (1.0 - cosine * cosine);
            double3 mirrored = direction + 2.0 * cosine * normal;
            if (sine >= 1.0)
                return Seen(shape, index, hit + 1e-7 * normal, mirrored, inside, weight);
            double beyond = Math.Sqrt(1.0 - sine);
            double across = (ratio * cosine - beyond) / (ratio * cosine + beyond), along = (cosine - ratio * beyond) / (cosine + ratio * beyond);
            double reflectance = 0.5 * (across * across + along * along);
            double3 bent = ratio * direction + (ratio * cosine - beyond) * normal;
            return reflectance * Seen(shape, index, hit + 1e-7 * normal, mirrored, inside, weight * reflectance)
                + (1.0 - reflectance) * Seen(shape, index, hit - 1e-7 * normal, bent, !inside, weight * (1.0 - reflectance));
        }

        static Shape ShapeOf(string name) => name switch
        {
            "sphere" => (double3 o, double3 d, out double t, out double3 n) => Round(o, d, 0.7, new double3(1.0, 1.0, 1.0), out t, out n),
            "cylinder" => (double3 o, double3 d, out double t, out double3 n) => Round(o, d, 0.5, new double3(1.0, 0.0, 1.0), out t, out n),
            "sheet" => (double3 o, double3 d, out double t, out double3 n) => Sheet(o, d, 30.0, out t, out n),
            _ => (double3 o, double3 d, out double t, out double3 n) =>
            {
                (t, n) = (0.0, default);
                return false;
            }
            ,
        };

        // Finds where the axes' sum of squares is that of the radius; an axis of 0 does not count.
        static bool Round(double3 origin, double3 direction, double radius, double3 axes, out double distance, out double3 normal)
        {
            double3 o = origin * axes, d = direction * axes;
            double a = math.lengthsq(d), b = math.dot(o, d), c = math.lengthsq(o) - radius * radius, root = b * b - a * c;
            (distance, normal) = (0.0, default);
            if (root <= 0.0 || a <= 0.0)
                return false;
            root = Math.Sqrt(root);
            distance = (-b - root) / a > Ahead ? (-b - root) / a : (-b + root) / a;
            normal = (o + distance * d) / radius;
            return distance > Ahead;
        }

        static bool Sheet(double3 origin, double3 direction, double degrees, out double distance, out double3 normal)
        {
            double angle = degrees * Math.PI / 180.0, cosine = Math.Cos(angle), sine = Math.Sin(angle);
            // The box's axes in the world, as Quaternion.Euler turns them: x towards the camera, z to the right.
            double3 right = new double3(cosine, 0.0, -sine), forward = new double3(sine, 0.0, cosine), up = new double3(0.0, 1.0, 0.0);
            double3 o = new double3(math.dot(origin, right), origin.y, math.dot(origin, forward));
            double3 d = new double3(math.dot(direction, right), direction.y, math.dot(direction, forward)), half = new double3(1.5, 1.5, 0.15);
            double enter = double.NegativeInfinity, leave = double.PositiveInfinity;
            double3 first = default, last = default;
            for (int i = 0; i < 3; i++)
            {
                double near = (-Math.Sign(d[i]) * half[i] - o[i]) / d[i], far = (Math.Sign(d[i]) * half[i] - o[i]) / d[i];
                double3 axis = i == 0 ? right : i == 1 ? up : forward;
                if (near > enter)
                    (enter, first) = (near, axis);
                if (far < leave)
                    (leave, last) = (far, axis);
            }
            (distance, normal) = enter > Ahead ? (enter, first) : (leave, last);
            return enter < leave && distance > Ahead;
        }
    }
}
