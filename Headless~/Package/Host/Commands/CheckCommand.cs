using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Diagnostics;
using System.IO;
using System.Linq;
using Host.Check;

namespace Host.Commands
{
    /// <summary><c>check</c>: what must hold so that the package works in Unity, a line a rule.</summary>
    static class CheckCommand
    {
        public static Command Create()
        {
            var filter = new Option<string>("--filter") { Description = "Only rules whose name contains this text.", DefaultValueFactory = _ => "" };
            var page = new Option<string>("--page") { Description = "Markdown file for the table of rules and the tables that they make." };
            var command = new Command("check", "Checks that the package works in Unity, by all that can be had without an editor.") { filter, page };
            command.SetAction(parsed => Execute(parsed.GetValue(filter), parsed.GetValue(page)));
            return command;
        }

        static int Execute(string filter, string page)
        {
            List<Rule> rules = RuleBook.All.Where(rule => rule.Name.Contains(filter, StringComparison.OrdinalIgnoreCase)).ToList();
            if (rules.Count == 0)
                throw new HostException($"--filter {filter}: no rule's name contains that; the rules are: " +
                    $"{string.Join("; ", RuleBook.All.Select(rule => rule.Name))}.");
            var package = new PackageTree(Session.Root());
            var examined = new List<(Rule rule, Findings findings)>();
            int widest = rules.Max(rule => rule.Name.Length);
            foreach (Rule rule in rules)
            {
                var clock = Stopwatch.StartNew();
                Findings findings = rule.Examine(package);
                examined.Add((rule, findings));
                string verdict = findings.Faults.Count == 0 ? "ok" : $"{findings.Faults.Count} faults";
                Console.Out.WriteLine($"{rule.Name.PadRight(widest)}  {verdict,-9} {clock.Elapsed.TotalSeconds,5:0.0} s  {findings.Looked}");
                foreach (string fault in findings.Faults)
                    Console.Out.WriteLine("    " + fault);
            }
            if (page != null)
                CheckPage.Write(page, examined);
            int faults = examined.Sum(e => e.findings.Faults.Count);
            Console.Out.WriteLine(faults == 0 ? $"{rules.Count} rules hold"
                : $"{examined.Count(e => e.findings.Faults.Count > 0)} of {rules.Count} rules are broken, {faults} faults");
            return faults == 0 ? 0 : 1;
        }
    }
}
