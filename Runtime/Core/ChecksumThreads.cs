using System;
using System.Runtime.InteropServices;
using System.Threading;
using static System.FormattableString;

namespace Rill
{
    /// <summary>The checksum of long data by several threads: each sums parts of it, and the sums of the parts are joined to that of
    /// the whole. Between <see cref="Begin"/> and <see cref="End"/> the caller can do something else. Used by one thread at a
    /// time.</summary>
    /// <remarks>Allocates only for data that are longer than all before. The threads begin with the first data of several parts.</remarks>
    sealed class ChecksumThreads : IDisposable
    {
        /// <summary>Length of a part but the last, bytes: its sum takes long beside handing it over, and a frame of 100,000 particles has
        /// several.</summary>
        public const int PartBytes = 1 << 18;

        const int MaxHelpers = 3;       // four sum a frame faster than a disk takes it

        static readonly uint PartShift = Crc32C.Shift(PartBytes);

        readonly object gate = new object();
        readonly Thread[] helpers;
        uint[] words = Array.Empty<uint>(), sums = Array.Empty<uint>();
        int length, parts, taken, summed;
        bool isDisposed;

        /// <param name="helpers">Threads beside the caller's; without it as many as the machine has cores to spare, at most 3.</param>
        public ChecksumThreads(int? helpers = null)
            => this.helpers = new Thread[helpers ?? Math.Min(MaxHelpers, Environment.ProcessorCount - 1)];

        /// <summary>Begins to sum; the data must not change until <see cref="End"/> has returned.</summary>
        /// <param name="data">What is summed.</param>
        /// <param name="bytes">Number of bytes, from the first on.</param>
        /// <exception cref="ArgumentOutOfRangeException">There are not so many bytes.</exception>
        /// <exception cref="InvalidOperationException">What was begun before has not ended.</exception>
        public void Begin(uint[] data, int bytes)
        {
            if (bytes < 0 || bytes > (long)sizeof(uint) * data.Length)
                throw Limit.OutOfRange(nameof(bytes), bytes,
                    Invariant($"There are {(long)sizeof(uint) * data.Length:N0} bytes to sum."));
            lock (gate)
            {
                if (summed < parts)
                    throw new InvalidOperationException("A checksum is being made already: call End first.");
                (words, length) = (data, bytes);
                (parts, taken, summed) = ((int)(((long)bytes + PartBytes - 1) / PartBytes), 0, 0);
                if (sums.Length < parts)
                    sums = new uint[parts];
                Monitor.PulseAll(gate);
            }
            if (parts > 1 && helpers.Length > 0 && helpers[0] == null)
                Start();
        }

        /// <summary>Sums what no thread has taken yet, and waits for the others.</summary>
        /// <returns>The CRC-32C of what was given to <see cref="Begin"/>.</returns>
        public uint End()
        {
            while (TryTake(false, out int part))
                Sum(part);
            lock (gate)
                while (summed < parts)
                    Monitor.Wait(gate);
            uint whole = 0u;
            for (int part = 0; part < parts; part++)
                whole = Crc32C.Combine(whole, sums[part], LengthOf(part) == PartBytes ? PartShift : Crc32C.Shift(LengthOf(part)));
            return whole;
        }

        /// <summary>Ends the threads.</summary>
        public void Dispose()
        {
            lock (gate)
            {
                isDisposed = true;
                Monitor.PulseAll(gate);
            }
        }

        void Start()
        {
            for (int i = 0; i < helpers.Length; i++)
            {
                helpers[i] = new Thread(Help) { Name = "Rill.Checksum", IsBackground = true };
                helpers[i].Start();
            }
        }

        void Help()
        {
            while (TryTake(true, out int part))
                Sum(part);
        }

        // A helper waits for one; false once this is disposed.
        bool TryTake(bool waits, out int part)
        {
            lock (gate)
            {
                while (waits && !isDisposed && taken == parts)
                    Monitor.Wait(gate);
                part = taken;
                if (isDisposed || taken == parts)
                    return false;
                taken++;
                return true;
            }
        }

        void Sum(int part)
        {
            int bytes = LengthOf(part);
            Span<uint> its = words.AsSpan(part * (PartBytes / sizeof(uint)), (bytes + sizeof(uint) - 1) / sizeof(uint));
            uint sum = Crc32C.Of(MemoryMarshal.AsBytes(its).Slice(0, bytes));
            lock (gate)
            {
                sums[part] = sum;
                if (++summed == parts)
                    Monitor.PulseAll(gate);
            }
        }

        int LengthOf(int part) => Math.Min(PartBytes, length - part * PartBytes);
    }
}
