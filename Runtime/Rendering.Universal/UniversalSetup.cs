using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering.Universal;

namespace Rill.Universal
{
    /// <summary>Settings that a project with the Universal Render Pipeline lacks for fluid surfaces.</summary>
    /// <remarks>Depth and opaque texture may be off in the asset: the pass asks for both.</remarks>
    sealed class UniversalSetup : IRenderSetup
    {
        public IEnumerable<SetupProblem> Problems
        {
            get
            {
                UniversalRenderPipelineAsset asset = UniversalRenderPipeline.asset;
                if (asset == null)
                    yield break;
                foreach (Camera camera in Camera.allCameras)
                {
                    camera.TryGetComponent(out UniversalAdditionalCameraData data);
                    if (data != null && data.renderType == CameraRenderType.Overlay)
                        continue;
                    if (!(UniversalSurfaces.RendererOf(camera, data, asset) is UniversalRenderer))
                        yield return new SetupProblem($"Camera '{camera.name}' draws with a renderer that is no Universal Renderer (a " +
                            $"2D Renderer has no depth): it shows no fluid surfaces. Choose another renderer in the camera's Rendering section.");
                }
#if UNITY_EDITOR
                foreach (UniversalRendererData renderer in RenderersOf(asset))
                    if (!renderer.shadowTransparentReceive)
                        yield return new SetupProblem(
                            $"Renderer '{renderer.name}': Transparent Receive Shadows is off, so that no shadow falls on fluid surfaces.",
                            "Turn it on", () => LetReceiveShadows(renderer));
#endif
            }
        }

        public void End() { }        // nothing of a camera's is changed

#if UNITY_EDITOR
        // The asset does not give its list to scripts before 17.3.
        static List<UniversalRendererData> RenderersOf(UniversalRenderPipelineAsset asset)
        {
            var found = new List<UniversalRendererData>();
            using (var serialized = new UnityEditor.SerializedObject(asset))
            {
                UnityEditor.SerializedProperty list = serialized.FindProperty("m_RendererDataList");
                for (int i = 0; list != null && i < list.arraySize; i++)
                    if (list.GetArrayElementAtIndex(i).objectReferenceValue is UniversalRendererData data)
                        found.Add(data);
            }
            return found;
        }

        static void LetReceiveShadows(UniversalRendererData renderer)
        {
            UnityEditor.Undo.RecordObject(renderer, "Transparent Receive Shadows");
            renderer.shadowTransparentReceive = true;
            UnityEditor.EditorUtility.SetDirty(renderer);
        }
#endif
    }
}
