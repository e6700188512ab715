using System;
using System.Collections.Generic;
using System.IO;
using System.Text;
using Host.Assets;

namespace Host.Scripts.Assemblies
{
    /// <summary>A csc.rsp, Unity's way to give the compiler options: at Assets/ for all predefined assemblies, beside an .asmdef for that
    /// one.</summary>
    internal sealed class ResponseFile
    {
        public readonly List<string> Defines = new List<string>(), References = new List<string>(), Unknown = new List<string>();
        public bool Unsafe, Nullable;
        public string Language;

        public static ResponseFile Read(AssetEntry entry)
        {
            var response = new ResponseFile();
            foreach (var line in File.ReadAllLines(entry.File))
                foreach (var option in Words(line)) response.Take(option);
            return response;
        }

        void Take(string option)
        {
            if (option[0] != '-' && option[0] != '/')
            {
                Unknown.Add(option);
                return;
            }
            var colon = option.IndexOf(':');
            var name = (colon < 0 ? option : option.Substring(0, colon)).Substring(1).ToLowerInvariant();
            var value = colon < 0 ? "" : option.Substring(colon + 1).Trim('"');
            switch (name)
            {
                case "define": case "d": Defines.AddRange(value.Split(new[] { ';', ',' }, StringSplitOptions.RemoveEmptyEntries)); break;
                case "reference": case "r": References.Add(value); break;
                case "unsafe": case "unsafe+": Unsafe = true; break;
                case "langversion": Language = value; break;
                case "nullable": case "nullable+": Nullable = value is "" or "enable"; break;
                // These change messages and debug data only.
                case "nowarn": case "warn": case "w": case "warnaserror": case "warnaserror+": case "debug": case "optimize": case "analyzer": case "ruleset": case "additionalfile": break;
                default: Unknown.Add(option); break;
            }
        }

        static IEnumerable<string> Words(string line)
        {
            if (line.TrimStart().StartsWith("#", StringComparison.Ordinal)) yield break;
            var word = new StringBuilder();
            var quoted = false;
            foreach (var c in line + " ")
                if (c == '"') { quoted = !quoted; word.Append(c); }
                else if (!char.IsWhiteSpace(c) || quoted) word.Append(c);
                else if (word.Length > 0)
                {
                    yield return word.ToString();
                    word.Clear();
                }
        }
    }
}
