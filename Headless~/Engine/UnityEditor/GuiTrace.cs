using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Headless;

namespace UnityEditor
{
    /// <summary>Records what the GUI of this host would have drawn, for tests of inspectors, and what a user would have done to it.</summary>
    internal static class GuiTrace
    {
        public static readonly List<(string path, string label, bool mixed)> Fields = new List<(string, string, bool)>();
        public static readonly List<(MessageType type, string text)> HelpBoxes = new List<(MessageType, string)>();

        /// <summary>Called with each field that is drawn; true says that it was edited.</summary>
        public static Func<SerializedProperty, bool> Edit;

        public static void Field(SerializedProperty property, string label)
        {
            Fields.Add((property.propertyPath, label, property.hasMultipleDifferentValues));
            if (Edit != null && Edit(property))
                GUI.changed = true;
        }

        public static void Help(MessageType type, string text) => HelpBoxes.Add((type, text));

        public static void Clear()
        {
            Fields.Clear();
            HelpBoxes.Clear();
            Edit = null;
            GuiDrawing.Clear();
        }
    }
}
