using System.Linq;
using Host.Check;
using Host.Shaders;
using NUnit.Framework;
using UnityEngine.Headless;

namespace Host.Tests
{
    /// <summary>The rule that compares layouts, on a package that is well and on planted differences.</summary>
    public sealed class CheckLayoutTests
    {
        const string Kernel = @"#pragma kernel K
struct Element { float3 p; uint id; float2x3 m; };
StructuredBuffer<Element> _In; RWStructuredBuffer<float3> _Out; AppendStructuredBuffer<uint2> _List; ByteAddressBuffer _Raw;
float4 _Scales[3]; float3x3 _Turn; float _Last; cbuffer Named { float2 _A; float3 _B; bool _Is; int2 _Cells[2]; row_major float2x4 _Rows; };
[numthreads(8,4,1)] void K(uint3 id : SV_DispatchThreadID)
{
    Element e = _In[id.x];
    _Out[id.x] = mul(_Turn, e.p) * _Scales[e.id & 1].x + _Last + float3(mul(e.m, e.p), _Is ? _B.x : _A.y) + float3(mul(_Rows, (float4)1),
        _Cells[1].x);
    _List.Append(_Raw.Load2(8 * id.x));
}
";

        /// <summary>glslang, with a fault of its own.</summary>
        sealed class Faulty : IShaderBackend
        {
            public System.Action<ShaderProgram> Fault;
            public string Name => "faulty";
            public PreprocessedSource Preprocess(CompileRequest request, IncludeResolver resolver)
                => ShaderBackend.Glslang.Preprocess(request, resolver);
            public string KeyOf(PreprocessedSource source, CompileRequest request) => System.Guid.NewGuid().ToString();     // never from the cache

            public CompiledProgram Build(PreprocessedSource source, CompileRequest request, SourceDeclarations declarations)
            {
                CompiledProgram compiled = ShaderBackend.Glslang.Build(source, request, declarations);
                Fault(compiled.Program);
                return compiled;
            }
        }

        static Findings Examine(string file, string text, IShaderBackend host = null)
        {
            using (var package = new SyntheticPackage().Add(file, text))
                return new LayoutRule(null, host ?? ShaderBackend.Glslang, ShaderBackend.Fxc).Examine(package.Tree);
        }

        [Test]
        public void Equal_layouts_are_well()
        {
            Findings findings = Examine("A.compute", Kernel);
            Assert.That(findings.Faults, Is.Empty);
            Assert.That(findings.Looked, Is.EqualTo("5 buffers and 8 constants of 1 programs"));
        }

        static void MoveField(ShaderProgram program)
        {
            ConstantField[] fields = program.Resources.Single(r => r.Name == "Named").Constants.Fields;
            int i = System.Array.FindIndex(fields, f => f.Name == "_B");
            fields[i].Offset -= 4;
        }

        [Test]
        public void A_constant_at_other_bytes_is_a_fault()
            => Assert.That(Examine("A.compute", Kernel, new Faulty { Fault = MoveField }).Faults,
                Is.EqualTo(new[] {
                "A.compute (K): Named._B is Float 1 x 3 of 12 bytes at byte 12 here, FXC's is Float 1 x 3 of 12 bytes at byte 16" }));

        [Test]
        public void An_element_of_another_size_is_a_fault()
            => Assert.That(Examine("A.compute", Kernel,
                new Faulty { Fault = p => p.Resources.Single(r => r.Name == "_Out").Stride = 16 }).Faults,
                Is.EqualTo(new[] { "A.compute (K): an element of '_Out' has 16 bytes here, FXC's 12" }));

        [Test]
        public void A_resource_that_the_host_does_not_bind_is_a_fault()
            => Assert.That(Examine("A.compute", Kernel,
                new Faulty { Fault = p => p.Resources = p.Resources.Where(r => r.Name != "_Raw").ToArray() }).Faults,
                Is.EqualTo(new[] { "A.compute (K): FXC's program reads '_Raw', a RawBuffer, which the host's does not" }));

        [Test]
        public void Another_size_of_groups_is_a_fault()
            => Assert.That(Examine("A.compute", Kernel, new Faulty { Fault = p => p.GroupY = 1 }).Faults,
                Is.EqualTo(new[] { "A.compute (K): groups are of 8 x 1 x 1 threads here, FXC's of 8 x 4 x 1" }));

        [Test]
        public void Stages_that_list_their_values_in_different_orders_are_a_fault()
        {
            const string text = @"Shader ""T"" { SubShader { Pass { HLSLPROGRAM
#pragma vertex vert
#pragma fragment frag
struct Out { float4 clip : SV_Position; float3 normal : NORMAL; float4 color : COLOR; };
struct In { float4 clip : SV_Position; float4 color : COLOR; float3 normal : NORMAL; };
Out vert(float4 p : POSITION) { Out o; o.clip = p; o.normal = p.xyz; o.color = p; return o; }
float4 frag(In i) : SV_Target { return i.color * i.normal.x; }
ENDHLSL } } }";
            Assert.That(Examine("T.shader", text).Faults, Is.EqualTo(new[] { "T.shader (frag): T.shader(3): error: in 'frag': the " +
                "fragment program reads COLOR from another register than the vertex program writes it to; Direct3D joins stages by " +
                "register: declare the same struct, or the same order, in both" }));
        }
    }
}
