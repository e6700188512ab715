using System;
using System.Collections.Generic;
using System.IO;
using System.Runtime.InteropServices;
using static System.FormattableString;

namespace Rill
{
    /// <summary>The frames of a recording, in any order. Safe for files from anywhere: lengths are checked before memory is taken. Used by
    /// one thread at a time.</summary>
    sealed class RecordingReader : IDisposable
    {
        readonly Stream stream;
        readonly ChecksumThreads checksums = new ChecksumThreads();
        readonly byte[] headerBytes = new byte[RecordingFormat.FrameHeaderBytes];
        readonly IndexEntry[] entries;
        readonly long end;      // of the frames

        /// <param name="stream">One that can seek; disposed with this, and where this throws.</param>
        /// <exception cref="InvalidDataException">It is not a recording; the message says why, and what to do.</exception>
        public RecordingReader(Stream stream)
        {
            this.stream = stream;
            try
            {
                var bytes = new byte[(int)Math.Min(stream.Length, RecordingFormat.HeaderBytes)];
                ReadAt(0, bytes);
                Header = RecordingFormat.ReadHeader(bytes);
                end = stream.Length;
                entries = FromIndex(ref end) ?? Scan(ref end);
                foreach (IndexEntry entry in entries)
                    MaxParticles = Math.Max(MaxParticles, entry.particles);
            }
            catch
            {
                stream.Dispose();
                throw;
            }
        }

        public RecordingHeader Header { get; }

        public int FrameCount => entries.Length;

        /// <summary>Number of particles in the largest frame.</summary>
        public int MaxParticles { get; }

        /// <summary>Whether it has no index that can be read, so that there may have been more frames.</summary>
        public bool WasCutShort { get; private set; }

        /// <summary>Fluid time of a frame, s.</summary>
        public double TimeOf(int frame) => entries[frame].time;

        /// <summary>The last frame that is not later than a time; 0 before the first.</summary>
        public int FrameAt(double time)
        {
            int low = 0, high = entries.Length - 1;
            while (low < high)
            {
                int mid = (low + high + 1) / 2;
                if (entries[mid].time <= time)
                    low = mid;
                else
                    high = mid - 1;
            }
            return low;
        }

        /// <summary>Reads a frame and checks it.</summary>
        /// <exception cref="InvalidDataException">It is damaged.</exception>
        /// <exception cref="IOException">The disk does not give it.</exception>
        public void Read(int number, RecordedFrame frame)
        {
            IndexEntry entry = entries[number];
            long at = entry.position;
            ReadAt(at, headerBytes);
            long particlesAt = at + RecordingFormat.FrameHeaderBytes;
            if (!RecordingFormat.TryReadFrameHeader(headerBytes, Header, number, end - particlesAt, frame, out int length,
                out uint checksum) || !entry.IsOf(frame))
                throw DamagedFrame(number);
            frame.Reserve(length / sizeof(uint));
            Span<byte> bytes = MemoryMarshal.AsBytes(frame.words.AsSpan()).Slice(0, length);
            ReadAt(particlesAt, bytes);
            checksums.Begin(frame.words, length);
            if (checksums.End() != checksum)
                throw DamagedFrame(number);
        }

        public void Dispose()
        {
            checksums.Dispose();
            stream.Dispose();
        }

        static InvalidDataException DamagedFrame(int number) => new InvalidDataException(Invariant($"Frame {number:N0} of the recording ") +
            "was changed since it was written: its checksum is another. Copy the file again, or record again.");

        // Null where there is none, or its checksum is another.
        IndexEntry[] FromIndex(ref long framesEnd)
        {
            if (stream.Length < RecordingFormat.HeaderBytes + RecordingFormat.FooterBytes)
                return null;
            Span<byte> footer = stackalloc byte[RecordingFormat.FooterBytes];
            ReadAt(stream.Length - RecordingFormat.FooterBytes, footer);
            if (!RecordingFormat.TryFindIndex(footer, stream.Length, out long position, out int length))
                return null;
            var bytes = new byte[length];
            ReadAt(position, bytes);
            IndexEntry[] found = RecordingFormat.ReadIndex(bytes, Header, position);
            if (found != null)
                framesEnd = position;
            return found;
        }

        // The frames one after the other, up to the first that is not whole. Their particles are checked as they are read.
        IndexEntry[] Scan(ref long framesEnd)
        {
            WasCutShort = true;
            var found = new List<IndexEntry>();
            var frame = new RecordedFrame();
            long at = RecordingFormat.HeaderBytes;
            double last = double.NegativeInfinity;
            while (at + RecordingFormat.FrameHeaderBytes <= stream.Length)
            {
                long particlesAt = at + RecordingFormat.FrameHeaderBytes;
                ReadAt(at, headerBytes);
                if (!RecordingFormat.TryReadFrameHeader(headerBytes, Header, found.Count, stream.Length - particlesAt, frame,
                    out int length, out _) || frame.time < last)
                    break;
                found.Add(new IndexEntry { position = at, time = frame.time, particles = frame.particles, step = frame.step });
                last = frame.time;
                at = particlesAt + length;
            }
            framesEnd = at;
            return found.ToArray();
        }

        void ReadAt(long position, Span<byte> to)
        {
            if (stream.Position != position)
                stream.Seek(position, SeekOrigin.Begin);
            while (to.Length > 0)
            {
                int read = stream.Read(to);
                if (read <= 0)
                    throw new EndOfStreamException("The recording became shorter while it was read. Open it again.");
                to = to.Slice(read);
            }
        }
    }
}
