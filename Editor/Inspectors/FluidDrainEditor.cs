using System.Collections.Generic;
using UnityEditor;
using UnityEngine;
using static System.FormattableString;

namespace Rill.Editor
{
    [CustomEditor(typeof(FluidDrain))]
    [CanEditMultipleObjects]
    sealed class FluidDrainEditor : RillEditor
    {
        static readonly InspectorSection[] AllSections =
        {
            new InspectorSection("Shape", true,
                new InspectorField("simulation"),
                new InspectorField("shape"),
                new InspectorField("size", "m", When.Is("shape", DrainShape.Box)),
                new InspectorField("radius", "m", When.Is("shape", DrainShape.Sphere))),
            new InspectorSection("Flow", true,
                new InspectorField("rateLimit", "m³/s"),
                new InspectorField("recycleTo")),
        };

        internal override InspectorSection[] Sections => AllSections;

        internal override bool TryGetFrame(Object of, out Bounds bounds) => FrameBounds.TryGet((FluidDrain)of, out bounds);

        internal override void ListLive(List<(string label, string text)> live)
            => live.Add(("Drained", Invariant($"{((FluidDrain)target).Drained:N0} particles")));

        void OnSceneGUI()
        {
            var drain = (FluidDrain)target;
            if (drain.Shape == DrainShape.Sphere)
                ShapeHandles.Sphere(drain, "radius", false, GizmoColors.Drain);
            else
                ShapeHandles.Box(drain, "size", false, GizmoColors.Drain);
        }
    }
}
