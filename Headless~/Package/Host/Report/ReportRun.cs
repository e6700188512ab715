using System.Diagnostics;
using System.IO;

namespace Host.Report
{
    /// <summary>Context in which a section measures: its amount, its device, and where its tables go.</summary>
    sealed class ReportRun
    {
        readonly string dataFolder;
        readonly TextWriter log;
        readonly Stopwatch clock = Stopwatch.StartNew();

        /// <param name="quick">Small scenes for a CPU: that everything works, not how fast.</param>
        public ReportRun(string dataFolder, bool quick, string device, TextWriter log)
        {
            this.dataFolder = dataFolder;
            Quick = quick;
            Device = device;
            this.log = log;
        }

        public bool Quick { get; }
        public string Device { get; }

        public void Log(string line) => log.WriteLine($"{clock.Elapsed.TotalSeconds,7:0.0} s  {line}");

        /// <param name="settings">What holds for all rows.</param>
        public void Save(string name, ReportTable table, string settings)
        {
            table.MeasuredOn = $"{Device}; {settings}";
            table.Save(Path.Combine(dataFolder, name + ".csv"));
        }
    }
}
