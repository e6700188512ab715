using System;
using UnityEngine;

namespace Rill
{
    /// <summary>Whether anything of a fluid's surface can be seen in a frame, before the frame's steps: its box, or the path of its shadow.</summary>
    sealed class SurfaceWatch
    {
        static Camera[] cameras = Array.Empty<Camera>();

        int seenFrame = -2;

        /// <summary>A camera sees it in this frame, known to <see cref="IsSeen"/> or not (the scene view's, a probe's): the next frame has
        /// the surface too.</summary>
        public void See() => seenFrame = Time.frameCount;

        /// <summary>Allocates no managed memory while the number of cameras does not grow.</summary>
        /// <param name="layer">Layer of the fluid.</param>
        /// <param name="box">Box of the fluid.</param>
        /// <param name="shadow">World, m: how far its shadow reaches, along the light; zero where it casts none.</param>
        public bool IsSeen(int layer, in FluidBox box, Vector3 shadow)
        {
            if (Time.frameCount - seenFrame <= 1)
                return true;
            if (cameras.Length < Camera.allCamerasCount)
                cameras = new Camera[Camera.allCamerasCount];
            int count = Camera.GetAllCameras(cameras);
            bool isSeen = false;
            for (int i = 0; i < count && !isSeen; i++)
            {
                if ((cameras[i].cullingMask & (1 << layer)) == 0)
                    continue;
                isSeen = BoxOnPicture.Of(FluidViews.Of(cameras[i]), box, shadow).IsSeen;
            }
            Array.Clear(cameras, 0, count);
            return isSeen;
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        static void Reset() => cameras = Array.Empty<Camera>();
    }
}
