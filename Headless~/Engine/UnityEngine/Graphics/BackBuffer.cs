namespace UnityEngine.Headless
{
    /// <summary>
    /// The screen as Direct3D's back buffer has it while a camera of the Built-in pipeline draws straight into it: row 0 is the top, so
    /// nothing is flipped, and what copies it texel by texel gets a picture that is upside down.
    /// </summary>
    internal static class BackBuffer
    {
        /// <summary>With what is on the screen.</summary>
        public static RenderTexture Begin()
        {
            RenderTexture screen = ScreenTarget.Texture, buffer = RenderTexture.GetTemporary(screen.descriptor);
            buffer.IsUpright = true;
            Blitter.BlitSlice(screen, buffer, 0, 0);
            return buffer;
        }

        /// <summary>Shows it.</summary>
        public static void End(RenderTexture buffer)
        {
            Blitter.Blit(buffer, ScreenTarget.Texture, new Vector2(1, -1), new Vector2(0, 1));
            buffer.IsUpright = false;
            RenderTexture.ReleaseTemporary(buffer);
        }
    }
}
