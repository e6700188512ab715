using System.Collections.Generic;
using UnityEditor;
using static System.FormattableString;

namespace Rill.Editor
{
    [CustomEditor(typeof(FluidBuoyancy))]
    [CanEditMultipleObjects]
    sealed class FluidBuoyancyEditor : RillEditor
    {
        static readonly InspectorSection[] AllSections =
        {
            new InspectorSection("Floating", true,
                new InspectorField("virtualMass", "of the displaced water"),
                new InspectorField("damping", "of critical"),
                new InspectorField("maxAcceleration", "m/s²")),
        };

        internal override InspectorSection[] Sections => AllSections;

        internal override void ListLive(List<(string label, string text)> live)
            => live.Add(("Under water", Invariant($"{((FluidBuoyancy)target).SubmergedFraction:P0}")));
    }
}
