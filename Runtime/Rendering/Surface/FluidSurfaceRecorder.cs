using System;
using System.Collections.Generic;
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

        const int DepthPass = 0, ChordPass = 2; // of SurfaceRaster.shader

        /// <summary>texels</summary>
        [GenerateHlsl("SurfaceFilter", Signed = true)] const int MaxFilterRadius = 32;


        readonly ComputeShader filter;
        Material raster;
        readonly SurfaceThickness thickness;
        SurfaceFoam foam;       // these two are made when first needed
        SurfaceMotion motion;
        readonly Kernel filterRows, filterRowsAgain, filterColumns, findNormals;
        readonly CameraParts<SurfaceView> views = new CameraParts<SurfaceView>();
        readonly List<SurfaceView> replaced = new List<SurfaceView>();
        readonly MaterialPropertyBlock properties = new MaterialPropertyBlock();

        /// <summary>Why no surface can be drawn on this device; null where one can.</summary>
        public static string DeviceProblem => GpuTexture.WhyNot(RenderTextureFormat.Depth, false)
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
        public SurfaceView ViewOf(Camera camera)
        {
            SurfaceView found = views.Find(camera);
            if (found == null)
                views.Add(found = new SurfaceView(camera));
            found.LastFrame = Time.frameCount;
            return found;
        }

        /// <summary>What a draw of this camera may still show in this frame is no longer shown, until it is recorded again.</summary>
        public void TurnOff(Camera camera) => views.Find(camera)?.TurnOff();

        /// <summary>Whether <see cref="Prepare"/> has found that the camera sees the fluid in the picture that it draws now.</summary>
        public bool IsPreparedFor(Camera camera) => views.Find(camera) is SurfaceView view && view.IsPrepared;

        /// <summary>Makes the camera's textures and what its shading draw reads of them, before anything is recorded: a render pipeline
        /// wants that draw before it culls.</summary>
        /// <param name="fluid">What is drawn.</param>
        /// <returns>Whether the camera sees the fluid's box; there is nothing to record and to draw otherwise.</returns>
        public bool Prepare(in FluidViews camera, in SurfaceFrame fluid)
        {
            TurnOff(camera.camera);
            DisposeReplaced();
            BoxOnPicture box = BoxOnPicture.Of(camera, fluid);
            if (!box.IsSeen)
                return false;
            SurfaceView view = ViewOf(camera.camera);
            if (view.IsSubmitted && !view.IsSubmittedFor(camera.width, camera.height))
                view = Replace(view);
            view.IsPrepared = true;
            float pixels = SurfaceConstants.PixelsPerMeter(camera.projection, camera.height);
            float scale = ScaleOf(fluid, pixels / box.NearestDepth);
            int divisor = SurfaceThickness.DivisorFor(scale * fluid.spacing * pixels / box.MiddleDepth);
            view.Prepare(Scaled(camera.width, scale), Scaled(camera.height, scale), camera.eyes, divisor, fluid.phases);
            view.PrepareFoam(fluid.foam.particles != null);
            view.PrepareMotion(camera.needsMotion);
            SetShading(view);
            if (camera.needsMotion)
                (motion ??= new SurfaceMotion()).Set(view, fluid);
            return true;
        }

        // The draw that waits goes on holding its textures, and shows nothing.
        SurfaceView Replace(SurfaceView view)
        {
            views.Remove(view);
            replaced.Add(view);
            return ViewOf(view.Camera);
        }

        void DisposeReplaced()
        {
            for (int i = replaced.Count - 1; i >= 0; i--)
            {
                if (replaced[i].IsSubmitted)
                    continue;
                replaced[i].Dispose();
                replaced.RemoveAt(i);
            }
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
            constants.surfaceSize = SurfaceIds.SizeOf(view.Smoothed);
            constants.foamColor = fluid.foam.color;
            view.Write(cmd, constants);
            var state = new SurfaceState(fluid.version, fluid.lag.x, fluid.filterRadius, fluid.domainToWorld, camera);
            bool isShown = view.Shown.HasValue && view.Shown.Value.Equals(state);
            view.SetConstants(properties);
            fluid.SetOn(properties);
            if (!isShown)
            {
                RecordDepth(cmd, camera, fluid, view);
                RecordFilter(cmd, camera, fluid, view, bounds);
                view.Shown = state;
            }
            view.HasMotion = view.Chords != null;
            thickness.Record(cmd, raster, camera, fluid, view);      // the scene in it may have moved
            if (view.Foam != null)
                (foam ??= new SurfaceFoam()).Record(cmd, camera, fluid, view);
        }

        /// <summary>Draws motion vectors into what is bound, after <see cref="Record"/> of the same frame; nothing where the camera needs
        /// none.</summary>
        public void RecordMotion(CommandBuffer cmd, in FluidViews camera)
        {
            SurfaceView view = views.Find(camera.camera);
            if (view != null && view.IsPrepared && view.HasMotion)
                motion.Record(cmd, view);
        }

        /// <summary>Submits the draw of motion vectors, after <see cref="Prepare"/> of a camera that needs them.</summary>
        public void SubmitMotion(in RenderParams parameters) => motion.Submit(parameters);

        public void Dispose()
        {
            views.Clear();
            foreach (SurfaceView view in replaced)
                view.Dispose();
            replaced.Clear();
            motion?.Dispose();
            motion = null;
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
                    (foam ??= new SurfaceFoam()).Describe(stage, eyes, view);
                view.Describe(stage);
            }
        }

        void RecordDepth(CommandBuffer cmd, in FluidViews camera, in SurfaceFrame fluid, SurfaceView view)
        {
            cmd.BeginSample(DepthMarker);
            bool hasChords = view.Chords != null;
            for (int eye = 0; eye < camera.eyes; eye++)
            {
                properties.SetInt(SurfaceIds.SurfaceEye, eye);
                if (hasChords)
                    cmd.SetRenderTarget(view.Chords, view.Drawn, 0, CubemapFace.Unknown, eye);
                else
                    cmd.SetRenderTarget(view.Drawn, 0, CubemapFace.Unknown, eye);
                cmd.ClearRenderTarget(true, hasChords, Color.clear);
                cmd.DrawProceduralIndirect(Matrix4x4.identity, raster, hasChords ? ChordPass : DepthPass, MeshTopology.Triangles,
                    fluid.surfaceArguments, 0, properties);
            }
            cmd.EndSample(DepthMarker);
        }

        // bounds: what the fluid's box covers of the picture; the rest was drawn empty.
        void RecordFilter(CommandBuffer cmd, in FluidViews camera, in SurfaceFrame fluid, SurfaceView view, Vector4 bounds)
        {
            int width = view.Width, height = view.Height;
            int left = Mathf.Clamp((int)((bounds.x * 0.5f + 0.5f) * width), 0, width - 1),
                right = Mathf.Clamp((int)((bounds.z * 0.5f + 0.5f) * width) + 1, left + 1, width);
            int bottom = Mathf.Clamp((int)((bounds.y * 0.5f + 0.5f) * height), 0, height - 1),
                top = Mathf.Clamp((int)((bounds.w * 0.5f + 0.5f) * height) + 1, bottom + 1, height);
            view.SetConstants(cmd, filter);
            cmd.SetComputeVectorParam(filter, Ids.FilterBounds, new Vector4(left, bottom, right, top));
            int passes = camera.IsProbe ? 1 : fluid.filterPasses;
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
                    cmd.SetComputeTextureParam(filter, rows, Ids.Filtered, view.Rows);
                    SurfaceIds.Dispatch(cmd, filter, rows, right - left, top - bottom);
                    cmd.SetComputeTextureParam(filter, filterColumns, SurfaceIds.Depth, view.Rows);
                    cmd.SetComputeTextureParam(filter, filterColumns, Ids.Filtered, view.Smoothed);
                    SurfaceIds.Dispatch(cmd, filter, filterColumns, right - left, top - bottom);
                }
                cmd.EndSample(FilterMarker);

                cmd.BeginSample(NormalsMarker);
                cmd.SetComputeTextureParam(filter, findNormals, SurfaceIds.Depth, view.Smoothed);
                cmd.SetComputeTextureParam(filter, findNormals, Ids.Normals, view.Normals);
                SurfaceIds.Dispatch(cmd, filter, findNormals, right - left, top - bottom);
                cmd.EndSample(NormalsMarker);
            }
        }

        void SetFilterEye(CommandBuffer cmd, in FluidViews camera, in SurfaceFrame fluid, SurfaceView view, int eye)
        {
            cmd.SetComputeIntParam(filter, SurfaceIds.SurfaceEye, eye);
            float texels = camera.IsProbe ? 0f : SurfaceConstants.PixelsPerMeter(camera.ProjectionOf(eye), view.Height);
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

        // Where the filter would be wider than its kernel holds, the textures get smaller: a close-up costs no more than a wide view.
        static float ScaleOf(in SurfaceFrame fluid, float pixelsPerMeter)
        {
            float scale = fluid.scale;
            while (scale > 0.25f && fluid.filterRadius * pixelsPerMeter * scale > 1.5f * MaxFilterRadius)
                scale *= 0.5f;
            return scale;
        }

        static int Scaled(int pixels, float scale) => Math.Max((int)(pixels * scale), 1);

        static class Ids
        {
            public static readonly int FilterBounds = Shader.PropertyToID("_FilterBounds");
            public static readonly int FilterRadius = Shader.PropertyToID("_FilterRadius");
            public static readonly int Filtered = Shader.PropertyToID("_Filtered");
            public static readonly int Normals = Shader.PropertyToID("_Normals");
            public static readonly int SurfaceNormals = Shader.PropertyToID("_SurfaceNormals");
            public static readonly int SurfaceThickness = Shader.PropertyToID("_SurfaceThickness");
            public static readonly int SurfaceFoam = Shader.PropertyToID("_SurfaceFoam");
        }
    }
}
