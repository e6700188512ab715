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
        static readonly ProfilerMarker ThicknessMarker = GpuMarker.Create("Rill.Surface.Thickness");
        static readonly ProfilerMarker BlurMarker = GpuMarker.Create("Rill.Surface.Blur");

        const string FilterFile = "SurfaceFilter";
        const int DepthPass = 0, ThicknessPass = 1;
        const int MaxFilterRadius = 32;         // texels, kMaxRadius in SurfaceFilter.compute
        const float ThicknessBlur = 2f;         // two standard deviations, d
        const int FramesKept = 3;               // for which a camera may stay away
        const string SceneArrayKeyword = "RILL_SCENE_ARRAY";

        readonly ComputeShader filter;
        Material raster;
        readonly int filterRows, filterRowsAgain, filterColumns, findNormals, blurThickness;
        readonly List<SurfaceView> views = new List<SurfaceView>();
        readonly MaterialPropertyBlock properties = new MaterialPropertyBlock();
        readonly SurfaceConstants constants = new SurfaceConstants();
        readonly LocalKeyword sceneArray;

        public FluidSurfaceRecorder()
        {
            StageShader stage = StageShader.Load("SurfaceViews");
            filter = StageShader.LoadCompute("SurfaceViews");
            raster = new Material(stage.Shader) { hideFlags = HideFlags.HideAndDontSave };
            sceneArray = new LocalKeyword(stage.Shader, SceneArrayKeyword);
            filterRows = filter.FindKernel("FilterRows");
            filterRowsAgain = filter.FindKernel("FilterRowsAgain");
            filterColumns = filter.FindKernel("FilterColumns");
            findNormals = filter.FindKernel("FindNormals");
            blurThickness = filter.FindKernel("BlurThickness");
        }

        /// <summary>The textures of a camera; made when it first asks. Those of cameras that draw no more are given back.</summary>
        public SurfaceView ViewOf(Camera camera)
        {
            int frame = Time.frameCount;
            SurfaceView found = null;
            for (int i = views.Count - 1; i >= 0; i--)
            {
                if (ReferenceEquals(views[i].Camera, camera))
                    found = views[i];
                else if (views[i].Camera == null || frame - views[i].LastFrame > FramesKept)
                {
                    views[i].Dispose();
                    views.RemoveAt(i);
                }
            }
            if (found == null)
                views.Add(found = new SurfaceView(camera));
            found.LastFrame = frame;
            return found;
        }

        /// <summary>Makes the camera's textures and what its shading draw reads of them, before anything is recorded: a render pipeline wants that draw before it culls.</summary>
        /// <param name="fluid">What is drawn.</param>
        /// <returns>Whether the camera sees the fluid's box; there is nothing to record and to draw otherwise.</returns>
        public bool Prepare(in FluidViews camera, in SurfaceFrame fluid)
        {
            constants.Set(camera);
            Vector4 bounds = BoundsOnPicture(camera, fluid, constants, out float nearest);
            if (bounds.x >= bounds.z || bounds.y >= bounds.w)
                return false;
            SurfaceView view = ViewOf(camera.camera);
            view.Constants.Set(camera);
            view.Bounds = bounds;
            view.IsPrepared = true;
            float scale = ScaleOf(camera, fluid, nearest);
            view.Prepare(Scaled(camera.width, scale), Scaled(camera.height, scale), camera.eyes);
            SetShading(view, bounds, camera);
            return true;
        }

        /// <summary>Records everything that has changed since the camera's last frame; nothing where it was not prepared since the last call.</summary>
        /// <param name="camera">As <see cref="Prepare"/> had it.</param>
        /// <param name="fluid">As <see cref="Prepare"/> had it.</param>
        public void Record(CommandBuffer cmd, in FluidViews camera, in SurfaceFrame fluid)
        {
            SurfaceView view = ViewOf(camera.camera);
            if (!view.IsPrepared)
                return;
            view.IsPrepared = false;
            var state = new SurfaceState(fluid.version, fluid.lag.x, fluid.filterRadius, fluid.domainToWorld, view.Constants);
            bool isShown = view.Shown.HasValue && view.Shown.Value.Equals(state);
            Set(properties, fluid, view.Constants);
            if (!isShown)
            {
                RecordDepth(cmd, camera, fluid, view);
                RecordFilter(cmd, camera, fluid, view, view.Bounds);
                view.Shown = state;
            }
            RecordThickness(cmd, camera, fluid, view);      // the scene in it may have moved
        }

        public void Dispose()
        {
            foreach (SurfaceView view in views)
                view.Dispose();
            views.Clear();
            EngineObject.Destroy(ref raster);
        }

        /// <summary>What a frame costs for the cameras that have drawn lately, and their textures.</summary>
        /// <param name="filterPasses">How often the filter runs.</param>
        public void Describe(StageDescription stage, int filterPasses)
        {
            foreach (SurfaceView view in views)
            {
                if (view.Smoothed == null)
                    continue;
                int eyes = view.Smoothed.volumeDepth;
                stage.Kernel(FilterFile, "FilterRows", eyes);
                if (filterPasses > 1)
                    stage.Kernel(FilterFile, "FilterRowsAgain", eyes * (filterPasses - 1));
                stage.Kernel(FilterFile, "FilterColumns", eyes * filterPasses);
                stage.Kernel(FilterFile, "FindNormals", eyes);
                stage.Kernel(FilterFile, "BlurThickness", eyes);
                stage.Draw("SurfaceRaster", 2 * eyes);
                view.Describe(stage);
            }
        }

        void RecordDepth(CommandBuffer cmd, in FluidViews camera, in SurfaceFrame fluid, SurfaceView view)
        {
            cmd.BeginSample(DepthMarker);
            properties.SetVector(Ids.SurfaceSize, SizeOf(view.Width, view.Height));
            for (int eye = 0; eye < camera.eyes; eye++)
            {
                properties.SetInt(Ids.SurfaceEye, eye);
                cmd.SetRenderTarget(view.Drawn, 0, CubemapFace.Unknown, eye);
                cmd.ClearRenderTarget(true, false, Color.clear);
                cmd.DrawProceduralIndirect(Matrix4x4.identity, raster, DepthPass, MeshTopology.Triangles, fluid.surfaceArguments, 0, properties);
            }
            cmd.EndSample(DepthMarker);
        }

        void RecordThickness(CommandBuffer cmd, in FluidViews camera, in SurfaceFrame fluid, SurfaceView view)
        {
            cmd.BeginSample(ThicknessMarker);
            cmd.SetKeyword(raster, sceneArray, camera.sceneIsArray);
            properties.SetVector(Ids.SurfaceSize, SizeOf(view.Thickness.width, view.Thickness.height));
            properties.SetVector(Ids.SceneSize, camera.sceneSize);
            for (int eye = 0; eye < camera.eyes; eye++)
            {
                properties.SetInt(Ids.SurfaceEye, eye);
                cmd.SetRenderTarget(view.DrawnThickness, 0, CubemapFace.Unknown, eye);
                cmd.ClearRenderTarget(false, true, Color.clear);
                cmd.DrawProceduralIndirect(Matrix4x4.identity, raster, ThicknessPass, MeshTopology.Triangles, fluid.particleArguments, 0, properties);
            }
            cmd.EndSample(ThicknessMarker);

            cmd.BeginSample(BlurMarker);
            SetFilter(cmd, view);
            cmd.SetComputeVectorParam(filter, Ids.ThicknessSize, SizeOf(view.Thickness.width, view.Thickness.height));
            for (int eye = 0; eye < camera.eyes; eye++)
            {
                SetFilterEye(cmd, camera, fluid, view, eye);
                cmd.SetComputeTextureParam(filter, blurThickness, Ids.Depth, view.Smoothed);
                cmd.SetComputeTextureParam(filter, blurThickness, Ids.Drawn, view.DrawnThickness);
                cmd.SetComputeTextureParam(filter, blurThickness, Ids.Thickness, view.Thickness);
                Dispatch(cmd, blurThickness, view.Thickness.width, view.Thickness.height);
            }
            cmd.EndSample(BlurMarker);
        }

        void RecordFilter(CommandBuffer cmd, in FluidViews camera, in SurfaceFrame fluid, SurfaceView view, Vector4 bounds)
        {
            // Texels that the fluid's box covers: the rest was drawn empty.
            int width = view.Width, height = view.Height;
            int left = Mathf.Clamp((int)((bounds.x * 0.5f + 0.5f) * width), 0, width - 1), right = Mathf.Clamp((int)((bounds.z * 0.5f + 0.5f) * width) + 1, left + 1, width);
            int bottom = Mathf.Clamp((int)((bounds.y * 0.5f + 0.5f) * height), 0, height - 1), top = Mathf.Clamp((int)((bounds.w * 0.5f + 0.5f) * height) + 1, bottom + 1, height);
            SetFilter(cmd, view);
            cmd.SetComputeVectorParam(filter, Ids.FilterBounds, new Vector4(left, bottom, right, top));
            for (int eye = 0; eye < camera.eyes; eye++)
            {
                SetFilterEye(cmd, camera, fluid, view, eye);
                cmd.BeginSample(FilterMarker);
                for (int i = 0; i < fluid.filterPasses; i++)
                {
                    int rows = i == 0 ? filterRows : filterRowsAgain;
                    if (i == 0)
                        cmd.SetComputeTextureParam(filter, rows, Ids.Depth, view.Drawn, 0, RenderTextureSubElement.Depth);
                    else
                        cmd.SetComputeTextureParam(filter, rows, Ids.Depth, view.Smoothed);
                    cmd.SetComputeTextureParam(filter, rows, Ids.Filtered, view.Rows);
                    Dispatch(cmd, rows, right - left, top - bottom);
                    cmd.SetComputeTextureParam(filter, filterColumns, Ids.Depth, view.Rows);
                    cmd.SetComputeTextureParam(filter, filterColumns, Ids.Filtered, view.Smoothed);
                    Dispatch(cmd, filterColumns, right - left, top - bottom);
                }
                cmd.EndSample(FilterMarker);

                cmd.BeginSample(NormalsMarker);
                cmd.SetComputeTextureParam(filter, findNormals, Ids.Depth, view.Smoothed);
                cmd.SetComputeTextureParam(filter, findNormals, Ids.Normals, view.Normals);
                Dispatch(cmd, findNormals, right - left, top - bottom);
                cmd.EndSample(NormalsMarker);
            }
        }

        void SetFilter(CommandBuffer cmd, SurfaceView view)
        {
            cmd.SetComputeMatrixArrayParam(filter, Ids.WorldToClip, view.Constants.WorldToClip);
            cmd.SetComputeVectorArrayParam(filter, Ids.Rays, view.Constants.Rays);
            cmd.SetComputeVectorArrayParam(filter, Ids.Depths, view.Constants.Depths);
            cmd.SetComputeVectorParam(filter, Ids.SurfaceSize, SizeOf(view.Width, view.Height));
            cmd.SetComputeVectorParam(filter, Ids.FilterBounds, new Vector4(0f, 0f, view.Width, view.Height));
        }

        void SetFilterEye(CommandBuffer cmd, in FluidViews camera, in SurfaceFrame fluid, SurfaceView view, int eye)
        {
            cmd.SetComputeIntParam(filter, Ids.SurfaceEye, eye);
            float texels = SurfaceConstants.PixelsPerMetre(camera.ProjectionOf(eye), view.Height);
            cmd.SetComputeVectorParam(filter, Ids.FilterRadius, new Vector4(fluid.filterRadius * texels, fluid.filterRange, ThicknessBlur * fluid.spacing * 0.5f * texels, 0f));
        }

        // A thread for each texel.
        void Dispatch(CommandBuffer cmd, int kernel, int width, int height)
        {
            filter.GetKernelThreadGroupSizes(kernel, out uint x, out uint y, out _);
            cmd.DispatchCompute(filter, kernel, (width + (int)x - 1) / (int)x, (height + (int)y - 1) / (int)y, 1);
        }

        static void Set(MaterialPropertyBlock block, in SurfaceFrame fluid, SurfaceConstants constants)
        {
            Set(block, constants);
            block.SetMatrix(Ids.DomainToWorld, fluid.domainToWorld);
            block.SetFloat(Ids.ParticleSpacing, fluid.spacing);
            block.SetVector(Ids.FrameLag, fluid.lag);
            block.SetVector(Ids.DrawnDomainSize, fluid.domainSize);
            block.SetBuffer(Ids.SurfaceParticles, fluid.surfaceParticles);
            block.SetBuffer(Ids.Positions, fluid.positions);
            block.SetBuffer(Ids.StartPositions, fluid.startPositions);
            block.SetBuffer(Ids.Velocities, fluid.velocities);
            block.SetBuffer(Ids.Counters, fluid.counters);
        }

        static void Set(MaterialPropertyBlock block, SurfaceConstants constants)
        {
            block.SetMatrixArray(Ids.WorldToClip, constants.WorldToClip);
            block.SetVectorArray(Ids.Rays, constants.Rays);
            block.SetVectorArray(Ids.Depths, constants.Depths);
        }

        // What Surface.hlsl reads of this camera.
        static void SetShading(SurfaceView view, Vector4 bounds, in FluidViews camera)
        {
            MaterialPropertyBlock block = view.Shading;
            Set(block, view.Constants);
            block.SetVector(Ids.SurfaceSize, SizeOf(view.Width, view.Height));
            block.SetVector(Ids.PictureBounds, bounds);
            block.SetVector(Ids.SceneSize, camera.sceneSize);
            block.SetTexture(Ids.SurfaceDepth, view.Smoothed);
            block.SetTexture(Ids.SurfaceNormals, view.Normals);
            block.SetTexture(Ids.SurfaceThickness, view.Thickness);
        }

        // Lowest and highest x and y of the box's corners on the picture, of all eyes; everything where a corner is not in front.
        static Vector4 BoundsOnPicture(in FluidViews camera, in SurfaceFrame fluid, SurfaceConstants constants, out float nearest)
        {
            var bounds = new Vector4(1f, 1f, -1f, -1f);
            nearest = float.MaxValue;
            bool isWhole = false, isSeen = false;
            for (int i = 0; i < 8 * camera.eyes; i++)
            {
                var corner = new Vector4((i & 1) != 0 ? fluid.domainSize.x + 1f : -1f, (i & 2) != 0 ? fluid.domainSize.y + 1f : -1f, (i & 4) != 0 ? fluid.domainSize.z + 1f : -1f, 1f);
                Vector4 clip = constants.WorldToClip[i / 8] * (fluid.domainToWorld * corner);
                nearest = Mathf.Min(nearest, clip.w);
                isWhole |= clip.w <= 1e-4f;
                isSeen |= clip.w > 0f;
                Vector2 at = new Vector2(clip.x, clip.y) / Mathf.Max(clip.w, 1e-4f);
                bounds = new Vector4(Mathf.Min(bounds.x, at.x), Mathf.Min(bounds.y, at.y), Mathf.Max(bounds.z, at.x), Mathf.Max(bounds.w, at.y));
            }
            if (isWhole)
                return isSeen ? new Vector4(-1f, -1f, 1f, 1f) : Vector4.zero;
            return new Vector4(Mathf.Clamp(bounds.x, -1f, 1f), Mathf.Clamp(bounds.y, -1f, 1f), Mathf.Clamp(bounds.z, -1f, 1f), Mathf.Clamp(bounds.w, -1f, 1f));
        }

        // Where the filter would be wider than its kernel holds, the textures get smaller: a close-up costs no more than a wide view.
        static float ScaleOf(in FluidViews camera, in SurfaceFrame fluid, float nearest)
        {
            float scale = fluid.scale;
            bool isOrthographic = camera.projection.m32 == 0f;
            float radius = fluid.filterRadius * SurfaceConstants.PixelsPerMetre(camera.projection, camera.height) / (isOrthographic ? 1f : Mathf.Max(nearest, 4f * fluid.spacing));
            while (scale > 0.25f && radius * scale > 1.5f * MaxFilterRadius)
                scale *= 0.5f;
            return scale;
        }

        static int Scaled(int pixels, float scale) => Math.Max((int)(pixels * scale), 1);

        static Vector4 SizeOf(int width, int height) => new Vector4(width, height, 1f / width, 1f / height);

        static class Ids
        {
            public static readonly int WorldToClip = Shader.PropertyToID("_SurfaceWorldToClip");
            public static readonly int Rays = Shader.PropertyToID("_SurfaceRays");
            public static readonly int Depths = Shader.PropertyToID("_SurfaceDepths");
            public static readonly int SurfaceSize = Shader.PropertyToID("_SurfaceSize");
            public static readonly int SurfaceEye = Shader.PropertyToID("_SurfaceEye");
            public static readonly int FilterBounds = Shader.PropertyToID("_FilterBounds");
            public static readonly int FilterRadius = Shader.PropertyToID("_FilterRadius");
            public static readonly int Depth = Shader.PropertyToID("_Depth");
            public static readonly int Filtered = Shader.PropertyToID("_Filtered");
            public static readonly int Drawn = Shader.PropertyToID("_Drawn");
            public static readonly int Thickness = Shader.PropertyToID("_Thickness");
            public static readonly int ThicknessSize = Shader.PropertyToID("_ThicknessSize");
            public static readonly int Normals = Shader.PropertyToID("_Normals");
            public static readonly int SurfaceDepth = Shader.PropertyToID("_SurfaceDepth");
            public static readonly int SurfaceNormals = Shader.PropertyToID("_SurfaceNormals");
            public static readonly int SurfaceThickness = Shader.PropertyToID("_SurfaceThickness");
            public static readonly int PictureBounds = Shader.PropertyToID("_PictureBounds");
            public static readonly int SceneSize = Shader.PropertyToID("_SceneSize");
            public static readonly int DomainToWorld = Shader.PropertyToID("_DomainToWorld");
            public static readonly int ParticleSpacing = Shader.PropertyToID("_ParticleSpacing");
            public static readonly int FrameLag = Shader.PropertyToID("_FrameLag");
            public static readonly int DrawnDomainSize = Shader.PropertyToID("_DrawnDomainSize");
            public static readonly int SurfaceParticles = Shader.PropertyToID("_SurfaceParticles");
            public static readonly int Positions = Shader.PropertyToID("_Positions");
            public static readonly int StartPositions = Shader.PropertyToID("_StartPositions");
            public static readonly int Velocities = Shader.PropertyToID("_Velocities");
            public static readonly int Counters = Shader.PropertyToID("_Counters");
        }
    }
}
