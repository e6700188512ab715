using UnityEditor;

namespace Rill.Editor
{
    [CustomEditor(typeof(FluidMaterialAsset))]
    [CanEditMultipleObjects]
    sealed class FluidMaterialAssetEditor : RillEditor
    {
        static readonly InspectorSection[] AllSections =
        {
            new InspectorSection("Material", true,
                new InspectorField("density", "kg/m³"),
                new InspectorField("dynamicViscosity", "Pa s"),
                new InspectorField("surfaceTension", "N/m"),
                new InspectorField("contactAngle", "degrees", When.IsPositive("surfaceTension")),
                new InspectorField("frictionAngle", "degrees"),
                new InspectorField("cohesion", "Pa")),
        };

        internal override InspectorSection[] Sections => AllSections;

        public override bool RequiresConstantRepaint() => false;
    }
}
