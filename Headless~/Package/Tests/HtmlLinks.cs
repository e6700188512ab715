using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;

namespace Host.Tests
{
    /// <summary>Links and pictures of HTML pages that lead nowhere.</summary>
    static class HtmlLinks
    {
        /// <param name="files">Pages and what else lies beside them, by path with '/'.</param>
        /// <param name="folder">Folder that they are to lie in; what they have not is looked for from there.</param>
        /// <param name="links">Number of links.</param>
        public static List<string> Dead(IReadOnlyDictionary<string, string> files, string folder, out int links)
        {
            Dictionary<string, HashSet<string>> anchors = files.ToDictionary(file => file.Key,
                file => new HashSet<string>(Regex.Matches(file.Value, @"\sid=""([^""]+)""").Select(match => match.Groups[1].Value)));
            var dead = new List<string>();
            links = 0;
            foreach (KeyValuePair<string, string> page in files.Where(file => file.Key.EndsWith(".html", StringComparison.Ordinal)))
                foreach (Match match in Regex.Matches(page.Value, @"\s(?:href|src)=""([^""]*)""|url=([^""]+)"""))
                {
                    string target = match.Groups[1].Success ? match.Groups[1].Value : match.Groups[2].Value;
                    links++;
                    if (!Regex.IsMatch(target, "^(https?|mailto):") && IsDead(page.Key, target, anchors, folder))
                        dead.Add(page.Key + ": " + target);
                }
            return dead;
        }

        static bool IsDead(string page, string target, Dictionary<string, HashSet<string>> anchors, string folder)
        {
            string[] parts = target.Split(new[] { '#' }, 2);
            string path = parts[0].Length == 0 ? page
                : Path.GetRelativePath(folder, Path.Combine(folder, Path.GetDirectoryName(page), Uri.UnescapeDataString(parts[0])))
                    .Replace('\\', '/');
            if (anchors.TryGetValue(path, out HashSet<string> there))
                return parts.Length == 2 && !there.Contains(parts[1]);
            string file = Path.Combine(folder, path);
            return path.Split('/')[0] != ".." || !File.Exists(file) && !Directory.Exists(file);
        }
    }
}
