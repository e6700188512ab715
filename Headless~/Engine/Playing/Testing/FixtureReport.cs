using System.Collections.Generic;

namespace Host.Testing
{
    /// <summary>Results of a fixture, and of the set-ups around it since the one before. It goes from a worker to its parent as JSON.</summary>
    sealed class FixtureReport
    {
        public string Assembly { get; set; }

        /// <summary>Null for what belongs to no fixture.</summary>
        public string Fixture { get; set; }

        /// <summary>The lines to show: the fixture's own, then its failures.</summary>
        public string Text { get; set; } = "";

        public int Passed { get; set; }
        public int Failed { get; set; }
        public int Skipped { get; set; }
        public double Seconds { get; set; }

        /// <summary>All of its tests ran, not only some that a filter let through.</summary>
        public bool IsWhole { get; set; }

        /// <summary>Test methods that ran, and those of them that dispatched compute work to the device.</summary>
        public List<string> Methods { get; set; } = new();
        public List<string> DispatchingMethods { get; set; } = new();
    }
}
