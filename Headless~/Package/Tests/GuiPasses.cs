using System;
using System.Linq;
using UnityEditor;
using UnityEngine;
using UnityEngine.Headless;

namespace Host.Tests
{
    /// <summary>
    /// Draws a GUI as the editor does: once to lay it out, once to show it or to act on it. Unity throws where the second draws
    /// more rows than the first, and shifts them where it draws fewer.
    /// </summary>
    static class GuiPasses
    {
        /// <returns>What differs between the two; null where nothing does, or where a user acted, which may change all below.</returns>
        public static string Draw(Action gui)
        {
            (Func<SerializedProperty, bool> edit, Func<string, bool> press) = (GuiTrace.Edit, GuiDrawing.Press);
            bool acts = edit != null || press != null;
            try
            {
                (GuiTrace.Edit, GuiDrawing.Press) = (null, null);
                string[] laidOut = Pass(gui, EventType.Layout);
                (GuiTrace.Edit, GuiDrawing.Press) = (edit, press);
                string[] shown = Pass(gui, acts ? EventType.MouseUp : EventType.Repaint);
                return acts || shown.SequenceEqual(laidOut) ? null : $"laid out: {string.Join(", ", laidOut.Except(shown))}; shown: " +
                    $"{string.Join(", ", shown.Except(laidOut))}; {laidOut.Length} and {shown.Length} rows";
            }
            finally
            {
                (GuiTrace.Edit, GuiDrawing.Press) = (edit, press);
                Event.current = null;
            }
        }

        static string[] Pass(Action gui, EventType type)
        {
            GuiTrace.Fields.Clear();
            GuiTrace.HelpBoxes.Clear();
            GuiDrawing.Labels.Clear();
            GuiDrawing.Buttons.Clear();
            Event.current = new Event { type = type };
            gui();
            // Texts may change, rows may not.
            return GuiTrace.Fields.Select(field => "field " + field.path).Concat(GuiTrace.HelpBoxes.Select((box, i) => $"help box {i}"))
                .Concat(GuiDrawing.Labels.Select((label, i) => $"label {i}"))
                    .Concat(GuiDrawing.Buttons.Select((button, i) => $"button {i}")).ToArray();
        }
    }
}
