using System;
using System.Collections.Generic;
using System.IO;
using System.Runtime.InteropServices;
using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>The bodies of a snapshot as bytes, little endian, one after the other.</summary>
    static class SnapshotBodies
    {
        const int MaxBodies = 65536, MaxPath = 4096, MaxPoints = 64, MaxAnswers = QueryBatch.RingSize, MaxWords = 4096, MaxFrames = 1000;

        public static byte[] Write(List<SnapshotBody> bodies)
        {
            using (var stream = new MemoryStream())
            using (var writer = new BinaryWriter(stream))
            {
                writer.Write(bodies.Count);
                foreach (SnapshotBody body in bodies)
                    Write(writer, body);
                writer.Flush();
                return stream.ToArray();
            }
        }

        /// <exception cref="InvalidDataException">They are not bodies.</exception>
        public static List<SnapshotBody> Read(byte[] bytes)
        {
            using (var stream = new MemoryStream(bytes))
            using (var reader = new BinaryReader(stream))
            {
                try
                {
                    var bodies = new List<SnapshotBody>();
                    int count = Count(reader, MaxBodies);
                    for (int i = 0; i < count; i++)
                        bodies.Add(ReadBody(reader));
                    Require(stream.Position == stream.Length);
                    return bodies;
                }
                catch (Exception problem) when (problem is EndOfStreamException || problem is ArgumentException || problem is FormatException)
                {
                    throw SnapshotFormat.Damaged("a floating body is cut off");
                }
            }
        }

        static void Write(BinaryWriter writer, SnapshotBody body)
        {
            writer.Write(body.path.Length > MaxPath ? body.path.Substring(0, MaxPath) : body.path);
            WriteValue(writer, body.record);
            writer.Write(body.water != null);
            if (body.water == null)
                return;
            writer.Write(body.water.unneeded);
            WriteValues<float3>(writer, body.water.points.ToArray());
            writer.Write(body.water.answers.Count);
            foreach (SnapshotAnswer answer in body.water.answers)
            {
                WriteValue(writer, answer.frame);
                WriteValue(writer, answer.shiftSince);
                writer.Write(answer.frames);
                WriteValues<float4>(writer, answer.points);
                WriteValues<uint>(writer, answer.words);
            }
        }

        static SnapshotBody ReadBody(BinaryReader reader)
        {
            var body = new SnapshotBody { path = reader.ReadString(), record = ReadFloats<BodyRecord>(reader) };
            Require(body.path.Length <= MaxPath && body.record.heldFrames >= 0 && body.record.flags <= BodyRecord.All
                && body.record.awaitedTime >= 0f && body.record.response.levelIsKnown <= 1);
            if (!reader.ReadBoolean())
                return body;
            body.water = new SnapshotWater { unneeded = Finite(reader.ReadSingle()) };
            foreach (float3 point in ReadValues<float3>(reader, MaxPoints))
            {
                Require(math.all(math.isfinite(point)));
                body.water.points.Add(point);
            }
            int answers = Count(reader, MaxAnswers);
            for (int i = 0; i < answers; i++)
                body.water.answers.Add(ReadAnswer(reader));
            return body;
        }

        static SnapshotAnswer ReadAnswer(BinaryReader reader)
        {
            var answer = new SnapshotAnswer
            {
                frame = ReadValue<QueryFrame>(reader),
                shiftSince = ReadFloats<Vector3>(reader),
                frames = Count(reader, MaxFrames),
                points = ReadValues<float4>(reader, MaxPoints),
                words = ReadValues<uint>(reader, MaxWords),
            };
            QueryFrame frame = answer.frame;
            Require(frame.step >= 0 && math.isfinite(frame.time) && frame.spacing > 0f && math.isfinite(frame.spacing)
                && math.all(math.isfinite(((quaternion)frame.rotation).value)) && math.isfinite(frame.density)
                && math.all(math.isfinite((float3)frame.up)) && math.all(math.isfinite((float3)frame.shift))
                && answer.words.Length >= answer.points.Length * Queries.ProbeWords);
            foreach (float4 point in answer.points)
                Require(math.all(math.isfinite(point)));
            return answer;
        }

        static void WriteValue<T>(BinaryWriter writer, T value) where T : struct => writer.Write(StructBytes.Of(ref value).ToArray());

        static void WriteValues<T>(BinaryWriter writer, T[] values) where T : struct
        {
            writer.Write(values.Length);
            writer.Write(MemoryMarshal.AsBytes<T>(values).ToArray());
        }

        static T ReadValue<T>(BinaryReader reader) where T : struct
        {
            byte[] bytes = reader.ReadBytes(SnapshotContents.SizeOf<T>());
            Require(bytes.Length == SnapshotContents.SizeOf<T>());
            return MemoryMarshal.Read<T>(bytes);
        }

        // Whole numbers look like small floats.
        static T ReadFloats<T>(BinaryReader reader) where T : struct
        {
            T value = ReadValue<T>(reader);
            foreach (float number in MemoryMarshal.Cast<byte, float>(StructBytes.Of(ref value)))
                Finite(number);
            return value;
        }

        static T[] ReadValues<T>(BinaryReader reader, int most) where T : struct
        {
            int count = Count(reader, most), bytes = count * SnapshotContents.SizeOf<T>();
            byte[] read = reader.ReadBytes(bytes);
            Require(read.Length == bytes);
            return MemoryMarshal.Cast<byte, T>(read).ToArray();
        }

        static int Count(BinaryReader reader, int most)
        {
            int count = reader.ReadInt32();
            Require(count >= 0 && count <= most);
            return count;
        }

        static float Finite(float value)
        {
            Require(math.isfinite(value));
            return value;
        }

        static void Require(bool holds)
        {
            if (!holds)
                throw SnapshotFormat.Damaged("a floating body cannot be");
        }
    }
}
