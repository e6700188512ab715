using UnityEngine.Headless;

namespace UnityEngine.Rendering.Universal
{
    /// <summary>
    /// A camera's matrices of this frame and the last one that it drew, as the device takes them and without jitter. In its first frame
    /// both are the same. Of two eyes the names are others. Read in URP 17.1.0, Runtime/MotionVectors.cs (MotionVectorsPersistentData).
    /// </summary>
    internal sealed class MotionMatrices
    {
        static readonly int
            viewProjection = Shader.PropertyToID("_NonJitteredViewProjMatrix"), previousViewProjection = Shader.PropertyToID("_PrevViewProjMatrix"),
            viewProjections = Shader.PropertyToID("_NonJitteredViewProjMatrixStereo"),
                previousViewProjections = Shader.PropertyToID("_PrevViewProjMatrixStereo");

        readonly Matrix4x4[] now = new Matrix4x4[2], previous = new Matrix4x4[2];
        int lastFrame = -1;

        public void Update(in CameraMatrices matrices)
        {
            if (lastFrame == Time.frameCount)
                return;
            for (int eye = 0; eye < System.Math.Max(matrices.xr.viewCount, 1); eye++)
            {
                Matrix4x4 next = GL.GetGPUProjectionMatrix(matrices.ProjectionNoJitter(eye), true) * matrices.View(eye);
                previous[eye] = lastFrame < 0 ? next : now[eye];
                now[eye] = next;
            }
            lastFrame = Time.frameCount;
        }

        public void SetGlobals(bool isStereo)
        {
            if (isStereo)
            {
                Shader.SetGlobalMatrixArray(viewProjections, now);
                Shader.SetGlobalMatrixArray(previousViewProjections, previous);
                return;
            }
            Shader.SetGlobalMatrix(viewProjection, now[0]);
            Shader.SetGlobalMatrix(previousViewProjection, previous[0]);
        }
    }
}
