using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace Rill.Universal
{
    /// <summary>A pass of the package's for one camera.</summary>
    /// <remarks>
    /// Each camera has its own: one may be drawn from inside of another. URP leaves it in the queue of a renderer where a camera was not
    /// culled, and runs it there for whatever camera comes next, so it does its work once, and only for its own.
    /// </remarks>
    abstract class CameraPass : ScriptableRenderPass, ICameraPart
    {
        protected FluidViews views;
        ScriptableRenderer renderer, queue;     // what draws the camera, and in whose queue it is

        protected CameraPass(Camera camera) => Camera = camera;

        public Camera Camera { get; }
        public bool IsGone => Camera == null;

        /// <summary>Whether the camera's picture is to be recorded yet.</summary>
        public bool IsReady { get; private set; }

        /// <summary>Whether the camera's renderer has it in its queue.</summary>
        public bool IsEnqueued => ReferenceEquals(queue, renderer);

        /// <summary>For the picture that the camera draws now.</summary>
        public virtual void Prepare(in FluidViews camera, ScriptableRenderer drawing)
        {
            views = camera;
            renderer = drawing;
            IsReady = true;
        }

        /// <summary>Puts it into the queue where it is ready and not there yet.</summary>
        public void Enqueue()
        {
            if (!IsReady || IsEnqueued)
                return;
            queue = renderer;
            renderer.EnqueuePass(this);
        }

        /// <summary>URP empties the queue after this, whichever camera has been drawn.</summary>
        public override void OnCameraCleanup(CommandBuffer cmd) => queue = null;

        /// <summary>The camera has been drawn, or has not been culled.</summary>
        public void Invalidate() => IsReady = false;

        public void Dispose() => Invalidate();

        /// <summary>Returns whether it has work to do for the camera that is drawn: once for each picture.</summary>
        protected bool Begin(Camera drawn)
        {
            if (!ReferenceEquals(drawn, Camera))
            {
                UniversalSurfaces.Notice(drawn);
                return false;
            }
            bool isReady = IsReady;
            IsReady = false;
            return isReady;
        }

        /// <summary>In two passes, one after the other, URP draws one eye in each.</summary>
        protected void SetEyes(XRPass xr)
        {
            views.eyes = xr.enabled ? Mathf.Min(xr.viewCount, views.eyes) : 1;
            views.sceneIsArray = xr.singlePassEnabled;
        }
    }
}
