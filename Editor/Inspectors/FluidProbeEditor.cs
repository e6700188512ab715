using System.Collections.Generic;
using UnityEditor;
using UnityEngine;
using static System.FormattableString;

namespace Rill.Editor
{
    [CustomEditor(typeof(FluidProbe))]
    [CanEditMultipleObjects]
    sealed class FluidProbeEditor : RillEditor
    {
        static readonly InspectorSection[] AllSections =
        {
            new InspectorSection("Probe", true,
                new InspectorField("simulation"),
                new InspectorField("radius", "m")),
            new InspectorSection("Events", false,
                new InspectorField("levelStep", "m"),
                new InspectorField("onLevelChanged")),
        };

        internal override InspectorSection[] Sections => AllSections;

        internal override bool TryGetFrame(Object of, out Bounds bounds) => FrameBounds.TryGet((FluidProbe)of, out bounds);

        internal override void ListLive(List<(string label, string text)> live)
        {
            if (!((FluidProbe)target).TryGetSample(out FluidProbeSample sample))
            {
                live.Add(("Sample", "none: before the first result, or outside the fluid's box"));
                return;
            }
            live.Add(("Sample", Invariant($"step {sample.step:N0}, {1000f * sample.age:0} ms old")));
            live.Add(("Density", Invariant($"{sample.density:0.00} of rest")));
            live.Add(("Velocity", sample.hasVelocity ? Invariant($"{Text(sample.velocity)} m/s, phase {sample.phase}") : "no water here"));
            live.Add(("Surface", sample.hasSurface ? Invariant($"height {sample.height:0.000} m, normal {Text(sample.normal)}")
                : "none on the line along gravity"));
            live.Add(("Submerged", Invariant($"{100f * sample.submerged:0} %")));
        }

        static string Text(Vector3 v) => Invariant($"{v.x:0.00}, {v.y:0.00}, {v.z:0.00}");

        void OnSceneGUI() => ShapeHandles.Sphere((FluidProbe)target, "radius", false, GizmoColors.Query);
    }
}
