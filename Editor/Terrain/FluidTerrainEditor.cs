using UnityEditor;
using UnityEngine;

namespace Rill.Editor
{
    [CustomEditor(typeof(FluidTerrain))]
    [CanEditMultipleObjects]
    sealed class FluidTerrainEditor : RillEditor
    {
        static readonly InspectorSection[] AllSections =
        {
            new InspectorSection("Ground", true,
                new InspectorField("part", "fractions of the sides")),
        };

        internal override InspectorSection[] Sections => AllSections;

        public override bool RequiresConstantRepaint() => false;

        private protected override void DrawLive()
        {
            if (GUILayout.Button("Take the heights again"))
                ((FluidTerrain)target).Refresh();
        }
    }
}
