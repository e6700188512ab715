using UnityEngine.Headless;

namespace UnityEngine
{
    public sealed class GL
    {
        public static bool invertCulling { get => RenderState.InvertCulling; set => RenderState.InvertCulling = value; }
        public static bool wireframe { get; set; }
        public static bool sRGBWrite { get; set; }
        public static Matrix4x4 modelview { get => RenderState.View; set => BuiltinVariables.SetViewProjection(value, RenderState.Projection); }

        /// <summary>Direct3D 11's: depth from 1 (near) to 0 (far), and y flipped for textures, so that row 0 is the picture's bottom.</summary>
        public static Matrix4x4 GetGPUProjectionMatrix(Matrix4x4 proj, bool renderIntoTexture)
        {
            if (renderIntoTexture)
                proj.SetRow(1, -proj.GetRow(1));
            proj.SetRow(2, (proj.GetRow(3) - proj.GetRow(2)) * 0.5f);
            return proj;
        }

        public static void LoadProjectionMatrix(Matrix4x4 mat) => BuiltinVariables.SetViewProjection(RenderState.View, mat);

        public static void LoadIdentity() => BuiltinVariables.SetViewProjection(Matrix4x4.identity, RenderState.Projection);

        public static void LoadOrtho() => Load(Matrix4x4.Ortho(0, 1, 0, 1, -1, 100));
        public static void LoadPixelMatrix() => LoadPixelMatrix(0, RenderState.Width, 0, RenderState.Height);
        public static void LoadPixelMatrix(float left, float right, float bottom, float top)
            => Load(Matrix4x4.Ortho(left, right, bottom, top, -1, 100));

        static void Load(Matrix4x4 projection) => BuiltinVariables.SetViewProjection(Matrix4x4.identity, projection);

        public static void PushMatrix() => stack.Push((RenderState.View, RenderState.Projection));

        public static void PopMatrix()
        {
            (Matrix4x4 view, Matrix4x4 projection) = stack.Pop();
            BuiltinVariables.SetViewProjection(view, projection);
        }

        static readonly System.Collections.Generic.Stack<(Matrix4x4, Matrix4x4)> stack = new System.Collections.Generic.Stack<(Matrix4x4,
            Matrix4x4)>();

        public static void Viewport(Rect pixelRect) => RenderState.SetViewport(pixelRect);
        public static void Clear(bool clearDepth, bool clearColor, Color backgroundColor) => Clear(clearDepth, clearColor, backgroundColor, 1);
        public static void Clear(bool clearDepth, bool clearColor, Color backgroundColor, float depth)
            => RenderState.Clear(clearDepth, clearColor, backgroundColor, depth);
        public static void Flush() => Gpu.Device.Flush();
        public static void InvalidateState() { }
        public static void RenderTargetBarrier() { }
    }
}
