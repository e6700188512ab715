using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;

namespace Host.Report
{
    /// <summary>Writes the page, its plots and, beside it, the tables that it rests on.</summary>
    static class ReportWriter
    {
        /// <exception cref="HostException">A section was not measured.</exception>
        public static void Write(IReadOnlyList<ReportSection> sections, ReportFolders folders)
        {
            var records = sections.Select(section => ReportRecord.Find(folders.Data, section)).ToList();
            string[] missing = sections.Where((_, i) => records[i] == null).Select(section => section.Name).ToArray();
            if (missing.Length > 0)
                throw new HostException($"{string.Join(", ", missing)}: not measured into {folders.Data}; \"rill report " +
                    $"{string.Join(" ", missing)}\" without --write-only does.");

            ReportPage head = Page(), body = Page();
            foreach (ReportSection section in sections.Where(section => !section.OpensPage))
                body.Section(section);
            Introduce(head, sections, records);
            foreach (ReportSection section in sections.Where(section => section.OpensPage))
                head.Section(section);
            foreach (ReportSection section in sections)
                section.WriteOverview(head);
            ListFailures(head, body.Failures);
            ListRuns(head, sections, records);
            File.WriteAllText(folders.Page, head.ToString() + body);
            CopyTables(head.Tables.Concat(body.Tables).Concat(sections.Select(ReportRecord.Name)), folders);

            ReportPage Page() => new(folders.Data, folders.Images, folders.ImageLink);
        }

        static void Introduce(ReportPage page, IReadOnlyList<ReportSection> sections, List<ReportRecord> records)
        {
            page.Line("# Report");
            page.Line();
            foreach (var group in records.Where(record => record.Quick || record.InSoftware).GroupBy(record => (record.Quick, record.InSoftware)))
            {
                string what = string.Join(", ", sections.Where((_, i) => (records[i].Quick, records[i].InSoftware) == group.Key)
                    .Select(section => section.Name));
                page.Line(
                    $"**{(group.Key.Quick ? "A quick run" : "A run")}{(group.Key.InSoftware ? " on a CPU" : "")}** ({what}): {(group.Key.Quick ? "small scenes, few settings; it shows that everything works, not what the solver can do. " : "")}{(group.Key.InSoftware ? "Its times say nothing about a GPU." : "")}".TrimEnd());
                page.Line();
            }
            page.Line("Written by `rill report`. It begins with the question, what settings cost and leave of error, and all that fails. "
                + "[What was measured on what](#what-was-measured-on-what) stands before the sections.");
        }

        static void ListRuns(ReportPage page, IReadOnlyList<ReportSection> sections, List<ReportRecord> records)
        {
            page.Line("## What was measured on what");
            page.Line();
            page.Table(new[] { "section", "command", "device", "date", "commit", "took" }, sections.Select((section, i) => new[]
            {
                section.Title, $"`rill report {section.Name}{(records[i].Quick ? " --quick" : "")}`", records[i].Device, records[i].Date,
                    records[i].Commit, records[i].Seconds.ToString("0 s", CultureInfo.InvariantCulture),
            }));
            page.Line("Every table lies beside the page as CSV; its first line says what it was measured on.");
        }

        static void ListFailures(ReportPage page, ReportFailures failures)
        {
            page.Line();
            page.Line("## What fails");
            page.Line();
            page.Line(failures.Rows.Count == 0 ? "Nothing: all figures of the sections below meet their bars."
                : "Everything that misses its bar in the tables of the sections below; the worst figure of each.");
            page.Line();
            if (failures.Rows.Count > 0)
                page.Table(ReportFailures.Columns, failures.Rows);
        }

        // With the records, so that the page can be written again from what lies beside it when one section is measured again.
        static void CopyTables(IEnumerable<string> tables, ReportFolders folders)
        {
            if (Path.GetFullPath(folders.Data) == Path.GetFullPath(folders.LinkedData))
                return;
            Directory.CreateDirectory(folders.LinkedData);
            foreach (string table in tables)
                File.Copy(Path.Combine(folders.Data, table + ".csv"), Path.Combine(folders.LinkedData, table + ".csv"), overwrite: true);
        }
    }
}
