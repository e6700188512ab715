namespace UnityEngine.Headless
{
    /// <summary>Missing members of the host that scripts called; the host reads it after a run.</summary>
    internal sealed class StubCalls
    {
        internal static readonly System.Collections.Generic.SortedDictionary<string,
            int> Called = new System.Collections.Generic.SortedDictionary<string, int>(System.StringComparer.Ordinal);

        /// <summary>For what cannot be left undone.</summary>
        internal static System.Exception Missing(string member)
        {
            Count(member);
            return new System.NotSupportedException(member + " is not part of the headless host");
        }

        internal static void Count(string member)
        {
            lock (Called)
            {
                Called.TryGetValue(member, out int times);
                Called[member] = times + 1;
            }
        }
    }
}
