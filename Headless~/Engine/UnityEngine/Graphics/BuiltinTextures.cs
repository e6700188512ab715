using System.Collections.Generic;

namespace UnityEngine.Headless
{
    /// <summary>The textures that a property declared as "white", "black" ... has until one is set.</summary>
    internal static class BuiltinTextures
    {
        static readonly Dictionary<string, Texture2D> flat = new Dictionary<string, Texture2D>();
        static readonly Dictionary<string, Texture> others = new Dictionary<string, Texture>();

        public static Texture2D White => Flat("white", new Color32(255, 255, 255, 255), false);
        public static Texture2D Black => Flat("black", new Color32(0, 0, 0, 0), false);
        public static Texture2D Red => Flat("red", new Color32(255, 0, 0, 255), false);
        public static Texture2D Gray => Flat("gray", new Color32(128, 128, 128, 128), false);
        public static Texture2D LinearGray => Flat("linearGray", new Color32(128, 128, 128, 128), true);
        public static Texture2D Normal => Flat("bump", new Color32(128, 128, 255, 255), true);

        public static Texture Named(string name, DeviceTextureDimension dimension)
        {
            Texture2D texture = Named(name);
            switch (dimension)
            {
                case DeviceTextureDimension.Tex2D: return texture;
                case DeviceTextureDimension.Tex3D: return Other(name + " 3D",
                    () => Fill(new Texture3D(1, 1, 1, TextureFormat.RGBA32, false), texture));
                case DeviceTextureDimension.Tex2DArray: return Other(name + " array",
                    () => Fill(new Texture2DArray(1, 1, 1, TextureFormat.RGBA32, false), texture));
                case DeviceTextureDimension.Cube: return Other(name + " cube", () => Fill(new Cubemap(1, TextureFormat.RGBA32, false), texture));
                default: return null;
            }
        }

        static Texture2D Named(string name)
        {
            switch (name)
            {
                case "white": return White;
                case "black": return Black;
                case "red": return Red;
                case "bump":
                case "normal": return Normal;
                case "linearGray":
                case "linearGrey": return LinearGray;
                default: return Gray;
            }
        }

        static Texture2D Flat(string name, Color32 color, bool linear)
        {
            if (flat.TryGetValue(name, out Texture2D texture) && texture != null)
                return texture;
            texture = new Texture2D(1, 1, TextureFormat.RGBA32, false, linear) { name = name, hideFlags = HideFlags.HideAndDontSave };
            texture.SetPixels32(new[] { color });
            texture.Apply();
            LiveObjects.Remove(texture.Store);      // the engine's own, not a leak of anybody's
            return flat[name] = texture;
        }

        static Texture Other(string name, System.Func<Texture> create)
        {
            if (!others.TryGetValue(name, out Texture texture) || texture == null)
                others[name] = texture = create();
            return texture;
        }

        static Texture3D Fill(Texture3D texture, Texture2D with)
        {
            texture.SetPixels(with.GetPixels());
            texture.Apply();
            return texture;
        }

        static Texture2DArray Fill(Texture2DArray texture, Texture2D with)
        {
            texture.SetPixels(with.GetPixels(), 0);
            texture.Apply();
            return texture;
        }

        static Cubemap Fill(Cubemap texture, Texture2D with)
        {
            for (int face = 0; face < 6; face++)
                texture.SetPixels(with.GetPixels(), (CubemapFace)face);
            texture.Apply();
            LiveObjects.Remove(texture.Store);
            return texture;
        }

        public static void Reset()
        {
            foreach (Texture2D texture in flat.Values)
                Object.DestroyImmediate(texture, true);
            foreach (Texture texture in others.Values)
                Object.DestroyImmediate(texture, true);
            flat.Clear();
            others.Clear();
        }
    }
}
