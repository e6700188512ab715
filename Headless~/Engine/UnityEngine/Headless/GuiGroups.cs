using System;
using System.Collections.Generic;

namespace UnityEngine.Headless
{
    /// <summary>Groups of immediate-mode GUI that are open. Unity draws nonsense or logs where they do not match; here it throws.</summary>
    internal static class GuiGroups
    {
        const string FoldoutHeader = "FoldoutHeaderGroup";

        static readonly Stack<string> open = new Stack<string>();

        /// <summary>Inspectors and handles that left one open have a fault.</summary>
        public static int Open => open.Count;

        public static void Begin(string kind)
        {
            if (kind == FoldoutHeader && open.Contains(FoldoutHeader))
                throw new InvalidOperationException("You can't nest Foldout Headers, end it with EndFoldoutHeaderGroup.");
            open.Push(kind);
        }

        public static void End(string kind)
        {
            if (open.Count == 0)
                throw new InvalidOperationException($"End{kind} without Begin{kind}.");
            string begun = open.Pop();
            if (begun != kind)
                throw new InvalidOperationException($"End{kind} where Begin{begun} is open.");
        }

        public static void Clear() => open.Clear();
    }
}
