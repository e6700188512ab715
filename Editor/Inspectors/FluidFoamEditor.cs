using System.Collections.Generic;
using UnityEditor;
using static System.FormattableString;

namespace Rill.Editor
{
    [CustomEditor(typeof(FluidFoam))]
    [CanEditMultipleObjects]
    sealed class FluidFoamEditor : FluidRendererEditor
    {
        static readonly InspectorSection[] AllSections =
        {
            new InspectorSection("Foam", true,
                new InspectorField("settings.amount"),
                new InspectorField("settings.lifetime", "s"),
                new InspectorField("settings.kinds"),
                new InspectorField("settings.budget", "particles")),
            new InspectorSection("Look", true,
                new InspectorField("radius", "m"),
                new InspectorField("color"),
                new InspectorField("opacity"),
                new InspectorField("sun"),
                new InspectorField("ambient")),
            new InspectorSection("Scale", false,
                new InspectorField("settings.referenceSpeed", "m/s"),
                new InspectorField("settings.referenceDepth", "m")),
            Shadows,
        };

        internal override InspectorSection[] Sections => AllSections;

        internal override void ListLive(List<(string label, string text)> live)
        {
            if (!((FluidFoam)target).TryGetStatistics(out FoamStatistics statistics))
                return;
            live.Add(("Spray", Invariant($"{statistics.spray:N0} particles")));
            live.Add(("Foam", Invariant($"{statistics.foam:N0} particles")));
            live.Add(("Bubbles", Invariant($"{statistics.bubbles:N0} particles")));
            if (statistics.refused > 0)
                live.Add(("Refused",
                    Invariant($"{statistics.refused:N0} of {statistics.spawned + statistics.refused:N0}: raise the budget or lower the ") +
                    "amount"));
        }
    }
}
