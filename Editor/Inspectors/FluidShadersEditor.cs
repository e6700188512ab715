using UnityEditor;

namespace Rill.Editor
{
    /// <summary>Inspector of an asset that keeps stages in a player for what scripts add.</summary>
    [CustomEditor(typeof(FluidShaders))]
    [CanEditMultipleObjects]
    sealed class FluidShadersEditor : RillEditor
    {
        static readonly InspectorSection[] AllSections =
        {
            new InspectorSection("Shaders", true,
                new InspectorField("stages")),
        };

        internal override InspectorSection[] Sections => AllSections;

        public override bool RequiresConstantRepaint() => false;
    }
}
