using System;
using System.Collections.Generic;
using NUnit.Framework;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Host.Tests
{
    public class GraphicsReadbackTests : GraphicsFixture
    {
        GraphicsBuffer buffer;

        [SetUp]
        public void CreateBuffer()
        {
            buffer = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 8, 4) { name = "Source" };
            buffer.SetData(new uint[] { 0, 1, 2, 3, 4, 5, 6, 7 });
        }

        [TearDown]
        public void ReleaseBuffer() => buffer.Dispose();

        [Test]
        public void A_request_is_done_at_the_beginning_of_the_second_frame_after_it_and_for_that_frame_only()
        {
            int called = 0;
            AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(buffer, r =>
            {
                called++;
                Assert.That(r.GetData<uint>()[7], Is.EqualTo(7));
            });
            Player.Device.WaitIdle();
            Assert.That(request.done, Is.False, "in its own frame");
            Assert.That(Assert.Throws<InvalidOperationException>(() => request.GetData<uint>()).Message,
                Does.Contain("Source").And.Contain("second frame"));
            Frame();
            Assert.That(request.done, Is.False, "in the next frame");
            Frame();
            Assert.That(request.done, Is.True);
            Assert.That(request.hasError, Is.False);
            Assert.That(called, Is.EqualTo(1));
            NativeArray<uint> data = request.GetData<uint>();
            Assert.That(data.ToArray(), Is.EqualTo(new uint[] { 0, 1, 2, 3, 4, 5, 6, 7 }));
            Frame();
            Assert.That(request.hasError, Is.True);
            Assert.That(Assert.Throws<InvalidOperationException>(() => request.GetData<uint>()).Message,
                Does.Contain("Source").And.Contain("frame in which it arrived"));
            Assert.That(() => data[0], Throws.Exception, "the array's memory went with the frame");
            Assert.That(called, Is.EqualTo(1));
        }

        [Test]
        public void A_request_that_fails_as_on_a_lost_device_is_done_with_an_error_calls_back_once_and_has_no_data()
        {
            int called = 0;
            ReadbackQueue.Fails = source => source.Contains("Source");
            var other = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 1, 4) { name = "Other" };
            other.SetData(new uint[] { 9 });
            AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(buffer, r =>
            {
                called++;
                Assert.That((r.done, r.hasError), Is.EqualTo((true, true)));
                Assert.That(Assert.Throws<InvalidOperationException>(() => r.GetData<uint>()).Message,
                    Does.Contain("Source").And.Contain("ended with an error"));
            });
            AsyncGPUReadbackRequest unharmed = AsyncGPUReadback.Request(other);
            Assert.That(request.hasError, Is.False, "while it is pending");
            AsyncGPUReadback.WaitAllRequests();
            Assert.That((request.done, request.hasError, called), Is.EqualTo((true, true, 1)));
            Assert.That(unharmed.GetData<uint>()[0], Is.EqualTo(9));

            var array = new NativeArray<uint>(8, Allocator.Persistent);
            AsyncGPUReadbackRequest into = AsyncGPUReadback.RequestIntoNativeArray(ref array, buffer);
            into.WaitForCompletion();
            Assert.That((into.done, into.hasError), Is.EqualTo((true, true)));
            Assert.That(array.ToArray(), Is.EqualTo(new uint[8]), "left as it was");
            array.Dispose();
            Frame();
            Assert.That(called, Is.EqualTo(1));
            other.Dispose();
            PlayerLoop.Reset();
            Assert.That(ReadbackQueue.Fails, Is.Null, "the next test fails by itself");
        }

        [Test]
        public void Updates_alone_bring_a_request_that_the_device_has_finished()
        {
            int called = 0;
            AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(buffer, r => called++);
            request.Update();       // submits it
            Player.Device.WaitIdle();
            request.Update();
            Assert.That((request.done, request.hasError, called), Is.EqualTo((true, false, 1)));
            Assert.That(request.GetData<uint>()[6], Is.EqualTo(6));
            request.Update();
            Frame();
            Frame();
            Assert.That(called, Is.EqualTo(1), "it does not arrive again");
        }

        /// <summary>A device's copy that arrives when the test decides, and that must not be waited for.</summary>
        sealed class PendingCopy : DeviceReadback
        {
            public bool Arrived;
            public override bool IsDone => Arrived;
            public override void Wait() => Assert.Fail("an update waits for nothing");
            public override ReadOnlySpan<byte> Data => Arrived ? new byte[4] : throw new InvalidOperationException("read before it arrived");
            public override void Dispose() { }
        }

        [Test]
        public void An_update_waits_for_nothing()
        {
            var copies = new[] { new PendingCopy { Arrived = true }, new PendingCopy() };
            var request = new AsyncGPUReadbackRequest(new ReadbackRequest { LayerCount = 2, LayerBytes = 4, Source = "pending" });
            request.Request.Copies.AddRange(copies);
            request.Update();
            Assert.That(request.done, Is.False, "one of two has arrived");
            copies[1].Arrived = true;
            request.Update();
            Assert.That(request.done, Is.True);
            request.Request.Expire();
        }

        [Test]
        public void The_data_is_of_the_time_of_the_request()
        {
            AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(buffer);
            buffer.SetData(new uint[] { 99, 99, 99, 99, 99, 99, 99, 99 });
            request.WaitForCompletion();
            Assert.That(request.done, Is.True);
            Assert.That(request.GetData<uint>()[3], Is.EqualTo(3));
        }

        [Test]
        public void A_range_is_in_bytes_size_first()
        {
            AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(buffer, 8, 12);
            request.WaitForCompletion();
            Assert.That(request.GetData<uint>().ToArray(), Is.EqualTo(new uint[] { 3, 4 }));
            Assert.That(request.layerDataSize, Is.EqualTo(8));
            Assert.That(Assert.Throws<ArgumentException>(() => AsyncGPUReadback.Request(buffer, 8, 28)).Message,
                Does.Contain("Source").And.Contain("32"));
        }

        [Test]
        public void A_native_array_is_filled_and_stays()
        {
            var target = new NativeArray<uint>(8, Allocator.Persistent);
            try
            {
                AsyncGPUReadbackRequest request = AsyncGPUReadback.RequestIntoNativeArray(ref target, buffer);
                Frame();
                Assert.That(target[5], Is.Zero);
                Frame();
                Assert.That(request.done && !request.hasError, Is.True);
                Frame();
                Frame();
                Assert.That(target[5], Is.EqualTo(5));
                Assert.That(request.hasError, Is.False);
            }
            finally
            {
                target.Dispose();
            }
        }

        [Test]
        public void Requests_complete_in_order_and_waiting_for_all_completes_them_now()
        {
            var order = new List<int>();
            for (int i = 0; i < 3; i++)
            {
                int which = i;
                AsyncGPUReadback.Request(buffer, r => order.Add(which));
            }
            AsyncGPUReadback.WaitAllRequests();
            Assert.That(order, Is.EqualTo(new[] { 0, 1, 2 }));
            Frame();
            Frame();
            Assert.That(order.Count, Is.EqualTo(3));
        }

        [Test]
        public void A_command_buffer_requests_when_it_executes()
        {
            uint seen = 0;
            using (var cmd = new CommandBuffer())
            {
                cmd.RequestAsyncReadback(buffer, 4, 8, r => seen = r.GetData<uint>()[0]);
                Frame();
                Frame();
                Assert.That(seen, Is.Zero);
                Graphics.ExecuteCommandBuffer(cmd);
                Frame();
                Assert.That(seen, Is.Zero);
                Frame();
                Assert.That(seen, Is.EqualTo(2));
            }
        }

        [Test]
        public void Part_of_a_texture_comes_in_the_format_that_was_asked_for()
        {
            var texture = new Texture2D(4, 4, TextureFormat.RGBA32, false, true);
            for (int i = 0; i < 16; i++)
                texture.SetPixel(i % 4, i / 4, new Color32((byte)i, 0, 0, 255));
            texture.Apply();
            AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(texture, 0, 1, 2, 2, 2, 0, 1, TextureFormat.RFloat);
            request.WaitForCompletion();
            Assert.That(request.width, Is.EqualTo(2));
            float[] values = request.GetData<float>().ToArray();
            Assert.That(Array.ConvertAll(values, v => Mathf.RoundToInt(v * 255)), Is.EqualTo(new[] { 9, 10, 13, 14 }));
            UnityEngine.Object.DestroyImmediate(texture);
        }

        [Test]
        public void A_callback_that_throws_does_not_keep_the_others_from_arriving()
        {
            LogAssert.Expect(LogType.Exception, "InvalidOperationException: planted");
            bool second = false;
            AsyncGPUReadback.Request(buffer, r => throw new InvalidOperationException("planted"));
            AsyncGPUReadback.Request(buffer, r => second = true);
            Frame();
            Frame();
            Assert.That(second, Is.True);
            Assert.That(Logged, Has.Some.Contains("planted"));
        }
    }
}
