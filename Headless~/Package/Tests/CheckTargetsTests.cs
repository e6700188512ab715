using System.IO;
using System.Linq;
using Host.Check;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>Programs that other graphics APIs do not take.</summary>
    public sealed class CheckTargetsTests
    {
        SyntheticPackage package;
        Findings findings;

        [OneTimeSetUp]
        public void Plant()
        {
            package = new SyntheticPackage()
                .Add("Good.compute", Kernel(64, "RWStructuredBuffer<uint> _A;\n", "_A[id.x] = id.x;"))
                .Add("NineBuffers.compute", Kernel(64, Each("RWStructuredBuffer<uint> _A@;\n", 9), Each("_A@[id.x] = 1;", 9)))
                .Add("Threads.compute", Kernel(512, "RWStructuredBuffer<uint> _A;\n", "_A[id.x] = id.x;"))
                .Add("Groupshared.compute", Kernel(64, "RWStructuredBuffer<uint> _A;\ngroupshared uint g_A[5000];\n",
                    "g_A[id.x * 70] = id.x; GroupMemoryBarrierWithGroupSync(); _A[id.x] = g_A[4999 - id.x];"))
                .Add("Typed.compute", Kernel(64, "Buffer<float> _In;\nRWStructuredBuffer<float> _A;\n", "_A[id.x] = _In[id.x];"))
                .Add("Buffers.compute", Kernel(64, Each("StructuredBuffer<uint> _In@;\n", 32) + "RWStructuredBuffer<uint> _A;\n",
                    "_A[id.x] = 0" + Each(" + _In@[id.x]", 32) + ";"))
                .Add("Draw.shader", "Shader \"S\"\n{\n    SubShader { Pass {\n        HLSLPROGRAM\n        #pragma target 5.0\n        " +
                    "#pragma vertex V\n        #pragma fragment F\n        StructuredBuffer<float4> _At;\n" +
                    "        float4 V(uint id : SV_VertexID) : SV_Position { return _At[id]; }\n        float4 F() : SV_Target { " +
                    "return 1; }\n        ENDHLSL\n    } }\n}\n")
                .Add("Wrong.compute", Kernel(64, "", "_Missing[id.x] = 1;"))
                .Add("Nameless.compute", "#pragma kernel\n");
            findings = new TargetsRule().Examine(package.Tree);
        }

        [OneTimeTearDown]
        public void Remove() => package.Dispose();

        static string Kernel(int threads, string declarations, string body)
            => $"#pragma kernel K\n{declarations}[numthreads({threads},1,1)] void K(uint3 id : SV_DispatchThreadID) {{ {body} }}\n";
        static string Each(string what, int count) => string.Concat(Enumerable.Range(0, count).Select(i => what.Replace("@", i.ToString())));

        string Cell(string file, string column, string program = "K")
        {
            ResultTable table = findings.Tables.Single();
            return table.Rows.Single(r => r[0] == file && r[1] == program)[table.Columns.ToList().IndexOf(column)];
        }

        [TestCase("NineBuffers.compute", "WebGPU", "no: 9 storage buffers of 8")]
        [TestCase("NineBuffers.compute", "GLES 3.1", "no: 9 storage buffers of 4")]
        [TestCase("NineBuffers.compute", "Metal", "yes")]
        [TestCase("Threads.compute", "WebGPU", "no: 512 threads of 256")]
        [TestCase("Threads.compute", "GLES 3.1", "no: 512 threads of 128")]
        [TestCase("Threads.compute", "Vulkan", "yes")]
        [TestCase("Groupshared.compute", "WebGPU", "no: 20000 shared bytes of 16384")]
        [TestCase("Groupshared.compute", "GLES 3.1", "no: 20000 shared bytes of 16384")]
        [TestCase("Groupshared.compute", "Metal", "yes")]
        [TestCase("Typed.compute", "WebGPU", "no: has no Buffer<T>")]
        [TestCase("Buffers.compute", "Metal", "no: 33 buffers of 31")]
        [TestCase("Good.compute", "Metal", "yes")]
        [TestCase("Good.compute", "Vulkan", "yes")]
        [TestCase("Good.compute", "WebGPU", "yes")]
        [TestCase("Good.compute", "GLES 3.1", "yes")]
        public void The_table_says_whether_a_program_fits_and_why_not(string file, string target, string verdict)
        {
            Assert.That(Cell(file, target), Is.EqualTo(verdict));
        }

        [Test]
        public void Buffers_of_a_vertex_program_do_not_fit_OpenGL_ES()
        {
            Assert.That(Cell("Draw.shader", "GLES 3.1", "V"), Is.EqualTo("no: 1 storage buffers of 0"));
            Assert.That(Cell("Draw.shader", "GLES 3.1", "F"), Is.EqualTo("yes"));
        }

        [Test]
        public void Only_targets_that_are_stated_as_supported_make_faults()
        {
            Assert.That(findings.Faults.Where(f => f.Contains("does not run on")),
                Is.EqualTo(new[] { "Buffers.compute (K) does not run on Metal: 33 buffers of 31" }));
        }

        [Test]
        public void A_program_that_does_not_translate_is_a_fault_where_it_is_supported()
        {
            var es = new Target { Name = "OpenGL ES", Supported = true, Translation = Translation.OpenGlEs31 };
            Assert.That(new TargetsRule(null, null, new[] { es }).Examine(package.Tree).Faults,
                Has.Some.StartsWith("Draw.shader (V) does not run on OpenGL ES: spirv-cross: SPIRV-Cross threw an exception: BaseVertex"));
        }

        [Test]
        public void What_cannot_be_compiled_or_read_is_a_fault()
        {
            Assert.That(findings.Faults, Has.Some.StartsWith("Wrong.compute(2): error").And.Some.StartsWith(
                "Nameless.compute(1): error: #pragma kernel needs a name"));
        }

        [Test]
        public void A_missing_tool_is_a_fault_that_says_how_to_install_it()
        {
            string cache = Directory.CreateTempSubdirectory("rill-targets-").FullName;
            Assert.That(new TargetsRule(cache, new[] { cache }, Target.All).Examine(package.Tree).Faults,
                Has.Some.Contains("spirv-cross is not there").And.Some.Contains("apt-get install spirv-cross"));
            Directory.Delete(cache, recursive: true);
        }
    }
}
