using System.Globalization;
using Rill;

namespace Host.Report.ErrorTime
{
    /// <summary>One setting of a sweep.</summary>
    /// <param name="Deep">Whether with the two-level correction.</param>
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

        public static string Method(bool deep) => deep ? "two-level" : "plain";

        public override string ToString() => string.Create(CultureInfo.InvariantCulture, $"{Method(Deep)} {Substeps} x {Iterations}, ω {Relaxation}");
    }
}
