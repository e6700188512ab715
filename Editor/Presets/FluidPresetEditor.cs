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
            new InspectorSection("Fluid", true,
                new InspectorField("material.density", "kg/m³"),
                new InspectorField("material.velocitySmoothing", "fraction in 1/60 s"),
                new InspectorField("material.dynamicViscosity", "Pa s"),
                new InspectorField("material.wallFriction"),
                new InspectorField("material.vorticity", "m/s"),
                new InspectorField("material.artificialPressure"),
                new InspectorField("material.artificialPressureDistance", "support radii", When.IsPositive("material.artificialPressure")),
                new InspectorField("material.allowedTension"),
                new InspectorField("material.shearModulus", "Pa"),
                new InspectorField("material.relaxationTime", "s", When.IsPositive("material.shearModulus")),
                new InspectorField("material.surfaceTension", "N/m"),
                new InspectorField("material.contactAngle", "degrees", When.IsPositive("material.surfaceTension"))),
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
