using System.IO;
using System.Text.RegularExpressions;

namespace Host.Assets
{
    /// <summary>The name by which Shader.Find knows a .shader file, read without compiling it.</summary>
    internal static class ShaderNames
    {
        static readonly Regex Comment = new Regex(@"//[^\n]*|/\*.*?\*/", RegexOptions.Singleline | RegexOptions.Compiled);
        static readonly Regex Name = new Regex("\\bShader\\s*\"([^\"]+)\"", RegexOptions.Compiled);

        /// <summary>Null when the file names none.</summary>
        public static string Of(string file)
        {
            var match = Name.Match(Comment.Replace(File.ReadAllText(file), " "));
            return match.Success ? match.Groups[1].Value : null;
        }
    }
}
