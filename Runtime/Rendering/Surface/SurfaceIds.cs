using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Common parts of the passes of a camera's picture of the surface: properties of SurfaceView.hlsl, a thread for each
    /// texel.</summary>
    static class SurfaceIds
    {
        public static readonly int Constants = Shader.PropertyToID("RillSurfaceView");
        public static readonly int SurfaceEye = Shader.PropertyToID("_SurfaceEye");
        public static readonly int SurfaceDepth = Shader.PropertyToID("_SurfaceDepth");

        /// <summary>A thread for each texel.</summary>
        public static void Dispatch(CommandBuffer cmd, ComputeShader shader, int kernel, int width, int height)
        {
            shader.GetKernelThreadGroupSizes(kernel, out uint x, out uint y, out _);
            cmd.DispatchCompute(shader, kernel, (width + (int)x - 1) / (int)x, (height + (int)y - 1) / (int)y, 1);
        }
    }
}
