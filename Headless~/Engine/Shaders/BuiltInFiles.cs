using System.IO;

namespace Host.Shaders
{
    /// <summary>Sources that come with the editor in Unity, and with this assembly here: include files and shaders.</summary>
    internal static class BuiltInFiles
    {
        static readonly string folder = Path.GetDirectoryName(typeof(BuiltInFiles).Assembly.Location);

        /// <summary>Folder of UnityCG.cginc and its kin.</summary>
        public static string Includes { get; } = Path.Combine(folder, "CGIncludes");
        /// <summary>Standard, Unlit/Color ... as .shader files.</summary>
        public static string Shaders { get; } = Path.Combine(folder, "BuiltInShaders");

        /// <summary>Returns an include file; null if it does not exist.</summary>
        public static string FindInclude(string path)
        {
            string file = Path.Combine(Includes, path);
            return path.IndexOf('/') < 0 && File.Exists(file) ? file : null;
        }
    }
}
