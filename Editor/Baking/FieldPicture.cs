using System;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Rill.Editor
{
    /// <summary>A picture that is painted again only where something that it shows has changed: an inspector draws many times a second.</summary>
    sealed class FieldPicture
    {
        readonly string name;
        Texture2D texture;
        Color32[] pixels;
        object shown;

        public FieldPicture(string name) => this.name = name;

        /// <param name="what">Equal where the picture would be the same.</param>
        /// <param name="paint">Fills the pixels, lowest row first.</param>
        public Texture2D Of(object what, Vector2Int size, Action<Color32[]> paint)
        {
            bool fits = texture != null && texture.width == size.x && texture.height == size.y;
            if (fits && what.Equals(shown))
                return texture;
            if (!fits)
            {
                Release();
                texture = new Texture2D(size.x, size.y, TextureFormat.RGBA32, false)
                {
                    name = name, hideFlags = HideFlags.HideAndDontSave,
                    wrapMode = TextureWrapMode.Clamp
                };
                pixels = new Color32[size.x * size.y];
            }
            paint(pixels);
            texture.SetPixels32(pixels);
            texture.Apply(false);
            shown = what;
            return texture;
        }

        public void Invalidate() => shown = null;

        public void Release()
        {
            if (texture != null)
                Object.DestroyImmediate(texture);
            texture = null;
            shown = null;
        }
    }
}
