using UnityEditor;
using UnityEngine;

namespace Rill.Editor
{
    [CustomEditor(typeof(FluidSmokeSource))]
    [CanEditMultipleObjects]
    sealed class FluidSmokeSourceEditor : RillEditor
    {
        static readonly InspectorSection[] AllSections =
        {
            new InspectorSection("Source", true,
                new InspectorField("simulation"),
                new InspectorField("radius", "m"),
                new InspectorField("temperature", "°C"),
                new InspectorField("density", "1/m"),
                new InspectorField("speed", "m/s")),
        };

        internal override InspectorSection[] Sections => AllSections;

        internal override bool TryGetFrame(Object of, out Bounds bounds) => FrameBounds.TryGet((FluidSmokeSource)of, out bounds);

        void OnSceneGUI() => ShapeHandles.Sphere((FluidSmokeSource)target, "radius", false, GizmoColors.Emitter);
    }
}
