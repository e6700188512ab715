using System.Collections.Generic;

namespace Host.Check
{
    /// <summary>All rules, in the order of the table.</summary>
    static class RuleBook
    {
        public static IReadOnlyList<Rule> All { get; } = new Rule[]
        {
            new FxcRule(),
            new LayoutRule(),
            new TargetsRule(),
        };
    }
}
