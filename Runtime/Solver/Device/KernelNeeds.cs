using System.Collections.Generic;

namespace Rill
{
    /// <summary>The table of what each program of the package takes of a device.</summary>
    static partial class KernelNeeds
    {
        /// <summary>A row for each variant of each kernel.</summary>
        public static IReadOnlyList<KernelNeed> OfKernels => Kernels;

        /// <summary>A row for each stage of each draw shader.</summary>
        public static IReadOnlyList<KernelNeed> OfDraws => Draws;
    }
}
