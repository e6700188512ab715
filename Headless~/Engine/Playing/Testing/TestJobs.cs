using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.IO.Pipes;
using System.Linq;
using System.Reflection;
using System.Runtime.InteropServices;
using System.Text.Json;
using System.Threading;
using System.Threading.Tasks;

namespace Host.Testing
{
    /// <summary>
    /// Distributes fixtures among worker processes: a worker that is free asks for the next. One that dies takes the fixture that it ran with it,
    /// which counts as failed, and another goes on with the rest.
    /// </summary>
    sealed class TestJobs : IDisposable
    {
        /// <summary>More were not measured, and each process has a session's memory and start of its own.</summary>
        public const int MaxDefault = 4;
        public const int Max = 64;

        /// <summary>Seconds without a word after which a worker counts as stuck: no fixture takes half as long on two busy cores.</summary>
        public const int DefaultLimit = 1200;

        /// <summary>Bytes from which on a worker gets no further fixture, and another takes its place: what lavapipe has compiled stays in a process,
        /// and two that run all fixtures would take 12 GB each.</summary>
        const long MaxMemory = 4L << 30;

        const string DeviceThreads = "LP_NUM_THREADS";      // how many lavapipe starts

        readonly object key = new();
        readonly List<string> arguments;
        readonly TestTally tally;
        readonly int limit;
        readonly List<Process> running = new();
        readonly List<PosixSignalRegistration> signals = new();
        readonly HashSet<string> open = new();              // handed to no worker yet
        bool isStopped;

        /// <param name="arguments">Of <c>rill test</c>, to choose the same tests.</param>
        /// <param name="limit">Seconds that a worker may take from one report to the next; it is then ended.</param>
        public TestJobs(List<string> arguments, TestTally tally, int limit = DefaultLimit)
        {
            this.arguments = arguments;
            this.tally = tally;
            this.limit = limit;
            foreach (PosixSignal signal in new[] { PosixSignal.SIGINT, PosixSignal.SIGTERM, PosixSignal.SIGHUP })
                signals.Add(PosixSignalRegistration.Create(signal, _ => Stop()));
        }

        /// <summary>Facts of the workers that came to their end.</summary>
        public List<TestFacts> Facts { get; } = new();

        /// <summary>Faults that belong to no fixture.</summary>
        public List<string> Complaints { get; } = new();

        /// <summary>Number of processes that suits this machine: lavapipe leaves cores idle between dispatches, a GPU is shared at a loss.</summary>
        public static int Default(bool isSoftware) => isSoftware ? Math.Min(Environment.ProcessorCount, MaxDefault) : 1;

        /// <param name="alone">Of the fixtures that run alone, instead of the others.</param>
        public void Run(List<string> fixtures, int jobs, bool alone)
        {
            open.UnionWith(fixtures);
            jobs = Math.Min(jobs, fixtures.Count);
            List<Thread> threads = Enumerable.Range(0, jobs)
                .Select(_ => new Thread(() => Work(Math.Max(1, Environment.ProcessorCount / jobs), alone))).ToList();
            threads.ForEach(thread => thread.Start());
            threads.ForEach(thread => thread.Join());
            if (open.Count > 0)
                Complaints.Add($"no worker was left to run {string.Join(", ", open.Select(Title))}");
            open.Clear();
        }

        public void Dispose()
        {
            Stop();
            signals.ForEach(signal => signal.Dispose());
        }

        void Work(int deviceThreads, bool alone)
        {
            bool goesOn = true;
            while (goesOn)
            {
                // One that dies before it has taken a fixture would do so again.
                goesOn = !Serve(deviceThreads, alone, out int taken) && taken > 0;
                lock (key)
                    goesOn &= open.Count > 0 && !isStopped;
            }
        }

        /// <returns>The worker came to its end, and was not replaced for its memory.</returns>
        bool Serve(int deviceThreads, bool alone, out int taken)
        {
            string name = "rill-test-" + Guid.NewGuid().ToString("N"), current = null;
            bool ended = false, isStuck = false, isFull = false;
            taken = 0;
            using var pipe = new NamedPipeServerStream(name, PipeDirection.InOut, 1, PipeTransmissionMode.Byte, PipeOptions.Asynchronous);
            using Process process = Start(name, deviceThreads, alone);
            if (process == null)
                return false;
            using var clock = new Timer(_ =>
            {
                isStuck = true;
                process.Kill(entireProcessTree: true);
            }, null, 1000L * limit, Timeout.Infinite);
            try
            {
                if (IsConnected(pipe, process))
                {
                    using var reader = new StreamReader(pipe, leaveOpen: true);
                    using var writer = new StreamWriter(pipe, leaveOpen: true) { AutoFlush = true };
                    while (reader.ReadLine() is string line)
                    {
                        WorkerMessage message = JsonSerializer.Deserialize<WorkerMessage>(line);
                        clock.Change(1000L * limit, Timeout.Infinite);
                        isFull |= message.Claim != null && taken > 0 && MemoryOf(process) > MaxMemory;
                        lock (key)
                        {
                            if (message.Report != null)
                                tally.Add(message.Report);
                            if (message.Report?.Fixture == current)
                                current = null;
                            if (message.Facts != null)
                                Facts.Add(message.Facts);
                            if (message.Claim != null && !isFull && open.Remove(message.Claim))
                            {
                                current = message.Claim;
                                taken++;
                            }
                        }
                        ended |= message.Facts != null;
                        if (message.Claim != null)
                            writer.WriteLine(message.Claim == current ? "yes" : "no");
                    }
                }
            }
            catch (Exception error) when (error is IOException or JsonException)
            {
                // It died while it was answered, or within a message.
            }
            process.WaitForExit();
            lock (key)
            {
                running.Remove(process);
                if (isStopped || ended && process.ExitCode == 0)
                    return ended && !isFull;
                string ending = isStuck ? $"was ended after {limit} s" : Ending(process.ExitCode);
                if (current != null)
                    tally.Add(new FixtureReport { Assembly = current.Split(' ')[0], Failed = 1,
                        Text =
                        $"  {Title(current).Split('.').Last(),-44} FAILED: its worker process {ending} while it ran {Title(current)}\n" });
                else
                    Complaints.Add($"a worker process {ending} " +
                    $"{(ended ? "when it was done" : taken > 0 ? "between two fixtures" : "before its first fixture")}");
            }
            return ended;
        }

        Process Start(string pipe, int deviceThreads, bool alone)
        {
            // The program that runs this assembly, or the one that it was built into.
            string program = Environment.ProcessPath, assembly = Assembly.GetEntryAssembly().Location;
            bool isDotnet = Path.GetFileNameWithoutExtension(program).Equals("dotnet", StringComparison.OrdinalIgnoreCase);
            var all = new List<string> { "test", "--worker", pipe };
            if (isDotnet)
                all.Insert(0, assembly);
            if (alone)
                all.Add("--alone");
            var start = new ProcessStartInfo(program, all.Concat(arguments));
            if (!start.Environment.ContainsKey(DeviceThreads))
                start.Environment[DeviceThreads] = deviceThreads.ToString();
            lock (key)
            {
                if (isStopped)
                    return null;
                Process process = Process.Start(start);
                running.Add(process);
                return process;
            }
        }

        static long MemoryOf(Process process)
        {
            process.Refresh();
            return process.HasExited ? 0 : process.WorkingSet64;
        }

        static bool IsConnected(NamedPipeServerStream pipe, Process process)
        {
            using var cancel = new CancellationTokenSource();
            Task connected = pipe.WaitForConnectionAsync(cancel.Token), exited = process.WaitForExitAsync(cancel.Token);
            Task.WhenAny(connected, exited).Wait();
            cancel.Cancel();
            return connected.IsCompletedSuccessfully;
        }

        void Stop()
        {
            lock (key)
            {
                isStopped = true;
                foreach (Process process in running.Where(process => !process.HasExited))
                    process.Kill(entireProcessTree: true);
            }
        }

        static string Title(string fixture) => fixture.Substring(fixture.IndexOf(' ') + 1);

        static string Ending(int exitCode) => exitCode > 128 ? $"was ended by signal {exitCode - 128}{Name(exitCode - 128)}"
            : $"ended with exit code {exitCode}";

        static string Name(int signal) => signal switch { 6 => " (SIGABRT)", 9 => " (SIGKILL)", 11 => " (SIGSEGV)", 15 => " (SIGTERM)", _ => "" };
    }
}
