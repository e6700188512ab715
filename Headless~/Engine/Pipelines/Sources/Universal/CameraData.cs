using UnityEngine.Experimental.Rendering;
#if SRP_17
using UnityEngine.Rendering.RenderGraphModule;
#endif

namespace UnityEngine.Rendering.Universal
{
#if SRP_17
    public class UniversalCameraData : ContextItem
    {
        public Camera camera, baseCamera;
        public CameraRenderType renderType;
        public CameraType cameraType;
        public RenderTexture targetTexture;
        public RenderTextureDescriptor cameraTargetDescriptor;
        public ScriptableRenderer renderer;
        public AntialiasingMode antialiasing;
        public float renderScale;
        public bool clearDepth, resolveFinalTarget, postProcessEnabled;

        internal CameraMatrices matrices;

        public XRPass xr { get; internal set; }
        public bool isSceneViewCamera => cameraType == CameraType.SceneView;
        public bool isPreviewCamera => cameraType == CameraType.Preview;

        /// <summary>Returns the view matrix, as Camera.worldToCameraMatrix does.</summary>
        public Matrix4x4 GetViewMatrix(int viewIndex = 0) => matrices.View(viewIndex);

        /// <summary>Returns the projection, as Camera.projectionMatrix does, with the jitter of this frame.</summary>
        public Matrix4x4 GetProjectionMatrix(int viewIndex = 0) => matrices.Projection(viewIndex);

        public override void Reset()
        {
            camera = baseCamera = null;
            renderer = null;
            targetTexture = null;
            xr = null;
        }
    }

    /// <summary>The frame's data under the names of older versions.</summary>
    public struct CameraData
    {
        internal UniversalCameraData data;

        public ref Camera camera => ref data.camera;
        public ref Camera baseCamera => ref data.baseCamera;
        public ref CameraRenderType renderType => ref data.renderType;
        public ref CameraType cameraType => ref data.cameraType;
        public ref RenderTexture targetTexture => ref data.targetTexture;
        public ref RenderTextureDescriptor cameraTargetDescriptor => ref data.cameraTargetDescriptor;
        public ref ScriptableRenderer renderer => ref data.renderer;
        public ref AntialiasingMode antialiasing => ref data.antialiasing;
        public ref float renderScale => ref data.renderScale;
        public ref bool resolveFinalTarget => ref data.resolveFinalTarget;
        public XRPass xr => data.xr;
        public bool isSceneViewCamera => data.isSceneViewCamera;
        public bool isPreviewCamera => data.isPreviewCamera;
        public Matrix4x4 GetViewMatrix(int viewIndex = 0) => data.GetViewMatrix(viewIndex);
        public Matrix4x4 GetProjectionMatrix(int viewIndex = 0) => data.GetProjectionMatrix(viewIndex);
    }

    public struct RenderingData
    {
        internal ContextContainer frameData;
        public CameraData cameraData;
    }

    public class UniversalResourceDataBase : ContextItem
    {
        public override void Reset() { }
    }

    /// <summary>Resources that were not made in this frame are not valid handles.</summary>
    public class UniversalResourceData : UniversalResourceDataBase
    {
        public TextureHandle activeColorTexture => cameraColor;
        public TextureHandle activeDepthTexture => cameraDepth;
        public TextureHandle cameraColor { get; set; }
        public TextureHandle cameraDepth { get; set; }
        public TextureHandle cameraDepthTexture { get; internal set; }
        public TextureHandle cameraOpaqueTexture { get; internal set; }
        public TextureHandle motionVectorColor { get; set; }
        public TextureHandle motionVectorDepth { get; set; }

        public override void Reset() => cameraColor = cameraDepth = cameraDepthTexture = cameraOpaqueTexture = motionVectorColor =
            motionVectorDepth = TextureHandle.nullHandle;
    }
#else
    public struct CameraData
    {
        public Camera camera, baseCamera;
        public CameraRenderType renderType;
        public CameraType cameraType;
        public RenderTexture targetTexture;
        public RenderTextureDescriptor cameraTargetDescriptor;
        public ScriptableRenderer renderer;
        public AntialiasingMode antialiasing;
        public float renderScale;
        public bool clearDepth, resolveFinalTarget, postProcessEnabled;

        internal CameraMatrices matrices;

        public XRPass xr { get; internal set; }
        public bool isSceneViewCamera => cameraType == CameraType.SceneView;
        public bool isPreviewCamera => cameraType == CameraType.Preview;
        public Matrix4x4 GetViewMatrix(int viewIndex = 0) => matrices.View(viewIndex);
        public Matrix4x4 GetProjectionMatrix(int viewIndex = 0) => matrices.Projection(viewIndex);
    }

    public struct RenderingData
    {
        public CameraData cameraData;
    }
#endif

    /// <summary>Matrices of one eye, or of those of a headset.</summary>
    internal struct CameraMatrices
    {
        public Matrix4x4 view, projection, jitter;
        public XRPass xr;

        public Matrix4x4 View(int index) => xr.enabled ? xr.GetViewMatrix(index) : view;
        public Matrix4x4 Projection(int index) => jitter * ProjectionNoJitter(index);
        public Matrix4x4 ProjectionNoJitter(int index) => xr.enabled ? xr.GetProjMatrix(index) : projection;
    }
}
