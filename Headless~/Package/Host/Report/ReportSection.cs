namespace Host.Report
{
    /// <summary>A part of the report: it measures into tables and, from those alone, writes its part of the page.</summary>
    abstract class ReportSection
    {
        /// <summary>A word for the command line and for file names.</summary>
        public abstract string Name { get; }
        public abstract string Title { get; }

        /// <summary>Whether it runs only when it is named: what takes long.</summary>
        public virtual bool OnlyByName => false;

        /// <summary>Whether it stands at the beginning of the page, before all overviews.</summary>
        public virtual bool OpensPage => false;

        /// <summary>Runs the simulations; saves tables by <see cref="ReportRun.Save"/>.</summary>
        public abstract void Measure(ReportRun run);

        /// <summary>A picture for the beginning of the page, from the same tables; nothing for most sections.</summary>
        public virtual void WriteOverview(ReportPage page) { }

        /// <summary>Text, tables and plots from what <see cref="Measure"/> saved, maybe on another machine and another day.</summary>
        public abstract void Write(ReportPage page);
    }
}
