using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;
using System.Threading.Tasks;

namespace Host.Output
{
    /// <summary>Writes frames as PNG on worker threads, a few at most waiting in memory.</summary>
    sealed class FrameWriter : IDisposable
    {
        readonly string folder;
        readonly List<Task> tasks = new();
        readonly List<(string File, double Time)> frames = new();
        readonly SemaphoreSlim free = new(Math.Max(2, Environment.ProcessorCount) * 2);

        /// <param name="folder">Created; frames of an earlier run in it are removed.</param>
        public FrameWriter(string folder)
        {
            this.folder = folder;
            Directory.CreateDirectory(folder);
            foreach (string old in Directory.GetFiles(folder, "frame_*.png"))
                File.Delete(old);
        }

        public IReadOnlyList<(string File, double Time)> Frames => frames;

        /// <summary>Pattern for ffmpeg's image sequences.</summary>
        public string Pattern => Path.Combine(folder, "frame_%04d.png");

        /// <param name="encode">Makes the PNG's bytes; runs on another thread.</param>
        public void Add(double time, Func<byte[]> encode)
        {
            string file = Path.Combine(folder, $"frame_{frames.Count + 1:0000}.png");
            frames.Add((file, time));
            free.Wait();
            tasks.Add(Task.Run(() =>
            {
                try
                {
                    File.WriteAllBytes(file, encode());
                }
                finally
                {
                    free.Release();
                }
            }));
        }

        /// <summary>Waits for all files; throws what went wrong with any.</summary>
        public void Finish() => Task.WhenAll(tasks).GetAwaiter().GetResult();

        public void Dispose()
        {
            // After an error elsewhere the files may be incomplete, but no thread writes on.
            Task.WhenAll(tasks).ContinueWith(_ => { }).Wait();
            free.Dispose();
        }
    }
}
