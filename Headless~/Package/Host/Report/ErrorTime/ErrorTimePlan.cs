using System.Collections.Generic;
using System.Linq;
using Host.Experiments;

namespace Host.Report.ErrorTime
{
    /// <summary>A scene and the settings that it is run with.</summary>
    sealed record ErrorTimePlan(ExperimentScene Scene, double Seconds, IReadOnlyList<SweepSetting> Settings)
    {
        static readonly SweepSetting[] Plain =
        {
            new(false, 1, 1, 0.3f), new(false, 1, 2), new(false, 1, 3), new(false, 1, 4), new(false, 1, 8), new(false, 1, 16),
            new(false, 1, 4, 0.5f), new(false, 1, 4, 1f), new(false, 1, 4, 1.2f), new(false, 1, 8, 1.2f), new(false, 1, 16, 1.2f),
            new(false, 2, 1, 0.3f), new(false, 2, 2), new(false, 2, 4), new(false, 4, 1, 0.3f), new(false, 4, 2), new(false, 4, 4), new(false, 8, 2),
        };

        static readonly SweepSetting[] TwoLevel =
        {
            new(true, 1, 1), new(true, 1, 2), new(true, 1, 3), new(true, 1, 4), new(true, 1, 6), new(true, 1, 8),
            new(true, 1, 1, 0.5f), new(true, 1, 2, 0.5f), new(true, 1, 2, 1f), new(true, 1, 4, 0.5f), new(true, 1, 4, 1.2f),
            new(true, 2, 1), new(true, 2, 2), new(true, 2, 4), new(true, 4, 1), new(true, 4, 2),
        };

        // Plain iterations collapse in deep water, and a step of collapsed water takes twenty times as long: few of those.
        static readonly SweepSetting[] PlainInDeepWater = { new(false, 1, 4), new(false, 1, 16), new(false, 4, 4), new(false, 8, 2) };

        static readonly SweepSetting[] Few = { new(false, 1, 2), new(false, 1, 4), new(true, 1, 1), new(true, 1, 2) };

        /// <summary>For a GPU.</summary>
        public static readonly ErrorTimePlan[] Full =
        {
            new(ExperimentScene.Dam(100_000), 8, Plain.Concat(TwoLevel).ToArray()),
            new(ExperimentScene.Dam(1_000_000), 8, TwoLevel.Where(s => s.Substeps * s.Iterations <= 4).Append(new(false, 4, 4)).ToArray()),
            new(ExperimentScene.Dam(1_000_000), 3, new SweepSetting[] { new(false, 1, 4) }),
            new(ExperimentScene.Column(120, 0.05f), 8, PlainInDeepWater.Concat(TwoLevel).ToArray()),
            new(ExperimentScene.Drop(2f), 6, Plain.Concat(TwoLevel).ToArray()),
            new(ExperimentScene.Tank(8, 112, 0.02f), 8, Plain.Concat(TwoLevel).ToArray()),
        };

        /// <summary>For a CPU.</summary>
        public static readonly ErrorTimePlan[] Quick =
        {
            new(ExperimentScene.Dam(2_000), 2, Few),
            new(ExperimentScene.Column(24, 0.05f, 10), 2, Few),
            new(ExperimentScene.Drop(0.5f), 2, Few),
            new(ExperimentScene.Tank(6, 20, 0.05f), 2, Few),
        };
    }
}
