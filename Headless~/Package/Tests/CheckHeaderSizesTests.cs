using System.IO;
using Host.Check;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>The rule about sizes in the headers of shaders.</summary>
    public class CheckHeaderSizesTests
    {
        [TestCase("//   _Counters  [16]  in   uint", "_Counters is the number 16")]
        [TestCase("//   _Reactions [256 * 13]  i/o  uint", "_Reactions is the number 256 * 13")]
        [TestCase("//   _Arguments [8 words]  out", "_Arguments is the number 8")]
        public void A_size_that_is_a_number_is_named(string line, string fault)
            => Assert.That(Faults(line), Has.Length.EqualTo(1).And.Some.Contains("Shaders/A.compute(2)").And.Some.Contains(fault));

        [TestCase("//   _Counters  [kCounterCount]  in   uint")]
        [TestCase("//   _Rows  [2 bricks + 1]  in   uint")]
        [TestCase("//   _Volume  [1]  in   uint")]
        [TestCase("uint _Counters[16];")]
        public void A_size_by_name_and_code_are_not(string line) => Assert.That(Faults(line), Is.Empty);

        static string[] Faults(string line)
        {
            string folder = Directory.CreateTempSubdirectory("rill-sizes-").FullName;
            try
            {
                Directory.CreateDirectory(Path.Combine(folder, "Shaders"));
                File.WriteAllText(Path.Combine(folder, "Shaders/A.compute"), "// About A.\n" + line + "\n");
                return new HeaderSizesRule().Examine(new PackageTree(folder)).Faults.ToArray();
            }
            finally
            {
                Directory.Delete(folder, true);
            }
        }
    }
}
