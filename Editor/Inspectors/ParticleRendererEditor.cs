using UnityEditor;

namespace Rill.Editor
{
    [CustomEditor(typeof(ParticleRenderer))]
    [CanEditMultipleObjects]
    sealed class ParticleRendererEditor : FluidRendererEditor
    {
        static readonly InspectorSection[] AllSections =
        {
            new InspectorSection("Spheres", true,
                new InspectorField("radius", "particle spacings")),
            new InspectorSection("Color", true,
                new InspectorField("colorBy"),
                new InspectorField("colorRange", RangeUnit, When.IsNot("colorBy", ParticleRenderer.Quantity.Phase)),
                new InspectorField("slowColor", when: When.IsNot("colorBy", ParticleRenderer.Quantity.Phase)),
                new InspectorField("middleColor", when: When.IsNot("colorBy", ParticleRenderer.Quantity.Phase)),
                new InspectorField("fastColor", when: When.IsNot("colorBy", ParticleRenderer.Quantity.Phase)),
                new InspectorField("phaseColors", when: When.Is("colorBy", ParticleRenderer.Quantity.Phase))),
            new InspectorSection("Light", true,
                new InspectorField("sun"),
                new InspectorField("ambient")),
            Shadows,
        };

        internal override InspectorSection[] Sections => AllSections;

        static string RangeUnit(SerializedObject inspected)
        {
            SerializedProperty quantity = inspected.FindProperty("colorBy");
            if (quantity.hasMultipleDifferentValues)
                return null;
            return quantity.intValue == (int)ParticleRenderer.Quantity.Speed ? "m/s" : "density error";
        }
    }
}
