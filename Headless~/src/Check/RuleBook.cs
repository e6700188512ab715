using System.Collections.Generic;
using Host.Check.Api;

namespace Host.Check
{
    /// <summary>All rules, in the order of the table.</summary>
    static class RuleBook
    {
        public static IReadOnlyList<Rule> All { get; } = new Rule[]
        {
            new UnityMembersRule(),
            new SourceNamesRule(),
            new NetStandardRule(),
            new HostSurfaceRule(),
        };
    }
}
