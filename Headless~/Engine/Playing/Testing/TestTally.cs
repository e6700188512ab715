using System.Collections.Generic;
using System.IO;

namespace Host.Testing
{
    /// <summary>Sums and shows what fixtures report, from this process or from several.</summary>
    sealed class TestTally
    {
        readonly TextWriter output;
        readonly TestDurations durations;
        readonly HashSet<string> methods = new(), dispatchingMethods = new();
        string shownAssembly;

        public TestTally(TextWriter output, TestDurations durations)
        {
            this.output = output;
            this.durations = durations;
        }

        public int Passed { get; private set; }
        public int Failed { get; private set; }
        public int Skipped { get; private set; }

        /// <summary>Test methods that ran, and those of them that dispatched compute work to the device.</summary>
        public int Methods => methods.Count;
        public int DispatchingMethods => dispatchingMethods.Count;

        public void Add(FixtureReport report)
        {
            Passed += report.Passed;
            Failed += report.Failed;
            Skipped += report.Skipped;
            methods.UnionWith(report.Methods);
            dispatchingMethods.UnionWith(report.DispatchingMethods);
            if (report.IsWhole && report.Failed == 0)
                durations.Note(report.Fixture, report.Seconds);
            // Fixtures of several assemblies may end in turns.
            if (report.Assembly != shownAssembly)
                output.WriteLine(shownAssembly = report.Assembly);
            output.Write(report.Text);
            output.Flush();
        }
    }
}
