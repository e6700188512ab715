using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.HighDefinition;

namespace Rill.HighDefinition
{
    /// <summary>Settings that a project with the High Definition Render Pipeline lacks for fluid surfaces.</summary>
    sealed class HighDefinitionSetup : IRenderSetup
    {
        public IEnumerable<SetupProblem> Problems
        {
            get
            {
                if (!(GraphicsSettings.currentRenderPipeline is HDRenderPipelineAsset asset))
                    yield break;
                if (!asset.currentPlatformRenderPipelineSettings.supportCustomPass)
                    yield return new SetupProblem(
                        $"HDRP asset '{asset.name}': Custom Pass is off under Rendering, so that no camera shows fluid surfaces.",
                        "Turn it on", () => LetUseCustomPasses(asset));
                foreach (Camera camera in Camera.allCameras)
                {
                    if (!camera.TryGetComponent(out HDAdditionalCameraData data) || !data.customRenderingSettings)
                        continue;
                    if (!data.renderingPathCustomFrameSettings.IsEnabled(FrameSettingsField.CustomPass))
                        yield return new SetupProblem(
                            $"Camera '{camera.name}': Custom Pass is off in its Custom Frame Settings, so that it shows no fluid surfaces.",
                            "Turn it on", () => Enable(data, FrameSettingsField.CustomPass));
                    if (!data.renderingPathCustomFrameSettings.IsEnabled(FrameSettingsField.Refraction))
                        yield return new SetupProblem($"Camera '{camera.name}': Refraction is off in its Custom Frame Settings, so " +
                            $"that fluid surfaces show black where they refract. Or turn Refraction off on the Fluid Surface.",
                            "Turn it on", () => Enable(data, FrameSettingsField.Refraction));
                }
            }
        }

        public void End() => HighDefinitionSurfaces.Reset();

        static void LetUseCustomPasses(HDRenderPipelineAsset asset)
        {
            RecordUndo(asset, "Custom Pass");
            RenderPipelineSettings settings = asset.currentPlatformRenderPipelineSettings;
            settings.supportCustomPass = true;
            asset.currentPlatformRenderPipelineSettings = settings;
            MarkChanged(asset);
        }

        static void Enable(HDAdditionalCameraData data, FrameSettingsField field)
        {
            RecordUndo(data, "Custom Frame Settings");
            data.renderingPathCustomFrameSettings.SetEnabled(field, true);
            MarkChanged(data);
        }

        static void RecordUndo(Object changed, string what)
        {
#if UNITY_EDITOR
            UnityEditor.Undo.RecordObject(changed, what);
#endif
        }

        static void MarkChanged(Object changed)
        {
#if UNITY_EDITOR
            UnityEditor.EditorUtility.SetDirty(changed);
#endif
        }
    }
}
