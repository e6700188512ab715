using System;
using System.Collections.Generic;
using System.IO;
using System.Text.Json;
using Host.Shaders;

namespace Host.Testing
{
    /// <summary>How long fixtures took when they last ran, kept beside the compiled shaders. It only decides which of them begin.</summary>
    sealed class TestDurations
    {
        readonly string file;
        readonly Dictionary<string, double> seconds;

        /// <param name="folder">Null: the shaders' cache.</param>
        public TestDurations(string folder = null)
        {
            file = Path.Combine(Directory.CreateDirectory(Path.Combine(folder ?? ShaderCache.DefaultFolder(), "tests")).FullName, "durations.json");
            seconds = Read(file);
        }

        /// <summary>Infinite for one that never ran.</summary>
        public double Of(string fixture) => seconds.TryGetValue(fixture, out double known) ? known : double.PositiveInfinity;

        public void Note(string fixture, double duration) => seconds[fixture] = Math.Round(duration, 2);

        public void Save()
        {
            // Whoever looks meanwhile sees the whole file or none.
            string partial = file + "." + Guid.NewGuid().ToString("N");
            File.WriteAllText(partial, JsonSerializer.Serialize(seconds));
            File.Move(partial, file, overwrite: true);
        }

        static Dictionary<string, double> Read(string file)
        {
            try
            {
                return File.Exists(file) ? JsonSerializer.Deserialize<Dictionary<string, double>>(File.ReadAllText(file)) ?? new() : new();
            }
            catch (JsonException)
            {
                return new();    // a file that a full disk cut short: written again
            }
        }
    }
}
