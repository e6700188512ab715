using System.Collections.Generic;
using Host.Experiments;
using Unity.Mathematics;

namespace Host.Studies.Methods
{
    /// <summary>What every method is put to.</summary>
    /// <param name="IsStill">Water that should not move: its speed is noise. Where water flows, the jitter is.</param>
    sealed record MethodScene(string Name, string Title, ExperimentScene Scene, double Seconds, bool IsStill)
    {
        public static IEnumerable<MethodScene> All(bool quick)
        {
            if (quick)
                return new[]
                {
                    new MethodScene("dam", "dam, 13 layers", ExperimentScene.Dam(2_000), 0.4, false),
                    new MethodScene("column", "column, 30 layers",
                        ExperimentScene.Block("column", new int3(8, 30, 8), new int3(8, 60, 8), 0.05f), 0.4, true),
                };
            return new[]
            {
                new MethodScene("dam", "dam, 50 layers", ExperimentScene.Dam(100_000), 2, false),
                new MethodScene("column", "column, 120 layers", ExperimentScene.Column(120, 0.05f), 4, true),
                new MethodScene("tank", "tank, 12 layers", ExperimentScene.Column(12, 0.05f), 4, true),
            };
        }
    }
}
