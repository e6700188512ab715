using System.IO;
using System.Linq;
using Host.Shaders;
using NUnit.Framework;
using UnityEngine.Headless;

namespace Host.Tests
{
    /// <summary>Programs whose bytecode vkd3d refuses, and the list that they have to stand in.</summary>
    public class UntranslatableTests
    {
        // Doubles: what vkd3d 1.2 does not know of shader model 5.
        const string Doubles = "#pragma kernel K\nStructuredBuffer<float> _In; RWStructuredBuffer<float> _Out;\n[numthreads(1,1,1)] " +
            "void K() { double d = _In[0]; d = d * d + d; _Out[0] = (float)d; }";
        const string Plain = "#pragma kernel K\nStructuredBuffer<float> _In; RWStructuredBuffer<float> _Out;\n[numthreads(1,1,1)] void " +
            "K() { _Out[0] = 2 * _In[0]; }";

        static CompiledProgram Compile(string text, params Untranslatable[] list)
        {
            string folder = Directory.CreateTempSubdirectory("rill-shader-tests-").FullName;
            try
            {
                string path = Path.Combine(folder, "T.compute");
                File.WriteAllText(path, text);
                return ShaderImporter.AllVariants(path, "T.compute", _ => null, new ShaderCache(Path.Combine(folder, "cache")),
                    new FxcBackend(list)).Single().Compile();
            }
            finally
            {
                Directory.Delete(folder, recursive: true);
            }
        }

        static string Refusal(string text, params Untranslatable[] list) => Assert.Throws<ShaderCompileException>(() => Compile(text, list)).Message;

        static string ReasonOf(string refusal) => refusal.Substring(refusal.IndexOf("vkd3d-compiler cannot"));

        [Test]
        public void What_vkd3d_cannot_translate_is_refused_in_its_words()
            => Assert.That(Refusal(Doubles), Does.StartWith(
                "T.compute(1): error: in 'K': vkd3d-compiler cannot translate it: ").And.Contain("Unrecognized opcode"));

        [Test]
        public void Once_listed_with_its_reason_it_is_compiled_by_glslang_which_is_said()
        {
            string reason = ReasonOf(Refusal(Doubles));
            CompiledProgram compiled = Compile(Doubles, new Untranslatable("T.compute", "K", reason));
            Assert.That(compiled.WhyGlslang, Is.EqualTo(reason));
            Assert.That(compiled.Program.Resources.Select(r => r.Name), Is.EquivalentTo(new[] { "_In", "_Out" }));
        }

        [Test]
        public void Listed_for_another_reason_it_is_refused()
            => Assert.That(Refusal(Doubles, new Untranslatable("T.compute", "K", "vkd3d-compiler cannot translate it: Tuesday")),
                Does.Contain("Unrecognized opcode"));

        [Test]
        public void What_translates_may_not_be_listed()
            => Assert.That(Refusal(Plain, new Untranslatable("T.compute", "K", "too hard")),
                Does.Contain("listed as untranslatable (too hard), but it translates now: strike it from the list"));

        [Test]
        public void A_program_for_DXC_is_refused()
            => Assert.That(Refusal(Plain.Replace("#pragma kernel K", "#pragma kernel K\n#pragma use_dxc")),
                Is.EqualTo("T.compute(2): error: #pragma use_dxc asks for DXC, whose programs this backend does not run"));

        [Test]
        public void An_error_of_FXC_is_named_with_file_and_line()
            => Assert.That(Refusal(Plain.Replace("2 * _In[0]", "\n\n\n2 * _Im[0]")),
                Does.StartWith("T.compute(6): error: X3004: undeclared identifier '_Im'"));
    }
}
