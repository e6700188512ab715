using System;
using System.Collections.Generic;
using System.Linq;
using System.Runtime.InteropServices;
using Host.Vulkan;
using NUnit.Framework;
using UnityEngine.Headless;
using static Host.Tests.VulkanShaders;
using static UnityEngine.Headless.ShaderResourceKind;

namespace Host.Tests
{
    /// <summary>The device below IGraphicsDevice. Every test runs under the validation layer, which must stay silent, and must leave
    /// nothing alive.</summary>
    [TestFixture]
    public class VulkanDeviceTests
    {
        const uint Garbage = 0xCDCDCDCD;
        VulkanDevice device;
        List<DeviceResource> made;

        [SetUp]
        public void SetUp()
        {
            device = new VulkanDevice(validation: true);
            made = new List<DeviceResource>();
        }

        [TearDown]
        public void TearDown()
        {
            foreach (var resource in made) resource.Dispose();
            device.WaitIdle();
            int left = device.LiveResources;
            device.Dispose();
            Assert.That(device.ValidationMessages, Is.Empty, string.Join("\n", device.ValidationMessages));
            Assert.That(left, Is.EqualTo(0), "objects left on the GPU");
        }

        // ---- buffers

        [Test]
        public void The_device_says_who_it_is_and_what_it_can_do()
        {
            var info = device.Info;
            Assert.That(info.Name, Is.Not.Empty);
            Assert.That(info.Driver, Is.Not.Empty);
            Assert.That(info.MaxBufferBytes, Is.GreaterThanOrEqualTo(128L << 20));
            Assert.That(info.MaxGroupsharedBytes, Is.GreaterThanOrEqualTo(32 << 10));
            Assert.That(info.MaxGroupInvocations, Is.GreaterThanOrEqualTo(1024));
            Assert.That(info.MemoryBytes, Is.GreaterThan(0));
            Assert.That(info.SubgroupSize, Is.GreaterThan(0));
        }

        [Test]
        public void A_device_that_is_not_there_is_refused_with_the_names_of_those_that_are()
        {
            var error = Assert.Throws<InvalidOperationException>(() => new VulkanDevice(deviceName: "Voodoo 2"));
            Assert.That(error.Message, Does.Contain("Voodoo 2").And.Contain(device.Info.Name));
        }

        [TestCase(0, 16, 1)]
        [TestCase(1, 5, 2)]
        [TestCase(7, 1, 3)]
        [TestCase(13, 100, 29)]
        public void Bytes_uploaded_and_copied_at_odd_offsets_are_read_back_and_their_neighbors_stay(int offset, int bytes, int targetOffset)
        {
            var (a, b) = (Buffer(256), Buffer(256));
            byte[] data = Enumerable.Range(1, bytes).Select(i => (byte)i).ToArray();
            device.Upload(a, offset, data);
            device.Copy(a, offset, b, targetOffset, bytes);

            var expected = Enumerable.Repeat((byte)0xCD, 256).ToArray();
            data.CopyTo(expected, targetOffset);
            Assert.That(Bytes(b, 0, 256), Is.EqualTo(expected));
            Assert.That(Bytes(b, targetOffset, bytes), Is.EqualTo(data));
        }

        [Test]
        public void A_fill_sets_its_words_alone()
        {
            var buffer = Buffer(64);
            device.Fill(buffer, 8, 12, 42);
            var expected = Enumerable.Repeat(Garbage, 16).ToArray();
            expected[2] = expected[3] = expected[4] = 42;
            Assert.That(UInts(buffer), Is.EqualTo(expected));
        }

        [Test]
        public void An_upload_larger_than_a_piece_of_staging_memory_arrives_whole()
        {
            int words = (32 << 18) + 12345;
            var buffer = Buffer(words * 4L);
            var data = new uint[words];
            for (int i = 0; i < words; i++) data[i] = (uint)i * 2654435761;
            device.Upload(buffer, 0, MemoryMarshal.AsBytes(data.AsSpan()));
            Assert.That(UInts(buffer).AsSpan().SequenceEqual(data), Is.True);
        }

        [Test]
        public void What_lies_outside_of_a_buffer_is_refused_by_name()
        {
            var buffer = Buffer(64, "Positions");
            var error = Assert.Throws<ArgumentOutOfRangeException>(() => device.Fill(buffer, 60, 8, 0));
            Assert.That(error.Message, Does.Contain("Positions").And.Contain("64"));
            Assert.Throws<ArgumentOutOfRangeException>(() => device.Read(buffer, -4, new byte[4]));
        }

        [Test]
        public void A_buffer_that_does_not_fit_is_refused_with_its_name_and_size()
        {
            var error = Assert.Throws<OutOfGpuMemoryException>(() => device.CreateBuffer("Everything", 1L << 50));
            Assert.That(error.Message, Does.Contain("Everything").And.Contain($"{1L << 50:N0}"));
        }

        [Test]
        public void Uploads_act_between_the_dispatches_that_surround_them()
        {
            var add = Kernel(Add());
            var buffer = Buffer(4);
            device.Upload(buffer, 0, new byte[] { 5, 0, 0, 0 });
            device.Dispatch(add, Bind(buffer), 1, 1, 1);
            var before = device.BeginReadback(buffer, 0, 4);
            device.Upload(buffer, 0, new byte[] { 100, 0, 0, 0 });
            device.Dispatch(add, Bind(buffer), 1, 1, 1);
            Assert.That(UInts(buffer)[0], Is.EqualTo(101));
            Assert.That(before.Data[0], Is.EqualTo(6));
            before.Dispose();
        }

        // ---- compute

        [Test]
        public void A_dispatch_sees_what_the_thousand_before_it_wrote()
        {
            const int n = 4096;
            // Each step moves every value one place on and adds one, so that a lost or early step shows.
            var kernel = Kernel(Compute("Shift", 64, @"
                layout(std430, binding = 0) readonly buffer A { uint a[]; };
                layout(std430, binding = 1) buffer B { uint b[]; };
                void main() { uint i = gl_GlobalInvocationID.x; b[i] = a[(i + 1) % 4096] + 1; }", Resource("A", StructuredBuffer), Resource("B", RWStructuredBuffer)));
            var (a, b) = (Buffer(n * 4), Buffer(n * 4));
            var data = new uint[n];
            for (int i = 0; i < n; i++) data[i] = (uint)i * 7919;
            device.Upload(a, 0, MemoryMarshal.AsBytes(data.AsSpan()));
            for (int step = 0; step < 1000; step++)
            {
                device.Dispatch(kernel, Bind(a, b), n / 64, 1, 1);
                (a, b) = (b, a);
            }
            uint[] expected = Enumerable.Range(0, n).Select(i => data[(i + 1000) % n] + 1000).ToArray();
            Assert.That(UInts(a), Is.EqualTo(expected));
        }

        [Test]
        public void Dispatches_across_many_submissions_stay_in_order()
        {
            var add = Kernel(Add());
            var buffer = Buffer(4);
            device.Fill(buffer, 0, 4, 0);
            for (int i = 0; i < 300; i++)
            {
                device.Dispatch(add, Bind(buffer), 1, 1, 1);
                if (i % 3 == 0) device.Flush();
            }
            Assert.That(UInts(buffer)[0], Is.EqualTo(300));
        }

        [Test]
        public void A_barrier_stands_only_between_dispatches_that_fraction_what_one_of_them_writes()
        {
            var copy = Kernel(Compute("Copy", 1, @"
                layout(std430, binding = 0) readonly buffer A { uint a[]; };
                layout(std430, binding = 1) buffer B { uint b[]; };
                void main() { b[0] = a[0]; }", Resource("A", RWStructuredBuffer), Resource("B", RWStructuredBuffer)));
            var (a, b, c) = (Buffer(4), Buffer(4), Buffer(4));
            var d = Buffer(4);
            long Cost(DeviceBuffer from, DeviceBuffer to)
            {
                long before = device.BarrierCount;
                device.Dispatch(copy, Bind(from, to), 1, 1, 1);
                return device.BarrierCount - before;
            }
            Assert.That(Cost(a, b), Is.EqualTo(1), "after the fills");
            Assert.That(Cost(a, c), Is.EqualTo(0), "both read a, although declared RW: the kernel never writes it");
            Assert.That(Cost(b, d), Is.EqualTo(1), "b was just written");
            Assert.That(Cost(c, b), Is.EqualTo(1), "b was just read");
            Assert.That(Cost(a, c), Is.EqualTo(1), "c was just read");
            Assert.That(Cost(a, d), Is.EqualTo(0), "d was written before the barrier that is there");
            device.Flush();
            Assert.That(Cost(a, d), Is.EqualTo(1), "a submission is not a barrier");
        }

        [Test]
        public void Reads_past_the_end_give_zero_and_writes_past_it_vanish()
        {
            var kernel = Kernel(Compute("Outside", 1, @"
                layout(std430, binding = 0) buffer A { uint a[]; };
                layout(std430, binding = 1) buffer B { uint b[]; };
                void main() { b[0] = a[16]; b[1] = a[100000]; b[2] = a[15]; a[16] = 1; a[17] = 2; a[5000] = 3; b[100] = 4; }", Resource("A", RWStructuredBuffer), Resource("B", RWStructuredBuffer)));
            var (a, b) = (Buffer(64), Buffer(64));
            device.Dispatch(kernel, Bind(a, b), 1, 1, 1);
            Assert.That(UInts(b).Take(4), Is.EqualTo(new[] { 0u, 0u, Garbage, Garbage }));
            Assert.That(UInts(a), Is.All.EqualTo(Garbage));
        }

        [Test]
        public void A_window_of_a_buffer_ends_where_it_says()
        {
            var kernel = Kernel(Compute("Window", 1, @"
                layout(std430, binding = 0) readonly buffer A { uint a[]; };
                layout(std430, binding = 1) buffer B { uint b[]; };
                void main() { b[0] = a[0]; b[1] = a[63]; b[2] = a[64]; }", Resource("A", StructuredBuffer), Resource("B", RWStructuredBuffer)));
            var (a, b) = (Buffer(1024), Buffer(16));
            var data = Enumerable.Range(0, 256).Select(i => (uint)i + 1).ToArray();
            device.Upload(a, 0, MemoryMarshal.AsBytes(data.AsSpan()));
            device.Dispatch(kernel, new[] { new DeviceBinding { Buffer = a, Offset = 256, Bytes = 256 }, new DeviceBinding { Buffer = b } }, 1, 1, 1);
            Assert.That(UInts(b).Take(3), Is.EqualTo(new[] { 65u, 128u, 0u }));
        }

        [Test]
        public void Null_buffers_textures_and_constants_read_zero_and_swallow_writes()
        {
            var kernel = Kernel(Compute("Nothing", 1, @"
                layout(std430, binding = 0) buffer A { uint a[]; };
                layout(binding = 1) uniform texture2D t;
                layout(binding = 2, r32f) uniform image2D i;
                layout(binding = 3) uniform C { uint c; };
                layout(std430, binding = 4) buffer B { uint b[]; };
                void main()
                {
                    a[0] = 7; imageStore(i, ivec2(0), vec4(7));
                    b[0] = a[1]; b[1] = floatBitsToUint(texelFetch(t, ivec2(0), 0).x); b[2] = floatBitsToUint(imageLoad(i, ivec2(1, 0)).x); b[3] = c;
                }", Resource("A", RWStructuredBuffer), Resource("T", Texture), Resource("I", RWTexture), Resource("C", ConstantBuffer), Resource("B", RWStructuredBuffer)));
            var b = Buffer(16);
            device.Dispatch(kernel, new[] { new DeviceBinding(), new DeviceBinding(), new DeviceBinding(), new DeviceBinding(),
                new DeviceBinding { Buffer = b } }, 1, 1, 1);
            Assert.That(UInts(b), Is.All.EqualTo(0));
        }

        [Test]
        public void Constants_are_those_of_their_own_dispatch()
        {
            var kernel = Kernel(Compute("Store", 1, @"
                layout(binding = 0) uniform C { uint index; uint value; };
                layout(std430, binding = 1) buffer B { uint b[]; };
                void main() { b[index] = value; }", Resource("C", ConstantBuffer), Resource("B", RWStructuredBuffer)));
            var b = Buffer(4000);
            var constants = new byte[16];
            for (int i = 0; i < 1000; i++)
            {
                BitConverter.TryWriteBytes(constants, i);
                BitConverter.TryWriteBytes(constants.AsSpan(4), i * i);
                device.Dispatch(kernel, new[] { new DeviceBinding { Constants = constants, ConstantsLength = 8 },
                    new DeviceBinding { Buffer = b } }, 1, 1, 1);
            }
            Assert.That(UInts(b), Is.EqualTo(Enumerable.Range(0, 1000).Select(i => (uint)(i * i)).ToArray()));
        }

        [Test]
        public void A_constant_buffer_can_be_a_buffer_that_a_dispatch_wrote()
        {
            var add = Kernel(Add());
            var store = Kernel(Compute("Show", 1, @"
                layout(binding = 0) uniform C { uint value; };
                layout(std430, binding = 1) buffer B { uint b[]; };
                void main() { b[0] = value; }", Resource("C", ConstantBuffer), Resource("B", RWStructuredBuffer)));
            var (c, b) = (Buffer(256), Buffer(4));
            device.Fill(c, 0, 256, 41);
            device.Dispatch(add, Bind(c), 1, 1, 1);
            device.Dispatch(store, Bind(c, b), 1, 1, 1);
            Assert.That(UInts(b)[0], Is.EqualTo(42));
        }

        [Test]
        public void Group_counts_written_on_the_GPU_are_those_dispatched()
        {
            var write = Kernel(Compute("Arguments", 1, @"
                layout(std430, binding = 0) buffer A { uint a[]; };
                void main() { a[1] = 3; a[2] = 5; a[3] = 2; }", Resource("A", RWStructuredBuffer)));
            var count = Kernel(Compute("Count", 1, @"
                layout(std430, binding = 0) buffer A { uint a[]; };
                void main() { atomicAdd(a[0], 1); }", Resource("A", RWStructuredBuffer)));
            var (arguments, result) = (Buffer(16), Buffer(4));
            device.Fill(arguments, 0, 16, 0);
            device.Fill(result, 0, 4, 0);
            device.Dispatch(write, Bind(arguments), 1, 1, 1);
            device.DispatchIndirect(count, Bind(result), arguments, 4);
            Assert.That(UInts(result)[0], Is.EqualTo(30));
        }

        [Test]
        public void Typed_buffers_load_and_store_their_elements()
        {
            var kernel = Kernel(Compute("Typed", 1, @"
                layout(binding = 0) uniform utextureBuffer a;
                layout(binding = 1, r32ui) uniform uimageBuffer b;
                void main() { imageStore(b, 1, uvec4(texelFetch(a, 2).x + 1)); }", Resource("A", TypedBuffer), Resource("B", RWTypedBuffer)));
            var (a, b) = (Buffer(16), Buffer(16));
            device.Fill(a, 8, 4, 41);
            device.Dispatch(kernel, Bind(a, b), 1, 1, 1);
            Assert.That(UInts(b), Is.EqualTo(new[] { Garbage, 42u, Garbage, Garbage }));
        }

        [Test]
        public void A_released_buffer_is_refused_by_name()
        {
            var kernel = Kernel(Add());
            var buffer = device.CreateBuffer("Density", 16);
            buffer.Dispose();
            var error = Assert.Throws<ObjectDisposedException>(() => device.Dispatch(kernel, Bind(buffer), 1, 1, 1));
            Assert.That(error.Message, Does.Contain("Density").And.Contain("Add"));
        }

        [Test]
        public void A_buffer_released_while_the_stream_needs_it_does_its_work_first()
        {
            var add = Kernel(Add());
            var result = Buffer(4);
            for (int i = 0; i < 20; i++)
            {
                var passing = device.CreateBuffer("Passing", 4);
                device.Fill(passing, 0, 4, (uint)i);
                device.Dispatch(add, Bind(passing), 1, 1, 1);
                device.Copy(passing, 0, result, 0, 4);
                passing.Dispose();
            }
            Assert.That(UInts(result)[0], Is.EqualTo(20));
        }

        // ---- reading later

        [Test]
        public void A_readback_holds_what_the_buffer_held_when_it_was_asked_for()
        {
            var buffer = Buffer(4);
            var readbacks = new List<DeviceReadback>();
            for (uint i = 0; i < 49; i++)
            {
                device.Fill(buffer, 0, 4, i);
                readbacks.Add(device.BeginReadback(buffer, 0, 4));
                if (i % 7 == 0) device.Flush();     // the last one is not submitted
            }
            Assert.That(readbacks[48].IsDone, Is.False, "not submitted yet");
            device.WaitIdle();
            for (int i = 0; i < 49; i++)
            {
                Assert.That(readbacks[i].IsDone, Is.True);
                Assert.That(BitConverter.ToInt32(readbacks[i].Data.ToArray(), 0), Is.EqualTo(i));
                readbacks[i].Dispose();
            }
        }

        [Test]
        public void Ten_thousand_resources_come_and_go_and_nothing_is_left()
        {
            int before = device.LiveResources;
            for (int i = 0; i < 10000; i++)
            {
                var buffer = device.CreateBuffer("Brief", 64 + i % 7 * 1000);
                if (i % 2 == 0) device.Fill(buffer, 0, 64, 1);
                if (i % 5 == 0) device.BeginReadback(buffer, 0, 64).Dispose();
                buffer.Dispose();
                buffer.Dispose();
            }
            device.WaitIdle();
            Assert.That(device.LiveResources, Is.EqualTo(before));
        }

        // ---- textures

        [Test]
        public void A_volume_written_by_a_kernel_is_sampled_with_a_linear_filter()
        {
            var write = Kernel(Compute("WriteVolume", 1, @"
                layout(binding = 0, r32f) uniform image3D v;
                void main() { ivec3 p = ivec3(gl_WorkGroupID); imageStore(v, p, vec4(p.x + 10 * p.y + 100 * p.z)); }",
                Resource("V", RWTexture, DeviceTextureDimension.Tex3D)));
            var sample = Kernel(Compute("SampleVolume", 1, @"
                layout(binding = 0) uniform texture3D v;
                layout(binding = 1) uniform sampler s;
                layout(std430, binding = 2) buffer B { float b[]; };
                void main() { b[0] = textureLod(sampler3D(v, s), vec3(0.5), 0).x; b[1] = textureLod(sampler3D(v, s), vec3(-3, 0.125, 0.125), 0).x; }",
                Resource("V", Texture, DeviceTextureDimension.Tex3D), Resource("S", Sampler), Resource("B", RWStructuredBuffer)));
            var volume = NewTexture(DeviceFormat.R32_Float, 4, 4, 4, randomWrite: true);
            var b = Buffer(8);
            device.Dispatch(write, new[] { new DeviceBinding { Texture = volume } }, 4, 4, 4);
            var sampler = new DeviceSampler { Linear = true, U = DeviceWrap.Clamp, V = DeviceWrap.Clamp, W = DeviceWrap.Clamp };
            device.Dispatch(sample, new[] { new DeviceBinding { Texture = volume }, new DeviceBinding { Sampler = sampler },
                new DeviceBinding { Buffer = b } }, 1, 1, 1);
            float[] got = MemoryMarshal.Cast<uint, float>(UInts(b)).ToArray();
            Assert.That(got[0], Is.EqualTo(1.5f * 111).Within(0.5), "the mean of the eight texels around the center");
            Assert.That(got[1], Is.EqualTo(0).Within(1e-5), "clamped to the first texel");
            float[] texels = MemoryMarshal.Cast<byte, float>(device.ReadTexture(volume, 0, 0)).ToArray();
            Assert.That(texels, Is.EqualTo(Enumerable.Range(0, 64).Select(i => (float)(i % 4 + 10 * (i / 4 % 4) + 100 * (i / 16))).ToArray()));
        }

        [Test]
        public void A_texture_level_uploaded_and_copied_is_read_back()
        {
            var (a, b) = (NewTexture(DeviceFormat.RGBA8_UNorm, 5, 3, mips: 2), NewTexture(DeviceFormat.RGBA8_UNorm, 5, 3));
            var level0 = Enumerable.Range(0, 60).Select(i => (byte)i).ToArray();
            var level1 = Enumerable.Range(100, 8).Select(i => (byte)i).ToArray();
            device.UploadTexture(a, 0, 0, level0);
            device.UploadTexture(a, 1, 0, level1);
            device.CopyTexture(a, b);
            Assert.That(device.ReadTexture(a, 1, 0), Is.EqualTo(level1));
            Assert.That(device.ReadTexture(b, 0, 0), Is.EqualTo(level0));
        }

        [Test]
        public void A_clear_reaches_every_level_and_slice_and_integers_as_integers()
        {
            var array = Keep(device.CreateTexture(new DeviceTextureDescription
            {
                Name = "Array", Dimension = DeviceTextureDimension.Tex2DArray, Format = DeviceFormat.R32_UInt, Width = 4, Height = 4,
                    Slices = 3, Mips = 2,
            }));
            device.ClearTexture(array, new DeviceColor { R = 77 });
            for (int slice = 0; slice < 3; slice++)
                for (int mip = 0; mip < 2; mip++)
                    Assert.That(MemoryMarshal.Cast<byte, uint>(device.ReadTexture(array, mip, slice)).ToArray(), Is.All.EqualTo(77));
        }

        // ---- raster

        [Test]
        public void The_top_of_clip_space_is_the_first_row()
        {
            var target = NewTexture(DeviceFormat.RGBA8_UNorm, 8, 8, target: true);
            // Covers x < 0, y > 0: a quarter of the target as two triangles.
            var pass = Pass(Positions("vec2(-1, 1), vec2(0, 1), vec2(0, 0), vec2(-1, 1), vec2(0, 0), vec2(-1, 0)", "0.5"), White());
            Begin(target, null);
            device.Draw(pass, State(DeviceCull.Off), Array.Empty<DeviceBinding>(), new DeviceDraw { VertexCount = 6, InstanceCount = 1 });
            device.EndPass();
            AssertPixels(target, (x, y) => x < 4 && y < 4);
        }

        [TestCase(true)]
        [TestCase(false)]
        public void Clockwise_faces_face_the_front(bool clockwise)
        {
            var target = NewTexture(DeviceFormat.RGBA8_UNorm, 8, 8, target: true);
            // Clip y is up: top left, top right, bottom right turns clockwise as one looks at the picture.
            var pass = Pass(Positions(clockwise ? "vec2(-1, 1), vec2(3, 1), vec2(-1, -3)" : "vec2(-1, 1), vec2(-1, -3), vec2(3, 1)", "0.5"), White());
            Begin(target, null);
            device.Draw(pass, State(DeviceCull.Back), Array.Empty<DeviceBinding>(), new DeviceDraw { VertexCount = 3, InstanceCount = 1 });
            device.EndPass();
            AssertPixels(target, (x, y) => clockwise);
        }

        [Test]
        public void A_viewport_confines_what_is_drawn()
        {
            var target = NewTexture(DeviceFormat.RGBA8_UNorm, 8, 8, target: true);
            var pass = Pass(Positions("vec2(-1, 1), vec2(3, 1), vec2(-1, -3)", "0.5"), White());
            device.BeginPass(new DeviceTargets { Color0 = target, ColorCount = 1, ClearColor = true, ViewportX = 2, ViewportY = 1,
                ViewportWidth = 3, ViewportHeight = 4 });
            device.Draw(pass, State(DeviceCull.Off), Array.Empty<DeviceBinding>(), new DeviceDraw { VertexCount = 3, InstanceCount = 1 });
            device.EndPass();
            AssertPixels(target, (x, y) => x >= 2 && x < 5 && y >= 1 && y < 5);
        }

        [Test]
        public void With_reversed_depth_the_nearer_hides_the_farther_whatever_the_order()
        {
            var (target, depth) = (NewTexture(DeviceFormat.RGBA8_UNorm, 8, 8, target: true), NewTexture(DeviceFormat.D32_Float, 8, 8, target: true));
            var near = Pass(Positions("vec2(-1, 1), vec2(3, 1), vec2(-1, -3)", "0.75"), White());
            var far = Pass(Positions("vec2(-1, 1), vec2(3, 1), vec2(-1, -3)", "0.25"),
                Fragment("Red", "layout(location = 0) out vec4 c; void main() { c = vec4(1, 0, 0, 1); }"));
            var state = State(DeviceCull.Off);
            (state.DepthTest, state.DepthWrite) = (DeviceCompare.GreaterEqual, true);
            Begin(target, depth);
            device.Draw(near, state, Array.Empty<DeviceBinding>(), new DeviceDraw { VertexCount = 3, InstanceCount = 1 });
            device.Draw(far, state, Array.Empty<DeviceBinding>(), new DeviceDraw { VertexCount = 3, InstanceCount = 1 });
            device.EndPass();
            AssertPixels(target, (x, y) => true);
            Assert.That(MemoryMarshal.Cast<byte, float>(device.ReadTexture(depth, 0, 0)).ToArray(), Is.All.EqualTo(0.75f));
        }

        [Test]
        public void An_indirect_draw_takes_its_counts_and_positions_from_buffers_that_a_kernel_wrote()
        {
            var write = Kernel(Compute("Quad", 1, @"
                layout(std430, binding = 0) buffer A { uint a[]; };
                layout(std430, binding = 1) buffer P { vec2 p[]; };
                void main()
                {
                    a[0] = 3; a[1] = 2; a[2] = 0; a[3] = 0;
                    p[0] = vec2(-1, 1); p[1] = vec2(0, 1); p[2] = vec2(-1, 0);
                }", Resource("A", RWStructuredBuffer), Resource("P", RWStructuredBuffer)));
            var pass = Pass(Vertex("Instances", @"
                layout(std430, binding = 0) readonly buffer P { vec2 p[]; };
                void main() { gl_Position = vec4(p[gl_VertexIndex] + vec2(gl_InstanceIndex, 0), 0.5, 1); }", new int[0], Resource("P", StructuredBuffer)), White());
            var (arguments, positions) = (Buffer(16), Buffer(64));
            var target = NewTexture(DeviceFormat.RGBA8_UNorm, 8, 8, target: true);
            device.Dispatch(write, Bind(arguments, positions), 1, 1, 1);
            Begin(target, null);
            device.Draw(pass, State(DeviceCull.Off), Bind(positions), new DeviceDraw { Arguments = arguments });
            device.EndPass();
            AssertPixels(target, (x, y) => y < 4 && x % 4 + y < 3, (x, y) => y < 4 && x % 4 + y == 3);
        }

        [Test]
        public void A_mesh_is_drawn_from_its_streams_and_an_input_that_it_lacks_reads_zero()
        {
            var pass = Pass(Vertex("Mesh", @"
                layout(location = 0) in vec3 position; layout(location = 3) in vec4 color; layout(location = 5) in uvec4 bones;
                layout(location = 0) out vec4 c;
                void main() { gl_Position = vec4(position, 1); c = bones.x == 0 ? vec4(color.xyz + 1, 1) : vec4(0); }", new[] { 0, 3, 5 }),
                Fragment("Color", "layout(location = 0) in vec4 c; layout(location = 0) out vec4 o; void main() { o = c; }"));
            var (vertices, indices) = (Buffer(64), Buffer(8));
            var corners = new float[] { 9, 9, 9, -1, 1, 0.5f, 3, 1, 0.5f, -1, -3, 0.5f };   // the first 12 bytes belong to someone else
            device.Upload(vertices, 0, MemoryMarshal.AsBytes(corners.AsSpan()));
            device.Upload(indices, 0, new byte[] { 7, 0, 0, 0, 1, 0, 2, 0 });
            var target = NewTexture(DeviceFormat.RGBA8_UNorm, 8, 8, target: true);
            Begin(target, null);
            device.Draw(pass, State(DeviceCull.Back), Array.Empty<DeviceBinding>(), new DeviceDraw
            {
                VertexCount = 3, InstanceCount = 1, FirstVertex = 1, Indices = indices,
                Streams = new[] { new DeviceVertexStream { Location = 0, Buffer = vertices, Offset = 12, Stride = 12,
                    Format = DeviceFormat.RGB32_Float } },
            });
            device.EndPass();
            AssertPixels(target, (x, y) => true);
        }

        [Test]
        public void Points_whose_program_writes_no_size_cover_a_pixel_each()
        {
            var target = NewTexture(DeviceFormat.RGBA8_UNorm, 8, 8, target: true);
            var pass = Pass(Vertex("Points", "out gl_PerVertex { vec4 gl_Position; }; void main() { gl_Position = vec4((gl_VertexIndex " +
                "* 2 + 0.5) / 4 - 1, 0.875, 0.5, 1); }", new int[0]), White());
            var state = State(DeviceCull.Back);
            state.Topology = DeviceTopology.Points;
            Begin(target, null);
            device.Draw(pass, state, Array.Empty<DeviceBinding>(), new DeviceDraw { VertexCount = 4, InstanceCount = 1 });
            device.EndPass();
            AssertPixels(target, (x, y) => y == 0 && x % 2 == 0);
        }

        [Test]
        public void A_pass_interrupted_by_dispatches_and_flushes_keeps_what_it_drew()
        {
            var add = Kernel(Add());
            var count = Buffer(4);
            device.Fill(count, 0, 4, 0);
            var target = NewTexture(DeviceFormat.RGBA8_UNorm, 8, 8, target: true);
            var pass = Pass(Vertex("Column", @"
                layout(std430, binding = 0) readonly buffer C { uint n; };
                vec2 at[6] = vec2[](vec2(0, -1), vec2(0, 1), vec2(1, 1), vec2(0, -1), vec2(1, 1), vec2(1, -1));
                void main() { vec2 p = at[gl_VertexIndex]; gl_Position = vec4((p.x + float(n - 1)) / 4 - 1, p.y, 0.5, 1); }", new int[0], Resource("C", StructuredBuffer)), White());
            Begin(target, null);
            for (int i = 0; i < 8; i++)
            {
                device.Dispatch(add, Bind(count), 1, 1, 1);
                if (i % 2 == 0) device.Draw(pass, State(DeviceCull.Off), Bind(count), new DeviceDraw { VertexCount = 6, InstanceCount = 1 });
                if (i % 3 == 0) device.Flush();
            }
            device.EndPass();
            AssertPixels(target, (x, y) => x % 2 == 0);
        }

        [Test]
        public void A_draw_samples_what_the_pass_before_drew_and_a_kernel_reads_the_result()
        {
            var (a, b) = (NewTexture(DeviceFormat.RGBA8_UNorm, 8, 8, target: true), NewTexture(DeviceFormat.RGBA8_UNorm, 8, 8, target: true));
            var first = Pass(Positions("vec2(-1, 1), vec2(0, 1), vec2(0, 0), vec2(-1, 1), vec2(0, 0), vec2(-1, 0)", "0.5"), White());
            var second = Pass(Positions("vec2(-1, 1), vec2(3, 1), vec2(-1, -3)", "0.5"), Fragment("Fetch", @"
                layout(binding = 32) uniform texture2D t; layout(location = 0) out vec4 o;
                void main() { o = texelFetch(t, ivec2(gl_FragCoord.xy), 0); }", Resource("T", Texture)));
            Begin(a, null);
            device.Draw(first, State(DeviceCull.Off), Array.Empty<DeviceBinding>(), new DeviceDraw { VertexCount = 6, InstanceCount = 1 });
            device.EndPass();
            Begin(b, null);
            device.Draw(second, State(DeviceCull.Off), new[] { new DeviceBinding { Texture = a } },
                new DeviceDraw { VertexCount = 3, InstanceCount = 1 });
            device.EndPass();
            AssertPixels(b, (x, y) => x < 4 && y < 4);
            var count = Kernel(Compute("CountWhite", 1, @"
                layout(binding = 0) uniform texture2D t;
                layout(std430, binding = 1) buffer N { uint n; };
                void main() { if (texelFetch(t, ivec2(gl_WorkGroupID.xy), 0).x > 0.5) atomicAdd(n, 1); }", Resource("T", Texture), Resource("N", RWStructuredBuffer)));
            var n = Buffer(4);
            device.Fill(n, 0, 4, 0);
            device.Dispatch(count, new[] { new DeviceBinding { Texture = b }, new DeviceBinding { Buffer = n } }, 8, 8, 1);
            Assert.That(UInts(n)[0], Is.EqualTo(16));
        }

        [Test]
        public void A_texture_that_is_the_target_reads_zero_in_its_own_draw()
        {
            var target = NewTexture(DeviceFormat.RGBA8_UNorm, 8, 8, target: true);
            device.ClearTexture(target, new DeviceColor { R = 1, G = 1, B = 1, A = 1 });
            var pass = Pass(Positions("vec2(-1, 1), vec2(3, 1), vec2(-1, -3)", "0.5"), Fragment("Self", @"
                layout(binding = 32) uniform texture2D t; layout(location = 0) out vec4 o;
                void main() { o = vec4(texelFetch(t, ivec2(gl_FragCoord.xy), 0).xyz, 1); }", Resource("T", Texture)));
            device.BeginPass(new DeviceTargets { Color0 = target, ColorCount = 1 });
            device.Draw(pass, State(DeviceCull.Off), new[] { new DeviceBinding { Texture = target } },
                new DeviceDraw { VertexCount = 3, InstanceCount = 1 });
            device.EndPass();
            AssertPixels(target, (x, y) => false);
        }

        [Test]
        public void A_pass_without_draws_clears_its_targets()
        {
            var target = NewTexture(DeviceFormat.RGBA8_UNorm, 8, 8, target: true);
            device.BeginPass(new DeviceTargets { Color0 = target, ColorCount = 1, ClearColor = true,
                ClearValue = new DeviceColor { R = 1, G = 1, B = 1, A = 1 } });
            device.EndPass();
            AssertPixels(target, (x, y) => true);
        }

        [Test]
        public void Blending_adds_where_it_is_asked_to_and_the_mask_spares_a_channel()
        {
            var target = NewTexture(DeviceFormat.RGBA8_UNorm, 8, 8, target: true);
            var pass = Pass(Positions("vec2(-1, 1), vec2(3, 1), vec2(-1, -3)", "0.5"),
                Fragment("Fifth", "layout(location = 0) out vec4 c; void main() { c = vec4(0.2); }"));
            var state = State(DeviceCull.Off);
            (state.Blend, state.SrcColor, state.DstColor, state.SrcAlpha, state.DstAlpha, state.ColorMask) =
                (true, DeviceBlend.One, DeviceBlend.One, DeviceBlend.One, DeviceBlend.One, 8 | 4 | 1);
            Begin(target, null);
            for (int i = 0; i < 3; i++) device.Draw(pass, state, Array.Empty<DeviceBinding>(), new DeviceDraw { VertexCount = 3, InstanceCount = 1 });
            device.EndPass();
            Assert.That(device.ReadTexture(target, 0, 0).Take(4), Is.EqualTo(new byte[] { 153, 153, 0, 255 }));
        }

        // ---- time

        [Test]
        public void Samples_nest_and_the_outer_lasts_at_least_as_long_as_the_inner_together()
        {
            var kernel = Kernel(Compute("Work", 64, @"
                layout(std430, binding = 0) buffer A { float a[]; };
                void main() { uint i = gl_GlobalInvocationID.x; float x = i; for (int k = 0; k < 2000; k++) x = sin(x) + 1; a[i] = x; }", Resource("A", RWStructuredBuffer)));
            var buffer = Buffer(64 * 64 * 4);
            device.Timing = true;
            device.BeginSample("Step");
            for (int i = 0; i < 3; i++)
            {
                device.BeginSample("Inner" + i);
                device.Dispatch(kernel, Bind(buffer), 64, 1, 1);
                device.EndSample();
                if (i == 1) device.Flush();
            }
            device.EndSample();
            var samples = device.CollectSamples();
            Assert.That(samples.Select(s => s.Name), Is.EqualTo(new[] { "Step", "Inner0", "Inner1", "Inner2" }));
            Assert.That(samples.Select(s => s.Depth), Is.EqualTo(new[] { 0, 1, 1, 1 }));
            Assert.That(samples.Select(s => s.Milliseconds), Is.All.GreaterThan(0.001));
            Assert.That(samples[0].Milliseconds, Is.GreaterThanOrEqualTo(samples.Skip(1).Sum(s => s.Milliseconds) * 0.999));
            Assert.That(samples.Select(s => s.BeginMs), Is.Ordered);
            Assert.That(device.CollectSamples(), Is.Empty);
        }

        [Test]
        public void Samples_cost_nothing_and_leave_nothing_while_timing_is_off()
        {
            device.BeginSample("Unseen");
            device.EndSample();
            Assert.That(device.CollectSamples(), Is.Empty);
        }

        // ---- helpers

        static ShaderProgram Add() => Compute("Add", 1, "layout(std430, binding = 0) buffer A { uint a[]; }; void main() { a[0] += 1; }",
            Resource("A", RWStructuredBuffer));

        static ShaderProgram Positions(string corners, string depth)
            => Vertex("Corners", $"vec2 at[] = vec2[]({corners}); void main() {{ gl_Position = vec4(at[gl_VertexIndex], {depth}, 1); }}", new int[0]);

        static ShaderProgram White() => Fragment("White", "layout(location = 0) out vec4 c; void main() { c = vec4(1); }");

        static DeviceRasterState State(DeviceCull cull) => new DeviceRasterState { Cull = cull, DepthTest = DeviceCompare.Always, ColorMask = 15 };

        static DeviceBinding[] Bind(params DeviceBuffer[] buffers) => Array.ConvertAll(buffers, b => new DeviceBinding { Buffer = b });

        void Begin(DeviceTexture target, DeviceTexture depth)
            => device.BeginPass(new DeviceTargets { Color0 = target, ColorCount = 1, Depth = depth, ClearColor = true,
                ClearDepth = depth != null, ClearValue = new DeviceColor { A = 1 } });

        T Keep<T>(T resource) where T : DeviceResource
        {
            made.Add(resource);
            return resource;
        }

        DeviceKernel Kernel(ShaderProgram program) => Keep(device.CreateKernel(program));
        DevicePass Pass(ShaderProgram vertex, ShaderProgram fragment) => Keep(device.CreatePass(vertex, fragment));

        DeviceBuffer Buffer(long bytes, string name = "Buffer")
        {
            var buffer = Keep(device.CreateBuffer(name, bytes));
            device.Fill(buffer, 0, buffer.Bytes, Garbage);
            return buffer;
        }

        DeviceTexture NewTexture(DeviceFormat format, int width, int height, int depth = 0, int mips = 1, bool randomWrite = false,
            bool target = false)
            => Keep(device.CreateTexture(new DeviceTextureDescription
            {
                Name = "Texture", Dimension = depth > 0 ? DeviceTextureDimension.Tex3D : DeviceTextureDimension.Tex2D, Format = format,
                Width = width, Height = height, Depth = depth, Slices = 1, Mips = mips, Samples = 1, RandomWrite = randomWrite, Target = target,
            }));

        byte[] Bytes(DeviceBuffer buffer, long offset, int bytes)
        {
            var data = new byte[bytes];
            device.Read(buffer, offset, data);
            return data;
        }

        uint[] UInts(DeviceBuffer buffer)
        {
            var data = new uint[buffer.Bytes / 4];
            device.Read(buffer, 0, MemoryMarshal.AsBytes(data.AsSpan()));
            return data;
        }

        /// <summary>White where expected, black elsewhere; pixels on an edge may be either.</summary>
        void AssertPixels(DeviceTexture target, Func<int, int, bool> white, Func<int, int, bool> edge = null)
        {
            byte[] pixels = device.ReadTexture(target, 0, 0);
            for (int y = 0; y < target.Description.Height; y++)
                for (int x = 0; x < target.Description.Width; x++)
                    if (edge == null || !edge(x, y))
                        Assert.That(pixels[(y * target.Description.Width + x) * 4], Is.EqualTo(white(x, y) ? 255 : 0), $"red of pixel {x}, {y}");
        }
    }
}
