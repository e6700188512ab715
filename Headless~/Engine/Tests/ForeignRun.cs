using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Runtime.InteropServices;
using System.Text.Json;
using Host.Assets;
using NUnit.Framework;
using UnityEngine;

namespace Host.Tests
{
    /// <summary>`rill run --project` on one of the projects beside these tests, in a process of its own: scripts that were loaded once
    /// stay.</summary>
    sealed class ForeignRun : IDisposable
    {
        public readonly int ExitCode;
        /// <summary>Lines of both streams, in the order of each.</summary>
        public readonly string[] Output, Errors;
        readonly string folder = Path.Combine(Path.GetTempPath(), "rill-foreign-" + Guid.NewGuid().ToString("N"));

        public static string ProjectFolder(string name) => Path.Combine(TestFolder.Path, "Projects", name);

        public ForeignRun(string project, int frames, params string[] more)
        {
            string host = Assembly.GetEntryAssembly().Location;
            var arguments = new List<string> { host, "run", "--project", project, "--frames", frames.ToString(), "--every",
                frames.ToString(), "--no-video", "--out", folder };
            arguments.AddRange(more.Select(argument => argument.Replace("<folder>", folder)));
            using var process = Process.Start(new ProcessStartInfo("dotnet", arguments) { RedirectStandardOutput = true,
                RedirectStandardError = true });
            var errors = process.StandardError.ReadToEndAsync();
            Output = Lines(process.StandardOutput.ReadToEnd());
            Errors = Lines(errors.Result);
            process.WaitForExit();
            ExitCode = process.ExitCode;
        }

        static string[] Lines(string text) => text.Split('\n', StringSplitOptions.RemoveEmptyEntries);

        public string Everything => string.Join("\n", Output.Concat(Errors));

        /// <summary>The last drawn frame; the first row is the top one.</summary>
        public PngImage Picture()
        {
            string file = Directory.GetFiles(Path.Combine(folder, "frames"), "*.png").OrderBy(name => name).Last();
            return PngImage.Read(File.ReadAllBytes(file), file);
        }

        /// <summary>The dumped buffer of that stride and target.</summary>
        public T[] Buffer<T>(int frame, int stride, string target) where T : struct
        {
            string at = Path.Combine(folder, "dump", frame.ToString());
            using JsonDocument list = JsonDocument.Parse(File.ReadAllText(Path.Combine(at, "buffers.json")));
            JsonElement buffer = list.RootElement.EnumerateArray().Single(b => b.GetProperty("stride").GetInt32() == stride
                && b.GetProperty("target").GetString().Contains(target));
            return MemoryMarshal.Cast<byte, T>(File.ReadAllBytes(Path.Combine(at, buffer.GetProperty("file").GetString()))).ToArray();
        }

        public void MustHaveSucceeded() => Assert.That(ExitCode, Is.EqualTo(0), Everything);

        public void Dispose()
        {
            if (Directory.Exists(folder)) Directory.Delete(folder, true);
        }
    }

    /// <summary>Computes where a point of the world lies in a picture, by hand.</summary>
    sealed class Lens
    {
        readonly Vector3 position;
        readonly Quaternion rotation;
        readonly float scale;
        readonly int width, height;

        public Lens(Vector3 position, Quaternion rotation, float fieldOfView, PngImage picture)
        {
            this.position = position;
            this.rotation = rotation;
            (width, height) = (picture.Width, picture.Height);
            scale = height / 2f / Mathf.Tan(fieldOfView / 2 * Mathf.Deg2Rad);
        }

        /// <summary>Column and row from the top left; false outside of the picture.</summary>
        public bool TryFind(Vector3 world, out int column, out int row)
        {
            Vector3 seen = Quaternion.Inverse(rotation) * (world - position);
            column = (int)Mathf.Floor(width / 2f + seen.x / seen.z * scale);
            row = (int)Mathf.Floor(height / 2f - seen.y / seen.z * scale);
            return seen.z > 0 && column >= 0 && row >= 0 && column < width && row < height;
        }
    }
}
