using System.Collections.Generic;
using Host.Experiments;
using Unity.Mathematics;

namespace Host.Report.Extremes
{
    /// <summary>Water many layers deep, one substep of 1/60 s.</summary>
    static class DeepCases
    {
        const string Subject = "Deep water";

        public static IEnumerable<ExtremeCase> All(bool quick)
        {
            if (quick)
            {
                yield return Still("column of 40 layers 10 x 10 wide",
                    ExperimentScene.Block("column", new int3(10, 40, 10), new int3(10, 52, 10), 0.05f), 2.5);
                yield break;
            }
            yield return Still("dam of 100 layers (1000000 particles)", ExperimentScene.Dam(1_000_000), 15);
            yield return Still("column of 120 layers", ExperimentScene.Column(120, 0.05f), 8);
            yield return Still("column of 240 layers", ExperimentScene.Column(240, 0.0125f), 8);
        }

        static ExtremeCase Still(string name, ExperimentScene scene, double seconds) => new(Subject, name, (setting, check) =>
        {
            using var fluid = new ExtremeFluid(scene, setting.Solver);
            // Without the correction deep water collapses within the first second, and a step of it then takes a hundred times as long.
            bool plain = setting.Solver.deepWater == Rill.DeepWater.Off;
            fluid.Seconds(!plain ? seconds : setting.Quick ? 1 : 1.5);
            double settled = plain || setting.Quick ? 0.5 : 2;
            check.AtMost("C+ settled", fluid.Settled(s => s.densityError, settled), 0.005, "%");
            check.Between("volume", fluid.Settled(s => s.volumeRatio, settled), 0.97, 1.03);
            check.AtMost("jitter", fluid.Settled(s => s.jitter, settled), 0.05, "m/s");
            check.AtMost("highest energy over the start's", fluid.MaxEnergy, 1.005);
            check.Note("pairs nearer than 0.25 d", ClosePairs.Count(fluid.Read(), 0.25f));
            return fluid.Counts;
        });
    }
}
