using System.Collections.Generic;

namespace UnityEditor
{
    /// <summary>What the GUI of this host would have drawn, for tests of inspectors.</summary>
    internal static class GuiTrace
    {
        public static readonly List<(string path, string label, bool mixed)> Fields = new List<(string, string, bool)>();
        public static readonly List<(MessageType type, string text)> HelpBoxes = new List<(MessageType, string)>();

        public static void Field(string path, string label, bool mixed) => Fields.Add((path, label, mixed));
        public static void Help(MessageType type, string text) => HelpBoxes.Add((type, text));

        public static void Clear()
        {
            Fields.Clear();
            HelpBoxes.Clear();
        }
    }
}
