using System;
using System.Collections.Generic;
using System.Linq;

namespace Host.UnityApi
{
    enum ApiTypeForm { Named, Parameter, Array, Pointer, Reference }

    /// <summary>
    /// A type as a signature names it. Both sides of a comparison are brought to this form: C#'s keywords are full names
    /// (int: System.Int32), T? of a struct is not told from T? of a class, tuples are System.ValueTuple.
    /// </summary>
    sealed class ApiTypeName
    {
        public readonly ApiTypeForm Form;
        /// <summary>Path of a named type, each part with the number of its own type parameters as metadata has it: "System", "Collections",
        /// "Generic", "List`1". Of a type parameter its name or index.</summary>
        public readonly IReadOnlyList<string> Path;
        /// <summary>Type arguments, those of outer types first; of an array, pointer or reference the element.</summary>
        public readonly IReadOnlyList<ApiTypeName> Arguments;
        /// <summary>Rank of an array.</summary>
        public readonly int Rank;
        /// <summary>The path begins at the outermost namespace. Not so in a signature as written.</summary>
        public readonly bool Full;

        ApiTypeName(ApiTypeForm form, IReadOnlyList<string> path, IReadOnlyList<ApiTypeName> arguments, int rank = 0, bool full = false)
        {
            Form = form;
            Path = path;
            Arguments = arguments;
            Rank = rank;
            Full = full;
        }

        static readonly IReadOnlyList<ApiTypeName> None = Array.Empty<ApiTypeName>();

        static readonly Dictionary<string, string> Keywords = new()
        {
            ["void"] = "Void", ["bool"] = "Boolean", ["char"] = "Char", ["string"] = "String", ["object"] = "Object",
            ["sbyte"] = "SByte", ["byte"] = "Byte", ["short"] = "Int16", ["ushort"] = "UInt16", ["int"] = "Int32", ["uint"] = "UInt32",
            ["long"] = "Int64", ["ulong"] = "UInt64", ["float"] = "Single", ["double"] = "Double", ["decimal"] = "Decimal",
            ["nint"] = "IntPtr", ["nuint"] = "UIntPtr",
        };

        /// <summary>Name as written: a keyword, a name, a part of a full name.</summary>
        public static ApiTypeName Written(IReadOnlyList<string> path, IReadOnlyList<ApiTypeName> arguments = null) =>
            path.Count == 1 && Keywords.TryGetValue(path[0], out string name) ? Named(new[] { "System", name })
            : new ApiTypeName(ApiTypeForm.Named, path, arguments ?? None);

        /// <summary>By full name.</summary>
        public static ApiTypeName Named(IReadOnlyList<string> path, IReadOnlyList<ApiTypeName> arguments = null)
            => new(ApiTypeForm.Named, path, arguments ?? None, full: true);

        /// <summary>Type parameters are compared by index, not by name: "!0" of the type, "!!0" of the method.</summary>
        public static ApiTypeName Parameter(string name) => new(ApiTypeForm.Parameter, new[] { name }, None);
        public static ApiTypeName ArrayOf(ApiTypeName element, int rank = 1)
            => new(ApiTypeForm.Array, Array.Empty<string>(), new[] { element }, rank);
        public static ApiTypeName PointerTo(ApiTypeName element) => new(ApiTypeForm.Pointer, Array.Empty<string>(), new[] { element });
        public static ApiTypeName ReferenceTo(ApiTypeName element) => new(ApiTypeForm.Reference, Array.Empty<string>(), new[] { element });
        public static ApiTypeName NullableOf(ApiTypeName element) => Named(new[] { "System", "Nullable`1" }, new[] { element });
        public static ApiTypeName TupleOf(IReadOnlyList<ApiTypeName> elements) => Named(new[] { "System", "ValueTuple`" + elements.Count }, elements);

        /// <summary>The type's own name, without what it is in.</summary>
        public string Name => Path.Count == 0 ? "" : Path[^1];
        /// <summary>The path with dots: the key of a type.</summary>
        public string Key => string.Join(".", Path);
        public bool IsVoid => Form == ApiTypeForm.Named && Key == "System.Void";
        public bool IsNullable => Form == ApiTypeForm.Named && Key == "System.Nullable`1";
        public ApiTypeName Element => Arguments[0];

        /// <summary>Returns the name with every named type or parameter in it replaced; arguments first.</summary>
        public ApiTypeName Map(Func<ApiTypeName, ApiTypeName> map)
        {
            ApiTypeName mapped = Arguments.Count == 0 ? this
                : new ApiTypeName(Form, Path, Arguments.Select(argument => argument.Map(map)).ToList(), Rank, Full);
            return Form is ApiTypeForm.Named or ApiTypeForm.Parameter ? map(mapped) : mapped;
        }

        public override string ToString() => Form switch
        {
            ApiTypeForm.Array => $"{Element}[{new string(',', Rank - 1)}]",
            ApiTypeForm.Pointer => $"{Element}*",
            ApiTypeForm.Reference => $"ref {Element}",
            ApiTypeForm.Parameter => Name,
            _ when IsNullable => $"{Element}?",
            _ when Path.Count == 2 && Path[0] == "System" && Keyword(Path[1]) is { } keyword => keyword,
            _ => string.Join(".", Path.Select(part => part.Split('`')[0])) + (Arguments.Count == 0 ? "" : $"<{string.Join(", ", Arguments)}>"),
        };

        static string Keyword(string name) => name is "IntPtr" or "UIntPtr" ? null : Keywords.FirstOrDefault(pair => pair.Value == name).Key;
    }
}
