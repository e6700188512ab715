using System;

namespace Host.Assets
{
    /// <summary>A file or folder that Unity would import.</summary>
    internal sealed class AssetEntry
    {
        /// <summary>"Assets/Scenes/Main.unity" or "Packages/com.x.y/Runtime/A.cs".</summary>
        public string Path;
        public string File;
        public bool IsFolder;
        /// <summary>Null when the .meta file is missing or unusable.</summary>
        public string Guid;
        public string Importer = "";
        public int ExecutionOrder;

        public string Name => System.IO.Path.GetFileNameWithoutExtension(Path);
        public string Extension => System.IO.Path.GetExtension(Path).ToLowerInvariant();

        /// <summary>The name by which Resources.Load finds it; null outside of Resources folders.</summary>
        public string ResourcePath
        {
            get
            {
                const string folder = "/Resources/";
                var at = Path.LastIndexOf(folder, StringComparison.OrdinalIgnoreCase);
                if (at < 0 || IsFolder) return null;
                var below = Path.Substring(at + folder.Length);
                return below.Substring(0, below.Length - System.IO.Path.GetExtension(below).Length);
            }
        }

        public override string ToString() => Path;
    }
}
