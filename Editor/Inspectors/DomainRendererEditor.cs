using UnityEditor;

namespace Rill.Editor
{
    [CustomEditor(typeof(DomainRenderer))]
    [CanEditMultipleObjects]
    sealed class DomainRendererEditor : FluidRendererEditor
    {
        static readonly InspectorSection[] AllSections =
        {
            new InspectorSection("Box", true,
                new InspectorField("edges"),
                new InspectorField("floor"),
                new InspectorField("tile", "m")),
            Shadows,
        };

        internal override InspectorSection[] Sections => AllSections;
    }
}
