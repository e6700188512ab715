using UnityEditor;
using UnityEngine.Rendering;

namespace Rill.Editor
{
    /// <summary>Base of the editors for components that draw with a shader of the package.</summary>
    abstract class FluidRendererEditor : RillEditor
    {
        private protected static readonly InspectorSection Shadows = new InspectorSection("Shadows", true,
            new InspectorField("castShadows"),
            new InspectorField("receiveShadows"));

        internal const string UnlitInHighDefinition =
            "HDRP draws this without the scene's lights and shadows. Choose a light as Sun. This has never been run in HDRP.";

        public override bool RequiresConstantRepaint() => false;

        /// <summary>Note about what HDRP does not support in it.</summary>
        private protected virtual string HighDefinitionNote => UnlitInHighDefinition;

        private protected override void DrawMessages()
        {
            string note = PipelineNote(GraphicsSettings.currentRenderPipeline != null
                ? GraphicsSettings.currentRenderPipeline.GetType().Name : null, HighDefinitionNote);
            if (note != null)
                EditorGUILayout.HelpBox(note, MessageType.Info);
        }

        /// <param name="pipelineAsset">Name of its type; null for the Built-in pipeline.</param>
        /// <param name="highDefinition">The note in HDRP.</param>
        /// <returns>Null where there is nothing to note.</returns>
        internal static string PipelineNote(string pipelineAsset, string highDefinition)
        {
            return pipelineAsset != null && pipelineAsset.StartsWith("HDRenderPipeline", System.StringComparison.Ordinal) ? highDefinition : null;
        }
    }
}
