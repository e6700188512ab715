using System;
using System.Diagnostics;
using System.IO;
using Spectre.Console;

namespace Host.Output
{
    /// <summary>A bar on a terminal, a line every few seconds elsewhere.</summary>
    static class Progress
    {
        const double SecondsBetweenLines = 5;

        /// <param name="work">Gets a function to call with the work done (of total) and a word on its state.</param>
        public static void Run(TextWriter output, string title, double total, Action<Action<double, string>> work)
        {
            if (!Console.IsOutputRedirected && AnsiConsole.Profile.Capabilities.Interactive)
                AnsiConsole.Progress().AutoClear(true).Columns(new TaskDescriptionColumn(), new ProgressBarColumn(), new PercentageColumn(),
                    new RemainingTimeColumn()).Start(context =>
                {
                    ProgressTask task = context.AddTask(Markup.Escape(title), maxValue: total);
                    work((done, state) =>
                    {
                        task.Value = done;
                        task.Description = Markup.Escape($"{title}  {state}");
                    });
                });
            else
            {
                var clock = Stopwatch.StartNew();
                double next = SecondsBetweenLines;
                work((done, state) =>
                {
                    if (clock.Elapsed.TotalSeconds < next)
                        return;
                    next = clock.Elapsed.TotalSeconds + SecondsBetweenLines;
                    output.WriteLine($"{100 * done / total,3:0}%  {state}");
                });
            }
        }
    }
}
