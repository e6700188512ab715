using System;
using System.Collections.Generic;
using System.CommandLine;
using System.IO;
using Host.Check;

namespace Host.Commands
{
    /// <summary><c>generate</c>: writes the files of the package that are derived from others.</summary>
    static class GenerateCommand
    {
        public static Command Create()
        {
            var command = new Command("generate", "Writes the files of the package that are derived from its other files; rill check compares them.");
            command.SetAction(_ => Write(GeneratedFiles.All));
            return command;
        }

        /// <summary>Returns the exit code.</summary>
        public static int Write(IEnumerable<GeneratedFiles> all)
        {
            string root = Session.Root();
            int faults = 0, upToDate = 0;
            foreach (GeneratedFiles generated in all)
            {
                var package = new PackageTree(root);
                var findings = new Findings();
                IReadOnlyDictionary<string, string> texts = generated.Texts(package, findings);
                foreach (string fault in findings.Faults)
                    Console.Error.WriteLine(fault);
                faults += findings.Faults.Count;
                if (texts == null)
                    continue;
                foreach ((string path, string text) in texts)
                {
                    if (Write(Path.Combine(root, path), text))
                        Console.Out.WriteLine($"{path}: written");
                    else
                        upToDate++;
                }
                foreach (string path in generated.Leftover(package, texts))
                {
                    File.Delete(Path.Combine(root, path));
                    Console.Out.WriteLine($"{path}: deleted, nothing generates it any more");
                }
            }
            Console.Out.WriteLine($"{upToDate} files were up to date");
            return faults == 0 ? 0 : 1;
        }

        // Whether it differed.
        static bool Write(string path, string text)
        {
            if (File.Exists(path) && File.ReadAllText(path) == text)
                return false;
            Directory.CreateDirectory(Path.GetDirectoryName(path));
            File.WriteAllText(path, text);
            return true;
        }
    }
}
