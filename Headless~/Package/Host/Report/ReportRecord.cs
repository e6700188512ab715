using System;
using System.IO;
using System.Linq;

namespace Host.Report
{
    /// <summary>Record of a section's measuring: device, amount, date and commit. It lies beside the section's tables.</summary>
    sealed record ReportRecord(string Device, bool Quick, bool InSoftware, string Date, double Seconds,
        string Commit)
    {
        /// <summary>Commit of tables from before it was recorded.</summary>
        public const string NotRecorded = "not recorded";
        const string CommitColumn = "commit";
        const string Scope = "of the whole section";

        /// <summary>Name of its table.</summary>
        public static string Name(ReportSection section) => "report-" + section.Name;

        public static void Save(ReportRun run, ReportSection section, double seconds)
        {
            var table = new ReportTable("quick", "date", "seconds", CommitColumn);
            table.Add(run.Quick, DateTime.UtcNow.ToString("yyyy-MM-dd"), Math.Round(seconds, 1), SourceCommit.Describe());
            run.Save(Name(section), table, Scope);
        }

        /// <summary>Null for a section that was never measured into this folder.</summary>
        public static ReportRecord Find(string dataFolder, ReportSection section)
        {
            string file = Path.Combine(dataFolder, Name(section) + ".csv");
            if (!File.Exists(file))
                return null;
            ReportTable table = ReportTable.Load(file);
            ReportTable.Row row = table.Rows.Single();
            return new ReportRecord(table.MeasuredOn.Replace("; " + Scope, ""), bool.Parse(row["quick"]), table.InSoftware, row["date"],
                row.Number("seconds"), table.Columns.Contains(CommitColumn) ? row[CommitColumn] : NotRecorded);
        }
    }
}
