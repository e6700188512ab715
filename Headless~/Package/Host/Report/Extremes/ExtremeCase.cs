using System;
using Rill;

namespace Host.Report.Extremes
{
    /// <summary>How much a run of the cases may do and with which setting of the solver.</summary>
    sealed record ExtremeSetting(string Name, SolverSettings Solver, bool Quick)
    {
        public const string PlainName = "deep water off";

        /// <summary>With the correction: what <see cref="DeepWater.Automatic"/> is for water deeper than four layers.</summary>
        public static ExtremeSetting DeepWaterOn(bool quick) => new("deep water on", With(DeepWater.On), quick);
        /// <summary>Without: what <see cref="DeepWater.Automatic"/> is for shallow water.</summary>
        public static ExtremeSetting Plain(bool quick) => new(PlainName, With(DeepWater.Off), quick);

        /// <summary>Setting of a new component.</summary>
        public static ExtremeSetting Default(bool quick) => new("default", SolverSettings.Default, quick);

        static SolverSettings With(DeepWater deepWater)
        {
            SolverSettings settings = SolverSettings.Default;
            settings.deepWater = deepWater;
            return settings;
        }
    }

    /// <summary>Something that a solver may meet and must stand.</summary>
    /// <param name="Subject">Cases of one subject stand together.</param>
    /// <param name="Run">Does it, judges it, and answers with the counts.</param>
    sealed record ExtremeCase(string Subject, string Name, Func<ExtremeSetting, ExtremeCheck, ExtremeCounts> Run)
    {
        /// <summary>Whether it goes through the component, whose own settings it is about: then once, not once a setting.</summary>
        public bool OfComponent { get; init; }
    }
}
