using System.Collections.Generic;
using Host.UnityApi;

namespace Host.Check.Api
{
    /// <summary>A member as an assembly names it: a reference to another assembly's, or a definition of its own.</summary>
    /// <param name="Owner">The type that it is a member of.</param>
    /// <param name="IsStatic">Null: a reference to a field, which does not say.</param>
    /// <param name="Returns">What a method returns, what a field is.</param>
    sealed record CompiledMember(ApiTypeName Owner, string Name, bool IsField, bool? IsStatic, int Arity, ApiTypeName Returns,
        IReadOnlyList<ApiTypeName> Parameters)
    {
        static readonly string[] Accessors = { "get_", "set_", "add_", "remove_" };

        /// <summary>Without the accessor's prefix: what the source says.</summary>
        public string SourceName
        {
            get
            {
                foreach (string accessor in Accessors)
                    if (!IsField && Name.StartsWith(accessor))
                        return Name == "get_Item" || Name == "set_Item" ? "this" : Name.Substring(accessor.Length);
                return Name is "op_Implicit" or "op_Explicit" ? "op_Conversion" : Name;
            }
        }

        public override string ToString()
        {
            string arity = Arity == 0 ? "" : $"<{new string(',', Arity - 1)}>";
            return IsField ? $"{Owner}.{Name} ({Returns})"
                : $"{Owner}.{Name}{arity}({string.Join(", ", Parameters)}){(Name == ".ctor" || Returns.IsVoid ? "" : $" : {Returns}")}";
        }
    }
}
