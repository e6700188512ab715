using System.Collections.Generic;
using System.Linq;
using Host.Report.Extremes;

namespace Host.Report
{
    /// <summary>Stiff and extreme cases, each against its bar, with the correction for deep water and without.</summary>
    sealed class ExtremesSection : ReportSection
    {
        const string Table = "extremes";

        public override string Name => "extremes";
        public override string Title => "Stiff and extreme cases";
        public override bool OnlyByName => true;

        public override void Measure(ReportRun run)
        {
            var table = new ReportTable("subject", "case", "setting", "bar", "seen", "broken", "added", "alive", "refused", "not_finite", "outside", "coincident", "overflow", "speed_max");
            bool quick = run.Quick;
            foreach (ExtremeCase extreme in ExtremeCases.All(quick))
                foreach (ExtremeSetting setting in extreme.OfComponent ? new[] { ExtremeSetting.Default(quick) } : new[] { ExtremeSetting.DeepWaterOn(quick), ExtremeSetting.Plain(quick) })
                {
                    var check = new ExtremeCheck();
                    ExtremeCounts counts = extreme.Run(setting, check);
                    string broken = string.Join("; ", counts.Broken().Append(check.Broken).Where(text => text.Length > 0));
                    table.Add(extreme.Subject, extreme.Name, setting.Name, check.Bar, check.Seen, broken, counts.Added, counts.Alive, counts.Refused, counts.NonFinite, counts.Escaped, counts.Coincident, counts.Overflow, counts.SpeedMax);
                    run.Log($"{extreme.Name} | {setting.Name} | {(broken.Length == 0 ? "holds" : "FAILS: " + broken)} | {check.Seen}");
                }
            run.Save(Table, table, $"60 steps a second and 1 substep x 4 iterations and relaxation 0.8 unless given; {(quick ? "small scenes" : "full size")}");
        }

        public override void Write(ReportPage page)
        {
            ReportTable table = page.Load(Table);
            List<ReportTable.Row> rows = table.Rows.ToList();
            int failed = rows.Count(row => row["broken"].Length > 0);
            page.Line($"`rill report extremes`, {table.MeasuredOn}. {rows.Count} runs, of which {rows.Count - failed} hold and {failed} fail. Every run also has to keep each");
            page.Line("particle inside, with a finite speed, and alive, refused or culled, so that nobody is missing from the sum. *On* and *off* are the setting Deep");
            page.Line("Water (automatic is on above four layers of water); *default* goes through the component with its own settings. The bar on speed where");
            page.Line("particles are crowded is what two steps can add: half a spacing a pass, and two spacings by the grid's density correction.");
            page.Line();
            WriteCounts(page, rows);
            foreach (IGrouping<string, ReportTable.Row> subject in rows.GroupBy(row => row["subject"]))
            {
                page.Line("### " + subject.Key);
                page.Line();
                page.Table(new[] { "case", "setting", "bar", "seen", "" }, subject.Select(row => new[] { row["case"], row["setting"], row["bar"], row["seen"], row["broken"].Length == 0 ? "holds" : $"**FAILS**: {row["broken"]}" }));
            }
        }

        static string Where(List<ReportTable.Row> rows, string column)
        {
            string[] cases = rows.Where(row => row.Number(column) > 0).Select(row => $"{row["case"]} ({row["setting"]})").ToArray();
            return cases.Length == 0 ? "in none" : $"in {string.Join(" and in ", cases)}";
        }

        // Figures of the others are this project's own measurements of them.
        static void WriteCounts(ReportPage page, List<ReportTable.Row> rows)
        {
            double Sum(string column) => rows.Sum(row => row.Number(column));
            double missing = Sum("added") - Sum("alive") - Sum("refused") - Sum("not_finite");
            page.Table(new[] { "", "worst seen of other solvers in such scenes", "here, over all runs" }, new[]
            {
                new[] { "not a number", "the first at frame 1009, then all", $"{rows.Count(row => !double.IsFinite(row.Number("speed_max")))} runs; {Sum("not_finite"):0} particles that were given as such culled and counted" },
                new[] { "particles outside", "258,533", $"{Sum("outside"):0}" },
                new[] { "coincident particles at the end", "601 pairs", $"particles closer than 0.05 d to another: {string.Join(", ", rows.GroupBy(row => row["setting"]).Select(setting => $"{setting.Sum(row => row.Number("coincident")):0} with {setting.Key}"))}; {Where(rows, "coincident")}" },
                new[] { "beyond a cell's or list's capacity", "lost in silence", $"{missing:0} lost; at most {rows.Max(row => row.Number("overflow")):0} particles with full lists, reported" },
            });
        }
    }
}
