using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using System.Threading;
using NUnit.Framework;
using Unity.Mathematics;

namespace Rill.Tests
{
    /// <summary>Recordings as bytes: what is whole comes back in any order, and what is not a recording is refused in words.</summary>
    public class RecordingFormatTests
    {
        static readonly RecordingHeader Header = new RecordingHeader(new FrameLayout(RecordingFields.All, false), 500, 0.05f,
            new float3(20f, 30f, 16f));
        static readonly int[] Counts = { 0, 1, 2, 3, 100, 499, 500 };

        byte[] bytes;

        [OneTimeSetUp]
        public void WriteOne() => bytes = Write(Header, Counts);

        [Test]
        public void Frames_come_back_as_they_were_in_any_order()
        {
            using (RecordingReader reader = Open(bytes))
            {
                Assert.That((reader.FrameCount, reader.MaxParticles, reader.WasCutShort), Is.EqualTo((Counts.Length, 500, false)));
                Assert.That((reader.Header.Spacing, reader.Header.DomainSize, reader.Header.Capacity, reader.Header.Layout.Fields,
                    reader.Header.Layout.Bits), Is.EqualTo((0.05f, new float3(20f, 30f, 16f), 500, RecordingFields.All, 16)));
                var frame = new RecordedFrame();
                foreach (int number in new[] { 6, 0, 3, 5, 5, 1, 4, 2 })
                {
                    reader.Read(number, frame);
                    Assert.That((frame.number, frame.particles, frame.step, frame.time, frame.nextId),
                        Is.EqualTo((number, Counts[number], 2 * number + 1, number / 30.0, 7u)));
                    Assert.That(frame.words.Take(Words(number)), Is.EqualTo(Particles(number)));
                }
            }
        }

        [Test]
        public void The_largest_frame_is_found_wherever_it_is([Values] bool isCutShort)
        {
            byte[] file = Write(Header, new[] { 5, 100, 3 });
            using (RecordingReader reader = Open(file.Take(isCutShort ? file.Length - 1 : file.Length).ToArray()))
                Assert.That((reader.FrameCount, reader.MaxParticles), Is.EqualTo((3, 100)));
        }

        [Test]
        public void A_file_that_is_refused_is_closed_and_one_that_is_read_with_its_reader()
        {
            var refused = new MemoryStream(bytes.Take(40).ToArray());
            Assert.Throws<InvalidDataException>(() => new RecordingReader(refused));
            Assert.That(refused.CanRead, Is.False);
            var taken = new MemoryStream(bytes);
            using (new RecordingReader(taken))
                Assert.That(taken.CanRead);
            Assert.That(taken.CanRead, Is.False);
        }

        [Test]
        public void The_frame_at_a_time_is_the_last_that_is_not_later()
        {
            using (RecordingReader reader = Open(bytes))
                foreach ((double time, int frame) in new[] { (-1.0, 0), (0.0, 0), (0.9 / 30.0, 0), (1.0 / 30.0, 1), (3.5 / 30.0, 3),
                    (6.0 / 30.0, 6), (99.0, 6) })
                    Assert.That(reader.FrameAt(time), Is.EqualTo(frame), $"{time} s");
        }

        [Test]
        public void A_file_that_is_cut_short_keeps_every_whole_frame()
        {
            long[] ends = Ends();
            for (int length = RecordingFormat.HeaderBytes; length < bytes.Length; length += length < 600 || length > bytes.Length - 300 ? 1 : 61)
                using (RecordingReader reader = Open(bytes.Take(length).ToArray()))
                {
                    Assert.That(reader.WasCutShort, $"{length} bytes");
                    Assert.That(reader.FrameCount, Is.EqualTo(ends.Count(end => end <= length)), $"{length} bytes");
                    var frame = new RecordedFrame();
                    for (int i = 0; i < reader.FrameCount; i++)
                        reader.Read(i, frame);
                }
            for (int length = 0; length < RecordingFormat.HeaderBytes; length++)
                Assert.That(Refusal(bytes.Take(length).ToArray()), Is.Not.Null, $"{length} bytes");
        }

        [Test]
        public void Every_change_of_a_byte_is_found_or_takes_no_more_than_the_index()
        {
            var changed = (byte[])bytes.Clone();
            var random = new System.Random(1);
            int index = (int)Ends().Last();
            for (int i = 0; i < bytes.Length; i += i < 800 || i > index - 60 ? 1 : 97)
            {
                changed[i] ^= (byte)(1 << random.Next(8));
                if (i >= index)
                    AssertScanned(changed, i);
                else
                    Assert.That(Refusal(changed), Is.Not.Null, $"byte {i}");
                changed[i] = bytes[i];
            }
            Assert.That(Refusal(changed), Is.Null);
        }

        [Test]
        public void Bytes_at_random_are_refused_and_take_no_memory()
        {
            var random = new System.Random(2);
            for (int i = 0; i < 500; i++)
            {
                var noise = new byte[random.Next(3000)];
                random.NextBytes(noise);
                if (i % 2 == 0)
                    Array.Copy(bytes, noise, Math.Min(noise.Length, RecordingFormat.HeaderBytes));       // with the right beginning
                if (i % 4 == 0 && noise.Length > 200)
                    Encoding.ASCII.GetBytes("RillDone").CopyTo(noise, noise.Length - 8);       // and the right end
                long before = GC.GetAllocatedBytesForCurrentThread();
                string refusal = i % 2 == 0 && noise.Length >= RecordingFormat.HeaderBytes ? Count(noise) == 0 ? "no frame" : null : Refusal(noise);
                Assert.That(refusal, Is.Not.Null, $"{i}");
                Assert.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.LessThan(100_000), $"{i}");
            }
        }

        static IEnumerable<TestCaseData> Refusals()
        {
            yield return new TestCaseData(new Func<byte[], byte[]>(b => Encoding.ASCII.GetBytes("PNG and so on")),
                "does not begin with 'RillRecd'").SetName("no recording");
            yield return new TestCaseData(new Func<byte[], byte[]>(b => b.Take(40).ToArray()), "ends after 40 of the 64 bytes").SetName("header cut");
            yield return new TestCaseData(new Func<byte[], byte[]>(b => With(b, 8, 2)),
                "has version 2, but this package reads up to 1. Update").SetName("newer version");
            yield return new TestCaseData(new Func<byte[], byte[]>(b => With(b, 8, 0)), "its version is 0").SetName("version 0");
            yield return new TestCaseData(new Func<byte[], byte[]>(b => With(b, 12, 255)), "its fields 255 are unknown").SetName("unknown fields");
            yield return new TestCaseData(new Func<byte[], byte[]>(b => With(b, 16, 17)), "coordinates have 17 bits").SetName("other bits");
            yield return new TestCaseData(new Func<byte[], byte[]>(b => With(b, 23, 255)), "its capacity is").SetName("huge capacity");
            yield return new TestCaseData(new Func<byte[], byte[]>(b => With(b, 20, 0u)),
                "its capacity is 0, and a fluid has 1 to 16,777,216").SetName("no capacity");
            yield return new TestCaseData(new Func<byte[], byte[]>(b => With(b, 20, 16777217u)),
                "its capacity is 16,777,217").SetName("capacity above the most");
            yield return new TestCaseData(new Func<byte[], byte[]>(b => With(b, 27, 255)), "its spacing is").SetName("negative spacing");
            foreach (float value in new[] { 0f, float.NaN, float.PositiveInfinity })
                for (int field = 0; field < 4; field++)
                {
                    int at = 24 + 4 * field;
                    yield return new TestCaseData(new Func<byte[], byte[]>(b => With(b, at, math.asuint(value))),
                        "its spacing is").SetName($"{new[] { "spacing", "width", "height", "length" }[field]} of {value}");
                }
            yield return new TestCaseData(new Func<byte[], byte[]>(b => With(b, 32, math.asuint(-30f))), "its spacing is").SetName("negative height");
            yield return new TestCaseData(new Func<byte[], byte[]>(b => { b = (byte[])b.Clone(); b[30] ^= 1; return b; }),
                "checksum of its header is another").SetName("changed header");
            yield return new TestCaseData(new Func<byte[],
                byte[]>(b => { b = (byte[])b.Clone(); b[RecordingFormat.HeaderBytes + 500] ^= 1; return b; }),
                "was changed since it was written").SetName("changed frame");
        }

        [TestCaseSource(nameof(Refusals))]
        public void A_refusal_says_what_is_wrong(Func<byte[], byte[]> change, string expected)
            => Assert.That(Refusal(change(bytes)), Does.Contain(expected));

        // A checksum does not keep out who can compute one.
        [Test]
        public void An_index_with_a_right_checksum_that_is_wrong_is_refused()
        {
            var entries = new List<IndexEntry>();
            using (RecordingReader reader = Open(bytes))
                for (int i = 0; i < Counts.Length; i++)
                    entries.Add(new IndexEntry
                    {
                        position = i == 0 ? RecordingFormat.HeaderBytes : Ends()[i - 1], time = i / 30.0,
                        particles = Counts[i], step = 2 * i + 1
                    });
            Assert.That(RefusalWith(entries, e => { }), Is.Null);
            Assert.That(RefusalWith(entries, e => Set(e, 2, v => { v.position += 1; return v; })), Does.Contain("frame 2 of its index lies at byte"));
            Assert.That(RefusalWith(entries, e => Set(e, 2, v => { v.particles = 501; return v; })), Does.Contain("with 501 particles"));
            Assert.That(RefusalWith(entries, e => Set(e, 3, v => { v.time = double.NaN; return v; })), Does.Contain("has the time"));
            Assert.That(RefusalWith(entries, e => Set(e, 3, v => { v.time = 0.0; return v; })), Does.Contain("has the time"));
            Assert.That(RefusalWith(entries, e => Set(e, 0, v => { v.time = double.NaN; return v; })),
                Does.Contain("frame 0 of its index has the time"));
            Assert.That(RefusalWith(entries, e => Set(e, 6, v => { v.time = double.PositiveInfinity; return v; })), Does.Contain("has the time"));
            Assert.That(RefusalWith(entries, e => Set(e, 3, v => { v.step = -1; return v; })), Does.Contain("frame 3 of its index lies at byte"));
            Assert.That(RefusalWith(entries, e => Set(e, 5, v => { v.particles = 500; return v; })),
                Does.Contain("frame 6 of its index lies at byte"));
            Assert.That(RefusalWith(entries, e => e.Add(new IndexEntry { position = Ends().Last(), time = 1.0 })),
                Does.Contain("frame 7 of its index ends after the frames"));
            Assert.That(RefusalWith(entries, e => e.RemoveAt(6)), Does.Contain("does not list all"));
            Assert.That(RefusalWith(entries, e => Set(e, 6, v => { v.particles = 490; return v; })), Does.Contain("does not list all"));
        }

        static IEnumerable<TestCaseData> FramesThatAreWrong()
        {
            yield return Wrong("mark", 0, BitConverter.GetBytes(0x78644952u));
            yield return Wrong("number of the next", 4, BitConverter.GetBytes(5));
            yield return Wrong("particles above the capacity", 8, BitConverter.GetBytes(501));
            yield return Wrong("particles above the capacity with their bytes", 8, BitConverter.GetBytes(501).Concat(new byte[4])
                .Concat(BitConverter.GetBytes(4 / 30.0)).Concat(BitConverter.GetBytes(9))
                .Concat(BitConverter.GetBytes((int)(4 * Header.Layout.Words(501)))).ToArray());
            yield return Wrong("particles of more bytes", 8, BitConverter.GetBytes(101));
            yield return Wrong("all the particles that there are", 8, BitConverter.GetBytes(uint.MaxValue));
            yield return Wrong("bytes of other particles", 28, BitConverter.GetBytes(4 * Words(4) + 4));
            yield return Wrong("bytes beyond the file", 28, BitConverter.GetBytes(uint.MaxValue));
            yield return Wrong("time that is not a number", 16, BitConverter.GetBytes(double.NaN));
            yield return Wrong("time without end", 16, BitConverter.GetBytes(double.PositiveInfinity));
            yield return Wrong("time before the last frame's", 16, BitConverter.GetBytes(2.9 / 30.0));
            yield return Wrong("step below 0", 24, BitConverter.GetBytes(-1));
        }

        static TestCaseData Wrong(string name, int at, byte[] value)
            => new TestCaseData(at, value).SetName("A frame is refused with a wrong " + name);

        // By the index, and one after the other where there is none.
        [TestCaseSource(nameof(FramesThatAreWrong))]
        public void A_frame_with_a_right_checksum_that_is_wrong_is_refused_in_each_way_of_reading(int at, byte[] value)
        {
            byte[] changed = WithFrame(bytes, 4, at, value), without = changed.Take((int)Ends().Last()).ToArray();
            Assert.That(Refusal(changed), Does.Contain("Frame 4 of the recording was changed since it was written"));
            Assert.That(Count(without), Is.EqualTo(4), "the frames before it");
            Assert.That(Refusal(without), Is.Null);
        }

        [Test]
        public void A_frame_of_the_index_that_lies_elsewhere_in_time_is_refused()
        {
            Assert.That(Refusal(WithFrame(bytes, 4, 16, BitConverter.GetBytes(4.1 / 30.0))), Does.Contain("Frame 4"), "s");
            Assert.That(Refusal(WithFrame(bytes, 4, 24, BitConverter.GetBytes(10))), Does.Contain("Frame 4"), "steps");
        }

        [Test]
        public void Frames_of_one_time_are_taken_in_each_way_of_reading()
        {
            byte[] frames = bytes.Take((int)Ends().Last()).ToArray();
            for (int i = 0; i < Counts.Length; i++)
                frames = WithFrame(frames, i, 16, BitConverter.GetBytes(0.5));
            Assert.That(Count(frames), Is.EqualTo(Counts.Length));
            IndexEntry[] entries = Counts.Select((particles, i) => new IndexEntry
            {
                position = i == 0 ? RecordingFormat.HeaderBytes : Ends()[i - 1], time = 0.5, particles = particles, step = 2 * i + 1
            }).ToArray();
            Assert.That(Refusal(frames.Concat(RecordingFormat.WriteIndex(entries, frames.Length)).ToArray()), Is.Null);
        }

        [Test]
        public void Buffers_run_out_while_the_disk_stands_still_and_what_was_written_is_whole()
        {
            var disk = new HeldStream();
            var writer = new RecordingWriter(disk, Header, 4);
            for (int i = 0; i < 4; i++)
                writer.Write(Fill(writer.TryReserve(), 4));
            RecordedFrame more = writer.TryReserve();
            disk.Go();
            Assert.That(more, Is.Null, "all wait for the disk");
            writer.Finish();
            Assert.That(writer.Join(20_000));
            Assert.That((writer.FramesWritten, writer.Problem, writer.IsDone), Is.EqualTo((4, (string)null, true)));
            Assert.That(writer.TryReserve(), Is.Not.Null, "buffers come back");
            Assert.That(writer.BytesWritten, Is.EqualTo(disk.ToArray().Length));
            Assert.That(Count(disk.ToArray()), Is.EqualTo(4));
        }

        [Test]
        public void A_full_disk_is_told_and_the_frames_before_are_whole()
        {
            var disk = new FullStream(3000);
            var writer = new RecordingWriter(disk, Header, 8);
            for (int i = 0; i < 8; i++)
                writer.Write(Fill(writer.TryReserve(), 4));
            writer.Finish();
            Assert.That(writer.Join(20_000));
            Assert.That(writer.Problem, Does.Contain("No space left"));
            Assert.That(writer.FramesWritten, Is.EqualTo(1));
            Assert.That(Count(disk.ToArray()), Is.EqualTo(1));
        }

        [Test]
        public void Long_frames_are_whole_and_a_changed_bit_is_found_in_each_part_of_them()
        {
            var header = new RecordingHeader(Header.Layout, 50_000, Header.Spacing, Header.DomainSize);
            const int Frames = 3, Words = 850_000 / 4;      // four parts, see ChecksumThreads
            var stream = new MemoryStream();
            var writer = new RecordingWriter(stream, header, Frames);
            for (int i = 0; i < Frames; i++)
            {
                RecordedFrame frame = writer.TryReserve();
                (frame.particles, frame.step, frame.time) = (header.Capacity, i, i);
                for (int k = 0; k < Words; k++)
                    frame.words[k] = (uint)(k * 2_654_435_761L + i);
                writer.Write(frame);
            }
            writer.Finish();
            Assert.That(writer.Join(20_000));
            byte[] file = stream.ToArray();
            int begin = RecordingFormat.HeaderBytes + 2 * RecordingFormat.FrameHeaderBytes + 4 * Words;       // of the particles of frame 1
            using (RecordingReader reader = Open(file))
            {
                var frame = new RecordedFrame();
                for (int i = 0; i < Frames; i++)
                {
                    reader.Read(i, frame);
                    Assert.That((frame.words[1], frame.words[Words - 1]), Is.EqualTo(((uint)(2_654_435_761L + i),
                        (uint)((Words - 1) * 2_654_435_761L + i))), $"frame {i}");
                }
                for (int at = 0; at < 4 * Words; at += 130_001)
                {
                    file[begin + at] ^= 4;
                    Assert.That(() => reader.Read(1, frame), Throws.TypeOf<InvalidDataException>(), $"byte {at:N0}");
                    file[begin + at] ^= 4;
                }
                reader.Read(1, frame);
            }
        }

        [Test]
        public void Coordinates_are_wide_only_in_boxes_of_more_than_1024_spacings()
        {
            Assert.That(FrameLayout.For(RecordingFields.None, new float3(10f, 1024f, 10f)).Bits, Is.EqualTo(16));
            Assert.That(FrameLayout.For(RecordingFields.None, new float3(10f, 1025f, 10f)).Bits, Is.EqualTo(21));
            Assert.That(new FrameLayout(RecordingFields.None, false).Words(1_000_000) * 4, Is.EqualTo(6_000_000));
            Assert.That(new FrameLayout(RecordingFields.All, false).Words(1_000_000) * 4, Is.EqualTo(17_000_000));
            Assert.That(new FrameLayout(RecordingFields.All, true).Words(1_000_000) * 4, Is.EqualTo(19_000_000));
        }

        static void AssertScanned(byte[] changed, int i)
        {
            try
            {
                using (RecordingReader reader = Open(changed))
                    Assert.That((reader.FrameCount, reader.WasCutShort), Is.EqualTo((Counts.Length, true)), $"byte {i}");
            }
            catch (InvalidDataException refusal)
            {
                Assert.Fail($"byte {i}: {refusal.Message}");
            }
        }

        byte[] WithIndex(List<IndexEntry> entries)
        {
            int end = (int)Ends().Last();
            return bytes.Take(end).Concat(RecordingFormat.WriteIndex(entries.ToArray(), end)).ToArray();
        }

        string RefusalWith(List<IndexEntry> entries, Action<List<IndexEntry>> change)
        {
            var changed = new List<IndexEntry>(entries);
            change(changed);
            return Refusal(WithIndex(changed));
        }

        static void Set(List<IndexEntry> entries, int i, Func<IndexEntry, IndexEntry> change) => entries[i] = change(entries[i]);

        static byte[] With(byte[] source, int at, uint value)
        {
            byte[] changed = source;
            for (int i = 0; i < 4; i++)
                changed = With(changed, at + i, (byte)(value >> 8 * i));
            return changed;
        }

        // With a right checksum of the frame's header.
        static byte[] WithFrame(byte[] source, int number, int at, byte[] value)
        {
            var changed = (byte[])source.Clone();
            int begin = number == 0 ? RecordingFormat.HeaderBytes : (int)Ends()[number - 1];
            value.CopyTo(changed, begin + at);
            BitConverter.GetBytes(Crc32C.Of(changed.AsSpan(begin, 36))).CopyTo(changed, begin + 36);
            return changed;
        }

        static byte[] With(byte[] source, int at, byte value)
        {
            var changed = (byte[])source.Clone();
            changed[at] = value;
            BitConverter.GetBytes(Crc32C.Of(changed.AsSpan(0, 60))).CopyTo(changed, 60);
            return changed;
        }

        // Positions at which frames end.
        static long[] Ends()
        {
            long at = RecordingFormat.HeaderBytes;
            return Enumerable.Range(0, Counts.Length).Select(i => at += RecordingFormat.FrameHeaderBytes + 4 * Words(i)).ToArray();
        }

        static int Words(int number) => (int)Header.Layout.Words(Counts[number]);

        static uint[] Particles(int number)
        {
            var random = new System.Random(number);
            return Enumerable.Range(0, Words(number)).Select(i => (uint)random.Next()).ToArray();
        }

        static RecordedFrame Fill(RecordedFrame frame, int number)
        {
            Particles(number).CopyTo(frame.words, 0);
            (frame.particles, frame.step, frame.time, frame.nextId) = (Counts[number], 2 * number + 1, number / 30.0, 7);
            return frame;
        }

        static byte[] Write(RecordingHeader header, int[] counts)
        {
            var stream = new MemoryStream();
            var writer = new RecordingWriter(stream, header, counts.Length);
            for (int i = 0; i < counts.Length; i++)
            {
                RecordedFrame frame = Fill(writer.TryReserve(), i);
                frame.particles = counts[i];
                writer.Write(frame);
            }
            writer.Finish();
            Assert.That(writer.Join(20_000));
            Assert.That(writer.Problem, Is.Null);
            return stream.ToArray();
        }

        static RecordingReader Open(byte[] given) => new RecordingReader(new MemoryStream(given));

        static int Count(byte[] given)
        {
            using (RecordingReader reader = Open(given))
                return reader.FrameCount;
        }

        // Refusal of the file or any of its frames; null where all are taken, and as many as there were.
        static string Refusal(byte[] given)
        {
            try
            {
                using (RecordingReader reader = Open(given))
                {
                    var frame = new RecordedFrame();
                    for (int i = 0; i < reader.FrameCount; i++)
                        reader.Read(i, frame);
                    return null;
                }
            }
            catch (InvalidDataException refusal)
            {
                return refusal.Message;
            }
        }
    }

    /// <summary>A disk that takes nothing until it is let go.</summary>
    sealed class HeldStream : MemoryStream
    {
        readonly ManualResetEventSlim gate = new ManualResetEventSlim(false);

        public void Go() => gate.Set();

        public override void Write(byte[] buffer, int offset, int count)
        {
            gate.Wait();
            base.Write(buffer, offset, count);
        }

        public override void Write(ReadOnlySpan<byte> buffer)
        {
            gate.Wait();
            base.Write(buffer);
        }
    }

    /// <summary>A disk with so much room.</summary>
    sealed class FullStream : MemoryStream
    {
        readonly long room;

        public FullStream(long room) => this.room = room;

        public override void Write(byte[] buffer, int offset, int count) => Write(buffer.AsSpan(offset, count));

        public override void Write(ReadOnlySpan<byte> buffer)
        {
            if (Position + buffer.Length > room)
                throw new IOException("No space left on device.");
            byte[] copy = buffer.ToArray();
            base.Write(copy, 0, copy.Length);
        }
    }
}
