using System.Collections.Generic;
using System.Linq;

namespace Host.Report.Extremes
{
    static class ExtremeCases
    {
        /// <param name="quick">Sizes that a CPU can do.</param>
        public static IEnumerable<ExtremeCase> All(bool quick)
        {
            return DeepCases.All(quick).Concat(CrowdCases.All(quick)).Concat(ForceCases.All(quick)).Concat(InputCases.All()).Concat(LongCases.All(quick));
        }
    }
}
