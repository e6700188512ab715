using System.Collections.Generic;
using UnityEditor;
using UnityEngine;
using static System.FormattableString;

namespace Rill.Editor
{
    [CustomEditor(typeof(FluidDetector))]
    [CanEditMultipleObjects]
    sealed class FluidDetectorEditor : RillEditor
    {
        const string ShapeTitle = "Shape";

        static readonly InspectorSection[] AllSections =
        {
            new InspectorSection(ShapeTitle, true,
                new InspectorField("simulation"),
                new InspectorField("shape"),
                new InspectorField("size", "m", When.Is("shape", DetectorShape.Box)),
                new InspectorField("radius", "m", When.Is("shape", DetectorShape.Sphere, DetectorShape.Capsule)),
                new InspectorField("height", "m", When.Is("shape", DetectorShape.Capsule)),
                new InspectorField("field", when: When.Is("shape", DetectorShape.Mesh))),
            new InspectorSection("Thresholds", true,
                new InspectorField("enterFill"),
                new InspectorField("fillLevel"),
                new InspectorField("hysteresis"),
                new InspectorField("impactSpeed", "m/s")),
            new InspectorSection("Events", false,
                new InspectorField("levelStep"),
                new InspectorField("onEnter"),
                new InspectorField("onExit"),
                new InspectorField("onFilled"),
                new InspectorField("onEmptied"),
                new InspectorField("onImpact"),
                new InspectorField("onLevelChanged")),
        };

        internal override InspectorSection[] Sections => AllSections;

        internal override bool TryGetFrame(Object of, out Bounds bounds) => FrameBounds.TryGet((FluidDetector)of, out bounds);

        private protected override void DrawBelow(string title)
        {
            if (title == ShapeTitle)
                BakeButton.Draw<FluidDetector>(targets, detector => detector.Shape == DetectorShape.Mesh && detector.Field == null);
        }

        internal override void ListLive(List<(string label, string text)> live)
        {
            if (!((FluidDetector)target).TryGetSample(out FluidDetectorSample sample))
            {
                live.Add(("Sample", "none: before the first result"));
                return;
            }
            live.Add(("Sample", Invariant($"step {sample.step:N0}, {1000f * sample.age:0} ms old")));
            live.Add(("Volume", Invariant($"{1000f * sample.volume:0.000} liters, fill {100f * sample.fill:0.0} %")));
            live.Add(("Velocity", sample.hasVelocity ? Invariant($"{sample.velocity.x:0.00}, {sample.velocity.y:0.00}, ") +
                Invariant($"{sample.velocity.z:0.00} m/s")
                : "no water inside"));
        }

        void OnSceneGUI()
        {
            var detector = (FluidDetector)target;
            if (detector.Shape == DetectorShape.Box)
                ShapeHandles.Box(detector, "size", false, GizmoColors.Query);
            else if (detector.Shape == DetectorShape.Sphere)
                ShapeHandles.Sphere(detector, "radius", false, GizmoColors.Query);
        }
    }
}
