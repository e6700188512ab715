using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>The uniforms of SurfaceView.hlsl for one camera: matrices and rays of each eye.</summary>
    sealed class SurfaceConstants
    {
        /// <summary>vectors of each eye in _SurfaceRays</summary>
        [GenerateHlsl("SurfaceView")] const int RaysOfEye = 6;

        public readonly Matrix4x4[] WorldToClip = new Matrix4x4[2];
        public readonly Vector4[] Rays = new Vector4[2 * RaysOfEye];
        public readonly Vector4[] Depths = new Vector4[2];

        public void Set(in FluidViews views)
        {
            for (int eye = 0; eye < 2; eye++)
                Set(eye, views.ViewOf(eye < views.eyes ? eye : 0), views.ProjectionOf(eye < views.eyes ? eye : 0));
        }

        public void SetOn(MaterialPropertyBlock block)
        {
            block.SetMatrixArray(SurfaceIds.WorldToClip, WorldToClip);
            block.SetVectorArray(SurfaceIds.Rays, Rays);
            block.SetVectorArray(SurfaceIds.Depths, Depths);
        }

        public void SetOn(CommandBuffer cmd, ComputeShader shader)
        {
            cmd.SetComputeMatrixArrayParam(shader, SurfaceIds.WorldToClip, WorldToClip);
            cmd.SetComputeVectorArrayParam(shader, SurfaceIds.Rays, Rays);
            cmd.SetComputeVectorArrayParam(shader, SurfaceIds.Depths, Depths);
        }

        void Set(int eye, Matrix4x4 view, Matrix4x4 projection)
        {
            bool isOrthographic = projection.m32 == 0f;
            // z of -1 to 1 becomes 1 to 0.
            Matrix4x4 reversed = Matrix4x4.identity;
            reversed.m22 = -0.5f;
            reversed.m23 = 0.5f;
            WorldToClip[eye] = reversed * projection * view;
            Depths[eye] = isOrthographic ? new Vector4(0.5f - 0.5f * projection.m23, 0.5f * projection.m22, 1f, 0f)
                : new Vector4(0.5f + 0.5f * projection.m22, -0.5f * projection.m23, 0f, 0f);

            Matrix4x4 toWorld = view.inverse;
            Vector3 right = toWorld.GetColumn(0), up = toWorld.GetColumn(1), forward = -(Vector3)toWorld.GetColumn(2), origin = toWorld.GetColumn(3);
            right /= projection.m00;
            up /= projection.m11;
            int first = eye * RaysOfEye;
            Vector4 middle = isOrthographic ? -right * projection.m03 - up * projection.m13 : right * projection.m02 + up * projection.m12;
            Rays[first] = isOrthographic ? (Vector4)origin + middle : (Vector4)origin;
            Rays[first + 1] = isOrthographic ? (Vector4)right : Vector4.zero;
            Rays[first + 2] = isOrthographic ? (Vector4)up : Vector4.zero;
            Rays[first + 3] = isOrthographic ? (Vector4)forward : (Vector4)forward + middle;
            Rays[first + 4] = isOrthographic ? Vector4.zero : (Vector4)right;
            Rays[first + 5] = isOrthographic ? Vector4.zero : (Vector4)up;
        }

        /// <summary>Pixels of a picture of that height that 1 m takes up at a depth of 1 m with perspective, at any without.</summary>
        public static float PixelsPerMeter(Matrix4x4 projection, int height) => 0.5f * height * Mathf.Abs(projection.m11);
    }
}
