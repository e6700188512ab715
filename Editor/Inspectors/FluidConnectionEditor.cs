using System.Collections.Generic;
using UnityEditor;
using UnityEngine;
using static System.FormattableString;

namespace Rill.Editor
{
    [CustomEditor(typeof(FluidConnection))]
    [CanEditMultipleObjects]
    sealed class FluidConnectionEditor : RillEditor
    {
        static readonly InspectorSection[] AllSections =
        {
            new InspectorSection("Fluids", true,
                new InspectorField("first"),
                new InspectorField("second")),
        };

        internal override InspectorSection[] Sections => AllSections;

        internal override bool TryGetFrame(Object of, out Bounds bounds) => FrameBounds.TryGet((FluidConnection)of, out bounds);

        internal override void ListLive(List<(string label, string text)> live)
        {
            var connection = (FluidConnection)target;
            live.Add(("To Second", Invariant($"{connection.HandedToSecond:N0} particles, {connection.WaitingForSecond:N0} wait")));
            live.Add(("To First", Invariant($"{connection.HandedToFirst:N0} particles, {connection.WaitingForFirst:N0} wait")));
        }
    }
}
