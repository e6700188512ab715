using Host.Check;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>The rule that keeps the engine apart from the package sees what would tie it.</summary>
    public class CheckEngineTests
    {
        static Findings Examine(string project, string code)
        {
            using var package = new SyntheticPackage();
            package.Add("Headless~/Engine/Playing/Playing.csproj",
                $"<Project Sdk=\"Microsoft.NET.Sdk\"><ItemGroup>{project}</ItemGroup></Project>").Add("Headless~/Engine/Playing/Session.cs",
                code).Add("Headless~/Package/Host/Program.cs", "using Rill;");
            return new EngineRule().Examine(package.Tree);
        }

        [TestCase(
            @"<ProjectReference Include=""../Vulkan/Host.Vulkan.csproj"" /><PackageReference Include=""NUnit"" /><InternalsVisibleTo Include=""Host"" /><EmbeddedResource Include=""$(NuGetPackageRoot)a/b.dll"" />")]
        [TestCase(@"<Compile Include=""**/*.cs"" />")]
        public void What_lies_in_the_engine_may_be_referred_to(string project)
            => Assert.That(Examine(project, "// RILL_CACHE names a folder; rill is the command").Faults, Is.Empty);

        [TestCase(@"<ProjectReference Include=""../../Package/Rill/Rill.csproj"" />", "../../Package/Rill/Rill.csproj")]
        [TestCase(@"<Compile Include=""$(PackageRoot)Runtime/**/*.cs"" />", "$(PackageRoot)Runtime/**/*.cs")]
        [TestCase(@"<None Include=""..\..\..\Shaders\*.hlsl"" />", @"..\..\..\Shaders\*.hlsl")]
        public void What_lies_outside_may_not(string project, string path)
            => Assert.That(Examine(project, "").Faults, Has.Count.EqualTo(1).And.All.Contains("Playing.csproj refers to " + path));

        [TestCase("using Rill;")]
        [TestCase("// as Rill has it")]
        [TestCase("Load(\"Rill.Tests\");")]
        public void Code_may_not_name_the_package(string line)
            => Assert.That(Examine("", "\n" + line).Faults,
            Has.Count.EqualTo(1).And.All.Contains("Headless~/Engine/Playing/Session.cs(2) names Rill"));

        [Test]
        public void Without_an_engine_there_is_nothing_to_hold()
        {
            using var package = new SyntheticPackage();
            Assert.That(new EngineRule().Examine(package.Tree).Faults, Is.EqualTo(new[] { "Headless~/Engine/ has no project" }));
        }
    }
}
