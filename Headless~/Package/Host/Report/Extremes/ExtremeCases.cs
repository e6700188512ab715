using System.Collections.Generic;
using System.Linq;

namespace Host.Report.Extremes
{
    static class ExtremeCases
    {
        /// <summary>Water alone.</summary>
        /// <param name="quick">Sizes that a CPU can do.</param>
        public static IEnumerable<ExtremeCase> All(bool quick)
        {
            return DeepCases.All(quick).Concat(CrowdCases.All(quick)).Concat(ForceCases.All(quick)).Concat(InputCases.All())
                .Concat(LongCases.All(quick));
        }

        /// <summary>Among meshes, pistons and emitters.</summary>
        /// <param name="quick">Sizes that a CPU can do.</param>
        public static IEnumerable<ExtremeCase> AllWithObstacles(bool quick) => ObstacleCases.All(quick).Concat(EmitterCases.All());
    }
}
