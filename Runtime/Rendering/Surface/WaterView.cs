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

        /// <summary>Floats; the others are half floats.</summary>
        public RenderTexture Faces;

        public RenderTexture Ends, Directions, Mirrors;

        /// <summary>See SprayLayer.hlsl; null where there is neither spray nor foam, and without foam.</summary>
        public RenderTexture Spray, Bubbles;

        /// <summary>The part of the picture that they hold, from their first texel on.</summary>
        public PictureWindow Window;

        /// <summary>That part of the picture in texels of <see cref="Spray"/>.</summary>
        public PictureWindow SprayWindow;

        // More texels than this from the bottom to the top of a picture show no more of what is small.
        const int SprayLines = 1440;

        ScreenSize size;

        public WaterView(Camera camera) : base(camera, "Rill.Water.Constants") => SetConstants(Properties);

        /// <summary>Whether the textures do for a frame as they are.</summary>
        /// <param name="bounds">Lowest x and y, highest x and y of the fluid's box on the picture, -1 to 1.</param>
        public bool Holds(in FluidViews camera, Vector4 bounds, in MeshFrame mesh)
        {
            PictureWindow window = PictureWindow.Of(camera, bounds, mesh.rayScale);
            return Ends != null && Ends.volumeDepth == camera.eyes && window.Width <= Ends.width && window.Height <= Ends.height
                && camera.needsMotion == (Chords != null) && mesh.HasSpray == (Spray != null) && mesh.HasFoam == (Bubbles != null);
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
                maxHeight) || Ends == null || Ends.volumeDepth != camera.eyes)
                Make(camera.eyes);
            Properties.SetTexture(Ids.RayFaces, Faces);
            Properties.SetTexture(Ids.RayEnds, Ends);
            Properties.SetTexture(Ids.RayDirections, Directions);
            Properties.SetTexture(Ids.RayMirrors, Mirrors);
            int divisor = SprayDivisor(camera, scale), across = (Ends.width + divisor - 1) / divisor, up = (Ends.height + divisor - 1) / divisor;
            Fit(ref Chords, camera.needsMotion, "Rill.Water.Chords", Ends.width, Ends.height);
            Fit(ref Spray, mesh.HasSpray, "Rill.Water.Spray", across, up);
            Fit(ref Bubbles, mesh.HasFoam, "Rill.Water.Bubbles", across, up);
            if (Spray != null)
                Properties.SetTexture(Ids.Spray, Spray);
            if (Bubbles != null)
                Properties.SetTexture(Ids.Bubbles, Bubbles);
        }

        /// <summary>Sets which part of the picture is in use, as far as the textures go.</summary>
        public void Place(in FluidViews camera, Vector4 bounds, float scale)
        {
            Window = PictureWindow.Of(camera, bounds, scale).Within(Ends.width, Ends.height);
            SprayWindow = Window.Coarser(SprayDivisor(camera, scale));
            if (Spray != null)
                SprayWindow = SprayWindow.Within(Spray.width, Spray.height);
        }

        public override void Dispose()
        {
            base.Dispose();
            ReleaseTextures();
        }

        public void Describe(StageDescription stage)
        {
            SurfaceView.Describe(stage, Faces);
            SurfaceView.Describe(stage, Ends);
            SurfaceView.Describe(stage, Directions);
            SurfaceView.Describe(stage, Mirrors);
            SurfaceView.Describe(stage, Chords);
            SurfaceView.Describe(stage, Spray);
            SurfaceView.Describe(stage, Bubbles);
        }

        void Make(int eyes)
        {
            ReleaseTextures();
            Faces = Make("Rill.Water.RayFaces", eyes, GraphicsFormat.R32G32B32A32_SFloat);
            Ends = Make("Rill.Water.RayEnds", eyes);
            Directions = Make("Rill.Water.RayDirections", eyes);
            Mirrors = Make("Rill.Water.RayMirrors", eyes);
        }

        // 1, 2 or 4.
        static int SprayDivisor(in FluidViews camera, float scale)
        {
            int lines = PictureWindow.Scaled(camera.height, scale);
            return lines <= SprayLines ? 1 : lines <= 2 * SprayLines ? 2 : 4;
        }

        // A texture that is there only where something needs it.
        void Fit(ref RenderTexture layer, bool isNeeded, string name, int width, int height)
        {
            if (layer != null && (!isNeeded || layer.width != width || layer.height != height || layer.volumeDepth != Ends.volumeDepth))
                EngineObject.Release(ref layer);
            if (isNeeded && layer == null)
                layer = SurfaceView.Make(name, width, height, Ends.volumeDepth, GraphicsFormat.R16G16B16A16_SFloat, true);
        }

        RenderTexture Make(string name, int eyes, GraphicsFormat format = GraphicsFormat.R16G16B16A16_SFloat)
            => SurfaceView.Make(name, size.Width, size.Height, eyes, format, true);

        void ReleaseTextures()
        {
            EngineObject.Release(ref Faces);
            EngineObject.Release(ref Ends);
            EngineObject.Release(ref Directions);
            EngineObject.Release(ref Mirrors);
            EngineObject.Release(ref Chords);
            EngineObject.Release(ref Spray);
            EngineObject.Release(ref Bubbles);
        }

        /// <summary>Properties of WaterRays.compute, WaterSpray.compute and Water.hlsl.</summary>
        public static class Ids
        {
            public static readonly int RayFaces = Shader.PropertyToID("_RayFaces");
            public static readonly int RayEnds = Shader.PropertyToID("_RayEnds");
            public static readonly int RayDirections = Shader.PropertyToID("_RayDirections");
            public static readonly int RayMirrors = Shader.PropertyToID("_RayMirrors");
            public static readonly int RayChords = Shader.PropertyToID("_RayChords");
            public static readonly int Spray = Shader.PropertyToID("_Spray");
            public static readonly int Bubbles = Shader.PropertyToID("_Bubbles");
        }
    }
}
