using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Rill;
using Unity.Mathematics;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Host.Tests
{
    /// <summary>`rill export` of a sample in a process of its own, and its files as VTK and meshio read them.</summary>
    public sealed class ExportTests : GraphicsFixture
    {
        const string Sample = "Still Pool";
        const int Every = 2, Files = 3;

        string folder;

        [SetUp]
        public void MakeFolder() => folder = Directory.CreateTempSubdirectory("rill-export-").FullName;

        [TearDown]
        public void RemoveFolder() => Directory.Delete(folder, true);

        [Category("LongRun")]       // a player of its own
        [TestCase("vtk", ParticleReaderTests.ReadVtk)]
        [TestCase("ply", ParticleReaderTests.ReadPly)]
        public void The_files_of_a_sample_are_what_is_in_its_box_in_the_order_of_time(string format, string script)
        {
            Box box = BoxOf(Sample);
            (int code, string text) = Export(Sample, "--seconds", "0.1", "--every", Every.ToString(), "--format", format, "--out", folder);
            Assert.That(code, Is.Zero, text);
            Assert.That(text, Does.Contain($"{Files} files in {folder}"));
            string[] files = Directory.GetFiles(folder).OrderBy(file => file, StringComparer.Ordinal).ToArray();
            Assert.That(files.Select(Path.GetFileName), Is.EqualTo(Enumerable.Range(0, Files).Select(i => $"particles_{i:000000}.{format}")));

            var times = new List<double>();
            foreach (string file in files)
            {
                times.Add(TimeOf(file));
                string[] lines = ParticleReaderTests.Read(script, file);
                if (format == "vtk")
                    Assert.That(double.Parse(lines[0].Split(' ')[2], CultureInfo.InvariantCulture), Is.EqualTo(times.Last()), "as VTK reads it");
                double[][] particles = lines.Skip(1)
                    .Select(line => line.Split(' ').Select(word => double.Parse(word, CultureInfo.InvariantCulture)).ToArray()).ToArray();
                AssertSound(particles, box);
            }
            Assert.That(times[0], Is.EqualTo(Every / 60.0).Within(1e-3), "after the steps of the frames before it");
            for (int i = 1; i < Files; i++)
                Assert.That(times[i] - times[i - 1], Is.EqualTo(Every / 60.0).Within(1e-3));
        }

        // x, y, z, velocity, density, phase, id: of still water, all of which is in the box.
        static void AssertSound(double[][] particles, Box box)
        {
            Assert.That(particles, Has.Length.EqualTo(3072));
            Assert.That(particles.All(particle => particle.All(double.IsFinite)));
            Assert.That(particles.Select(particle => particle[8]).Distinct().Count(), Is.EqualTo(particles.Length), "ids");
            float margin = 0.1f * box.spacing;
            foreach (double[] particle in particles)
            {
                Vector3 local = box.toLocal.MultiplyPoint3x4(new Vector3((float)particle[0], (float)particle[1], (float)particle[2]));
                for (int axis = 0; axis < 3; axis++)
                    Assert.That(local[axis], Is.InRange(-margin, box.size[axis] + margin), $"particle {particle[8]}, axis {axis}");
                Assert.That(math.length(new double3(particle[3], particle[4], particle[5])), Is.LessThan(1.0), "still, m/s");
            }
            // At the surface the sum over neighbors lacks what would be above; most particles are not there.
            double[] densities = particles.Select(particle => particle[6] / box.density).OrderBy(density => density).ToArray();
            Assert.That(densities[densities.Length / 2], Is.EqualTo(1.0).Within(0.05), "the median");
            Assert.That(densities[0], Is.GreaterThan(0.4));
            Assert.That(densities[^1], Is.LessThan(1.2));
        }

        [Test, Category("LongRun")]
        public void Bad_input_is_named_with_what_to_do_and_leaves_no_file()
        {
            string target = Path.Combine(folder, "new");
            AssertRefused("--format obj: give ply or vtk", Sample, "--format", "obj", "--out", target);
            AssertRefused("No Such Scene", "No Such Scene", "--out", target);
            AssertRefused("--every", Sample, "--every", "0", "--out", target);
            string file = Path.Combine(folder, "file");
            File.WriteAllText(file, "");
            AssertRefused($"--out {file}/below: no files can be written there", Sample, "--out", file + "/below");
            Assert.That(Directory.GetFileSystemEntries(folder).Select(Path.GetFileName), Is.EqualTo(new[] { "file" }));
        }

        static void AssertRefused(string problem, params string[] arguments)
        {
            (int code, string text) = Export(arguments);
            TestContext.Out.WriteLine(text);
            Assert.That(code, Is.EqualTo(2), text);
            Assert.That(text, Does.Contain(problem));
        }

        static double TimeOf(string file)
        {
            using var reader = new StreamReader(file);
            string head = reader.ReadLine() + reader.ReadLine() + reader.ReadLine();
            return double.Parse(Regex.Match(head, "Rill, fluid time ([^ ]+) s").Groups[1].Value, CultureInfo.InvariantCulture);
        }

        struct Box
        {
            public Matrix4x4 toLocal;       // from world space; the lowest corner is 0, m
            public Vector3 size;
            public float spacing, density;
        }

        static Box BoxOf(string sample)
        {
            using var scene = new SampleScene(sample);
            var fluid = Object.FindAnyObjectByType<FluidSimulation>();
            Transform box = fluid.transform;
            return new Box
            {
                toLocal = Matrix4x4.Translate(0.5f * fluid.DomainSize) * Matrix4x4.TRS(box.position, box.rotation, Vector3.one).inverse,
                size = fluid.DomainSize,
                spacing = fluid.ParticleSpacing,
                density = fluid.Material.density,
            };
        }

        static (int code, string text) Export(params string[] arguments)
        {
            var all = new List<string> { Assembly.GetEntryAssembly().Location, "export" };
            all.AddRange(arguments);
            using var process = Process.Start(new ProcessStartInfo("dotnet", all) { RedirectStandardOutput = true, RedirectStandardError = true });
            var errors = process.StandardError.ReadToEndAsync();
            string output = process.StandardOutput.ReadToEnd();
            process.WaitForExit();
            return (process.ExitCode, output + errors.Result);
        }
    }
}
