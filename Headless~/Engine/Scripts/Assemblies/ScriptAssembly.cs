using System.Collections.Generic;
using Host.Assets;

namespace Host.Scripts.Assemblies
{
    /// <summary>Scripts that are compiled together.</summary>
    internal sealed class ScriptAssembly
    {
        public string Name;
        /// <summary>"Assets/Boids/Boids.asmdef", or null for Unity's predefined assemblies.</summary>
        public string Definition;
        public readonly List<AssetEntry> Files = new List<AssetEntry>();
        public readonly List<ScriptAssembly> References = new List<ScriptAssembly>();
        /// <summary>Assemblies of the host that stand in for packages.</summary>
        public readonly List<string> Hosted = new List<string>();
        public readonly List<AssetEntry> Plugins = new List<AssetEntry>();
        public readonly List<string> Defines = new List<string>();
        public bool AllowUnsafe, NoEngineReferences;
        /// <summary>Set for the tests that the project runs; for the editor alone.</summary>
        public bool HoldsTests, IsEditorOnly;

        public override string ToString() => Name;
    }
}
