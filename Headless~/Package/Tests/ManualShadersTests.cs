using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Host.Shaders;
using NUnit.Framework;
using UnityEngine.Headless;

namespace Host.Tests
{
    /// <summary>The HLSL of the manual compiles: whole shaders as they are, other blocks in a kernel over the particles.</summary>
    public sealed class ManualShadersTests
    {
        const string Package = "Packages/com.rill.fluids/";
        const string KernelStart = "#pragma kernel Main\n#include \"" + Package + "Shaders/RillParticles.hlsl\"\n\n" +
            "RWStructuredBuffer<float4> _Sums;\n\n[numthreads(kRillThreads, 1, 1)]\n" +
            "void Main(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)\n{\nuint i = RillIndex(group, thread);\n" +
            "if (i >= RillCount())\n    return;\nfloat3 sum = 0;\n";
        const string KernelEnd = "_Sums[i] = float4(sum, 0);\n}\n";

        string folder;

        [OneTimeSetUp]
        public void Start() => folder = Directory.CreateTempSubdirectory("rill-manual-hlsl-").FullName;

        [OneTimeTearDown]
        public void End() => Directory.Delete(folder, recursive: true);

        static IEnumerable<TestCaseData> Blocks()
        {
            foreach (string page in Directory.GetFiles(Path.Combine(PackageFolder.Path, "Documentation~"), "*.md").OrderBy(page => page,
                StringComparer.Ordinal))
            {
                int number = 0;
                foreach (string block in BlocksOf(File.ReadAllText(page)))
                    yield return new TestCaseData(block).SetName($"HLSL block {++number} of {Path.GetFileName(page)} compiles");
            }
        }

        [TestCaseSource(nameof(Blocks))]
        public void A_block_compiles(string block) => Assert.That(Problems(block), Is.Empty);

        [Test]
        public void The_manual_has_such_blocks() => Assert.That(Blocks().Count(), Is.GreaterThanOrEqualTo(2));

        [TestCase("sum += RillVelocity(i);\n", true)]
        [TestCase("sum += RillSwiftness(i);\n", false)]
        [TestCase("#pragma kernel K\n[numthreads(1, 1, 1)] void K() {}\n", true)]
        [TestCase("#pragma kernel K\n[numthreads(1, 1, 1)] void K() { no; }\n", false)]
        public void A_block_that_does_not_compile_is_seen(string block, bool compiles)
            => Assert.That(Problems(block), compiles ? Is.Empty : Is.Not.Empty);

        [TestCase("```hlsl\na();\n```\n", "a();\n")]
        [TestCase("1. Do:\n\n   ```hlsl\n   a();\n   ```\n", "a();\n")]
        [TestCase("```csharp\na();\n```\n", null)]
        public void A_block_is_found(string page, string text) => Assert.That(BlocksOf(page).SingleOrDefault(), Is.EqualTo(text));

        static IEnumerable<string> BlocksOf(string page)
            => Regex.Matches(page.Replace("\r\n", "\n"), @"^(?<indent> *)```hlsl *\n(?<text>(?:.*\n)*?) *```$", RegexOptions.Multiline)
                .Select(match => Regex.Replace(match.Groups["text"].Value, "^" + match.Groups["indent"].Value, "", RegexOptions.Multiline));

        // Messages of the compiler that this host runs.
        List<string> Problems(string block)
        {
            string path = Path.Combine(folder, Guid.NewGuid().ToString("N") + ".compute");
            File.WriteAllText(path, block.Contains("#pragma kernel") ? block : KernelStart + block + KernelEnd);
            var problems = new List<string>();
            foreach (ShaderVariant variant in ShaderImporter.AllVariants(path, "Manual.compute", Resolve, new ShaderCache()))
                try
                {
                    if (variant.Fault != null)
                        throw variant.Fault;
                    variant.Compile();
                }
                catch (ShaderCompileException e)
                {
                    problems.Add(e.Message);
                }
            return problems;
        }

        static string Resolve(string include) => include.StartsWith(Package, StringComparison.Ordinal)
            ? Path.Combine(PackageFolder.Path, include.Substring(Package.Length)) : null;
    }
}
