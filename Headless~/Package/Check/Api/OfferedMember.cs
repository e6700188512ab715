using System.Collections.Generic;
using Host.UnityApi;

namespace Host.Check.Api
{
    /// <summary>A public or protected member that an assembly defines, with what only definitions tell.</summary>
    sealed class OfferedMember
    {
        public CompiledMember Member;
        public bool Protected, Obsolete, Constant, ReadOnly, Virtual;
        /// <summary>Parameters as declared: names, ref, in and out, params, optional. Null: a field, or a property's accessor.</summary>
        public IReadOnlyList<ApiParameter> Parameters;

        public override string ToString() => Member.ToString();
    }
}
