using System;
using UnityEditor;
using UnityEngine.Rendering;

namespace Rill.Editor
{
    [CustomEditor(typeof(FluidSurface))]
    [CanEditMultipleObjects]
    sealed class FluidSurfaceEditor : FluidRendererEditor
    {
        static readonly Func<SerializedObject, bool> IsCustom = When.Is("preset", SurfacePreset.Custom);

        static readonly InspectorSection[] AllSections =
        {
            new InspectorSection("Look", true,
                new InspectorField("preset"),
                new InspectorField("look.colorAtDepth", when: IsCustom),
                new InspectorField("look.colorDepth", "m", IsCustom),
                new InspectorField("look.scattering", when: IsCustom),
                new InspectorField("look.scatteringDepth", "m", IsCustom),
                new InspectorField("look.refractionIndex", when: IsCustom),
                new InspectorField("look.roughness", when: IsCustom),
                new InspectorField("phaseLooks"),
                new InspectorField("refraction")),
            new InspectorSection("Quality", true,
                new InspectorField("hiddenWalls"),
                new InspectorField("quality")),
            new InspectorSection("Light", true,
                new InspectorField("sun"),
                new InspectorField("reflection"),
                new InspectorField("reflectionStrength"),
                new InspectorField("caustics"),
                new InspectorField("ripples")),
            new InspectorSection("Shadows", true,
                new InspectorField("castShadows"),
                new InspectorField("shadowOpacity", when: inspected => inspected.FindProperty("castShadows").intValue != (int)ShadowCastingMode.Off),
                new InspectorField("receiveShadows")),
        };

        readonly SetupProblemList setup = new SetupProblemList();

        internal override InspectorSection[] Sections => AllSections;

        internal const string LimitsInHighDefinition =
            "In HDRP neither fog nor shadows act on this surface, and it mirrors the sky alone. This has never been run in HDRP.";

        private protected override string HighDefinitionNote => LimitsInHighDefinition;

        private protected override void DrawMessages()
        {
            base.DrawMessages();
            setup.Draw();
        }
    }
}
