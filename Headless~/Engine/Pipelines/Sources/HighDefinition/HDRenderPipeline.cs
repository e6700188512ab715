using System;
using System.Collections.Generic;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Headless;

namespace UnityEngine.Rendering.HighDefinition
{
    /// <summary>
    /// All cameras begin before the first is drawn. Of each: depth, opaque draws, sky, custom passes, draws before the refraction, the copy
    /// of the color for what refracts, custom passes, transparent draws, picture. Textures are arrays with a slice for each eye, larger
    /// than the camera, which
    /// uses their first texels; what lies beyond is magenta. No shadow maps, lights or volumes of its own; no tone mapping.
    /// </summary>
    /// <remarks>
    /// HDRP 16.0: Runtime/RenderPipeline/HDRenderPipeline.cs (Render: BeginCameraRendering, culling and custom pass volumes of all cameras
    /// come before ExecuteRenderRequest), HDRenderPipeline.RenderGraph.cs (order of passes; the color pyramid is made
    /// where refraction is on; single pass from the prepass on, custom passes included), HDRenderPipeline.Prepass.cs (motion vectors come with the
    /// prepass, or a black texture for them where they are off; those of the camera itself are left out here: they stay 0), CustomPass.cs
    /// (a pass may write them), Runtime/RenderPipeline/HDRenderQueue.cs (ranges of queues), Runtime/ShaderLibrary/TextureXR.hlsl (arrays).
    /// </remarks>
    public class HDRenderPipeline : RenderPipeline
    {
        const float Scale = 0.7f, HistoryScale = 0.8f;      // of what a camera uses of the textures, and of those that live on
        const int FirstBeforeRefraction = 2650, LastBeforeRefraction = 2850, FirstTransparent = 2900, LastTransparent = 3100;

        static readonly int depthId = Shader.PropertyToID("_CameraDepthTexture"), pyramidId = Shader.PropertyToID("_ColorPyramidTexture"),
            motionId = Shader.PropertyToID("_CameraMotionVectorsTexture");
        static readonly Func<string, bool> depthOnly = mode => mode == "DepthForwardOnly" || mode == "DepthOnly";
        static readonly Func<string, bool> forward = mode => mode == "" || mode == "SRPDefaultUnlit" || mode == "ForwardOnly";

        readonly HDRenderPipelineAsset asset;
        readonly HighDefinitionVariables variables = new HighDefinitionVariables();
        RTHandle color, depth, motion, depthPyramid, colorPyramid, black;

        /// <summary>Value in the color buffer of one unit of light.</summary>
        internal static float Exposure = 1;

        public HDRenderPipeline(HDRenderPipelineAsset asset)
        {
            this.asset = asset;
            Shader.globalRenderPipeline = "HDRenderPipeline";
            // Intensities are physical, as in HDRP.
            GraphicsSettings.lightsUseLinearIntensity = GraphicsSettings.lightsUseColorTemperature = true;
        }

#if SRP_17
        [Obsolete("Of arrays")]
#endif
#if SRP_17_3
        protected override void Render(ScriptableRenderContext context, Camera[] cameras) => Render(context, new List<Camera>(cameras));
#else
        protected override void Render(ScriptableRenderContext renderContext, Camera[] cameras) => Render(renderContext, new List<Camera>(cameras));
#endif

        protected override void Render(ScriptableRenderContext renderContext, List<Camera> cameras)
        {
            BeginContextRendering(renderContext, cameras);
            var begun = new List<HDCamera>();
            foreach (Camera camera in cameras)
            {
                if (camera.pixelWidth <= 0 || camera.pixelHeight <= 0)
                    continue;
                foreach (XRPass pass in XRPass.AllOf(camera, HDCamera.AllowsHeadset(camera)))
                {
                    HDCamera seen = HDCamera.GetOrCreate(camera, pass.multipassId);
                    seen.Update(asset.currentPlatformRenderPipelineSettings, pass);
                    BeginCameraRendering(renderContext, camera);
                    begun.Add(seen);
                }
            }
            foreach (HDCamera camera in begun)
            {
                try
                {
                    FrameRenderer.Cull(camera.camera);
                    Draw(renderContext, camera);
                }
                finally
                {
                    camera.xr.StopSinglePass();
                    FrameRenderer.EndCulled();
                    Gpu.ClosePass();
                    RenderState.SetCameraTarget(null);
                    RenderState.SetTarget(null);
                }
                EndCameraRendering(renderContext, camera.camera);
            }
            EndContextRendering(renderContext, cameras);
        }

        void Draw(ScriptableRenderContext context, HDCamera hd)
        {
            Camera camera = hd.camera;
            var viewport = new Rect(0, 0, hd.actualWidth, hd.actualHeight);
            MakeTargets(hd);
            RenderState.SetCameraTarget(camera.targetTexture);
            BuiltinVariables.SetTime();
            variables.SetLighting(Exposure);
            variables.SetCamera(hd);
            HighDefinitionVariables.WithholdLoose();
            Shader.SetGlobalTexture(depthId, black.rt);
            Shader.SetGlobalTexture(pyramidId, black.rt);

            hd.xr.StartSinglePass();
            Run(CustomPassInjectionPoint.BeforeRendering, context, hd);
            ClearMotion(hd, viewport);
            Bind(null, depthPyramid, viewport);
            RenderState.Clear(true, false, default, 1);
            FrameRenderer.DrawCulled(0, FrameRenderer.LastOpaqueQueue, depthOnly);
            Shader.Globals.SetTexture(depthId, depthPyramid.rt, RenderTextureSubElement.Depth);
            Run(CustomPassInjectionPoint.AfterOpaqueDepthAndNormal, context, hd);

            Bind(color, depth, viewport);
            RenderState.Clear(true, true, camera.backgroundColor, 1);
            FrameRenderer.DrawCulled(0, FrameRenderer.LastOpaqueQueue, forward);
            DrawSky(hd, viewport);
            Run(CustomPassInjectionPoint.BeforePreRefraction, context, hd);
            Bind(color, depth, viewport);
            FrameRenderer.DrawCulled(FirstBeforeRefraction, LastBeforeRefraction, forward);
            if (hd.frameSettings.IsEnabled(FrameSettingsField.Refraction))
                CopyColor(hd, viewport);
            Run(CustomPassInjectionPoint.BeforeTransparent, context, hd);
            Bind(color, depth, viewport);
            FrameRenderer.DrawCulled(FirstTransparent, LastTransparent, forward);

            hd.xr.StopSinglePass();
            for (int slice = 0; slice < hd.Slices; slice++)
                Headless.Blitter.BlitSlice(color.rt, hd.xr.enabled ? StereoView.Eyes : camera.targetTexture, slice,
                    slice + hd.xr.multipassId, PartOf(color, hd));
            if (hd.xr.enabled)
                StereoView.Show();
        }

        void ClearMotion(HDCamera hd, Rect viewport)
        {
            Shader.SetGlobalTexture(motionId, black.rt);
            if (!hd.frameSettings.IsEnabled(FrameSettingsField.MotionVectors))
                return;
            Bind(motion, null, viewport);
            RenderState.Clear(false, true, Color.clear, 1);
            Shader.SetGlobalTexture(motionId, motion.rt);
        }

        // HDRP's own skies are volumes; the scene's stands for them.
        void DrawSky(HDCamera hd, Rect viewport)
        {
            Camera camera = hd.camera;
            if (RenderSettings.skybox == null || camera.clearFlags != CameraClearFlags.Skybox)
                return;
            BuiltinVariables.SetSun();
            BuiltinVariables.SetCamera(camera, camera.pixelWidth, camera.pixelHeight);
            hd.xr.StopSinglePass();
            for (int slice = 0; slice < hd.Slices; slice++)
            {
                Bind(color, depth, viewport, slice);
                if (hd.xr.enabled)
                    BuiltinVariables.SetViewProjection(hd.xr.GetViewMatrix(slice), hd.xr.GetProjMatrix(slice));
                Sky.Draw(camera);
            }
            hd.xr.StartSinglePass();
            HighDefinitionVariables.WithholdLoose();
        }

        void CopyColor(HDCamera hd, Rect viewport)
        {
            RenderState.SetTarget(colorPyramid.rt, 0, RenderTargetIdentifier.AllDepthSlices);
            RenderState.Clear(false, true, Color.magenta, 1);
            hd.xr.StopSinglePass();
            for (int slice = 0; slice < hd.Slices; slice++)
                Headless.Blitter.BlitSlice(color.rt, colorPyramid.rt, slice, slice, PartOf(color, hd), viewport);
            hd.xr.StartSinglePass();
            Shader.SetGlobalTexture(pyramidId, colorPyramid.rt);
        }

        void Run(CustomPassInjectionPoint point, ScriptableRenderContext context, HDCamera hd)
        {
            if (!hd.frameSettings.IsEnabled(FrameSettingsField.CustomPass))
                return;
            foreach (CustomPassVolume volume in CustomPassVolume.Of(hd.camera, point))
                foreach (CustomPass pass in volume.customPasses)
                    if (pass != null && pass.WillBeExecuted(hd.camera))
                        Run(pass, context, hd);
        }

        void Run(CustomPass pass, ScriptableRenderContext context, HDCamera hd)
        {
            CommandBuffer cmd = CommandBufferPool.Get(pass.name);
            try
            {
                bool hasColor = pass.targetColorBuffer == CustomPass.TargetBuffer.Camera,
                    hasDepth = pass.targetDepthBuffer == CustomPass.TargetBuffer.Camera;
                if (hasColor || hasDepth)
                    Bind(hasColor ? color : null, hasDepth ? depth : null, new Rect(0, 0, hd.actualWidth, hd.actualHeight));
                pass.Run(new CustomPassContext(context, cmd, hd, CullingResults.OfScene(), color, depth,
                    hd.frameSettings.IsEnabled(FrameSettingsField.MotionVectors) ? motion : black));
                cmd.Execute();
            }
            finally
            {
                CommandBufferPool.Release(cmd);
            }
        }

        void MakeTargets(HDCamera hd)
        {
            RTHandle.Need(ref color, "_CameraColorBuffer", Shape(hd, Scale, GraphicsFormat.R16G16B16A16_SFloat), FilterMode.Point);
            RTHandle.Need(ref depth, "_CameraDepthStencilBuffer", Shape(hd, Scale, GraphicsFormat.None), FilterMode.Point);
            RTHandle.Need(ref motion, "Motion Vectors", Shape(hd, Scale, GraphicsFormat.R16G16_SFloat), FilterMode.Point);
            // The smaller mips lie below the first, in one texture.
            RenderTextureDescriptor packed = Shape(hd, Scale, GraphicsFormat.None);
            packed.height += packed.height / 2;
            RTHandle.Need(ref depthPyramid, "_CameraDepthBufferMipChain", packed, FilterMode.Point);
            RTHandle.Need(ref colorPyramid, "_CameraColorBufferMipChain", Shape(hd, HistoryScale, GraphicsFormat.R16G16B16A16_SFloat),
                FilterMode.Bilinear);
            if (black != null && black.rt.volumeDepth == hd.Slices)
                return;
            RTHandle.Need(ref black, "_BlackTexture",
                new RenderTextureDescriptor(1, 1, GraphicsFormat.R8G8B8A8_UNorm,
                GraphicsFormat.None) { dimension = TextureDimension.Tex2DArray, volumeDepth = hd.Slices }, FilterMode.Point);
            RenderState.SetTarget(black.rt, 0, RenderTargetIdentifier.AllDepthSlices);
            RenderState.Clear(false, true, Color.clear, 1);
        }

        static RenderTextureDescriptor Shape(HDCamera hd, float scale, GraphicsFormat format) =>
            new RenderTextureDescriptor(Mathf.CeilToInt(hd.actualWidth / scale), Mathf.CeilToInt(hd.actualHeight / scale), format,
            format == GraphicsFormat.None ? GraphicsFormat.D32_SFloat : GraphicsFormat.None)
            {
                dimension = TextureDimension.Tex2DArray, volumeDepth = hd.Slices,
            };

        static Vector2 PartOf(RTHandle handle, HDCamera hd)
            => new Vector2((float)hd.actualWidth / handle.rt.width, (float)hd.actualHeight / handle.rt.height);

        static readonly List<RenderTexture> colors = new List<RenderTexture>();

        static void Bind(RTHandle color, RTHandle depth, Rect viewport, int slice = RenderTargetIdentifier.AllDepthSlices)
        {
            colors.Clear();
            if (color != null)
                colors.Add(color.rt);
            RenderState.SetTargets(colors, depth?.rt, 0, slice);
            RenderState.SetViewport(viewport);
        }

        protected override void Dispose(bool disposing)
        {
            foreach (RTHandle handle in new[] { color, depth, motion, depthPyramid, colorPyramid, black })
                handle?.Release();
            color = depth = motion = depthPyramid = colorPyramid = black = null;
            variables.Dispose();
            HDCamera.Reset();
            CommandBufferPool.Reset();
            GraphicsSettings.lightsUseLinearIntensity = GraphicsSettings.lightsUseColorTemperature = false;
            Shader.globalRenderPipeline = "";
        }
    }
}
