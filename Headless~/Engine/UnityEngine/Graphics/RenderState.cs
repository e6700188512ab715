using System;
using System.Collections.Generic;

namespace UnityEngine.Headless
{
    /// <summary>Targets and matrices of draws: what the render thread holds between two commands.</summary>
    internal static class RenderState
    {
        const int MaxColors = 4;

        static readonly RenderTexture[] colors = new RenderTexture[MaxColors];
        static int colorCount;
        static RenderTexture depth;
        static int mip, slice, slices;
        static Rect? viewport;

        /// <summary>RenderTexture.active: null is the screen.</summary>
        public static RenderTexture ActiveTexture { get; private set; }
        /// <summary>Current meaning of BuiltinRenderTextureType.CameraTarget.</summary>
        public static RenderTexture CameraTarget => cameraTarget is object ? cameraTarget : ScreenTarget.Texture;
        static RenderTexture cameraTarget;

        public static Material CurrentMaterial;
        public static int CurrentPass;
        public static bool InvertCulling;
        /// <summary>Factor of the instances of draws that are not indirect: 2 for two eyes in one pass.</summary>
        public static int InstanceMultiplier = 1;
        public static Matrix4x4 View = Matrix4x4.identity, Projection = Matrix4x4.identity;

        /// <summary>Whether draws go to where row 0 is the top of the picture: their projection does not flip y.</summary>
        public static bool IsUpright => colorCount > 0 ? colors[0].IsUpright : depth is object && depth.IsUpright;

        public static Texture CurrentTexture => colorCount > 0 ? colors[0] : depth is object ? depth : (Texture)ScreenTarget.Texture;
        public static int Width => Math.Max(1, CurrentTexture.width >> mip);
        public static int Height => Math.Max(1, CurrentTexture.height >> mip);

        public static void SetCameraTarget(RenderTexture target) => cameraTarget = target;

        /// <summary>Color and depth of one texture; null is the screen.</summary>
        public static void SetTarget(RenderTexture target, int mipLevel = 0, int depthSlice = 0)
        {
            Gpu.ClosePass();
            ActiveTexture = target is object && target.IsUpright ? null : target;
            colorCount = 0;
            depth = null;
            viewport = null;
            (mip, slice, slices) = (mipLevel, Math.Max(0, depthSlice), SlicesOf(target, depthSlice));
            if (target is object)
            {
                target.Create();
                depth = target.DepthTexture != null && mipLevel == 0 ? target : null;
                if (target.graphicsFormat != Experimental.Rendering.GraphicsFormat.None)
                    colors[colorCount++] = target;
            }
            BuiltinVariables.FollowTarget();
        }

        public static void SetTargets(IReadOnlyList<RenderTexture> colorTargets, RenderTexture depthTarget, int mipLevel, int depthSlice)
        {
            if (colorTargets.Count > MaxColors)
                throw new NotSupportedException($"SetRenderTarget with {colorTargets.Count} color targets; the headless host has {MaxColors}.");
            Gpu.ClosePass();
            viewport = null;
            (mip, slice, slices) = (mipLevel, Math.Max(0, depthSlice), SlicesOf(colorTargets.Count > 0 ? colorTargets[0] : depthTarget, depthSlice));
            colorCount = 0;
            foreach (RenderTexture color in colorTargets)
            {
                if (color is null)
                    continue;
                color.Create();
                if (color.graphicsFormat != Experimental.Rendering.GraphicsFormat.None)
                    colors[colorCount++] = color;
            }
            depth = depthTarget;
            depth?.Create();
            ActiveTexture = IsUpright ? null : colorCount > 0 ? colors[0] : depth;
            BuiltinVariables.FollowTarget();
        }

        // RenderTargetIdentifier.AllDepthSlices
        static int SlicesOf(RenderTexture target, int depthSlice) =>
            depthSlice < 0 && target is object && target.dimension == Rendering.TextureDimension.Tex2DArray ? target.volumeDepth : 1;

        /// <summary>In pixels, origin at the bottom left, as Unity counts.</summary>
        public static void SetViewport(Rect rect)
        {
            Gpu.ClosePass();
            viewport = rect;
        }

        public static void Clear(bool clearDepth, bool clearColor, Color color, float depthValue)
        {
            if (!clearDepth && !clearColor)
                return;
            DeviceTargets targets = Targets();
            Color stored = Player.LinearColorSpace ? color.linear : color;
            targets.ClearColor = clearColor && targets.ColorCount > 0;
            targets.ClearDepth = clearDepth && targets.Depth != null;
            targets.ClearValue = new DeviceColor { R = stored.r, G = stored.g, B = stored.b, A = stored.a };
            targets.ClearDepthValue = 1 - depthValue;   // reversed Z: Unity's 1 is the far plane, which is stored as 0
            Gpu.OpenPass(targets);
        }

        /// <summary>Makes sure that a pass is open on the current targets.</summary>
        public static void Open()
        {
            if (!Gpu.IsPassOpen)
                Gpu.OpenPass(Targets());
        }

        static DeviceTargets Targets()
        {
            var targets = new DeviceTargets { Mip = mip, Slice = slice, Slices = slices };
            if (colorCount == 0 && depth is null)
                SetScreen(ref targets);
            else
            {
                targets.ColorCount = colorCount;
                for (int i = 0; i < colorCount; i++)
                {
                    DeviceTexture color = colors[i].GetDevice(Rendering.RenderTextureSubElement.Color)
                        ?? throw new GpuUsageException(
                            $"Drawing into RenderTexture '{(colors[i].Destroyed ? "(destroyed)" : colors[i].name)}', which was released.");
                    if (i == 0) targets.Color0 = color;
                    else if (i == 1) targets.Color1 = color;
                    else if (i == 2) targets.Color2 = color;
                    else targets.Color3 = color;
                }
                targets.Depth = depth?.DepthTexture;
            }

            Rect rect = viewport ?? new Rect(0, 0, Width, Height);
            // Row 0 of a render texture is the picture's bottom, and so is Unity's viewport origin: no flip.
            float y = IsUpright ? Height - rect.yMax : rect.y;
            (targets.ViewportX, targets.ViewportY, targets.ViewportWidth, targets.ViewportHeight) = (rect.x, y, rect.width, rect.height);
            return targets;
        }

        static void SetScreen(ref DeviceTargets targets)
        {
            RenderTexture screen = ScreenTarget.Texture;
            targets.ColorCount = 1;
            targets.Color0 = screen.GetDevice(Rendering.RenderTextureSubElement.Color);
            targets.Depth = screen.DepthTexture;
        }

        public static void Reset()
        {
            Array.Clear(colors, 0, colors.Length);
            colorCount = mip = slice = slices = 0;
            depth = ActiveTexture = cameraTarget = null;
            viewport = null;
            CurrentMaterial = null;
            InvertCulling = false;
            InstanceMultiplier = 1;
            View = Projection = Matrix4x4.identity;
        }
    }
}
