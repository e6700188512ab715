using System.Linq;
using System.Runtime.InteropServices;
using NUnit.Framework;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Headless;

namespace Host.Tests
{
    /// <summary>Kernels as users write them, not as the package's own are.</summary>
    public class GraphicsKernelStyleTests : ShaderTextFixture
    {
        static float[] Run(string text, int count, System.Action<ComputeShader> set = null, int kernel = 0)
        {
            ComputeShader shader = ComputeOf(text);
            set?.Invoke(shader);
            using (var buffer = new ComputeBuffer(count, sizeof(float)))
            {
                buffer.SetData(new float[count]);
                shader.SetBuffer(kernel, "Result", buffer);
                shader.Dispatch(kernel, 1, 1, 1);
                var values = new float[count];
                buffer.GetData(values);
                return values;
            }
        }

        [Test]
        public void Loose_globals_are_set_by_every_call()
        {
            const string text = @"#pragma kernel CSMain
RWStructuredBuffer<float> Result;
float dt; int count; uint flags; bool on; float2 a; float3 b; float4 c; float4x4 m; float4 list[3]; float numbers[2]; int3 cell; half h;
[numthreads(8,1,1)]
void CSMain (uint3 id : SV_DispatchThreadID)
{
    if (id.x > 0) return;
    Result[0] = dt; Result[1] = count; Result[2] = flags; Result[3] = on ? 1 : 0; Result[4] = a.y; Result[5] = b.z; Result[6] = c.w;
    Result[7] = mul(m, float4(1, 2, 3, 1)).x; Result[8] = list[2].y; Result[9] = numbers[1]; Result[10] = cell.z; Result[11] = h;
}";
            float[] values = Run(text, 12, s =>
            {
                s.SetFloat("dt", 0.5f);
                s.SetInt("count", 7);
                s.SetInt("flags", 3);
                s.SetBool("on", true);
                s.SetVector("a", new Vector4(1, 2, 3, 4));
                s.SetFloats("b", 5, 6, 7);
                s.SetVector("c", new Vector4(1, 2, 3, 9));
                s.SetMatrix("m", Matrix4x4.Translate(new Vector3(10, 0, 0)));
                s.SetVectorArray("list", new[] { Vector4.zero, Vector4.one, new Vector4(0, 8, 0, 0) });
                // An array of floats lies 16 bytes apart, and SetFloats takes the bytes as they come.
                s.SetFloats("numbers", 1, 0, 0, 0, 2, 0, 0, 0);
                s.SetInts("cell", 1, 2, 3);
                s.SetFloat("h", 0.25f);
            });
            Assert.That(values, Is.EqualTo(new float[] { 0.5f, 7, 3, 1, 2, 7, 9, 11, 8, 2, 3, 0.25f }));
        }

        [Test]
        public void Macros_static_tables_and_inout_parameters_work()
        {
            const string text = @"#pragma kernel First
#pragma kernel Second
#define THREADS 4
#define THREADS_2D THREADS, 1, 1
#define SQ(x) ((x) * (x))
static const int2 offsets[4] = { int2(1, 0), int2(0, 1), int2(-1, 0), int2(0, -1) };
static const float weights[] = { 0.25, 0.5, 0.75, 1.0 };
RWStructuredBuffer<float> Result;
groupshared float cache[THREADS];
void Shift(inout float values[4], out float sum, in float by) { sum = 0; for (int i = 0; i < 4; ++i) { values[i] += by; sum += values[i]; } }
uint Hash(uint s) { s ^= 2747636419u; s *= 2654435769u; s ^= s >> 16; return s; }
[numthreads(THREADS_2D)]
void First(uint3 id : SV_DispatchThreadID, uint gi : SV_GroupIndex, uint3 gid : SV_GroupID, uint3 tid : SV_GroupThreadID)
{
    float values[4] = { 1, 2, 3, 4 };
    float sum;
    Shift(values, sum, (float)id.x);
    cache[tid.x] = sum;
    GroupMemoryBarrierWithGroupSync();
    Result[id.x] = cache[THREADS - 1 - gi] + SQ(offsets[id.x].x + offsets[id.x].y) * weights[id.x] + gid.y;
}
[numthreads(1,1,1)]
void Second() { Result[0] = Hash(1) & 0xFF; int n = 0; while (true) { if (++n > 5) break; } do { n--; } while (n > 3); switch (n) { case 3: Result[1] = 33; break; default: Result[1] = 0; break; } Result[2] = fmod(7.5, 2) + sign(-3) + step(1, 2) + smoothstep(0, 1, 0.5) + clamp(5, 0, 1); Result[3] = asfloat(asuint(2.5)) + countbits(7u) + firstbithigh(8u); }";
            Assert.That(Run(text, 4), Is.EqualTo(new[] { 22.25f, 18.5f, 14.75f, 11f }));
            float[] second = Run(text, 4, kernel: 1);
            uint s = unchecked((1u ^ 2747636419u) * 2654435769u);
            Assert.That(second, Is.EqualTo(new float[] { (s ^ s >> 16) & 0xFF, 33, 1.5f - 1 + 1 + 0.5f + 1, 2.5f + 3 + 3 }));
        }

        [StructLayout(LayoutKind.Sequential)]
        struct Agent
        {
            public Vector2 Position;
            public float Angle;
            public int Alive;       // a bool in the shader
            public Vector3Int Cell;
            public Matrix4x4 Pose;
        }

        [Test]
        public void Structs_with_bools_ints_and_matrices_go_there_and_back()
        {
            const string text = @"#pragma kernel Update
struct Agent { float2 position; float angle; bool alive; int3 cell; float4x4 pose; };
RWStructuredBuffer<Agent> agents;
StructuredBuffer<float4x4> poses;
uint numAgents;
[numthreads(16,1,1)]
void Update(uint id : SV_DispatchThreadID)
{
    if (id >= numAgents) return;
    Agent a = agents[id];
    a.position = mul(poses[id], float4(a.position, 0, 1)).xy;
    a.alive = !a.alive;
    a.cell.z -= 1;
    a.pose[0][3] = a.angle;
    agents[id] = a;
}";
            ComputeShader shader = ComputeOf(text);
            var agents = Enumerable.Range(0, 5)
                .Select(i => new Agent { Position = new Vector2(i, 1), Angle = i * 0.5f, Alive = i % 2, Cell = new Vector3Int(1, 2, i),
                Pose = Matrix4x4.identity }).ToArray();
            using (var native = new NativeArray<Agent>(agents, Allocator.Temp))
            using (var buffer = new ComputeBuffer(5, Marshal.SizeOf<Agent>()))
            using (var poses = new ComputeBuffer(5, 64))
            {
                buffer.SetData(native);
                poses.SetData(Enumerable.Repeat(Matrix4x4.Translate(Vector3.up), 5).ToList());
                shader.SetBuffer(0, "agents", buffer);
                shader.SetBuffer(0, "poses", poses);
                shader.SetInt("numAgents", 5);
                shader.Dispatch(0, 1, 1, 1);
                buffer.GetData(agents);
            }
            for (int i = 0; i < 5; i++)
            {
                Assert.That(agents[i].Position, Is.EqualTo(new Vector2(i, 2)));
                Assert.That(agents[i].Alive != 0, Is.EqualTo(i % 2 == 0));
                Assert.That(agents[i].Cell, Is.EqualTo(new Vector3Int(1, 2, i - 1)));
                Assert.That(agents[i].Pose.m03, Is.EqualTo(i * 0.5f));
            }
        }

        static RenderTexture Writable(RenderTextureFormat format, RenderTextureReadWrite readWrite = RenderTextureReadWrite.Linear)
        {
            var texture = new RenderTexture(8, 8, 0, format, readWrite) { enableRandomWrite = true };
            texture.Create();
            return texture;
        }

        [Test]
        public void A_kernel_writes_and_reads_back_pictures_of_any_format([Values(RenderTextureFormat.ARGB32, RenderTextureFormat.ARGBHalf,
            RenderTextureFormat.ARGBFloat, RenderTextureFormat.Default)] RenderTextureFormat format)
        {
            const string text = @"#pragma kernel Fill
#pragma kernel Fade
RWTexture2D<float4> Result;
[numthreads(8,8,1)] void Fill(uint3 id : SV_DispatchThreadID) { Result[id.xy] = float4(id.x / 8.0, id.y / 8.0, 1, 1); }
[numthreads(8,8,1)] void Fade(uint3 id : SV_DispatchThreadID) { Result[id.xy] = max(0, Result[id.xy] - float4(0.25, 0, 0.5, 0)); }";
            ComputeShader shader = ComputeOf(text);
            RenderTexture texture = Writable(format);
            shader.SetTexture(0, "Result", texture);
            shader.SetTexture(1, "Result", texture);
            shader.Dispatch(0, texture.width / 8, texture.height / 8, 1);
            shader.Dispatch(1, texture.width / 8, texture.height / 8, 1);
            Vector4[] texels = Read(texture);
            Object.DestroyImmediate(texture);
            Vector4 texel = texels[2 * 8 + 6];
            Assert.That(texel.x, Is.EqualTo(0.5f).Within(0.005f));
            Assert.That(texel.y, Is.EqualTo(0.25f).Within(0.005f));
            Assert.That(texel.z, Is.EqualTo(0.5f).Within(0.005f));
        }

        [Test]
        public void One_channel_formats_take_floats_and_ints()
        {
            const string text = @"#pragma kernel Main
RWTexture2D<float> Height; RWTexture2D<int> Number; RWTexture2D<float2> Pair; RWTexture3D<float4> Volume;
[numthreads(8,8,1)] void Main(uint3 id : SV_DispatchThreadID) { Height[id.xy] = id.x + Height[id.xy]; InterlockedAdd(Number[id.xy], 5); Pair[id.xy] = id.xy; Volume[id] = float4(id, 1); }";
            ComputeShader shader = ComputeOf(text);
            RenderTexture height = Writable(RenderTextureFormat.RFloat), number = Writable(RenderTextureFormat.RInt),
                pair = Writable(RenderTextureFormat.RGHalf);
            var volume = new RenderTexture(8, 8, 0,
                RenderTextureFormat.ARGBHalf) { dimension = UnityEngine.Rendering.TextureDimension.Tex3D, volumeDepth = 2,
                enableRandomWrite = true };
            volume.Create();
            shader.SetTexture(0, "Height", height);
            shader.SetTexture(0, "Number", number);
            shader.SetTexture(0, "Pair", pair);
            shader.SetTexture(0, "Volume", volume);
            shader.Dispatch(0, 1, 1, 2);
            Assert.That(Read(height)[5].x, Is.GreaterThanOrEqualTo(5));
            Assert.That(Read(pair)[8 * 3 + 5], Is.EqualTo(new Vector4(5, 3, 0, 1)));
            float[] values = Run("#pragma kernel Main\nTexture2D<int> Number; Texture3D<float4> Volume; RWStructuredBuffer<float> " +
                "Result; [numthreads(1,1,1)] void Main() { Result[0] = Number[int2(1, 1)]; Result[1] = Number.Load(int3(1, 1, 0)); " +
                "Result[2] = Volume[int3(3, 4, 1)].z + Volume[int3(3, 4, 1)].x; }", 3, s =>
            {
                s.SetTexture(0, "Number", number);
                s.SetTexture(0, "Volume", volume);
            });
            Assert.That(values, Is.EqualTo(new float[] { 10, 10, 4 }));
            foreach (RenderTexture texture in new[] { height, number, pair, volume })
                Object.DestroyImmediate(texture);
        }

        [Test]
        public void Textures_are_sampled_by_their_own_and_by_inline_samplers()
        {
            var texture = new Texture2D(2, 2, TextureFormat.RGBAHalf, false, true) { wrapMode = TextureWrapMode.Clamp,
                filterMode = FilterMode.Point };
            texture.SetPixels(new[] { new Color(0, 0, 0, 1), new Color(1, 0, 0, 1), new Color(0, 1, 0, 1), new Color(1, 1, 0, 1) });
            texture.Apply();
            float[] values = Run(@"#pragma kernel Main
Texture2D<float4> Source; SamplerState samplerSource; SamplerState my_linear_clamp_sampler; SamplerState sampler_point_repeat;
RWStructuredBuffer<float> Result; float4 Source_TexelSize;
[numthreads(1,1,1)] void Main()
{
    Result[0] = Source.SampleLevel(samplerSource, float2(0.6, 0.1), 0).r;
    Result[1] = Source.SampleLevel(my_linear_clamp_sampler, float2(0.5, 0.25), 0).r;
    Result[2] = Source.SampleLevel(sampler_point_repeat, float2(1.1, 0.75), 0).g;
    uint w, h; Source.GetDimensions(w, h); Result[3] = w * 10 + h;
    Result[4] = Source[uint2(1, 1)].r;
}", 5, s => s.SetTexture(0, "Source", texture));
            Object.DestroyImmediate(texture);
            Assert.That(values, Is.EqualTo(new[] { 1, 0.5f, 1, 22, 1 }).Within(1e-5f));
        }

        [Test]
        public void A_mip_level_is_bound_for_writing()
        {
            var texture = new RenderTexture(8, 8, 0, RenderTextureFormat.ARGBFloat) { enableRandomWrite = true, useMipMap = true,
                autoGenerateMips = false };
            texture.Create();
            ComputeShader shader = ComputeOf("#pragma kernel Main\nRWTexture2D<float4> Result;\n[numthreads(1,1,1)] void Main(uint3 id " +
                ": SV_DispatchThreadID) { Result[id.xy] = 3; }");
            shader.SetTexture(0, "Result", texture, 2);
            shader.Dispatch(0, 2, 2, 1);
            float[] values = Run("#pragma kernel Main\nTexture2D<float4> Source; RWStructuredBuffer<float> Result; [numthreads(1,1,1)] " +
                "void Main() { Result[0] = Source.Load(int3(1, 1, 2)).r; Result[1] = Source.mips[2][uint2(0, 0)].r; Result[2] = " +
                "Source.Load(int3(0, 0, 0)).r; }", 3, s => s.SetTexture(0, "Source", texture));
            Object.DestroyImmediate(texture);
            Assert.That(values, Is.EqualTo(new float[] { 3, 3, 0 }));
        }

        [Test]
        public void Kernels_may_use_the_editors_include_files()
        {
            float[] values = Run("#pragma kernel Main\n#include \"UnityCG.cginc\"\nRWStructuredBuffer<float> " +
                "Result;\n[numthreads(1,1,1)] void Main() { fixed4 c = fixed4(1, 1, 1, 1); Result[0] = UNITY_PI + Luminance(c.rgb) * " +
                "0; Result[1] = _Time.y * 0 + 2; }", 2);
            Assert.That(values[0], Is.EqualTo(Mathf.PI).Within(1e-5f));
        }
    }
}
