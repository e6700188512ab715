using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Host.Assets;

namespace Host.Scripts.Assemblies
{
    /// <summary>
    /// The symbols with which Unity 2022.3 compiles scripts of a Windows development player: what the host plays is a player (nothing of the
    /// editor's runs), and it keeps Direct3D 11's conventions, which is why Application.platform says Windows as well.
    /// </summary>
    internal static class Defines
    {
        /// <summary>Name of the platform in .asmdef files.</summary>
        public const string Platform = "WindowsStandalone64";
        public const string EditorPlatform = "Editor";
        public const string UnityVersion = "2022.3.0";

        static readonly string[] Always =
        {
            "UNITY_2022_3_0", "UNITY_2022_3", "UNITY_2022", "UNITY_64", "UNITY_STANDALONE", "UNITY_STANDALONE_WIN", "PLATFORM_STANDALONE",
                "PLATFORM_STANDALONE_WIN",
            "DEVELOPMENT_BUILD", "UNITY_ASSERTIONS", "ENABLE_PROFILER", "ENABLE_MONO", "NET_STANDARD_2_0", "NET_STANDARD",
                "NET_STANDARD_2_1", "NETSTANDARD", "NETSTANDARD2_1", "CSHARP_7_OR_LATER", "CSHARP_7_3_OR_NEWER", "TRACE",
        };

        static readonly Dictionary<int, int> LastMinor = new Dictionary<int,
            int> { [2017] = 4, [2018] = 4, [2019] = 4, [2020] = 3, [2021] = 3, [2022] = 3 };

        // Tests run in the Editor on Windows, which sets IncludeTests for all assemblies.
        public const string IncludeTests = "UNITY_INCLUDE_TESTS";
        const string DevelopmentBuild = "DEVELOPMENT_BUILD";
        static readonly string[] Editor = { "UNITY_EDITOR", "UNITY_EDITOR_64", "UNITY_EDITOR_WIN" };

        public static List<string> Of(string project, bool editor = false)
        {
            var all = editor ? Always.Where(d => d != DevelopmentBuild).Concat(Editor).ToList() : new List<string>(Always);
            for (var minor = 3; minor <= 6; minor++) all.Add($"UNITY_5_{minor}_OR_NEWER");
            foreach (var year in LastMinor)
                for (var minor = 1; minor <= year.Value; minor++) all.Add($"UNITY_{year.Key}_{minor}_OR_NEWER");

            var file = Path.Combine(project, "ProjectSettings", "ProjectSettings.asset");
            var settings = File.Exists(file) ? UnityYaml.Load(file, "ProjectSettings/ProjectSettings.asset").Documents[0].Fields : null;
            // 0 the old input manager, 1 the input system, 2 both.
            var input = settings?.Int("activeInputHandler") ?? 0;
            if (input != 1) all.Add("ENABLE_LEGACY_INPUT_MANAGER");
            if (input >= 1) all.Add("ENABLE_INPUT_SYSTEM");
            all.AddRange(Symbols(settings));
            return all.Distinct().ToList();
        }

        /// <summary>Old files number the platforms (1 is standalone), newer ones name them.</summary>
        static IEnumerable<string> Symbols(YamlMapping settings)
        {
            if (settings?["scriptingDefineSymbols"] is not YamlMapping symbols) return Enumerable.Empty<string>();
            var text = symbols.Text("Standalone", symbols.Text("1", ""));
            return text.Split(new[] { ';', ' ', ',' }, StringSplitOptions.RemoveEmptyEntries);
        }

        /// <summary>Each entry must hold: "NAME", "!NAME", or some of them with "||" between.</summary>
        public static bool Hold(IEnumerable<string> constraints, ICollection<string> defined) =>
            constraints.All(c => c.Split("||", StringSplitOptions.TrimEntries).Any(part => part.StartsWith("!", StringComparison.Ordinal)
            ? !defined.Contains(part.Substring(1).Trim()) : defined.Contains(part)));
    }
}
