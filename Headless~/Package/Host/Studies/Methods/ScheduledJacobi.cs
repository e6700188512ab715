using System;
using System.Linq;
using Rill;

namespace Host.Studies.Methods
{
    /// <summary>Scheduled relaxation: a relaxation for each pass, some far above 1 (Yang and Mittal 2014).</summary>
    sealed class ScheduledJacobi : PassByPass
    {
        readonly float[] schedule;

        /// <param name="schedule">ω of pass after pass; begins again when it ends.</param>
        public ScheduledJacobi(params float[] schedule) => this.schedule = schedule;

        /// <summary>Yang and Mittal's scheme of two levels for N = 16: one pass at 32.60, 15 at 0.8630.</summary>
        public static float[] YangMittal16() => Enumerable.Repeat(0.8630f, 15).Prepend(32.60f).ToArray();

        /// <summary>
        /// The optimal weights for eigenvalues between two bounds (Adsuara et al. 2017, eq. 22), largest and smallest in turns
        /// so that what one pass amplifies the next damps.
        /// </summary>
        public static float[] Optimal(int passes, double lowest, double highest)
        {
            double[] weights = Enumerable.Range(1, passes)
                .Select(n => 2 / (highest + lowest - (highest - lowest) * Math.Cos(Math.PI * (2 * n - 1) / (2 * passes)))).ToArray();
            return Enumerable.Range(0, passes).Select(i => (float)(i % 2 == 0 ? weights[passes - 1 - i / 2] : weights[i / 2])).ToArray();
        }

        public override bool EndsInPackagePass => true;

        protected override float Relaxation(int pass, in SolverSettings settings) => schedule[pass % schedule.Length];
    }
}
