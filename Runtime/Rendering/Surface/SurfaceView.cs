using System;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>What one camera needs of one fluid's surface: its textures, with a slice for each eye, and what they show.</summary>
    sealed class SurfaceView : CameraView
    {
        const int FoamDivisor = 2;

        /// <summary>Of the draw that shades, which lives on until the next frame.</summary>
        public readonly MaterialPropertyBlock Shading = new MaterialPropertyBlock();

        /// <summary>Depth alone: the ellipsoids as they were drawn.</summary>
        public RenderTexture Drawn;

        /// <summary>The same smoothed, see SurfaceView.hlsl.</summary>
        public RenderTexture Smoothed;

        /// <summary>xyz unit normal, world; w variance.</summary>
        public RenderTexture Normals;

        /// <summary>Water in front of the scene along the ray, m; of each phase where their looks differ.</summary>
        public RenderTexture Thickness;

        /// <summary>See FoamLayer.hlsl; half the size. Null where there is no foam.</summary>
        public RenderTexture Foam;

        /// <summary>The part of the picture that the textures hold, from their first texel on: in their texels, in those of
        /// <see cref="Thickness"/> and in those of <see cref="Foam"/>.</summary>
        public PictureWindow Window, ThicknessWindow, FoamWindow;

        /// <summary>Width of the textures over that of the picture; 0 before the first frame.</summary>
        public float Scale;

        /// <summary>Width of the textures over that of <see cref="Thickness"/>; 0 before the first frame.</summary>
        public int ThicknessDivisor;

        ScreenSize size, thicknessSize;

        public SurfaceView(Camera camera) : base(camera, "Rill.Surface.Constants") { }

        /// <summary>What <see cref="Smoothed"/> and <see cref="Normals"/> show; null where they show nothing yet.</summary>
        public SurfaceState? Shown { get; set; }

        /// <summary>Whose thickness is told apart: 1 or 4.</summary>
        public int Phases => Thickness.graphicsFormat == GraphicsFormat.R16G16B16A16_SFloat ? PhaseFrame.MaxPhases : 1;

        /// <summary>Sets which part of the picture is in use, as far as the textures go.</summary>
        /// <param name="bounds">Lowest x and y, highest x and y of the fluid's box on the picture, -1 to 1.</param>
        public void Place(in FluidViews camera, Vector4 bounds)
        {
            Window = PictureWindow.Of(camera, bounds, Scale);
            if (Smoothed != null)
                Window = Window.Within(Smoothed.width, Smoothed.height);
            ThicknessWindow = Window.Coarser(ThicknessDivisor);
            if (Thickness != null)
                ThicknessWindow = ThicknessWindow.Within(Thickness.width, Thickness.height);
            FoamWindow = Window.Coarser(FoamDivisor);
        }

        /// <summary>Whether the textures do for a frame as they are.</summary>
        public bool Holds(in FluidViews camera, Vector4 bounds, in SurfaceFrame fluid)
        {
            PictureWindow window = PictureWindow.Of(camera, bounds, Scale), thickness = window.Coarser(ThicknessDivisor);
            return Smoothed != null && Smoothed.volumeDepth == camera.eyes && window.Width <= Smoothed.width && window.Height <= Smoothed.height
                && Thickness.graphicsFormat == ThicknessFormat(fluid.phases)
                && thickness.Width <= Thickness.width && thickness.Height <= Thickness.height
                && HasFoam(fluid) == (Foam != null) && camera.needsMotion == (Chords != null);
        }

        /// <summary>Makes the textures where they are missing, too small, or for long much too large.</summary>
        /// <param name="bounds">Lowest x and y, highest x and y of the fluid's box on the picture, -1 to 1.</param>
        public void Prepare(in FluidViews camera, Vector4 bounds, in SurfaceFrame fluid)
        {
            PictureWindow window = PictureWindow.Of(camera, bounds, Scale), thickness = window.Coarser(ThicknessDivisor);
            // The camera's full resolution, whatever is drawn of it now.
            int maxWidth = Math.Max((int)window.Grid.x, PictureWindow.Scaled(camera.camera.pixelWidth, Scale)),
                maxHeight = Math.Max((int)window.Grid.y, PictureWindow.Scaled(camera.camera.pixelHeight, Scale));
            if (size.Fit(Math.Min(window.Width + PictureWindow.Play, maxWidth), Math.Min(window.Height + PictureWindow.Play, maxHeight), maxWidth,
                maxHeight) || Smoothed == null || Smoothed.volumeDepth != camera.eyes)
                MakeSurface(camera.eyes);
            bool isUnfit = thicknessSize.Fit(thickness.Width + PictureWindow.Play / ThicknessDivisor, thickness.Height + PictureWindow.Play
                / ThicknessDivisor, Coarse(maxWidth, ThicknessDivisor), Coarse(maxHeight, ThicknessDivisor));
            PrepareThickness(isUnfit, camera.eyes, ThicknessFormat(fluid.phases));
            PrepareFoam(HasFoam(fluid));
            PrepareMotion(camera.needsMotion);
        }

        static bool HasFoam(in SurfaceFrame fluid) => fluid.foam.particles != null;

        static GraphicsFormat ThicknessFormat(in PhaseFrame phases)
            => phases.Components > 1 ? GraphicsFormat.R16G16B16A16_SFloat : GraphicsFormat.R32_SFloat;

        void MakeSurface(int eyes)
        {
            ReleaseTextures();
            Drawn = Make("Rill.Surface.Drawn", size.Width, size.Height, eyes, GraphicsFormat.None, false);
            Smoothed = Make("Rill.Surface.Depth", size.Width, size.Height, eyes, GraphicsFormat.R32_SFloat, true);
            Normals = Make("Rill.Surface.Normals", size.Width, size.Height, eyes, GraphicsFormat.R16G16B16A16_SFloat, true);
        }

        void PrepareThickness(bool isUnfit, int eyes, GraphicsFormat format)
        {
            if (!isUnfit && Thickness != null && Thickness.graphicsFormat == format)
                return;
            EngineObject.Release(ref Thickness);
            Thickness = Make("Rill.Surface.Thickness", thicknessSize.Width, thicknessSize.Height, eyes, format, true);
        }

        void PrepareFoam(bool isNeeded)
        {
            if (isNeeded == (Foam != null))
                return;
            EngineObject.Release(ref Foam);
            if (isNeeded)
                Foam = Make("Rill.Surface.Foam", Coarse(size.Width, FoamDivisor), Coarse(size.Height, FoamDivisor), Smoothed.volumeDepth,
                    GraphicsFormat.R16G16B16A16_SFloat, true);
        }

        void PrepareMotion(bool isNeeded)
        {
            if (isNeeded == (Chords != null))
                return;
            EngineObject.Release(ref Chords);
            if (!isNeeded)
                return;
            Chords = Make("Rill.Surface.Chords", size.Width, size.Height, Smoothed.volumeDepth, GraphicsFormat.R16G16B16A16_SFloat, false);
            Shown = null;
        }

        static int Coarse(int texels, int divisor) => (texels + divisor - 1) / divisor;

        public override void Dispose()
        {
            base.Dispose();
            ReleaseTextures();
        }

        void ReleaseTextures()
        {
            EngineObject.Release(ref Drawn);
            EngineObject.Release(ref Smoothed);
            EngineObject.Release(ref Normals);
            EngineObject.Release(ref Chords);
            EngineObject.Release(ref Thickness);
            EngineObject.Release(ref Foam);
            Shown = null;
        }

        public void Describe(StageDescription stage)
        {
            Describe(stage, Drawn);
            Describe(stage, Smoothed);
            Describe(stage, Normals);
            Describe(stage, Chords);
            Describe(stage, Thickness);
            Describe(stage, Foam);
        }

        /// <summary>Nothing where there is none.</summary>
        public static void Describe(StageDescription stage, RenderTexture texture)
        {
            if (texture != null)
                stage.Texture(texture.name, (long)texture.width * texture.height * texture.volumeDepth * BytesOf(texture));
        }

        static int BytesOf(RenderTexture texture) => texture.graphicsFormat == GraphicsFormat.R32G32B32A32_SFloat ? 16
            : texture.graphicsFormat == GraphicsFormat.R16G16B16A16_SFloat ? 8 : 4;

        /// <summary>With a slice for each eye.</summary>
        public static RenderTexture Make(string name, int width, int height, int eyes, GraphicsFormat format, bool written)
        {
            return GpuTexture.Create(name, new RenderTextureDescriptor(width, height, format, format == GraphicsFormat.None
                ? GraphicsFormat.D32_SFloat : GraphicsFormat.None)
            {
                dimension = TextureDimension.Tex2DArray, volumeDepth = eyes, enableRandomWrite = written,
            });
        }
    }
}
