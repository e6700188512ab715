using UnityEngine.Headless;

namespace UnityEngine.Rendering.Universal
{
    /// <summary>
    /// A camera's matrices of this frame and the last one that it drew, as the device takes them and without jitter. In its first frame
    /// both are the same. Read in URP 17.1.0, Runtime/MotionVectors.cs (MotionVectorsPersistentData).
    /// </summary>
    internal sealed class MotionMatrices
    {
        static readonly int viewProjection = Shader.PropertyToID("_NonJitteredViewProjMatrix"), previousViewProjection = Shader.PropertyToID("_PrevViewProjMatrix");

        Matrix4x4 now, previous;
        int lastFrame = -1;

        public void Update(Camera camera)
        {
            if (lastFrame == Time.frameCount)
                return;
            Matrix4x4 next = GL.GetGPUProjectionMatrix(camera.projectionMatrix, true) * camera.worldToCameraMatrix;
            previous = lastFrame < 0 ? next : now;
            now = next;
            lastFrame = Time.frameCount;
        }

        public void SetGlobals()
        {
            Shader.SetGlobalMatrix(viewProjection, now);
            Shader.SetGlobalMatrix(previousViewProjection, previous);
        }
    }
}
