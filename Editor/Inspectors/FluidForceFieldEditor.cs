using UnityEditor;
using UnityEngine;

namespace Rill.Editor
{
    [CustomEditor(typeof(FluidForceField))]
    [CanEditMultipleObjects]
    sealed class FluidForceFieldEditor : RillEditor
    {
        static readonly InspectorSection[] AllSections =
        {
            new InspectorSection("Field", true,
                new InspectorField("simulation"),
                new InspectorField("kind"),
                new InspectorField("strength", StrengthUnit),
                new InspectorField("drag", "1/s", When.Is("kind", ForceFieldKind.Wind))),
            new InspectorSection("Bounds", true,
                new InspectorField("bounds"),
                new InspectorField("radius", "m", When.Is("bounds", ForceFieldBounds.Sphere)),
                new InspectorField("size", "m", When.Is("bounds", ForceFieldBounds.Box)),
                new InspectorField("falloff", when: When.IsNot("bounds", ForceFieldBounds.None))),
        };

        internal override InspectorSection[] Sections => AllSections;

        internal override bool TryGetFrame(Object of, out Bounds bounds) => FrameBounds.TryGet((FluidForceField)of, out bounds);

        static string StrengthUnit(SerializedObject inspected)
        {
            SerializedProperty kind = inspected.FindProperty("kind");
            if (kind.hasMultipleDifferentValues)
                return "m/s², wind m/s";
            return kind.intValue == (int)ForceFieldKind.Wind ? "m/s" : "m/s²";
        }

        void OnSceneGUI()
        {
            var field = (FluidForceField)target;
            if (field.Bounds == ForceFieldBounds.Sphere)
                ShapeHandles.Sphere(field, "radius", false, GizmoColors.ForceField);
            else if (field.Bounds == ForceFieldBounds.Box)
                ShapeHandles.Box(field, "size", false, GizmoColors.ForceField);
        }
    }
}
