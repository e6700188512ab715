using System;
using System.Collections.Generic;
using System.Linq;

namespace Host.Report.Extremes
{
    /// <summary>Stiff and extreme cases, each against its bar, with the correction for deep water and without.</summary>
    sealed class ExtremesSection : ReportSection
    {
        readonly Func<bool, IEnumerable<ExtremeCase>> cases;
        readonly bool besideOthers;

        /// <param name="cases">By whether they shall be small.</param>
        /// <param name="besideOthers">Whether other solvers' counts stand beside them.</param>
        public ExtremesSection(string name, string title, Func<bool, IEnumerable<ExtremeCase>> cases, bool besideOthers)
        {
            Name = name;
            Title = title;
            this.cases = cases;
            this.besideOthers = besideOthers;
        }

        /// <summary>Name on the command line and in the table.</summary>
        public override string Name { get; }
        public override string Title { get; }
        public override bool OnlyByName => true;

        public override void Measure(ReportRun run)
        {
            var table = new ReportTable("subject", "case", "setting", "bar", "seen", "broken", "added", "alive", "refused", "not_finite",
                "outside", "coincident", "overflow", "speed_max");
            bool quick = run.Quick;
            foreach (ExtremeCase extreme in cases(quick))
                foreach (ExtremeSetting setting in extreme.OfComponent ? new[] { ExtremeSetting.Default(quick) }
                    : new[] { ExtremeSetting.DeepWaterOn(quick), ExtremeSetting.Plain(quick) })
                {
                    var check = new ExtremeCheck();
                    ExtremeCounts counts = extreme.Run(setting, check);
                    string broken = string.Join("; ", counts.Broken().Append(check.Broken).Where(text => text.Length > 0));
                    table.Add(extreme.Subject, extreme.Name, setting.Name, check.Bar, check.Seen, broken, counts.Added, counts.Alive,
                        counts.Refused, counts.NonFinite, counts.Escaped, counts.Coincident, counts.Overflow, counts.SpeedMax);
                    run.Log($"{extreme.Name} | {setting.Name} | {(broken.Length == 0 ? "holds" : "FAILS: " + broken)} | {check.Seen}");
                }
            run.Save(Name, table,
                $"60 steps a second and 1 substep x 4 iterations and relaxation 0.8 unless given; {(quick ? "small scenes" : "full size")}");
        }

        public override void Write(ReportPage page)
        {
            ReportTable table = page.Load(Name);
            List<ReportTable.Row> rows = table.Rows.ToList();
            int failed = rows.Count(row => row["broken"].Length > 0);
            page.Line($"`rill report {Name}`, {table.MeasuredOn}. {rows.Count} runs, of which {rows.Count - failed} hold and {failed} " +
                $"fail. Every run also has to keep each");
            page.Line("particle inside, with a finite speed, and alive, refused or culled, so that none is missing from the sum. *On* " +
                "and *off* are the setting Deep");
            page.Line("Water (automatic is on above four layers of water); *default* goes through the component with its own settings. " +
                "The bar on speed where");
            page.Line("particles are crowded is what two steps can add: half a spacing a pass, and two spacings by the grid's density correction.");
            page.Line();
            if (besideOthers)
                WriteCounts(page, rows);
            foreach (IGrouping<string, ReportTable.Row> subject in rows.GroupBy(row => row["subject"]))
            {
                page.Heading(subject.Key);
                page.Table(new[] { "case", "setting", "bar", "seen", "" },
                    subject.Select(row => new[] { row["case"], row["setting"], row["bar"], row["seen"], Verdict.Of(row["broken"]) }));
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
            List<ReportTable.Row> plain = rows.Where(row => row["setting"] == ExtremeSetting.PlainName).ToList(), usual = rows.Except(plain).ToList();
            page.Table(new[] { "", "worst seen of other solvers in such scenes",
                $"here, {usual.Count} runs with the correction or the component's defaults",
                $"here, {plain.Count} runs of plain iterations" }, new[]
            {
                Counts("not a number", "the first at frame 1009, then all",
                    of => $"{of.Count(row => !double.IsFinite(row.Number("speed_max")))} runs; {Sum(of, "not_finite"):0} particles " +
                    $"that were given as such culled and counted"),
                Counts("particles outside", "258,533", of => $"{Sum(of, "outside"):0}"),
                Counts("coincident particles at the end", "601 pairs",
                    of => $"{Sum(of, "coincident"):0} closer than 0.05 d to another, {Where(of, "coincident")}"),
                Counts("beyond a cell's or list's capacity", "lost in silence",
                    of => $"{Sum(of, "added") - Sum(of, "alive") - Sum(of, "refused") - Sum(of, "not_finite"):0} lost; at most " +
                    $"{of.Max(row => row.Number("overflow")):0} particles with full lists, reported"),
            });

            static double Sum(List<ReportTable.Row> of, string column) => of.Sum(row => row.Number(column));
            string[] Counts(string what, string others, Func<List<ReportTable.Row>, string> ours) => new[] { what, others, ours(usual), ours(plain) };
        }
    }
}
