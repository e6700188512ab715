using System.Collections.Generic;

namespace Host.Check
{
    /// <summary>One thing that must hold for a package. A rule that cannot read what it has to judge reports that as a fault.</summary>
    abstract class Rule
    {
        /// <summary>"group: what must hold", a line of the table; <c>rill check --filter</c> looks for a part of it.</summary>
        public abstract string Name { get; }

        public abstract Findings Examine(PackageTree package);
    }

    /// <summary>Objects that a rule examined and faults that it found.</summary>
    sealed class Findings
    {
        /// <summary>In numbers, for the table: "28 kernels in 30 variants".</summary>
        public string Looked = "";
        /// <summary>A line each: the file (with its line), what is wrong, and what to do. Empty = the rule holds.</summary>
        public readonly List<string> Faults = new();
        /// <summary>Tables that the rule's look gave, for the documentation.</summary>
        public readonly List<ResultTable> Tables = new();

        public void Fault(string what) => Faults.Add(what);
    }

    /// <summary>Results to print, as Markdown in the documentation.</summary>
    sealed class ResultTable
    {
        /// <summary>The heading above it, e.g. "Cost of each kernel".</summary>
        public string Title;
        /// <summary>A sentence before the table: compiler, version, settings.</summary>
        public string About = "";
        public string[] Columns;
        public readonly List<string[]> Rows = new();
    }
}
