using System;
using System.Collections.Generic;
using System.Linq;
using Host.Shaders;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>Data read from the bytes that FXC emits: resources, layouts, signatures, barriers.</summary>
    public class ResourceDefinitionsTests
    {
        const string Text = @"struct S { float3 p; uint n; float2x3 m; };
StructuredBuffer<S> _Elements; RWStructuredBuffer<float3> _Out; AppendStructuredBuffer<uint2> _List; ByteAddressBuffer _Raw;
    RWStructuredBuffer<uint> _Counted;
Texture3D<float> _Volume; SamplerState linearClampSampler; Buffer<uint2> _Texels; RWTexture2D<float4> _Image;
float4 _Tint = float4(1, 2, 3, 4); float3x4 _Turn; row_major float2x4 _Rows[2];
cbuffer Named { int _Count; bool _Is; S _One; float _Unused; }
groupshared uint g_A[64];
[numthreads(8, 4, 2)] void K(uint3 id : SV_DispatchThreadID, uint i : SV_GroupIndex)
{
    S e = _Elements[id.x];
    g_A[i] = e.n;
    GroupMemoryBarrierWithGroupSync();
    float v = _Volume.SampleLevel(linearClampSampler, e.p, 0);
    _Out[id.x] = mul(e.m, e.p).xyx * v + _Tint.xyz + mul(_Turn, _Tint) + mul(_Rows[1], _Tint).x + _One.p;
    if (_Is) _List.Append(_Raw.Load2(_Count) + _Texels[g_A[63 - i]]);
    _Counted[_Counted.IncrementCounter()] = i;
    AllMemoryBarrier();
    _Image[id.xy] = v;
}
";

        static readonly Lazy<DxbcContainer> kernel = new Lazy<DxbcContainer>(() => new DxbcContainer(Compile(Text, "K", "cs_5_0")));

        static byte[] Compile(string text, string entry, string profile)
        {
            FxcResult result = new FxcCompiler().Compile(new FxcRequest
            {
                Name = "test", Source = new PreprocessedSource { Text = text }, EntryPoint = entry, EntryLine = new SourceLine("test", 1),
                    Profile = profile, Flags = FxcFlags.OptimizationLevel3,
            });
            Assert.That(result.Errors, Is.Empty);
            return result.Dxbc;
        }

        [Test]
        public void Resources_have_their_kinds_registers_and_strides()
        {
            IEnumerable<string> resources = new ResourceDefinitions(kernel.Value).Resources.Select(r =>
                $"{r.Name} {r.Type} {r.Register} {r.Stride} {r.Dimension} {r.Components}");
            Assert.That(resources, Is.EquivalentTo(new[]
            {
                "linearClampSampler Sampler 0 0 Unknown 1",
                "_Elements Structured 0 40 Buffer 1",
                "_Raw ByteAddress 1 0 Buffer 1",
                "_Volume Texture 2 0 Texture3D 1",
                "_Texels Texture 3 0 Buffer 2",
                "_Out RWStructured 0 12 Buffer 1",
                "_List Append 1 8 Buffer 1",
                "_Counted RWStructuredWithCounter 2 4 Buffer 1",
                "_Image RWTyped 3 0 Texture2D 4",
                "$Globals ConstantBuffer 0 0 Unknown 1",
                "Named ConstantBuffer 1 0 Unknown 1",
            }));
        }

        [Test]
        public void Constants_have_their_offsets_sizes_and_types()
        {
            DefinedBuffer globals = new ResourceDefinitions(kernel.Value).ConstantBuffers.Single(b => b.Name == "$Globals"),
                named = new ResourceDefinitions(kernel.Value).ConstantBuffers.Single(b => b.Name == "Named");
            string Line(DefinedVariable v) => $"{v.Name} {v.Offset} {v.Bytes} {v.Type.Class} {v.Type.Rows}x{v.Type.Columns} " +
                $"[{v.Type.Elements}]{(v.IsUsed ? "" : " unused")}";
            Assert.That(globals.Variables.Select(Line),
                Is.EqualTo(new[] { "_Tint 0 16 Vector 1x4 [0]", "_Turn 16 60 MatrixColumns 3x4 [0]", "_Rows 80 64 MatrixRows 2x4 [2]" }));
            Assert.That(globals.Bytes, Is.EqualTo(144));
            Assert.That(named.Variables.Select(Line),
                Is.EqualTo(new[] { "_Count 0 4 Scalar 1x1 [0]", "_Is 4 4 Scalar 1x1 [0]", "_One 16 56 Struct 1x10 [0]",
                "_Unused 72 4 Scalar 1x1 [0] unused" }));
            Assert.That(named.Variables.Take(2).Select(v => v.Type.Type), Is.EqualTo(new[] { ShaderVariableType.Int, ShaderVariableType.Bool }));
            Assert.That(named.Variables[2].Type.Members.Select(m => $"{m.Name} {m.Offset}"), Is.EqualTo(new[] { "p 0", "n 12", "m 16" }));
            Assert.That(Enumerable.Range(0, 4).Select(i => BitConverter.ToSingle(globals.Variables[0].Default, 4 * i)),
                Is.EqualTo(new[] { 1, 2, 3, 4 }));
            Assert.That(globals.Variables[1].Default, Is.Null);
        }

        [Test]
        public void Elements_of_structured_buffers_have_their_members()
        {
            DefinedBuffer elements = new ResourceDefinitions(kernel.Value).Elements.Single(b => b.Name == "_Elements");
            Assert.That(elements.Variables.Single().Type.Members.Select(m => $"{m.Name} {m.Offset}"), Is.EqualTo(new[] { "p 0", "n 12", "m 16" }));
            Assert.That(elements.Bytes, Is.EqualTo(40));
        }

        [Test]
        public void Barriers_and_groups_are_those_of_the_source()
        {
            var order = new DxbcBarriers(kernel.Value);
            Assert.That(order.Barriers, Is.EqualTo(new[] { SyncFlags.ThreadsInGroup | SyncFlags.Groupshared,
                SyncFlags.Groupshared | SyncFlags.UavGlobal }));
            Assert.That(order.HaveCommonUavs, Is.True);
            Assert.That(new DxbcDeclarations(kernel.Value).GroupSize, Is.EqualTo((8, 4, 2)));
        }

        [Test]
        public void A_buffer_declared_globallycoherent_is_shared_without_a_barrier()
        {
            string text = "RWStructuredBuffer<uint> _Out; [numthreads(1,1,1)] void K() { _Out[0] = 1; }";
            Assert.That(new DxbcBarriers(new DxbcContainer(Compile(text, "K", "cs_5_0"))).HaveCommonUavs, Is.False);
            Assert.That(new DxbcBarriers(new DxbcContainer(Compile("globallycoherent " + text, "K", "cs_5_0"))).HaveCommonUavs, Is.True);
        }

        [Test]
        public void Signatures_share_registers()
        {
            const string text = "struct V { float4 clip : SV_Position; float2 uv : TEXCOORD0; float fog : FOG; nointerpolation uint id : ID7; };\n" +
                "V vert(float4 at : POSITION, uint i : SV_InstanceID) { V v; v.clip = at; v.uv = at.xy; v.fog = at.z; v.id = i; return v; }\n" +
                "float4 frag(V v) : SV_Target { return v.fog + v.id; }";
            string Line(SignatureElement e) => $"{e.Semantic.Full} {e.SystemValue} r{e.Register} {e.Mask}";
            var vertex = new DxbcContainer(Compile(text, "vert", "vs_5_0"));
            Assert.That(Signature.Inputs(vertex).Select(Line), Is.EqualTo(new[] { "POSITION0 0 r0 15", "SV_INSTANCEID0 8 r1 1" }));
            Assert.That(Signature.Outputs(vertex).Select(Line),
                Is.EqualTo(new[] { "SV_POSITION0 1 r0 15", "TEXCOORD0 0 r1 3", "FOG0 0 r1 4", "ID7 0 r2 1" }));
            Assert.That(Signature.Inputs(new DxbcContainer(Compile(text, "frag", "ps_5_0"))).Where(e => e.ReadMask != 0)
                .Select(e => e.Semantic.Short), Is.EqualTo(new[] { "FOG", "ID7" }));
        }

        [Test]
        public void A_chunk_that_is_cut_off_is_named()
        {
            byte[] dxbc = Compile(Text, "K", "cs_5_0");
            int rdef = Enumerable.Range(0, dxbc.Length - 4).First(i => dxbc[i] == 'R' && dxbc[i + 1] == 'D' && dxbc[i + 2] == 'E'
                && dxbc[i + 3] == 'F');
            BitConverter.GetBytes(0x7FFFFFF0).CopyTo(dxbc, rdef + 8 + 12);     // where the resources stand
            Assert.That(Assert.Throws<FormatException>(() => new ResourceDefinitions(new DxbcContainer(dxbc))).Message,
            Does.StartWith("The RDEF chunk has"));
        }
    }
}
