using System;
using UnityEngine.Rendering;

namespace UnityEngine.Headless
{
    internal static class Screenshot
    {
        /// <summary>The picture as one looks at it: top row first, 8 bits a channel, alpha as stored. Null reads the screen.</summary>
        public static byte[] ReadRgba(RenderTexture source = null)
        {
            if (source == null)
                source = ScreenTarget.Texture;
            source.Create();
            byte[] texels = Gpu.Device.ReadTexture(source.GetDevice(RenderTextureSubElement.Color), 0, 0);
            TextureFormat format = Formats.ToTextureFormat(source.graphicsFormat);
            int w = source.width, h = source.height;
            var rgba = new byte[w * h * 4];
            for (int y = 0; y < h; y++)
            {
                int from = (h - 1 - y) * w;
                if (format == TextureFormat.RGBA32)
                    Buffer.BlockCopy(texels, from * 4, rgba, y * w * 4, w * 4);
                else
                    for (int x = 0; x < w; x++)
                        TexelCodec.Encode(rgba, y * w + x, TextureFormat.RGBA32, TexelCodec.Decode(texels, from + x, format));
            }
            return rgba;
        }
    }
}
