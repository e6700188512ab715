using System.Globalization;
using Rill;

namespace Host.Report.ErrorTime
{
    /// <summary>One setting of a sweep.</summary>
    /// <param name="Deep">Whether Deep Water is on.</param>
    readonly record struct SweepSetting(bool Deep, int Substeps, int Iterations, float Relaxation = SweepSetting.UsualRelaxation)
    {
        public const float UsualRelaxation = 0.8f;

        public SolverSettings Settings
        {
            get
            {
                SolverSettings settings = SolverSettings.Default;
                settings.deepWater = Deep ? DeepWater.On : DeepWater.Off;
                settings.substeps = Substeps;
                settings.iterations = Iterations;
                settings.relaxation = Relaxation;       // not clamped: what lies beyond is part of the question
                return settings;
            }
        }

        /// <summary>Returns the setting a scene runs with when nothing is set.</summary>
        /// <param name="depth">Of all its water over the whole floor, layers.</param>
        public static SweepSetting DefaultFor(float depth)
            => new(CoarseCorrection.IsNeeded(DeepWater.Automatic, depth, false), SolverSettings.Default.substeps,
            SolverSettings.Default.iterations, SolverSettings.Default.relaxation);

        public static string Method(bool deep) => deep ? "deep water" : "plain";

        public override string ToString() => string.Create(CultureInfo.InvariantCulture, $"{Method(Deep)} {Substeps} x {Iterations}, ω {Relaxation}");
    }
}
