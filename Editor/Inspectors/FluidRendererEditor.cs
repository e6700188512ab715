using UnityEditor;
using UnityEngine.Rendering;

namespace Rill.Editor
{
    /// <summary>Of what draws with a shader of the package.</summary>
    abstract class FluidRendererEditor : RillEditor
    {
        private protected static readonly InspectorSection Shadows = new InspectorSection("Shadows", true,
            new InspectorField("castShadows"),
            new InspectorField("receiveShadows"));

        public override bool RequiresConstantRepaint() => false;

        private protected override void DrawMessages()
        {
            string note = PipelineNote(GraphicsSettings.currentRenderPipeline != null ? GraphicsSettings.currentRenderPipeline.GetType().Name : null);
            if (note != null)
                EditorGUILayout.HelpBox(note, MessageType.Info);
        }

        /// <param name="pipelineAsset">Name of its type; null for the Built-in pipeline.</param>
        /// <returns>Null where it draws with the scene's light.</returns>
        internal static string PipelineNote(string pipelineAsset)
        {
            return pipelineAsset != null && pipelineAsset.StartsWith("HDRenderPipeline", System.StringComparison.Ordinal)
                ? "HDRP draws this without the scene's lights and shadows. Choose a light as Sun. This has never been run in HDRP."
                : null;
        }
    }
}
