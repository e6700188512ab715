using System;
using System.Collections.Generic;
using System.Linq;

namespace Host.UnityApi
{
    enum ApiKind { Class, Struct, Interface, Enum, Delegate, Value, Field, Property, Indexer, Event, Method, Constructor, Operator, Conversion }

    enum ApiPass { ByValue, Ref, In, Out }

    /// <param name="Default">What stands after '='; null: nothing does.</param>
    sealed record ApiParameter(string Name, ApiTypeName Type, ApiPass Pass, bool Params, bool This, string Default)
    {
        public bool ByReference => Pass != ApiPass.ByValue;

        public override string ToString() => (Params ? "params " : "") + (Pass == ApiPass.ByValue ? ""
            : Pass.ToString().ToLowerInvariant() + " ") + Type;
    }

    /// <summary>A line of the lists, parsed.</summary>
    sealed class ApiMember
    {
        public ApiLine Line;
        public ApiKind Kind;
        /// <summary>"Dispatch", ".ctor", "this", "op_Addition" (for a conversion "op_Conversion"), of a type "".</summary>
        public string Name = "";
        public IReadOnlyList<string> TypeParameters = Array.Empty<string>();
        public IReadOnlyList<ApiParameter> Parameters = Array.Empty<ApiParameter>();
        /// <summary>Type that a method, operator or delegate returns, or a field or property has; of an enum its underlying type.</summary>
        public ApiTypeName Type;
        /// <summary>Base class and interfaces of a type, in the order of the declaration.</summary>
        public IReadOnlyList<ApiTypeName> Bases = Array.Empty<ApiTypeName>();
        public bool Static, Protected, Abstract, Virtual, Override, ReadOnly, Constant, ReturnsReference, CanRead, CanWrite;

        public bool IsType => Kind <= ApiKind.Delegate;
        public bool Obsolete => Line.Obsolete;

        public ApiMember With(ApiTypeName type, IReadOnlyList<ApiParameter> parameters)
        {
            var copy = (ApiMember)MemberwiseClone();
            copy.Type = type;
            copy.Parameters = parameters;
            return copy;
        }

        public ApiMember With(ApiKind kind, string name)
        {
            var copy = (ApiMember)MemberwiseClone();
            copy.Kind = kind;
            copy.Name = name;
            return copy;
        }

        public override string ToString() => Kind switch
        {
            ApiKind.Value => $"value {Name}",
            ApiKind.Field or ApiKind.Event => $"{(Static ? "static " : "")}{Type} {Name}",
            ApiKind.Property => $"{(Static ? "static " : "")}{Type} {Name}",
            ApiKind.Constructor => $".ctor({string.Join(", ", Parameters)})",
            ApiKind.Class or ApiKind.Struct or ApiKind.Interface or ApiKind.Enum => Kind.ToString().ToLowerInvariant(),
            _ => $"{(Static ? "static " : "")}{Type} " +
                $"{Name}{(TypeParameters.Count == 0 ? "" : $"<{string.Join(", ", TypeParameters)}>")}({string.Join(", ", Parameters)})",
        };
    }
}
