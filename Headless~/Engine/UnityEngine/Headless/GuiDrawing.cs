using System;
using System.Collections.Generic;

namespace UnityEngine.Headless
{
    /// <summary>Texts and buttons that would have been drawn, for tests of what is clipped, and which button a user would have pressed.</summary>
    internal static class GuiDrawing
    {
        /// <summary>Pixels.</summary>
        public const float LetterWidth = 7f;

        public static readonly List<(Rect area, string text, GUIStyle style)> Labels = new List<(Rect, string, GUIStyle)>();
        public static readonly List<string> Buttons = new List<string>();

        /// <summary>Asked at each button whether it is pressed.</summary>
        public static Func<string, bool> Press;

        public static void Label(Rect area, string text, GUIStyle style) => Labels.Add((area, text, style ?? GUIStyle.none));

        public static bool Button(string text)
        {
            Buttons.Add(text);
            bool isPressed = Press != null && Press(text);
            GUI.changed |= isPressed;
            return isPressed;
        }

        /// <summary>Lines that a text takes in a column, broken between words.</summary>
        public static int Lines(string text, float width)
        {
            int lines = 1;
            float at = 0f;
            foreach (string word in text.Split(' '))
            {
                float wide = LetterWidth * word.Length, gap = at > 0f ? LetterWidth : 0f;
                if (at > 0f && at + gap + wide > width)
                {
                    lines++;
                    at = wide;
                }
                else
                    at += gap + wide;
            }
            return lines;
        }

        /// <summary>The labels of which some is not to be seen.</summary>
        public static IEnumerable<string> Clipped()
        {
            foreach ((Rect area, string text, GUIStyle style) in Labels)
            {
                float widest = LetterWidth * text.Length, height = style.CalcHeight(new GUIContent(text), area.width);
                if (style.wordWrap)
                {
                    widest = 0f;
                    foreach (string word in text.Split(' '))
                        widest = Math.Max(widest, LetterWidth * word.Length);
                }
                if (widest > area.width || height > area.height)
                    yield return $"'{text}' takes {widest} x {height} pixels of {area.width} x {area.height}";
            }
        }

        public static void Clear()
        {
            Labels.Clear();
            Buttons.Clear();
            Press = null;
        }
    }
}
