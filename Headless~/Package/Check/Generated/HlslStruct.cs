using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Runtime.InteropServices;
using System.Text;
using UnityEngine.Headless;

namespace Host.Check
{
    /// <summary>A struct of C# as an element of a structured buffer, or as a constant buffer, whose members lie at the same bytes.</summary>
    sealed class HlslStruct
    {
        // Kind of scalar and how many.
        static readonly Dictionary<string, (string kind, int count)> Types = new()
        {
            ["System.Single"] = ("float", 1), ["System.Int32"] = ("int", 1), ["System.UInt32"] = ("uint", 1),
            ["UnityEngine.Vector2"] = ("float", 2), ["UnityEngine.Vector3"] = ("float", 3), ["UnityEngine.Vector4"] = ("float", 4),
        };

        static HlslStruct()
        {
            foreach (string kind in new[] { "float", "int", "uint" })
                for (int count = 2; count <= 4; count++)
                    Types.Add($"Unity.Mathematics.{kind}{count}", (kind, count));
        }

        sealed class Member
        {
            public string Name, Kind, Summary;
            public int Count, ArrayLength, Offset;

            public string Type => Kind + (Count == 1 ? "" : Count.ToString());
            public string Declaration(string name) => $"{Type} {name}{(ArrayLength == 0 ? "" : $"[{ArrayLength}]")};";
        }

        readonly Type type;
        readonly HlslMark mark;
        readonly CodeSummaries summaries;
        readonly Findings findings;

        HlslStruct(Type type, HlslMark mark, CodeSummaries summaries, Findings findings) => (this.type, this.mark, this.summaries,
            this.findings) = (type, mark, summaries, findings);

        /// <summary>Null where it has a fault, which is named.</summary>
        public static HlslDeclaration Of(Type type, HlslMark mark, CodeSummaries summaries, Findings findings)
        {
            int before = findings.Faults.Count;
            var made = new HlslStruct(type, mark, summaries, findings);
            List<Member> members = made.Members();
            HlslDeclaration declaration = findings.Faults.Count > before ? null : mark.ConstantBuffer == null ? made.Element(members)
                : made.Constants(members);
            return findings.Faults.Count > before ? null : declaration;
        }

        List<Member> Members()
        {
            var members = new List<Member>();
            foreach (FieldInfo field in type.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic).OrderBy(field
                => field.MetadataToken))
            {
                var member = new Member { Name = field.Name, Summary = summaries.Of(field) };
                Type element = field.FieldType;
                if (!Types.ContainsKey(element.FullName) && element.IsValueType && !element.IsPrimitive && !element.IsEnum)
                {
                    // A struct of equal members is an array of them.
                    FieldInfo[] elements = element.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic);
                    if (elements.Length > 0 && elements.All(e => e.FieldType == elements[0].FieldType))
                        (element, member.ArrayLength) = (elements[0].FieldType, elements.Length);
                }
                if (!Types.TryGetValue(element.FullName, out (string kind, int count) shape))
                {
                    findings.Fault($"{type.FullName}.{field.Name} is a {field.FieldType.Name}, which HLSL cannot hold at the same bytes: use " +
                        "int, uint, float, a vector of them, or a struct of equal ones for an array.");
                    continue;
                }
                bool isSigned = HlslMark.Of(field)?.Signed ?? mark.Signed;
                (member.Kind, member.Count) = (shape.kind == "int" && !isSigned ? "uint" : shape.kind, shape.count);
                member.Offset = (int)Marshal.OffsetOf(type, field.Name);
                members.Add(member);
            }
            return members;
        }

        // Elements of a structured buffer lie without gaps, whatever the types.
        HlslDeclaration Element(List<Member> members)
        {
            string name = mark.Name ?? type.Name;
            var text = new StringBuilder("\n" + GeneratedHlsl.Line("", summaries.Of(type)) + $"struct {name}\n{{\n");
            int at = 0;
            foreach (Member member in members)
            {
                Compare(member.Name, member.Offset, at, "a structured buffer");
                at += 4 * member.Count * Math.Max(member.ArrayLength, 1);
                text.Append("    " + GeneratedHlsl.Line(member.Declaration(member.Name), member.Summary));
            }
            Compare("its end", Marshal.SizeOf(type), at, "a structured buffer");
            return new HlslDeclaration(type.FullName, text.Append("};\n").ToString(), name);
        }

        HlslDeclaration Constants(List<Member> members)
        {
            var text = new StringBuilder("\n" + GeneratedHlsl.Line("", summaries.Of(type)) + $"cbuffer {mark.ConstantBuffer}\n{{\n");
            var defines = new StringBuilder();
            var names = new List<string> { mark.ConstantBuffer };
            var declared = new List<(string name, int offset, ConstantField field)>();
            for (int i = 0; i < members.Count; i++)
            {
                Member member = members[i];
                string name = Property(member.Name);
                names.Add(name);
                int count = member.Count;
                Member next = i + 1 < members.Count ? members[i + 1] : null;
                if (count == 3 && member.ArrayLength == 0 && next != null && next.Count == 1 && next.ArrayLength == 0 && next.Kind == member.Kind)
                {
                    string nextName = Property(next.Name), both = $"{name}And{nextName.Substring(1)}";
                    text.Append($"    {member.Kind}4 {both};\n");
                    defines.Append(GeneratedHlsl.Line($"#define {name} ({both}.xyz)",
                        member.Summary)).Append(GeneratedHlsl.Line($"#define {nextName} ({both}.w)", next.Summary));
                    names.Add(nextName);
                    (count, i) = (4, i + 1);
                }
                else
                {
                    if (count is 2 or 3)
                        findings.Fault($"{type.FullName}.{member.Name} is a {member.Type} of a constant buffer, which graphics APIs put at " +
                            $"different bytes: put a {member.Kind} behind a {member.Kind}3, or use scalars or a {member.Kind}4.");
                    else if (member.ArrayLength > 0 && count != 4)
                        findings.Fault($"{type.FullName}.{member.Name} is an array of {member.Type} in a constant buffer, of which each would " +
                            $"take 16 bytes: use a {member.Kind}4 for each.");
                    text.Append("    " + GeneratedHlsl.Line(member.Declaration(name), member.Summary));
                }
                declared.Add((member.Name, member.Offset, new ConstantField { Rows = 1, Columns = count, ArrayLength = member.ArrayLength }));
            }
            foreach (ConstantPacking packing in new[] { ConstantPacking.Direct3D, ConstantPacking.Std140, ConstantPacking.Metal })
            {
                int[] offsets = packing.Offsets(declared.Select(d => d.field).ToList());
                for (int i = 0; i < declared.Count; i++)
                    Compare(declared[i].name, declared[i].offset, offsets[i], packing.Name);
            }
            if (Marshal.SizeOf(type) % 16 != 0)
                findings.Fault($"{type.FullName} has {Marshal.SizeOf(type)} bytes, and a constant buffer has a multiple of 16: add scalars at " +
                    "its end.");
            text.Append("};\n");
            if (defines.Length > 0)
                text.Append('\n').Append(defines);
            return new HlslDeclaration(type.FullName, text.ToString(), names.ToArray());
        }

        void Compare(string member, int here, int there, string where)
        {
            if (here != there)
                findings.Fault($"{type.FullName}: {member} lies at byte {here} in C# and at {there} in HLSL, by the rules of {where}: use " +
                    "LayoutKind.Sequential, and fill what lies before it with scalars.");
        }

        static string Property(string name) => $"_{char.ToUpperInvariant(name[0])}{name.Substring(1)}";
    }
}
