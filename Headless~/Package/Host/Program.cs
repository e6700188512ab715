using System;
using Host.Assets;
using Host.Baking;
using Host.Bench;
using Host.Commands;
using Host.Reference;
using Host.Report;
using Host.Studies;

namespace Host
{
    /// <summary>The command line <c>rill</c>: what the engine plays and tests, and what is about this package alone.</summary>
    static class Program
    {
        static int Main(string[] arguments)
        {
            BuiltInPackage.Current = new RillPackage();
            if (Environment.GetEnvironmentVariable("RILL_ROOT") is { Length: > 0 } root)
                ProjectFolders.AtHand = new[] { root };
            return CommandLine.Run("rill", "Runs scenes and tests of a Unity compute package without Unity.", arguments,
                RunCommand.Create(),
                TestCommand.Create(),
                ExplainCommand.Create(),
                ExportCommand.Create(),
                ReferenceCommand.Create(),
                BakeCommand.Create(),
                BenchCommand.Create(),
                StudyCommand.Create(),
                MeasureCommand.Create(),
                DampingCommand.Create(),
                ReportCommand.Create(),
                CheckCommand.Create(),
                GenerateCommand.Create(),
                ManualCommand.Create(),
                ReferencesCommand.Create());
        }
    }
}
