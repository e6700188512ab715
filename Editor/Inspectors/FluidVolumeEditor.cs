using UnityEditor;
using UnityEngine;
using static System.FormattableString;

namespace Rill.Editor
{
    [CustomEditor(typeof(FluidVolume))]
    [CanEditMultipleObjects]
    sealed class FluidVolumeEditor : RillEditor
    {
        static readonly InspectorSection[] AllSections =
        {
            new InspectorSection("Volume", true,
                new InspectorField("shape"),
                new InspectorField("size", "m", When.Is("shape", VolumeShape.Box)),
                new InspectorField("radius", "m", When.Is("shape", VolumeShape.Sphere)),
                new InspectorField("field", when: When.Is("shape", VolumeShape.SignedDistanceField)),
                new InspectorField("velocity", "m/s"),
                new InspectorField("material")),
        };

        internal override InspectorSection[] Sections => AllSections;

        internal override bool TryGetFrame(Object of, out Bounds bounds) => FrameBounds.TryGet((FluidVolume)of, out bounds);

        private protected override void DrawBelow(string title)
        {
            BakeButton.Draw<FluidVolume>(targets, volume => volume.Shape == VolumeShape.SignedDistanceField && volume.Field == null);
            if (targets.Length > 1)
                return;
            var volume = (FluidVolume)target;
            FluidSimulation fluid = volume.GetComponentInParent<FluidSimulation>(true);
            if (fluid != null)
                InspectorRows.Text("Holds", Invariant($"about {FillEstimate.Particles(volume, fluid.ParticleSpacing):N0} particles"));
            if (VolumePreview.HiddenNote(volume) is string note)
                EditorGUILayout.HelpBox(note, MessageType.None);
        }

        void OnSceneGUI()
        {
            var volume = (FluidVolume)target;
            if (volume.Shape == VolumeShape.Sphere)
                ShapeHandles.Sphere(volume, "radius", false, GizmoColors.Volume);
            else if (volume.Shape == VolumeShape.Box)
                ShapeHandles.Box(volume, "size", false, GizmoColors.Volume);
        }
    }
}
