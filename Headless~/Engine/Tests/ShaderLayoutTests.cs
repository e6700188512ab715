using System;
using System.Linq;
using System.Runtime.InteropServices;
using Host.Shaders;
using Host.Vulkan;
using NUnit.Framework;
using UnityEngine.Headless;

namespace Host.Tests
{
    /// <summary>
    /// That rewritten layouts reach the right bytes, on the device. Every constant buffer and input buffer holds the number
    /// i in its word i, so that what a kernel reads is where it read.
    /// </summary>
    public class ShaderLayoutTests
    {
        const int InputWords = 1024;
        const string Kernel = "\n[numthreads(1,1,1)] void K() ";

        VulkanDevice device;
        DeviceBuffer input;

        [OneTimeSetUp]
        public void Open()
        {
            device = new VulkanDevice(validation: true);
            input = device.CreateBuffer("Input", InputWords * 4);
        }

        [OneTimeTearDown]
        public void Close()
        {
            input.Dispose();
            device.Dispose();
        }

        static byte[] Words(int count) => Enumerable.Range(0, count).SelectMany(i => BitConverter.GetBytes((float)i)).ToArray();

        // Returns what the kernel leaves in _Out.
        float[] Run(string declarations, string body, int outputWords)
        {
            int messages = device.ValidationMessages.Count;
            using (var files = new ShaderFolder().Add("Test.compute", "#pragma kernel K\n" + declarations + Kernel + "{ " + body + " }"))
            using (DeviceKernel kernel = device.CreateKernel(ShaderFolder.Checked(files.Compute("Test.compute").Compile(0, null))))
            using (DeviceBuffer output = device.CreateBuffer("Out", outputWords * 4))
            using (DeviceBuffer counter = device.CreateBuffer("Counter", 4))
            {
                const uint garbage = 0xDEADBEEF;
                device.Upload(input, 0, Words(InputWords));
                device.Fill(output, 0, outputWords * 4, garbage);
                device.Fill(counter, 0, 4, 0);
                DeviceBinding[] bindings = kernel.Program.Resources.Select(r =>
                    r.Kind == ShaderResourceKind.ConstantBuffer
                    ? new DeviceBinding { Constants = Words(r.Constants.Bytes / 4), ConstantsLength = r.Constants.Bytes }
                    : new DeviceBinding { Buffer = r.Kind == ShaderResourceKind.Counter ? counter : r.Name == "_Out" ? output : input }).ToArray();
                device.Dispatch(kernel, bindings, 1, 1, 1);
                var result = new float[outputWords];
                device.Read(output, 0, MemoryMarshal.AsBytes(result.AsSpan()));
                Assert.That(device.ValidationMessages.Skip(messages), Is.Empty);
                return result;
            }
        }

        [Test]
        public void Constants_are_read_where_Direct3D_packs_them()
        {
            float[] got = Run(@"struct S { float3 p; float s; float2 uv; };
cbuffer Params { float3 a; float b; float c[4]; float tail; float3x3 m; float afterM; S s; float afterS; S list[2]; float last; float2x3 n;
    row_major float2x4 r; float x; };
RWStructuredBuffer<float> _Out;",
                "_Out[0] = a.z; _Out[1] = b; _Out[2] = c[3]; _Out[3] = tail; _Out[4] = m[0][1]; _Out[5] = m[2][0]; _Out[6] = afterM; " +
                    "_Out[7] = s.uv.y; _Out[8] = afterS;" +
                "_Out[9] = list[1].s; _Out[10] = last; _Out[11] = n[1][2]; _Out[12] = r[1][2]; _Out[13] = x;", 14);
            // a 0, b 3, c 4 (a register each), tail 17, columns of m 20, 24, 28, afterM 31, s 32, afterS 38, list 40 and 48,
            // last 54, columns of n 56, 60, 64, rows of r 68 and 72, x 76.
            Assert.That(got, Is.EqualTo(new float[] { 2, 3, 16, 17, 24, 22, 31, 37, 38, 51, 54, 65, 74, 76 }));
        }

        [Test]
        public void Structured_elements_are_read_without_padding()
        {
            float[] got = Run(@"struct I { float3 p; float s; float2 uv; };
struct E { float a; float3 b; I i; float2 c; I two[2]; float3x3 m; row_major float2x3 r; float2x3 q; float3 tail[2]; float z; };
StructuredBuffer<E> _In; RWStructuredBuffer<float> _Out;",
                "E e = _In[1]; _Out[0] = e.a; _Out[1] = e.b.z; _Out[2] = e.i.uv.y; _Out[3] = e.c.x; _Out[4] = e.two[1].s; _Out[5] = " +
                    "e.m[0][1]; _Out[6] = e.m[2][0];" +
                "_Out[7] = e.r[1][2]; _Out[8] = e.q[1][2]; _Out[9] = e.tail[1].y; _Out[10] = _In[2].z;", 11);
            // In words: a 0, b 1, i 4, c 10, two 12, m 24, r 33, q 39, tail 45, z 51; an element is 52.
            Assert.That(got, Is.EqualTo(new float[] { 52, 55, 61, 62, 73, 79, 78, 90, 96, 101, 155 }));
        }

        [Test]
        public void Structured_elements_are_written_without_padding()
        {
            float[] got = Run("struct E { float3 a; float2x3 m; float z; }; RWStructuredBuffer<E> _Out;",
                "E e; e.a = float3(1, 2, 3); e.m = float2x3(4, 5, 6, 7, 8, 9); e.z = 10; _Out[1] = e;", 20);
            Assert.That(got.Skip(10), Is.EqualTo(new float[] { 1, 2, 3, 4, 7, 5, 8, 6, 9, 10 }), "columns of the matrix");
        }

        [Test]
        public void A_matrix_uploaded_by_columns_multiplies_a_column_vector()
        {
            // Word i of _M is i: column c holds 4 c to 4 c + 3, so that row r of M v is the sum of (4 c + r) v[c].
            float[] got = Run("float4x4 _M; RWStructuredBuffer<float4> _Out;",
                "_Out[0] = mul(_M, float4(1, 2, 3, 4)); _Out[1] = _M._m03_m13_m23_m33; _Out[2] = _M[1]; _Out[3] = mul((float3x3)_M, " +
                    "float3(0, 1, 0)).xyzz;", 16);
            float[] product = Enumerable.Range(0, 4).Select(r => (float)Enumerable.Range(0, 4).Sum(c => (4 * c + r) * (c + 1))).ToArray();
            Assert.That(got, Is.EqualTo(product.Concat(new float[] { 12, 13, 14, 15, 1, 5, 9, 13, 4, 5, 6, 6 })));
        }

        [Test]
        public void Buffers_of_float3_and_of_matrices_stride_tightly()
        {
            float[] got = Run("StructuredBuffer<float3> _A; StructuredBuffer<float3x3> _M; RWStructuredBuffer<float3> _Out;",
                "_Out[0] = _A[5]; _Out[1] = mul(_M[1], float3(1, 0, 0)); _Out[2] = mul(float3(1, 0, 0), _M[1]);", 9);
            Assert.That(got, Is.EqualTo(new float[] { 15, 16, 17, 9, 10, 11, 9, 12, 15 }));
        }

        [Test]
        public void Appended_elements_follow_one_another()
        {
            float[] got = Run("AppendStructuredBuffer<float3> _Out;", "for (int i = 0; i < 3; i++) _Out.Append(i + 1);", 9);
            Assert.That(got, Is.EqualTo(new float[] { 1, 1, 1, 2, 2, 2, 3, 3, 3 }));
        }

        [Test]
        public void Raw_buffers_count_bytes_and_exchange_words()
        {
            float[] got = Run("RWByteAddressBuffer _R; StructuredBuffer<float> _S; RWStructuredBuffer<float> _Out;",
                "uint bytes, old, n, stride; _R.GetDimensions(bytes); _S.GetDimensions(n, stride); _Out[0] = bytes; " +
                    "_R.InterlockedCompareExchange(8, asuint(2.0), 77, old); _Out[1] = asfloat(old); _Out[2] = _R.Load(8); _Out[3] = " +
                    "n; _Out[4] = stride;", 5);
            Assert.That(got, Is.EqualTo(new float[] { InputWords * 4, 2, 77, InputWords, 4 }));
        }

        [Test]
        public void Vertex_and_instance_ids_count_from_zero_wherever_the_draw_begins()
        {
            const string text = @"Shader ""T"" { SubShader { Pass { Cull Off ZTest Always
HLSLPROGRAM
#pragma vertex vert
#pragma fragment frag
struct ToFragment { float unused : TEXCOORD0; nointerpolation uint instance : INSTANCE; float4 clip : SV_Position; float2 xy : TEXCOORD1; };
ToFragment vert(uint vertex : SV_VertexID, uint instance : SV_InstanceID)
{
    ToFragment o;
    // A triangle over the whole target, of the first three vertices alone.
    o.xy = vertex < 3 ? float2(vertex == 1 ? 3 : -1, vertex == 2 ? 3 : -1) : 0;
    o.clip = float4(2 * o.xy, 0.5, 1) * 2;
    o.instance = instance; o.unused = 7;
    return o;
}
float4 frag(ToFragment i) : SV_Target { return float4(i.instance + 1, i.clip.w, i.clip.xy); }
ENDHLSL
} } }";
            const int size = 4;
            int messages = device.ValidationMessages.Count;
            using (var files = new ShaderFolder().Add("T.shader", text))
            using (DeviceTexture target = device.CreateTexture(new DeviceTextureDescription { Name = "Target",
                Format = DeviceFormat.RGBA32_Float, Width = size, Height = size, Depth = 1, Slices = 1, Mips = 1, Samples = 1,
                Target = true }))
            {
                ShaderPassSource source = files.Shader("T.shader").Passes[0];
                using (DevicePass pass = device.CreatePass(source.Compile(ShaderStage.Vertex, null), source.Compile(ShaderStage.Fragment, null)))
                {
                    device.BeginPass(new DeviceTargets { Color0 = target, ColorCount = 1, ClearColor = true, ViewportWidth = size,
                        ViewportHeight = size });
                    device.Draw(pass, source.ResolveState(null), new DeviceBinding[0],
                        new DeviceDraw { VertexCount = 3, InstanceCount = 1, FirstVertex = 6, FirstInstance = 5 });
                    device.EndPass();
                    float[] texels = MemoryMarshal.Cast<byte, float>(device.ReadTexture(target, 0, 0)).ToArray();
                    Assert.That(texels.Take(4), Is.EqualTo(new[] { 1, 2, 0.5f, 0.5f }), "instance 0, Direct3D's w, the first texel's center");
                    Assert.That(texels.Skip(4 * (size * size - 1)), Is.EqualTo(new[] { 1, 2, size - 0.5f, size - 0.5f }));
                }
            }
            Assert.That(device.ValidationMessages.Skip(messages), Is.Empty);
        }
    }
}
