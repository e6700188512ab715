using System;
using UnityEditor;

namespace Rill.Editor
{
    [CustomEditor(typeof(FluidPreset))]
    [CanEditMultipleObjects]
    sealed class FluidPresetEditor : RillEditor
    {
        static readonly Func<SerializedObject, bool> IsCustom = When.Is("surface", SurfacePreset.Custom);

        static readonly InspectorSection[] AllSections =
        {
            new InspectorSection("Fluid", true, MaterialFields.Usual.With(MaterialFields.Advanced)),
            new InspectorSection("Look", true,
                new InspectorField("surface"),
                new InspectorField("look.colorAtDepth", when: IsCustom),
                new InspectorField("look.colorDepth", "m", IsCustom),
                new InspectorField("look.scattering", when: IsCustom),
                new InspectorField("look.scatteringDepth", "m", IsCustom),
                new InspectorField("look.refractionIndex", when: IsCustom),
                new InspectorField("look.roughness", when: IsCustom)),
            new InspectorSection("Text", true,
                new InspectorField("realViscosity", "Pa s"),
                new InspectorField("conditions")),
        };

        internal override InspectorSection[] Sections => AllSections;

        public override bool RequiresConstantRepaint() => false;
    }
}
