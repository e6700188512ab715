using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>What the passes of the surface on the screen have in common: properties of SurfaceView.hlsl and of the scene, a thread for each
    /// texel.</summary>
    static class SurfaceIds
    {
        public static readonly int Constants = Shader.PropertyToID("RillSurfaceView");
        public static readonly int SurfaceEye = Shader.PropertyToID("_SurfaceEye");
        public static readonly int SurfaceDepth = Shader.PropertyToID("_SurfaceDepth");
        public static readonly int Depth = Shader.PropertyToID("_Depth");

        /// <summary>A thread for each texel.</summary>
        public static void Dispatch(CommandBuffer cmd, ComputeShader shader, int kernel, int width, int height)
        {
            shader.GetKernelThreadGroupSizes(kernel, out uint x, out uint y, out _);
            cmd.DispatchCompute(shader, kernel, (width + (int)x - 1) / (int)x, (height + (int)y - 1) / (int)y, 1);
        }
    }
}
