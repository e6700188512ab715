using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Security.Cryptography;
using System.Text;
using System.Text.Json;
using UnityEngine.Headless;

namespace Host.Output
{
    /// <summary>The raw bytes of every live buffer after a frame: <c>frame/name.bin</c> and <c>frame/buffers.json</c>.</summary>
    static class BufferDump
    {
        public static void Write(string folder, int frame)
        {
            string target = Path.Combine(folder, frame.ToString());
            Directory.CreateDirectory(target);
            var entries = new List<object>();
            foreach ((BufferStorage buffer, string file) in BufferStorage.Live.Zip(
                FileNames(BufferStorage.Live.Select(buffer => buffer.Name)), (a, b) => (a, b)))
            {
                File.WriteAllBytes(Path.Combine(target, file), buffer.ReadAll());
                entries.Add(new { name = buffer.Name, count = buffer.Count, stride = buffer.Stride, target = buffer.Target == 0
                    ? "Structured" : buffer.Target.ToString(), file });
            }
            File.WriteAllText(Path.Combine(target, "buffers.json"),
                JsonSerializer.Serialize(entries, new JsonSerializerOptions { WriteIndented = true }) + "\n");
        }

        /// <summary>A file name for each buffer name: safe, and a number behind those that come again.</summary>
        public static IEnumerable<string> FileNames(IEnumerable<string> names)
        {
            var taken = new HashSet<string>(StringComparer.OrdinalIgnoreCase);
            foreach (string name in names)
            {
                string safe = string.Concat((name.Length == 0 ? "unnamed" : name).Select(c => char.IsLetterOrDigit(c) || "._- ".Contains(c)
                    ? c : '_'));
                string unique = safe;
                for (int i = 2; !taken.Add(unique); i++)
                    unique = $"{safe}-{i}";
                yield return unique + ".bin";
            }
        }

        /// <summary>SHA-256 over every live buffer's name, shape and bytes, in order of creation.</summary>
        public static string Hash()
        {
            using var hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
            foreach (BufferStorage buffer in BufferStorage.Live)
            {
                hash.AppendData(Encoding.UTF8.GetBytes($"{buffer.Name} {buffer.Count} {buffer.Stride}\n"));
                hash.AppendData(buffer.ReadAll());
            }
            return Convert.ToHexString(hash.GetHashAndReset()).ToLowerInvariant();
        }
    }
}
