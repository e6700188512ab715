using System.Collections.Generic;
using System.Linq;
using Host.Check;
using Host.Shaders;
using NUnit.Framework;
using UnityEngine.Headless;

namespace Host.Tests
{
    /// <summary>Every fault for which Microsoft's compiler is asked, planted; one run finds them all.</summary>
    public sealed class CheckFxcTests
    {
        const string Kernel = "#pragma kernel K\nRWStructuredBuffer<uint> _Out;\n";

        SyntheticPackage package;
        Findings findings;

        [OneTimeSetUp]
        public void Plant()
        {
            package = new SyntheticPackage()
                .Add("Good.compute", "#pragma kernel K\n#pragma multi_compile_local _ UNUSED\nStructuredBuffer<uint> " +
                    "_In;\nRWStructuredBuffer<uint> _Out;\ngroupshared uint g_Sums[64];\n" +
                    "[numthreads(64,1,1)] void K(uint3 id : SV_GroupThreadID)\n{\n    g_Sums[id.x] = _In[id.x];\n    " +
                    "GroupMemoryBarrierWithGroupSync();\n    _Out[id.x] = g_Sums[63 - id.x];\n}\n")
                .Add("Syntax.compute", Kernel + "[numthreads(1,1,1)] void K()\n{\n    uint a = 1\n    _Out[0] = a;\n}\n")
                .Add("Includes.compute", "#pragma kernel K\n#include \"Packages/com.test.planted/Included.hlsl\"\n[numthreads(1,1,1)] " +
                    "void K() { _Out[0] = Twice(1); }\n")
                .Add("Included.hlsl", "RWStructuredBuffer<uint> _Out;\n\nuint Twice(uint a)\n{\n    return a * missing;\n}\n")
                .Add("GroupRace.compute", Kernel + "groupshared uint g_Last;\n[numthreads(64,1,1)] void K(uint3 id : " +
                    "SV_GroupThreadID)\n{\n    g_Last = id.x;\n    GroupMemoryBarrierWithGroupSync();\n    _Out[id.x] = g_Last;\n}\n")
                .Add("BufferRace.compute", Kernel + "[numthreads(64,1,1)] void K(uint3 id : SV_GroupThreadID)\n{\n    _Out[0] = id.x;\n}\n")
                .Add("Barrier.compute", Kernel + "groupshared uint g_A[64];\n[numthreads(64,1,1)] void K(uint3 id : " +
                    "SV_GroupThreadID)\n{\n    if (id.x < 3)\n    {\n        g_A[id.x] = 1;\n        " +
                    "GroupMemoryBarrierWithGroupSync();\n    }\n    _Out[id.x] = g_A[id.x];\n}\n")
                .Add("Uninitialized.compute", Kernel + "groupshared uint g_A[64];\n[numthreads(64,1,1)] void K(uint3 id : " +
                    "SV_GroupThreadID)\n{\n    GroupMemoryBarrierWithGroupSync();\n\n    _Out[id.x] = g_A[id.x];\n}\n")
                .Add("Sample.compute", "#pragma kernel K\nTexture2D<float> _Tex;\nSamplerState sampler_Tex;\nRWStructuredBuffer<float> " +
                    "_Out;\n[numthreads(1,1,1)] void K()\n{\n    _Out[0] = _Tex.Sample(sampler_Tex, 0.5);\n}\n")
                .Add("Wave.compute",
                    Kernel + "[numthreads(64,1,1)] void K(uint3 id : SV_DispatchThreadID)\n{\n    _Out[id.x] = WaveActiveSum(id.x);\n}\n")
                .Add("Dxc.compute", "#pragma use_dxc\n" + Kernel
                    + "[numthreads(64,1,1)] void K(uint3 id : SV_DispatchThreadID) { _Out[id.x] = WaveActiveSum(id.x); }\n")
                .Add("Truncates.compute", "#pragma kernel K\nRWStructuredBuffer<float> _Out;\n[numthreads(1,1,1)] void K(uint3 id : " +
                    "SV_DispatchThreadID)\n{\n    float4 four = float4(id, 1);\n    _Out[id.x] = four;\n}\n")
                .Add("Hushed.compute", "#include \"Hush.hlsl\"\n#pragma kernel K\nRWStructuredBuffer<float> _Out;\n[numthreads(1,1,1)] " +
                    "void K(uint3 id : SV_DispatchThreadID) { float4 four = float4(id, 1); _Out[id.x] = four; }\n")
                .Add("Hush.hlsl", "#pragma warning(disable : 3206)\n")
                .Add("Loud.compute", "#pragma warning(disable : 3206)\n#pragma kernel K\nRWStructuredBuffer<float> " +
                    "_Out;\n[numthreads(1,1,1)] void K(uint3 id : SV_DispatchThreadID) { float4 four = float4(id, 1); _Out[id.x] = four; }\n")
                .Add("Pragma.compute", Kernel + "#include \"Pragma.hlsl\"\n[numthreads(1,1,1)] void K() { _Out[0] = 1; }\n")
                .Add("Pragma.hlsl", "\n#pragma multi_compile _ NOT_HERE\n")
                .Add("NineUavs.compute", "#pragma kernel K\n" + Declare("RWStructuredBuffer<uint> _A", 9)
                    + "[numthreads(64,1,1)] void K(uint3 id : SV_DispatchThreadID) { " + Each("_A@[id.x] = 1; ", 9) + "}\n")
                .Add("TooShared.compute", Kernel + "groupshared uint g_A[8193];\n[numthreads(64,1,1)] void K(uint3 id : " +
                    "SV_GroupThreadID)\n{\n    g_A[id.x * 100] = id.x;\n    GroupMemoryBarrierWithGroupSync();\n    _Out[id.x] = " +
                    "g_A[8192 - id.x];\n}\n")
                .Add("Threads.compute", Kernel + "[numthreads(1025,1,1)] void K(uint3 id : SV_DispatchThreadID) { _Out[id.x] = 1; }\n")
                .Add("OneVariant.compute", "#pragma kernel Uses\n#pragma kernel Ignores OTHER\n#pragma multi_compile_local _ RED " +
                    "GREEN\nRWStructuredBuffer<uint> _Out;\n#ifdef OTHER\n[numthreads(1,1,1)] void Ignores() { _Out[0] = 2; }\n#else\n" +
                    "[numthreads(1,1,1)] void Uses()\n{\n#if defined(RED)\n    _Out[0] = 3;\n#elif defined(GREEN)\n    _Out[0] = " +
                    "undefined;\n#endif\n}\n#endif\n")
                .Add("NoEntry.compute", "#pragma kernel Elsewhere\nRWStructuredBuffer<uint> _Out;\n[numthreads(1,1,1)] void K() { _Out[0] = 1; }\n")
                .Add("StandIn.compute", Kernel + "#include \"UnityCG.cginc\"\n[numthreads(1,1,1)] void K() { _Out[0] = 1; }\n")
                .Add("NoInclude.compute", Kernel + "#include \"Missing.hlsl\"\n[numthreads(1,1,1)] void K() { _Out[0] = 1; }\n")
                .Add("Nameless.compute", "#pragma kernel\n")
                .Add("Garbage.shader", "Shader \"Garbage\"\n{\n    SubShader { Pass { Culling Off } }\n}\n")
                .Add("Samples~/Old.shader", Shader("sampler2D _Tex;\nfloat4 Vertex(float4 at : POSITION) : SV_Position { return at; " +
                    "}\nfloat4 Fragment(float4 at : SV_Position) : COLOR { return tex2D(_Tex, at.xy); }\n"))
                .Add("Stage.shader", Shader("float4 Vertex(float4 at : POSITION) : SV_Position { return at; }\nfloat4 Fragment(float4 " +
                    "at : SV_Position) : SV_Target\n{\n    return wrong;\n}\n"))
                .Add("Fog.shader", Shader("#pragma multi_compile_fog\nfloat4 Vertex(float4 at : POSITION) : SV_Position { return at; " +
                    "}\nfloat4 Fragment(float4 at : SV_Position) : SV_Target { return 1; }\n"))
                .Add("Unused.hlsl", "float Unused(float a) { return a; }\n")
                .Add("Hidden~/Ignored.compute", "not HLSL at all");
            findings = new FxcRule().Examine(package.Tree);
        }

        [OneTimeTearDown]
        public void Remove() => package.Dispose();

        static string Declare(string what, int count) => string.Concat(Enumerable.Range(0, count).Select(i => what + i + ";\n"));
        static string Each(string what, int count) => string.Concat(Enumerable.Range(0, count).Select(i => what.Replace("@", i.ToString())));
        static string Shader(string code) => "Shader \"S\"\n{\n    SubShader\n    {\n        Pass\n        {\n            Name \"P\"\n " +
            "           HLSLPROGRAM\n#pragma vertex Vertex\n#pragma fragment Fragment\n" + code
            + "            ENDHLSL\n        }\n    }\n}\n";

        [TestCase("Syntax.compute(6): error X3000: syntax error")]
        [TestCase("Packages/com.test.planted/Included.hlsl(5): error X3004: undeclared identifier 'missing'; in Includes.compute (K)")]
        [TestCase("GroupRace.compute(6): error X3695: race condition writing to shared memory")]
        [TestCase("BufferRace.compute(5): error X3694: race condition writing to shared resource")]
        [TestCase("Barrier.compute(9): error X3663: thread sync operation found in varying flow control")]
        [TestCase("Uninitialized.compute(8): error X4575: reading uninitialized value")]
        [TestCase("Sample.compute(7): error X4532: cannot map expression to cs_5_0")]
        [TestCase("Wave.compute(5): error X3004: undeclared identifier 'WaveActiveSum'")]
        [TestCase("Dxc.compute (K): #pragma use_dxc asks for DXC")]
        [TestCase("Truncates.compute(6): warning X3206: implicit truncation of vector type")]
        [TestCase("Loud.compute(4): warning X3206: implicit truncation of vector type")]    // Unity minds HLSL's pragmas in includes alone
        [TestCase("Pragma.hlsl(2): warning X3568: 'multi_compile' : unknown pragma ignored; in Pragma.compute (K)")]
        [TestCase("NineUavs.compute (K): 9 UAVs, but Direct3D 11.0 has 8")]
        [TestCase("TooShared.compute(1): error X4586: The total amount of group shared memory (32772 bytes) exceeds")]
        [TestCase("Threads.compute(3): error X3655")]
        [TestCase("OneVariant.compute(13): error X3004: undeclared identifier 'undefined'; in OneVariant.compute (Uses, GREEN)")]
        [TestCase("NoEntry.compute(1): error X3501: 'Elsewhere': entrypoint not found")]
        [TestCase("NoInclude.compute(3): error: Couldn't open include file 'Missing.hlsl'; in NoInclude.compute (K)")]
        [TestCase("StandIn.compute (K): includes UnityCG.cginc, of which only a stand-in is here")]
        [TestCase("Nameless.compute(1): error: #pragma kernel needs a name")]
        [TestCase("Garbage.shader(3): error")]
        [TestCase("Stage.shader(14): error X3004: undeclared identifier 'wrong'; in Stage.shader (P/Vertex), Stage.shader (P/Fragment)")]
        [TestCase("Unused.hlsl: no kernel or stage of the package includes it")]
        [TestCase("Fog.shader(11): the variants of #pragma multi_compile_fog are not compiled here")]
        public void A_planted_fault_is_named_with_file_and_line(string fault)
        {
            Assert.That(findings.Faults, Has.Some.StartsWith(fault));
        }

        [Test]
        public void A_fault_in_an_include_of_the_package_is_seen_once_with_kernels_that_have_it()
        {
            using (var copy = new PackageCopy())
                copy.Catches(new FxcRule(), () => copy.Replace("Shaders/Baking/Pose.hlsl", "#endif",
                    "float Planted(float4 four) { return four; }\n#endif"), "Shaders/Baking/Pose.hlsl(", "warning X3206",
                    "Shaders/Baking/MeshSdf.compute (", " more");
        }

        [Test]
        public void The_variants_beside_a_faulty_one_are_well()
        {
            Assert.That(findings.Faults.Count(f => f.Contains("OneVariant.compute")), Is.EqualTo(1));
        }

        [TestCase("Good.compute")]
        [TestCase("Hushed.compute")]
        [TestCase("Samples~/Old.shader")]
        [TestCase("Hidden~")]
        public void What_Unity_takes_or_does_not_see_is_no_fault(string file)
        {
            Assert.That(findings.Faults.Where(f => f.Contains(file)), Is.Empty);
        }

        [Test]
        public void The_table_tells_what_a_kernel_costs()
        {
            string[][] rows = findings.Tables.Single().Rows.Where(r => r[0] == "Good.compute").ToArray();
            Assert.That(rows, Has.Length.EqualTo(1), "a keyword that the kernel ignores makes no variant");
            var cost = findings.Tables.Single().Columns.Zip(rows[0], (column, cell) => (column, cell)).ToDictionary(c => c.column, c => c.cell);
            Assert.That(cost["group"], Is.EqualTo("64 x 1 x 1"));
            Assert.That(cost["groupshared B"], Is.EqualTo("256"));
            Assert.That(cost["UAVs"], Is.EqualTo("1"));
            Assert.That(cost["buffers"], Is.EqualTo("1"));
            Assert.That(int.Parse(cost["instructions"]), Is.InRange(5, 12));
            Assert.That(int.Parse(cost["registers"]), Is.EqualTo(1));
        }

        [Test]
        public void Every_choice_of_keywords_that_matters_is_compiled_once()
        {
            var variants = new ComputeFile(System.IO.Path.Combine(package.Folder, "OneVariant.compute"), "OneVariant.compute",
                new ShaderCompiler(null, null)).AllVariants();
            Assert.That(variants.Select(v => v.Program + " " + v.Keywords), Is.EqualTo(new[] { "Uses ", "Uses RED", "Uses GREEN", "Ignores " }));
        }

        [Test]
        public void More_variants_than_anybody_compiles_are_a_fault()
        {
            using (var many = new SyntheticPackage()
                .Add("Many.compute", Each("#pragma multi_compile _ A@ B@ C@\n", 7) + Kernel
                + "[numthreads(1,1,1)] void K() { _Out[0] = 1; }\n"))
                Assert.That(new FxcRule().Examine(many.Tree).Faults.Single(),
                    Does.StartWith("Many.compute(1): error: its keywords make more than 4096 variants"));
        }

        [Test]
        public void An_allowed_warning_is_no_fault_and_an_allowance_that_nothing_needs_is_one()
        {
            var rule = new FxcRule(null, null,
                new[] { new FxcAllowance("X3206", "Truncates.compute", "it is meant"),
                new FxcAllowance("X3206", "Good.compute", "it was meant") });
            List<string> faults = rule.Examine(package.Tree).Faults;
            Assert.That(faults, Has.None.Contains("Truncates.compute"));
            Assert.That(faults.Single(f => f.Contains("Good.compute")), Does.StartWith("FXC does not say X3206 of Good.compute any more"));
        }

        [Test]
        public void An_error_cannot_be_allowed()
        {
            var rule = new FxcRule(null, null, new[] { new FxcAllowance("X3004", "Wave.compute", "who knows") });
            Assert.That(rule.Examine(package.Tree).Faults, Has.Some.StartsWith("Wave.compute(5): error X3004"));
        }
    }
}
