using System;
using UnityEngine.Headless;

namespace UnityEngine
{
    public static class ImageConversion
    {
        /// <summary>Rows bottom first, as textures hold them, become the top-first rows of the file.</summary>
        public static byte[] EncodeToPNG(this Texture2D tex)
        {
            if (tex == null)
                throw new ArgumentNullException(nameof(tex));
            int w = tex.width, h = tex.height;
            Color32[] pixels = tex.GetPixels32();
            var rgba = new byte[w * h * 4];
            for (int i = 0; i < pixels.Length; i++)
            {
                int at = ((h - 1 - i / w) * w + i % w) * 4;
                rgba[at] = pixels[i].r;
                rgba[at + 1] = pixels[i].g;
                rgba[at + 2] = pixels[i].b;
                rgba[at + 3] = pixels[i].a;
            }
            return Png.Encode(rgba, w, h);
        }
    }
}
