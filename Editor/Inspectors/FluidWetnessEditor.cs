using UnityEditor;

namespace Rill.Editor
{
    [CustomEditor(typeof(FluidWetness))]
    [CanEditMultipleObjects]
    sealed class FluidWetnessEditor : RillEditor
    {
        static readonly InspectorSection[] AllSections =
        {
            new InspectorSection("Wetness", true,
                new InspectorField("dryingTime", "s"),
                new InspectorField("darkening"),
                new InspectorField("smoothness")),
        };

        readonly SetupProblemList setup = new SetupProblemList();

        internal override InspectorSection[] Sections => AllSections;

        public override bool RequiresConstantRepaint() => false;

        private protected override void DrawMessages() => setup.Draw();
    }
}
