using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Diagnostics;
using System.IO;
using System.Linq;
using Host.Output;
using Host.Report.Budget;
using Host.Report.ErrorTime;
using Host.Report.Extremes;
using Host.Report.Methods;
using Host.Report.Obstacles;
using Host.Studies.Thesis;

namespace Host.Report
{
    /// <summary><c>report</c>: error against run time, against experiment and theory, and at the extremes, as tables, plots and a page.</summary>
    static class ReportCommand
    {
        static readonly ReportSection[] Sections =
        {
            new MethodsSection(),
            new ErrorTimeSection(),
            new ThesisSection(),
            new TheorySection(),
            new DampingSection(),
            new ObstaclesSection(),
            new ExtremesSection("extremes", "Stiff and extreme cases", ExtremeCases.All),
            new ExtremesSection("obstacle-extremes", "Extreme cases with obstacles and sources", ExtremeCases.AllWithObstacles),
            new BudgetSection(),
        };

        public static Command Create()
        {
            var names = new Argument<string[]>("sections") {
                Description = $"Those to do: {string.Join(", ", Sections.Select(section => section.Name))}. All but the long ones if " +
                $"none is named; with --write-only all that were measured.", DefaultValueFactory = _ => Array.Empty<string>() };
            var quick = new Option<bool>("--quick") { Description = "Small scenes that a CPU can do; shows that all works, not how fast." };
            var output = new Option<string>("--out") { Description = $"Folder for tables, plots and page; {ResultsFolder.Root}/report by default." };
            var page = new Option<string>("--page") {
                Description =
                "Write the page to this file instead, its plots to images/report and copies of its tables to data, both beside it." };
            var measureOnly = new Option<bool>("--measure-only") { Description = "Only tables: needs no gnuplot." };
            var writeOnly = new Option<bool>("--write-only") { Description = "Only plots and page, from tables that are there." };
            var command = new Command("report", "Measures error against run time, against experiment and theory, and at the extremes.") {
                names, quick, output, page, measureOnly, writeOnly };
            command.SetAction(parsed =>
            {
                bool measure = !parsed.GetValue(writeOnly), write = !parsed.GetValue(measureOnly);
                if (!measure && !write)
                    throw new HostException("--measure-only and --write-only together leave nothing to do; give one of them or none.");
                write = write && CanWrite(measure);
                ReportFolders folders = ReportFolders.Of(ResultsFolder.Of(parsed.GetValue(output), "report"), parsed.GetValue(page));
                List<ReportSection> sections = Chosen(Sections, parsed.GetValue(names), measure, folders.Data);
                if (measure)
                    Measure(sections, parsed.GetValue(quick), folders.Data);
                if (write)
                {
                    ReportWriter.Write(sections, folders);
                    Console.WriteLine(folders.Page);
                }
                return 0;
            });
            return command;
        }

        /// <summary>Whether plots can be drawn. The tables of a measurement, which may take hours, need none; a page does.</summary>
        /// <exception cref="HostException">They cannot, and nothing is measured either.</exception>
        public static bool CanWrite(bool measure)
        {
            if (Tool.Gnuplot.IsInstalled)
                return true;
            if (!measure)
                throw new HostException($"{Tool.Gnuplot.NotInstalled}, and the report's page consists of plots.");
            Tool.WarnOfMissing((Tool.Gnuplot, "plots and no page; \"rill report --write-only\" makes them of the tables when it is"));
            return false;
        }

        /// <summary>The sections named; without a name all but the long ones or, when none is measured now, all whose tables are there.</summary>
        /// <exception cref="HostException">There is none of that name, or none was measured.</exception>
        public static List<ReportSection> Chosen(IReadOnlyList<ReportSection> all, string[] names, bool measure, string dataFolder)
        {
            foreach (string name in names)
                if (all.All(section => section.Name != name))
                    throw new HostException(
                        $"the report has no section \"{name}\"; it has {string.Join(", ", all.Select(section => section.Name))}.");
            if (names.Length > 0)
                return all.Where(section => names.Contains(section.Name)).ToList();
            if (measure)
                return all.Where(section => !section.OnlyByName).ToList();
            List<ReportSection> measured = all.Where(section => ReportRecord.Find(dataFolder, section) != null).ToList();
            return measured.Count > 0 ? measured
                : throw new HostException($"no section was measured into {dataFolder}; \"rill report\" without --write-only does.");
        }

        static void Measure(List<ReportSection> sections, bool quick, string dataFolder)
        {
            using var session = new Session(Session.Root());
            Console.WriteLine(session.DescribeDevice());
            var run = new ReportRun(dataFolder, quick, session.DescribeDevice(), Console.Out);
            foreach (ReportSection section in sections)
                Measure(section, run);
        }

        public static void Measure(ReportSection section, ReportRun run)
        {
            run.Log(section.Title);
            var clock = Stopwatch.StartNew();
            section.Measure(run);
            ReportRecord.Save(run, section, clock.Elapsed.TotalSeconds);
        }
    }
}
