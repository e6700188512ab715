using System;
using System.Buffers.Binary;
using System.Collections.Generic;
using System.IO;
using System.Text;
using static System.FormattableString;

namespace Rill
{
    /// <summary>How the sections of a snapshot lie in bytes: header, table, sections, checksum; all little endian.</summary>
    /// <remarks>
    /// Header: 8 bytes "RillSnap", uint version, uint number of sections, ulong length of all. Table: for each section uint number,
    /// uint 0, ulong position, ulong length. The sections follow in that order without gaps, and the CRC-32C of all before ends it.
    /// </remarks>
    static class SnapshotFormat
    {
        const int HeaderBytes = 24, EntryBytes = 24, ChecksumBytes = 4, VersionOneCounters = 16, VersionThreeEmitterWords = 8;
        const string What = "These bytes are not a snapshot that can be read: ";

        static readonly byte[] Magic = Encoding.ASCII.GetBytes("RillSnap");

        /// <exception cref="InvalidOperationException">They are more than an array holds.</exception>
        public static byte[] Write(SnapshotContents contents)
        {
            long total = HeaderBytes + (long)EntryBytes * contents.Count + ChecksumBytes;
            foreach (KeyValuePair<SnapshotSection, byte[]> section in contents.Sections)
                total += section.Value.Length;
            if (total > int.MaxValue)
                throw new InvalidOperationException(
                    Invariant($"The snapshot takes {total:N0} bytes, more than the {int.MaxValue:N0} that an array holds. Take it of ") +
                    "fewer particles.");

            var bytes = new byte[total];
            Magic.CopyTo(bytes, 0);
            BinaryPrimitives.WriteUInt32LittleEndian(bytes.AsSpan(8), FluidSnapshot.CurrentVersion);
            BinaryPrimitives.WriteUInt32LittleEndian(bytes.AsSpan(12), (uint)contents.Count);
            BinaryPrimitives.WriteUInt64LittleEndian(bytes.AsSpan(16), (ulong)total);
            int entry = HeaderBytes, position = HeaderBytes + EntryBytes * contents.Count;
            foreach (KeyValuePair<SnapshotSection, byte[]> section in contents.Sections)
            {
                BinaryPrimitives.WriteUInt32LittleEndian(bytes.AsSpan(entry), (uint)section.Key);
                BinaryPrimitives.WriteUInt64LittleEndian(bytes.AsSpan(entry + 8), (ulong)position);
                BinaryPrimitives.WriteUInt64LittleEndian(bytes.AsSpan(entry + 16), (ulong)section.Value.Length);
                section.Value.CopyTo(bytes, position);
                entry += EntryBytes;
                position += section.Value.Length;
            }
            BinaryPrimitives.WriteUInt32LittleEndian(bytes.AsSpan(position), Crc32C.Of(bytes.AsSpan(0, position)));
            return bytes;
        }

        /// <exception cref="InvalidDataException">They are not a snapshot, damaged, or of a newer version.</exception>
        public static SnapshotContents Read(ReadOnlySpan<byte> bytes)
        {
            if (bytes.Length < Magic.Length || !bytes.Slice(0, Magic.Length).SequenceEqual(Magic))
                throw new InvalidDataException(What + "they do not begin with 'RillSnap'. Give those that FluidSnapshot.ToBytes made.");
            if (bytes.Length < HeaderBytes + ChecksumBytes)
                throw Truncated(bytes.Length, HeaderBytes + ChecksumBytes);
            uint version = BinaryPrimitives.ReadUInt32LittleEndian(bytes.Slice(8));
            if (version > FluidSnapshot.CurrentVersion)
                throw new InvalidDataException(What
                    + Invariant($"they have version {version}, but this package reads up to {FluidSnapshot.CurrentVersion}. Update the ") +
                    "package.");
            ulong total = BinaryPrimitives.ReadUInt64LittleEndian(bytes.Slice(16));
            if (total > (ulong)bytes.Length)
                throw Truncated(bytes.Length, total);
            if (total < (ulong)bytes.Length)
                throw new InvalidDataException(What
                    + Invariant($"there are {bytes.Length:N0} of them, but they say {total:N0}. Give no more than FluidSnapshot.ToBytes ") +
                    "made.");
            int end = bytes.Length - ChecksumBytes;
            if (Crc32C.Of(bytes.Slice(0, end)) != BinaryPrimitives.ReadUInt32LittleEndian(bytes.Slice(end)))
                throw new InvalidDataException(What
                    + "their checksum is another, so they were changed since they were written. Read the file again, or use an older one.");
            if (version == 0)
                throw Damaged("their version is 0");
            SnapshotContents contents = ReadSections(bytes.Slice(0, end));
            if (version == 1)
                AddHandOver(contents);
            if (version <= 3)
                AddPressing(contents);
            return contents;
        }

        /// <summary>Sections that a right checksum does not make right.</summary>
        public static InvalidDataException Damaged(string how)
            => new InvalidDataException(What + how + ". They were not written by FluidSnapshot.ToBytes; use others.");

        // Version 1 knew of no particles that are handed over.
        static void AddHandOver(SnapshotContents contents)
        {
            if (!contents.Has(SnapshotSection.Counters) || contents.Values<uint>(SnapshotSection.Counters).Length != VersionOneCounters)
                return;
            uint[] counters = contents.Values<uint>(SnapshotSection.Counters).ToArray();
            Array.Resize(ref counters, ParticleBuffers.CounterCount);
            contents.SetValues<uint>(SnapshotSection.Counters, counters);
        }

        // Version 3 knew of no emitters that press water away: the words of each were fewer.
        static void AddPressing(SnapshotContents contents)
        {
            const int emitters = StepSources.MaxEmitters;
            if (!contents.Has(SnapshotSection.EmitterStates)
                || contents.Values<uint>(SnapshotSection.EmitterStates).Length != emitters * VersionThreeEmitterWords)
                return;
            ReadOnlySpan<uint> fewer = contents.Values<uint>(SnapshotSection.EmitterStates);
            var states = new uint[emitters * EmitterStates.Words];
            for (int emitter = 0; emitter < emitters; emitter++)
                fewer.Slice(emitter * VersionThreeEmitterWords, VersionThreeEmitterWords).CopyTo(states.AsSpan(emitter * EmitterStates.Words));
            contents.SetValues<uint>(SnapshotSection.EmitterStates, states);
        }

        static SnapshotContents ReadSections(ReadOnlySpan<byte> bytes)
        {
            uint count = BinaryPrimitives.ReadUInt32LittleEndian(bytes.Slice(12));
            ulong position = HeaderBytes + (ulong)EntryBytes * count;
            if (position > (ulong)bytes.Length)
                throw Damaged(Invariant($"a table of {count:N0} sections does not fit into {bytes.Length:N0} bytes"));
            var contents = new SnapshotContents();
            for (int i = 0; i < (int)count; i++)
            {
                ReadOnlySpan<byte> entry = bytes.Slice(HeaderBytes + EntryBytes * i, EntryBytes);
                var section = (SnapshotSection)BinaryPrimitives.ReadUInt32LittleEndian(entry);
                ulong length = BinaryPrimitives.ReadUInt64LittleEndian(entry.Slice(16));
                if (!Enum.IsDefined(typeof(SnapshotSection), section) || contents.Has(section))
                    throw Damaged(Invariant($"section {(uint)section} is unknown or there twice"));
                if (BinaryPrimitives.ReadUInt64LittleEndian(entry.Slice(8)) != position || length > (ulong)bytes.Length - position)
                    throw Damaged(Invariant($"section {section} lies outside of them"));
                contents.Set(section, bytes.Slice((int)position, (int)length).ToArray());
                position += length;
            }
            if (position != (ulong)bytes.Length)
                throw Damaged("they hold more than their sections");
            return contents;
        }

        static InvalidDataException Truncated(int there, ulong wanted)
            => new InvalidDataException(What + Invariant($"there are {there:N0} of {wanted:N0}. Read all of the file."));
    }
}
