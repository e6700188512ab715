using System;
using System.Collections.Generic;
using System.ComponentModel;
using System.Diagnostics;
using System.Linq;
using System.Text.Json;

namespace Host.Check
{
    /// <summary>Content that a registry would hand out: all that Unity sees, samples and documentation, and nothing of the workshop.</summary>
    sealed class TarballRule : Rule
    {
        // Read by Unity though hidden, and shipped.
        static readonly string[] Shipped = { "Samples~/", "Documentation~/" };

        public override string Name => "package: npm pack holds what users need and nothing else";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            List<string> packed = Pack(package, findings);
            if (packed == null)
                return findings;
            HashSet<string> wanted = package.Visible.Concat(
                package.Files.Where(f => Shipped.Any(folder => f.StartsWith(folder, StringComparison.Ordinal)))).ToHashSet();
            foreach (string file in packed.Where(f => !wanted.Contains(f)).OrderBy(f => f, StringComparer.Ordinal))
                findings.Fault($"{file} would be shipped, and no user needs it: name it in .npmignore");
            foreach (string file in wanted.Except(packed).OrderBy(f => f, StringComparer.Ordinal))
                findings.Fault($"{file} would not be shipped: see .npmignore");
            findings.Looked = $"{packed.Count} files in the tarball";
            return findings;
        }

        static List<string> Pack(PackageTree package, Findings findings)
        {
            var start = new ProcessStartInfo("npm", new[] { "pack", "--dry-run", "--json", "--ignore-scripts" }) {
                WorkingDirectory = package.Root, RedirectStandardOutput = true, RedirectStandardError = true };
            try
            {
                using Process process = Process.Start(start);
                var errors = process.StandardError.ReadToEndAsync();
                string output = process.StandardOutput.ReadToEnd();
                process.WaitForExit();
                if (process.ExitCode == 0)
                {
                    using JsonDocument json = JsonDocument.Parse(output);
                    return json.RootElement[0].GetProperty("files").EnumerateArray().Select(file => file.GetProperty("path").GetString()).ToList();
                }
                findings.Fault($"npm pack failed with exit code {process.ExitCode}: {errors.Result.Trim().ReplaceLineEndings(" ")}");
            }
            catch (Win32Exception)
            {
                findings.Fault("npm is not installed: apt-get install npm, or Node.js from https://nodejs.org");
            }
            catch (JsonException e)
            {
                findings.Fault($"npm pack --json wrote something else than JSON: {e.Message}");
            }
            return null;
        }
    }
}
