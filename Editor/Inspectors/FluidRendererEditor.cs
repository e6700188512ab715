using UnityEditor;
using UnityEngine.Rendering;

namespace Rill.Editor
{
    /// <summary>Of what draws with a pass that the pipeline may not run.</summary>
    abstract class FluidRendererEditor : RillEditor
    {
        public override bool RequiresConstantRepaint() => false;

        private protected override void DrawMessages()
        {
            string note = PipelineNote(GraphicsSettings.currentRenderPipeline != null ? GraphicsSettings.currentRenderPipeline.GetType().Name : null);
            if (note != null)
                EditorGUILayout.HelpBox(note, MessageType.Warning);
        }

        /// <param name="pipelineAsset">Name of its type; null for the Built-in pipeline.</param>
        /// <returns>Null where it draws.</returns>
        internal static string PipelineNote(string pipelineAsset)
        {
            return pipelineAsset != null && pipelineAsset.StartsWith("HDRenderPipeline", System.StringComparison.Ordinal)
                ? "HDRP does not draw this. Use URP or the Built-in pipeline."
                : null;
        }
    }
}
