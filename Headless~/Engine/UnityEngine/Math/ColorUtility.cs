using System.Collections.Generic;
using System.Globalization;

namespace UnityEngine
{
    public class ColorUtility
    {
        // The names that Unity's documentation lists.
        static readonly Dictionary<string, uint> names = new Dictionary<string, uint>
        {
            ["red"] = 0xff0000ff, ["cyan"] = 0x00ffffff, ["blue"] = 0x0000ffff, ["darkblue"] = 0x0000a0ff, ["lightblue"] = 0xadd8e6ff,
                ["purple"] = 0x800080ff,
            ["yellow"] = 0xffff00ff, ["lime"] = 0x00ff00ff, ["fuchsia"] = 0xff00ffff, ["white"] = 0xffffffff, ["silver"] = 0xc0c0c0ff,
                ["grey"] = 0x808080ff,
            ["black"] = 0x000000ff, ["orange"] = 0xffa500ff, ["brown"] = 0xa52a2aff, ["maroon"] = 0x800000ff, ["green"] = 0x008000ff,
                ["olive"] = 0x808000ff,
            ["navy"] = 0x000080ff, ["teal"] = 0x008080ff, ["aqua"] = 0x00ffffff, ["magenta"] = 0xff00ffff,
        };

        public static string ToHtmlStringRGB(Color color) => ToHtmlStringRGBA(color).Substring(0, 6);

        public static string ToHtmlStringRGBA(Color color)
        {
            Color32 c = color;
            return $"{c.r:X2}{c.g:X2}{c.b:X2}{c.a:X2}";
        }

        /// <summary>#RGB, #RGBA, #RRGGBB, #RRGGBBAA or a name.</summary>
        public static bool TryParseHtmlString(string htmlString, out Color color)
        {
            color = Color.white;
            if (string.IsNullOrEmpty(htmlString) || !TryBits(htmlString.ToLowerInvariant(), out uint bits))
                return false;
            color = new Color32((byte)(bits >> 24), (byte)(bits >> 16), (byte)(bits >> 8), (byte)bits);
            return true;
        }

        static bool TryBits(string text, out uint bits)
        {
            if (text[0] != '#')
                return names.TryGetValue(text, out bits);
            string digits = text.Substring(1);
            if (digits.Length == 3 || digits.Length == 4)
            {
                var doubled = new System.Text.StringBuilder();
                foreach (char c in digits)
                    doubled.Append(c).Append(c);
                digits = doubled.ToString();
            }
            if (digits.Length == 6)
                digits += "ff";
            bits = 0;
            return digits.Length == 8 && uint.TryParse(digits, NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out bits);
        }
    }
}
