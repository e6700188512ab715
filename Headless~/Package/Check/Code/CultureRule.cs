using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection.Metadata;
using Host.Check.Api;
using Host.UnityApi;

namespace Host.Check
{
    /// <summary>
    /// The package formats, reads and compares texts alike under every culture: with a German one a number is "0,05", in Turkish the capital
    /// of i is another letter, and code that was not told which culture to use takes the user's.
    /// </summary>
    /// <remarks>An interpolated string of strings alone is joined without a culture. With anything else in it the compiler calls
    /// string.Format.</remarks>
    sealed class CultureRule : Rule
    {
        const string Remedy = "write Invariant($\"...\") of System.FormattableString, or pass CultureInfo.InvariantCulture",
            Ordinal = "pass StringComparison.Ordinal", Comparer = "pass StringComparer.Ordinal";

        static readonly HashSet<string> Numbers = new() { "System.SByte", "System.Byte", "System.Int16", "System.UInt16", "System.Int32",
            "System.UInt32", "System.Int64", "System.UInt64", "System.Single", "System.Double", "System.Decimal", "System.DateTime",
            "System.DateTimeOffset", "System.TimeSpan" };
        static readonly HashSet<string> Providers = new() { "System.IFormatProvider", "System.Globalization.CultureInfo",
            "System.StringComparison", "System.StringComparer" };
        static readonly HashSet<string> Sorted = new() { "System.Collections.Generic.SortedDictionary`2",
            "System.Collections.Generic.SortedList`2", "System.Collections.Generic.SortedSet`1" };

        readonly IReadOnlyList<string> names;

        public CultureRule(IReadOnlyList<string> assemblies = null) => names = assemblies ?? PackageAssemblies.WithoutTests;

        public override string Name => "code: texts are the same under every culture";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            int calls = 0;
            using var types = new PackageTypes(package, names, findings);
            foreach (PackageType type in types.All)
                foreach (MethodDefinition method in type.Definition.GetMethods().Select(type.Assembly.Metadata.GetMethodDefinition))
                {
                    var said = new HashSet<string>();
                    foreach (CompiledCall call in type.Assembly.Calls(method))
                    {
                        calls++;
                        if (Complaint(call) is { } remedy && said.Add(call.Method.ToString()))
                            findings.Fault($"{type.Assembly.Name}.dll: {type}.{type.Text(method.Name)} calls {Called(call)}, whose text " +
                                $"depends on the user's culture: {remedy}");
                    }
                }
            findings.Looked = $"{calls} calls";
            return findings;
        }

        static string Called(CompiledCall call) => call.Constrained == null ? call.Method.ToString() : $"{call.Constrained}.{call.Method.Name}()";

        /// <summary>Null: the call does not look at the culture. Else what to write instead.</summary>
        static string Complaint(CompiledCall call)
        {
            ApiTypeName owner = call.Constrained != null && call.Method.Owner.Key == "System.Object" ? call.Constrained : call.Method.Owner;
            string name = call.Method.Name;
            List<string> parameters = call.Method.Parameters.Select(type => type.Key).ToList();
            if (parameters.Count > 0 && parameters[^1] == "System.StringComparison" && call.Constant is 0 or 1)
                return Ordinal;
            if (parameters.Any(Providers.Contains))
                return null;
            switch (owner.Key)
            {
                case "System.String":
                    return OfString(name, parameters, call);
                case "System.Char" when name is "ToLower" or "ToUpper":
                    return $"call {name}Invariant";
                case "System.Text.StringBuilder" when name is "Append" or "Insert" or "AppendJoin":
                case "System.IO.TextWriter" or "System.IO.StreamWriter" or "System.IO.StringWriter" when name is "Write" or "WriteLine":
                    return Formats(call) || parameters.Count > 1 && parameters[0] == "System.String" && name.StartsWith("Write") ? Remedy : null;
                case "System.Text.StringBuilder" when name == "AppendFormat":
                case "System.Runtime.CompilerServices.DefaultInterpolatedStringHandler" when name == "AppendFormatted"
                    && (parameters[0] != "System.String" || call.Arguments.Count > 0):
                case "System.FormattableString" when name is "CurrentCulture" or "ToString" && parameters.Count < 2:
                case "UnityEngine.Debug" when name.EndsWith("Format", StringComparison.Ordinal):
                    return Remedy;
                case "System.Convert" when name == "ToString" ? Formats(call) : parameters.Count > 0 && parameters[0] == "System.String"
                    && !name.Contains("Base64", StringComparison.Ordinal) && name != "ToBoolean" && name != "ToChar":
                    return Remedy;
                case "System.ArgumentOutOfRangeException" when name == ".ctor" && parameters.Count == 3:
                    return "pass the value as a part of the message";
                case "System.Globalization.CultureInfo" when name is "get_CurrentCulture" or "get_CurrentUICulture":
                    return "take CultureInfo.InvariantCulture";
                case "System.StringComparer" when name.StartsWith("get_CurrentCulture", StringComparison.Ordinal):
                    return "take StringComparer.Ordinal";
                case "System.Array" when name == "Sort" && call.Arguments.Count > 0 && IsString(call.Arguments[0]) && !Compares(call):
                case "System.Linq.Enumerable" when (name.StartsWith("OrderBy", StringComparison.Ordinal)
                    || name.StartsWith("ThenBy", StringComparison.Ordinal)) && IsString(call.Arguments[^1]) && !Compares(call):
                case "System.Collections.Generic.List`1" when name == "Sort" && IsString(owner.Arguments[0]) && !Compares(call):
                case "System.Collections.Generic.Comparer`1" when name == "get_Default" && IsString(owner.Arguments[0]):
                case var sorted when Sorted.Contains(sorted) && name == ".ctor" && IsString(owner.Arguments[0]) && !Compares(call):
                    return Comparer;
            }
            return HoldsNumbers(owner) && name is "ToString" or "Parse" or "TryParse" or "TryFormat" ? Remedy : null;
        }

        static bool HoldsNumbers(ApiTypeName type) => Numbers.Contains(type.Key)
            || type.Key.StartsWith("Unity.Mathematics.", StringComparison.Ordinal)
            || (type.IsNullable || type.Key.StartsWith("System.ValueTuple`", StringComparison.Ordinal)) && type.Arguments.Any(HoldsNumbers);

        static string OfString(string name, List<string> parameters, CompiledCall call)
        {
            switch (name)
            {
                case "Format":
                    return Remedy;
                case "Concat" or "Join" when Formats(call):
                    return Remedy;
                case "ToLower" or "ToUpper":
                    return $"call {name}Invariant";
                case "StartsWith" or "EndsWith" or "IndexOf" or "LastIndexOf" when parameters[0] == "System.String":
                    return Ordinal;
                case "Compare" or "CompareTo":
                    return "call string.CompareOrdinal";
                default:
                    return null;
            }
        }

        // Whether an argument is made a text of: whatever is not a text already, a character or a place in the text.
        static bool Formats(CompiledCall call)
        {
            if (call.Arguments.Any(argument => !IsString(argument)))
                return true;
            int first = call.Method.Name == "Insert" ? 1 : 0;
            return call.Method.Parameters.Skip(first).Take(call.Method.Name is "Append" or "Insert" or "Write" or "WriteLine" or "ToString" ? 1 : 4)
                .Any(type => Numbers.Contains(type.Key) || type.Key == "System.Object"
                    || type.Form == ApiTypeForm.Array && type.Element.Key == "System.Object");
        }

        // With a comparer or a comparison of the caller's.
        static bool Compares(CompiledCall call) => call.Method.Parameters.Any(type =>
            type.Key is "System.Collections.Generic.IComparer`1" or "System.Comparison`1");

        static bool IsString(ApiTypeName type) => type.Key == "System.String";
    }
}
