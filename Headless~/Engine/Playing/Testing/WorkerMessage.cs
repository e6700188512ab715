namespace Host.Testing
{
    /// <summary>A line of JSON from a worker to its parent: one of these. A claim is answered by a line "yes" or "no".</summary>
    sealed class WorkerMessage
    {
        /// <summary>The fixture that the worker wants to run next.</summary>
        public string Claim { get; set; }

        public FixtureReport Report { get; set; }

        /// <summary>The last message.</summary>
        public TestFacts Facts { get; set; }
    }
}
