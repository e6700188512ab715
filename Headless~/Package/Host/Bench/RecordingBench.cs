using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Runtime.InteropServices;
using Host.Commands;
using Host.Experiments;
using Host.Report;
using Rill;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace Host.Bench
{
    /// <summary><c>bench recording</c>: bytes of a recorded frame, and what packing, handing over, writing and reading it take.</summary>
    static class RecordingBench
    {
        const string Stage = "Rill.Recording";
        const int First = 20, Last = 60;
        const int Buffers = 12;         // as a FluidRecorder has
        const int SumsAlone = 40;

        public static Command Create()
        {
            var particles = new Option<int>("--particles") {
                Description = "Particles of the fluid; the block's lattice comes as near as it can. 1000000 is what a GPU is asked for.",
                DefaultValueFactory = _ => 100_000 };
            var fields = new Option<RecordingFields>("--fields") {
                Description = "What is recorded besides positions: none, velocities, phases, ids or all.", DefaultValueFactory = _
                => RecordingFields.All };
            var frames = new Option<int>("--frames") { Description = $"Frames measured, at least {StepTimes.MinSteps}.",
                DefaultValueFactory = _ => StepTimes.MinSteps };
            var folder = new Option<string>("--folder") {
                Description = "Where the file is written, and removed again; the folder for temporary files where it is not given." };
            Option<string> shaders = ShadersOption.Create();
            var command = new Command("recording", "Measures what recording and reading the frames of a fluid takes.") { particles, fields,
                frames, folder, shaders };
            command.SetAction(parsed =>
            {
                ShadersOption.Use(parsed.GetValue(shaders));
                GivenNumber.CheckOption("--particles", parsed.GetValue(particles), ExperimentScene.MinDamParticles, SolverLayout.MaxCapacity);
                if (parsed.GetValue(frames) < StepTimes.MinSteps)
                    throw new HostException($"--frames {parsed.GetValue(frames)}: a median needs at least {StepTimes.MinSteps}.");
                Execute(parsed.GetValue(particles), parsed.GetValue(fields), parsed.GetValue(frames), parsed.GetValue(folder)
                    ?? Path.GetTempPath(), Console.Out);
                return 0;
            });
            return command;
        }

        static void Execute(int particles, RecordingFields fields, int frames, string folder, TextWriter output)
        {
            using var session = new Session(Session.Root());
            ExperimentScene scene = ExperimentScene.Dam(particles);
            output.WriteLine(session.DescribeDevice());
            output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{scene.Particles:N0} particles of a dam, d = " +
                $"{scene.Spacing:0.#####} m, positions and {fields}, {frames} frames into {folder}"));
            if (session.Info.IsSoftware)
                output.WriteLine("This device is a CPU, whose time of packing says nothing about a GPU: it is left out.");
            StepInput input = ExperimentFigures.Input(SolverSettings.Default);
            using var solver = new PbfSolver(new SolverLayout(scene.Domain, scene.Spacing, scene.Particles, input.settings.neighborCapacity,
                input.settings.listMargin));
            var header = new RecordingHeader(solver.Layout, fields);
            GraphicsBuffer packed = GpuBuffer.Structured<uint>("Rill.RecordedFrame", FrameLayout.PackedHeader + header.Layout.Words(header.Capacity));
            double packing = double.NaN;
            if (session.Info.IsSoftware)
                PackOnce(solver, scene, header, packed);
            else
                packing = StepTimes.Measure(solver, scene.Fill, input, First, Last, StepTimes.MinSteps,
                cmd => solver.RecordFrame(cmd, header.Layout, packed))[Stage].Median;

            string path = Path.Combine(folder, $"rill-bench-{Guid.NewGuid():N}.rillrec");
            try
            {
                Times times = Write(path, header, packed, frames);
                List<double> read = Read(path);
                double bytes = times.bytes / (double)frames;
                output.WriteLine();
                Row(output, "bytes a frame, MB", bytes * 1e-6);
                Row(output, "the same at 60 frames a second, MB/s", 60.0 * bytes * 1e-6);
                if (!double.IsNaN(packing))
                    Row(output, "packing, device, ms", packing);
                Row(output, "copy out of the readback, main thread, ms", Median(times.copies));
                Row(output, "checksum alone, one thread, ms", Median(times.checksums));
                Row(output, "checksum alone, several threads, ms", Median(times.sharedChecksums));
                Row(output, "frame after frame, checksum and writing, ms", times.writing / frames);
                Row(output, "the same, MB/s", times.bytes * 1e-3 / times.writing);
                Row(output, "reading and checksum, threads of their own, ms", Median(read));
            }
            finally
            {
                File.Delete(path);
                packed.Release();
            }
        }

        // Packs the block as it is filled in.
        static void PackOnce(PbfSolver solver, ExperimentScene scene, RecordingHeader header, GraphicsBuffer packed)
        {
            scene.Fill(solver);
            using var commands = new CommandBuffer { name = "Rill.PackOnce" };
            solver.RecordFrame(commands, header.Layout, packed);
            Graphics.ExecuteCommandBuffer(commands);
        }

        struct Times
        {
            public long bytes;
            public List<double> copies, checksums, sharedChecksums;
            public double writing;      // of all frames, ms
        }

        // Writes one frame again and again: the main thread copies it as soon as a buffer is free, and the writer's threads do the rest.
        static Times Write(string path, RecordingHeader header, GraphicsBuffer packed, int frames)
        {
            var times = new Times { copies = new List<double>(), checksums = new List<double>(), sharedChecksums = new List<double>() };
            AsyncGPUReadback.Request(packed, request =>
            {
                NativeArray<uint> words = request.GetData<uint>();
                SumAlone(words.ToArray(), sizeof(uint) * (int)header.Layout.Words((int)words[0]), times);
                var writer = new RecordingWriter(File.Create(path), header, Buffers);
                var all = Stopwatch.StartNew();
                var watch = new Stopwatch();
                for (int i = 0; i < frames; i++)
                {
                    RecordedFrame frame;
                    while ((frame = writer.TryReserve()) == null)
                        System.Threading.Thread.Sleep(0);
                    watch.Restart();
                    frame.particles = (int)words[0];
                    NativeArray<uint>.Copy(words, FrameLayout.PackedHeader, frame.words, 0, (int)header.Layout.Words(frame.particles));
                    times.copies.Add(watch.Elapsed.TotalMilliseconds);
                    (frame.step, frame.time) = (i, i / 60.0);
                    writer.Write(frame);
                }
                writer.Finish();
                writer.Join(System.Threading.Timeout.Infinite);
                times.writing = all.Elapsed.TotalMilliseconds;
                times.bytes = writer.BytesWritten;
            });
            AsyncGPUReadback.WaitAllRequests();
            return times;
        }

        static void SumAlone(uint[] words, int bytes, Times times)
        {
            using var threads = new ChecksumThreads();
            var watch = new Stopwatch();
            for (int i = 0; i < SumsAlone; i++)
            {
                watch.Restart();
                uint one = Crc32C.Of(MemoryMarshal.AsBytes(words.AsSpan()).Slice(0, bytes));
                times.checksums.Add(watch.Elapsed.TotalMilliseconds);
                watch.Restart();
                threads.Begin(words, bytes);
                if (threads.End() != one)
                    throw new HostException("The checksum of several threads is another than that of one.");
                times.sharedChecksums.Add(watch.Elapsed.TotalMilliseconds);
            }
        }

        static List<double> Read(string path)
        {
            using var reader = new RecordingReader(File.OpenRead(path));
            var frame = new RecordedFrame();
            var times = new List<double>();
            for (int i = 0; i < reader.FrameCount; i++)
            {
                var watch = Stopwatch.StartNew();
                reader.Read(i, frame);
                times.Add(watch.Elapsed.TotalMilliseconds);
            }
            return times;
        }

        static double Median(IEnumerable<double> values)
        {
            double[] sorted = values.OrderBy(value => value).ToArray();
            return sorted[sorted.Length / 2];
        }

        static void Row(TextWriter output, string what, double value)
            => output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{what,-48}{value,12:0.000}"));
    }
}
