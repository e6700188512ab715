using System;
using System.Collections.Generic;
#if SRP_17
using UnityEngine.Rendering.RenderGraphModule;
#endif

namespace UnityEngine.Rendering.Universal
{
    /// <summary>Passes of a camera by event; those of the same event in the order in which they came. Read in URP 17.1.0,
    /// Runtime/ScriptableRenderer.cs.</summary>
    public abstract class ScriptableRenderer : IDisposable
    {
        readonly List<ScriptableRenderPass> queue = new List<ScriptableRenderPass>();
        readonly List<ScriptableRendererFeature> features = new List<ScriptableRendererFeature>();
        RTHandle color, depth;
        bool isExecuting;

        public ScriptableRenderer(ScriptableRendererData data)
        {
            foreach (ScriptableRendererFeature feature in data.rendererFeatures)
            {
                if (feature == null)
                    continue;
                feature.Create();
                features.Add(feature);
            }
        }

        protected internal List<ScriptableRenderPass> activeRenderPassQueue => queue;
        protected internal List<ScriptableRendererFeature> rendererFeatures => features;

        public void EnqueuePass(ScriptableRenderPass pass) => queue.Add(pass);

#if SRP_17
        [Obsolete(ScriptableRenderPass.Compatibility, false)]
        public RTHandle cameraColorTargetHandle => InPass(color);

        [Obsolete(ScriptableRenderPass.Compatibility, false)]
        public RTHandle cameraDepthTargetHandle => InPass(depth);
#else
        public RTHandle cameraColorTargetHandle => InPass(color);
        public RTHandle cameraDepthTargetHandle => InPass(depth);
#endif

        RTHandle InPass(RTHandle target)
        {
            if (isExecuting)
                return target;
            Debug.LogError("You can only call cameraColorTargetHandle inside the scope of a ScriptableRenderPass. Otherwise the " +
                "pipeline camera target texture might have not been created or might have already been disposed.");
            return null;
        }

        internal void SetTargets(RTHandle color, RTHandle depth)
        {
            this.color = color;
            this.depth = depth;
            isExecuting = color != null;
        }

        /// <summary>Before the camera is culled: what features submit now is seen by it.</summary>
        internal void OnPreCullRenderPasses(Camera camera)
        {
#if SRP_17
            var data = new CameraData { data = new UniversalCameraData { camera = camera, renderer = this } };
#else
            var data = new CameraData { camera = camera, renderer = this };
#endif
            foreach (ScriptableRendererFeature feature in features)
                if (feature.isActive)
                    feature.OnCameraPreCull(this, data);
        }

        internal void AddRenderPasses(ref RenderingData data)
        {
            foreach (ScriptableRendererFeature feature in features)
                if (feature.isActive)
                    feature.AddRenderPasses(this, ref data);
            queue.RemoveAll(pass => pass == null);
        }

        internal void SortPasses()
        {
            for (int i = 1; i < queue.Count; i++)
                for (int k = i; k > 0 && queue[k].renderPassEvent < queue[k - 1].renderPassEvent; k--)
                    (queue[k], queue[k - 1]) = (queue[k - 1], queue[k]);
        }

        /// <summary>The only place where the queue is emptied: a camera that is not culled never comes here.</summary>
        internal void FinishRendering()
        {
            var cmd = CommandBufferPool.Get();
            foreach (ScriptableRenderPass pass in queue)
                pass.OnCameraCleanup(cmd);
            cmd.Execute();
            CommandBufferPool.Release(cmd);
            queue.Clear();
            SetTargets(null, null);
        }

        public void Dispose()
        {
            foreach (ScriptableRendererFeature feature in features)
                if (feature != null)
                    feature.Dispose();
            Dispose(true);
        }

        protected virtual void Dispose(bool disposing) { }
    }
}
