using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Security.Cryptography;
using System.Text;
using System.Threading;
using System.Threading.Tasks;

namespace Host.Shaders
{
    /// <summary>
    /// Microsoft's d3dcompiler_47.dll, a program for Windows that calls it, and what wine needs to run that. All of it lies in
    /// a folder of the cache and is made there once, by one process at a time.
    /// </summary>
    sealed class FxcInstallation
    {
        const string Gcc = "x86_64-w64-mingw32-gcc", WineFolder = "/usr/lib/wine";    // Debian's wine64 is in no folder of the PATH

        static readonly string[] WineNames = { "wine64", "wine" };
        static readonly TimeSpan MaxWait = TimeSpan.FromMinutes(10);

        /// <summary>Folders in which programs are searched when none are named.</summary>
        public static IReadOnlyList<string> ToolFolders
            => (Environment.GetEnvironmentVariable("PATH") ?? "").Split(Path.PathSeparator).Where(f => f.Length > 0).Append(WineFolder)
            .ToList();

        /// <summary>Wine's drive Z: what the compiler reads and writes must lie in it.</summary>
        public readonly string Folder;

        readonly string wine, worker, prefix;
        readonly IReadOnlyList<string> toolFolders;

        /// <summary>Makes what is not there yet.</summary>
        /// <param name="cacheFolder">Everything goes into its folder "fxc".</param>
        /// <exception cref="FxcException">Something is missing; says how to install it.</exception>
        public FxcInstallation(string cacheFolder, IReadOnlyList<string> toolFolders)
        {
            Folder = Directory.CreateDirectory(Path.Combine(cacheFolder, "fxc")).FullName;
            prefix = Path.Combine(Folder, "wine");
            this.toolFolders = toolFolders;
            using FileStream only = Lock(Path.Combine(Folder, "lock"));
            wine = WineNames.Select(Find).FirstOrDefault(path => path != null)
                ?? throw new FxcException("wine64 is not there; it runs Microsoft's shader compiler (Debian: apt-get install wine64).");
            worker = BuildWorker();
            FxcDownload.Fetch(Folder, Find("npm"));
            WinePrefix.Make(prefix, TryOut);
        }

        /// <summary>Starts fxc-worker.exe on the files "jobs" and "results" of a folder within <see cref="Folder"/>.</summary>
        public Process Start(string workingFolder)
        {
            var start = new ProcessStartInfo(wine, new[] { worker, "jobs", "results" }) { WorkingDirectory = workingFolder,
                RedirectStandardError = true };
            start.Environment["WINEPREFIX"] = prefix;
            // Microsoft's, not wine's own; no offers to install .NET
            start.Environment["WINEDLLOVERRIDES"] = "d3dcompiler_47=n;mscoree=;mshtml=;winemenubuilder.exe=";
            start.Environment["WINEDEBUG"] = "-all";
            start.Environment.Remove("DISPLAY");
            start.Environment.Remove("WAYLAND_DISPLAY");
            return Process.Start(start);
        }

        string Find(string tool) => toolFolders.Select(f => Path.Combine(f, tool)).FirstOrDefault(File.Exists);

        string BuildWorker()
        {
            using Stream resource = typeof(FxcInstallation).Assembly.GetManifestResourceStream("fxc-worker.c");
            using var reader = new StreamReader(resource);
            string source = reader.ReadToEnd();
            string hash = Convert.ToHexString(SHA256.HashData(Encoding.UTF8.GetBytes(source))).Substring(0, 12);
            string program = Path.Combine(Folder, $"fxc-worker-{hash}.exe");
            if (File.Exists(program))
                return program;

            string gcc = Find(Gcc) ?? throw new FxcException($"{Gcc} is not there; it builds the program that calls Microsoft's shader " +
                $"compiler (Debian: apt-get install gcc-mingw-w64-x86-64).");
            InNewFolder(Folder, temporary =>
            {
                File.WriteAllText(Path.Combine(temporary, "fxc-worker.c"), source);
                Run(gcc, temporary, "-O1", "-s", "-o", "fxc-worker.exe", "fxc-worker.c");
                File.Move(Path.Combine(temporary, "fxc-worker.exe"), program, overwrite: true);
            });
            return program;
        }

        // No jobs: wine's registry is made, and the compiler is shown to load, before several processes need both at once.
        void TryOut() => InNewFolder(Folder, temporary =>
        {
            File.WriteAllBytes(Path.Combine(temporary, "jobs"), BitConverter.GetBytes(0));
            using Process process = Start(temporary);
            Task<string> errors = process.StandardError.ReadToEndAsync();
            if (!process.WaitForExit(60000))
                process.Kill(entireProcessTree: true);
            if (!process.HasExited || process.ExitCode != 0)
                throw new FxcException(
                    $"{wine} cannot run Microsoft's shader compiler here: {(errors.Wait(1000) ? errors.Result.Trim() : "it does not end")}");
        });

        static FileStream Lock(string path)
        {
            for (var waited = Stopwatch.StartNew(); ; Thread.Sleep(100))
                try
                {
                    return new FileStream(path, FileMode.OpenOrCreate, FileAccess.ReadWrite, FileShare.None);
                }
                catch (IOException) when (waited.Elapsed < MaxWait)
                {
                    // Another process installs.
                }
        }

        /// <summary>Beside what becomes of it: a move is one step then, and a process that is stopped leaves nothing half done.</summary>
        public static void InNewFolder(string parent, Action<string> work)
        {
            string temporary = Directory.CreateDirectory(Path.Combine(parent, Guid.NewGuid().ToString("N"))).FullName;
            try
            {
                work(temporary);
            }
            finally
            {
                Directory.Delete(temporary, recursive: true);
            }
        }

        public static void Run(string program, string folder, params string[] arguments)
        {
            var start = new ProcessStartInfo(program, arguments) { WorkingDirectory = folder, RedirectStandardOutput = true,
                RedirectStandardError = true };
            using Process process = Process.Start(start);
            Task<string> errors = process.StandardError.ReadToEndAsync();
            string log = process.StandardOutput.ReadToEnd() + errors.Result;
            process.WaitForExit();
            if (process.ExitCode != 0)
                throw new FxcException(
                    $"{Path.GetFileName(program)} {string.Join(" ", arguments)} failed with code {process.ExitCode}: {log.Trim()}");
        }
    }
}
