using UnityEngine;

namespace Rill
{
    /// <summary>The part of a picture that textures hold: whole texels of a grid over the picture, which need not end with it.</summary>
    readonly struct PictureWindow
    {
        /// <summary>Texels by which a window may get wider and higher as the picture moves by less than a texel.</summary>
        public const int Play = Alignment;

        const int Alignment = 8;        // texels, so that coarser windows begin where this does

        readonly float gridWidth, gridHeight;
        readonly int x, y;

        /// <summary>Texels.</summary>
        public readonly int Width, Height;

        PictureWindow(float gridWidth, float gridHeight, int x, int y, int width, int height)
        {
            this.gridWidth = gridWidth;
            this.gridHeight = gridHeight;
            this.x = x;
            this.y = y;
            Width = width;
            Height = height;
        }

        public int Texels => Width * Height;

        /// <summary>Width and height of the grid, texels, and one over them.</summary>
        public Vector4 Grid => new Vector4(gridWidth, gridHeight, 1f / gridWidth, 1f / gridHeight);

        /// <summary>First texel of the grid, width and height.</summary>
        public Vector4 Rect => new Vector4(x, y, Width, Height);

        /// <summary>The part of a camera's picture that bounds cover.</summary>
        /// <param name="bounds">Lowest x and y, highest x and y on the picture, -1 to 1.</param>
        /// <param name="scale">Width of the grid over that of the picture.</param>
        public static PictureWindow Of(in FluidViews camera, Vector4 bounds, float scale)
            => Around(Scaled(camera.width, scale), Scaled(camera.height, scale), bounds);

        /// <summary>Returns how many texels of a grid so many pixels take, at least 1.</summary>
        /// <param name="scale">Width of the grid over that of the picture.</param>
        public static int Scaled(int pixels, float scale) => Mathf.Max((int)(pixels * scale), 1);

        /// <param name="width">Width of the grid, texels.</param>
        /// <param name="height">Height of the grid, texels.</param>
        /// <param name="bounds">Lowest x and y, highest x and y on the picture, -1 to 1.</param>
        public static PictureWindow Around(int width, int height, Vector4 bounds)
        {
            (int left, int right) = Span(bounds.x, bounds.z, width);
            (int bottom, int top) = Span(bounds.y, bounds.w, height);
            return new PictureWindow(width, height, left, bottom, right - left, top - bottom);
        }

        /// <summary>Returns this part in texels that are so many times as wide.</summary>
        /// <param name="divisor">A power of two up to 8.</param>
        public PictureWindow Coarser(int divisor) => new PictureWindow(gridWidth / divisor, gridHeight / divisor, x / divisor, y / divisor,
            (Width + divisor - 1) / divisor, (Height + divisor - 1) / divisor);

        /// <summary>The whole picture from what a texture holds of it; default beyond. For tests and tools.</summary>
        /// <param name="rowLength">Texels of a row of the texture.</param>
        public T[] Whole<T>(T[] texels, int rowLength)
        {
            int width = Mathf.CeilToInt(gridWidth);
            var whole = new T[width * Mathf.CeilToInt(gridHeight)];
            for (int row = 0; row < Height; row++)
                System.Array.Copy(texels, row * rowLength, whole, (y + row) * width + x, Width);
            return whole;
        }

        /// <summary>No more of it than so many texels.</summary>
        public PictureWindow Within(int width, int height)
            => new PictureWindow(gridWidth, gridHeight, x, y, Mathf.Min(Width, width), Mathf.Min(Height, height));

        static (int first, int end) Span(float low, float high, int size)
        {
            int first = Mathf.Clamp((int)((low * 0.5f + 0.5f) * size), 0, size - 1) / Alignment * Alignment;
            return (first, Mathf.Clamp((int)((high * 0.5f + 0.5f) * size) + 1, first + 1, size));
        }
    }
}
