using System.Collections.Generic;
using UnityEditor;
using UnityEngine;
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

        readonly List<string> problems = new List<string>();

        private protected override void DrawMessages()
        {
            // Both passes of a frame have to draw the same rows.
            if (Event.current.type == EventType.Layout)
            {
                problems.Clear();
                foreach (Object one in targets)
                    foreach (string problem in DeepWaterState.FloatingProblems(((Component)one).gameObject))
                        if (!problems.Contains(problem))
                            problems.Add(problem);
            }
            foreach (string problem in problems)
                EditorGUILayout.HelpBox(problem, MessageType.Warning);
        }

        internal override void ListLive(List<(string label, string text)> live)
            => live.Add(("Under water", Invariant($"{((FluidBuoyancy)target).SubmergedFraction:P0}")));
    }
}
