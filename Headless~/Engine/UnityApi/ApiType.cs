using System.Collections.Generic;
using System.Linq;

namespace Host.UnityApi
{
    /// <summary>A type of one version with its members; a type declared in parts is one.</summary>
    sealed class ApiType
    {
        /// <summary>"UnityEngine.Pool.ObjectPool`1"; nested types after a dot.</summary>
        public string Key;
        /// <summary>Name as the lists write it: "UnityEngine.Pool.ObjectPool&lt;T&gt;".</summary>
        public string Name;
        public ApiKind Kind;
        public bool Obsolete, Protected;
        /// <summary>Null: a namespace is around it.</summary>
        public ApiType Outer;
        /// <summary>Those of outer types first; signatures say "!0" for the first of them.</summary>
        public IReadOnlyList<string> TypeParameters;
        /// <summary>Base class and interfaces, in full where a list holds them.</summary>
        public readonly List<ApiTypeName> Bases = new();
        /// <summary>Storage of an enum, or the line of a delegate.</summary>
        public ApiMember Declaration;
        /// <summary>Members with types in full where a list holds them, and type parameters by index.</summary>
        public readonly List<ApiMember> Members = new();

        public bool WithinObsolete => Obsolete || Outer != null && Outer.WithinObsolete;

        public IEnumerable<ApiMember> Named(string name) => Members.Where(member => member.Name == name);

        public override string ToString() => Name;
    }
}
