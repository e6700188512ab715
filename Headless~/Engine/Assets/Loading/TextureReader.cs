using System;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace Host.Assets
{
    /// <summary>Textures that are assets of their own (.asset, .renderTexture), not imported from an image.</summary>
    internal static class TextureReader
    {
        public static RenderTexture MakeRenderTexture(YamlMapping fields)
        {
            var description = new RenderTextureDescriptor(fields.Int("m_Width"), fields.Int("m_Height"),
                (GraphicsFormat)fields.Int("m_ColorFormat"), (GraphicsFormat)fields.Int("m_DepthStencilFormat"))
            {
                msaaSamples = Math.Max(fields.Int("m_AntiAliasing"), 1),
                dimension = (TextureDimension)fields.Int("m_Dimension", (int)TextureDimension.Tex2D),
                volumeDepth = Math.Max(fields.Int("m_VolumeDepth"), 1),
                enableRandomWrite = fields.Bool("m_EnableRandomWrite"),
                useMipMap = fields.Bool("m_MipMap"),
                autoGenerateMips = fields.Bool("m_GenerateMips", true),
            };
            return Sampled(new RenderTexture(description), fields["m_TextureSettings"]);
        }

        public static Texture2D MakeTexture2D(YamlMapping fields)
        {
            var texture = new Texture2D(fields.Int("m_Width"), fields.Int("m_Height"), (TextureFormat)fields.Int("m_TextureFormat"),
                fields.Int("m_MipCount", 1), fields.Int("m_ColorSpace") == 0);
            texture.LoadRawTextureData(Data(fields));
            texture.Apply(false);
            return Sampled(texture, fields["m_TextureSettings"]);
        }

        public static Texture3D MakeTexture3D(YamlMapping fields)
        {
            var texture = new Texture3D(fields.Int("m_Width"), fields.Int("m_Height"), fields.Int("m_Depth"),
                (GraphicsFormat)fields.Int("m_Format"), TextureCreationFlags.None, 1);
            if (fields.Int("m_MipCount", 1) > 1)
                throw fields.Location.Error(
                $"the volume texture '{fields.Text("m_Name")}' has mip levels, which the host does not read: save it without");
            texture.SetPixelData(Data(fields), 0);
            texture.Apply(false, !fields.Bool("m_IsReadable", true));
            return Sampled(texture, fields["m_TextureSettings"]);
        }

        static byte[] Data(YamlMapping fields)
        {
            if (!PackedNumbers.TryBytes(fields.Text("_typelessdata"), out var bytes))
                throw fields.Location.Error($"the data of the texture '{fields.Text("m_Name")}' is damaged");
            if (bytes.Length == 0)
                throw fields.Location.Error(
                $"the texture '{fields.Text("m_Name")}' keeps its data in another file, which the host does not read");
            return bytes;
        }

        /// <summary>Filter and wrap; -1 and absent keys: the default. Importers and assets name the keys differently.</summary>
        public static T Sampled<T>(T texture, YamlNode settings) where T : Texture
        {
            if (settings == null) return texture;
            int Value(string key, int otherwise)
            {
                var found = settings.Int(key, settings.Int("m_" + char.ToUpperInvariant(key[0]) + key.Substring(1), -1));
                return found >= 0 ? found : otherwise;
            }
            texture.filterMode = (FilterMode)Value("filterMode", (int)FilterMode.Bilinear);
            texture.wrapModeU = (TextureWrapMode)Value("wrapU", 0);
            texture.wrapModeV = (TextureWrapMode)Value("wrapV", 0);
            texture.wrapModeW = (TextureWrapMode)Value("wrapW", 0);
            return texture;
        }
    }
}
