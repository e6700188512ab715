using System;
using UnityEngine;

namespace Rill
{
    /// <summary>Whether a camera draws two eyes in one pass by instancing, for which an indirect draw needs two instances.</summary>
    /// <remarks>
    /// Unity multiplies the instances of other draws, not those of indirect ones (CommandBuffer.SetInstanceMultiplier). Multiview,
    /// which Android's single pass is, runs the vertex program for each eye and needs one instance. Where two are drawn for nothing
    /// (two eyes in two passes, the editor's scene view beside a headset), the shaders draw the second outside.
    /// </remarks>
    static class StereoInstancing
    {
        /// <summary>first command of a draw of one instance, in a buffer of <see cref="GpuBuffer.Arguments"/></summary>
        [GenerateHlsl("Arguments")] public const int MonoCommand = 0;

        /// <summary>and of two, one for each eye</summary>
        [GenerateHlsl("Arguments")] public const int StereoCommand = 2;

        static Camera[] cameras = Array.Empty<Camera>();
        static int frame = -1;
        static bool isActive;

        /// <summary>In this frame. Allocates only when there are more cameras than ever before.</summary>
        public static bool IsActive
        {
            get
            {
                if (frame == Time.frameCount)
                    return isActive;
                frame = Time.frameCount;
                return isActive = Application.platform != RuntimePlatform.Android && AnyCameraIsStereo();
            }
        }

        static bool AnyCameraIsStereo()
        {
            int count = Camera.allCamerasCount;
            if (cameras.Length < count)
                cameras = new Camera[count];
            count = Camera.GetAllCameras(cameras);
            bool any = false;
            for (int i = 0; i < count; i++)
                any |= cameras[i].stereoEnabled;
            Array.Clear(cameras, 0, count);
            return any;
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        static void Reset()
        {
            cameras = Array.Empty<Camera>();
            frame = -1;
            isActive = false;
        }
    }
}
