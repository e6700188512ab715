using UnityEditor;

namespace Rill.Editor
{
    [CustomEditor(typeof(FluidSurfaceMesh))]
    [CanEditMultipleObjects]
    sealed class FluidSurfaceMeshEditor : RillEditor
    {
        static readonly InspectorSection[] AllSections =
        {
            new InspectorSection("Mesh", true,
                new InspectorField("quality"),
                new InspectorField("hiddenWalls")),
        };

        internal override InspectorSection[] Sections => AllSections;

        public override bool RequiresConstantRepaint() => false;
    }
}
