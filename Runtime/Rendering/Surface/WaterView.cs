using System;
using UnityEngine;
using UnityEngine.Experimental.Rendering;

namespace Rill
{
    /// <summary>Textures of one camera that say where the light comes from that it sees through one fluid's mesh, with a slice for each eye. See
    /// PackedRay of WaterRays.hlsl.</summary>
    sealed class WaterView : CameraView
    {
        /// <summary>Properties of the draws, which live on until the next frame.</summary>
        public readonly MaterialPropertyBlock Properties = new MaterialPropertyBlock();

        /// <summary>The nearest faces, in floats; the others are half floats.</summary>
        public RenderTexture Faces;

        /// <summary>Ends of the rays through those faces, in texels of <see cref="CoarseWindow"/>, as are spray and bubbles.</summary>
        public RenderTexture Ends, Directions, Mirrors;

        /// <summary>Sunlight where the rays end; null without caustics.</summary>
        public RenderTexture Sun;

        /// <summary>Fractions of phases 1 to 3 along the rays; null where all phases look alike.</summary>
        public RenderTexture Phases;

        /// <summary>See SprayLayer.hlsl; null where there is neither spray nor foam, and without foam.</summary>
        public RenderTexture Spray, Bubbles;

        /// <summary>The part of the picture that the faces hold, from their first texel on.</summary>
        public PictureWindow Window;

        /// <summary>That part of the picture in texels that are as wide, or on a fine picture several times as wide.</summary>
        public PictureWindow CoarseWindow;

        /// <summary>The tiles of <see cref="CoarseWindow"/> that show something.</summary>
        public readonly WaterTiles Tiles = new WaterTiles();

        ScreenSize size;

        public WaterView(Camera camera) : base(camera, "Rill.Water.Constants") => SetConstants(Properties);

        /// <summary>Whether the textures do for a frame as they are.</summary>
        /// <param name="bounds">Lowest x and y, highest x and y of the fluid's box on the picture, -1 to 1.</param>
        public bool Holds(in FluidViews camera, Vector4 bounds, in MeshFrame mesh)
        {
            PictureWindow window = PictureWindow.Of(camera, bounds, mesh.rayScale);
            return Faces != null && Faces.volumeDepth == camera.eyes && window.Width <= Faces.width && window.Height <= Faces.height
                && camera.needsMotion == (Chords != null) && mesh.HasSpray == (Spray != null) && mesh.HasFoam == (Bubbles != null)
                && (mesh.phases != null) == (Phases != null) && (mesh.caustics != null) == (Sun != null);
        }

        /// <summary>Makes the textures where they are missing, too small, or for long much too large.</summary>
        public void Prepare(in FluidViews camera, Vector4 bounds, in MeshFrame mesh)
        {
            float scale = mesh.rayScale;
            PictureWindow window = PictureWindow.Of(camera, bounds, scale);
            // The camera's full resolution, whatever is drawn of it now.
            int maxWidth = Math.Max((int)window.Grid.x, PictureWindow.Scaled(camera.camera.pixelWidth, scale)),
                maxHeight = Math.Max((int)window.Grid.y, PictureWindow.Scaled(camera.camera.pixelHeight, scale));
            if (size.Fit(Math.Min(window.Width + PictureWindow.Play, maxWidth), Math.Min(window.Height + PictureWindow.Play, maxHeight), maxWidth,
                maxHeight) || Faces == null || Faces.volumeDepth != camera.eyes)
                Make(camera.eyes);
            int divisor = Divisor(camera, mesh), across = (Faces.width + divisor - 1) / divisor, up = (Faces.height + divisor - 1) / divisor;
            Fit(ref Ends, true, "Rill.Water.RayEnds", across, up);
            Fit(ref Directions, true, "Rill.Water.RayDirections", across, up);
            Fit(ref Mirrors, true, "Rill.Water.RayMirrors", across, up);
            Fit(ref Chords, camera.needsMotion, "Rill.Water.Chords", Faces.width, Faces.height);
            Fit(ref Sun, mesh.caustics != null, "Rill.Water.RaySun", across, up);
            Fit(ref Phases, mesh.phases != null, "Rill.Water.RayPhases", across, up);
            Fit(ref Spray, mesh.HasSpray, "Rill.Water.Spray", across, up);
            Fit(ref Bubbles, mesh.HasFoam, "Rill.Water.Bubbles", across, up);
            Tiles.Fit(across, up);
            Properties.SetBuffer(Ids.WaterTiles, Tiles.Tiles);
            Properties.SetTexture(Ids.RayFaces, Faces);
            Properties.SetTexture(Ids.RayEnds, Ends);
            Properties.SetTexture(Ids.RayDirections, Directions);
            Properties.SetTexture(Ids.RayMirrors, Mirrors);
            // The shaders do not read what stands in for a missing texture.
            Properties.SetTexture(Ids.RaySun, Sun != null ? Sun : Ends);
            Properties.SetTexture(Ids.RayPhases, Phases != null ? Phases : Ends);
            if (Spray != null)
                Properties.SetTexture(Ids.Spray, Spray);
            if (Bubbles != null)
                Properties.SetTexture(Ids.Bubbles, Bubbles);
        }

        /// <summary>Sets which part of the picture is in use, as far as the textures go.</summary>
        public void SetWindow(in FluidViews camera, Vector4 bounds, in MeshFrame mesh)
        {
            Window = PictureWindow.Of(camera, bounds, mesh.rayScale).Within(Faces.width, Faces.height);
            CoarseWindow = Window.Coarser(Divisor(camera, mesh)).Within(Ends.width, Ends.height);
        }

        public override void Dispose()
        {
            base.Dispose();
            ReleaseTextures();
        }

        public void Describe(StageDescription stage)
        {
            stage.Texture(Faces);
            stage.Texture(Ends);
            stage.Texture(Directions);
            stage.Texture(Mirrors);
            stage.Texture(Chords);
            stage.Texture(Sun);
            stage.Texture(Phases);
            stage.Texture(Spray);
            stage.Texture(Bubbles);
            Tiles.Describe(stage);
        }

        void Make(int eyes)
        {
            ReleaseTextures();
            Faces = GpuTexture.CreateLayers("Rill.Water.RayFaces", size.Width, size.Height, eyes, GraphicsFormat.R32G32B32A32_SFloat, true);
        }

        // Returns how many texels of the window one of the coarse window is wide: 1, 2 or 4.
        static int Divisor(in FluidViews camera, in MeshFrame mesh)
        {
            int lines = PictureWindow.Scaled(camera.height, mesh.rayScale);
            return lines <= mesh.fineLines ? 1 : (lines + 1) / 2 <= mesh.fineLines ? 2 : 4;
        }

        // A texture of half floats that is there only where something needs it.
        void Fit(ref RenderTexture layer, bool isNeeded, string name, int width, int height)
        {
            if (layer != null && (!isNeeded || layer.width != width || layer.height != height || layer.volumeDepth != Faces.volumeDepth))
                EngineObject.Release(ref layer);
            if (isNeeded && layer == null)
                layer = GpuTexture.CreateLayers(name, width, height, Faces.volumeDepth, GraphicsFormat.R16G16B16A16_SFloat, true);
        }

        void ReleaseTextures()
        {
            EngineObject.Release(ref Faces);
            EngineObject.Release(ref Ends);
            EngineObject.Release(ref Directions);
            EngineObject.Release(ref Mirrors);
            EngineObject.Release(ref Chords);
            EngineObject.Release(ref Sun);
            EngineObject.Release(ref Phases);
            EngineObject.Release(ref Spray);
            EngineObject.Release(ref Bubbles);
            Tiles.Release();
        }

        /// <summary>Properties of WaterRays.compute, WaterSpray.compute and Water.hlsl.</summary>
        public static class Ids
        {
            public static readonly int RayFaces = Shader.PropertyToID("_RayFaces");
            public static readonly int RayEnds = Shader.PropertyToID("_RayEnds");
            public static readonly int RayDirections = Shader.PropertyToID("_RayDirections");
            public static readonly int RayMirrors = Shader.PropertyToID("_RayMirrors");
            public static readonly int RayChords = Shader.PropertyToID("_RayChords");
            public static readonly int RaySun = Shader.PropertyToID("_RaySun");
            public static readonly int RayPhases = Shader.PropertyToID("_RayPhases");
            public static readonly int Spray = Shader.PropertyToID("_Spray");
            public static readonly int Bubbles = Shader.PropertyToID("_Bubbles");
            public static readonly int WaterTiles = Shader.PropertyToID("_WaterTiles");
        }
    }
}
