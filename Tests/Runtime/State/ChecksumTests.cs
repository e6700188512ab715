using System;
using System.Linq;
using System.Runtime.InteropServices;
using System.Text;
using NUnit.Framework;
using UnityEngine.TestTools.Constraints;
using Is = NUnit.Framework.Is;

namespace Rill.Tests
{
    /// <summary>The checksum of files against its definition, bit by bit: for data of any length, summed by any number of
    /// threads.</summary>
    public class ChecksumTests
    {
        const int Part = ChecksumThreads.PartBytes;
        static readonly int[] Lengths = { 0, 1, 7, 8, 4093, Part - 1, Part, Part + 1, 2 * Part, 3 * Part + 5 };
        static readonly uint[] Words = Enumerable.Range(0, Part + 2).Select(i => Scrambled((uint)i)).ToArray();

        static ReadOnlySpan<byte> Bytes => MemoryMarshal.AsBytes(Words.AsSpan());

        [Test]
        public void The_checksum_is_CRC_32C()
        {
            Assert.That(Crc32C.Of(Encoding.ASCII.GetBytes("123456789")), Is.EqualTo(0xE3069283u));     // the check value of its definition
            Assert.That(Crc32C.Of(new byte[32]), Is.EqualTo(0x8A9136AAu));     // RFC 3720, B.4
            Assert.That(Crc32C.Append(Crc32C.Of(Encoding.ASCII.GetBytes("1234")), Encoding.ASCII.GetBytes("56789")),
                Is.EqualTo(0xE3069283u));
        }

        [Test]
        public void Tables_give_what_the_definition_gives_bit_by_bit()
        {
            for (int begin = 0; begin < 17; begin++)
                for (int length = 0; length < 70; length++)
                    Assert.That(Crc32C.Of(Bytes.Slice(begin, length)), Is.EqualTo(BitByBit(Bytes.Slice(begin, length))),
                        $"{length} bytes from {begin} on");
            Assert.That(Crc32C.Of(Bytes), Is.EqualTo(BitByBit(Bytes)));
        }

        [Test]
        public void Two_pieces_join_to_the_checksum_of_the_whole()
        {
            foreach (int first in new[] { 0, 1, 8, 999, 1000 })
            {
                uint joined = Crc32C.Combine(Crc32C.Of(Bytes.Slice(0, first)), Crc32C.Of(Bytes.Slice(first, 1000 - first)),
                    Crc32C.Shift(1000 - first));
                Assert.That(joined, Is.EqualTo(Crc32C.Of(Bytes.Slice(0, 1000))), $"{first} bytes and the rest");
            }
        }

        [Test]
        public void Threads_give_the_checksum_of_any_length([Values(0, 1, 3)] int helpers)
        {
            using (var threads = new ChecksumThreads(helpers))
                foreach (int length in Lengths)
                {
                    threads.Begin(Words, length);
                    Assert.That(threads.End(), Is.EqualTo(BitByBit(Bytes.Slice(0, length))), $"{length:N0} bytes");
                }
        }

        [Test]
        public void A_flipped_bit_is_found_in_every_part()
        {
            var changed = (uint[])Words.Clone();
            using (var threads = new ChecksumThreads())
            {
                const int Length = 3 * Part + 5;
                uint right = BitByBit(Bytes.Slice(0, Length));
                foreach (int at in new[] { 0, Part / 2, Part - 1, Part, Part + 1, 2 * Part - 1, 2 * Part + 3, 3 * Part - 1, 3 * Part,
                    Length - 1 })
                {
                    MemoryMarshal.AsBytes(changed.AsSpan())[at] ^= 0x10;
                    Assert.That(Of(threads, changed, Length), Is.Not.EqualTo(right), $"byte {at:N0}");
                    MemoryMarshal.AsBytes(changed.AsSpan())[at] ^= 0x10;
                }
                Assert.That(Of(threads, changed, Length), Is.EqualTo(right));
            }
        }

        [Test]
        public void Threads_sum_one_frame_after_the_other_without_a_mistake()
        {
            uint[] expected = Lengths.Select(length => Crc32C.Of(Bytes.Slice(0, length))).ToArray();
            using (var threads = new ChecksumThreads(3))
                for (int i = 0; i < 300; i++)
                {
                    int which = i * 7 % Lengths.Length;
                    Assert.That(Of(threads, Words, Lengths[which]), Is.EqualTo(expected[which]), $"frame {i} of {Lengths[which]:N0} bytes");
                }
        }

        [Test]
        public void Another_frame_takes_no_managed_memory()
        {
            using (var threads = new ChecksumThreads(3))
            {
                Of(threads, Words, 3 * Part + 5);
                uint sum = 0;
                TestDelegate frame = () => sum = Of(threads, Words, 3 * Part + 5);
                Assert.That(frame, Is.Not.AllocatingGCMemory());
                Assert.That(sum, Is.EqualTo(Crc32C.Of(Bytes.Slice(0, 3 * Part + 5))));
            }
        }

        [Test]
        public void Misuse_is_refused_with_what_to_do()
        {
            using (var threads = new ChecksumThreads(0))
            {
                Assert.That(() => threads.Begin(new uint[2], 9),
                    Throws.TypeOf<ArgumentOutOfRangeException>().With.Message.Contains("There are 8 bytes"));
                Assert.That(() => threads.Begin(new uint[2], -1), Throws.TypeOf<ArgumentOutOfRangeException>());
                threads.Begin(new uint[2], 8);
                Assert.That(() => threads.Begin(new uint[2], 8), Throws.InvalidOperationException.With.Message.Contains("call End first"));
                Assert.That(threads.End(), Is.EqualTo(Crc32C.Of(new byte[8])));
            }
        }

        static uint Of(ChecksumThreads threads, uint[] words, int bytes)
        {
            threads.Begin(words, bytes);
            return threads.End();
        }

        // RFC 3720, 12.1: the remainder of the bits, lowest first, by Castagnoli's polynomial, with all bits inverted before and after.
        static uint BitByBit(ReadOnlySpan<byte> bytes)
        {
            uint crc = 0xFFFFFFFFu;
            foreach (byte value in bytes)
            {
                crc ^= value;
                for (int bit = 0; bit < 8; bit++)
                    crc = (crc & 1) != 0 ? crc >> 1 ^ 0x82F63B78u : crc >> 1;
            }
            return ~crc;
        }

        static uint Scrambled(uint i)
        {
            i = (i ^ i >> 16) * 0x7FEB352Du;
            i = (i ^ i >> 15) * 0x846CA68Bu;       // lowbias32 of C. Wellons
            return i ^ i >> 16;
        }
    }
}
