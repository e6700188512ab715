using System;
using System.Collections.Generic;
using System.Linq;
using Host.Output;

namespace Host.Probing
{
    /// <summary>Measurements of runs. Each entry looks at the loaded scene and answers with its probes, none when there is nothing for it.</summary>
    static class Probes
    {
        static readonly Func<IEnumerable<IRunProbe>>[] All = { FluidProbe.OfScene, BudgetProbe.OfScene };

        public static List<IRunProbe> OfScene() => All.SelectMany(create => create()).ToList();
    }
}
