using System.CommandLine;
using Host.Check;

namespace Host.Commands
{
    /// <summary><c>manual</c>: writes the manual's HTML, and nothing else that <c>generate</c> writes.</summary>
    static class ManualCommand
    {
        public static Command Create()
        {
            var command = new Command("manual",
                "Writes the manual's HTML from its pages and the code's documentation, in seconds; rill generate does too.");
            command.SetAction(_ => GenerateCommand.Write(GeneratedFiles.OfManual));
            return command;
        }
    }
}
