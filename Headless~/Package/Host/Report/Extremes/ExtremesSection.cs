using System;
using System.Collections.Generic;
using System.Linq;

namespace Host.Report.Extremes
{
    /// <summary>Stiff and extreme cases, each against its bar, with the correction for deep water and without.</summary>
    sealed class ExtremesSection : ReportSection
    {
        readonly Func<bool, IEnumerable<ExtremeCase>> cases;

        /// <param name="cases">By whether they shall be small.</param>
        public ExtremesSection(string name, string title, Func<bool, IEnumerable<ExtremeCase>> cases)
        {
            Name = name;
            Title = title;
            this.cases = cases;
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
            page.Line($"{rows.Count} runs, of which {rows.Count - failed} hold and {failed} fail: {table.Settings}. In every run no particle " +
                "may be lost, outside the box or infinitely fast. Where particles are crowded the bar on speed is what two steps can add.");
            page.Line();
            WriteCounts(page, rows);
            page.Table(new[] { "subject", "runs", "hold", "fail" }, rows.GroupBy(row => row["subject"]).Select(subject => new[] { subject.Key,
                Count(subject, _ => true), Count(subject, row => row["broken"].Length == 0), Count(subject, row => row["broken"].Length > 0) }));
            if (failed == 0)
                return;
            page.Line("The runs that fail are listed with their figures and bars under [What fails](#what-fails), those that hold in " +
                "the table below.");
            page.Line();
            page.ListFailures(new[] { "case", "setting", "" }, rows.Where(row => row["broken"].Length > 0)
                .Select(row => new[] { row["case"], row["setting"], Verdict.Of(Failure(row["broken"], row["bar"], row["seen"])) }));

            static string Count(IEnumerable<ReportTable.Row> of, Func<ReportTable.Row, bool> which) => $"{of.Count(which)}";
        }

        /// <summary>Returns what broke, with what was seen and the bar: "jitter 0.7745 m/s (at most 0.05 m/s)". A fault without a figure is only
        /// named.</summary>
        public static string Failure(string broken, string bars, string seen) => string.Join("; ", broken.Split("; ").Select(name =>
        {
            string figure = Named(seen, name), bar = Named(bars, name);
            return figure == null || bar == null ? name : $"{figure} ({bar[name.Length..].Trim()})";
        }));

        static string Named(string list, string name)
            => list.Split("; ").FirstOrDefault(part => part.StartsWith(name + " ", StringComparison.Ordinal));

        static string Where(List<ReportTable.Row> rows, string column)
        {
            int cases = rows.Count(row => row.Number(column) > 0);
            return cases == 0 ? "in none" : $"in {cases} runs";
        }

        static void WriteCounts(ReportPage page, List<ReportTable.Row> rows)
        {
            List<ReportTable.Row> plain = rows.Where(row => row["setting"] == ExtremeSetting.PlainName).ToList(), usual = rows.Except(plain).ToList();
            page.Table(new[] { "", $"{usual.Count} runs with the correction or the component's defaults",
                $"{plain.Count} runs of plain iterations" }, new[]
            {
                Counts("not a number", of => $"{of.Count(row => !double.IsFinite(row.Number("speed_max")))} runs; {Sum(of, "not_finite"):0} " +
                    $"particles that were given as such culled and counted"),
                Counts("particles outside", of => $"{Sum(of, "outside"):0}"),
                Counts("closer than 0.05 d to another at the end",
                    of => FormattableString.Invariant($"{Sum(of, "coincident"):N0} particles, {Where(of, "coincident")}")),
                Counts("beyond a cell's or list's capacity",
                    of => $"{Sum(of, "added") - Sum(of, "alive") - Sum(of, "refused") - Sum(of, "not_finite"):0} lost; at most " +
                    $"{of.Max(row => row.Number("overflow")):0} particles with full lists, reported"),
            });

            static double Sum(List<ReportTable.Row> of, string column) => of.Sum(row => row.Number(column));
            string[] Counts(string what, Func<List<ReportTable.Row>, string> ours) => new[] { what, ours(usual), ours(plain) };
        }
    }
}
