using System;
using System.Buffers.Binary;
using System.IO;
using System.Text;
using Unity.Mathematics;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Writes particles into files that other programs read: position, velocity, density, phase and id of each.</summary>
    /// <remarks>Coordinates stay Unity's own: left-handed, y up.</remarks>
    public static class ParticleFile
    {
        const int Chunk = 1 << 16;      // bytes written at a time

        /// <summary>".ply" or ".vtk".</summary>
        public static string Extension(ParticleFileFormat format) => format == ParticleFileFormat.Ply ? ".ply" : ".vtk";

        /// <summary>Writes one file. The stream stays open.</summary>
        /// <exception cref="ArgumentNullException">The stream or the frame is missing.</exception>
        /// <exception cref="IOException">The stream could not be written.</exception>
        public static void Write(Stream stream, ParticleFrame frame, ParticleFileFormat format)
        {
            if (stream == null)
                throw new ArgumentNullException(nameof(stream));
            if (frame == null)
                throw new ArgumentNullException(nameof(frame));
            var writer = new Writer(stream, format == ParticleFileFormat.Vtk);
            if (format == ParticleFileFormat.Ply)
                WritePly(writer, frame);
            else
                WriteVtk(writer, frame);
            writer.Flush();
        }

        static void WritePly(Writer writer, ParticleFrame frame)
        {
            writer.Text("ply\nformat binary_little_endian 1.0\n");
            writer.Text(Invariant($"comment Rill, fluid time {frame.Time} s; positions in m, velocities in m/s, densities in kg/m3\n"));
            writer.Text(Invariant($"element vertex {frame.Count}\n"));
            writer.Text("property float x\nproperty float y\nproperty float z\nproperty float vx\nproperty float vy\nproperty float " +
                "vz\nproperty float density\nproperty uchar phase\nproperty uint id\nend_header\n");
            for (int i = 0; i < frame.Count; i++)
            {
                writer.Add(frame.Positions[i]);
                writer.Add(frame.Velocities[i]);
                writer.Add(frame.Densities[i]);
                writer.Add(frame.Phases[i]);
                writer.Add(frame.Ids[i]);
            }
        }

        static void WriteVtk(Writer writer, ParticleFrame frame)
        {
            string count = Invariant($"{frame.Count}");
            writer.Text(Invariant($"# vtk DataFile Version 3.0\nRill, fluid time {frame.Time} s; m, m/s, kg/m3\nBINARY\nDATASET POLYDATA\n"));
            writer.Text("FIELD FieldData 1\nTIME 1 1 double\n");
            writer.Add(frame.Time);
            writer.Text($"\nPOINTS {count} float\n");
            foreach (float3 position in frame.Positions)
                writer.Add(position);
            // A cell for each point: without, viewers show nothing.
            writer.Text(Invariant($"\nVERTICES {count} {2L * frame.Count}\n"));
            for (int i = 0; i < frame.Count; i++)
            {
                writer.Add(1u);
                writer.Add((uint)i);
            }
            writer.Text($"\nPOINT_DATA {count}\nVECTORS velocity float\n");
            foreach (float3 velocity in frame.Velocities)
                writer.Add(velocity);
            writer.Text("\nSCALARS density float 1\nLOOKUP_TABLE default\n");
            foreach (float density in frame.Densities)
                writer.Add(density);
            writer.Text("\nSCALARS phase unsigned_char 1\nLOOKUP_TABLE default\n");
            foreach (byte phase in frame.Phases)
                writer.Add(phase);
            writer.Text("\nSCALARS id unsigned_int 1\nLOOKUP_TABLE default\n");
            foreach (uint id in frame.Ids)
                writer.Add(id);
            writer.Text("\n");
        }

        /// <summary>Numbers of either byte order, a chunk at a time.</summary>
        sealed class Writer
        {
            readonly Stream stream;
            readonly bool bigEndian;
            readonly byte[] chunk = new byte[Chunk];
            int used;

            public Writer(Stream stream, bool bigEndian)
            {
                this.stream = stream;
                this.bigEndian = bigEndian;
            }

            public void Text(string text)
            {
                Flush();
                byte[] bytes = Encoding.ASCII.GetBytes(text);
                stream.Write(bytes, 0, bytes.Length);
            }

            public void Add(float3 value)
            {
                Add(value.x);
                Add(value.y);
                Add(value.z);
            }

            public void Add(float value) => Add(math.asuint(value));

            public void Add(uint value)
            {
                Span<byte> to = Take(sizeof(uint));
                if (bigEndian)
                    BinaryPrimitives.WriteUInt32BigEndian(to, value);
                else
                    BinaryPrimitives.WriteUInt32LittleEndian(to, value);
            }

            public void Add(double value)
            {
                Span<byte> to = Take(sizeof(ulong));
                if (bigEndian)
                    BinaryPrimitives.WriteUInt64BigEndian(to, (ulong)BitConverter.DoubleToInt64Bits(value));
                else
                    BinaryPrimitives.WriteUInt64LittleEndian(to, (ulong)BitConverter.DoubleToInt64Bits(value));
            }

            public void Add(byte value) => Take(1)[0] = value;

            public void Flush()
            {
                stream.Write(chunk, 0, used);
                used = 0;
            }

            Span<byte> Take(int bytes)
            {
                if (used + bytes > chunk.Length)
                    Flush();
                used += bytes;
                return chunk.AsSpan(used - bytes, bytes);
            }
        }
    }
}
