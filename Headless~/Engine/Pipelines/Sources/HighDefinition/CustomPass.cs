using System;
using System.Collections.Generic;

namespace UnityEngine.Rendering.HighDefinition
{
    public enum CustomPassInjectionPoint
    {
        BeforeRendering = 0,
        BeforeTransparent = 1,
        BeforePostProcess = 2,
        AfterPostProcess = 3,
        BeforePreRefraction = 4,
        AfterOpaqueDepthAndNormal = 5,
    }

    public struct CustomPassContext
    {
        public readonly ScriptableRenderContext renderContext;
        public readonly CommandBuffer cmd;
        public readonly HDCamera hdCamera;
        public readonly CullingResults cameraCullingResults;
        public readonly RTHandle cameraColorBuffer, cameraDepthBuffer, cameraMotionVectorsBuffer;

        internal CustomPassContext(ScriptableRenderContext context, CommandBuffer cmd, HDCamera camera, CullingResults culled,
            RTHandle color, RTHandle depth, RTHandle motion)
        {
            (renderContext, this.cmd, hdCamera, cameraCullingResults, cameraColorBuffer, cameraDepthBuffer, cameraMotionVectorsBuffer) =
                (context, cmd, camera, culled, color, depth, motion);
        }
    }

    /// <summary>Set up before it first runs, cleaned up when its volume ends. HDRP 16.0,
    /// Runtime/RenderPipeline/RenderPass/CustomPass/CustomPass.cs.</summary>
    [Serializable]
    public abstract class CustomPass
    {
        public enum TargetBuffer { Camera, Custom, None }

        bool isSetUp;

        public string name { get; set; } = "Custom Pass";
        public bool enabled = true;
        public TargetBuffer targetColorBuffer, targetDepthBuffer;

        protected virtual bool executeInSceneView => true;

        protected virtual void Setup(ScriptableRenderContext renderContext, CommandBuffer cmd) { }
        protected virtual void Execute(CustomPassContext ctx) { }
        protected virtual void Cleanup() { }

        internal bool WillBeExecuted(Camera camera) => enabled && (camera.cameraType != CameraType.SceneView || executeInSceneView);

        internal void Run(in CustomPassContext context)
        {
            if (!isSetUp)
            {
                Setup(context.renderContext, context.cmd);
                isSetUp = true;
            }
            Execute(context);
        }

        internal void CleanUp()
        {
            if (isSetUp)
                Cleanup();
            isSetUp = false;
        }
    }

    /// <summary>
    /// Passes that run at one point of a camera's frame: of every camera whose volume layer mask holds the object's layer, or of the target
    /// camera alone, whatever its masks. HDRP 16.0, CustomPassVolume.cs (IsVisible, Update). Local volumes are not here.
    /// </summary>
    [ExecuteAlways]
    public class CustomPassVolume : MonoBehaviour
    {
        static readonly List<CustomPassVolume> active = new List<CustomPassVolume>();

        public float priority;
        public List<CustomPass> customPasses = new List<CustomPass>();
        public CustomPassInjectionPoint injectionPoint = CustomPassInjectionPoint.BeforeTransparent;

        public bool isGlobal { get; set; } = true;
        public Camera targetCamera { get; set; }

        void OnEnable() => active.Add(this);

        void OnDisable()
        {
            active.Remove(this);
            foreach (CustomPass pass in customPasses)
                pass.CleanUp();
        }

        /// <summary>Those of a camera, the highest priority first.</summary>
        internal static List<CustomPassVolume> Of(Camera camera, CustomPassInjectionPoint point)
        {
            List<CustomPassVolume> found = active.FindAll(volume => volume.injectionPoint == point
                && (volume.targetCamera == null ? volume.isGlobal : volume.targetCamera == camera));
            found.Sort((a, b) => b.priority.CompareTo(a.priority));
            return found;
        }
    }
}
