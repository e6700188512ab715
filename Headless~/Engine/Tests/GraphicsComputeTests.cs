using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace Host.Tests
{
    public class GraphicsComputeTests : GraphicsFixture
    {
        static GraphicsBuffer Uints(params uint[] values)
        {
            var buffer = new GraphicsBuffer(GraphicsBuffer.Target.Structured, values.Length, 4);
            buffer.SetData(values);
            return buffer;
        }

        static uint[] Read(GraphicsBuffer buffer)
        {
            var values = new uint[buffer.count];
            buffer.GetData(values);
            return values;
        }

        [Test]
        public void A_dispatch_sees_what_the_one_before_wrote()
        {
            ComputeShader shader = Compute("Work");
            int kernel = shader.FindKernel("AddOne");
            using (GraphicsBuffer values = Uints(new uint[100]))
            {
                shader.SetInt("_Count", 100);
                shader.SetInt("_Step", 1);
                shader.SetBuffer(kernel, "_Values", values);
                for (int i = 0; i < 50; i++)
                    shader.Dispatch(kernel, 2, 1, 1);
                Assert.That(Read(values), Is.All.EqualTo(50));
            }
        }

        [Test]
        public void A_command_buffer_takes_values_when_recorded_and_acts_when_executed_each_time()
        {
            ComputeShader shader = Compute("Work");
            int kernel = shader.FindKernel("AddOne");
            using (GraphicsBuffer values = Uints(new uint[64]))
            using (var cmd = new CommandBuffer { name = "Twice" })
            {
                cmd.SetComputeIntParam(shader, "_Count", 64);
                cmd.SetComputeBufferParam(shader, kernel, "_Values", values);
                cmd.SetComputeIntParam(shader, "_Step", 3);
                cmd.DispatchCompute(shader, kernel, 1, 1, 1);
                cmd.SetComputeIntParam(shader, "_Step", 10);
                cmd.DispatchCompute(shader, kernel, 1, 1, 1);
                Assert.That(Read(values), Is.All.Zero);
                Graphics.ExecuteCommandBuffer(cmd);
                Assert.That(Read(values), Is.All.EqualTo(13));
                Graphics.ExecuteCommandBuffer(cmd);
                Assert.That(Read(values), Is.All.EqualTo(26));

                // The last buffer stays set on the shader.
                shader.Dispatch(kernel, 1, 1, 1);
                Assert.That(Read(values), Is.All.EqualTo(36));

                cmd.Clear();
                Graphics.ExecuteCommandBuffer(cmd);
                Assert.That(Read(values), Is.All.EqualTo(36));
            }
        }

        [Test]
        public void Buffer_data_in_a_command_buffer_is_a_copy_of_the_time_of_recording()
        {
            using (GraphicsBuffer values = Uints(1, 2, 3, 4))
            using (var cmd = new CommandBuffer())
            {
                var data = new uint[] { 10, 20, 30 };
                cmd.SetBufferData(values, data, 1, 2, 2);
                data[1] = 99;
                Graphics.ExecuteCommandBuffer(cmd);
                Assert.That(Read(values), Is.EqualTo(new uint[] { 1, 2, 20, 30 }));
            }
        }

        [Test]
        public void Counters_are_set_and_copied_by_a_command_buffer()
        {
            ComputeShader shader = Compute("Work");
            int kernel = shader.FindKernel("AppendEven");
            using (var pile = new GraphicsBuffer(GraphicsBuffer.Target.Append, 64, 4))
            using (var count = new GraphicsBuffer(GraphicsBuffer.Target.Raw, 1, 4))
            using (var cmd = new CommandBuffer())
            {
                cmd.SetBufferCounterValue(pile, 3);
                cmd.SetComputeIntParam(shader, "_Count", 20);
                cmd.SetComputeBufferParam(shader, kernel, "_Appended", pile);
                cmd.DispatchCompute(shader, kernel, 1, 1, 1);
                cmd.CopyCounterValue(pile, count, 0);
                Graphics.ExecuteCommandBuffer(cmd);
                Assert.That(Read(count)[0], Is.EqualTo(13));
            }
        }

        [Test]
        public void Group_counts_of_an_indirect_dispatch_come_from_the_gpu([Values(0, 1)] int recorded)
        {
            ComputeShader shader = Compute("Work");
            int write = shader.FindKernel("WriteArguments"), add = shader.FindKernel("AddOne");
            using (var arguments = new GraphicsBuffer(GraphicsBuffer.Target.Raw | GraphicsBuffer.Target.IndirectArguments, 4, 4))
            using (GraphicsBuffer values = Uints(new uint[64 * 5]))
            using (var cmd = new CommandBuffer())
            {
                shader.SetBuffer(write, "_Arguments", arguments);
                shader.SetInts("_GroupsX", 99);
                shader.SetInt("_GroupsY", 3);
                shader.SetInt("_GroupsZ", 1);
                shader.SetInt("_GroupsW", 1);
                shader.SetInt("_Count", 64 * 5);
                shader.SetInt("_Step", 1);
                shader.SetBuffer(add, "_Values", values);
                shader.Dispatch(write, 1, 1, 1);
                if (recorded == 1)
                {
                    cmd.DispatchCompute(shader, add, arguments, 4);
                    Graphics.ExecuteCommandBuffer(cmd);
                }
                else
                    shader.DispatchIndirect(add, arguments, 4);
                Assert.That(Read(values), Is.EqualTo(Enumerable.Range(0, 64 * 5).Select(i => i < 192 ? 1u : 0u)));
            }
        }

        [Test]
        public void Every_atomic_does_what_its_name_says()
        {
            ComputeShader shader = Compute("Work");
            int kernel = shader.FindKernel("Atomics");
            using (GraphicsBuffer values = Uints(0, 1000, 0, uint.MaxValue, 0, 0, 0, 0, 0, 0))
            using (var signed = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 2, 4))
            {
                signed.SetData(new[] { 1000, -1000 });
                shader.SetBuffer(kernel, "_Values", values);
                shader.SetBuffer(kernel, "_Signed", signed);
                shader.Dispatch(kernel, 2, 1, 1);
                uint[] v = Read(values);
                var s = new int[2];
                signed.GetData(s);
                Assert.That(v[0], Is.EqualTo(127 * 128 / 2), "add");
                Assert.That(v[1], Is.Zero, "min");
                Assert.That(v[2], Is.EqualTo(127), "max");
                Assert.That(s, Is.EqualTo(new[] { -100, 27 }), "signed min and max");
                Assert.That(v[3], Is.Zero, "and");
                Assert.That(v[4], Is.EqualTo(uint.MaxValue), "or");
                Assert.That(v[5], Is.EqualTo(Enumerable.Range(0, 128).Aggregate(0, (a, b) => a ^ b)), "xor");
                Assert.That(v[6], Is.EqualTo(7), "exchange");
                Assert.That(v[7], Is.InRange(1, 128), "compare-exchange");
                Assert.That(v[8], Is.EqualTo(1), "compare-exchange lets one through");
                Assert.That(v[9], Is.EqualTo(5), "compare-store");
            }
        }

        [Test]
        public void Thousands_of_dispatches_each_see_their_own_values()
        {
            ComputeShader shader = Compute("Work");
            int kernel = shader.FindKernel("AddOne");
            int step = Shader.PropertyToID("_Step");
            using (GraphicsBuffer values = Uints(new uint[64]))
            using (var cmd = new CommandBuffer())
            {
                cmd.SetComputeIntParam(shader, "_Count", 64);
                cmd.SetComputeBufferParam(shader, kernel, "_Values", values);
                for (int i = 1; i <= 5000; i++)
                {
                    cmd.SetComputeIntParam(shader, step, i);
                    cmd.DispatchCompute(shader, kernel, 1, 1, 1);
                }
                Graphics.ExecuteCommandBuffer(cmd);
                Assert.That(Read(values), Is.All.EqualTo(5000 * 5001 / 2));
            }
        }

        [Test]
        public void Groups_share_memory_across_a_barrier()
        {
            ComputeShader shader = Compute("Work");
            int kernel = shader.FindKernel("GroupSum");
            using (GraphicsBuffer source = Uints(Enumerable.Range(0, 150).Select(i => (uint)i).ToArray()), sums = Uints(9, 9, 9, 9))
            {
                shader.SetInt("_Count", 150);
                shader.SetBuffer(kernel, "_Source", source);
                shader.SetBuffer(kernel, "_Values", sums);
                shader.Dispatch(kernel, 3, 1, 1);
                Assert.That(Read(sums), Is.EqualTo(new uint[] { 2016, 6112, 3047, 9 }));
            }
        }

        [Test]
        public void Reads_past_the_end_give_zero_and_writes_there_vanish()
        {
            ComputeShader shader = Compute("Work");
            int kernel = shader.FindKernel("OutOfRange");
            using (GraphicsBuffer source = Uints(42, 43), values = Uints(9, 9, 9))
            {
                shader.SetBuffer(kernel, "_Source", source);
                shader.SetBuffer(kernel, "_Values", values);
                shader.Dispatch(kernel, 1, 1, 1);
                Assert.That(Read(values), Is.EqualTo(new uint[] { 0, 42, 9 }));
            }
        }

        [Test]
        public void Loose_globals_of_every_kind_arrive([Values(0, 1)] int recorded)
        {
            ComputeShader shader = Compute("Work");
            int kernel = shader.FindKernel("Globals");
            Matrix4x4 move = Matrix4x4.Translate(new Vector3(10, 20, 30)), scale = Matrix4x4.Scale(new Vector3(2, 3, 4));
            var vectors = new[] { Vector4.zero, Vector4.one, new Vector4(0, 11, 0, 0) };
            using (var result = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 14, 4))
            using (var cmd = new CommandBuffer())
            {
                if (recorded == 1)
                {
                    cmd.SetComputeFloatParam(shader, "_Float", 1.5f);
                    cmd.SetComputeFloatParams(shader, "_Float2", 0, 2.5f);
                    cmd.SetComputeVectorParam(shader, "_Float3", new Vector4(0, 0, 3.5f, 0));
                    cmd.SetComputeVectorParam(shader, "_Float4", new Vector4(0, 0, 0, 4.5f));
                    cmd.SetComputeIntParam(shader, "_Int", -5);
                    cmd.SetComputeIntParams(shader, "_Int2", 0, 6);
                    cmd.SetComputeIntParam(shader, "_Bool", 1);
                    cmd.SetComputeMatrixParam(shader, "_Matrix", move);
                    cmd.SetComputeVectorArrayParam(shader, "_Vectors", vectors);
                    cmd.SetComputeMatrixArrayParam(shader, "_Matrices", new[] { move, scale });
                    cmd.SetComputeBufferParam(shader, kernel, "_Out", result);
                    cmd.DispatchCompute(shader, kernel, 1, 1, 1);
                    Graphics.ExecuteCommandBuffer(cmd);
                }
                else
                {
                    shader.SetFloat("_Float", 1.5f);
                    shader.SetFloats("_Float2", 0, 2.5f);
                    shader.SetVector("_Float3", new Vector4(0, 0, 3.5f, 0));
                    shader.SetVector("_Float4", new Vector4(0, 0, 0, 4.5f));
                    shader.SetInt("_Int", -5);
                    shader.SetInts("_Int2", 0, 6);
                    shader.SetBool("_Bool", true);
                    shader.SetMatrix("_Matrix", move);
                    shader.SetVectorArray("_Vectors", vectors);
                    shader.SetMatrixArray("_Matrices", new[] { move, scale });
                    shader.SetBuffer(kernel, "_Out", result);
                    shader.Dispatch(kernel, 1, 1, 1);
                }
                var values = new float[14];
                result.GetData(values);
                Assert.That(values, Is.EqualTo(new[] { 1.5f, 2.5f, 3.5f, 4.5f, -5, 6, 1, 11, 22, 33, 11, 2, 6, 12 }));
            }
        }

        [Test]
        public void A_named_constant_buffer_is_packed_as_direct3d_packs_it_by_field_or_whole([Values(0, 1)] int whole)
        {
            ComputeShader shader = Compute("Constants");
            int kernel = shader.FindKernel("Read");
            using (var result = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 9, 4))
            using (var constants = new GraphicsBuffer(GraphicsBuffer.Target.Constant, 64, 4))
            {
                if (whole == 1)
                {
                    var words = new float[64];
                    words[0] = 1;                           // _A
                    words[3] = 2;                           // _B.z
                    words[4] = 3;                           // _C[0]
                    words[12] = 4;                          // _C[2]
                    words[14] = 5;                          // _D.y
                    for (int i = 0; i < 4; i++)
                        words[16 + i * 5] = i + 1;          // _R: diagonal
                    for (int i = 0; i < 3; i++)
                        words[32 + i * 5] = i + 10;         // _M: diagonal
                    constants.SetData(words);
                    shader.SetConstantBuffer("Settings", constants, 0, 256);
                }
                else
                {
                    shader.SetFloat("_A", 1);
                    shader.SetVector("_B", new Vector4(0, 0, 2, 0));
                    shader.SetFloats("_C", 3, 0, 0, 0, 0, 0, 0, 0, 4);      // spread by hand to 16 bytes, as compute shaders want it
                    shader.SetVector("_D", new Vector4(0, 5, 0, 0));
                    shader.SetMatrix("_R", Matrix4x4.Scale(new Vector3(1, 2, 3)) * Diagonal(1, 1, 1, 4));
                    shader.SetMatrix("_M", Diagonal(10, 11, 12, 1));
                }
                shader.SetBuffer(kernel, "_Out", result);
                shader.Dispatch(kernel, 1, 1, 1);
                var values = new float[9];
                result.GetData(values);
                Assert.That(values, Is.EqualTo(new float[] { 1, 2, 3, 4, 5, 1, 16, 10, 36 }));
            }
        }

        static Matrix4x4 Diagonal(float x, float y, float z, float w)
        {
            Matrix4x4 m = Matrix4x4.zero;
            (m.m00, m.m11, m.m22, m.m33) = (x, y, z, w);
            return m;
        }

        static uint Variant(ComputeShader shader, string kernel)
        {
            using (GraphicsBuffer result = Uints(0))
            {
                shader.SetBuffer(shader.FindKernel(kernel), "_Out", result);
                shader.Dispatch(shader.FindKernel(kernel), 1, 1, 1);
                return Read(result)[0];
            }
        }

        [Test]
        public void Each_kernel_has_its_own_defines_and_group_size()
        {
            ComputeShader shader = Compute("Variants");
            Assert.That(Variant(shader, "Plain"), Is.EqualTo(7));
            Assert.That(Variant(shader, "Doubled"), Is.EqualTo(14));
            Assert.That(Variant(shader, "Tripled"), Is.EqualTo(121));
            shader.GetKernelThreadGroupSizes(shader.FindKernel("Plain"), out uint x, out uint y, out uint z);
            Assert.That(new[] { x, y, z }, Is.EqualTo(new uint[] { 4, 2, 1 }));
            Assert.That(shader.IsSupported(1), Is.True);
            Assert.That(shader.HasKernel("Doubled"), Is.True);
            Assert.That(shader.HasKernel("Quadrupled"), Is.False);
        }

        [Test]
        public void Keywords_choose_the_variant_locally_globally_and_in_order_of_execution()
        {
            ComputeShader shader = Compute("Variants");
            var keyword = new LocalKeyword(shader, "WITH_BONUS");
            Assert.That(shader.keywordSpace.keywordNames, Does.Contain("WITH_BONUS"));
            shader.EnableKeyword(keyword);
            Assert.That(shader.IsKeywordEnabled(keyword), Is.True);
            Assert.That(Variant(shader, "Doubled"), Is.EqualTo(1014));
            shader.DisableKeyword("WITH_BONUS");
            Assert.That(Variant(shader, "Doubled"), Is.EqualTo(14));
            Shader.EnableKeyword("GLOBAL_BONUS");
            Assert.That(Variant(shader, "Doubled"), Is.EqualTo(20014));
            Shader.DisableKeyword("GLOBAL_BONUS");

            int kernel = shader.FindKernel("Plain");
            using (GraphicsBuffer first = Uints(0), second = Uints(0))
            using (var cmd = new CommandBuffer())
            {
                cmd.EnableKeyword(shader, keyword);
                cmd.SetComputeBufferParam(shader, kernel, "_Out", first);
                cmd.DispatchCompute(shader, kernel, 1, 1, 1);
                cmd.SetKeyword(shader, keyword, false);
                cmd.SetComputeBufferParam(shader, kernel, "_Out", second);
                cmd.DispatchCompute(shader, kernel, 1, 1, 1);
                Graphics.ExecuteCommandBuffer(cmd);
                Assert.That(Read(first)[0], Is.EqualTo(1007));
                Assert.That(Read(second)[0], Is.EqualTo(7));
            }
        }

        [Test]
        public void A_volume_is_sampled_by_inline_samplers_and_read_by_texel()
        {
            ComputeShader shader = Compute("Textures");
            int kernel = shader.FindKernel("SampleVolume");
            var volume = new Texture3D(2, 2, 2, TextureFormat.RHalf, false);        // 32-bit floats are not filtered everywhere
            ushort none = 0, one = Mathf.FloatToHalf(1f), nine = Mathf.FloatToHalf(9f);
            volume.SetPixelData(new[] { none, one, none, one, none, nine, none, one }, 0);     // x = 1 holds 1, but 9 at (1, 0, 1)
            volume.Apply(false);
            using (var result = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 1, 16))
            {
                shader.SetTexture(kernel, "_Volume", volume);
                shader.SetBuffer(kernel, "_Out", result);
                shader.SetVector("_At", new Vector4(0.5f, 0.75f, 0.25f, 0));
                shader.Dispatch(kernel, 1, 1, 1);
                var values = new Vector4[1];
                result.GetData(values);
                Assert.That(values[0].x, Is.EqualTo(0.5f).Within(1e-3f), "linear between two texels");
                Assert.That(values[0].y, Is.EqualTo(1), "nearest, wrapped around");
                Assert.That(values[0].z, Is.EqualTo(9));
                Assert.That(values[0].w, Is.Zero, "outside");
            }
            UnityEngine.Object.DestroyImmediate(volume);
        }

        [Test]
        public void A_volume_is_written_by_a_kernel()
        {
            ComputeShader shader = Compute("Textures");
            int kernel = shader.FindKernel("WriteVolume");
            var target = new RenderTexture(4, 3, 0, GraphicsFormat.R32_SFloat) { dimension = TextureDimension.Tex3D, volumeDepth = 2,
                enableRandomWrite = true };
            target.Create();
            shader.SetTexture(kernel, "_VolumeOut", target);
            shader.SetInts("_Size", 4, 3, 2);
            shader.Dispatch(kernel, 1, 1, 1);
            AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(target);
            request.WaitForCompletion();
            Assert.That(request.layerCount, Is.EqualTo(2));
            for (int z = 0; z < 2; z++)
                Assert.That(request.GetData<float>(z).ToArray(),
                    Is.EqualTo(Enumerable.Range(0, 12).Select(i => (float)(i % 4 + 10 * (i / 4) + 100 * z))));
            target.Release();
        }

        [Test]
        public void A_plane_written_by_a_kernel_has_row_zero_at_the_bottom_of_the_picture()
        {
            ComputeShader shader = Compute("Textures");
            int kernel = shader.FindKernel("WritePlane");
            var target = new RenderTexture(8, 4, 0, RenderTextureFormat.ARGB32, RenderTextureReadWrite.Linear) { enableRandomWrite = true };
            target.Create();
            shader.SetTexture(kernel, "_PlaneOut", target);
            shader.SetInts("_Size", 8, 4, 1);
            shader.Dispatch(kernel, 1, 1, 1);
            byte[] picture = Screenshot.ReadRgba(target);
            Assert.That(new[] { picture[0], picture[1] }, Is.EqualTo(new byte[] { 0, 3 }), "the top left pixel is texel (0, 3)");

            RenderTexture.active = target;
            var copy = new Texture2D(8, 4, TextureFormat.RGBA32, false, true);
            copy.ReadPixels(new Rect(0, 0, 8, 4), 0, 0);
            RenderTexture.active = null;
            Assert.That((Color32)copy.GetPixel(5, 1), Is.EqualTo(new Color32(5, 1, 0, 1)));
            copy.Apply();

            int read = shader.FindKernel("ReadPlane");
            using (var result = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 4, 16))
            {
                shader.SetTexture(read, "_Plane", copy);
                shader.SetBuffer(read, "_Out", result);
                shader.Dispatch(read, 1, 1, 1);
                var values = new Vector4[4];
                result.GetData(values);
                Assert.That(values[0], Is.EqualTo(new Vector4(8, 4, 0, 0)));
                Assert.That(values[1].y * 255, Is.EqualTo(0).Within(1e-3f), "row 0 is the bottom");
                Assert.That(values[2].y * 255, Is.EqualTo(3).Within(1e-3f));
                Assert.That(values[3].y * 255, Is.LessThan(0.5f), "the lowest eighth is the center of row 0");
            }
            UnityEngine.Object.DestroyImmediate(copy);
            UnityEngine.Object.DestroyImmediate(target);
        }

        [Test]
        public void Globals_reach_kernels_that_have_no_value_of_their_own()
        {
            ComputeShader shader = Compute("Work");
            int kernel = shader.FindKernel("AddOne");
            using (GraphicsBuffer values = Uints(new uint[4]))
            {
                Shader.SetGlobalInteger("_Count", 4);
                Shader.SetGlobalBuffer("_Values", values);
                shader.SetInt("_Step", 2);
                shader.Dispatch(kernel, 1, 1, 1);
                Assert.That(Read(values), Is.All.EqualTo(2));
            }
        }

        [Test]
        public void Gpu_samples_of_a_command_buffer_are_timed_while_timing_is_on()
        {
            ComputeShader shader = Compute("Work");
            int kernel = shader.FindKernel("AddOne");
            using (GraphicsBuffer values = Uints(new uint[64]))
            using (var cmd = new CommandBuffer())
            {
                cmd.BeginSample("Outer");
                cmd.BeginSample(new Unity.Profiling.ProfilerMarker("Inner"));
                cmd.SetComputeIntParam(shader, "_Count", 64);
                cmd.SetComputeIntParam(shader, "_Step", 1);
                cmd.SetComputeBufferParam(shader, kernel, "_Values", values);
                cmd.DispatchCompute(shader, kernel, 1, 1, 1);
                cmd.EndSample(new Unity.Profiling.ProfilerMarker("Inner"));
                cmd.EndSample("Outer");
                Player.Device.Timing = true;
                Graphics.ExecuteCommandBuffer(cmd);
                Player.Device.Timing = false;
                Assert.That(Player.Device.CollectSamples().Select(s => $"{s.Depth} {s.Name}"), Is.EqualTo(new[] { "0 Outer", "1 Inner" }));
            }
        }

        [Test]
        public void Executing_many_commands_again_allocates_next_to_nothing()
        {
            ComputeShader shader = Compute("Work");
            int kernel = shader.FindKernel("AddOne");
            int step = Shader.PropertyToID("_Step");
            using (GraphicsBuffer values = Uints(new uint[64]))
            using (var cmd = new CommandBuffer())
            {
                cmd.SetComputeIntParam(shader, "_Count", 64);
                cmd.SetComputeBufferParam(shader, kernel, "_Values", values);
                for (int i = 0; i < 1000; i++)
                {
                    cmd.SetComputeIntParam(shader, step, i & 1);
                    cmd.DispatchCompute(shader, kernel, 1, 1, 1);
                }
                for (int warmUp = 0; warmUp < 3; warmUp++)
                    Graphics.ExecuteCommandBuffer(cmd);
                Player.Device.WaitIdle();
                long before = GC.GetAllocatedBytesForCurrentThread();
                Graphics.ExecuteCommandBuffer(cmd);
                long bytes = GC.GetAllocatedBytesForCurrentThread() - before;
                Assert.That(bytes, Is.LessThan(64 * 1024), "bytes for 1000 dispatches");
                Assert.That(Read(values), Is.All.EqualTo(2000));
            }
        }
    }
}
