using System;
using System.Collections.Generic;
using System.Linq;

namespace Host.Report.ErrorTime
{
    /// <summary>A row of a sweep, and whether the setting held the scene.</summary>
    sealed class SweepResult
    {
        // Water that lies flat cannot lie lower than at rest density; a mean height of less was compressed at some time.
        public const double MinVolume = 0.95, MaxVolume = 1.05, MaxEnergy = 1.01, MaxError = 0.03;
        /// <summary>s; before, water still moves and its mean height says nothing of its volume.</summary>
        public const double SettledAfter = 6;

        readonly ReportTable.Row row;

        SweepResult(ReportTable.Row row) => this.row = row;

        public static IEnumerable<SweepResult> All(ReportTable table) => table.Rows.Select(row => new SweepResult(row));

        /// <summary>Those that hold and that no other one beats, by rising time.</summary>
        public static List<SweepResult> FrontOf(IEnumerable<SweepResult> results)
            => Pareto.Front(results.Where(result => result.Holds), result => result.Milliseconds, result => result.Error);

        public string Scene => row["scene"];
        public string SceneId => $"{Scene}-{Particles}";
        public int Particles => (int)row.Number("particles");
        public int Layers => (int)row.Number("layers");
        public double Spacing => row.Number("spacing_m");
        public double Seconds => row.Number("seconds");
        public SweepSetting Setting => new(row["deep"] == "on", (int)row.Number("substeps"), (int)row.Number("iterations"),
            (float)row.Number("relaxation"));
        public double MillisecondsMoving => row.Number("ms_moving");
        public double MillisecondsSettled => row.Number("ms_settled");
        /// <summary>Time of the more expensive window: what a frame must have room for.</summary>
        public double Milliseconds => Math.Max(MillisecondsMoving, MillisecondsSettled);
        public double ErrorMoving => row.Number("error_moving");
        public double ErrorSettled => row.Number("error_settled");
        /// <summary>C+ of the worse window.</summary>
        public double Error => Math.Max(ErrorMoving, ErrorSettled);
        public double Error999 => row.Number("error_999");
        public double Noise => row.Number("noise");
        public double Jitter => row.Number("jitter");
        public double Volume => row.Number("volume");
        public double MinVolumeSeen => row.Number("volume_lowest");
        public double Energy => row.Number("energy");
        public double Coincident => row.Number("coincident");
        public double Escaped => row.Number("escaped");
        public double NonFinite => row.Number("non_finite");
        public double Overflow => row.Number("overflow");
        public double Bytes => row.Number("bytes");

        /// <summary>Whether water stands still in the end: then any speed is noise.</summary>
        public bool IsStill => Scene is "tank" or "column";
        public double Unrest => IsStill ? Noise : Jitter;

        public bool Holds => Fault == null;

        /// <summary>Why the setting does not hold the scene; null if it does.</summary>
        public string Fault =>
            !(NonFinite == 0 && Escaped == 0) ? "loses particles" :
            !(MinVolumeSeen >= MinVolume) ? "collapses" :
            !(Energy <= MaxEnergy) ? "gains energy" :
            Seconds >= SettledAfter && !(Volume <= MaxVolume) ? "boils" :
            !(Error <= MaxError) ? "is too dense" :
            null;
    }
}
