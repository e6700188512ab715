using UnityEditor;

namespace Rill.Editor
{
    /// <summary>Inspector of the assets by which stages find their shaders: they belong to the package.</summary>
    [CustomEditor(typeof(StageShader))]
    [CanEditMultipleObjects]
    sealed class StageShaderEditor : RillEditor
    {
        static readonly InspectorSection[] AllSections =
        {
            new InspectorSection("Shaders", true,
                new InspectorField("compute"),
                new InspectorField("shader")),
        };

        internal override InspectorSection[] Sections => AllSections;

        public override bool RequiresConstantRepaint() => false;
    }
}
