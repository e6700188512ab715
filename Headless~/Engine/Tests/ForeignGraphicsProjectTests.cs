using System;
using System.Linq;
using System.Runtime.InteropServices;
using Host.Assets;
using NUnit.Framework;
using UnityEngine;

namespace Host.Tests
{
    /// <summary>Two projects that live by shaders: particles drawn by a surface shader, a fluid made of blits.</summary>
    public class ForeignGraphicsProjectTests
    {
        ForeignRun wcsph, grid;

        ForeignRun Wcsph => wcsph ??= new ForeignRun(ForeignRun.ProjectFolder("Wcsph"), 30, "--size", "320x180", "--dump", "<folder>/dump", "--at", "1,30");
        ForeignRun Grid => grid ??= new ForeignRun(ForeignRun.ProjectFolder("GridFluid"), 40, "--size", "320x180");

        [OneTimeTearDown]
        public void RemoveResults()
        {
            wcsph?.Dispose();
            grid?.Dispose();
        }

        static Color32 At(PngImage picture, int column, int row) => picture.Pixels[(picture.Height - 1 - row) * picture.Width + column];

        // ---- weakly compressible SPH: loose globals, kernels by number, DrawMeshInstancedIndirect

        [StructLayout(LayoutKind.Sequential)]
        struct Particle
        {
            public Vector3 Position, Velocity, Force;
            public float Density, Pressure;
        }

        const int Count = 960;

        Particle[] ParticlesAfter(int frame) => Wcsph.Buffer<Particle>(frame, Marshal.SizeOf<Particle>(), "Structured");

        [Test]
        public void The_column_falls_under_gravity_at_first()
        {
            Wcsph.MustHaveSucceeded();
            Particle[] particles = ParticlesAfter(1);
            Assert.That(particles.Length, Is.EqualTo(Count));
            // Three substeps of 3 ms an Update, the one of the frame in which no time passes included; most particles feel no pressure yet.
            float[] speeds = particles.Select(p => p.Velocity.y).OrderBy(v => v).ToArray();
            Assert.That(speeds[Count / 2], Is.EqualTo(-9.81f * 0.018f).Within(5e-3f));
        }

        [Test]
        public void The_water_spreads_stays_in_its_box_and_is_hardly_compressed()
        {
            Particle[] particles = ParticlesAfter(30);
            Assert.That(particles.All(p => p.Position.x >= 0 && p.Position.x <= 3 && p.Position.y >= 0 && p.Position.y <= 3 && p.Position.z >= 0 && p.Position.z <= 0.8f), "outside of the box");
            Assert.That(particles.Max(p => p.Position.x), Is.GreaterThan(1.05f), "it flows out to the side");
            Assert.That(particles.Average(p => p.Position.y), Is.LessThan(0.58f), "it sinks");
            Assert.That(particles.All(p => p.Density >= 1000), "the density is clamped from below");
            Assert.That(particles.Average(p => p.Density), Is.LessThan(1080));
        }

        [Test]
        public void Every_slow_particle_in_front_is_drawn_where_it_is_and_in_blue()
        {
            PngImage picture = Wcsph.Picture();
            var lens = new Lens(new Vector3(1.5f, 1.3f, -3), new Quaternion(0.0871557f, 0, 0, 0.9961947f), 60, picture);
            Particle[] front = ParticlesAfter(30).Where(p => p.Position.z < 0.08f && p.Velocity.magnitude < 1).ToArray();
            Assert.That(front.Length, Is.GreaterThan(20));
            int blue = front.Count(p => lens.TryFind(p.Position, out int column, out int row) && At(picture, column, row) is Color32 c && c.b > c.r + 20);
            Assert.That(blue, Is.GreaterThan(0.95 * front.Length), $"of {front.Length}");
            // The floor is white in the sun's colour and the sky's, the sky above bluish: both by built-in materials.
            Color32 floor = At(picture, 240, 165), sky = At(picture, 160, 5);
            Assert.That(floor.r - floor.b, Is.GreaterThan(sky.r - sky.b + 20), $"the floor {floor} under the sky {sky}");
            Assert.That(floor.r, Is.GreaterThan(150), $"the floor {floor}");
            Assert.That(sky.b, Is.GreaterThan(sky.r), $"the sky {sky}");
        }

        [Test]
        public void A_key_that_nobody_presses_is_asked_for_without_an_error() =>
            Assert.That(Wcsph.Errors.Where(line => line.StartsWith("error", StringComparison.Ordinal)), Is.Empty);

        // ---- stable fluids: chains of blits, OnRenderImage, a gamma project

        [Test]
        public void Dye_rises_from_where_it_is_poured_and_spreads()
        {
            Grid.MustHaveSucceeded();
            PngImage picture = Grid.Picture();
            float weight = 0, x = 0, y = 0;
            for (int row = 0; row < picture.Height; row++)
                for (int column = 0; column < picture.Width; column++)
                {
                    Color32 c = At(picture, column, row);
                    int light = c.r + c.g + c.b;
                    (weight, x, y) = (weight + light, x + light * (column + 0.5f), y + light * (row + 0.5f));
                }
            Assert.That(weight, Is.GreaterThan(100000), "light in the picture");
            x /= weight * picture.Width;
            y /= weight * picture.Height;
            // Poured on a way from (0.72, 0.3) to (0.54, 0.42), counted from the lower left, and carried upwards.
            Assert.That(x, Is.InRange(0.5f, 0.78f), "the middle of the dye from the left");
            Assert.That(1 - y, Is.InRange(0.36f, 0.7f), "the middle of the dye from below");
            Assert.That(At(picture, 10, 10), Is.EqualTo(new Color32(0, 0, 0, 255)), "far away nothing is");
        }

        [Test]
        public void Ink_begins_red()
        {
            PngImage picture = Grid.Picture();
            long red = picture.Pixels.Sum(p => (long)p.r), blue = picture.Pixels.Sum(p => (long)p.b);
            Assert.That(red, Is.GreaterThan(2 * blue));
        }

        [Test]
        public void Temporary_textures_are_no_leak()
        {
            Assert.That(Grid.Output, Does.Contain("0 GPU objects left"));
            Assert.That(Wcsph.Output, Does.Contain("0 GPU objects left"));
        }
    }
}
