using System;
using NUnit.Framework;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Host.Tests
{
    /// <summary>Every misuse that strict mode refuses: the message names the buffer or kernel, the limit and the call.</summary>
    public class GraphicsStrictTests : GraphicsFixture
    {
        static GraphicsBuffer Buffer(string name, int count = 16, int stride = 4,
            GraphicsBuffer.Target target = GraphicsBuffer.Target.Structured, bool written = true)
        {
            var buffer = new GraphicsBuffer(target, count, stride) { name = name };
            if (written)
                buffer.SetData(new uint[count * stride / 4]);
            return buffer;
        }

        static void Refused(TestDelegate code, params string[] says) => Refused<InvalidOperationException>(code, says);

        static void Refused<T>(TestDelegate code, params string[] says) where T : Exception
        {
            Exception error = Assert.Catch<Exception>(code);
            Assert.That(error, Is.InstanceOf<T>(), error.ToString());
            foreach (string what in says)
                Assert.That(error.Message, Does.Contain(what));
        }

        // ---- creation

        [Test] public void A_buffer_of_no_elements() => Refused<ArgumentException>(() => Buffer("None", 0), "GraphicsBuffer", "0 elements");
        [Test] public void A_buffer_of_fewer_than_no_elements()
            => Refused<ArgumentException>(() => new ComputeBuffer(-1, 4), "ComputeBuffer", "-1 elements");
        [Test] public void A_stride_that_is_no_multiple_of_four()
            => Refused<ArgumentException>(() => new GraphicsBuffer(GraphicsBuffer.Target.Structured, 4, 6), "6 bytes", "multiple of 4");
        [Test] public void A_stride_above_2048()
            => Refused<ArgumentException>(() => new GraphicsBuffer(GraphicsBuffer.Target.Structured, 4, 2052), "2052", "2048");
        [Test] public void A_raw_buffer_of_another_stride_than_four()
            => Refused<ArgumentException>(() => new GraphicsBuffer(GraphicsBuffer.Target.Raw, 4, 16), "raw", "16 bytes");
        [Test] public void A_resource_above_two_gigabytes()
            => Refused<ArgumentException>(() => new GraphicsBuffer(GraphicsBuffer.Target.Structured, (1 << 20) + 1, 2048), "2,147,485,696",
            "2,147,483,648");

        // ---- reading and writing

        [Test]
        public void Set_data_past_the_end()
        {
            using (GraphicsBuffer buffer = Buffer("Short", 4))
                Refused<ArgumentException>(() => buffer.SetData(new uint[5]), "SetData", "Short", "16");
        }

        [Test]
        public void Set_data_from_past_the_end_of_the_array()
        {
            using (GraphicsBuffer buffer = Buffer("Range", 4))
                Refused<ArgumentOutOfRangeException>(() => buffer.SetData(new uint[4], 3, 0, 2), "SetData", "Range", "managedBufferStartIndex:3");
        }

        [Test]
        public void Get_data_past_the_end()
        {
            using (GraphicsBuffer buffer = Buffer("Short", 4))
                Refused<ArgumentException>(() => buffer.GetData(new uint[4], 0, 1, 4), "GetData", "Short");
        }

        [Test]
        public void Reading_a_buffer_that_nothing_has_written()
        {
            using (GraphicsBuffer buffer = Buffer("Blank", written: false))
            {
                Refused(() => buffer.GetData(new uint[1]), "GetData", "Blank", "nothing has written");
                Refused(() => AsyncGPUReadback.Request(buffer), "AsyncGPUReadback.Request", "Blank");
            }
        }

        [TestCase(true)]
        [TestCase(false)]
        public void A_recorded_native_array_that_changes_before_execution(bool disposes)
        {
            var data = new NativeArray<uint>(new uint[] { 1, 2, 3, 4 }, Allocator.Persistent);
            using (GraphicsBuffer target = Buffer("Target"))
            using (var cmd = new CommandBuffer())
            {
                cmd.SetBufferData(target, data, 1, 0, 2);
                data[0] = 9;        // no part of what was recorded
                Graphics.ExecuteCommandBuffer(cmd);
                if (disposes)
                    data.Dispose();
                else
                    data[1] = 9;
                Refused(() => Graphics.ExecuteCommandBuffer(cmd), "SetBufferData", "Target", "managed array");
            }
            if (data.IsCreated && !disposes)
                data.Dispose();
        }

        [Test]
        public void A_recorded_managed_array_is_copied()
        {
            var data = new uint[] { 1 };
            using (GraphicsBuffer target = Buffer("Target", 2))
            using (var cmd = new CommandBuffer())
            {
                cmd.SetBufferData(target, data, 0, 0, 1);
                data[0] = 2;
                cmd.SetBufferData(target, data, 0, 1, 1);
                data[0] = 3;
                Graphics.ExecuteCommandBuffer(cmd);
                var read = new uint[2];
                target.GetData(read);
                Assert.That(read, Is.EqualTo(new uint[] { 1, 2 }));
            }
        }

        [Test]
        public void Release_while_a_readback_is_on_its_way()
        {
            GraphicsBuffer buffer = Buffer("Leaving");
            AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(buffer);
            Refused(() => buffer.Release(), "Leaving", "read-back", "pending");
            request.WaitForCompletion();
            buffer.Release();
        }

        [Test]
        public void Any_use_after_release()
        {
            GraphicsBuffer buffer = Buffer("Gone");
            buffer.Release();
            ComputeShader shader = Compute("Faults");
            Refused<ObjectDisposedException>(() => buffer.SetData(new uint[1]), "SetData", "Gone");
            Refused<ObjectDisposedException>(() => buffer.GetData(new uint[1]), "GetData", "Gone");
            Refused<ObjectDisposedException>(() => buffer.SetCounterValue(0), "SetCounterValue", "Gone");
            Refused<ObjectDisposedException>(() => shader.SetBuffer(0, "_U0", buffer), "SetBuffer", "_U0", "Gone");
            using (var cmd = new CommandBuffer())
                Refused<ObjectDisposedException>(() => cmd.SetComputeBufferParam(shader, 0, "_U0", buffer), "SetComputeBufferParam", "_U0", "Gone");
        }

        [Test]
        public void Release_between_binding_and_dispatch()
        {
            ComputeShader shader = Compute("Work");
            int kernel = shader.FindKernel("AddOne");
            GraphicsBuffer buffer = Buffer("Gone");
            shader.SetBuffer(kernel, "_Values", buffer);
            buffer.Release();
            Refused(() => shader.Dispatch(kernel, 1, 1, 1), "AddOne", "_Values", "Gone", "released");
        }

        [Test]
        public void A_command_buffer_after_release()
        {
            var cmd = new CommandBuffer { name = "Old" };
            cmd.Release();
            Refused<ObjectDisposedException>(() => cmd.BeginSample("x"), "Old");
            Refused<ObjectDisposedException>(() => Graphics.ExecuteCommandBuffer(cmd), "Old");
        }

        [Test]
        public void Counting_without_a_counter()
        {
            using (GraphicsBuffer buffer = Buffer("Plain"))
            {
                Refused(() => buffer.SetCounterValue(0), "SetCounterValue", "Plain", "Append or Counter");
                Refused(() => GraphicsBuffer.CopyCount(buffer, buffer, 0), "CopyCount", "Plain");
            }
        }

        [Test]
        public void A_count_copied_to_a_place_outside()
        {
            using (GraphicsBuffer pile = Buffer("Pile", target: GraphicsBuffer.Target.Append), count = Buffer("Count", 1))
                Refused<ArgumentException>(() => GraphicsBuffer.CopyCount(pile, count, 4), "CopyCount", "Count", "4 bytes");
        }

        // ---- dispatch

        [Test]
        public void A_dispatch_with_nothing_bound()
        {
            ComputeShader shader = Compute("Work");
            Refused(() => shader.Dispatch(shader.FindKernel("AddOne"), 1, 1, 1), "AddOne", "_Values");
        }

        [Test]
        public void A_keyword_that_changes_between_binding_and_dispatch()
        {
            ComputeShader shader = Compute("Variants");
            var keyword = new LocalKeyword(shader, "WITH_BONUS");
            int kernel = shader.FindKernel("Plain");
            using (GraphicsBuffer target = Buffer("Target"))
            using (var cmd = new CommandBuffer())
            {
                cmd.SetComputeBufferParam(shader, kernel, "_Out", target);
                cmd.SetKeyword(shader, keyword, false);     // as it was
                cmd.DispatchCompute(shader, kernel, 1, 1, 1);
                Graphics.ExecuteCommandBuffer(cmd);

                cmd.Clear();
                cmd.SetComputeBufferParam(shader, kernel, "_Out", target);
                cmd.SetKeyword(shader, keyword, true);
                cmd.DispatchCompute(shader, kernel, 1, 1, 1);
                Refused(() => Graphics.ExecuteCommandBuffer(cmd), "Plain", "keyword", "_Out", "first");
            }
        }

        [TestCase(0, 1, 1)]
        [TestCase(1, -1, 1)]
        public void A_dispatch_of_no_groups(int x, int y, int z)
        {
            ComputeShader shader = Compute("Work");
            Refused(() => shader.Dispatch(0, x, y, z), "AddOne", "at least 1");
            using (var cmd = new CommandBuffer())
                Refused(() => cmd.DispatchCompute(shader, 0, x, y, z), "AddOne", "at least 1");
        }

        [TestCase(65536, 1, 1)]
        [TestCase(1, 65536, 1)]
        [TestCase(1, 1, 65536)]
        public void A_dispatch_of_too_many_groups(int x, int y, int z)
        {
            ComputeShader shader = Compute("Work");
            Refused(() => shader.Dispatch(0, x, y, z), "AddOne", "65,535");
        }

        [Test]
        public void A_kernel_that_is_not_there()
        {
            ComputeShader shader = Compute("Faults");
            Refused(() => shader.Dispatch(99, 1, 1, 1), "Dispatch", "Faults.compute", "99");
            Refused<ArgumentException>(() => shader.FindKernel("Nonsense"), "Nonsense", "NineViews");
            using (var cmd = new CommandBuffer())
                Refused(() => cmd.DispatchCompute(shader, -1, 1, 1, 1), "DispatchCompute", "-1");
        }

        [Test]
        public void Another_stride_than_the_kernel_declares()
        {
            ComputeShader shader = Compute("Faults");
            int kernel = shader.FindKernel("Strided");
            using (GraphicsBuffer wide = Buffer("Wide", 4, 16), target = Buffer("Target"))
            {
                shader.SetBuffer(kernel, "_Triples", wide);
                shader.SetBuffer(kernel, "_U0", target);
                Refused(() => shader.Dispatch(kernel, 1, 1, 1), "Strided", "_Triples", "12 bytes", "Wide", "16");
            }
        }

        [Test]
        public void A_raw_buffer_where_a_structured_one_belongs_and_the_reverse()
        {
            ComputeShader shader = Compute("Faults");
            int raw = shader.FindKernel("Raw"), structured = shader.FindKernel("ReadsAndWrites");
            using (GraphicsBuffer bytes = Buffer("Bytes", target: GraphicsBuffer.Target.Raw), elements = Buffer("Elements"),
                target = Buffer("Target"))
            {
                shader.SetBuffer(raw, "_Bytes", elements);
                shader.SetBuffer(raw, "_U0", target);
                Refused(() => shader.Dispatch(raw, 1, 1, 1), "Raw", "_Bytes", "Elements", "without Raw");
                shader.SetBuffer(structured, "_In", bytes);
                shader.SetBuffer(structured, "_U0", target);
                Refused(() => shader.Dispatch(structured, 1, 1, 1), "_In", "Bytes", "without Structured");
            }
        }

        [Test]
        public void Appending_to_a_buffer_without_a_counter()
        {
            ComputeShader shader = Compute("Faults");
            int kernel = shader.FindKernel("Appends");
            using (GraphicsBuffer plain = Buffer("Plain"))
            {
                shader.SetBuffer(kernel, "_Pile", plain);
                Refused(() => shader.Dispatch(kernel, 1, 1, 1), "Appends", "_Pile", "Plain", "Append or Counter");
            }
        }

        [Test]
        public void A_kernel_that_reads_what_nothing_has_written()
        {
            ComputeShader shader = Compute("Faults");
            int kernel = shader.FindKernel("ReadsAndWrites");
            using (GraphicsBuffer blank = Buffer("Blank", written: false), target = Buffer("Target", written: false))
            {
                shader.SetBuffer(kernel, "_In", blank);
                shader.SetBuffer(kernel, "_U0", target);
                Refused(() => shader.Dispatch(kernel, 1, 1, 1), "ReadsAndWrites", "_In", "Blank", "nothing has written");
                blank.SetData(new uint[16]);
                shader.Dispatch(kernel, 1, 1, 1);
                target.GetData(new uint[1]);    // a binding for writing counts as written
            }
        }

        [Test]
        public void One_buffer_bound_for_reading_and_for_writing()
        {
            ComputeShader shader = Compute("Faults");
            int kernel = shader.FindKernel("ReadsAndWrites");
            using (GraphicsBuffer both = Buffer("Both"))
            {
                shader.SetBuffer(kernel, "_In", both);
                shader.SetBuffer(kernel, "_U0", both);
                Refused(() => shader.Dispatch(kernel, 1, 1, 1), "ReadsAndWrites", "Both", "_In", "_U0");
            }
        }

        [Test]
        public void More_than_eight_unordered_access_views()
        {
            ComputeShader shader = Compute("Faults");
            Refused(() => shader.Dispatch(shader.FindKernel("NineViews"), 1, 1, 1), "NineViews", "9 unordered", "8");
        }

        [Test]
        [ByGlslang("FXC does not compile it")]
        public void More_than_32_kilobytes_of_groupshared_memory()
        {
            ComputeShader shader = Compute("Faults");
            Refused(() => shader.Dispatch(shader.FindKernel("BigShared"), 1, 1, 1), "BigShared", "32772", "32768");
        }

        [Test]
        public void A_buffer_larger_than_the_device_binds()
        {
            long limit = Player.Device.Info.MaxBufferBytes;
            if (limit >= Gpu.MaxResourceBytes)
                Assert.Pass("This device binds whatever Direct3D 11 lets exist.");
            ComputeShader shader = Compute("Work");
            int kernel = shader.FindKernel("AddOne");
            using (var large = new GraphicsBuffer(GraphicsBuffer.Target.Structured, (int)(limit / 4) + 1, 4) { name = "Large" })
            {
                shader.SetBuffer(kernel, "_Values", large);
                Refused(() => shader.Dispatch(kernel, 1, 1, 1), "AddOne", "_Values", "Large", limit.ToString("N0"));
            }
        }

        [Test]
        public void A_constant_buffer_that_is_too_small_or_of_another_kind()
        {
            ComputeShader shader = Compute("Faults");
            int kernel = shader.FindKernel("WholeConstants");
            using (GraphicsBuffer constants = Buffer("Constants", 4, 16, GraphicsBuffer.Target.Constant), plain = Buffer("Plain", 4, 16),
                target = Buffer("Target"))
            {
                shader.SetBuffer(kernel, "_U0", target);
                shader.SetConstantBuffer("Block", constants, 0, 16);
                Refused(() => shader.Dispatch(kernel, 1, 1, 1), "WholeConstants", "Block", "32 bytes", "16");
                shader.SetConstantBuffer("Block", constants, 0, 128);
                Refused(() => shader.Dispatch(kernel, 1, 1, 1), "Block", "holds 64");
                shader.SetConstantBuffer("Block", plain, 0, 64);
                Refused(() => shader.Dispatch(kernel, 1, 1, 1), "Block", "Plain", "without Constant");
                shader.SetConstantBuffer("Block", constants, 0, 64);
                shader.Dispatch(kernel, 1, 1, 1);
            }
        }

        [Test]
        public void A_number_of_another_type_than_declared()
        {
            ComputeShader shader = Compute("Work");
            int kernel = shader.FindKernel("AddOne");
            using (GraphicsBuffer values = Buffer("Values"))
            {
                shader.SetBuffer(kernel, "_Values", values);
                shader.SetFloat("_Step", 1);
                Refused(() => shader.Dispatch(kernel, 1, 1, 1), "AddOne", "_Step", "UInt", "Float");
            }
        }

        // ---- indirect arguments

        [Test]
        public void Arguments_in_a_buffer_of_another_kind()
        {
            ComputeShader shader = Compute("Work");
            using (GraphicsBuffer plain = Buffer("Plain"))
                Refused(() => shader.DispatchIndirect(0, plain), "DispatchIndirect", "AddOne", "Plain", "IndirectArguments");
        }

        [Test]
        public void Arguments_that_nothing_has_written_or_that_lie_outside()
        {
            ComputeShader shader = Compute("Work");
            using (GraphicsBuffer blank = Buffer("Blank", 4, target: GraphicsBuffer.Target.IndirectArguments, written: false))
            {
                Refused(() => shader.DispatchIndirect(0, blank), "AddOne", "Blank", "nothing has written");
                Refused<ArgumentException>(() => shader.DispatchIndirect(0, blank, 8), "AddOne", "Blank", "12 bytes");
                Refused<ArgumentException>(() => shader.DispatchIndirect(0, blank, 2), "AddOne", "multiple of 4");
                Refused<ArgumentNullException>(() => shader.DispatchIndirect(0, (GraphicsBuffer)null), "AddOne", "null");
            }
        }

        [Test]
        public void Arguments_written_on_the_gpu_above_the_limit_are_found_at_the_next_read()
        {
            ComputeShader shader = Compute("Work");
            int write = shader.FindKernel("WriteArguments"), nothing = shader.FindKernel("WriteArguments");
            using (GraphicsBuffer arguments = Buffer("Arguments", 4,
                target: GraphicsBuffer.Target.Raw | GraphicsBuffer.Target.IndirectArguments),
                other = Buffer("Other", 4, target: GraphicsBuffer.Target.Raw))
            {
                shader.SetBuffer(write, "_Arguments", arguments);
                shader.SetInt("_GroupsX", 1);
                shader.SetInt("_GroupsY", 70000);
                shader.SetInt("_GroupsZ", 0);
                shader.Dispatch(write, 1, 1, 1);
                shader.SetBuffer(nothing, "_Arguments", other);
                shader.DispatchIndirect(nothing, arguments);
                Refused(() => other.GetData(new uint[1]), "WriteArguments", "Arguments", "70,000", "65,535");
            }
        }

        // ---- textures

        [Test]
        public void Textures_that_are_missing_not_created_of_another_dimension_or_not_writable()
        {
            ComputeShader shader = Compute("Textures");
            int sample = shader.FindKernel("SampleVolume"), write = shader.FindKernel("WritePlane");
            shader.SetInts("_Size", 1, 1, 1);
            using (GraphicsBuffer result = Buffer("Result", 4, 16))
            {
                shader.SetBuffer(sample, "_Out", result);
                Refused(() => shader.Dispatch(sample, 1, 1, 1), "SampleVolume", "_Volume");
                shader.SetTexture(sample, "_Volume", Texture2D.whiteTexture);
                Refused(() => shader.Dispatch(sample, 1, 1, 1), "SampleVolume", "_Volume", "Tex3D", "Tex2D", "white");
            }
            var plane = new RenderTexture(4, 4, 0) { name = "Plane" };
            shader.SetTexture(write, "_PlaneOut", plane);
            Refused(() => shader.Dispatch(write, 1, 1, 1), "WritePlane", "_PlaneOut", "Plane");
            plane.Create();
            Refused(() => shader.Dispatch(write, 1, 1, 1), "WritePlane", "_PlaneOut", "Plane", "enableRandomWrite");
            Refused(() => plane.enableRandomWrite = true, "enableRandomWrite", "Plane", "Release");
            Refused<ArgumentOutOfRangeException>(() => shader.SetTexture(write, "_PlaneOut", plane, 3), "_PlaneOut", "1 mip levels");
            UnityEngine.Object.DestroyImmediate(plane);
            Refused(() => shader.Dispatch(write, 1, 1, 1), "WritePlane", "_PlaneOut");
        }

        // ---- drawing

        [Test]
        public void Draws_without_a_material_or_with_a_wrong_pass()
        {
            Refused<ArgumentNullException>(() => Graphics.RenderPrimitives(new RenderParams(), MeshTopology.Triangles, 3),
                "RenderPrimitives", "material");
            Refused<ArgumentNullException>(() => new Material((Shader)null), "shader");
            using (var cmd = new CommandBuffer())
            {
                var material = new Material(DrawShader("Triangle"));
                cmd.DrawProcedural(Matrix4x4.identity, material, 5, MeshTopology.Triangles, 3);
                Refused(() => Graphics.ExecuteCommandBuffer(cmd), "DrawProcedural", "pass 5", "Tests/Triangle");
            }
        }

        [Test]
        public void Draws_whose_arguments_are_of_another_kind_or_outside()
        {
            var parameters = new RenderParams(new Material(DrawShader("Triangle")));
            using (GraphicsBuffer plain = Buffer("Plain"), arguments = Buffer("Arguments", 4, target: GraphicsBuffer.Target.IndirectArguments))
            {
                Refused(() => Graphics.RenderPrimitivesIndirect(parameters, MeshTopology.Triangles, plain), "RenderPrimitivesIndirect",
                    "Plain", "IndirectArguments");
                Refused<ArgumentException>(() => Graphics.RenderPrimitivesIndirect(parameters, MeshTopology.Triangles, arguments, 2),
                    "RenderPrimitivesIndirect", "Arguments", "32 bytes");
            }
        }

        [Test]
        public void A_procedural_draw_with_a_shader_that_reads_a_mesh()
        {
            using (var cmd = new CommandBuffer())
            {
                cmd.DrawProcedural(Matrix4x4.identity, new Material(DrawShader("Mesh")), 0, MeshTopology.Triangles, 3);
                Refused(() => Graphics.ExecuteCommandBuffer(cmd), "DrawProcedural", "Tests/Mesh", "SV_VertexID");
            }
        }

        // ---- not strict: logged as in Unity, skipped

        [Test]
        public void Outside_of_strict_mode_faults_are_logged_and_skipped()
        {
            LogAssert.ignoreFailingMessages = true;
            Player.Strict = false;
            ComputeShader shader = Compute("Work");
            int kernel = shader.FindKernel("AddOne");
            shader.Dispatch(kernel, 1, 1, 1);
            Assert.That(Logged, Has.Some.Contains("Property (_Values) at kernel index (0) is not set"));
            shader.Dispatch(kernel, 0, 1, 1);
            Assert.That(Logged, Has.Some.Contains("Thread group count must be above zero"));
            shader.Dispatch(kernel, 70000, 1, 1);
            Assert.That(Logged, Has.Some.Contains("65535"));
            shader.Dispatch(99, 1, 1, 1);
            Assert.That(Logged, Has.Some.Contains("Kernel index (99) out of range"));
        }

        [Test]
        public void A_sample_that_ends_another()
        {
            using (var cmd = new CommandBuffer { name = "Samples" })
            {
                cmd.BeginSample("A");
                Refused(() => cmd.EndSample("B"), "Samples", "\"A\"", "\"B\"");
            }
        }
    }
}
