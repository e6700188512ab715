using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Runtime.InteropServices;
using Host.Assets;
using NUnit.Framework;
using UnityEngine;

namespace Host.Tests
{
    /// <summary>Projects as users of Unity write them, played by the host.</summary>
    public class ForeignProjectTests
    {
        ForeignRun boids, prefabs;

        ForeignRun Boids => boids ??= new ForeignRun(ForeignRun.ProjectFolder("Boids"), 12, "--size", "480x270", "--dump", "<folder>/dump",
            "--at", "11,12");
        ForeignRun Prefabs => prefabs ??= new ForeignRun(ForeignRun.ProjectFolder("Prefabs"), 90, "--size", "480x270");

        [OneTimeTearDown]
        public void RemoveResults()
        {
            boids?.Dispose();
            prefabs?.Dispose();
        }

        // ---- boids: append buffers, indirect draws

        struct Boid
        {
            public Vector3 Position, Velocity;
            public float Noise;
        }

        // Count of the scene.
        const int Count = 600;
        const float Speed = 5, ViewRadius = 8;
        static readonly Vector3 Center = new Vector3(0, 3, 0);
        static readonly Color32 Night = new Color32(13, 20, 38, 255);

        static readonly int Stride = Marshal.SizeOf<Boid>();

        [Test]
        public void Boids_fly_on_by_their_velocity()
        {
            Boids.MustHaveSucceeded();
            Boid[] before = Boids.Buffer<Boid>(11, Stride, "Structured"), after = Boids.Buffer<Boid>(12, Stride, "Structured");
            Assert.That(after.Length, Is.EqualTo(Count));
            for (int i = 0; i < Count; i++)
            {
                Assert.That(after[i].Velocity.magnitude, Is.EqualTo(Speed * after[i].Noise).Within(1e-3f), $"speed of boid {i}");
                Assert.That(Vector3.Distance(after[i].Position, before[i].Position + after[i].Velocity / 60), Is.LessThan(1e-4f), $"way of boid {i}");
            }
            Assert.That(after.Count(b => Vector3.Distance(b.Position, Center) > ViewRadius), Is.GreaterThan(20), "boids that are not to be seen");
        }

        // 3 steps, and shaders are compiled in the first.
        [Test]
        public void Steps_that_compile_shaders_do_not_count_to_the_time_of_a_step()
        {
            using var run = new ForeignRun(ForeignRun.ProjectFolder("Boids"), 3, "--no-frames");
            run.MustHaveSucceeded();
            Assert.That(run.Output, Has.Exactly(1).Match(
                @"^2 steps, \d+\.\d ms a step, \d+\.\d ms at the 99\.9th percentile; beside them 1 that compiled shaders took \d+ ms$"));
        }

        [Test]
        public void As_many_instances_are_drawn_as_were_appended()
        {
            Boid[] all = Boids.Buffer<Boid>(12, Stride, "Structured");
            List<Boid> near = all.Where(b => Vector3.Distance(b.Position, Center) < ViewRadius).ToList();
            uint[] arguments = Boids.Buffer<uint>(12, 20, "IndirectArguments");
            Assert.That(arguments, Is.EqualTo(new uint[] { 36, (uint)near.Count, 0, 0, 0 }));

            // The order of appending is the device's.
            IEnumerable<Boid> appended = Boids.Buffer<Boid>(12, Stride, "Append").Take(near.Count);
            Assert.That(appended.Select(b => b.Position.ToString("R")).OrderBy(p => p),
                Is.EqualTo(near.Select(b => b.Position.ToString("R")).OrderBy(p => p)));
        }

        [Test]
        public void Every_visible_boid_is_in_the_picture_and_no_other()
        {
            PngImage picture = Boids.Picture();
            Quaternion rotation = Quaternion.Euler(15, 30, 0);
            var lens = new Lens(Center - rotation * Vector3.forward * 32, rotation, 60, picture);
            bool IsNight(int column, int row) => Distance(At(picture, column, row), Night) <= 2;

            var near = new List<(int column, int row)>();
            foreach (Boid boid in Boids.Buffer<Boid>(12, Stride, "Structured"))
                if (Vector3.Distance(boid.Position, Center) < ViewRadius && lens.TryFind(boid.Position, out int column, out int row))
                    near.Add((column, row));
            Assert.That(near.Count(p => !IsNight(p.column, p.row)), Is.GreaterThan(0.97 * near.Count), $"of {near.Count} boids");

            // A boid is less than four pixels long.
            int stray = 0;
            for (int row = 0; row < picture.Height; row++)
                for (int column = 0; column < picture.Width; column++)
                    if (!IsNight(column, row) && !near.Any(p => Math.Abs(p.column - column) <= 5 && Math.Abs(p.row - row) <= 5)) stray++;
            Assert.That(stray, Is.EqualTo(0), "pixels away from every visible boid");
        }

        [Test]
        public void Elements_of_the_user_interface_hold_their_values_and_raise_their_events()
            => Assert.That(Boids.Output, Does.Contain("HUD says: 600 boids"));

        [Test]
        public void What_the_host_passes_over_is_said()
        {
            Assert.That(Boids.Errors, Has.Some.Contains("AudioSource in name only"));
            Assert.That(Boids.Errors, Has.Some.Contains("the package com.unity.cinemachine 2.9.7 is not here"));
            Assert.That(Boids.Errors, Has.None.Contains("com.unity.ide.visualstudio"), "a player has nothing of it");
            Assert.That(Boids.Output, Does.Contain("never called here: OnGUI of FlockHud"));
            Assert.That(Boids.Output, Has.Some.StartsWith("not part of the host: UnityEngine.Input.GetKey, called "));
            Assert.That(Boids.Output.Last(), Does.StartWith(
                "2 assemblies, 4 scripts compiled, 0 left out, 0 components missing, 1 packages missing"));
        }

        // ---- prefabs, assets, coroutines

        [Test]
        public void Prefabs_overrides_assets_events_and_coroutines_do_what_they_do_in_Unity()
        {
            Prefabs.MustHaveSucceeded();
            string[] said = Prefabs.Output.SkipWhile(line => line != "booting Towers").Where(line => !line.Contains(" on ")
                && !line.Contains("steps")).Take(9).ToArray();
            Assert.That(said, Is.EqualTo(new[]
            {
                "booting Towers",
                "saved {\"runs\":3,\"player\":\"none\",\"position\":{\"x\":1.5,\"y\":0.0,\"z\":0.0}}",
                "loaded Spark and sunset over the bay",
                "Small Tower: 2 floors, 1 of 2 windows lit, 2 lamps",
                "Small Tower says hello",
                "Big Tower: 3 floors, 2 of 3 windows lit, 2 lamps",
                "Big Tower says good evening",
                "risen to 4.00",
                "5 sparks spawned",
            }));
        }

        [Test]
        public void Lamps_have_the_colors_of_gradient_and_curve()
        {
            PngImage picture = Prefabs.Picture();
            var lens = new Lens(new Vector3(0, 2, -10), Quaternion.identity, 40, picture);
            void Look(Vector3 at, Color expected, string what)
            {
                Assert.That(lens.TryFind(at, out int column, out int row), what);
                Assert.That(Distance(At(picture, column, row), expected), Is.LessThanOrEqualTo(2),
                    $"{what}: {At(picture, column, row)} instead of {(Color32)expected}");
            }

            for (int i = 0; i < 4; i++) Look(new Vector3(-1.6f + 0.8f * i, 4, 0), Shade(i / 4f), $"spark {i}");
            Look(new Vector3(1.6f, 4, 0), new Color(0.1f, 0.1f, 0.1f), "the position of the spark that was destroyed");
            foreach (float tower in new[] { -2.5f, 2.5f })
            {
                Look(new Vector3(tower - 1.2f, 0.5f, 0), Shade(1), "a lamp with an overridden shade");
                Look(new Vector3(tower + 1.2f, 0.5f, 0), Shade(0.25f), "a lamp whose shade an event set");
                Look(new Vector3(tower, 0.5f, -0.6f), new Color(0.25f, 0.25f, 0.25f), "a floor");
            }
            Look(new Vector3(2.5f, 2.5f, -0.3f), new Color(0.25f, 0.25f, 0.25f), "the third floor, which only the big tower has");
            Look(new Vector3(-2.5f, 2.5f, -0.3f), new Color(0.1f, 0.1f, 0.1f), "above the small tower");
        }

        /// <summary>Red over green to blue, dimmed by a smooth step from 1 to a half.</summary>
        static Color Shade(float t)
        {
            Color hue = t < 0.5f ? new Color(1 - 2 * t, 2 * t, 0) : new Color(0, 2 - 2 * t, 2 * t - 1);
            return hue * (1 - 0.5f * (3 * t * t - 2 * t * t * t));
        }

        [Test]
        public void A_script_that_does_not_compile_is_named_with_its_first_error()
        {
            string line = Prefabs.Errors.Single(text => text.StartsWith("left out: ", StringComparison.Ordinal));
            Assert.That(line, Does.StartWith("left out: Assets/Scripts/Old/LegacyWind.cs(10,21): error CS1061: 'Camera' does not " +
                "contain a definition for 'RenderToCubemap'"));
            Assert.That(line, Does.EndWith("(Unity 2022.3 has it, the host does not)"));
            Assert.That(Prefabs.Output, Does.Contain("Assembly-CSharp: 5 of 6 scripts compiled"));
        }

        // ---- what the user typed

        [TestCase("Nowhere", "is no Unity project (a folder with Assets and ProjectSettings)")]
        public void A_folder_that_is_no_project_is_refused(string folder, string message)
        {
            using var run = new ForeignRun(ForeignRun.ProjectFolder(folder), 1);
            Assert.That(run.ExitCode, Is.EqualTo(2));
            Assert.That(run.Errors.Single(), Does.Contain(message));
        }

        static Color32 At(PngImage picture, int column, int row) => picture.Pixels[(picture.Height - 1 - row) * picture.Width + column];

        static int Distance(Color32 a, Color32 b) => Math.Max(Math.Abs(a.r - b.r), Math.Max(Math.Abs(a.g - b.g), Math.Abs(a.b - b.b)));
    }
}
