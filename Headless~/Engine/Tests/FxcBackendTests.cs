using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Headless;

namespace Host.Tests
{
    /// <summary>
    /// Differences of two compilers of HLSL: each kernel as glslang makes it and as FXC's bytecode, both held against what
    /// Direct3D says (its 11.3 functional specification, by section) or against double precision.
    /// </summary>
    public class FxcBackendTests : BackendFixture
    {
        // ---- integers

        static uint[] RunIntegers(string backend, string kernel, params uint[] pairs)
        {
            ComputeShader shader = Compute(backend, "Integers");
            int k = shader.FindKernel(kernel);
            using (GraphicsBuffer words = Buffer(pairs))
            using (GraphicsBuffer result = Buffer(new uint[pairs.Length * 2]))
            {
                shader.SetBuffer(k, "_Words", words);
                shader.SetBuffer(k, "_Result", result);
                shader.Dispatch(k, pairs.Length / 2, 1, 1);
                return Words(result);
            }
        }

        // For each pair the four words that the rule gives.
        static void CheckIntegers(string backend, string kernel, Func<uint, uint, uint[]> rule, params uint[] pairs)
        {
            uint[] expected = Enumerable.Range(0, pairs.Length / 2).SelectMany(i => rule(pairs[2 * i], pairs[2 * i + 1])).ToArray();
            Assert.That(RunIntegers(backend, kernel, pairs), Is.EqualTo(expected));
        }

        static uint U(int value) => unchecked((uint)value);

        // 22.11.7, 8, 12 (ishl, ishr, ushr): the low five bits of the amount count. C# shifts so too.
        [TestCaseSource(nameof(Backends))]
        public void A_shift_takes_the_low_five_bits_of_its_amount(string backend)
            => CheckIntegers(backend, "Shift",
                (v, by) => new[] { v << (int)by, v >> (int)by, U((int)v >> (int)by), v << (int)by ^ 1u << (int)by ^ v << 4 },
                1, 31, 0x80000001, 1, 0xF0000000, 32, 0x12345678, 33, 0xFFFFFFFF, 63, 0x80000000, 0xFFFFFFFF, 7, 100);

        // 22.12.9 (udiv): a divisor of 0 gives 0xffffffff for quotient and remainder.
        [TestCaseSource(nameof(Backends))]
        public void Unsigned_division_by_zero_gives_all_ones(string backend)
            => CheckIntegers(backend, "DivideUnsigned", (v, by) => new[] { by == 0 ? ~0u : v / by, by == 0 ? ~0u : v % by, v / 7, v % 7 },
                100, 7, 5, 0, 0, 0, 0xFFFFFFFF, 0xFFFFFFFF, 0xFFFFFFFF, 1, 3, 0x80000000, 0x80000000, 0);

        // Direct3D 11 has no signed division; FXC takes the magnitudes to udiv and gives the result the sign afterwards.
        [TestCaseSource(nameof(Backends))]
        public void Signed_division_rounds_to_zero_and_survives_zero_and_the_smallest_integer(string backend)
        {
            CheckIntegers(backend, "DivideSigned", (v, by) => DivideSigned((int)v, (int)by),
                100, 7, U(-7), 2, 7, U(-2), U(-7), U(-2), U(-1), 3, 5, 0, U(-5), 0, 0, 0, U(int.MinValue), U(-1), U(int.MinValue), 1,
                    U(int.MinValue), 2, int.MaxValue, U(-1), 0, U(-1), U(int.MinValue), 0);
        }

        static uint[] DivideSigned(int value, int by)
        {
            int Quotient(int v, int d) => d == 0 ? (v < 0 ? 1 : -1) : unchecked((int)((long)v / d));
            int Remainder(int v, int d) => d == 0 ? (v < 0 ? 1 : -1) : unchecked((int)((long)v % d));
            return new[] { U(Quotient(value, by)), U(Remainder(value, by)), U(Quotient(value, -7)), U(Remainder(value, -7)) };
        }

        // 22.11.3 to 5 (bfrev, countbits, firstbit); HLSL counts all from the lowest bit, and none gives -1.
        [TestCaseSource(nameof(Backends))]
        public void Bits_are_counted_and_found(string backend)
            => CheckIntegers(backend, "CountBits",
                (v, _) => new[] { (uint)Bits(v).Count(), Bits(v).Aggregate(0u, (r, bit) => r | 1u << 31 - bit), Bits(v).Any()
                ? (uint)Bits(v).First() : ~0u, Bits(v).Any() ? (uint)Bits(v).Last() : ~0u },
                0, 0, 1, 0, 0x80000000, 0, 0x00F01000, 0, 0xFFFFFFFF, 0, 0x12345678, 0);

        static IEnumerable<int> Bits(uint value) => Enumerable.Range(0, 32).Where(bit => (value >> bit & 1) != 0);

        // FXC makes ubfe, ibfe and bfi of these (22.11.2, 6, 11). Of negative numbers firstbithigh looks for the highest 0.
        [TestCaseSource(nameof(Backends))]
        public void Bit_fields_are_cut_out_and_put_in(string backend)
            => CheckIntegers(backend, "Fields", (v, o) => new[] { v >> 3 & 31, U((int)(v << 20) >> 25), (v & 0x7F) << 5 | o & 0x1F, MaxBit((int)v) },
                0x12345678, 0xABCD, 0xFFFFFFFF, 0, 0x00000FE0, 0x1F, 0x800, 3, 0, 0, 0xFFFFFFFE, 1, 0x40000000, 0);

        static uint MaxBit(int value)
        {
            uint sought = U(value < 0 ? ~value : value);
            return sought == 0 ? ~0u : (uint)Bits(sought).Last();
        }

        // ---- floats

        static uint[] RunFloats(string backend, string kernel, params float[] triples)
        {
            ComputeShader shader = Compute(backend, "Floats");
            int k = shader.FindKernel(kernel);
            int threads = triples.Length / 3;
            using (GraphicsBuffer floats = Buffer(triples))
            using (GraphicsBuffer result = Buffer(new uint[threads * 8]))
            {
                shader.SetBuffer(k, "_Floats", floats);
                shader.SetBuffer(k, "_Result", result);
                shader.Dispatch(k, threads, 1, 1);
                return Words(result);
            }
        }

        static float[] AsFloats(uint[] words) => words.Select(Float).ToArray();
        static float Float(uint word) => BitConverter.ToSingle(BitConverter.GetBytes(word), 0);
        static uint Word(float value) => BitConverter.ToUInt32(BitConverter.GetBytes(value), 0);

        // 22.13.3, 22.13.4 (ftoi, ftou): toward zero; out of range to the nearest; NaN to 0.
        [TestCaseSource(nameof(Backends))]
        public void A_float_that_an_integer_cannot_hold_becomes_the_nearest(string backend)
        {
            float[] values = { 0.9f, -0.9f, -1, 1e20f, -1e20f, 2147483648f, -2147483648f, 4294967040f, 4294967296f, 3e9f, float.NaN,
                float.PositiveInfinity, float.NegativeInfinity, 16777217f, -2147483904f };
            uint[] got = RunFloats(backend, "Convert", values.SelectMany(v => new[] { v, -v, 0 }).ToArray());
            uint[] expected = values.SelectMany(v => new[] { ToUInt(v), ToInt(v), ToUInt(v), ToUInt(-v), ToInt(-v), ToInt(v),
                Word((float)Word(v)), Word((float)(int)Word(v)) }).ToArray();
            Assert.That(got, Is.EqualTo(expected));
        }

        static uint ToUInt(float v) => float.IsNaN(v) || v <= 0 ? 0 : v >= 4294967296f ? uint.MaxValue : (uint)v;
        static uint ToInt(float v) => float.IsNaN(v) ? 0 : v >= 2147483648f ? int.MaxValue : v < -2147483648f ? U(int.MinValue) : U((int)v);

        // 22.10.10, 22.10.11 (max, min): a NaN gives way to the number. 22.19.1 (_sat): NaN becomes 0.
        [TestCaseSource(nameof(Backends))]
        public void The_least_and_the_most_pass_over_NaN(string backend)
        {
            float[] got = AsFloats(RunFloats(backend, "MinMax", 1, 2, 3, float.NaN, 2, 3, 1, float.NaN, 3, float.NaN, float.NaN, 0.5f, -5,
                -3, 7, float.PositiveInfinity, float.NegativeInfinity, 1));
            float nan = float.NaN, inf = float.PositiveInfinity;
            Assert.That(got, Is.EqualTo(new[]
            {
                1, 2, 1, 2, 2, 1, 2, 0,
                2, 2, 2, 2, 2, 0, 3, 0,
                1, 1, 1, 1, 1, 1, 1, 0,
                nan, nan, nan, nan, 0.5f, 0, 0.5f, 0,
                -5, -3, -5, -3, -3, 0, -3, 0,
                -inf, inf, -inf, inf, 1, 1, 1, 0,
            }));
        }

        // 22.19.2 (precise): no operation may be fused into another. Otherwise fused or not, never worse.
        [TestCaseSource(nameof(Backends))]
        public void What_is_precise_rounds_after_each_operation(string backend)
        {
            // The product needs more bits than a float has: 1 + 2^-11 + 2^-24, of which a float keeps the first two.
            float a = 1 + 1f / 4096, c = -(1 + 1f / 2048);
            float[] got = AsFloats(RunFloats(backend, "Precise", a, a, c));
            float fused = 1f / 16777216;
            Assert.That(got[0], Is.EqualTo(0), "product rounded, then the sum");
            Assert.That(got[1], Is.EqualTo(1 + 1f / 2048));
            Assert.That(got[2], Is.EqualTo(0).Or.EqualTo(fused));
            Assert.That(got[3], Is.EqualTo(0).Or.EqualTo(fused));
        }

        // 22.10.20 (sincos): 0.0008 absolute within 100 pi. 22.10.6 (exp): 2^-21 relative. 22.10.8 (log): 2^-21. 22.10.2, 19, 21 (div, rsq,
        // sqrt): one ulp.
        [TestCaseSource(nameof(Backends))]
        public void Functions_are_as_exact_as_Direct3D_demands(string backend)
        {
            var random = new System.Random(7);
            float[] triples = Enumerable.Range(0, 500)
                .SelectMany(i => new[] { (float)(random.NextDouble() * 600 - 300), (float)(random.NextDouble() * 40 - 20),
                (float)Math.Exp(random.NextDouble() * 20 - 10) }).ToArray();
            float[] got = AsFloats(RunFloats(backend, "Transcendental", triples));
            const double exact = 1.0 / (1 << 22), near = 1.0 / (1 << 21);
            for (int i = 0; i < 500; i++)
            {
                double a = triples[3 * i], b = triples[3 * i + 1], c = triples[3 * i + 2];
                double[] expected = { Math.Sin(a), Math.Cos(a), Math.Pow(2, b), Math.Log(c, 2), Math.Sqrt(c), 1 / Math.Sqrt(c), a / c,
                    Math.Pow(c, (double)((float)b * 0.1f)) };
                double[] bound =
                {
                    0.0008, 0.0008, near * expected[2], near * Math.Max(1, Math.Abs(expected[3])), exact * expected[4], exact * expected[5],
                        exact * Math.Abs(expected[6]),
                    // By exp2 of a product with log2: errors in the exponent count in full.
                    4 * near * expected[7] * Math.Max(1, Math.Abs(b * Math.Log(c, 2))),
                };
                for (int f = 0; f < 8; f++)
                    Assert.That(got[8 * i + f], Is.EqualTo(expected[f]).Within(bound[f]), $"function {f} of {a:R}, {b:R}, {c:R}");
            }
        }

        // 22.10.14 to 17: round_ne goes to the even one.
        [TestCaseSource(nameof(Backends))]
        public void Numbers_are_rounded_to_the_even_one_and_cut_toward_zero(string backend)
        {
            float[] values = { 0.5f, 1.5f, 2.5f, -0.5f, -1.5f, -2.75f, 3.25f, 0 };
            float[] got = AsFloats(RunFloats(backend, "Round", values.SelectMany(v => new[] { v, 2f, 0 }).ToArray()));
            float[] expected = values.SelectMany(v => new[]
            {
                (float)Math.Round(v, MidpointRounding.ToEven), (float)Math.Truncate(v), (float)Math.Floor(v), (float)Math.Ceiling(v),
                    v - (float)Math.Floor(v), v % 2, Math.Sign(v), v <= 2 ? 1 : 0,
            }).ToArray();
            Assert.That(got, Is.EqualTo(expected).Within(1e-6));
        }

        // 22.13.1, 22.13.2 (f16tof32, f32tof16).
        [TestCaseSource(nameof(Backends))]
        public void Halves_hold_what_they_can(string backend)
        {
            uint[] got = RunFloats(backend, "Half", 1, 0, 0, -2.5f, 0, 0, 65504, 0, 0, 1f / 16384, 0, 0, float.PositiveInfinity, 0, 0, 0, 0, 0);
            Assert.That(Enumerable.Range(0, 6).Select(i => got[8 * i]), Is.EqualTo(new uint[] { 0x3C00, 0xC100, 0x7BFF, 0x0400, 0x7C00, 0 }));
            Assert.That(Enumerable.Range(0, 6).Select(i => Float(got[8 * i + 1])),
                Is.EqualTo(new[] { 1, -2.5f, 65504, 1f / 16384, float.PositiveInfinity, 0 }));
        }

        // ---- packing

        static float[] RunPacking(string backend, string kernel, int index)
        {
            const int elementWords = 52;
            ComputeShader shader = Compute(backend, "Packing");
            int k = shader.FindKernel(kernel);
            using (GraphicsBuffer constants = Buffer(Counting(256), GraphicsBuffer.Target.Constant, 16))
            using (GraphicsBuffer elements = Buffer(Counting(4 * elementWords), stride: 4 * elementWords))
            using (GraphicsBuffer vectors = Buffer(Counting(60), stride: 12))
            using (GraphicsBuffer result = Buffer(new float[32]))
            using (GraphicsBuffer written = Buffer(new float[2 * elementWords], stride: 4 * elementWords))
            {
                shader.SetInt("_Index", index);
                shader.SetConstantBuffer(kernel == "ReadPlaced" ? "Placed" : "Params", constants, 0, 256 * 4);
                if (kernel == "ReadElements")
                {
                    shader.SetBuffer(k, "_Elements", elements);
                    shader.SetBuffer(k, "_Vectors", vectors);
                }
                bool writes = kernel == "WriteElements";
                shader.SetBuffer(k, writes ? "_Written" : "_Result", writes ? written : result);
                shader.Dispatch(k, 1, 1, 1);
                return Floats(writes ? written : result);
            }
        }

        // "Packing Rules for Constant Variables": registers of four words, which a vector does not straddle; each element of
        // an array starts one.
        [TestCaseSource(nameof(Backends))]
        public void Constants_lie_in_registers(string backend)
        {
            float[] got = RunPacking(backend, "ReadConstants", 2);
            // Equal to ShaderLayoutTests up to x at 76; pair 80, 84 and 88, isSet 90, mats 92 (columns) and 104, end 114.
            Assert.That(got.Take(20), Is.EqualTo(new float[] { 2, 3, 16, 17, 24, 22, 31, 37, 38, 51, 54, 65, 74, 76, 12, 52, 89, 1, 113, 114 }));
        }

        [TestCaseSource(nameof(Backends))]
        public void Constants_lie_where_packoffset_puts_them(string backend)
            => Assert.That(RunPacking(backend, "ReadPlaced", 0).Take(4), Is.EqualTo(new float[] { 37, 11, 24, 55 }));

        [TestCaseSource(nameof(Backends))]
        public void Elements_of_structured_buffers_lie_without_gaps(string backend)
        {
            float[] got = RunPacking(backend, "ReadElements", 2);
            // In words: a 0, b 1, i 4, c 10, two 12, m 24, r 33, q 39, tail 45, z 51; an element is 52.
            Assert.That(got.Take(13), Is.EqualTo(new float[] { 52, 55, 61, 62, 73, 79, 78, 90, 96, 101, 155, 6, 17 }));
        }

        [TestCaseSource(nameof(Backends))]
        public void Elements_are_written_without_gaps(string backend)
        {
            var expected = new float[52];
            void Put(int at, params float[] values) => values.CopyTo(expected, at);
            Put(0, 1, 2, 3, 4);
            Put(22, 5, 6);
            Put(24, 10, 13, 16, 11, 14, 17, 12, 15, 18);
            Put(33, 20, 21, 22, 23, 24, 25);
            Put(48, 7, 7, 7, 8);
            Assert.That(RunPacking(backend, "WriteElements", 0).Skip(52), Is.EqualTo(expected));
        }

        // ---- groups

        static readonly uint[] Inputs = Enumerable.Range(0, 64).Select(i => (uint)(i * 2654435761 % 1000 + 1)).ToArray();

        static uint[] RunGroup(string backend, string kernel, int count = 64, uint[] start = null)
        {
            ComputeShader shader = Compute(backend, "Groups");
            int k = shader.FindKernel(kernel);
            using (GraphicsBuffer words = Buffer(Inputs))
            using (GraphicsBuffer result = Buffer(start ?? new uint[256]))
            using (GraphicsBuffer parts = Buffer(new uint[64 * 6], stride: 24))
            {
                bool structs = kernel == "HlslStructs";
                if (kernel != "LeaveTogether" && kernel != "OrderMemory")
                    shader.SetBuffer(k, "_Words", words);
                shader.SetInt("_Count", count);
                shader.SetBuffer(k, structs ? "_Parts" : "_Result", structs ? parts : result);
                shader.Dispatch(k, 1, 1, 1);
                return Words(structs ? parts : result);
            }
        }

        [TestCaseSource(nameof(Backends))]
        public void A_loop_with_barriers_adds_up(string backend)
        {
            uint[] got = RunGroup(backend, "SumByTree");
            Assert.That(got.Take(64), Is.EqualTo(Enumerable.Range(0, 64).Select(i => (uint)Inputs.Take(i + 1).Sum(v => v))));
            Assert.That(got[64], Is.EqualTo(Inputs.Sum(v => v)));
        }

        [TestCaseSource(nameof(Backends))]
        public void Atomics_lose_nothing_and_say_what_was_there(string backend)
        {
            var start = new uint[256];
            start[131] = ~0u;
            start[135] = 33;
            uint[] got = RunGroup(backend, "Atomics", start: start);
            Assert.That(got.Take(64).OrderBy(v => v), Is.EqualTo(Enumerable.Range(0, 64)), "a ticket each");
            uint sum = (uint)Inputs.Sum(v => v);
            // Each saw the sum of those before it: together they are a chain from 0 to the sum.
            List<(uint before, uint after)> steps = Enumerable.Range(0, 64).Select(i => (got[64 + i], got[64 + i] + Inputs[i]))
                .OrderBy(s => s.Item1).ToList();
            Assert.That(steps[0].before, Is.EqualTo(0));
            for (int i = 1; i < 64; i++)
                Assert.That(steps[i].before, Is.EqualTo(steps[i - 1].after));
            Assert.That(got.Skip(128).Take(8), Is.EqualTo(new uint[]
            {
                64u, U((int)Inputs.Min() - 1000), sum, Inputs.Aggregate((a, b) => a & b), Inputs.Aggregate((a, b) => a | b),
                    Inputs.Aggregate((a, b) => a ^ b), Inputs.Max(), 77u,
            }));
            uint winner = got[200];
            Assert.That(winner, Is.InRange(1, 64));
            Assert.That(got.Skip(136).Take(64).Select((seen, i) => i + 1 == winner ? seen == 0 : seen == winner), Is.All.True,
                "one found 0, the others the winner");
        }

        [TestCaseSource(nameof(Backends))]
        public void Structs_in_group_memory_are_shared_whole(string backend)
        {
            uint[] got = RunGroup(backend, "HlslStructs");
            for (int i = 0; i < 64; i++)
            {
                int of = (i + 1) & 63, four = i & ~3;
                uint hits = (uint)Inputs.Skip(four).Take(4).Sum(v => v), most = of % 4 == 0 ? 1003 + (uint)of : 100 + (uint)of;
                Assert.That(got.Skip(6 * i).Take(6), Is.EqualTo(new[] { Word(of), Word(2 * of), Word(3 * of), hits, (uint)of, most }), $"part {i}");
            }
        }

        [TestCaseSource(nameof(Backends))]
        public void A_group_may_leave_as_one_before_a_barrier_and_singly_after(string backend)
        {
            Assert.That(RunGroup(backend, "LeaveTogether", count: 0), Is.All.Zero);
            Assert.That(RunGroup(backend, "LeaveTogether", count: 10), Is.EqualTo(Enumerable.Range(0, 256).Select(i => i < 10 ? 63 - i : 0)));
        }

        // 22.17.7 (sync): without _t no thread waits, so that it may stand under a branch.
        [TestCaseSource(nameof(Backends))]
        public void Barriers_order_memory_and_only_some_wait(string backend)
        {
            uint[] got = RunGroup(backend, "OrderMemory");
            Assert.That(got.Take(64), Is.EqualTo(Enumerable.Range(0, 64).Select(i => (i ^ 1) * (i ^ 1))));
            Assert.That(got.Skip(64).Take(8), Is.EqualTo(Enumerable.Range(0, 8).Select(i => i < 7 ? (i ^ 1) * (i ^ 1) : 0)));
        }

        // ---- buffers

        [TestCaseSource(nameof(Backends))]
        public void Raw_buffers_are_addressed_by_bytes(string backend)
        {
            ComputeShader shader = Compute(backend, "Buffers");
            int k = shader.FindKernel("Raw");
            using (GraphicsBuffer raw = Buffer(Enumerable.Range(0, 64).ToArray(), GraphicsBuffer.Target.Raw))
            using (GraphicsBuffer output = Buffer(new uint[16], GraphicsBuffer.Target.Raw))
            {
                shader.SetInt("_Count", 40);
                shader.SetBuffer(k, "_Raw", raw);
                shader.SetBuffer(k, "_RawOut", output);
                shader.Dispatch(k, 1, 1, 1);
                Assert.That(Words(output), Is.EqualTo(new uint[] { 1, 2, 3, 10, 11, 12, 4, 5, 6, 7, 5, 123, 9, 0, 0, 0 }));
            }
        }

        [TestCaseSource(nameof(Backends))]
        public void What_is_appended_can_be_counted_and_consumed(string backend)
        {
            ComputeShader shader = Compute(backend, "Buffers");
            int append = shader.FindKernel("AppendEven"), consume = shader.FindKernel("ConsumeAll");
            using (var list = new ComputeBuffer(64, 8, ComputeBufferType.Append))
            using (GraphicsBuffer count = Buffer(new uint[1], GraphicsBuffer.Target.Raw))
            using (GraphicsBuffer result = Buffer(new uint[33]))
            {
                list.SetCounterValue(0);
                shader.SetBuffer(append, "_Appended", list);
                shader.Dispatch(append, 1, 1, 1);
                var pairs = new uint[64];
                list.GetData(pairs, 0, 0, 64);
                Assert.That(Enumerable.Range(0, 32).Select(i => pairs[2 * i]).OrderBy(v => v),
                    Is.EqualTo(Enumerable.Range(0, 32).Select(i => 2 * i)));
                Assert.That(Enumerable.Range(0, 32).Select(i => pairs[2 * i + 1] - pairs[2 * i] * pairs[2 * i]), Is.All.Zero);

                shader.SetBuffer(consume, "_Consumed", list);
                shader.SetBuffer(consume, "_Result", result);
                shader.Dispatch(consume, 1, 1, 1);
                Assert.That(Words(result), Is.EqualTo(new uint[32].Append(32u * 31u)), "each pair once");
            }
        }

        [TestCaseSource(nameof(Backends))]
        public void A_counter_gives_each_thread_its_slot(string backend)
        {
            ComputeShader shader = Compute(backend, "Buffers");
            int k = shader.FindKernel("Count");
            using (var counted = new ComputeBuffer(80, 4, ComputeBufferType.Counter))
            {
                counted.SetData(new uint[80]);
                counted.SetCounterValue(10);
                shader.SetBuffer(k, "_Counted", counted);
                shader.Dispatch(k, 1, 1, 1);
                var values = new uint[80];
                counted.GetData(values);
                Assert.That(values.Skip(10).Take(64).OrderBy(v => v), Is.EqualTo(Enumerable.Range(0, 64)));
                Assert.That(values.Take(10).Concat(values.Skip(74)), Is.All.Zero);
            }
        }

        // 22.4.6 (ld), 22.4.10 (ld_raw), 22.4.12 (ld_structured): 0 from outside.
        [TestCaseSource(nameof(Backends))]
        public void Outside_of_a_buffer_lies_zero(string backend)
        {
            ComputeShader shader = Compute(backend, "Buffers");
            int k = shader.FindKernel("ReadOutside");
            int[] sevens = Enumerable.Repeat(7, 48).ToArray();
            using (GraphicsBuffer words = Buffer(sevens))
            using (GraphicsBuffer vectors = Buffer(Enumerable.Repeat(7f, 48 * 3).ToArray(), stride: 12))
            using (GraphicsBuffer raw = Buffer(sevens, GraphicsBuffer.Target.Raw))
            using (GraphicsBuffer result = Buffer(new uint[8]))
            {
                shader.SetInt("_Count", 48);
                shader.SetBuffer(k, "_Words", words);
                shader.SetBuffer(k, "_Vectors", vectors);
                shader.SetBuffer(k, "_Raw", raw);
                shader.SetBuffer(k, "_Texels", words);
                shader.SetBuffer(k, "_Result", result);
                shader.Dispatch(k, 1, 1, 1);
                Assert.That(Words(result), Is.EqualTo(new uint[] { 0, 7, 0, 0, 0, 7, 0, 0 }));
            }
        }

        // 22.4.9, 11, 13 (store_uav_typed, store_raw, store_structured) and the atomics: nothing is written outside.
        [TestCaseSource(nameof(Backends))]
        public void What_is_written_outside_of_a_buffer_is_dropped(string backend)
        {
            ComputeShader shader = Compute(backend, "Buffers");
            int k = shader.FindKernel("WriteOutside");
            using (GraphicsBuffer result = Buffer(new uint[16]))
            using (GraphicsBuffer vectors = Buffer(new float[16 * 3], stride: 12))
            using (GraphicsBuffer raw = Buffer(new uint[16], GraphicsBuffer.Target.Raw))
            using (GraphicsBuffer texels = Buffer(new float[16]))
            {
                shader.SetInt("_Count", 16);
                shader.SetBuffer(k, "_Result", result);
                shader.SetBuffer(k, "_VectorsOut", vectors);
                shader.SetBuffer(k, "_RawOut", raw);
                shader.SetBuffer(k, "_TexelsOut", texels);
                shader.Dispatch(k, 1, 1, 1);
                Assert.That(Words(result), Is.EqualTo(new uint[16].Select((_, i) => i == 0 ? 6u : 0)));
                Assert.That(Words(vectors).Concat(Words(raw)).Concat(Words(texels)), Is.All.Zero);
            }
        }

        [TestCaseSource(nameof(Backends))]
        public void Buffers_tell_their_sizes(string backend)
        {
            ComputeShader shader = Compute(backend, "Buffers");
            int k = shader.FindKernel("Sizes");
            using (GraphicsBuffer words = Buffer(new uint[20]))
            using (GraphicsBuffer raw = Buffer(new uint[30], GraphicsBuffer.Target.Raw))
            using (GraphicsBuffer counted = Buffer(new uint[50]))
            using (GraphicsBuffer result = Buffer(new uint[7]))
            {
                shader.SetBuffer(k, "_Words", words);
                shader.SetBuffer(k, "_Raw", raw);
                shader.SetBuffer(k, "_Texels", words);
                shader.SetBuffer(k, "_Counted", counted);
                shader.SetBuffer(k, "_Result", result);
                shader.Dispatch(k, 1, 1, 1);
                Assert.That(Words(result), Is.EqualTo(new uint[] { 20, 4, 0, 120, 20, 50, 4 }));
            }
        }

        [TestCaseSource(nameof(Backends))]
        public void Typed_buffers_convert_by_their_type(string backend)
        {
            ComputeShader shader = Compute(backend, "Buffers");
            int k = shader.FindKernel("Typed");
            using (GraphicsBuffer texels = Buffer(Enumerable.Range(0, 64).ToArray()))
            using (GraphicsBuffer output = Buffer(Enumerable.Repeat(100f, 64).ToArray()))
            {
                shader.SetBuffer(k, "_Texels", texels);
                shader.SetBuffer(k, "_TexelsOut", output);
                shader.Dispatch(k, 1, 1, 1);
                Assert.That(Floats(output), Is.EqualTo(Enumerable.Range(0, 64).Select(i => 100 + 0.5f * i)));
            }
        }

        // ---- control

        static uint[] RunControl(string backend, string kernel)
        {
            ComputeShader shader = Compute(backend, "Control");
            int k = shader.FindKernel(kernel);
            using (GraphicsBuffer words = Buffer(Inputs))
            using (GraphicsBuffer result = Buffer(new uint[64]))
            {
                shader.SetBuffer(k, "_Words", words);
                shader.SetBuffer(k, "_Result", result);
                shader.Dispatch(k, 1, 1, 1);
                return Words(result);
            }
        }

        static void CheckControl(string backend, string kernel, Func<int, uint, uint> rule)
            => Assert.That(RunControl(backend, kernel), Is.EqualTo(Enumerable.Range(0, 64).Select(i => rule(i, Inputs[i]))));

        [TestCaseSource(nameof(Backends))]
        public void Arrays_are_indexed_at_run_time(string backend)
        {
            uint[] table = { 3, 1, 4, 1, 5, 9, 2 };
            CheckControl(backend, "Arrays", (i, word) => (uint)Inputs.Take(i + 1).Sum(w => table[w % 7]) + 3 * (word & 3) + 1 + (uint)i % 3);
        }

        [TestCaseSource(nameof(Backends))]
        public void A_switch_takes_one_way(string backend)
            => CheckControl(backend, "Switches", (i, word) =>
            {
                switch (word % 6)
                {
                    case 0: return (uint)i;
                    case 1:
                    case 2: return 100 + (uint)i;
                    case 4: return i % 2 == 1 ? 100u : 4;
                    default: return 7;
                }
            });

        [TestCaseSource(nameof(Backends))]
        public void Loops_are_left_and_gone_on_with(string backend)
            => CheckControl(backend, "Loops", (i, word) =>
            {
                uint steps = 0, odd = 0;
                for (uint n = word; n != 1 && steps < 50; n = n % 2 == 0 ? n / 2 : 3 * n + 1)
                {
                    steps++;
                    odd += n % 2;
                }
                int found = Array.FindIndex(Inputs, w => w % 64 == i);
                return steps + 100 * odd + 10000 * (uint)(found < 0 ? 64 : found);
            });

        [TestCaseSource(nameof(Backends))]
        public void Functions_return_early_and_through_their_parameters(string backend)
            => CheckControl(backend, "Calls", (i, word) => Math.Max(word, (uint)i % 5) + 1000);

        // ---- what is not the same

        static float[] RunUnset(string backend, string kernel, float[] floats, int count, int results)
        {
            ComputeShader shader = Compute(backend, "Unset");
            int k = shader.FindKernel(kernel);
            using (GraphicsBuffer input = Buffer(floats))
            using (GraphicsBuffer result = Buffer(new float[results]))
            {
                shader.SetInt("_Count", count);
                shader.SetBuffer(k, "_Floats", input);
                shader.SetBuffer(k, "_Result", result);
                shader.Dispatch(k, 1, 1, 1);
                return Floats(result);
            }
        }

        // FXC takes a variable that is set on one path to be set on all of them, without a word, or starts it at 0 where it
        // cannot. What glslang's program does then is the driver's affair: only what was set is the same.
        [TestCaseSource(nameof(Backends))]
        public void A_variable_that_was_not_set_is_whatever_suits_the_compiler(string backend)
        {
            float[] floats = Enumerable.Range(0, 65).Select(i => i % 3 == 0 ? -1f : i).ToArray();
            float[] branch = RunUnset(backend, "SetUnderBranch", floats, 0, 64), loop = RunUnset(backend, "SetInLoop", floats, 5, 64);
            for (int i = 0; i < 64; i++)
                if (floats[i] > 0 || backend == "fxc")
                    Assert.That(branch[i], Is.EqualTo(floats[i + 1]), $"thread {i}");
            Assert.That(loop, Is.All.EqualTo(4));
            if (backend == "fxc")
                Assert.That(RunUnset(backend, "SetInLoop", floats, 0, 64), Is.All.Zero);
        }

        // FXC 10.1 drops one of the eight stores of an unrolled loop that writes two runs of a buffer, unless it is told not to
        // optimize. Unity's program would lack it too; that it is missing here shows that FXC's bytecode is what runs.
        [Test]
        public void A_store_that_FXC_drops_is_missing_when_its_bytecode_runs()
        {
            float[] all = { 1, 2, 3, -1, 2, 4, 6, -2 };
            Assert.That(RunUnset("glslang", "TwoRuns", new float[] { 1, 2, 9 }, 0, 8), Is.EqualTo(all));
            all[1] = 0;
            Assert.That(RunUnset("fxc", "TwoRuns", new float[] { 1, 2, 9 }, 0, 8), Is.EqualTo(all));
        }
    }
}
