using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace Host.Check
{
    /// <summary>Who looks up a message of the console in the manual finds it: the first words of each text that the package logs are on a
    /// page.</summary>
    sealed class LoggedMessagesRule : Rule
    {
        static readonly string[] Folders = { "Runtime/", "Editor/", "Testing/" };

        public override string Name => "documentation: each logged message is in the manual";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            List<LoggedMessage> messages = LoggedMessages.Of(package.Files.Where(IsCode).Select(file => (file, package.Read(file))));
            List<string> pages = package.Files.Where(file => file.StartsWith("Documentation~/", StringComparison.Ordinal)
                && file.EndsWith(".md", StringComparison.Ordinal)).Select(page => LoggedMessages.Normalize(package.Read(page))).ToList();
            foreach (LoggedMessage message in messages)
                if (!pages.Any(page => page.Contains(" " + message.Stem + " ", StringComparison.Ordinal)))
                    findings.Fault($"{message.File}({message.Line}) logs \"{message.Stem} ...\", and no page of Documentation~ has these words: " +
                        $"add a row to Documentation~/troubleshooting.md with its meaning and remedy");
            if (messages.Count == 0)
                findings.Fault($"no message is logged in {string.Join(", ", Folders)}: this rule no longer finds them");
            findings.Looked = $"{messages.Count} messages on {pages.Count} pages";
            return findings;
        }

        static bool IsCode(string file) => Path.GetExtension(file) == ".cs"
            && Folders.Any(folder => file.StartsWith(folder, StringComparison.Ordinal));
    }
}
