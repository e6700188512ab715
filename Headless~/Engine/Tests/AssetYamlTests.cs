using System.Collections.Generic;
using System.Linq;
using Host.Assets;
using NUnit.Framework;

namespace Host.Tests
{
    public class AssetYamlTests
    {
        const string Header = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n";

        static UnityYaml Parse(string body) => UnityYaml.Parse(Header + body, "Assets/Test.unity");
        static YamlMapping Fields(string lines) => Parse("--- !u!114 &1\nMonoBehaviour:\n" + lines).Documents[0].Fields;

        [Test]
        public void Documents_keep_class_file_id_type_and_line()
        {
            var yaml = Parse("--- !u!1 &10\nGameObject:\n  m_Name: A\n--- !u!4 &-9223372036854775808\nTransform:\n  m_Father: {fileID: 0}\n");
            Assert.That(yaml.Documents.Select(d => (d.ClassId, d.FileId, d.TypeName, d.Location.Line)),
                Is.EqualTo(new[] { (1, 10L, "GameObject", 3), (4, long.MinValue, "Transform", 6) }));
            Assert.That(yaml.Find(10).Fields["m_Name"].Location.ToString(), Is.EqualTo("Assets/Test.unity(5)"));
            Assert.That(yaml.Find(11), Is.Null);
        }

        [Test]
        public void Stripped_documents_are_told_apart()
        {
            var yaml = Parse("--- !u!4 &7 stripped\nTransform:\n  m_PrefabInstance: {fileID: 3}\n--- !u!4 &8\nTransform:\n  m_RootOrder: 1\n");
            Assert.That(yaml.Documents.Select(d => d.Stripped), Is.EqualTo(new[] { true, false }));
        }

        [Test]
        public void Windows_line_ends_change_nothing()
        {
            var yaml = UnityYaml.Parse((Header
                + "--- !u!1 &10\nGameObject:\n  m_Name: A B\n  m_Layer: 5\n--- !u!1 &11\nGameObject:\n  m_Name: \n").Replace("\n", "\r\n"),
                "x");
            Assert.That(yaml.Find(10).Fields.Text("m_Name"), Is.EqualTo("A B"));
            Assert.That(yaml.Find(10).Fields.Int("m_Layer"), Is.EqualTo(5));
            Assert.That(yaml.Find(11).Fields.Text("m_Name", "lacking"), Is.EqualTo(""));
        }

        [Test]
        public void References_may_break_over_lines()
        {
            var reference = Fields("  target: {fileID: -42, guid: 0123456789abcdef0123456789abcdef,\n    type: 3}\n").Reference("target");
            Assert.That(reference.FileId, Is.EqualTo(-42));
            Assert.That(reference.Guid, Is.EqualTo("0123456789abcdef0123456789abcdef"));
            Assert.That(reference.IsLocal, Is.False);
            Assert.That(Fields("  target: {fileID: 0}\n").Reference("target").IsNone);
        }

        [TestCase("1.5e-05", 1.5e-05f)]
        [TestCase("-0.25", -0.25f)]
        [TestCase("3", 3f)]
        [TestCase("inf", float.PositiveInfinity)]
        [TestCase("-inf", float.NegativeInfinity)]
        [TestCase("Infinity", float.PositiveInfinity)]
        [TestCase("nan", float.NaN)]
        [TestCase("-nan(ind)", float.NaN)]
        public void Numbers_read_the_same_in_every_culture(string text, float expected)
        {
            var before = System.Globalization.CultureInfo.CurrentCulture;
            var german = (System.Globalization.CultureInfo)System.Globalization.CultureInfo.InvariantCulture.Clone();
            german.NumberFormat.NumberDecimalSeparator = ",";
            german.NumberFormat.NumberGroupSeparator = ".";
            System.Globalization.CultureInfo.CurrentCulture = german;
            try
            {
                Assert.That(Fields($"  x: {text}\n").Float("x"), Is.EqualTo(expected));
            }
            finally
            {
                System.Globalization.CultureInfo.CurrentCulture = before;
            }
        }

        [Test]
        public void Masks_written_unsigned_are_taken_bit_for_bit() => Assert.That(Fields("  m_Bits: 4294967295\n").Int("m_Bits"), Is.EqualTo(-1));

        [Test]
        public void Strings_keep_quotes_colons_and_folded_lines()
        {
            var fields = Fields("  a: 'It''s: 5% #1'\n  b: \"x\\ty\\n\\u00e9\"\n  c: a long text that\n    goes on here\n  d: \n  e: '  '\n");
            Assert.That(new[] { "a", "b", "c", "d", "e" }.Select(k => fields.Text(k)),
                Is.EqualTo(new[] { "It's: 5% #1", "x\ty\né", "a long text that goes on here", "", "  " }));
        }

        [Test]
        public void Repeated_keys_of_old_editors_are_all_kept()
        {
            var group = (YamlMapping)Fields("  m_Floats:\n    data:\n      second: 1\n    data:\n      second: 2\n")["m_Floats"];
            Assert.That(group.Entries.Select(e => e.Value.Int("second")), Is.EqualTo(new[] { 1, 2 }));
        }

        [Test]
        public void Packed_numbers_are_little_endian()
        {
            var ints = new List<object>();
            Assert.That(PackedNumbers.TryRead(typeof(int), "01000000feffffff", ints));
            Assert.That(ints, Is.EqualTo(new object[] { 1, -2 }));
            Assert.That(PackedNumbers.TryRead(typeof(int), "010000", ints), Is.False);
            Assert.That(PackedNumbers.TryRead(typeof(byte), "xy", ints), Is.False);
            var longs = new List<object>();
            Assert.That(PackedNumbers.TryRead(typeof(long), "ffffffffffffff7f", longs));
            Assert.That(longs, Is.EqualTo(new object[] { long.MaxValue }));
        }

        [TestCase("hello", "no Unity YAML file")]
        [TestCase("version https://git-lfs.github.com/spec/v1\noid sha256:1\n", "git lfs pull")]
        [TestCase("%YAML 1.1\n--- !u!1 &1\nGameObject:\n  m_Name: A\n<<<<<<< HEAD\n", "Assets/X.unity(5): a merge conflict")]
        [TestCase("%YAML 1.1\n--- !u!1 &1\nGameObject:\n  m_Name: A\n--- !u!1 &1\nGameObject:\n  m_Name: B\n",
            "file id 1 is that of the document in line 2 too")]
        [TestCase("%YAML 1.1\n--- !u!one &1\nGameObject:\n  m_Name: A\n", "Assets/X.unity(2): '--- !u!one &1' is not a document header")]
        [TestCase("%YAML 1.1\n--- !u!1 &1\nGameObject:\n  m_Name: {a: 1\n", "Assets/X.unity(")]
        public void Damaged_files_are_refused_with_their_line(string text, string expected) =>
            Assert.That(Assert.Throws<AssetException>(() => UnityYaml.Parse(text, "Assets/X.unity")).Message, Does.Contain(expected));

        [Test]
        public void A_value_of_the_wrong_kind_names_its_line() =>
            Assert.That(Assert.Throws<AssetException>(() => Fields("  a: 1\n  x: many\n").Int("x")).Message,
            Is.EqualTo("Assets/Test.unity(6): 'many' is not a whole number"));

        [TestCase("settings.radius", "4")]
        [TestCase("list.Array.data[1].x", "4")]
        [TestCase("absent.inner.value", "4")]
        [TestCase("absentList.Array.data[2]", "4")]
        public void Overrides_reach_into_groups_and_lists(string path, string value)
        {
            var fields = Fields("  settings:\n    radius: 1\n  list:\n  - {x: 1, y: 2}\n  - {x: 3, y: 4}\n");
            PropertyPath.Set(fields, path, new YamlScalar(default, value));
            var at = path.Replace("Array.data[1]", "1").Replace("Array.data[2]", "2").Split('.')
                .Aggregate((YamlNode)fields, (node, key) => int.TryParse(key, out var index) ? ((YamlSequence)node).Elements[index] : node[key]);
            Assert.That(((YamlScalar)at).Value, Is.EqualTo(value));
        }

        [Test]
        public void A_longer_list_repeats_its_last_element()
        {
            var fields = Fields("  list:\n  - {x: 1}\n");
            PropertyPath.Set(fields, "list.Array.size", new YamlScalar(default, "3"));
            PropertyPath.Set(fields, "list.Array.data[1].x", new YamlScalar(default, "2"));
            Assert.That(fields.Items("list").Select(i => i.Int("x")), Is.EqualTo(new[] { 1, 2, 1 }));
        }
    }
}
