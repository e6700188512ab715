using System.Collections.Generic;
using System.Linq;

namespace Host.Scripts.Stubs
{
    /// <summary>
    /// Which lines of the lists are no C# by themselves, remembered so that a first use need not find out again. Sources/fixes.txt
    /// is a copy of the fixes.txt that lies beside a compiled UnityEngine.Stubs.dll in the cache.
    /// </summary>
    internal static class Fixes
    {
        public static IEnumerable<string> Of(StubSources sources)
        {
            foreach (var type in sources.Types.SelectMany(t => t.WithNested()).OrderBy(t => t.FullName, System.StringComparer.Ordinal))
            {
                if (type.Dropped) yield return $"{type.FullName}\tleave out";
                if (type.ForcedAbstract) yield return $"{type.FullName}\tabstract";
                foreach (var parent in type.BasesLeftOut) yield return $"{type.FullName}\twithout\t{parent}";
                foreach (var member in type.Members.Where(m => m.Dropped || m.ValueTypesOnly))
                    yield return $"{type.FullName}\t{(member.Dropped ? "leave out" : "values")}\t{member.Signature}";
            }
        }

        public static void Apply(StubSources sources, IEnumerable<string> fixes)
        {
            var types = sources.Types.SelectMany(t => t.WithNested()).ToLookup(t => t.FullName);
            foreach (var fix in fixes.Select(m => m.TrimEnd('\r').Split('\t')).Where(m => m.Length > 1))
                foreach (var type in types[fix[0]])
                {
                    if (fix.Length == 2 && fix[1] == "leave out") type.Dropped = true;
                    else if (fix[1] == "abstract") type.ForcedAbstract = true;
                    else if (fix[1] == "without") type.Without(fix[2]);
                    else
                        foreach (var member in type.Members.Where(m => m.Signature == fix[2]))
                            if (fix[1] == "values") member.ValueTypesOnly = true;
                            else member.Dropped = true;
                }
        }
    }
}
