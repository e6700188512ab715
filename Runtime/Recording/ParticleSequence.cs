using System;
using System.IO;
using Unity.Mathematics;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>
    /// Writes the particles of a fluid into a sequence of files, one for each <see cref="Capture"/>. They come back from the GPU two or
    /// three frames later and are written then; nothing waits for them.
    /// </summary>
    /// <remarks>Files are named prefix_000000, prefix_000001 and so on, in the order of the calls.</remarks>
    public sealed class ParticleSequence : IDisposable
    {
        readonly FluidSimulation simulation;
        readonly string folder, prefix;
        readonly ParticleFileFormat format;
        bool disposed;

        /// <param name="simulation">Whose particles.</param>
        /// <param name="folder">Made where it is missing.</param>
        /// <param name="prefix">Prefix of the files' names.</param>
        /// <param name="format">Format of the files.</param>
        /// <exception cref="ArgumentNullException">An argument is missing.</exception>
        /// <exception cref="IOException">The folder cannot be made.</exception>
        public ParticleSequence(FluidSimulation simulation, string folder, string prefix, ParticleFileFormat format)
        {
            this.simulation = simulation != null ? simulation : throw new ArgumentNullException(nameof(simulation));
            this.folder = folder ?? throw new ArgumentNullException(nameof(folder));
            this.prefix = prefix ?? throw new ArgumentNullException(nameof(prefix));
            this.format = format;
            Directory.CreateDirectory(folder);
            simulation.Results.Surface.Requesting += RequestDensity;
        }

        /// <summary>Calls of <see cref="Capture"/>.</summary>
        public int Captured { get; private set; }

        /// <summary>Files that are written.</summary>
        public int Written { get; private set; }

        /// <summary>Why the newest file that failed is not there; null where none failed.</summary>
        public string Problem { get; private set; }

        /// <summary>Asks for the particles as they are now: their file is written when they have come.</summary>
        /// <exception cref="InvalidOperationException">The simulation is not running.</exception>
        /// <exception cref="ObjectDisposedException">After <see cref="Dispose"/>.</exception>
        public void Capture()
        {
            if (disposed)
                throw new ObjectDisposedException(nameof(ParticleSequence));
            string file = Path.Combine(folder, Invariant($"{prefix}_{Captured:000000}{ParticleFile.Extension(format)}"));
            ParticleExport.Request(simulation, (frame, problem) => OnFrame(file, frame, problem));
            Captured++;
        }

        /// <summary>Asks for no more densities. Pending files are still written.</summary>
        public void Dispose()
        {
            if (disposed)
                return;
            disposed = true;
            simulation.Results.Surface.Requesting -= RequestDensity;
        }

        // Requests densities in the coming steps.
        void RequestDensity() => simulation.Steps.NeedsDensity = true;

        void OnFrame(string file, ParticleFrame frame, string problem)
        {
            try
            {
                if (frame != null)
                    using (FileStream stream = File.Create(file))
                        ParticleFile.Write(stream, frame, format);
                Written += frame != null ? 1 : 0;
            }
            catch (Exception failure) when (failure is IOException || failure is UnauthorizedAccessException)
            {
                problem = failure.Message;
            }
            if (problem == null)
                return;
            if (Problem == null)
                Debug.LogError($"Rill: '{file}' was not written: {problem} The sequence goes on.", simulation);
            Problem = $"'{file}' was not written: {problem}";
        }
    }
}
