using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Text;
using System.Threading.Tasks;
using Host.Shaders;
using NUnit.Framework;
using UnityEngine.Headless;

namespace Host.Tests
{
    /// <summary>A folder of shader files that lasts as long as a test.</summary>
    sealed class ShaderFolder : IDisposable
    {
        readonly string folder = Directory.CreateTempSubdirectory("rill-shader-tests-").FullName;

        public string CachePath => Path.Combine(folder, "cache");
        public void Dispose() => Directory.Delete(folder, recursive: true);

        public ShaderFolder Add(string name, string text, Encoding encoding = null)
        {
            string path = Path.Combine(folder, name);
            Directory.CreateDirectory(Path.GetDirectoryName(path));
            File.WriteAllText(path, text, encoding ?? new UTF8Encoding(false));
            return this;
        }

        // "Packages/name/..." and "Assets/..." lie in folders of those names.
        string Resolve(string path) => File.Exists(Path.Combine(folder, path)) ? Path.Combine(folder, path) : null;

        public ComputeShaderSource Compute(string name)
            => ShaderImporter.ImportCompute(Path.Combine(folder, name), name, Resolve, new ShaderCache(CachePath));
        public ShaderSource Shader(string name) => ShaderImporter.ImportShader(Path.Combine(folder, name), name, Resolve, new ShaderCache(CachePath));

        /// <summary>The first kernel of a file made of that text.</summary>
        public static ShaderProgram Compile(string text, params string[] keywords)
        {
            using (var files = new ShaderFolder().Add("Test.compute", text))
                return Checked(files.Compute("Test.compute").Compile(0, keywords));
        }

        public static ShaderProgram Checked(ShaderProgram program)
        {
            string path = Path.GetTempFileName();
            try
            {
                File.WriteAllBytes(path, program.Spirv);
                var start = new ProcessStartInfo("spirv-val", "--target-env vulkan1.1 --scalar-block-layout " + path) {
                    RedirectStandardError = true, RedirectStandardOutput = true };
                using (Process process = Process.Start(start))
                {
                    string log = process.StandardError.ReadToEnd() + process.StandardOutput.ReadToEnd();
                    process.WaitForExit();
                    Assert.That(process.ExitCode, Is.EqualTo(0), $"spirv-val on {program.Name}: {log}");
                }
            }
            finally
            {
                File.Delete(path);
            }
            return program;
        }
    }

    public class ShaderImportTests
    {
        const string Threads = "[numthreads(8, 4, 1)] ";

        static ShaderResource Find(ShaderProgram program, string name, ShaderResourceKind? kind = null)
            => program.Resources.Single(r => r.Name == name && (kind == null || r.Kind == kind));

        static ConstantField Field(ShaderProgram program, string name)
            => program.Resources.Where(r => r.Constants != null).SelectMany(r => r.Constants.Fields).Single(f => f.Name == name);

        // ---- structured buffers

        [TestCase("float", 4)]
        [TestCase("float2", 8)]
        [TestCase("float3", 12)]
        [TestCase("float4", 16)]
        [TestCase("uint3", 12)]
        [TestCase("bool", 4)]
        [TestCase("half3", 12)]
        [TestCase("float3x3", 36)]
        [TestCase("float4x4", 64)]
        [TestCase("float3x4", 48)]
        [TestCase("float4x3", 48)]
        [TestCase("float2x3", 24)]
        public void A_structured_buffers_stride_is_the_sum_of_its_scalars(string type, int stride)
        {
            ShaderProgram program = ShaderFolder.Compile($"#pragma kernel K\nStructuredBuffer<{type}> _In; RWStructuredBuffer<{type}> " +
                $"_Out;\n{Threads}void K(uint3 id : SV_DispatchThreadID) {{ _Out[id.x] = _In[id.x]; }}");
            Assert.That(Find(program, "_In").Stride, Is.EqualTo(stride));
            Assert.That(Find(program, "_Out").Stride, Is.EqualTo(stride));
            Assert.That(Find(program, "_In").Kind, Is.EqualTo(ShaderResourceKind.StructuredBuffer));
            Assert.That(Find(program, "_Out").Kind, Is.EqualTo(ShaderResourceKind.RWStructuredBuffer));
        }

        [Test]
        public void Structs_in_structured_buffers_have_no_padding()
        {
            const string text = @"#pragma kernel K
struct Inner { float3 p; float s; float2 uv; };
struct Element { float a; float3 b; Inner inner; float2 c; Inner two[2]; float4 d; float3x3 m; row_major float2x3 r; float3 tail[2]; };
StructuredBuffer<Element> _In; RWStructuredBuffer<Element> _Out;
[numthreads(1,1,1)] void K(uint3 id : SV_DispatchThreadID) { _Out[id.x] = _In[id.x + 1]; }";
            const int inner = 24;
            Assert.That(Find(ShaderFolder.Compile(text), "_Out").Stride, Is.EqualTo(4 + 12 + inner + 8 + 2 * inner + 16 + 36 + 24 + 24));
        }

        [Test]
        public void Structs_with_doubles_are_aligned_to_eight()
        {
            const string text = @"#pragma kernel K
struct Element { float a; double b; float c; };
RWStructuredBuffer<Element> _Out;
[numthreads(1,1,1)] void K() { Element e; e.a = 1; e.b = 2; e.c = 3; _Out[0] = e; }";
            Assert.That(Find(ShaderFolder.Compile(text), "_Out").Stride, Is.EqualTo(24));
        }

        [Test]
        [ByGlslang("vkd3d's modules address buffers by words")]
        public void Offsets_in_the_module_are_those_of_the_stride()
        {
            const string text = @"#pragma kernel K
struct Element { float3 a; float3 b; float3x2 m; float c; };
RWStructuredBuffer<Element> _Out;
[numthreads(1,1,1)] void K() { Element e = (Element)0; _Out[0] = e; }";
            SpirvModule module = SpirvModule.Read(ShaderFolder.Compile(text).Spirv);
            var types = new SpirvTypes(module);
            Instruction element = module.Instructions.Single(i => i.Op == Op.TypeStruct && types.Name(i[0]) == "Element"
                && types.Decorated(i[0], 0, Decoration.Offset) != null);
            int[] offsets = Enumerable.Range(0, 4).Select(m => (int)types.Decorated(element[0], m, Decoration.Offset)[3]).ToArray();
            Assert.That(offsets, Is.EqualTo(new[] { 0, 12, 24, 48 }));
            Assert.That(types.Decorated(element[0], 2, Decoration.MatrixStride)[3], Is.EqualTo(12), "two columns of three floats");
        }

        [Test]
        public void Matrices_are_column_major_unless_declared_otherwise()
        {
            const string text = @"#pragma kernel K
float2x3 _Columns; row_major float2x3 _Rows;
RWStructuredBuffer<float2> _Out;
[numthreads(1,1,1)] void K() { _Out[0] = mul(_Columns, float3(1, 2, 3)) + mul(_Rows, float3(1, 2, 3)); }";
            ShaderProgram program = ShaderFolder.Compile(text);
            ConstantField columns = Field(program, "_Columns"), rows = Field(program, "_Rows");
            Assert.That(new[] { columns.Rows, columns.Columns, columns.Bytes, columns.MatrixStride }, Is.EqualTo(new[] { 2, 3, 40, 16 }),
                "three columns of two");
            Assert.That(columns.RowMajor, Is.False);
            Assert.That(new[] { rows.Rows, rows.Columns, rows.Bytes, rows.MatrixStride }, Is.EqualTo(new[] { 2, 3, 28, 16 }), "two rows of three");
            Assert.That(rows.RowMajor, Is.True);
            Assert.That(rows.Offset, Is.EqualTo(48));
        }

        // ---- constant buffers

        // Expected offsets: Direct3D's packing rules, from the end of what stands before.
        [TestCase("float3 a; float b;", 0, 12)]
        [TestCase("float2 a; float3 b;", 0, 16)]
        [TestCase("float a; float3 b;", 0, 4)]
        [TestCase("float a; float4 b;", 0, 16)]
        [TestCase("float2 a; float2 b;", 0, 8)]
        [TestCase("float a[4]; float b;", 0, 52)]
        [TestCase("float2 a[3]; float2 b;", 0, 40)]
        [TestCase("float4 a[3]; float b;", 0, 48)]
        [TestCase("float a; float b[2];", 0, 16)]
        [TestCase("float3x3 a; float b;", 0, 44)]
        [TestCase("float4x4 a; float b;", 0, 64)]
        [TestCase("row_major float3x4 a; float b;", 0, 48)]
        [TestCase("float3x4 a; float b;", 0, 60)]
        [TestCase("float a; float2x2 b;", 0, 16)]
        [TestCase("bool a; int b;", 0, 4)]
        [TestCase("float3x3 a[2]; float b;", 0, 92)]
        public void Constants_are_packed_as_in_Direct3D(string members, int a, int b)
        {
            foreach (string declaration in new[] { "cbuffer Params { " + members + " };", members })
            {
                ShaderProgram program = ShaderFolder.Compile($"#pragma kernel K\n{declaration}\nRWStructuredBuffer<float> " +
                    $"_Out;\n[numthreads(1,1,1)] void K() {{ _Out[0] = ((float[1])b)[0] + (float)a; }}"
                    .Replace("((float[1])b)[0] + (float)a", Use(members, "b") + " + " + Use(members, "a")));
                Assert.That(new[] { Field(program, "a").Offset, Field(program, "b").Offset }, Is.EqualTo(new[] { a, b }), declaration);
            }
        }

        // A float made of a member, whatever its type.
        static string Use(string members, string name)
        {
            string declaration = members.Split(';').Select(m => m.Trim()).Single(m => m.Split(' ').Last().Split('[')[0] == name);
            string element = name + (declaration.EndsWith("]") ? "[1]" : "");
            string type = declaration.Split(' ').Reverse().Skip(1).First();
            return type.Contains('x') ? element + "[0][0]" : char.IsDigit(type[type.Length - 1]) ? element + ".x" : element;
        }

        [Test]
        public void What_follows_a_struct_in_a_cbuffer_fills_its_last_register()
        {
            const string text = @"#pragma kernel K
struct S { float3 p; float s; float2 uv; };
cbuffer Params { float first; S inner; float after; S list[2]; float last; };
RWStructuredBuffer<float> _Out;
[numthreads(1,1,1)] void K() { _Out[0] = first + inner.s + after + list[1].uv.y + last; }";
            ShaderProgram program = ShaderFolder.Compile(text);
            Assert.That(Field(program, "after").Offset, Is.EqualTo(16 + 24));
            Assert.That(Field(program, "last").Offset, Is.EqualTo(48 + 32 + 24));
            ConstantLayout layout = Find(program, "Params").Constants;
            Assert.That(layout.Bytes, Is.EqualTo(112));
            Assert.That(layout.IsGlobals, Is.False);
        }

        [Test]
        public void Loose_globals_make_one_buffer_with_their_types()
        {
            const string text = @"#pragma kernel K
float _F; int _I; uint2 _U; float4 _Array[5]; bool _B;
RWStructuredBuffer<float> _Out;
[numthreads(1,1,1)] void K() { _Out[0] = _F + _I + _U.y + _Array[_I].w + (_B ? 1 : 0); }";
            ShaderProgram program = ShaderFolder.Compile(text);
            Assert.That(Find(program, "$Globals").Constants.IsGlobals, Is.True);
            Assert.That(Field(program, "_F").Type, Is.EqualTo(ConstantType.Float));
            Assert.That(Field(program, "_I").Type, Is.EqualTo(ConstantType.Int));
            Assert.That(Field(program, "_U").Type, Is.EqualTo(ConstantType.UInt));
            Assert.That(Field(program, "_U").Columns, Is.EqualTo(2));
            ConstantField array = Field(program, "_Array");
            Assert.That(new[] { array.ArrayLength, array.ArrayStride, array.Bytes }, Is.EqualTo(new[] { 5, 16, 80 }));
        }

        // ---- kernels, defines, keywords

        [Test]
        public void Each_kernel_has_its_own_defines_and_group()
        {
            const string text = @"#pragma kernel Small SIZE=32 FLAG
#pragma kernel Large SIZE=256    // a comment
RWStructuredBuffer<uint> _Out;
[numthreads(SIZE, 1, 1)] void Small() {
#ifdef FLAG
    this is no HLSL
#endif
}
[numthreads(SIZE, 2, 1)] void Large() { _Out[0] = 1; }";
            using (var files = new ShaderFolder().Add("A.compute", text))
            {
                ComputeShaderSource source = files.Compute("A.compute");
                Assert.That(source.Kernels, Is.EqualTo(new[] { "Small", "Large" }));
                ShaderProgram large = source.Compile(1, new string[0]);
                Assert.That(new[] { large.GroupX, large.GroupY, large.GroupZ }, Is.EqualTo(new[] { 256, 2, 1 }));
                var error = Assert.Throws<ShaderCompileException>(() => source.Compile(0, new string[0]));
                Assert.That(error.Line, Is.EqualTo(6), "FLAG is on in this kernel: " + error.Message);
            }
        }

        [TestCase("", "OFF ONE")]
        [TestCase("FAST", "FAST ONE")]
        [TestCase("SLOW TWO", "SLOW TWO")]
        [TestCase("TWO ONE FEATURE", "OFF ONE FEATURE")]    // of a line the first one that is on
        [TestCase("UNKNOWN", "OFF ONE")]
        [ByGlslang("the pragmas ask for DXC")]
        public void A_variant_has_one_keyword_of_each_line(string enabled, string expected)
        {
            const string text = @"#pragma kernel K
#pragma multi_compile _ FAST SLOW
#pragma multi_compile_local ONE TWO
#pragma shader_feature_local FEATURE
#pragma use_dxc
#pragma require wavebasic
#pragma target 5.0
#pragma exclude_renderers gles metal
#pragma enable_d3d11_debug_symbols
#pragma multi_compile_fog
RWStructuredBuffer<uint> _Out;
#if FAST
#define SPEED 2
#elif defined(SLOW)
#define SPEED 1
#else
#define SPEED 0
#endif
#if defined(ONE) == defined(TWO)
#error one of the two must be on
#endif
#ifdef UNKNOWN
#error not declared
#endif
[numthreads(1 + SPEED, 1
#ifdef TWO
 + 1
#endif
 , 1
#ifdef FEATURE
 + 1
#endif
)] void K() { _Out[0] = 1; }";
            ShaderProgram program = ShaderFolder.Compile(text, enabled.Split(' '));
            string found = string.Join(" ", new[] { "OFF", "SLOW", "FAST" }[program.GroupX - 1], program.GroupY == 1 ? "ONE" : "TWO",
                program.GroupZ == 2 ? "FEATURE" : "").Trim();
            Assert.That(found, Is.EqualTo(expected));
        }

        [Test]
        public void Keywords_are_those_of_the_file_and_of_includes_with_pragmas()
        {
            using (var files = new ShaderFolder()
                .Add("A.compute", "#pragma kernel K\n#pragma multi_compile __ A B\n#include \"plain.hlsl\"\n#include_with_pragmas " +
                    "\"more.hlsl\"\n[numthreads(1,1,1)] void K() {}")
                .Add("plain.hlsl", "#pragma multi_compile _ HIDDEN\n#pragma kernel Hidden\n")
                .Add("more.hlsl", "#pragma shader_feature C\n"))
            {
                ComputeShaderSource source = files.Compute("A.compute");
                Assert.That(source.Keywords, Is.EqualTo(new[] { "A", "B", "C" }));
                Assert.That(source.Kernels, Is.EqualTo(new[] { "K" }));
            }
        }

        [Test]
        public void Unitys_defines_for_Direct3D_11_are_set()
        {
            const string text = @"#pragma kernel K
#if SHADER_API_D3D11 != 1 || !SHADER_API_DESKTOP || UNITY_VERSION < 202200 || !defined(SHADER_STAGE_COMPUTE) || defined(SHADER_STAGE_VERTEX) || !UNITY_REVERSED_Z || !UNITY_UV_STARTS_AT_TOP || SHADER_TARGET < 50 || defined(SHADER_API_METAL)
#error a define is wrong
#endif
[numthreads(1,1,1)] void K() {}";
            Assert.DoesNotThrow(() => ShaderFolder.Compile(text));
        }

        // ---- includes

        [Test]
        public void Includes_are_found_beside_the_file_and_in_packages_in_any_encoding()
        {
            using (var files = new ShaderFolder()
                .Add("Assets/S/A.compute", "#pragma kernel K\r\n#include \"../Common/b.hlsl\"\r\n#include " +
                    "\"Packages/com.x/Shaders/c.hlsl\"\r\nRWStructuredBuffer<float> _Out;\r\n[numthreads(1,1,1)] void K() { _Out[0] = " +
                    "Twice(Thrice(1)) + D; }\r\n", new UTF8Encoding(true))
                .Add("Assets/Common/b.hlsl", "float Twice(float x) { return 2 * x; }", Encoding.Unicode)
                .Add("Packages/com.x/Shaders/c.hlsl", "#include \"d.hlsl\"\nfloat Thrice(float x) { return 3 * x; }", Encoding.BigEndianUnicode)
                .Add("Packages/com.x/Shaders/d.hlsl", "#pragma once\n#include \"d.hlsl\"\n#include \"c.hlsl\"\n#define D 4", new UTF8Encoding(true)))
            {
                // c includes itself by way of d, which keeps it to once; c's own second turn defines Thrice again.
                files.Add("Packages/com.x/Shaders/c.hlsl",
                    "#ifndef C\n#define C\n#include \"d.hlsl\"\nfloat Thrice(float x) { return 3 * x; }\n#endif\n");
                Assert.DoesNotThrow(() => ShaderFolder.Checked(files.Compute("Assets/S/A.compute").Compile(0, null)));
            }
        }

        [Test]
        public void An_include_that_no_variant_needs_may_be_missing()
        {
            Assert.DoesNotThrow(() => ShaderFolder.Compile(
                "#pragma kernel K\n#if defined(SHADER_API_METAL)\n#include \"none.hlsl\"\n#endif\n[numthreads(1,1,1)] void K() {}"));
        }

        [Test]
        public void A_missing_include_is_named_with_file_and_line()
        {
            var error = Assert.Throws<ShaderCompileException>(() =>
                ShaderFolder.Compile("#pragma kernel K\n\n#include \"none.hlsl\"\n[numthreads(1,1,1)] void K() {}"));
            Assert.That(error.Message, Is.EqualTo("Test.compute(3): error: Couldn't open include file 'none.hlsl'"));
        }

        [Test]
        public void An_include_that_includes_itself_without_end_is_refused()
        {
            using (var files = new ShaderFolder().Add("A.compute", "#pragma kernel K\n#include \"b.hlsl\"\n")
                .Add("b.hlsl", "\n#include \"b.hlsl\"\n"))
            {
                var error = Assert.Throws<ShaderCompileException>(() => files.Compute("A.compute"));
                Assert.That(error.Message, Does.StartWith("b.hlsl(2): error:").And.Contain("include guard"));
            }
        }

        // ---- errors

        [Test]
        public void An_error_inside_an_include_names_its_file_and_line()
        {
            using (var files = new ShaderFolder()
                .Add("S/A.compute", "#pragma kernel K\n#include \"../Inc/b.hlsl\"\nRWStructuredBuffer<float> " +
                    "_Out;\n[numthreads(1,1,1)] void K() { _Out[0] = Twice(1); }")
                .Add("Inc/b.hlsl", "/* a comment\n   of two lines */\n#define TWO \\\n    2\nfloat Twice(float x)\n{\n    return x * tow;\n}\n"))
            {
                var error = Assert.Throws<ShaderCompileException>(() => files.Compute("S/A.compute").Compile(0, null));
                Assert.That(error.File, Is.EqualTo("Inc/b.hlsl"));
                Assert.That(error.Line, Is.EqualTo(7));
                Assert.That(error.Message, Does.StartWith("Inc/b.hlsl(7): error: ").And.Contain("tow"));
            }
        }

        [TestCase("#pragma kernel K\n#pragma kernel Missing\n[numthreads(1,1,1)] void K() {}", 1, 2, "kernel 'Missing' not found")]
        [TestCase("#pragma kernel K\n#if 1\n[numthreads(1,1,1)] void K() {}", 0, 2, "no #endif")]
        [TestCase("#pragma kernel K\n#error no such thing\n", 0, 2, "no such thing")]
        [TestCase("#pragma kernel K\n#define TWO(a, b) a\nstatic float x = TWO(1);\n", 0, 3, "macro 'TWO' takes 2 arguments, got 1")]
        [TestCase("#pragma kernel K\nTexture2D _T; SamplerState MySampler; RWStructuredBuffer<float4> _A;\n[numthreads(1,1,1)] void " +
            "K() { _A[0] = _T.SampleLevel(MySampler, float2(0, 0), 0); }", 0, 1, "unrecognized sampler 'MySampler'")]
        public void Faults_are_named_with_file_and_line(string text, int kernel, int line, string what)
        {
            using (var files = new ShaderFolder().Add("Test.compute", text))
            {
                var error = Assert.Throws<ShaderCompileException>(() => files.Compute("Test.compute").Compile(kernel, null));
                Assert.That(error.Message, Does.StartWith($"Test.compute({line}): error: ").And.Contain(what));
            }
        }

        [TestCase("#pragma kernel K\nvoid K() {}", 0, 1, "[numthreads(x,y,z)]")]
        [TestCase("#pragma kernel K\nRWStructuredBuffer<float> _A;\n[numthreads(1,1,1)] void K()\n{\n    _A[0] = ;\n}", 0, 5, "Expected")]
        [TestCase("#pragma kernel K\nStructuredBuffer<float3> _A; RWStructuredBuffer<uint> _B;\n[numthreads(1,1,1)] void K() { uint n, " +
            "s; _A.GetDimensions(n, s); _B[0] = n * s; }", 0, 1, "_A.GetDimensions")]
        [TestCase("#pragma kernel K\nRWStructuredBuffer<float4x4> _A;\n[numthreads(1,1,1)] void K()\n{\n    float4x4 m = 0;\n    " +
            "float2 v = (m._m03_m13 = float2(1, 2)); _A[0] = m;\n}", 0, 6, "make that a statement of its own")]
        [ByGlslang("the words and limits of glslang; FXC has its own")]
        public void Faults_of_glslang_are_named_with_file_and_line(string text, int kernel, int line, string what)
            => Faults_are_named_with_file_and_line(text, kernel, line, what);

        [Test]
        public void A_kernel_that_is_not_asked_for_may_be_wrong()
        {
            const string text =
                "#pragma kernel Good\n#pragma kernel Missing\nRWStructuredBuffer<float> _A;\n[numthreads(1,1,1)] void Good() { _A[0] = 1; }";
            Assert.DoesNotThrow(() => ShaderFolder.Compile(text));
        }

        // ---- resources

        [Test]
        public void Only_what_the_kernel_reaches_is_bound()
        {
            const string text = @"#pragma kernel A
#pragma kernel B
StructuredBuffer<float> _One, _Two; RWStructuredBuffer<float> _Out; Texture2D<float4> _Tex; SamplerState sampler_Tex; float _Scale;
    cbuffer Other { float _OtherScale; };
groupshared float g_Shared[100];
float Helper(uint i) { return _Two[i] * _Scale; }
[numthreads(1,1,1)] void A(uint3 id : SV_DispatchThreadID) { _Out[id.x] = _One[id.x]; }
[numthreads(100,1,1)] void B(uint3 id : SV_DispatchThreadID, uint i : SV_GroupIndex) { g_Shared[i] = Helper(id.x); GroupMemoryBarrierWithGroupSync(); _Out[id.x] = g_Shared[99 - i]; if (false) _Out[0] = _Tex.Load(int3(0, 0, 0)).x; }";
            using (var files = new ShaderFolder().Add("A.compute", text))
            {
                ComputeShaderSource source = files.Compute("A.compute");
                ShaderProgram a = ShaderFolder.Checked(source.Compile(0, null)), b = ShaderFolder.Checked(source.Compile(1, null));
                Assert.That(a.Resources.Select(r => r.Name), Is.EquivalentTo(new[] { "_One", "_Out" }));
                Assert.That(b.Resources.Select(r => r.Name), Is.EquivalentTo(new[] { "_Two", "_Out", "$Globals" }));
                Assert.That(b.Resources.Select(r => r.Binding), Is.EqualTo(new[] { 0, 1, 2 }));
                Assert.That(a.GroupsharedBytes, Is.EqualTo(0));
                Assert.That(b.GroupsharedBytes, Is.EqualTo(400));
                Assert.That(a.UavCount, Is.EqualTo(1));
            }
        }

        [Test]
        public void Append_and_consume_buffers_bring_their_counters()
        {
            const string text = @"#pragma kernel K
struct P { float3 position; uint id; };
AppendStructuredBuffer<P> _Append; ConsumeStructuredBuffer<P> _Consume; RWStructuredBuffer<uint> _Counted;
[numthreads(1,1,1)] void K() { _Append.Append(_Consume.Consume()); _Counted[_Counted.IncrementCounter()] = 1; }";
            ShaderProgram program = ShaderFolder.Compile(text);
            foreach (string name in new[] { "_Append", "_Consume", "_Counted" })
            {
                ShaderResource buffer = Find(program, name, ShaderResourceKind.RWStructuredBuffer),
                    counter = Find(program, name, ShaderResourceKind.Counter);
                Assert.That(buffer.Stride, Is.EqualTo(name == "_Counted" ? 4 : 16));
                Assert.That(buffer.IsAppendConsume, Is.EqualTo(name != "_Counted"), name);
                Assert.That(counter.Binding, Is.Not.EqualTo(buffer.Binding));
            }
            Assert.That(program.UavCount, Is.EqualTo(3));
        }

        [Test]
        public void Raw_buffers_are_told_from_structured_buffers_of_uint()
        {
            const string text = @"#pragma kernel K
ByteAddressBuffer _Raw; RWByteAddressBuffer _RWRaw; StructuredBuffer<uint> _Uints; RWStructuredBuffer<uint> _RWUints;
uint Load(ByteAddressBuffer _Uints, uint i) { return _Uints.Load(i); }
[numthreads(1,1,1)] void K(uint3 id : SV_DispatchThreadID)
{
    uint old, bytes;
    _RWRaw.InterlockedAdd(4, 1, old);
    _RWRaw.InterlockedCompareExchange(8, 1, 2, old);
    _Raw.GetDimensions(bytes);
    _RWRaw.Store3(16, uint3(old, bytes, Load(_Raw, 4)));
    InterlockedCompareExchange(_RWUints[0], 1, 2, old);
    _RWUints[1] = _Uints[id.x] + firstbithigh(old) + asuint(1.0);
}";
            ShaderProgram program = ShaderFolder.Compile(text);
            Assert.That(Find(program, "_Raw").Kind, Is.EqualTo(ShaderResourceKind.RawBuffer));
            Assert.That(Find(program, "_RWRaw").Kind, Is.EqualTo(ShaderResourceKind.RWRawBuffer));
            Assert.That(Find(program, "_Uints").Kind, Is.EqualTo(ShaderResourceKind.StructuredBuffer));
            Assert.That(Find(program, "_RWUints").Kind, Is.EqualTo(ShaderResourceKind.RWStructuredBuffer));
            Assert.That(Find(program, "_Raw").Stride, Is.EqualTo(4));
        }

        [Test]
        [ByGlslang("variables go by the names of the source")]
        public void Textures_have_their_dimension_and_written_ones_no_format()
        {
            const string text = @"#pragma kernel K
Texture2D<float4> _T2; Texture3D<float> _T3; Texture2DArray<float4> _TA; TextureCube<float4> _TC; SamplerState linearClampSampler;
RWTexture2D<float4> _W2; RWTexture3D<float> _W3; RWTexture2DArray<uint> _WA; RWTexture2D<uint> _Atomic; RWTexture3D<float> _ReadBack;
Buffer<float4> _B; RWBuffer<uint> _RB;
[numthreads(1,1,1)] void K(uint3 id : SV_DispatchThreadID)
{
    float4 s = _T2.SampleLevel(linearClampSampler, float2(0, 0), 0) + _T3[id] + _TA[id] + _TC.SampleLevel(linearClampSampler,
        float3(1, 0, 0), 0) + _B[id.x];
    _W2[id.xy] = s; _W3[id] = s.x; _WA[id] = 3; _ReadBack[id] += s.y; _RB[id.x] = 1;
    uint old; InterlockedAdd(_Atomic[id.xy], 1, old);
}";
            ShaderProgram program = ShaderFolder.Compile(text);
            Assert.That(Find(program, "_T2").Dimension, Is.EqualTo(DeviceTextureDimension.Tex2D));
            Assert.That(Find(program, "_T3").Dimension, Is.EqualTo(DeviceTextureDimension.Tex3D));
            Assert.That(Find(program, "_TA").Dimension, Is.EqualTo(DeviceTextureDimension.Tex2DArray));
            Assert.That(Find(program, "_TC").Dimension, Is.EqualTo(DeviceTextureDimension.Cube));
            Assert.That(Find(program, "_W2").Kind, Is.EqualTo(ShaderResourceKind.RWTexture));
            Assert.That(Find(program, "_W2").ElementFormat, Is.EqualTo(DeviceFormat.RGBA32_Float));
            Assert.That(Find(program, "_B").Kind, Is.EqualTo(ShaderResourceKind.TypedBuffer));
            Assert.That(Find(program, "_RB").Kind, Is.EqualTo(ShaderResourceKind.RWTypedBuffer));
            Assert.That(Find(program, "_RB").ElementFormat, Is.EqualTo(DeviceFormat.R32_UInt));
            Assert.That(program.UavCount, Is.EqualTo(6));

            SpirvModule module = SpirvModule.Read(program.Spirv);
            var types = new SpirvTypes(module);
            uint Format(string name) => types.Pointee(module.Instructions.Single(i => i.Op == Op.Variable && types.Name(i[1]) == name))[7];
            const uint unknown = 0, r32f = 3, r32ui = 33;
            Assert.That(new[] { Format("_W2"), Format("_W3"), Format("_WA") }, Is.All.EqualTo(unknown));
            Assert.That(Format("_ReadBack"), Is.EqualTo(r32f));
            Assert.That(Format("_Atomic"), Is.EqualTo(r32ui));
        }

        [TestCase("sampler_linear_clamp", true, false, DeviceWrap.Clamp, DeviceWrap.Clamp, false, 0)]
        [TestCase("linearRepeatSampler", true, false, DeviceWrap.Repeat, DeviceWrap.Repeat, false, 0)]
        [TestCase("MyPointMirrorOnceSampler", false, false, DeviceWrap.MirrorOnce, DeviceWrap.MirrorOnce, false, 0)]
        [TestCase("my_trilinear_mirror_sampler", true, true, DeviceWrap.Mirror, DeviceWrap.Mirror, false, 0)]
        [TestCase("sampler_LinearClampU_RepeatV", true, false, DeviceWrap.Clamp, DeviceWrap.Repeat, false, 0)]
        [TestCase("sampler_LinearClampCompare", true, false, DeviceWrap.Clamp, DeviceWrap.Clamp, true, 0)]
        [TestCase("sampler_linear_repeat_aniso8", true, false, DeviceWrap.Repeat, DeviceWrap.Repeat, false, 8)]
        public void Inline_samplers_are_read_from_their_names(string name, bool linear, bool linearMip, object u, object v, bool compare,
            int anisotropy)
        {
            DeviceSampler sampler = InlineSampler.Parse(name).Value;
            Assert.That(new object[] { sampler.Linear, sampler.LinearMip, sampler.U, sampler.V, sampler.Comparison, sampler.Anisotropy },
                Is.EqualTo(new[] { linear, linearMip, u, v, compare, anisotropy }));
        }

        [Test]
        public void A_sampler_named_for_a_texture_takes_that_textures_settings()
        {
            const string text = @"#pragma kernel K
Texture2D<float4> _MainTex, Other; SamplerState sampler_MainTex, samplerOther, pointRepeat; RWStructuredBuffer<float4> _Out;
[numthreads(1,1,1)] void K() { float2 uv = 0; _Out[0] = _MainTex.SampleLevel(sampler_MainTex, uv, 0) + Other.SampleLevel(samplerOther, uv, 0) + Other.SampleLevel(pointRepeat, uv, 0); }";
            ShaderProgram program = ShaderFolder.Compile(text);
            Assert.That(Find(program, "sampler_MainTex").SamplerOf, Is.EqualTo("_MainTex"));
            Assert.That(Find(program, "samplerOther").SamplerOf, Is.EqualTo("Other"));
            Assert.That(Find(program, "pointRepeat").InlineSampler, Is.Not.Null);
        }

        // ---- language

        [Test]
        public void What_kernels_commonly_use_compiles_to_valid_modules()
        {
            const string text = @"#pragma kernel K
#define CONCAT(a, b) a##b
#define DECLARE(type, name) RWStructuredBuffer<type> CONCAT(_, name)
#define LOOP(n) \
    [unroll] \
    for (uint i = 0; i < n; i++)
struct Cell { uint count; int2 range; };
DECLARE(Cell, Cells);
DECLARE(float3, Points);
DECLARE(uint, Sums);
static const float3 kOffsets[3] = { float3(1, 0, 0), float3(0, 1, 0), float3(0, 0, 1) };
groupshared Cell g_Cells[64];
groupshared uint g_Max;
void Store(RWStructuredBuffer<float3> points, uint i, float3 p) { points[i] = p; }
float3 Load(uint i, out float w) { w = 1; return _Points[i]; }
[numthreads(64,1,1)] void K(uint3 id : SV_DispatchThreadID, uint3 group : SV_GroupID, uint3 local : SV_GroupThreadID, uint index : SV_GroupIndex)
{
    if (index == 0) g_Max = 0;
    g_Cells[index].count = id.x;
    g_Cells[index].range = int2(group.x, local.y);
    GroupMemoryBarrierWithGroupSync();
    uint old;
    InterlockedMax(g_Max, g_Cells[63 - index].count, old);
    InterlockedAdd(g_Cells[0].count, 1, old);
    InterlockedCompareExchange(_Cells[id.x].count, 1, old, old);
    InterlockedMin(_Cells[id.x].range.x, -3);
    InterlockedExchange(_Sums[id.x], 7, old);
    DeviceMemoryBarrierWithGroupSync();
    AllMemoryBarrierWithGroupSync();
    float w;
    float3 sum = Load(id.x, w);
    LOOP(3) sum += kOffsets[i] * w;
    [loop] for (uint k = 0; k < g_Max; k++) { if (k == 5) break; sum += k * kOffsets[k % 3]; }
    Store(_Points, id.x, normalize(sum) + rcp(w) + saturate(sum.yzx) + float3(countbits(old), firstbitlow(old), reversebits(old))
        + asfloat(0x3f800000u) + f16tof32(f32tof16(w)) + mad(w, w, w));
    bool3 b = sum > 0;
    _Sums[id.x] = any(b) ? g_Max : (uint)all(b) + (uint)isnan(w);
    switch (index & 3) { case 0: _Sums[id.x + 64] = 1; break; case 1: case 2: _Sums[id.x + 64] = 2; break; default: break; }
}";
            ShaderProgram program = ShaderFolder.Compile(text);
            Assert.That(program.GroupsharedBytes, Is.EqualTo(64 * 12 + 4));
            Assert.That(Find(program, "_Points").Stride, Is.EqualTo(12));
        }

        // ---- cache

        [Test]
        public void A_program_comes_back_from_disk_the_same()
        {
            const string text = @"#pragma kernel K
Texture2D<float4> _T; SamplerState linearClampU_pointSampler; AppendStructuredBuffer<float3> _Out; float4x4 _M[2];
[numthreads(3,2,1)] void K() { _Out.Append(mul(_M[1], _T.SampleLevel(linearClampU_pointSampler, float2(0, 0), 0)).xyz); }";
            using (var files = new ShaderFolder().Add("A.compute", text).Add("B.compute", text))
            {
                ShaderProgram first = files.Compute("A.compute").Compile(0, null);
                Assert.That(Directory.GetFiles(files.CachePath).Length, Is.EqualTo(1));
                ShaderProgram again = files.Compute("B.compute").Compile(0, null);
                Assert.That(Directory.GetFiles(files.CachePath).Length, Is.EqualTo(1), "the same text is the same program");
                Assert.That(again.Name, Is.EqualTo("B.compute (K)"));
                Assert.That(again.Spirv, Is.EqualTo(first.Spirv));
                Assert.That(again.Resources.Select(r => (r.Name, r.Kind, r.Binding, r.Stride, r.IsAppendConsume, r.InlineSampler)),
                    Is.EqualTo(first.Resources.Select(r => (r.Name, r.Kind, r.Binding, r.Stride, r.IsAppendConsume, r.InlineSampler))));
                Assert.That(Field(again, "_M"), Is.EqualTo(Field(first, "_M")));
                files.Add("A.compute", text + "\n");
                files.Compute("A.compute").Compile(0, null);
                Assert.That(Directory.GetFiles(files.CachePath).Length, Is.EqualTo(1), "blank lines do not count");
                files.Add("A.compute", text.Replace("(3,2,1)", "(3,2,2)"));
                Assert.That(files.Compute("A.compute").Compile(0, null).GroupZ, Is.EqualTo(2));
            }
        }

        [Test]
        public void Kernels_compile_on_many_threads_at_once()
        {
            var text = new StringBuilder("RWStructuredBuffer<uint> _Out;\n");
            for (int k = 0; k < 12; k++)
                text.Append($"#pragma kernel K{k}\n[numthreads({k + 1},1,1)] void K{k}() {{ _Out[{k}] = {k}; }}\n");
            using (var files = new ShaderFolder().Add("A.compute", text.ToString()))
            {
                ComputeShaderSource source = files.Compute("A.compute");
                var sizes = new int[24];
                Parallel.For(0, 24, i => sizes[i] = source.Compile(i % 12, null).GroupX);
                Assert.That(sizes, Is.EqualTo(Enumerable.Range(0, 24).Select(i => i % 12 + 1)));
            }
        }
    }
}
