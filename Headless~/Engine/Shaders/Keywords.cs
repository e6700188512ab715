using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using UnityEngine.Headless;

namespace Host.Shaders
{
    /// <summary>The keyword lines of a source (multi_compile, shader_feature ...) and the variants that they make.</summary>
    sealed class Keywords
    {
        static readonly Regex LineName = new Regex(
            @"^(multi_compile|shader_feature|dynamic_branch)(_local)?(?:_(vertex|fragment|hull|domain|geometry|raytracing))?$");

        sealed class Line
        {
            public string[] Names;      // "" = none of them
            public ShaderStage? Stage;
            public bool Dynamic;
            /// <summary>Unity adds the line to every program, and turns its keywords on by itself.</summary>
            public bool Implicit;
        }

        const int MaxChoices = 4096;

        readonly List<Line> lines = new List<Line>();

        public const string Instancing = "INSTANCING_ON", ProceduralInstancing = "PROCEDURAL_INSTANCING_ON";
        public const string StereoInstancing = "STEREO_INSTANCING_ON", StereoMultiview = "STEREO_MULTIVIEW_ON";

        /// <param name="procedural">Whether "#pragma instancing_options procedural:" names a function.</param>
        /// <param name="stereo">Whether it is a graphics program, to which Unity adds the keywords of two eyes in one pass (manual,
        /// "Default shader keywords").</param>
        public Keywords(IEnumerable<PragmaLine> pragmas, bool procedural = false, bool stereo = false)
        {
            if (stereo)
                lines.Add(new Line { Names = new[] { "", StereoInstancing, StereoMultiview }, Implicit = true });
            foreach (PragmaLine pragma in pragmas)
            {
                string[] words = pragma.Text.Split(new[] { ' ', '\t' }, StringSplitOptions.RemoveEmptyEntries);
                Match match = LineName.Match(words[0]);
                if (words[0] == "multi_compile_instancing")
                    lines.Add(new Line { Names = procedural ? new[] { "", Instancing, ProceduralInstancing } : new[] { "", Instancing } });
                // In lines that name keywords of the render pipeline (multi_compile_fog ...) only the directional light and its shadow
                // are on here.
                if (words[0] == "multi_compile_fwdbase" || words[0] == "multi_compile_fwdbasealpha")
                {
                    lines.Add(new Line { Names = new[] { "DIRECTIONAL" } });
                    if (!pragmas.Any(p => p.Text.Split(new[] { ' ', '\t' }).Contains("SHADOWS_SCREEN")))
                        lines.Add(new Line { Names = new[] { "", "SHADOWS_SCREEN" } });
                }
                if (words[0] == "multi_compile_shadowcaster")
                    lines.Add(new Line { Names = new[] { "SHADOWS_DEPTH" } });
                if (!match.Success || words.Length < 2)
                    continue;
                string kind = match.Groups[1].Value, stage = match.Groups[3].Value;
                List<string> names = words.Skip(1).Select(w => w.Trim('_').Length == 0 ? "" : w).ToList();
                if (kind == "shader_feature" && names.Count == 1)
                    names.Insert(0, "");    // a feature alone is on or off
                lines.Add(new Line
                {
                    Names = names.ToArray(),
                    Dynamic = kind == "dynamic_branch",
                    Stage = stage == "vertex" ? ShaderStage.Vertex : stage == "fragment" ? ShaderStage.Fragment : (ShaderStage?)null,
                });
            }
        }

        public IReadOnlyList<string> All => lines.Where(l => !l.Implicit).SelectMany(l => l.Names).Where(n => n.Length > 0).Distinct().ToArray();

        /// <summary>Whether it is a line such as multi_compile_fog, whose keywords are Unity's and not known here.</summary>
        public static bool AreOfUnity(PragmaLine pragma)
        {
            string name = pragma.Text.Split(new[] { ' ', '\t' })[0];
            return (name.StartsWith("multi_compile_") || name.StartsWith("shader_feature_")) && !LineName.IsMatch(name);
        }

        /// <summary>The enabled keywords of every variant, none first.</summary>
        /// <exception cref="ShaderCompileException">There are too many to compile them one by one.</exception>
        public IReadOnlyList<string[]> Choices(string file)
        {
            var choices = new List<string[]> { Array.Empty<string>() };
            foreach (Line line in lines)
            {
                IEnumerable<string> names = line.Dynamic && !line.Names.Contains("") ? line.Names.Prepend("") : line.Names;
                choices = choices.SelectMany(choice => names, (choice, name) => name.Length == 0 ? choice : choice.Append(name).ToArray()).ToList();
                if (choices.Count > MaxChoices)
                    throw new ShaderCompileException(file, 1, $"its keywords make more than {MaxChoices} variants; no build would " +
                        $"want to compile them: use fewer, or dynamic_branch");
            }
            return choices;
        }

        /// <summary>One define a line: its first enabled keyword, or its first when none is.</summary>
        public List<KeyValuePair<string, string>> Select(ShaderStage stage, ICollection<string> enabled)
        {
            var defines = new List<KeyValuePair<string, string>>();
            foreach (Line line in lines)
            {
                if (line.Stage != null && line.Stage != stage)
                    continue;
                if (line.Dynamic)
                {
                    // A keyword of a dynamic branch is a value to test in the code; here it is a constant one.
                    foreach (string name in line.Names.Where(n => n.Length > 0))
                        defines.Add(KeyValuePair.Create(name, IsEnabled(enabled, name) ? "1" : "0"));
                    continue;
                }
                string chosen = line.Names.FirstOrDefault(n => n.Length > 0 && IsEnabled(enabled, n)) ?? line.Names[0];
                if (chosen.Length > 0)
                    defines.Add(KeyValuePair.Create(chosen, "1"));
            }
            return defines;
        }

        static bool IsEnabled(ICollection<string> enabled, string name) => enabled != null && enabled.Contains(name);
    }
}
