using System.Linq;
using Host.Check;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>The rule about long lines names them, and lets stay what cannot be broken.</summary>
    public class CheckLineLengthTests
    {
        const int Max = 150;

        static string[] Faults(string file, string line)
        {
            using var package = new SyntheticPackage();
            return new LineLengthRule().Examine(package.Add(file, "// first\n" + line + "\n").Tree).Faults.ToArray();
        }

        static string Sum(int columns) => "int a = b" + string.Concat(Enumerable.Repeat(" + c", columns / 4)) + ";";

        [TestCase("Runtime/A.cs")]
        [TestCase("Tests/Runtime/A.cs")]
        [TestCase("Shaders/A.hlsl")]
        [TestCase("Shaders/A.compute")]
        public void A_line_that_is_too_long_is_named(string file)
            => Assert.That(Faults(file, Sum(160)), Has.Length.EqualTo(1).And.All.Contains($"{file}(2) has 170 columns, more than {Max}"));

        [Test]
        public void A_long_line_with_short_strings_is_named()
            => Assert.That(Faults("Runtime/A.cs", "Call(\"a\", " + Sum(140) + ", \"b\");"), Has.Length.EqualTo(1));

        [Test]
        public void A_line_that_fits_is_not() => Assert.That(Faults("Runtime/A.cs", new string('/', Max)), Is.Empty);

        [TestCase("Shaders/Generated/A.hlsl", "")]
        [TestCase("Runtime/A.Generated.cs", "")]
        [TestCase("Headless~/Engine/A.cs", "")]
        [TestCase("Shaders/A.compute", "#pragma kernel ")]
        public void What_has_to_stay_in_one_line_or_Unity_does_not_see_may(string file, string start) => Assert.That(Faults(file, start + Sum(160)),
            Is.Empty);

        [Test]
        public void A_long_string_may_stay_in_one_piece()
            => Assert.That(Faults("Runtime/A.cs", "Log(\"it says \\\"no\\\" " + new string('a', Max) + "\");"), Is.Empty);
    }
}
