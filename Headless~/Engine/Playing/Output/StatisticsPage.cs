using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Net;
using System.Text;

namespace Host.Output
{
    /// <summary>index.html and statistics.md beside what they show: contact sheet, plots, columns, settings.</summary>
    sealed class StatisticsPage
    {
        public string Title;
        public string Command;
        public List<(string Name, string Value)> Settings = new();
        public List<Plot> Plots = new();
        /// <summary>GPU samples by name, mean milliseconds a step.</summary>
        public List<(string Name, double Milliseconds)> Stages = new();
        public Statistics Statistics;
        public bool HasContactSheet, HasVideo;

        public void Write(string folder)
        {
            File.WriteAllText(Path.Combine(folder, "index.html"), Html());
            File.WriteAllText(Path.Combine(folder, "statistics.md"), Markdown());
        }

        string Html()
        {
            var text = new StringBuilder();
            text.Append($"<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>{Escape(Title)}</title>\n");
            text.Append("<style>body{font:15px/1.45 sans-serif;max-width:1000px;margin:2em auto;padding:0 1em;color:#222}img,video{max-width:100%}" +
                "table{border-collapse:collapse;margin:1em 0}td,th{border-bottom:1px solid #ddd;padding:.25em .9em .25em 0;text-align:left}" +
                "td.n,th.n{text-align:right;font-variant-numeric:tabular-nums}pre{background:#f4f4f4;padding:.7em;overflow:auto}</style>\n</head>\n<body>\n");
            text.Append($"<h1>{Escape(Title)}</h1>\n<pre>{Escape(Command)}</pre>\n");
            if (HasContactSheet)
                text.Append("<h2>Frames</h2>\n<p><a href=\"contact.png\"><img src=\"contact.png\" alt=\"Frames over time\"></a></p>\n");
            if (HasVideo)
                text.Append("<p><video controls loop src=\"video.mp4\"></video></p>\n");
            if (Plots.Count > 0)
                text.Append("<h2>Over time</h2>\n");
            foreach (Plot plot in Plots)
                text.Append($"<p><img src=\"{Escape(plot.File)}.png\" alt=\"{Escape(plot.Title)}\"></p>\n");
            text.Append("<h2>Statistics</h2>\n<table>\n<tr><th>column</th>")
                .Append(string.Concat(SummaryHeads.Select(head => $"<th class=\"n\">{head}</th>"))).Append("</tr>\n");
            foreach (string[] row in Summary())
                text.Append($"<tr><td>{Escape(row[0])}</td>")
                    .Append(string.Concat(row.Skip(1).Select(value => $"<td class=\"n\">{value}</td>"))).Append("</tr>\n");
            text.Append("</table>\n<p>Every step: <a href=\"statistics.csv\">statistics.csv</a></p>\n");
            if (Stages.Count > 0)
                text.Append("<h2>GPU time by stage</h2>\n<table>\n<tr><th>stage</th><th class=\"n\">ms a step</th></tr>\n");
            foreach ((string name, double milliseconds) in Stages)
                text.Append($"<tr><td>{Escape(name)}</td><td class=\"n\">{Number(milliseconds)}</td></tr>\n");
            if (Stages.Count > 0)
                text.Append("</table>\n");
            text.Append("<h2>Settings</h2>\n<table>\n");
            foreach ((string name, string value) in Settings)
                text.Append($"<tr><td>{Escape(name)}</td><td>{Escape(value)}</td></tr>\n");
            return text.Append("</table>\n</body>\n</html>\n").ToString();
        }

        string Markdown()
        {
            var text = new StringBuilder();
            text.Append($"# {Title}\n\n```\n{Command}\n```\n\n");
            if (HasContactSheet)
                text.Append("![Frames over time](contact.png)\n\n");
            foreach (Plot plot in Plots)
                text.Append($"![{plot.Title}]({plot.File}.png)\n\n");
            text.Append($"| column | {string.Join(" | ", SummaryHeads)} |\n| --- |{string.Concat(SummaryHeads.Select(_ => " ---: |"))}\n");
            foreach (string[] row in Summary())
                text.Append($"| {string.Join(" | ", row)} |\n");
            if (Stages.Count > 0)
                text.Append("\n| GPU stage | ms a step |\n| --- | ---: |\n");
            foreach ((string name, double milliseconds) in Stages)
                text.Append($"| {name} | {Number(milliseconds)} |\n");
            text.Append("\n| setting | value |\n| --- | --- |\n");
            foreach ((string name, string value) in Settings)
                text.Append($"| {name} | {value.Replace("|", "\\|")} |\n");
            return text.ToString();
        }

        static readonly string[] SummaryHeads = { "mean", "minimum", "maximum", "99.9th percentile", "last" };

        IEnumerable<string[]> Summary()
        {
            // The first column is the time.
            foreach (string column in Statistics.Columns.Skip(1))
            {
                double[] values = Statistics.Known(column);
                if (values.Length == 0)
                    yield return new[] { column, "", "", "", "", "" };
                else
                    yield return new[] { column, Number(values.Average()), Number(values.Min()), Number(values.Max()),
                    Number(Percentile(values, 0.999)), Number(values[^1]) };
            }
        }

        /// <summary>The smallest value that at least this fraction of the values does not exceed (nearest rank).</summary>
        public static double Percentile(double[] values, double fraction)
        {
            double[] sorted = values.OrderBy(value => value).ToArray();
            return sorted[System.Math.Max(0, (int)System.Math.Ceiling(fraction * sorted.Length) - 1)];
        }

        static string Number(double value) => value.ToString("G6", CultureInfo.InvariantCulture);
        static string Escape(string text) => WebUtility.HtmlEncode(text);
    }
}
