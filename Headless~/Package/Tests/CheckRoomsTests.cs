using System;
using System.IO;
using Host.Check;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>The rule about rooms compiles each with those before it.</summary>
    public class CheckRoomsTests
    {
        static readonly string[] Order = { "Low", "Low/Within", "High" };

        string folder;

        [SetUp]
        public void MakeFolder() => folder = Directory.CreateTempSubdirectory("rill-rooms-").FullName;

        [TearDown]
        public void RemoveFolder() => Directory.Delete(folder, true);

        [Test]
        public void Rooms_that_name_only_lower_ones_hold()
        {
            Write("Low/A.cs", "namespace Rill { class A { internal const int One = 1; private protected virtual void F() { } } }");
            Write("Low/Within/B.cs", "namespace Rill { class B : A { private protected override void F() { } } }");
            Write("High/Deep/C.cs", "namespace Rill { class C { B b; int one = A.One; } }");
            Findings findings = Examine();
            Assert.That(findings.Faults, Is.Empty);
            Assert.That(findings.Looked, Is.EqualTo("3 files in 3 rooms"));
        }

        [TestCase("class A { C c; }", TestName = "A_type_of_a_higher_room_is_named(field)")]
        [TestCase("class A { object F() => new C(); }", TestName = "A_type_of_a_higher_room_is_named(body)")]
        [TestCase("class A { int one = C.One; }", TestName = "A_type_of_a_higher_room_is_named(constant)")]
        public void A_type_of_a_higher_room_is_named(string source)
        {
            Write("Low/A.cs", $"namespace Rill\n{{\n    {source}\n}}");
            Write("High/C.cs", "namespace Rill { class C { internal const int One = 1; } }");
            Assert.That(Examine().Faults, Has.Count.EqualTo(1)
                .And.Some.Contains("Runtime/Low/A.cs(3): room Low does not compile").And.Some.Contains("'C'"));
        }

        [Test]
        public void A_partial_type_does_not_span_rooms()
        {
            Write("Low/A.cs", "namespace Rill { partial class A { int F() => g; } }");
            Write("High/A.More.cs", "namespace Rill { partial class A { int g; } }");
            Assert.That(Examine().Faults, Has.Some.Contains("room Low"));
        }

        [Test]
        public void A_file_of_no_room_is_named()
        {
            Write("A.cs", "class A { }");
            Assert.That(Examine().Faults, Has.Some.Contains("Runtime/A.cs lies in no room").And.Some.Contains("Low, Low/Within, High"));
        }

        [Test]
        public void An_assembly_of_its_own_is_no_room()
        {
            Write("Low/A.cs", "class A { }");
            Write("Physics/P.cs", "class P { }");
            Assert.That(Examine().Faults, Is.Empty);
        }

        [Test]
        public void The_table_marks_what_is_used()
        {
            Write("Low/A.cs", "namespace Rill { class A { } }");
            Write("Low/Within/B.cs", "namespace Rill { class B { } }");
            Write("High/C.cs", "namespace Rill { class C : A { } }");
            Rooms rooms = RoomsRule.Compile(new PackageTree(folder), Order, new Findings());
            Assert.That(rooms.Matrix(), Is.EqualTo(
                "| uses | `Low` | `Low/Within` |\n| --- | --- | --- |\n| `Low` |  |  |\n| `Low/Within` |  |  |\n| `High` | x |  |\n"));
        }

        Findings Examine() => new RoomsRule(Order).Examine(new PackageTree(folder));

        void Write(string file, string source)
        {
            string path = Path.Combine(folder, "Runtime", file);
            Directory.CreateDirectory(Path.GetDirectoryName(path));
            File.WriteAllText(path, source + Environment.NewLine);
        }
    }
}
