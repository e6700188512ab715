using UnityEngine.Experimental.Rendering;

namespace UnityEngine.Headless
{
    /// <summary>Stand-in for the window: cameras without a target texture draw here.</summary>
    internal static class ScreenTarget
    {
        static RenderTexture texture;

        public static RenderTexture Texture
        {
            get
            {
                if (texture != null && (texture.width != Player.ScreenWidth || texture.height != Player.ScreenHeight
                    || texture.sRGB != Player.LinearColorSpace))
                    Reset();
                if (texture == null)
                {
                    GraphicsFormat format = Player.LinearColorSpace ? GraphicsFormat.R8G8B8A8_SRGB : GraphicsFormat.R8G8B8A8_UNorm;
                    texture = new RenderTexture(Player.ScreenWidth, Player.ScreenHeight, format,
                        GraphicsFormat.D32_SFloat_S8_UInt) { name = "Screen", IsBuiltIn = true, hideFlags = HideFlags.HideAndDontSave };
                    texture.Create();
                }
                return texture;
            }
        }

        public static void Reset()
        {
            if (texture is object)
                Object.DestroyImmediate(texture, true);
            texture = null;
        }
    }
}
