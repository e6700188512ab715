using Host.Check;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>The rule about culture names every call that takes the user's, and only such.</summary>
    public class CheckCultureTests
    {
        static readonly string[] Planted = { "Rill" };

        PlantedAssemblies planted;

        [SetUp]
        public void MakeFolder() => planted = new PlantedAssemblies();

        [TearDown]
        public void RemoveFolder() => planted.Dispose();

        Findings Examine(string members)
        {
            planted.Compile("UnityEngine", "namespace UnityEngine { public static class Debug { public static void LogFormat(string format, params object[] args) { } } }");
            planted.Compile("Unity.Mathematics", "namespace Unity.Mathematics { public struct float3 { public override string ToString() => null; } }");
            planted.Compile("Rill", "using System; using System.Collections.Generic; using System.Globalization; using System.IO; using System.Linq; " +
                "using System.Text; using UnityEngine; using Unity.Mathematics; using static System.FormattableString; class X { " + members + " }");
            return planted.Examine(new CultureRule(Planted));
        }

        [TestCase("string f(float x) => string.Format(\"{0}\", x);", "string.Format")]
        [TestCase("string f(float x) => $\"{x} m\";", "AppendFormatted")]
        [TestCase("string f(string x) => $\"{x,8}\" + 1.5f;", "float.ToString")]
        [TestCase("string f(float x) => \"a\" + x;", "float.ToString")]
        [TestCase("string f(int x) => x.ToString(\"N0\");", "int.ToString")]
        [TestCase("string f<T>(float? x) => x.ToString();", "float?.ToString")]
        [TestCase("string f((int, double) x) => x.ToString();", "ToString")]
        [TestCase("string f(float3 x) => x.ToString();", "float3.ToString")]
        [TestCase("string f(object x) => string.Concat(\"a\", x);", "string.Concat")]
        [TestCase("string f(List<float> x) => string.Join(\", \", x);", "string.Join")]
        [TestCase("string f(object[] x) => string.Join(\", \", x);", "string.Join")]
        [TestCase("void f(StringBuilder b) => b.Append(1.5f);", "StringBuilder.Append")]
        [TestCase("void f(StringBuilder b) => b.Insert(0, 1.5f);", "StringBuilder.Insert")]
        [TestCase("void f(StringBuilder b) => b.AppendFormat(\"{0}\", 1);", "StringBuilder.AppendFormat")]
        [TestCase("void f(TextWriter w) => w.WriteLine(1.5);", "TextWriter.WriteLine")]
        [TestCase("void f(TextWriter w) => w.Write(\"{0}\", 1.5);", "TextWriter.Write")]
        [TestCase("float f(string x) => float.Parse(x);", "float.Parse")]
        [TestCase("bool f(string x) => double.TryParse(x, out _);", "double.TryParse")]
        [TestCase("float f(string x) => Convert.ToSingle(x);", "Convert.ToSingle")]
        [TestCase("string f(double x) => Convert.ToString(x);", "Convert.ToString")]
        [TestCase("string f(string x) => x.ToLower();", "string.ToLower")]
        [TestCase("char f(char x) => char.ToUpper(x);", "char.ToUpper")]
        [TestCase("bool f(string x) => x.StartsWith(\"i\");", "string.StartsWith")]
        [TestCase("bool f(string x) => x.EndsWith(\"i\", StringComparison.CurrentCulture);", "string.EndsWith")]
        [TestCase("int f(string x) => x.IndexOf(\"i\");", "string.IndexOf")]
        [TestCase("int f(string x) => string.Compare(x, \"i\");", "string.Compare")]
        [TestCase("int f(string x) => x.CompareTo(\"i\");", "string.CompareTo")]
        [TestCase("void f(string[] x) => Array.Sort(x);", "Array.Sort")]
        [TestCase("void f(List<string> x) => x.Sort();", "Sort()")]
        [TestCase("object f(string[] x) => x.OrderBy(y => y);", "Enumerable.OrderBy")]
        [TestCase("object f() => new SortedDictionary<string, int>();", "SortedDictionary")]
        [TestCase("object f() => CultureInfo.CurrentCulture;", "CultureInfo.get_CurrentCulture")]
        [TestCase("object f() => StringComparer.CurrentCultureIgnoreCase;", "StringComparer.get_CurrentCultureIgnoreCase")]
        [TestCase("string f(FormattableString x) => FormattableString.CurrentCulture(x);", "FormattableString.CurrentCulture")]
        [TestCase("void f(float x) => Debug.LogFormat(\"{0}\", x);", "Debug.LogFormat")]
        [TestCase("void f(float x) => throw new ArgumentOutOfRangeException(nameof(x), x, \"too many\");", "ArgumentOutOfRangeException")]
        [TestCase("object f(int[] x) => x.Select(y => y.ToString());", "int.ToString")]
        [TestCase("Func<string, float> f() => float.Parse;", "float.Parse")]
        public void A_call_that_takes_the_user_s_culture_is_named(string member, string called)
            => Assert.That(Examine(member).Faults, Has.Some.StartsWith("Rill.dll: X").And.Contains(called).And.Contains("the user's culture"));

        [Test]
        public void Calls_that_say_which_culture_or_need_none_are_no_fault()
        {
            Findings findings = Examine(@"string a(float x, string s, StringBuilder b) => Invariant($""{x} of {s}"") + $""{s} and {s}"" + x.ToString(CultureInfo.InvariantCulture)
                    + string.Format(CultureInfo.InvariantCulture, ""{0}"", x) + string.Join("", "", new[] { s }) + b.Append(s).Append('c') + s.ToLowerInvariant();
                bool b(string s) => s.StartsWith(""i"", StringComparison.Ordinal) || s.IndexOf('i') > 0 || s.Contains(""i"") || float.TryParse(s, NumberStyles.Float, CultureInfo.InvariantCulture, out _);
                void c(List<string> s, string[] t, float[] n) { s.Sort(StringComparer.Ordinal); Array.Sort(t, StringComparer.Ordinal); Array.Sort(n); }
                string d(bool x, StringComparison e, Guid g) => x.ToString() + e.ToString() + g; void f(TextWriter w) { w.Write(""a""); w.Write('c'); }
                Exception g(int x) => new ArgumentOutOfRangeException(nameof(x), Invariant($""{x} is too many""));");
            Assert.That(findings.Faults, Is.Empty);
        }
    }
}
