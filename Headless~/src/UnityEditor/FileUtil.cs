using System;
using System.Collections.Generic;
using System.IO;
using UnityEngine.Headless;

namespace UnityEditor
{
    public class FileUtil
    {
        static readonly List<string> temporary = new List<string>();

        static FileUtil() => AppDomain.CurrentDomain.ProcessExit += (sender, exit) => Clean();

        /// <summary>In the project's Temp folder, which the Editor empties as it closes: what was written at these paths goes with the process.</summary>
        public static string GetUniqueTempPathInProject()
        {
            string folder = Path.Combine(Player.ProjectPath, "Temp");
            Directory.CreateDirectory(folder);
            string path = Path.Combine(folder, "UnityTempFile-" + Guid.NewGuid().ToString("N"));
            temporary.Add(path);
            return path;
        }

        static void Clean()
        {
            foreach (string path in temporary)
                File.Delete(path);
        }
    }
}
