using System;
using System.Collections.Generic;
using Unity.Collections;

namespace UnityEngine.Rendering
{
    /// <summary>While one is set in <see cref="GraphicsSettings"/> or <see cref="QualitySettings"/>, its pipeline draws the cameras; else
    /// the Built-in one does.</summary>
    public abstract class RenderPipelineAsset : ScriptableObject
    {
        protected abstract RenderPipeline CreatePipeline();
        protected virtual void OnValidate() { }
        protected virtual void OnDisable() { }

        internal RenderPipeline Create() => CreatePipeline();
    }

    public abstract class RenderPipeline
    {
        public bool disposed { get; private set; }

        protected abstract void Render(ScriptableRenderContext context, Camera[] cameras);
        protected virtual void Render(ScriptableRenderContext context, List<Camera> cameras) => Render(context, cameras.ToArray());
        protected virtual void Dispose(bool disposing) { }

        protected static void BeginContextRendering(ScriptableRenderContext context, List<Camera> cameras)
            => RenderPipelineManager.RaiseBegin(context, cameras);
        protected static void EndContextRendering(ScriptableRenderContext context, List<Camera> cameras)
            => RenderPipelineManager.RaiseEnd(context, cameras);
        protected static void BeginCameraRendering(ScriptableRenderContext context, Camera camera)
            => RenderPipelineManager.RaiseBegin(context, camera);
        protected static void EndCameraRendering(ScriptableRenderContext context, Camera camera) => RenderPipelineManager.RaiseEnd(context, camera);

        internal void RenderCameras(List<Camera> cameras) => Render(default, cameras);

        internal void DisposeOnce()
        {
            if (disposed)
                return;
            disposed = true;
            Dispose(true);
        }
    }

    /// <summary>Unity keeps commands until Submit; here they run when they are handed over, which is the same order.</summary>
    public struct ScriptableRenderContext : IEquatable<ScriptableRenderContext>
    {
        public void ExecuteCommandBuffer(CommandBuffer commandBuffer)
        {
            if (commandBuffer == null)
                throw new ArgumentNullException(nameof(commandBuffer));
            commandBuffer.Execute();
        }

        public void Submit() { }

        public bool Equals(ScriptableRenderContext other) => true;
        public override bool Equals(object obj) => obj is ScriptableRenderContext;
        public override int GetHashCode() => 0;
    }

    /// <summary>Results of culling for a camera: the directional lights.</summary>
    public struct CullingResults : IEquatable<CullingResults>
    {
        NativeArray<VisibleLight> lights;

        public NativeArray<VisibleLight> visibleLights => lights;

        internal static CullingResults OfScene()
        {
            IReadOnlyList<Light> directional = Light.Directional();
            var lights = new NativeArray<VisibleLight>(directional.Count, Allocator.Temp);
            for (int i = 0; i < directional.Count; i++)
                lights[i] = new VisibleLight { lightType = LightType.Directional, finalColor = directional[i].FinalColor,
                    localToWorldMatrix = directional[i].transform.localToWorldMatrix, Id = directional[i].GetInstanceID() };
            return new CullingResults { lights = lights };
        }

        public bool Equals(CullingResults other) => lights.Equals(other.lights);
        public override bool Equals(object obj) => obj is CullingResults other && Equals(other);
        public override int GetHashCode() => lights.GetHashCode();
    }

    public struct VisibleLight : IEquatable<VisibleLight>
    {
        public LightType lightType { get; set; }
        public Color finalColor { get; set; }
        public Matrix4x4 localToWorldMatrix { get; set; }
        public Light light => Light.Find(Id);
        internal int Id;

        public bool Equals(VisibleLight other) => lightType == other.lightType && finalColor.Equals(other.finalColor)
            && localToWorldMatrix.Equals(other.localToWorldMatrix);
        public override bool Equals(object obj) => obj is VisibleLight other && Equals(other);
        public override int GetHashCode() => localToWorldMatrix.GetHashCode();
    }

    public static class RenderPipelineManager
    {
        static RenderPipelineAsset asset;
        static RenderPipeline pipeline;

        public static RenderPipeline currentPipeline => pipeline;

        // Scriptable pipelines raise these; the built-in one never does. What a listener throws ends the frame, as in Unity
        // (UnityCsReference, RenderPipelineManager.cs, 2022.3).
        public static event Action<ScriptableRenderContext, Camera> beginCameraRendering, endCameraRendering;
        public static event Action<ScriptableRenderContext, List<Camera>> beginContextRendering, endContextRendering;
        public static event Action activeRenderPipelineTypeChanged, activeRenderPipelineCreated, activeRenderPipelineDisposed;

        /// <summary>The pipeline of the asset that is set now; null for the Built-in one.</summary>
        internal static RenderPipeline Prepare()
        {
            RenderPipelineAsset wanted = GraphicsSettings.currentRenderPipeline;
            if (ReferenceEquals(wanted, asset) && (pipeline == null || !pipeline.disposed))
                return pipeline;
            Type before = pipeline?.GetType();
            if (pipeline != null)
            {
                pipeline.DisposeOnce();
                activeRenderPipelineDisposed?.Invoke();
            }
            asset = wanted;
            pipeline = wanted is object ? wanted.Create() : null;
            if (pipeline != null)
                activeRenderPipelineCreated?.Invoke();
            if (pipeline?.GetType() != before)
                activeRenderPipelineTypeChanged?.Invoke();
            return pipeline;
        }

        internal static void RaiseBegin(ScriptableRenderContext context, Camera camera) => beginCameraRendering?.Invoke(context, camera);
        internal static void RaiseEnd(ScriptableRenderContext context, Camera camera) => endCameraRendering?.Invoke(context, camera);
        internal static void RaiseBegin(ScriptableRenderContext context, List<Camera> cameras) => beginContextRendering?.Invoke(context, cameras);
        internal static void RaiseEnd(ScriptableRenderContext context, List<Camera> cameras) => endContextRendering?.Invoke(context, cameras);
    }

    public sealed class GraphicsSettings : Object
    {
        GraphicsSettings() { }
        public static RenderPipelineAsset currentRenderPipeline => QualitySettings.renderPipeline != null ? QualitySettings.renderPipeline
            : defaultRenderPipeline;
        public static RenderPipelineAsset defaultRenderPipeline { get; set; }
        public static bool lightsUseLinearIntensity { get; set; }
        public static bool lightsUseColorTemperature { get; set; }
        public static bool useScriptableRenderPipelineBatching { get; set; }
        public static TransparencySortMode transparencySortMode { get; set; }
        public static Vector3 transparencySortAxis { get; set; } = Vector3.forward;
    }
}
