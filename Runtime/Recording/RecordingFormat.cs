using System;
using System.Buffers.Binary;
using System.IO;
using System.Text;
using Unity.Mathematics;
using static System.FormattableString;

namespace Rill
{
    /// <summary>How a recording lies in a file: header, frames, index; all little endian, each with a checksum of its own.</summary>
    /// <remarks>
    /// Header, 64 bytes: "RillRecd", uint version, uint fields, uint bits of a coordinate, uint capacity, float spacing (m), float3 size of the
    /// box (d), 20 bytes of 0, CRC-32C of all before. Frame: uint "RFrm", uint number, uint particles, uint next id, double time (s), uint
    /// step, uint bytes of the particles, CRC-32C of them, CRC-32C of the 36 bytes before; then the particles, see <see cref="FrameLayout"/>.
    /// Index: uint "RIdx", uint frames, for each ulong position, double time, uint particles, uint step; CRC-32C of all of it. The file ends
    /// with the position of the index (ulong) and "RillDone". A file that was cut short has no index: its frames are found one after the other.
    /// </remarks>
    static class RecordingFormat
    {
        /// <summary>Version that is written, and the newest that is read.</summary>
        public const int Version = 1;

        public const int HeaderBytes = 64, FrameHeaderBytes = 40, IndexHeaderBytes = 8, IndexEntryBytes = 24, ChecksumBytes = 4, FooterBytes = 16;

        const string What = "This file is not a recording that can be read: ";
        const uint FrameMark = 0x6D724652u, IndexMark = 0x78644952u;     // "RFrm", "RIdx"

        static readonly byte[] Magic = Encoding.ASCII.GetBytes("RillRecd"), EndMagic = Encoding.ASCII.GetBytes("RillDone");

        public static void WriteHeader(in RecordingHeader header, Span<byte> to)
        {
            to.Slice(0, HeaderBytes).Clear();
            Magic.CopyTo(to);
            Put(to, 8, Version);
            Put(to, 12, (uint)header.Layout.Fields);
            Put(to, 16, (uint)header.Layout.Bits);
            Put(to, 20, (uint)header.Capacity);
            Put(to, 24, math.asuint(header.Spacing));
            for (int axis = 0; axis < 3; axis++)
                Put(to, 28 + 4 * axis, math.asuint(header.DomainSize[axis]));
            Seal(to, HeaderBytes);
        }

        /// <param name="bytes">The first of the file; fewer than <see cref="HeaderBytes"/> where it is shorter.</param>
        /// <exception cref="InvalidDataException">It is not a recording, damaged, or of a newer version.</exception>
        public static RecordingHeader ReadHeader(ReadOnlySpan<byte> bytes)
        {
            if (bytes.Length < Magic.Length || !bytes.Slice(0, Magic.Length).SequenceEqual(Magic))
                throw new InvalidDataException(What + "it does not begin with 'RillRecd'. Give one that a FluidRecorder made.");
            if (bytes.Length < HeaderBytes)
                throw new InvalidDataException(What + Invariant($"it ends after {bytes.Length:N0} of the {HeaderBytes} bytes of its ") +
                    "header. Record again.");
            uint version = Get(bytes, 8);
            if (version > Version)
                throw new InvalidDataException(What + Invariant($"it has version {version}, but this package reads up to {Version}. ") +
                    "Update the package.");
            if (!IsSealed(bytes, HeaderBytes))
                throw new InvalidDataException(What
                    + "the checksum of its header is another, so it was changed since it was written. Copy the file again.");
            uint fields = Get(bytes, 12), bits = Get(bytes, 16), capacity = Get(bytes, 20);
            float spacing = math.asfloat(Get(bytes, 24));
            var size = new float3(math.asfloat(Get(bytes, 28)), math.asfloat(Get(bytes, 32)), math.asfloat(Get(bytes, 36)));
            if (version == 0)
                throw Damaged("its version is 0");
            if ((fields & ~(uint)RecordingFields.All) != 0)
                throw Damaged(Invariant($"its fields {fields} are unknown"));
            if (bits != FrameLayout.NarrowBits && bits != FrameLayout.WideBits)
                throw Damaged(Invariant($"its coordinates have {bits} bits"));
            if (capacity < 1 || capacity > SolverLayout.MaxCapacity)
                throw Damaged(Invariant($"its capacity is {capacity:N0}, and a fluid has 1 to {SolverLayout.MaxCapacity:N0}"));
            if (!(spacing > 0f) || !math.isfinite(spacing) || !math.all(math.isfinite(size)) || !math.all(size > 0f))
                throw Damaged(Invariant($"its spacing is {spacing} m and its box {size} spacings"));
            return new RecordingHeader(new FrameLayout((RecordingFields)fields, bits == FrameLayout.WideBits), (int)capacity, spacing, size);
        }

        /// <param name="length">Size of the particles, bytes.</param>
        /// <param name="checksum">Checksum of the particles.</param>
        public static void WriteFrameHeader(RecordedFrame frame, int length, uint checksum, Span<byte> to)
        {
            Put(to, 0, FrameMark);
            Put(to, 4, (uint)frame.number);
            Put(to, 8, (uint)frame.particles);
            Put(to, 12, frame.nextId);
            PutDouble(to, 16, frame.time);
            Put(to, 24, (uint)frame.step);
            Put(to, 28, (uint)length);
            Put(to, 32, checksum);
            Seal(to, FrameHeaderBytes);
        }

        /// <summary>All of a frame but its particles.</summary>
        /// <param name="number">That it must have.</param>
        /// <param name="room">Bytes of the file behind the header.</param>
        /// <returns>False if this is not such a frame, or does not end within the file.</returns>
        public static bool TryReadFrameHeader(ReadOnlySpan<byte> bytes, in RecordingHeader header, int number, long room,
            RecordedFrame frame, out int length, out uint checksum)
        {
            length = 0;
            checksum = 0;
            if (bytes.Length < FrameHeaderBytes || Get(bytes, 0) != FrameMark || !IsSealed(bytes, FrameHeaderBytes) || Get(bytes, 4) != (uint)number)
                return false;
            uint particles = Get(bytes, 8), bytesOfParticles = Get(bytes, 28), step = Get(bytes, 24);
            double time = GetDouble(bytes, 16);
            if (particles > (uint)header.Capacity || bytesOfParticles != (ulong)(sizeof(uint) * header.Layout.Words(particles))
                || bytesOfParticles > room || bytesOfParticles > int.MaxValue)
                return false;
            if (step > int.MaxValue || double.IsNaN(time) || double.IsInfinity(time))
                return false;
            length = (int)bytesOfParticles;
            checksum = Get(bytes, 32);
            frame.number = number;
            frame.particles = (int)particles;
            frame.nextId = Get(bytes, 12);
            frame.time = time;
            frame.step = (int)step;
            return true;
        }

        /// <summary>Index and end of a file.</summary>
        /// <param name="position">Where the index begins.</param>
        public static byte[] WriteIndex(ReadOnlySpan<IndexEntry> entries, long position)
        {
            int sealedBytes = IndexHeaderBytes + IndexEntryBytes * entries.Length + ChecksumBytes;
            var bytes = new byte[sealedBytes + FooterBytes];
            Put(bytes, 0, IndexMark);
            Put(bytes, 4, (uint)entries.Length);
            for (int i = 0; i < entries.Length; i++)
            {
                Span<byte> entry = bytes.AsSpan(IndexHeaderBytes + IndexEntryBytes * i);
                BinaryPrimitives.WriteUInt64LittleEndian(entry, (ulong)entries[i].position);
                PutDouble(entry, 8, entries[i].time);
                Put(entry, 16, (uint)entries[i].particles);
                Put(entry, 20, (uint)entries[i].step);
            }
            Seal(bytes, sealedBytes);
            BinaryPrimitives.WriteUInt64LittleEndian(bytes.AsSpan(sealedBytes), (ulong)position);
            EndMagic.CopyTo(bytes, sealedBytes + 8);
            return bytes;
        }

        /// <summary>Reads position and length of the index from the last bytes of a file; false if it has none.</summary>
        /// <param name="footer">The last <see cref="FooterBytes"/>.</param>
        /// <param name="fileBytes">Length of the file.</param>
        public static bool TryFindIndex(ReadOnlySpan<byte> footer, long fileBytes, out long position, out int length)
        {
            ulong begin = BinaryPrimitives.ReadUInt64LittleEndian(footer);
            long end = fileBytes - FooterBytes;
            position = (long)Math.Min(begin, long.MaxValue);
            long bytes = end - position;
            length = (int)Math.Max(Math.Min(bytes, int.MaxValue), 0);
            return footer.Slice(8, EndMagic.Length).SequenceEqual(EndMagic) && begin >= HeaderBytes && begin <= (ulong)end
                && bytes >= IndexHeaderBytes + ChecksumBytes && bytes <= int.MaxValue
                && (bytes - IndexHeaderBytes - ChecksumBytes) % IndexEntryBytes == 0;
        }

        /// <summary>The entries of an index; null where it is damaged, so that the frames have to be looked for.</summary>
        /// <param name="bytes">From the position to the checksum.</param>
        /// <param name="position">Where it begins in the file.</param>
        /// <exception cref="InvalidDataException">Its checksum is right, and what it says is not.</exception>
        public static IndexEntry[] ReadIndex(ReadOnlySpan<byte> bytes, in RecordingHeader header, long position)
        {
            int count = (bytes.Length - IndexHeaderBytes - ChecksumBytes) / IndexEntryBytes;
            if (Get(bytes, 0) != IndexMark || Get(bytes, 4) != (uint)count || !IsSealed(bytes, bytes.Length))
                return null;
            var entries = new IndexEntry[count];
            long next = HeaderBytes;
            for (int i = 0; i < count; i++)
            {
                ReadOnlySpan<byte> entry = bytes.Slice(IndexHeaderBytes + IndexEntryBytes * i, IndexEntryBytes);
                ulong at = BinaryPrimitives.ReadUInt64LittleEndian(entry);
                uint particles = Get(entry, 16), step = Get(entry, 20);
                double time = GetDouble(entry, 8);
                if (at != (ulong)next || particles > (uint)header.Capacity || step > int.MaxValue)
                    throw Damaged(Invariant($"frame {i} of its index lies at byte {at:N0} with {particles:N0} particles"));
                if (double.IsNaN(time) || double.IsInfinity(time) || i > 0 && !(time >= entries[i - 1].time))
                    throw Damaged(Invariant($"frame {i} of its index has the time {time} s"));
                entries[i] = new IndexEntry { position = next, time = time, particles = (int)particles, step = (int)step };
                next += FrameHeaderBytes + sizeof(uint) * header.Layout.Words(particles);
                if (next > position)
                    throw Damaged(Invariant($"frame {i} of its index ends after the frames"));
            }
            if (next != position)
                throw Damaged("its index does not list all of its frames");
            return entries;
        }

        /// <summary>Returns the exception for faults that a correct checksum does not rule out.</summary>
        public static InvalidDataException Damaged(string how)
            => new InvalidDataException(What + how + ". It was not written by a FluidRecorder; use another.");

        static void Seal(Span<byte> bytes, int length) => Put(bytes, length - ChecksumBytes, Crc32C.Of(bytes.Slice(0, length - ChecksumBytes)));

        static bool IsSealed(ReadOnlySpan<byte> bytes, int length)
            => Crc32C.Of(bytes.Slice(0, length - ChecksumBytes)) == Get(bytes, length - ChecksumBytes);

        static void Put(Span<byte> to, int at, uint value) => BinaryPrimitives.WriteUInt32LittleEndian(to.Slice(at), value);

        static void PutDouble(Span<byte> to, int at, double value)
            => BinaryPrimitives.WriteInt64LittleEndian(to.Slice(at), BitConverter.DoubleToInt64Bits(value));

        static uint Get(ReadOnlySpan<byte> from, int at) => BinaryPrimitives.ReadUInt32LittleEndian(from.Slice(at));

        static double GetDouble(ReadOnlySpan<byte> from, int at)
            => BitConverter.Int64BitsToDouble(BinaryPrimitives.ReadInt64LittleEndian(from.Slice(at)));
    }

    /// <summary>Position of a frame in a file, and what can be known without reading it.</summary>
    struct IndexEntry
    {
        /// <summary>Position of its header, from the start of the file.</summary>
        public long position;
        /// <summary>Fluid time, s.</summary>
        public double time;
        public int particles, step;

        /// <summary>Whether a frame is what the index says of it.</summary>
        public bool IsOf(RecordedFrame frame) => frame.particles == particles && frame.time == time && frame.step == step;
    }
}
