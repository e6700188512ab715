using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Fluid surfaces in the Built-in pipeline: their draws are submitted as a camera begins to cull, and a command buffer of its own
    /// before its transparent draws is filled as it begins to draw: only then are its matrices what scripts make of them.</summary>
    /// <remarks>A camera that is drawn from inside of another's callbacks comes in between, which is why nothing here is of one camera
    /// alone.</remarks>
    static class BuiltInSurfaces
    {
        const CameraEvent Event = CameraEvent.BeforeForwardAlpha;

        const int FramesKept = 3;       // for which a camera may see no surface
        const int Patience = 60;        // frames until a copy of another size than the picture's is made again

        static CameraParts<CameraBuffer> buffers = new CameraParts<CameraBuffer>();
        static ShadowCopy shadow;
        static bool hasSaidWhy;     // there is none

        /// <summary>When a surface begins.</summary>
        public static void Begin()
        {
            Camera.onPreCull -= Cull;
            Camera.onPreCull += Cull;
            Camera.onPreRender -= Render;
            Camera.onPreRender += Render;
        }

        /// <summary>When a surface has ended: after the last, cameras are as they were.</summary>
        public static void End()
        {
            if (FluidSurface.Active.Count == 0)
                Reset();
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        static void Reset()
        {
            Camera.onPreCull -= Cull;
            Camera.onPreRender -= Render;
            buffers.Clear();
            buffers = new CameraParts<CameraBuffer>();
            shadow?.Dispose();
            shadow = null;
            hasSaidWhy = false;
        }

        /// <summary>Once a frame: gives back the copies of cameras that have not seen a surface lately.</summary>
        public static void ReleaseUnused()
        {
            buffers.RemoveGone();
            for (int i = 0; i < buffers.Count; i++)
                buffers[i].ReleaseUnused();
        }

        public static void Describe(StageDescription stage) => shadow?.Describe(stage);

        static void Cull(Camera camera)
        {
            if (camera.cameraType == CameraType.Preview)
                return;
            CameraBuffer buffer = buffers.Find(camera);
            FluidViews views = ViewsOf(camera, buffer);
            PrepareShadow();
            for (int i = 0; i < FluidSurface.Active.Count; i++)
            {
                FluidSurface surface = FluidSurface.Active[i];
                if (!surface.Prepare(views))
                    continue;
                if (buffer == null)
                    buffers.Add(buffer = new CameraBuffer(camera));
                buffer.RequestDepth();
                if (surface.Refraction)
                {
                    buffer.RequestOwnTarget();
                    buffer.PrepareSceneColor(views);
                }
                surface.Submit(views, buffer.sceneColor, shadow);
            }
        }

        static void Render(Camera camera)
        {
            shadow?.Turn(SeesAny(camera));
            CameraBuffer buffer = buffers.Find(camera);
            if (buffer == null)
                return;
            buffer.commands.Clear();
            buffer.beforeShadows.Clear();
            shadow?.Begin(buffer.beforeShadows);
            FluidViews views = ViewsOf(camera, buffer);
            bool isCopied = false;
            for (int i = 0; i < FluidSurface.Active.Count; i++)
            {
                FluidSurface surface = FluidSurface.Active[i];
                if (!surface.IsPreparedFor(camera))
                    continue;
                if (surface.Refraction && !isCopied)
                    CopyScene(buffer, views);
                isCopied |= surface.Refraction;
                surface.Record(buffer.commands, views, shadow);
            }
        }

        static bool SeesAny(Camera camera)
        {
            for (int i = 0; i < FluidSurface.Active.Count; i++)
                if (FluidSurface.Active[i].IsPreparedFor(camera))
                    return true;
            return false;
        }

        // With a headset the active eye is the left one, but for the second of two passes (multi-pass): from that one on, each has one eye.
        static FluidViews ViewsOf(Camera camera, CameraBuffer buffer)
        {
            FluidViews views = FluidViews.Of(camera);
            if (views.eyes == 1 || buffer == null)
                return views;
            bool isRight = camera.stereoActiveEye == Camera.MonoOrStereoscopicEye.Right;
            buffer.isMultiPass |= isRight;
            if (buffer.isMultiPass)
                views.KeepEye(isRight ? 1 : 0);
            return views;
        }

        // Prepares the shadow of one light, which is the main one for all.
        static void PrepareShadow()
        {
            Light light = null;
            FluidSurface receiver = null;
            for (int i = 0; i < FluidSurface.Active.Count && light == null; i++)
            {
                receiver = FluidSurface.Active[i];
                light = receiver.ReceiveShadows ? receiver.KnownLight : null;
            }
            if (light != null && (light.type != LightType.Directional || light.shadows == LightShadows.None))
                light = null;
            if (light != null && shadow == null && ShadowCopy.DeviceProblem is string why)
            {
                if (!hasSaidWhy)
                    Debug.LogWarning($"Rill: no shadow falls on fluid surfaces: {why}. Turn Receive Shadows of Fluid Surface '{receiver.name}' off " +
                        $"there.", receiver);
                hasSaidWhy = true;
                light = null;
            }
            if (shadow != null && !shadow.IsOf(light))
            {
                shadow.Dispose();
                shadow = null;
            }
            if (light == null)
                return;
            shadow ??= new ShadowCopy(light);
        }

        // The opaque scene, for surfaces that refract. Before the first of them is recorded: that draws elsewhere.
        static void CopyScene(CameraBuffer buffer, in FluidViews views)
        {
            if (views.eyes == 1)
                buffer.commands.Blit(BuiltinRenderTextureType.CameraTarget, buffer.sceneColor);
            else
                for (int eye = 0; eye < views.eyes; eye++)
                    buffer.commands.Blit(BuiltinRenderTextureType.CameraTarget, buffer.sceneColor, eye, eye);
        }

        sealed class CameraBuffer : ICameraPart
        {
            public readonly CommandBuffer commands = new CommandBuffer { name = "Rill.Surface" },
                beforeShadows = new CommandBuffer { name = "Rill.Surface.Shadow" };
            public RenderTexture sceneColor;
            public bool isMultiPass;
            bool hasOurDepth, hasOurTarget;     // that nothing else asked for before
            int width, height, steadySince, lastFrame;

            public CameraBuffer(Camera camera)
            {
                Camera = camera;
                camera.AddCommandBuffer(Event, commands);
                camera.AddCommandBuffer(CameraEvent.BeforeDepthTexture, beforeShadows);
                camera.AddCommandBuffer(CameraEvent.BeforeGBuffer, beforeShadows);      // where it draws deferred
            }

            public Camera Camera { get; }
            public bool IsGone => Camera == null;

            /// <summary>For this frame. While the picture's size changes from frame to frame it is the largest, into which the picture is
            /// stretched; of the picture's own size once that has stayed for a while.</summary>
            public void PrepareSceneColor(in FluidViews views)
            {
                bool isFirst = lastFrame != Time.frameCount;
                lastFrame = Time.frameCount;
                if (views.width != width || views.height != height)
                    steadySince = Time.frameCount;
                (width, height) = (views.width, views.height);
                GraphicsFormat format = SystemInfo.GetGraphicsFormat(views.camera.allowHDR ? DefaultFormat.HDR : DefaultFormat.LDR);
                int madeWidth = width, madeHeight = height;
                if (sceneColor != null && sceneColor.volumeDepth == views.eyes && sceneColor.graphicsFormat == format)
                {
                    bool isLarge = sceneColor.width >= width && sceneColor.height >= height;
                    bool isExact = sceneColor.width == width && sceneColor.height == height;
                    if (isLarge && (isExact || !isFirst || Time.frameCount - steadySince < Patience))
                        return;
                    if (!isLarge)
                        (madeWidth, madeHeight) = (Mathf.Max(width, sceneColor.width), Mathf.Max(height, sceneColor.height));
                }
                EngineObject.Release(ref sceneColor);
                var description = new RenderTextureDescriptor(madeWidth, madeHeight, format, GraphicsFormat.None)
                {
                    dimension = views.eyes > 1 ? TextureDimension.Tex2DArray : TextureDimension.Tex2D, volumeDepth = views.eyes,
                };
                sceneColor = GpuTexture.Create("Rill.Surface.SceneColor", description, FilterMode.Bilinear);
            }

            public void ReleaseUnused()
            {
                if (Time.frameCount - lastFrame > FramesKept)
                    EngineObject.Release(ref sceneColor);
            }

            public void RequestDepth()
            {
                if ((Camera.depthTextureMode & DepthTextureMode.Depth) != 0)
                    return;
                Camera.depthTextureMode |= DepthTextureMode.Depth;
                hasOurDepth = true;
            }

            // A copy of the back buffer is upside down where textures begin at the top, and that of a target that the camera draws a part of
            // holds the whole; forced into a texture, its target is its part.
            public void RequestOwnTarget()
            {
                bool hasOne = Camera.targetTexture != null && Camera.rect == new Rect(0f, 0f, 1f, 1f);
                // The scene would store it in edit mode, where cameras draw into textures of the editor.
                if (Camera.forceIntoRenderTexture || hasOne || !Application.isPlaying)
                    return;
                Camera.forceIntoRenderTexture = true;
                hasOurTarget = true;
            }

            public void Dispose()
            {
                if (Camera != null)
                {
                    Camera.RemoveCommandBuffer(Event, commands);
                    Camera.RemoveCommandBuffer(CameraEvent.BeforeDepthTexture, beforeShadows);
                    Camera.RemoveCommandBuffer(CameraEvent.BeforeGBuffer, beforeShadows);
                    if (hasOurDepth)
                        Camera.depthTextureMode &= ~DepthTextureMode.Depth;
                    if (hasOurTarget)
                        Camera.forceIntoRenderTexture = false;
                }
                commands.Dispose();
                beforeShadows.Dispose();
                EngineObject.Release(ref sceneColor);
            }
        }
    }
}
