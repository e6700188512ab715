using System;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>
    /// Fills the textures from which a fluid's surface is shaded, for any camera in any render pipeline: the ellipsoids' depth,
    /// smoothed on the picture, its normals, and how much water a ray goes through.
    /// </summary>
    /// <remarks>Records into the caller's command buffer; sets no globals. Textures belong to the camera and live as long as it draws.</remarks>
    sealed class FluidSurfaceRecorder : IDisposable
    {
        static readonly ProfilerMarker DepthMarker = GpuMarker.Create("Rill.Surface.Depth");
        static readonly ProfilerMarker FilterMarker = GpuMarker.Create("Rill.Surface.Filter");
        static readonly ProfilerMarker NormalsMarker = GpuMarker.Create("Rill.Surface.Normals");

        const float ScaleHysteresis = 1.25f;
        const int DepthPass = 0, ChordPass = 2; // of SurfaceRaster.shader

        /// <summary>texels</summary>
        [GenerateHlsl("SurfaceFilter", Signed = true)] const int MaxFilterRadius = 32;


        readonly ComputeShader filter;
        Material raster;
        readonly SurfaceThickness thickness;
        SurfaceFoam foam;       // made when first needed
        readonly Kernel filterRows, filterRowsAgain, filterColumns, findNormals;
        readonly CameraViews<SurfaceView> views = new CameraViews<SurfaceView>(camera => new SurfaceView(camera));
        readonly MaterialPropertyBlock properties = new MaterialPropertyBlock();

        /// <summary>Why no surface can be drawn on this device; null where one can, and where there are no compute shaders, which the fluid says
        /// itself.</summary>
        public static string DeviceProblem => !SystemInfo.supportsComputeShaders ? null : GpuTexture.WhyNot(RenderTextureFormat.Depth, false)
            ?? GpuTexture.WhyNot(RenderTextureFormat.RFloat, false) ?? GpuTexture.WhyNot(RenderTextureFormat.RFloat, true)
            ?? GpuTexture.WhyNot(RenderTextureFormat.ARGBHalf, false) ?? GpuTexture.WhyNot(RenderTextureFormat.ARGBHalf, true);

        public FluidSurfaceRecorder()
        {
            StageShader stage = StageShader.Load("SurfaceViews");
            filter = StageShader.LoadCompute("SurfaceViews");
            raster = new Material(stage.Shader) { hideFlags = HideFlags.HideAndDontSave };
            thickness = new SurfaceThickness(stage.Shader);
            filterRows = new Kernel(filter, "FilterRows");
            filterRowsAgain = new Kernel(filter, "FilterRowsAgain");
            filterColumns = new Kernel(filter, "FilterColumns");
            findNormals = new Kernel(filter, "FindNormals");
        }

        /// <summary>The textures of a camera; made when it first asks. Those of cameras that draw no more are given back.</summary>
        public SurfaceView ViewOf(Camera camera) => views.ViewOf(camera);

        /// <summary>Returns the textures of a camera; null for one that has none.</summary>
        public CameraView Find(Camera camera) => views.Find(camera);

        /// <summary>What a draw of this camera may still show in this frame is no longer shown, until it is recorded again.</summary>
        public void TurnOff(Camera camera) => views.TurnOff(camera);

        /// <summary>Whether <see cref="Prepare"/> has found that the camera sees the fluid in the picture that it draws now.</summary>
        public bool IsPreparedFor(Camera camera) => views.IsPreparedFor(camera);

        /// <summary>Makes the camera's textures and what its shading draw reads of them, before anything is recorded: a render pipeline
        /// wants that draw before it culls.</summary>
        /// <param name="fluid">What is drawn.</param>
        /// <returns>Whether the camera sees the fluid's box; there is nothing to record and to draw otherwise.</returns>
        public bool Prepare(in FluidViews camera, in SurfaceFrame fluid)
        {
            TurnOff(camera.camera);
            views.DisposeReplaced();
            BoxOnPicture box = BoxOnPicture.Of(camera, fluid);
            if (!box.IsSeen)
                return false;
            SurfaceView view = ViewOf(camera.camera);
            float pixels = SurfaceConstants.PixelsPerMeter(camera.projection, camera.height);
            view.Scale = ScaleOf(fluid, pixels / box.NearestDepth, view.Scale);
            view.ThicknessDivisor = SurfaceThickness.DivisorFor(view.Scale * fluid.spacing * pixels / box.MiddleDepth, view.ThicknessDivisor);
            if (view.IsSubmitted && !(view.IsSubmittedFor(camera.width, camera.height) && view.Holds(camera, box.Bounds, fluid)))
            {
                SurfaceView next = views.Replace(view);
                (next.Scale, next.ThicknessDivisor) = (view.Scale, view.ThicknessDivisor);
                view = next;
            }
            view.IsPrepared = true;
            if (!view.IsSubmitted)
                view.Prepare(camera, box.Bounds, fluid);
            SurfaceScratch.Shared.Prepare(view);
            SetShading(view);
            if (camera.needsMotion)
                SurfaceMotion.Set(view, view.Smoothed, fluid.lag, fluid.domainToWorld, fluid.lastDomainToWorld);
            return true;
        }

        /// <summary>Records everything that has changed since the camera's last picture; nothing where this one was not prepared.</summary>
        /// <param name="camera">As <see cref="Prepare"/> had it, with the matrices that the camera draws with; not more eyes.</param>
        /// <param name="fluid">As <see cref="Prepare"/> had it.</param>
        /// <param name="constants">Of the fluid's look; the camera's are filled in.</param>
        public void Record(CommandBuffer cmd, in FluidViews camera, in SurfaceFrame fluid, SurfaceConstants constants = default)
        {
            SurfaceView view = views.Find(camera.camera);
            if (view == null || !view.IsPrepared)
                return;
            view.LastFrame = Time.frameCount;
            Vector4 bounds = BoxOnPicture.Of(camera, fluid).Bounds;
            constants.Set(camera);
            constants.pictureBounds = bounds;
            view.Place(camera, bounds);
            (constants.surfaceSize, constants.surfaceWindow) = (view.Window.Grid, view.Window.Rect);
            (constants.thicknessSize, constants.thicknessWindow) = (view.ThicknessWindow.Grid, view.ThicknessWindow.Rect);
            (constants.foamSize, constants.foamWindow) = (view.FoamWindow.Grid, view.FoamWindow.Rect);
            constants.foamColor = fluid.foam.color;
            view.Write(cmd, constants);
            int passes = camera.IsProbe ? 1 : fluid.filterPasses;
            var state = new SurfaceState(fluid, passes, camera, view.Window);
            bool isShown = view.Shown.HasValue && view.Shown.Value.Equals(state);
            view.SetConstants(properties);
            fluid.SetOn(properties);
            if (!isShown)
            {
                RecordDepth(cmd, camera, fluid, view);
                RecordFilter(cmd, camera, fluid, view, passes);
                view.Shown = state;
            }
            view.HasMotion = view.Chords != null;
            thickness.Record(cmd, raster, camera, fluid, view);      // the scene in it may have moved
            if (view.Foam != null)
                (foam ??= new SurfaceFoam()).Record(cmd, camera, fluid, view);
        }

        public void Dispose()
        {
            views.Dispose();
            EngineObject.Destroy(ref raster);
        }

        /// <summary>What a frame costs for the cameras that have drawn lately, and their textures.</summary>
        /// <param name="filterPasses">How often the filter runs.</param>
        public void Describe(StageDescription stage, int filterPasses)
        {
            for (int i = 0; i < views.Count; i++)
            {
                SurfaceView view = views[i];
                if (view.Smoothed == null)
                    continue;
                int eyes = view.Smoothed.volumeDepth;
                stage.Kernel(filterRows, eyes);
                if (filterPasses > 1)
                    stage.Kernel(filterRowsAgain, eyes * (filterPasses - 1));
                stage.Kernel(filterColumns, eyes * filterPasses);
                stage.Kernel(findNormals, eyes);
                stage.Draw("SurfaceRaster", eyes);
                if (view.Chords != null)
                    stage.Draw("SurfaceMotion", 1);
                thickness.Describe(stage, eyes, view);
                if (view.Foam != null)
                    (foam ??= new SurfaceFoam()).Describe(stage, eyes);
                view.Describe(stage);
            }
            if (views.Count > 0)
                SurfaceScratch.Shared.Describe(stage);
        }

        /// <summary>Once a frame: gives back what belongs to cameras that have not seen the fluid lately.</summary>
        public void ReleaseUnused()
        {
            views.ReleaseUnused();
        }

        void RecordDepth(CommandBuffer cmd, in FluidViews camera, in SurfaceFrame fluid, SurfaceView view)
        {
            cmd.BeginSample(DepthMarker);
            bool hasChords = view.Chords != null;
            var window = new Rect(0f, 0f, view.Window.Width, view.Window.Height);
            for (int eye = 0; eye < camera.eyes; eye++)
            {
                properties.SetInt(SurfaceIds.SurfaceEye, eye);
                if (hasChords)
                    cmd.SetRenderTarget(view.Chords, view.Drawn, 0, CubemapFace.Unknown, eye);
                else
                    cmd.SetRenderTarget(view.Drawn, 0, CubemapFace.Unknown, eye);
                // Before the viewport makes the clear one of a part: a tiler need not load then what was there.
                cmd.ClearRenderTarget(true, hasChords, Color.clear);
                cmd.SetViewport(window);
                cmd.DrawProceduralIndirect(Matrix4x4.identity, raster, hasChords ? ChordPass : DepthPass, MeshTopology.Triangles,
                    fluid.surfaceArguments, 0, properties);
            }
            cmd.EndSample(DepthMarker);
        }

        void RecordFilter(CommandBuffer cmd, in FluidViews camera, in SurfaceFrame fluid, SurfaceView view, int passes)
        {
            int width = view.Window.Width, height = view.Window.Height;
            RenderTexture filtered = SurfaceScratch.Shared.Rows;
            view.SetConstants(cmd, filter);
            for (int eye = 0; eye < camera.eyes; eye++)
            {
                SetFilterEye(cmd, camera, fluid, view, eye);
                cmd.BeginSample(FilterMarker);
                for (int i = 0; i < passes; i++)
                {
                    int rows = i == 0 ? filterRows : filterRowsAgain;
                    if (i == 0)
                        cmd.SetComputeTextureParam(filter, rows, SurfaceIds.Depth, view.Drawn, 0, RenderTextureSubElement.Depth);
                    else
                        cmd.SetComputeTextureParam(filter, rows, SurfaceIds.Depth, view.Smoothed);
                    cmd.SetComputeTextureParam(filter, rows, Ids.Filtered, filtered);
                    SurfaceIds.Dispatch(cmd, filter, rows, width, height);
                    cmd.SetComputeTextureParam(filter, filterColumns, SurfaceIds.Depth, filtered);
                    cmd.SetComputeTextureParam(filter, filterColumns, Ids.Filtered, view.Smoothed);
                    SurfaceIds.Dispatch(cmd, filter, filterColumns, width, height);
                }
                cmd.EndSample(FilterMarker);

                cmd.BeginSample(NormalsMarker);
                cmd.SetComputeTextureParam(filter, findNormals, SurfaceIds.Depth, view.Smoothed);
                cmd.SetComputeTextureParam(filter, findNormals, Ids.Normals, view.Normals);
                SurfaceIds.Dispatch(cmd, filter, findNormals, width, height);
                cmd.EndSample(NormalsMarker);
            }
        }

        void SetFilterEye(CommandBuffer cmd, in FluidViews camera, in SurfaceFrame fluid, SurfaceView view, int eye)
        {
            cmd.SetComputeIntParam(filter, SurfaceIds.SurfaceEye, eye);
            float texels = camera.IsProbe ? 0f : SurfaceConstants.PixelsPerMeter(camera.ProjectionOf(eye), view.Window.Grid.y);
            cmd.SetComputeVectorParam(filter, Ids.FilterRadius, new Vector4(fluid.filterRadius * texels, fluid.filterRange, 0f, 0f));
        }

        // What Surface.hlsl reads of this camera.
        static void SetShading(SurfaceView view)
        {
            MaterialPropertyBlock block = view.Shading;
            view.SetConstants(block);
            block.SetTexture(SurfaceIds.SurfaceDepth, view.Smoothed);
            block.SetTexture(Ids.SurfaceNormals, view.Normals);
            block.SetTexture(Ids.SurfaceThickness, view.Thickness);
            if (view.Foam != null)
                block.SetTexture(Ids.SurfaceFoam, view.Foam);
        }

        // Where the filter would be wider than its kernel holds, the textures get smaller: a close-up costs no more than a wide view. The last
        // scale stays while it is near to what fits.
        static float ScaleOf(in SurfaceFrame fluid, float pixelsPerMeter, float last)
        {
            float scale = ScaleOf(fluid, pixelsPerMeter);
            return last == 0f ? scale : Mathf.Clamp(last, ScaleOf(fluid, pixelsPerMeter * ScaleHysteresis), scale);
        }

        static float ScaleOf(in SurfaceFrame fluid, float pixelsPerMeter)
        {
            float scale = fluid.scale;
            while (scale > 0.25f && fluid.filterRadius * pixelsPerMeter * scale > 1.5f * MaxFilterRadius)
                scale *= 0.5f;
            return scale;
        }

        static class Ids
        {
            public static readonly int FilterRadius = Shader.PropertyToID("_FilterRadius");
            public static readonly int Filtered = Shader.PropertyToID("_Filtered");
            public static readonly int Normals = Shader.PropertyToID("_Normals");
            public static readonly int SurfaceNormals = Shader.PropertyToID("_SurfaceNormals");
            public static readonly int SurfaceThickness = Shader.PropertyToID("_SurfaceThickness");
            public static readonly int SurfaceFoam = Shader.PropertyToID("_SurfaceFoam");
        }
    }
}
