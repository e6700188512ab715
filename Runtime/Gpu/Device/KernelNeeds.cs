using System;
using System.Collections.Generic;

namespace Rill
{
    /// <summary>The table of what each program of the package takes of a device, and which of its rows a scene needs.</summary>
    static partial class KernelNeeds
    {
        /// <summary>A row for each variant of each kernel; of a kernel the one without keywords first.</summary>
        public static IReadOnlyList<KernelNeed> OfKernels => Kernels;

        /// <summary>A row for each stage of each draw shader.</summary>
        public static IReadOnlyList<KernelNeed> OfDraws => Draws;
    }
}
