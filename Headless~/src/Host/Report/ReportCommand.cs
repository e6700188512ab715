using System;
using System.Collections.Generic;
using System.CommandLine;
using System.IO;
using System.Linq;

namespace Host.Report
{
    /// <summary><c>report</c>: error against run time, against experiment and theory, and at the extremes, as tables, plots and a page.</summary>
    static class ReportCommand
    {
        static readonly ReportSection[] Sections =
        {
            new BudgetSection(),
        };

        public static Command Create()
        {
            var names = new Argument<string[]>("sections") { Description = $"Those to do: {string.Join(", ", Sections.Select(section => section.Name))}. All but the long ones if none is named.", DefaultValueFactory = _ => Array.Empty<string>() };
            var quick = new Option<bool>("--quick") { Description = "Small scenes that a CPU can do; shows that all works, not how fast." };
            var output = new Option<string>("--out") { Description = "Folder for tables, plots and page.", DefaultValueFactory = _ => Path.Combine("out", "report") };
            var measureOnly = new Option<bool>("--measure-only") { Description = "Only tables: needs no gnuplot." };
            var writeOnly = new Option<bool>("--write-only") { Description = "Only plots and page, from tables that are there." };
            var command = new Command("report", "Measures error against run time, against experiment and theory, and at the extremes.") { names, quick, output, measureOnly, writeOnly };
            command.SetAction(parsed => Execute(Chosen(parsed.GetValue(names)), parsed.GetValue(quick), Path.GetFullPath(parsed.GetValue(output)), !parsed.GetValue(writeOnly), !parsed.GetValue(measureOnly)));
            return command;
        }

        static List<ReportSection> Chosen(string[] names)
        {
            foreach (string name in names)
                if (Sections.All(section => section.Name != name))
                    throw new HostException($"there is no section \"{name}\" of the report; there are {string.Join(", ", Sections.Select(section => section.Name))}.");
            return Sections.Where(section => names.Length == 0 ? !section.OnlyByName : names.Contains(section.Name)).ToList();
        }

        static int Execute(List<ReportSection> sections, bool quick, string folder, bool measure, bool write)
        {
            string data = Path.Combine(folder, "data");
            if (measure)
            {
                using var session = new Session(Session.Root());
                string device = session.DescribeDevice();
                Console.WriteLine(device);
                var run = new ReportRun(data, quick, device, Console.Out);
                foreach (ReportSection section in sections)
                {
                    run.Log(section.Title);
                    section.Measure(run);
                }
            }
            if (write)
            {
                var page = new ReportPage(data, Path.Combine(folder, "images"), "images");
                page.Line("# Report");
                foreach (ReportSection section in sections)
                {
                    page.Line();
                    page.Line("## " + section.Title);
                    page.Line();
                    section.Write(page);
                }
                string file = Path.Combine(folder, "report.md");
                File.WriteAllText(file, page.ToString());
                Console.WriteLine(file);
            }
            return 0;
        }
    }
}
