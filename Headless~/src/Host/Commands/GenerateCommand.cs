using System;
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
            command.SetAction(_ => Execute());
            return command;
        }

        static int Execute()
        {
            string root = Session.Root();
            int faults = 0;
            foreach (GeneratedFile file in GeneratedFile.All)
            {
                var findings = new Findings();
                string text = file.Text(new PackageTree(root), findings);
                foreach (string fault in findings.Faults)
                    Console.Error.WriteLine(fault);
                faults += findings.Faults.Count;
                if (text == null)
                    continue;
                string path = Path.Combine(root, file.Path);
                bool changes = !File.Exists(path) || File.ReadAllText(path) != text;
                if (changes)
                {
                    Directory.CreateDirectory(Path.GetDirectoryName(path));
                    File.WriteAllText(path, text);
                }
                Console.Out.WriteLine($"{file.Path}: {(changes ? "written" : "up to date")}");
            }
            return faults == 0 ? 0 : 1;
        }
    }
}
