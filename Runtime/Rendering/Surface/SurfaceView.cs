using System;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>What one camera needs of one fluid's surface: its textures, with a slice for each eye, and what they show.</summary>
    sealed class SurfaceView : IDisposable
    {
        public readonly SurfaceConstants Constants = new SurfaceConstants();

        /// <summary>Of the draw that shades, which lives on until the frame is drawn.</summary>
        public readonly MaterialPropertyBlock Shading = new MaterialPropertyBlock();

        /// <summary>Depth alone: the ellipsoids as they were drawn.</summary>
        public RenderTexture Drawn;

        /// <summary>The same smoothed, see SurfaceView.hlsl; <see cref="Smoothed"/> is what counts, the other holds the rows.</summary>
        public RenderTexture Rows, Smoothed;

        /// <summary>xyz unit normal, world; w variance.</summary>
        public RenderTexture Normals;

        /// <summary>Water in front of the scene, m; half the size. As it was drawn, and smoothed.</summary>
        public RenderTexture DrawnThickness, Thickness;

        public SurfaceView(Camera camera) => Camera = camera;

        public Camera Camera { get; }

        /// <summary>Frame in which the camera last asked for it.</summary>
        public int LastFrame { get; set; }

        /// <summary>Lowest and highest x and y of the fluid's box on the picture, -1 to 1.</summary>
        public Vector4 Bounds { get; set; }

        /// <summary>Whether a frame of the camera was prepared and is not recorded yet.</summary>
        public bool IsPrepared { get; set; }

        /// <summary>What <see cref="Smoothed"/> and <see cref="Normals"/> show; null where they show nothing yet.</summary>
        public SurfaceState? Shown { get; set; }

        public int Width => Smoothed.width;
        public int Height => Smoothed.height;

        /// <summary>Makes the textures where they are missing or of another size.</summary>
        public void Prepare(int width, int height, int eyes)
        {
            if (Smoothed != null && Smoothed.width == width && Smoothed.height == height && Smoothed.volumeDepth == eyes)
                return;
            Dispose();
            Drawn = Make("Rill.Surface.Drawn", width, height, eyes, GraphicsFormat.None, false);
            Rows = Make("Rill.Surface.Rows", width, height, eyes, GraphicsFormat.R32_SFloat, true);
            Smoothed = Make("Rill.Surface.Depth", width, height, eyes, GraphicsFormat.R32_SFloat, true);
            Normals = Make("Rill.Surface.Normals", width, height, eyes, GraphicsFormat.R16G16B16A16_SFloat, true);
            DrawnThickness = Make("Rill.Surface.DrawnThickness", (width + 1) / 2, (height + 1) / 2, eyes, GraphicsFormat.R16G16_SFloat, false);
            Thickness = Make("Rill.Surface.Thickness", (width + 1) / 2, (height + 1) / 2, eyes, GraphicsFormat.R32_SFloat, true);
        }

        public void Dispose()
        {
            EngineObject.Release(ref Drawn);
            EngineObject.Release(ref Rows);
            EngineObject.Release(ref Smoothed);
            EngineObject.Release(ref Normals);
            EngineObject.Release(ref DrawnThickness);
            EngineObject.Release(ref Thickness);
            Shown = null;
        }

        public void Describe(StageDescription stage)
        {
            foreach (RenderTexture texture in new[] { Drawn, Rows, Smoothed, Normals, DrawnThickness, Thickness })
                if (texture != null)
                    stage.Texture(texture.name, (long)texture.width * texture.height * texture.volumeDepth * BytesOf(texture));
        }

        static int BytesOf(RenderTexture texture) => texture.graphicsFormat == GraphicsFormat.R16G16B16A16_SFloat ? 8 : 4;

        static RenderTexture Make(string name, int width, int height, int eyes, GraphicsFormat format, bool written)
        {
            var texture = new RenderTexture(new RenderTextureDescriptor(width, height, format, format == GraphicsFormat.None ? GraphicsFormat.D32_SFloat : GraphicsFormat.None)
            {
                dimension = TextureDimension.Tex2DArray, volumeDepth = eyes, enableRandomWrite = written,
            })
            {
                name = name, hideFlags = HideFlags.HideAndDontSave, filterMode = FilterMode.Bilinear, wrapMode = TextureWrapMode.Clamp,
            };
            texture.Create();
            return texture;
        }
    }
}
