using System;
using System.Collections.Generic;
using System.Linq;

namespace Host.Pipelines
{
    /// <summary>A version of the scriptable pipelines, which fraction their numbers, with the editor that ships it and the symbols that
    /// this editor sets.</summary>
    sealed class PipelineVersion
    {
        /// <summary>"14", as the command line has it.</summary>
        public string Name { get; private init; }
        /// <summary>The editor: "2022.3".</summary>
        public string Unity { get; private init; }
        /// <summary>The editor whose API lists count: there are none of 6000.4.</summary>
        public string ListedAs { get; private init; }
        /// <summary>Version of URP's package; HDRP's differs in its last number at most.</summary>
        public string Package { get; private init; }
        /// <summary>Whether passes that are executed, not recorded, can be compiled.</summary>
        public bool HasCompatibilityPath { get; private init; }
        /// <summary>Whether the project has URP_COMPATIBILITY_MODE among its scripting defines.</summary>
        public bool AsksForCompatibility { get; private init; }

        public bool HasRenderGraph => Unity != "2022.3";

        // Newest editor of each row that a package with minimum 2022.3 meets.
        static readonly string[] Editors = { "2022.3", "6000.0", "6000.1", "6000.2", "6000.3", "6000.4" };

        public static IReadOnlyList<PipelineVersion> All { get; } = new[]
        {
            new PipelineVersion { Name = "14", Unity = "2022.3", ListedAs = "2022.3", Package = "14.0.10", HasCompatibilityPath = true },
            new PipelineVersion { Name = "17.0", Unity = "6000.0", ListedAs = "6000.0", Package = "17.0.3", HasCompatibilityPath = true },
            new PipelineVersion { Name = "17.3-compatibility", Unity = "6000.3", ListedAs = "6000.3", Package = "17.3.0",
                HasCompatibilityPath = true, AsksForCompatibility = true },
            new PipelineVersion { Name = "17.3", Unity = "6000.3", ListedAs = "6000.3", Package = "17.3.0" },
            new PipelineVersion { Name = "17.4", Unity = "6000.4", ListedAs = "6000.3", Package = "17.4.0", AsksForCompatibility = true },
        };

        /// <summary>"14" or "17": the newest of that number that is played; or a full name.</summary>
        /// <exception cref="ArgumentException">There is none of that name.</exception>
        public static PipelineVersion Find(string name) => All.FirstOrDefault(version => version.Name == (name == "17" ? "17.0" : name))
            ?? throw new ArgumentException(
                $"the host has no render pipeline {name}; it has {string.Join(", ", All.Select(version => version.Name))}");

        /// <summary>Symbols that the editor defines for scripts of a player or of the editor.</summary>
        public IEnumerable<string> Defines(bool editor)
        {
            yield return "UNITY_5_3_OR_NEWER";
            yield return "UNITY_2022_3_OR_NEWER";
            yield return "UNITY_STANDALONE";
            yield return "UNITY_" + Unity.Replace('.', '_');
            foreach (string older in Editors.Skip(1).Take(Array.IndexOf(Editors, Unity)))
                yield return $"UNITY_{older.Replace('.', '_')}_OR_NEWER";
            if (AsksForCompatibility)
                yield return "URP_COMPATIBILITY_MODE";
            if (editor)
                yield return "UNITY_EDITOR";
        }

        /// <summary>For the stand-ins' sources.</summary>
        internal IEnumerable<string> StandInDefines => !HasRenderGraph ? Array.Empty<string>() : ListedAs == "6000.3"
            ? new[] { "SRP_17", "SRP_17_3" } : new[] { "SRP_17" };

        public override string ToString() => $"Unity {Unity} with URP {Package}{(AsksForCompatibility ? " and URP_COMPATIBILITY_MODE" : "")}";
    }
}
