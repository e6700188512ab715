using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Wet surfaces in the Built-in pipeline: a command buffer of each camera after its opaque objects, before the sky and before the copy
    /// of the scene that water refracts.</summary>
    static class BuiltInWetness
    {
        const CameraEvent Event = CameraEvent.AfterForwardOpaque;
        const int FramesKept = 3;       // for which a camera may see nothing wet

        static CameraParts<CameraBuffer> buffers = new CameraParts<CameraBuffer>();

        /// <summary>When the first wetness begins.</summary>
        public static void Begin()
        {
            Camera.onPreCull -= Cull;
            Camera.onPreCull += Cull;
            Camera.onPreRender -= Render;
            Camera.onPreRender += Render;
        }

        /// <summary>When a wetness has ended: after the last, cameras are as they were.</summary>
        public static void End()
        {
            if (FluidWetness.Active.Count == 0)
                Reset();
        }

        /// <summary>Once a frame: cameras that have not seen anything wet lately are as they were.</summary>
        public static void ReleaseUnused() => buffers.RemoveGone();

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        static void Reset()
        {
            Camera.onPreCull -= Cull;
            Camera.onPreRender -= Render;
            buffers.Clear();
            buffers = new CameraParts<CameraBuffer>();
        }

        static void Cull(Camera camera)
        {
            if (camera.cameraType == CameraType.Preview)
                return;
            CameraBuffer buffer = buffers.Find(camera);
            FluidViews views = ViewsOf(camera, buffer);
            bool isAnySeen = false;
            for (int i = 0; i < FluidWetness.Active.Count; i++)
                isAnySeen |= FluidWetness.Active[i].Prepare(views);
            if (!isAnySeen)
                return;
            if (buffer == null)
                buffers.Add(buffer = new CameraBuffer(camera));
            buffer.RequestDepth();
        }

        // Only now are the camera's matrices what scripts make of them.
        static void Render(Camera camera)
        {
            CameraBuffer buffer = buffers.Find(camera);
            if (buffer == null)
                return;
            buffer.Commands.Clear();
            FluidViews views = ViewsOf(camera, buffer);
            for (int i = 0; i < FluidWetness.Active.Count; i++)
                FluidWetness.Active[i].Record(buffer.Commands, views);
        }

        // With a headset the active eye is the left one, but for the second of two passes (multi-pass): from that one on, each has one eye.
        static FluidViews ViewsOf(Camera camera, CameraBuffer buffer)
        {
            FluidViews views = FluidViews.Of(camera);
            if (views.eyes == 1 || buffer == null)
                return views;
            bool isRight = camera.stereoActiveEye == Camera.MonoOrStereoscopicEye.Right;
            buffer.IsMultiPass |= isRight;
            if (buffer.IsMultiPass)
                views.KeepEye(isRight ? 1 : 0);
            return views;
        }

        sealed class CameraBuffer : ICameraPart
        {
            public readonly CommandBuffer Commands = new CommandBuffer { name = "Rill.Wetness.Draw" };
            public bool IsMultiPass;
            bool hasOurDepth;       // that nothing else asked for before
            int lastFrame;

            public CameraBuffer(Camera camera)
            {
                Camera = camera;
                camera.AddCommandBuffer(Event, Commands);
            }

            public Camera Camera { get; }
            public bool IsGone => Camera == null || Time.frameCount - lastFrame > FramesKept;

            public void RequestDepth()
            {
                lastFrame = Time.frameCount;
                if ((Camera.depthTextureMode & DepthTextureMode.Depth) != 0)
                    return;
                Camera.depthTextureMode |= DepthTextureMode.Depth;
                hasOurDepth = true;
            }

            public void Dispose()
            {
                if (Camera != null)
                {
                    Camera.RemoveCommandBuffer(Event, Commands);
                    if (hasOurDepth)
                        Camera.depthTextureMode &= ~DepthTextureMode.Depth;
                }
                Commands.Dispose();
            }
        }
    }
}
