using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Runtime.InteropServices;
using Host.Check;
using NUnit.Framework;
using Rill;
using Unity.Mathematics;
using UnityEngine;

namespace Host.Tests
{
    /// <summary>Output of [GenerateHlsl], its refusals, and that structs lie on the device as in C#.</summary>
    public sealed class GeneratedHlslTests : ShaderTextFixture
    {
        static class Constants
        {
            [GenerateHlsl("Planted")] public const int Group = 128;
            [GenerateHlsl("Planted", Signed = true)] public const int Band = 2;
            [GenerateHlsl("Planted")] public const int Below = -3;
            [GenerateHlsl("Planted")] public const uint Mask = 0x00FFFFFFu;
            [GenerateHlsl("Planted")] public const uint Few = 4;
            [GenerateHlsl("Planted", Prefix = "Rest")] public const float Side = 8f;
            [GenerateHlsl("Planted")] public const double Small = 1e-8;
            public const int OfCSharpAlone = 1;
        }

        [GenerateHlsl("Planted", Prefix = "Kind")]
        enum Kinds { In, Out = 4, Off }

        [GenerateHlsl("Planted", Name = "Body")]
        struct Element
        {
            public float3 center;
            public uint kind;
            public int2 cells;
            public Vector4 color;
            public Four four;
        }

        struct Four
        {
            public float a, b, c, d;
        }

        [GenerateHlsl("PlantedBuffer", ConstantBuffer = "PlantedConstants")]
        struct Buffer
        {
            public float3 size;
            public float step;
            public int3 counts;
            public int total;
            public float first, second, third, fourth;
            public Levels levels;
        }

        struct Levels
        {
            public uint4 a, b;
        }

        static readonly Type[] Planted = { typeof(Constants), typeof(Kinds), typeof(Element), typeof(Buffer) };

        static CodeSummaries Summaries(params (string id, string text)[] members) =>
            CodeSummaries.Parse($"<doc><members>{string.Concat(members.Select(m => $"<member name=\"{m.id}\"><summary>{m.text}</summary></member>"))}</members></doc>");

        static IReadOnlyDictionary<string, string> Files(params Type[] types) => GeneratedHlsl.Files(types, CodeSummaries.None, new Findings());

        static List<string> Faults(Type type)
        {
            var findings = new Findings();
            Assert.That(GeneratedHlsl.Files(new[] { type }, CodeSummaries.None, findings), Is.Null);
            return findings.Faults;
        }

        static string[] Lines(string text) => text.Split('\n').Skip(3).Where(line => line.Length > 0 && line != "#endif").ToArray();

        [Test]
        public void Constants_enums_and_structs_are_written_as_HLSL()
        {
            Assert.That(Lines(Files(Planted)["Planted"]), Is.EqualTo(new[]
            {
                "static const uint kGroup = 128;", "static const int kBand = 2;", "static const int kBelow = -3;",
                    "static const uint kMask = 0x00FFFFFFu;",
                "static const uint kFew = 4;", "static const float kRestSide = 8.0;", "static const float kSmall = 1E-08;",
                "struct Body", "{", "    float3 center;", "    uint kind;", "    uint2 cells;", "    float4 color;", "    float four[4];", "};",
                "static const uint kKindIn = 0;", "static const uint kKindOut = 4;", "static const uint kKindOff = 5;",
            }));
        }

        [Test]
        public void A_constant_buffer_joins_vectors_of_three_with_the_scalars_behind_them()
        {
            Assert.That(Lines(Files(Planted)["PlantedBuffer"]), Is.EqualTo(new[]
            {
                "cbuffer PlantedConstants", "{", "    float4 _SizeAndStep;", "    uint4 _CountsAndTotal;", "    float _First;", "    float _Second;",
                    "    float _Third;", "    float _Fourth;", "    uint4 _Levels[2];", "};",
                "#define _Size (_SizeAndStep.xyz)", "#define _Step (_SizeAndStep.w)", "#define _Counts (_CountsAndTotal.xyz)",
                "#define _Total (_CountsAndTotal.w)",
            }));
        }

        [Test]
        public void Summaries_become_comments_of_ASCII()
        {
            string id = typeof(Constants).FullName.Replace('+', '.');
            string text = GeneratedHlsl.Files(Planted, Summaries(($"F:{id}.Group", "Threads of <see cref=\"P:A.B.C(System.Int32)\"/>,\n   1/d²."),
                ($"T:{typeof(Kinds).FullName.Replace('+', '.')}", "All kinds.")), new Findings())["Planted"];
            Assert.That(text, Does.Contain("static const uint kGroup = 128;    // Threads of C, 1/d^2.\n").And.Contain("\n// All kinds.\nstatic const uint kKindIn"));
        }

        [Test]
        public void Each_file_says_what_generates_it_and_is_read_once()
        {
            string[] lines = Files(Planted)["PlantedBuffer"].Split('\n');
            Assert.That(lines[0], Does.Contain("rill generate").And.Contain("[GenerateHlsl(\"PlantedBuffer\")]").And.Contain("Do not edit"));
            Assert.That(lines.Skip(1).Take(2), Is.EqualTo(new[] { "#ifndef RILL_GENERATED_PLANTED_BUFFER_INCLUDED",
                "#define RILL_GENERATED_PLANTED_BUFFER_INCLUDED" }));
        }

        static class Twice
        {
            [GenerateHlsl("Planted")] public const int Group = 1;
            [GenerateHlsl("Planted", Prefix = "Gr")] public const int oup = 2;
        }

        static class NoConstant
        {
            [GenerateHlsl("Planted")] public static int Group = 1;
        }

        static class OtherType
        {
            [GenerateHlsl("Planted")] public const string Group = "128";
        }

        static class FileName
        {
            [GenerateHlsl("../Planted")] public const int Group = 128;
        }

        [GenerateHlsl("Planted")]
        struct NotBlittable
        {
            public bool isOn;
        }

        [GenerateHlsl("Planted")]
        [StructLayout(LayoutKind.Explicit)]
        struct Gap
        {
            [FieldOffset(0)] public float first;
            [FieldOffset(8)] public float second;
        }

        [GenerateHlsl("Planted")]
        [StructLayout(LayoutKind.Sequential, Size = 12)]
        struct LongEnd
        {
            public float first, second;
        }

        [GenerateHlsl("Planted", ConstantBuffer = "Planted")]
        struct VectorOfTwo
        {
            public float2 size;
            public float a, b;
        }

        [GenerateHlsl("Planted", ConstantBuffer = "Planted")]
        struct VectorOfThree
        {
            public float a;
            public float3 size;
        }

        [GenerateHlsl("Planted", ConstantBuffer = "Planted")]
        struct OtherKind
        {
            public float3 size;
            public uint count;
        }

        [GenerateHlsl("Planted", ConstantBuffer = "Planted")]
        struct Across
        {
            public float a;
            public float4 b;
            public float c, d, e;
        }

        [GenerateHlsl("Planted", ConstantBuffer = "Planted")]
        struct ShortEnd
        {
            public float a, b, c;
        }

        [GenerateHlsl("Planted", ConstantBuffer = "Planted")]
        struct ArrayOfScalars
        {
            public Four four;
        }

        [TestCase(typeof(Twice), "Twice.oup", "kGroup is in Planted.hlsl already")]
        [TestCase(typeof(NoConstant), "NoConstant.Group", "make it const")]
        [TestCase(typeof(OtherType), "OtherType.Group is a String", "use an int")]
        [TestCase(typeof(FileName), "FileName.Group", "\"../Planted\"")]
        [TestCase(typeof(NotBlittable), "NotBlittable.isOn is a Boolean", "use int, uint, float")]
        [TestCase(typeof(Gap), "second lies at byte 8 in C# and at 4 in HLSL", "LayoutKind.Sequential")]
        [TestCase(typeof(LongEnd), "its end lies at byte 12 in C# and at 8 in HLSL", "LongEnd")]
        [TestCase(typeof(VectorOfTwo), "VectorOfTwo.size is a float2 of a constant buffer", "use scalars")]
        [TestCase(typeof(VectorOfThree), "VectorOfThree.size is a float3 of a constant buffer", "put a float behind")]
        [TestCase(typeof(OtherKind), "OtherKind.size is a float3 of a constant buffer", "put a float behind")]
        [TestCase(typeof(Across), "b lies at byte 4 in C# and at 16 in HLSL", "fill what lies before it")]
        [TestCase(typeof(ShortEnd), "ShortEnd has 12 bytes", "add scalars at its end")]
        [TestCase(typeof(ArrayOfScalars), "ArrayOfScalars.four is an array of float in a constant buffer", "use a float4 for each")]
        public void What_would_not_be_the_same_on_both_sides_is_refused(Type type, string what, string remedy)
        {
            Assert.That(Faults(type), Has.Some.Contains(what).And.Some.Contains(remedy));
        }

        static IEnumerable<Type> Structs() => Planted.Concat(typeof(PbfSolver).Assembly.GetTypes()).Where(type => type.IsValueType && !type.IsEnum
            && HlslMark.Of(type) != null);

        // Numbers every word of two elements in a row and has a kernel read the second, member by member.
        [TestCaseSource(nameof(Structs))]
        public void Every_member_lies_on_the_device_where_it_lies_in_memory(Type type)
        {
            HlslMark mark = HlslMark.Of(type);
            bool isBuffer = mark.ConstantBuffer != null;
            int stride = Marshal.SizeOf(type) / 4, first = isBuffer ? 0 : stride;
            var reads = new List<string>();
            var expected = new List<uint>();
            foreach (FieldInfo field in type.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic))
            {
                string member = isBuffer ? $"_{char.ToUpperInvariant(field.Name[0])}{field.Name.Substring(1)}" : $"_In[1].{field.Name}";
                FieldInfo[] parts = field.FieldType.Namespace == type.Namespace
                    ? field.FieldType.GetFields(BindingFlags.Instance | BindingFlags.Public) : new FieldInfo[0];
                int words = Marshal.SizeOf(field.FieldType) / 4, components = words / Math.Max(parts.Length, 1);
                for (int word = 0; word < words; word++)
                {
                    string element = parts.Length > 0 ? $"[{word / components}]" : "", component = components > 1 ? $".{"xyzw"[word % components]}"
                        : "";
                    reads.Add($"asuint({member}{element}{component})");
                    expected.Add(Number(first + (int)Marshal.OffsetOf(type, field.Name) / 4 + word));
                }
            }
            Assert.That(expected.Distinct().Count(), Is.EqualTo(isBuffer ? expected.Count : stride), "every word of an element belongs to a member");

            string text = "#pragma kernel Probe\n" + Files(type)[mark.File] + (isBuffer ? "" : $"StructuredBuffer<{mark.Name ?? type.Name}> _In;\n") +
                "RWStructuredBuffer<uint> _Words;\n[numthreads(1, 1, 1)] void Probe()\n{\n"
                + string.Concat(reads.Select((read, word) => $"    _Words[{word}] = {read};\n")) + "}\n";
            ComputeShader shader = ComputeOf(text);
            uint[] numbers = Enumerable.Range(0, first + stride).Select(Number).ToArray();
            using (var input = isBuffer ? new GraphicsBuffer(GraphicsBuffer.Target.Constant, 1, 4 * stride)
                : new GraphicsBuffer(GraphicsBuffer.Target.Structured, 2, 4 * stride))
            using (var output = new GraphicsBuffer(GraphicsBuffer.Target.Structured, expected.Count, 4))
            {
                input.SetData(numbers);
                if (isBuffer)
                    shader.SetConstantBuffer(Shader.PropertyToID(mark.ConstantBuffer), input, 0, input.stride);
                else
                    shader.SetBuffer(0, "_In", input);
                shader.SetBuffer(0, "_Words", output);
                shader.Dispatch(0, 1, 1, 1);
                var words = new uint[expected.Count];
                output.GetData(words);
                Assert.That(words, Is.EqualTo(expected));
            }

            // Bits of a normal float.
            static uint Number(int word) => 0x3F800000u + (uint)word;
        }
    }
}
