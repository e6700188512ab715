using System;
using System.IO;

namespace UnityEditor
{
    public class FileUtil
    {
        static string temp;

        /// <summary>
        /// In a folder Temp, which goes with the process as the project's goes with the Editor. It is the machine's: where a package
        /// plays the project, one in its root would be imported with it.
        /// </summary>
        public static string GetUniqueTempPathInProject()
        {
            temp ??= MakeTemp();
            return Path.Combine(temp, "UnityTempFile-" + Guid.NewGuid().ToString("N"));
        }

        static string MakeTemp()
        {
            string root = Path.Combine(Path.GetTempPath(), "rill-project-" + Guid.NewGuid().ToString("N"));
            AppDomain.CurrentDomain.ProcessExit += (sender, exit) => Directory.Delete(root, recursive: true);
            return Directory.CreateDirectory(Path.Combine(root, "Temp")).FullName;
        }
    }
}
