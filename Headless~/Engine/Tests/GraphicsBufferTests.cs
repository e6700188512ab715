using System;
using System.Collections.Generic;
using System.Linq;
using System.Runtime.InteropServices;
using NUnit.Framework;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace Host.Tests
{
    public class GraphicsBufferTests : GraphicsFixture
    {
        [StructLayout(LayoutKind.Sequential)]
        struct Packed
        {
            public Vector3 Position;
            public uint Id;
            public Vector2 Uv;
            public Vector3 Normal;
        }

        const int Count = 130;

        static GraphicsBuffer Structured(int count, int stride, GraphicsBuffer.Target more = 0)
            => new GraphicsBuffer(GraphicsBuffer.Target.Structured | more, count, stride);

        // Sends an array through a copy kernel and back.
        static T[] RoundTrip<T>(string type, T[] values, int stride) where T : struct
        {
            ComputeShader shader = Compute("Strides");
            int kernel = shader.FindKernel("Copy" + type);
            var result = new T[values.Length];
            using (GraphicsBuffer input = Structured(values.Length, stride), output = Structured(values.Length, stride))
            {
                input.SetData(values);
                shader.SetInt("_Count", values.Length);
                shader.SetBuffer(kernel, "_In" + type, input);
                shader.SetBuffer(kernel, "_Out" + type, output);
                shader.Dispatch(kernel, (values.Length + 63) / 64, 1, 1);
                output.GetData(result);
            }
            return result;
        }

        static T[] Numbers<T>(Func<int, T> make) => Enumerable.Range(0, Count).Select(make).ToArray();

        [Test] public void Uints_come_back_as_they_went() => Same("Uint", Numbers(i => (uint)i * 7), 4);
        [Test] public void Pairs_of_floats_come_back_as_they_went() => Same("Float2", Numbers(i => new Vector2(i, -i)), 8);
        [Test] public void Triples_of_floats_are_twelve_bytes_apart() => Same("Float3", Numbers(i => new Vector3(i, -i, i * 0.5f)), 12);
        [Test] public void Quadruples_of_floats_come_back_as_they_went() => Same("Float4", Numbers(i => new Vector4(i, -i, i * 0.5f, 1)), 16);
        [Test] public void Pairs_of_ints_come_back_as_they_went() => Same("Int2", Numbers(i => new Vector2Int(-i, i)), 8);

        [Test]
        public void Structs_are_packed_without_gaps() =>
            Same("Packed", Numbers(i => new Packed { Position = new Vector3(i, 1, 2), Id = (uint)i, Uv = new Vector2(3, i),
            Normal = new Vector3(4, 5, i) }), 36);

        static void Same<T>(string type, T[] values, int stride) where T : struct => Assert.That(RoundTrip(type, values, stride), Is.EqualTo(values));

        [Test]
        public void Raw_buffers_are_read_and_written_by_byte_address()
        {
            ComputeShader shader = Compute("Strides");
            int kernel = shader.FindKernel("CopyRaw");
            uint[] values = Numbers(i => (uint)i * 11), result = new uint[Count];
            using (GraphicsBuffer input = new GraphicsBuffer(GraphicsBuffer.Target.Raw, Count, 4),
                output = new GraphicsBuffer(GraphicsBuffer.Target.Raw, Count, 4))
            {
                input.SetData(values);
                shader.SetInt("_Count", Count);
                shader.SetBuffer(kernel, "_InRaw", input);
                shader.SetBuffer(kernel, "_OutRaw", output);
                shader.Dispatch(kernel, 3, 1, 1);
                output.GetData(result);
            }
            Assert.That(result, Is.EqualTo(values));
        }

        [Test]
        public void Compute_buffers_do_the_same()
        {
            ComputeShader shader = Compute("Strides");
            int kernel = shader.FindKernel("CopyUint");
            uint[] values = Numbers(i => (uint)i), result = new uint[Count];
            using (ComputeBuffer input = new ComputeBuffer(Count, 4), output = new ComputeBuffer(Count, 4, ComputeBufferType.Structured))
            {
                input.SetData(values);
                shader.SetInt("_Count", Count);
                shader.SetBuffer(kernel, "_InUint", input);
                shader.SetBuffer(kernel, "_OutUint", output);
                shader.Dispatch(kernel, 3, 1, 1);
                output.GetData(result);
            }
            Assert.That(result, Is.EqualTo(values));
        }

        [Test]
        public void Ranges_of_set_and_get_touch_only_their_elements()
        {
            using (GraphicsBuffer buffer = Structured(10, 4))
            {
                buffer.SetData(new uint[] { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9 });
                buffer.SetData(new uint[] { 100, 101, 102, 103 }, 1, 4, 2);
                buffer.SetData(new List<uint> { 200, 201, 202 }, 2, 9, 1);
                using (var native = new NativeArray<uint>(new uint[] { 300, 301, 302 }, Allocator.Temp))
                    buffer.SetData(native, 1, 0, 2);
                var all = new uint[10];
                buffer.GetData(all);
                Assert.That(all, Is.EqualTo(new uint[] { 301, 302, 2, 3, 101, 102, 6, 7, 8, 202 }));

                var part = new uint[] { 9, 9, 9, 9, 9 };
                buffer.GetData(part, 2, 4, 2);
                Assert.That(part, Is.EqualTo(new uint[] { 9, 9, 101, 102, 9 }));
            }
        }

        [Test]
        public void Data_of_another_element_size_is_taken_by_bytes()
        {
            using (GraphicsBuffer buffer = Structured(2, 16))
            {
                buffer.SetData(new float[] { 1, 2, 3, 4, 5, 6, 7, 8 });
                var vectors = new Vector4[2];
                buffer.GetData(vectors);
                Assert.That(vectors[1], Is.EqualTo(new Vector4(5, 6, 7, 8)));
            }
        }

        [Test]
        public void New_buffers_hold_garbage_in_strict_mode_and_zeros_otherwise()
        {
            using (GraphicsBuffer buffer = Structured(4, 4))
                Assert.That(MemoryMarshal.Cast<byte, uint>(buffer.Storage.ReadAll()).ToArray(), Is.All.EqualTo(BufferStorage.Garbage));
            Player.Strict = false;
            using (GraphicsBuffer buffer = Structured(4, 4))
            {
                var values = new uint[] { 1, 1, 1, 1 };
                buffer.GetData(values);
                Assert.That(values, Is.All.Zero);
            }
        }

        [Test]
        public void Appended_elements_are_counted_and_consumed_again()
        {
            ComputeShader shader = Compute("Work");
            int append = shader.FindKernel("AppendEven"), consume = shader.FindKernel("ConsumeAll");
            using (GraphicsBuffer pile = new GraphicsBuffer(GraphicsBuffer.Target.Append, 100, 4),
                count = new GraphicsBuffer(GraphicsBuffer.Target.Raw, 2, 4), values = Structured(50, 4))
            {
                pile.SetCounterValue(0);
                shader.SetInt("_Count", 100);
                shader.SetBuffer(append, "_Appended", pile);
                shader.Dispatch(append, 2, 1, 1);
                count.SetData(new uint[] { 77, 77 });
                GraphicsBuffer.CopyCount(pile, count, 4);
                var counts = new uint[2];
                count.GetData(counts);
                Assert.That(counts, Is.EqualTo(new uint[] { 77, 50 }));

                shader.SetInt("_Count", 50);
                shader.SetBuffer(consume, "_Consumed", pile);
                shader.SetBuffer(consume, "_Values", values);
                values.SetData(new uint[50]);
                shader.Dispatch(consume, 1, 1, 1);
                var consumed = new uint[50];
                values.GetData(consumed);
                Assert.That(consumed.OrderBy(v => v), Is.EqualTo(Enumerable.Range(0, 50).Select(i => (uint)i * 2)));
                GraphicsBuffer.CopyCount(pile, count, 0);
                count.GetData(counts);
                Assert.That(counts[0], Is.Zero);
            }
        }

        [Test]
        public void A_counter_goes_on_from_the_value_that_was_set()
        {
            ComputeShader shader = Compute("Work");
            int kernel = shader.FindKernel("CountUp");
            using (ComputeBuffer counted = new ComputeBuffer(100, 4, ComputeBufferType.Counter),
                count = new ComputeBuffer(1, 4, ComputeBufferType.Raw))
            {
                counted.SetCounterValue(10);
                shader.SetInt("_Count", 30);
                shader.SetBuffer(kernel, "_Counted", counted);
                shader.Dispatch(kernel, 1, 1, 1);
                ComputeBuffer.CopyCount(counted, count, 0);
                var value = new uint[1];
                count.GetData(value);
                Assert.That(value[0], Is.EqualTo(40));
            }
        }

        [Test]
        public void A_locked_range_is_uploaded_when_it_is_unlocked()
        {
            using (var buffer = new GraphicsBuffer(GraphicsBuffer.Target.Structured, GraphicsBuffer.UsageFlags.LockBufferForWrite, 8, 4))
            {
                buffer.SetData(new uint[8]);
                NativeArray<uint> range = buffer.LockBufferForWrite<uint>(2, 3);
                range[0] = 5;
                range[1] = 6;
                buffer.UnlockBufferAfterWrite<uint>(2);
                var all = new uint[8];
                buffer.GetData(all);
                Assert.That(all, Is.EqualTo(new uint[] { 0, 0, 5, 6, 0, 0, 0, 0 }));
            }
        }

        [Test]
        public void Buffers_are_copied_whole()
        {
            using (GraphicsBuffer source = Structured(4, 4, GraphicsBuffer.Target.CopySource),
                target = Structured(4, 4, GraphicsBuffer.Target.CopyDestination))
            {
                source.SetData(new uint[] { 1, 2, 3, 4 });
                Graphics.CopyBuffer(source, target);
                var values = new uint[4];
                target.GetData(values);
                Assert.That(values, Is.EqualTo(new uint[] { 1, 2, 3, 4 }));
            }
        }

        [Test]
        public void Disposing_twice_is_harmless_and_frees_once()
        {
            int before = LiveObjects.Count;
            GraphicsBuffer buffer = Structured(4, 4);
            buffer.name = "Twice";
            Assert.That(LiveObjects.Report().Last(), Does.Contain("Twice"));
            Assert.That(BufferStorage.Live.Last().Name, Is.EqualTo("Twice"));
            buffer.Dispose();
            buffer.Release();
            Assert.That(buffer.IsValid(), Is.False);
            Assert.That(LiveObjects.Count, Is.EqualTo(before));
        }

        [Test]
        public void A_buffer_that_is_dropped_is_reported_and_freed_at_the_next_frame()
        {
            Player.Strict = false;      // in strict mode the run would count it as left behind
            int before = LiveObjects.Count;
            Drop();
            for (int i = 0; i < 10 && LiveObjects.Count > before; i++)
            {
                GC.Collect();
                GC.WaitForPendingFinalizers();
                Frame();
            }
            Assert.That(LiveObjects.Count, Is.EqualTo(before));
            Assert.That(Logged, Has.Some.Contains("GarbageCollector disposing of GraphicsBuffer").And.Some.Contains("Dropped"));
        }

        [System.Runtime.CompilerServices.MethodImpl(System.Runtime.CompilerServices.MethodImplOptions.NoInlining)]
        static void Drop() => new GraphicsBuffer(GraphicsBuffer.Target.Structured, 4, 4).name = "Dropped";

        [Test]
        public void Without_compute_shaders_a_buffer_refuses_by_name()
        {
            Player.PretendNoCompute = true;
            Assert.That(SystemInfo.supportsComputeShaders, Is.False);
            var error = Assert.Throws<InvalidOperationException>(() => Structured(4, 4));
            Assert.That(error.Message, Does.Contain("GraphicsBuffer(4, 4)").And.Contain("supportsComputeShaders"));
        }
    }
}
