using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Fluid surfaces in the Built-in pipeline: a command buffer of each camera before its transparent draws, filled as it begins
    /// to cull.</summary>
    static class BuiltInSurfaces
    {
        const CameraEvent Event = CameraEvent.BeforeForwardAlpha;

        static CameraParts<CameraBuffer> buffers = new CameraParts<CameraBuffer>();
        static ShadowCopy shadow;
        static bool hasSaidWhy;     // there is none

        /// <summary>When a surface begins.</summary>
        public static void Begin()
        {
            Camera.onPreCull -= Cull;
            Camera.onPreCull += Cull;
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
            buffers.Clear();
            buffers = new CameraParts<CameraBuffer>();
            shadow?.Dispose();
            shadow = null;
            hasSaidWhy = false;
        }

        public static void Describe(StageDescription stage) => shadow?.Describe(stage);

        static void Cull(Camera camera)
        {
            if (camera.cameraType == CameraType.Preview)
                return;
            FluidViews views = FluidViews.Of(camera);
            CameraBuffer buffer = buffers.Find(camera);
            buffer?.commands.Clear();
            bool isCopied = false;
            PrepareShadow();
            for (int i = 0; i < FluidSurface.Active.Count; i++)
            {
                FluidSurface surface = FluidSurface.Active[i];
                if (!surface.Prepare(views))
                    continue;
                if (buffer == null)
                    buffers.Add(buffer = new CameraBuffer(camera));
                buffer.AskForDepth();
                if (surface.Refraction && !isCopied)
                {
                    buffer.AskForOwnTarget();
                    CopyScene(buffer, views);
                    isCopied = true;
                }
                surface.Record(buffer.commands, views);
                surface.Submit(views, buffer.sceneColor, shadow);
            }
        }

        // Of one light, which is the main one for all.
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
            shadow.Begin();
        }

        // The opaque scene, for surfaces that refract. Before the first of them is recorded: that draws elsewhere.
        static void CopyScene(CameraBuffer buffer, in FluidViews views)
        {
            Prepare(ref buffer.sceneColor, views);
            if (views.eyes == 1)
                buffer.commands.Blit(BuiltinRenderTextureType.CameraTarget, buffer.sceneColor);
            else
                for (int eye = 0; eye < views.eyes; eye++)
                    buffer.commands.Blit(BuiltinRenderTextureType.CameraTarget, buffer.sceneColor, eye, eye);
        }

        static void Prepare(ref RenderTexture texture, in FluidViews views)
        {
            GraphicsFormat format = SystemInfo.GetGraphicsFormat(views.camera.allowHDR ? DefaultFormat.HDR : DefaultFormat.LDR);
            if (texture != null && texture.width == views.width && texture.height == views.height && texture.volumeDepth == views.eyes
                && texture.graphicsFormat == format)
                return;
            EngineObject.Release(ref texture);
            texture = GpuTexture.Create("Rill.Surface.SceneColor", new RenderTextureDescriptor(views.width, views.height, format, GraphicsFormat.None)
            {
                dimension = views.eyes > 1 ? TextureDimension.Tex2DArray : TextureDimension.Tex2D, volumeDepth = views.eyes,
            }, FilterMode.Bilinear);
        }

        sealed class CameraBuffer : ICameraPart
        {
            public readonly CommandBuffer commands = new CommandBuffer { name = "Rill.Surface" };
            public RenderTexture sceneColor;
            bool hasOurDepth, hasOurTarget;     // that nothing else asked for before

            public CameraBuffer(Camera camera)
            {
                Camera = camera;
                camera.AddCommandBuffer(Event, commands);
            }

            public Camera Camera { get; }
            public bool IsGone => Camera == null;

            public void AskForDepth()
            {
                if ((Camera.depthTextureMode & DepthTextureMode.Depth) != 0)
                    return;
                Camera.depthTextureMode |= DepthTextureMode.Depth;
                hasOurDepth = true;
            }

            // A copy of the back buffer is upside down where textures begin at the top, and that of a target that the camera draws a part of
            // holds the whole; forced into a texture, its target is its part.
            public void AskForOwnTarget()
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
                    if (hasOurDepth)
                        Camera.depthTextureMode &= ~DepthTextureMode.Depth;
                    if (hasOurTarget)
                        Camera.forceIntoRenderTexture = false;
                }
                commands.Dispose();
                EngineObject.Release(ref sceneColor);
            }
        }
    }
}
