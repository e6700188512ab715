using System;
using System.Collections.Generic;
using System.Linq;

namespace Host.UnityApi
{
    enum ApiTypeForm { Named, Parameter, Array, Pointer }

    /// <summary>
    /// A type as a signature names it. Both sides of a comparison are brought to this form: C#'s keywords are full names
    /// (int: System.Int32), T? of a struct is not told from T? of a class, tuples are System.ValueTuple.
    /// </summary>
    sealed class ApiTypeName
    {
        public readonly ApiTypeForm Form;
        /// <summary>Of a named type: "System", "Collections", "Generic", "List". Of a type parameter: its name.</summary>
        public readonly IReadOnlyList<string> Path;
        /// <summary>Type arguments, those of outer types first; of an array or pointer the element.</summary>
        public readonly IReadOnlyList<ApiTypeName> Arguments;
        /// <summary>Of an array.</summary>
        public readonly int Rank;

        ApiTypeName(ApiTypeForm form, IReadOnlyList<string> path, IReadOnlyList<ApiTypeName> arguments, int rank = 0)
        {
            Form = form;
            Path = path;
            Arguments = arguments;
            Rank = rank;
        }

        static readonly IReadOnlyList<ApiTypeName> None = Array.Empty<ApiTypeName>();

        static readonly Dictionary<string, string> Keywords = new()
        {
            ["void"] = "Void", ["bool"] = "Boolean", ["char"] = "Char", ["string"] = "String", ["object"] = "Object",
            ["sbyte"] = "SByte", ["byte"] = "Byte", ["short"] = "Int16", ["ushort"] = "UInt16", ["int"] = "Int32", ["uint"] = "UInt32",
            ["long"] = "Int64", ["ulong"] = "UInt64", ["float"] = "Single", ["double"] = "Double", ["decimal"] = "Decimal",
            ["nint"] = "IntPtr", ["nuint"] = "UIntPtr",
        };

        public static ApiTypeName Named(IReadOnlyList<string> path, IReadOnlyList<ApiTypeName> arguments = null)
        {
            if (path.Count == 1 && Keywords.TryGetValue(path[0], out string name))
                path = new[] { "System", name };
            return new ApiTypeName(ApiTypeForm.Named, path, arguments ?? None);
        }

        /// <summary>Type parameters are compared by place, not by name: "!0" of the type, "!!0" of the method.</summary>
        public static ApiTypeName Parameter(string name) => new(ApiTypeForm.Parameter, new[] { name }, None);
        public static ApiTypeName ArrayOf(ApiTypeName element, int rank = 1) => new(ApiTypeForm.Array, Array.Empty<string>(), new[] { element }, rank);
        public static ApiTypeName PointerTo(ApiTypeName element) => new(ApiTypeForm.Pointer, Array.Empty<string>(), new[] { element });
        public static ApiTypeName NullableOf(ApiTypeName element) => Named(new[] { "System", "Nullable" }, new[] { element });
        public static ApiTypeName TupleOf(IReadOnlyList<ApiTypeName> elements) => Named(new[] { "System", "ValueTuple" }, elements);

        /// <summary>The type's own name, without what it is in.</summary>
        public string Name => Path.Count == 0 ? "" : Path[^1];
        public bool IsVoid => Form == ApiTypeForm.Named && Path.Count == 2 && Path[1] == "Void" && Path[0] == "System";
        public bool IsNullable => Form == ApiTypeForm.Named && Name == "Nullable" && Arguments.Count == 1;

        /// <summary>The same with type parameters in place of the names that <paramref name="parameters"/> has.</summary>
        public ApiTypeName Bind(IReadOnlyDictionary<string, string> parameters)
        {
            if (Form == ApiTypeForm.Named && Path.Count == 1 && Arguments.Count == 0 && parameters.TryGetValue(Path[0], out string place))
                return Parameter(place);
            return Arguments.Count == 0 ? this : new ApiTypeName(Form, Path, Arguments.Select(argument => argument.Bind(parameters)).ToList(), Rank);
        }

        /// <summary>The same with types in place of type parameters.</summary>
        public ApiTypeName Substitute(Func<string, ApiTypeName> argument)
        {
            if (Form == ApiTypeForm.Parameter)
                return argument(Name) ?? this;
            return Arguments.Count == 0 ? this : new ApiTypeName(Form, Path, Arguments.Select(inner => inner.Substitute(argument)).ToList(), Rank);
        }

        public override string ToString() => Form switch
        {
            ApiTypeForm.Array => $"{Arguments[0]}[{new string(',', Rank - 1)}]",
            ApiTypeForm.Pointer => $"{Arguments[0]}*",
            ApiTypeForm.Parameter => Name,
            _ when IsNullable => $"{Arguments[0]}?",
            _ when Path.Count == 2 && Path[0] == "System" && Keyword(Path[1]) is { } keyword => keyword,
            _ => string.Join(".", Path) + (Arguments.Count == 0 ? "" : $"<{string.Join(", ", Arguments)}>"),
        };

        static string Keyword(string name) => name is "IntPtr" or "UIntPtr" ? null : Keywords.FirstOrDefault(pair => pair.Value == name).Key;
    }
}
