using System;
using System.Collections.Generic;

namespace UnityEngine.Rendering.Universal
{
    public abstract class ScriptableRendererData : ScriptableObject
    {
        readonly List<ScriptableRendererFeature> features = new List<ScriptableRendererFeature>();

        public List<ScriptableRendererFeature> rendererFeatures => features;

        protected abstract ScriptableRenderer Create();

        internal ScriptableRenderer InternalCreate() => Create();

        /// <summary>A changed renderer is made again (URP 17.1.0, Runtime/ScriptableRendererData.cs).</summary>
        public void SetDirty()
        {
            if (UniversalRenderPipeline.asset is UniversalRenderPipelineAsset asset && Array.IndexOf(asset.m_RendererDataList, this) >= 0)
                asset.DestroyRenderers();
        }
    }

    public class UniversalRendererData : ScriptableRendererData
    {
        public bool shadowTransparentReceive { get; set; } = true;
        public LayerMask opaqueLayerMask { get; set; } = -1;
        public LayerMask transparentLayerMask { get; set; } = -1;

        protected override ScriptableRenderer Create() => new UniversalRenderer(this);
    }

    [AttributeUsage(AttributeTargets.Class, AllowMultiple = false)]
    public class DisallowMultipleRendererFeature : Attribute
    {
        public string customTitle { get; }

        public DisallowMultipleRendererFeature(string customTitle = null) => this.customTitle = customTitle;
    }

    public abstract class ScriptableRendererFeature : ScriptableObject, IDisposable
    {
        bool active = true;

        public bool isActive => active;
        public void SetActive(bool active) => this.active = active;

        public abstract void Create();
        public abstract void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData);
        public virtual void OnCameraPreCull(ScriptableRenderer renderer, in CameraData cameraData) { }

        public void Dispose() => Dispose(true);
        protected virtual void Dispose(bool disposing) { }
    }
}
