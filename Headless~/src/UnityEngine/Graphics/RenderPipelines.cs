using System;
using System.Collections.Generic;

namespace UnityEngine.Rendering
{
    /// <summary>Always the built-in pipeline: no asset is ever set.</summary>
    public abstract class RenderPipelineAsset : ScriptableObject { }
    public abstract class RenderPipeline { }

    public struct ScriptableRenderContext { }

    public static class RenderPipelineManager
    {
        public static RenderPipeline currentPipeline => null;
        // Scriptable pipelines raise these; the built-in one never does.
        public static event Action<ScriptableRenderContext, Camera> beginCameraRendering { add { } remove { } }
        public static event Action<ScriptableRenderContext, Camera> endCameraRendering { add { } remove { } }
        public static event Action<ScriptableRenderContext, List<Camera>> beginContextRendering { add { } remove { } }
        public static event Action<ScriptableRenderContext, List<Camera>> endContextRendering { add { } remove { } }
        public static event Action activeRenderPipelineTypeChanged { add { } remove { } }
        public static event Action activeRenderPipelineCreated { add { } remove { } }
        public static event Action activeRenderPipelineDisposed { add { } remove { } }
    }

    public sealed class GraphicsSettings : Object
    {
        GraphicsSettings() { }
        public static RenderPipelineAsset currentRenderPipeline => null;
        public static RenderPipelineAsset defaultRenderPipeline { get => null; set { } }
        public static bool lightsUseLinearIntensity { get; set; }
        public static bool lightsUseColorTemperature { get; set; }
        public static bool useScriptableRenderPipelineBatching { get; set; }
        public static TransparencySortMode transparencySortMode { get; set; }
        public static Vector3 transparencySortAxis { get; set; } = Vector3.forward;
    }
}
