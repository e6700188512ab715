using UnityEditor;

namespace Rill.Editor
{
    [CustomEditor(typeof(FluidFollow))]
    [CanEditMultipleObjects]
    sealed class FluidFollowEditor : RillEditor
    {
        static readonly InspectorSection[] AllSections =
        {
            new InspectorSection("Motion", true,
                new InspectorField("target"),
                new InspectorField("distance", "particle spacings"),
                new InspectorField("lockX"),
                new InspectorField("lockY"),
                new InspectorField("lockZ")),
            new InspectorSection("Water", true,
                new InspectorField("leaving"),
                new InspectorField("handOverTo"),
                new InspectorField("refill")),
        };

        internal override InspectorSection[] Sections => AllSections;
    }
}
