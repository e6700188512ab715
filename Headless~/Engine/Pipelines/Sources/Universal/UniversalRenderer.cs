using System;
using System.Collections.Generic;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Headless;
#if SRP_17
using UnityEngine.Rendering.RenderGraphModule;
#endif

namespace UnityEngine.Rendering.Universal
{
    /// <summary>
    /// Forward: shadow map, depth prepass where a pass reads depth before the opaque draws, opaque draws, sky, copies of depth and color
    /// where somebody reads them, transparent draws, blit. Always through an intermediate texture, never with several samples.
    /// </summary>
    /// <remarks>
    /// Execute: Setup in Runtime/UniversalRenderer.cs (14.0.x): passes are sorted by event, URP's own of the same event
    /// come after those of users; depth is copied one before the first event that reads it, or after the opaque draws; color
    /// after the sky. A target is bound only where it is another than the last that the renderer bound (SetRenderPassAttachments in
    /// Runtime/ScriptableRenderer.cs, 17.1.0): who binds one of his own and leaves it spoils the next draws.
    /// Render graph: OnMainRendering in Runtime/UniversalRendererRenderGraph.cs (17.1.0): all passes from one event up to
    /// the next run there; every pass of URP's binds its own targets.
    /// Two eyes: RenderCameraStack and UpdateCameraData in Runtime/UniversalRenderPipeline.cs (17.1.0): textures are those of the headset,
    /// arrays of two
    /// slices; BeginXRRendering in Runtime/ScriptableRenderer.cs: single pass from after the shadows on, passes of users included.
    /// Motion vectors: Runtime/Passes/MotionVectorRenderPass.cs (17.1.0 and one of 14): drawn where temporal antialiasing or a pass asks,
    /// before the post processing in 14, after the copy of depth in 17; the depth that it tests is the scene's; objects of the opaque
    /// queue alone; sets DepthTextureMode.MotionVectors on the camera and never clears it. The motion of the camera itself, which URP
    /// draws there, is left out: it stays 0.
    /// </remarks>
    public sealed class UniversalRenderer : ScriptableRenderer
    {
        static readonly int depthTextureId = Shader.PropertyToID("_CameraDepthTexture"),
            opaqueTextureId = Shader.PropertyToID("_CameraOpaqueTexture");
        static readonly Func<string, bool> forward = mode => mode == "" || mode == "SRPDefaultUnlit" || mode == "UniversalForward"
            || mode == "UniversalForwardOnly";
        static readonly Func<string, bool> depthOnly = mode => mode == "DepthOnly";
        static readonly Func<string, bool> motionVectors = mode => mode == "MotionVectors";
        static readonly int motionTextureId = Shader.PropertyToID("_MotionVectorTexture"),
            motionDepthId = Shader.PropertyToID("_MotionVectorDepthTexture"),
            motionParams = Shader.PropertyToID("unity_MotionVectorsParams");

        readonly MainLightShadows shadows = new MainLightShadows();
        RTHandle colorAttachment, depthAttachment, depthTexture, opaqueTexture, motionColor, motionDepth;
        RenderTexture boundColor, boundDepth;
        Frame frame;

        public UniversalRenderer(UniversalRendererData data) : base(data) { }

        // State of the current frame.
        struct Frame
        {
            public ScriptableRenderContext context;
            public UniversalRenderPipelineAsset settings;
            public Camera camera, baseCamera;
            public UniversalAdditionalCameraData data;
            public RTHandle color, depth;
            public CameraMatrices matrices;
            public RenderTextureDescriptor shape;
            public int next, earliestDepth;
            public XRPass xr;
            public bool needsDepth, needsColor, needsMotion, isJittered, isLast, isOverlay;
            public RenderingData legacy;
#if SRP_17
            public ContextContainer items;
            public RenderGraph graph;
            public UniversalResourceData resources;
#endif
        }

        internal void Render(ScriptableRenderContext context, UniversalRenderPipelineAsset settings, Camera camera, Camera baseCamera,
            UniversalRenderer baseRenderer, XRPass xr, bool isLast)
        {
            camera.TryGetComponent(out UniversalAdditionalCameraData data);
            frame = new Frame { context = context, settings = settings, camera = camera, baseCamera = baseCamera, data = data, xr = xr,
                isLast = isLast, isOverlay = camera != baseCamera };
            SetCamera();
            AddRenderPasses(ref frame.legacy);
            SortPasses();
            FindInputs();
            MakeTargets(baseRenderer);
            SetTargets(frame.color, frame.depth);
            try
            {
#if SRP_17
                if (!UniversalRenderPipeline.IsCompatibilityMode)
                    RecordAndExecuteGraph();
                else
#endif
                    ExecutePasses();
                if (isLast)
                    Show();
            }
            finally
            {
                FinishRendering();
#if SRP_17
                frame.items.Dispose();
#endif
                frame = default;
                context.Submit();
            }
        }

        void SetCamera()
        {
            Camera camera = frame.camera;
            // A scale within 0.05 of 1 is 1, and so is that of cameras that are not the game's (InitializeStackedCameraData).
            float asked = frame.settings.renderScale, scale = Math.Abs(1 - asked) < 0.05f || !UniversalRenderPipeline.IsGameCamera(camera)
                ? 1 : asked;
            int width = Math.Max((int)(camera.pixelWidth * scale), 1), height = Math.Max((int)(camera.pixelHeight * scale), 1);
            // The headset's, which are scaled by all of renderScale, near 1 or not (XRSystem.SetRenderScale).
            if (frame.xr.enabled)
                (width, height) = (Math.Max((int)(frame.xr.renderTargetDesc.width * asked), 1),
                    Math.Max((int)(frame.xr.renderTargetDesc.height * asked), 1));
            frame.shape = Shape(width, height, frame.settings.supportsHDR && camera.allowHDR ? GraphicsFormat.R16G16B16A16_SFloat
                : Player.LinearColorSpace ? GraphicsFormat.R8G8B8A8_SRGB : GraphicsFormat.R8G8B8A8_UNorm, GraphicsFormat.None);
            frame.isJittered = TemporalJitter.IsOn(camera, frame.data);
            Matrix4x4 jitter = frame.isJittered ? Jitter.MatrixOf(Time.frameCount, width, height) : Matrix4x4.identity;
            frame.matrices = new CameraMatrices { view = camera.worldToCameraMatrix, projection = camera.projectionMatrix, jitter = jitter,
                xr = frame.xr };
            CameraRenderType type = frame.isOverlay ? CameraRenderType.Overlay : CameraRenderType.Base;
            AntialiasingMode antialiasing = frame.data != null ? frame.data.antialiasing : AntialiasingMode.None;
#if SRP_17
            frame.items = new ContextContainer();
            UniversalCameraData to = frame.items.Create<UniversalCameraData>();
            frame.resources = frame.items.Create<UniversalResourceData>();
            frame.legacy = new RenderingData { frameData = frame.items, cameraData = new CameraData { data = to } };
#else
            ref CameraData to = ref frame.legacy.cameraData;
#endif
            to.camera = camera;
            to.baseCamera = frame.baseCamera;
            to.renderType = type;
            to.cameraType = camera.cameraType;
            to.targetTexture = frame.baseCamera.targetTexture;
            to.cameraTargetDescriptor = frame.shape;
            to.renderer = this;
            to.antialiasing = antialiasing;
            to.renderScale = scale;
            to.clearDepth = frame.data == null || frame.data.clearDepth;
            to.resolveFinalTarget = frame.isLast;
            to.postProcessEnabled = frame.data != null && frame.data.renderPostProcessing;
            to.xr = frame.matrices.xr;
            to.matrices = frame.matrices;
        }

        // GetRenderPassInputs and InitializeAdditionalCameraData.
        void FindInputs()
        {
            frame.needsDepth = frame.settings.supportsCameraDepthTexture || frame.data != null && frame.data.requiresDepthTexture
                || frame.camera.cameraType == CameraType.SceneView;
            frame.needsColor = frame.settings.supportsCameraOpaqueTexture || frame.data != null && frame.data.requiresColorTexture;
            frame.earliestDepth = int.MaxValue;
            foreach (ScriptableRenderPass pass in activeRenderPassQueue)
            {
                if ((pass.input & ScriptableRenderPassInput.Depth) != 0)
                {
                    frame.needsDepth = true;
                    frame.earliestDepth = Math.Min(frame.earliestDepth, (int)pass.renderPassEvent);
                }
                frame.needsColor |= (pass.input & ScriptableRenderPassInput.Color) != 0;
                frame.needsMotion |= (pass.input & ScriptableRenderPassInput.Motion) != 0;
            }
            frame.needsMotion |= frame.isJittered;
            if (!frame.needsMotion)
                return;
            frame.needsDepth = true;
            frame.earliestDepth = Math.Min(frame.earliestDepth, (int)MotionEvent);
        }

#if SRP_17
        const RenderPassEvent MotionEvent = RenderPassEvent.AfterRenderingSkybox + 1;       // one after the copy of depth, as a renderer is made
#else
        const RenderPassEvent MotionEvent = RenderPassEvent.BeforeRenderingPostProcessing;
#endif

        void MakeTargets(UniversalRenderer baseRenderer)
        {
            if (frame.isOverlay)
            {
                frame.color = baseRenderer.colorAttachment;
                frame.depth = baseRenderer.depthAttachment;
                frame.shape = frame.color.rt.descriptor;
            }
            else
            {
                frame.color = RTHandle.Need(ref colorAttachment, "_CameraColorAttachmentA", frame.shape, FilterMode.Bilinear);
                frame.depth = RTHandle.Need(ref depthAttachment, "_CameraDepthAttachment", DepthShape(frame.shape), FilterMode.Point);
            }
            if (frame.needsDepth)
                RTHandle.Need(ref depthTexture, "_CameraDepthTexture", DepthShape(frame.shape), FilterMode.Point);
            else
                Shader.SetGlobalTexture(depthTextureId, Texture2D.blackTexture);       // UniversalRenderer.Setup does so
            if (frame.needsColor)
            {
                RenderTextureDescriptor shape = frame.shape;
                int divisor = frame.settings.opaqueDownsampling == Downsampling.None ? 1
                    : frame.settings.opaqueDownsampling == Downsampling._2xBilinear ? 2 : 4;
                (shape.width, shape.height) = (Math.Max(shape.width / divisor, 1), Math.Max(shape.height / divisor, 1));
                RTHandle.Need(ref opaqueTexture, "_CameraOpaqueTexture", shape, divisor == 1 ? FilterMode.Point : FilterMode.Bilinear);
            }
        }

        // In a graph of 17 there are handles to them in every frame; memory where a pass uses them.
        void MakeMotionTargets()
        {
            RTHandle.Need(ref motionColor, "_MotionVectorTexture",
                Shape(frame.shape.width, frame.shape.height, GraphicsFormat.R16G16_SFloat, GraphicsFormat.None), FilterMode.Point);
            RTHandle.Need(ref motionDepth, "_MotionVectorDepthTexture", DepthShape(frame.shape), FilterMode.Point);
        }

        RenderTextureDescriptor DepthShape(RenderTextureDescriptor shape)
            => Shape(shape.width, shape.height, GraphicsFormat.None, GraphicsFormat.D32_SFloat);

        RenderTextureDescriptor Shape(int width, int height, GraphicsFormat color, GraphicsFormat depth)
        {
            var shape = new RenderTextureDescriptor(width, height, color, depth);
            if (frame.xr.singlePassEnabled)
                (shape.dimension, shape.volumeDepth) = (TextureDimension.Tex2DArray, frame.xr.viewCount);
            return shape;
        }

        // ---- by Execute

        void ExecutePasses()
        {
            int copiesDepth = frame.earliestDepth <= (int)RenderPassEvent.BeforeRenderingOpaques ? -1
                : frame.earliestDepth < int.MaxValue ? Math.Min((int)RenderPassEvent.AfterRenderingTransparents, frame.earliestDepth - 1)
                : (int)RenderPassEvent.AfterRenderingOpaques;
            (boundColor, boundDepth) = (null, null);
            SetUpCameras();
            var steps = new List<(int At, Action Run)>
            {
                ((int)RenderPassEvent.BeforeRenderingShadows, DrawShadows),
                ((int)RenderPassEvent.BeforeRenderingPrePasses - 1, frame.xr.StartSinglePass),
                ((int)RenderPassEvent.BeforeRenderingPrePasses, () => { if (frame.needsDepth && copiesDepth < 0) DrawDepth(); }),
                ((int)RenderPassEvent.BeforeRenderingOpaques, () => { Bind(frame.color.rt, frame.depth.rt); Clear(); DrawOpaque(); }),
                ((int)RenderPassEvent.BeforeRenderingSkybox, () => { Bind(frame.color.rt, frame.depth.rt); DrawSky(); }),
                ((int)RenderPassEvent.AfterRenderingSkybox, () => { if (frame.needsColor) CopyColor(); }),
                ((int)RenderPassEvent.BeforeRenderingTransparents, () => { Bind(frame.color.rt, frame.depth.rt); DrawTransparent(); }),
            };
            if (frame.needsMotion)
            {
                MakeMotionTargets();
                steps.Insert(steps.FindIndex(step => step.At > (int)MotionEvent) is int motionAt && motionAt >= 0 ? motionAt : steps.Count,
                    ((int)MotionEvent, DrawMotion));
            }
            if (frame.needsDepth && copiesDepth >= 0)
                steps.Insert(steps.FindIndex(step => step.At > copiesDepth) is int at && at >= 0 ? at : steps.Count, (copiesDepth, CopyDepth));
            foreach ((int at, Action run) in steps)
            {
                ExecuteUpTo(at);
                run();
            }
            ExecuteUpTo(int.MaxValue);
        }

        void ExecuteUpTo(int last)
        {
            for (; frame.next < activeRenderPassQueue.Count && (int)activeRenderPassQueue[frame.next].renderPassEvent <= last; frame.next++)
            {
                ScriptableRenderPass pass = activeRenderPassQueue[frame.next];
                if ((int)pass.renderPassEvent >= (int)RenderPassEvent.BeforeRenderingPrePasses)
                    Bind(frame.color.rt, frame.depth.rt);
                Guard(pass, () =>
                {
#pragma warning disable CS0618
                    pass.Execute(frame.context, ref frame.legacy);
#pragma warning restore CS0618
                });
            }
        }

        void Bind(RenderTexture color, RenderTexture depth)
        {
            if (ReferenceEquals(color, boundColor) && ReferenceEquals(depth, boundDepth))
                return;
            (boundColor, boundDepth) = (color, depth);
            BindNow(color, depth);
        }

#if SRP_17
        // ---- by the render graph

        void RecordAndExecuteGraph()
        {
            RenderGraph graph = frame.graph = new RenderGraph();
            graph.BeginRecording();
            frame.resources.cameraColor = graph.Import("_CameraTargetAttachmentA", frame.color, frame.isOverlay);
            frame.resources.cameraDepth = graph.Import("_CameraDepthAttachment", frame.depth, frame.isOverlay);
            if (frame.needsDepth)
                frame.resources.cameraDepthTexture = graph.Import("_CameraDepthTexture", depthTexture, false);
            MakeMotionTargets();
            frame.resources.motionVectorColor = graph.Import("_MotionVectorTexture", motionColor, false);
            frame.resources.motionVectorDepth = graph.Import("_MotionVectorDepthTexture", motionDepth, false);
            bool prepass = frame.earliestDepth <= (int)RenderPassEvent.BeforeRenderingOpaques;
            bool copiesEarly = frame.earliestDepth < (int)RenderPassEvent.AfterRenderingSkybox || frame.earliestDepth == int.MaxValue;

            RecordUpTo(RenderPassEvent.AfterRenderingShadows);
            DrawShadows();
            RecordUpTo(RenderPassEvent.BeforeRenderingPrePasses);
            SetUpCameras();
            frame.xr.StartSinglePass();
            RecordUpTo(RenderPassEvent.AfterRenderingPrePasses);
            if (frame.needsDepth && prepass)
            {
                DrawDepth();
                DrawMotion();
            }
            RecordUpTo(RenderPassEvent.AfterRenderingOpaques);
            BindNow(frame.color.rt, frame.depth.rt);
            Clear();
            DrawOpaque();
            graph.MarkWritten(frame.resources.cameraColor);
            graph.MarkWritten(frame.resources.cameraDepth);
            if (frame.needsDepth && !prepass && copiesEarly)
            {
                CopyDepth();
                DrawMotion();
            }
            RecordUpTo(RenderPassEvent.AfterRenderingSkybox);
            BindNow(frame.color.rt, frame.depth.rt);
            DrawSky();
            if (frame.needsDepth && !prepass && !copiesEarly)
            {
                CopyDepth();
                DrawMotion();
            }
            RecordUpTo(RenderPassEvent.BeforeRenderingTransparents);
            if (frame.needsColor)
            {
                frame.resources.cameraOpaqueTexture = graph.Import("_CameraOpaqueTexture", opaqueTexture, false);
                CopyColor();
            }
            RecordUpTo(RenderPassEvent.AfterRenderingTransparents);
            BindNow(frame.color.rt, frame.depth.rt);
            DrawTransparent();
            RecordUpTo((RenderPassEvent)int.MaxValue);
            graph.End();
        }

        // Unity records the whole frame and then runs it; here each stretch runs when it is recorded, which is the same order.
        void RecordUpTo(RenderPassEvent end)
        {
            for (; frame.next < activeRenderPassQueue.Count && activeRenderPassQueue[frame.next].renderPassEvent < end; frame.next++)
            {
                ScriptableRenderPass pass = activeRenderPassQueue[frame.next];
                pass.RecordRenderGraph(frame.graph, frame.items);
                Guard(pass, () =>
                {
                    CommandBuffer cmd = CommandBufferPool.Get();
                    try
                    {
                        frame.graph.Execute(cmd);
                    }
                    finally
                    {
                        CommandBufferPool.Release(cmd);
                    }
                });
            }
        }
#endif

        // Later draws of URP's read the camera's matrices, which no one sets again for them.
        void Guard(ScriptableRenderPass pass, Action run)
        {
            (Matrix4x4 view, Matrix4x4 projection) = (RenderState.View, RenderState.Projection);
            run();
            if (view != RenderState.View || projection != RenderState.Projection)
                throw new GpuUsageException($"The pass {pass.GetType().Name} leaves other view and projection matrices behind than " +
                    $"those of the camera: later draws of the frame use them.");
        }

        // ---- the steps

        void SetUpCameras()
        {
            Camera camera = frame.camera;
            RenderState.SetCameraTarget(frame.baseCamera.targetTexture);
            BuiltinVariables.SetTime();
            UniversalVariables.SetLighting();
            SetMatrices();
            UniversalVariables.SetSize(frame.shape.width, frame.shape.height);
            if (frame.data == null)
                return;
            frame.data.motionVectorsPersistentData.Update(frame.matrices);
            frame.data.motionVectorsPersistentData.SetGlobals(frame.xr.singlePassEnabled);
        }

        // PushBuiltinShaderConstantsXR in CameraData.cs: of two eyes the names that are not arrays hold the left one's.
        void SetMatrices()
        {
            // The screen is as large as the camera says, what is drawn on as the render scale makes it.
            BuiltinVariables.SetCamera(frame.camera, frame.camera.pixelWidth, frame.camera.pixelHeight);
            BuiltinVariables.SetViewProjection(frame.matrices.View(0), frame.matrices.Projection(0));
            if (frame.xr.singlePassEnabled)
                BuiltinVariables.SetStereo(new[] { frame.matrices.View(0), frame.matrices.View(1) },
                    new[] { frame.matrices.Projection(0), frame.matrices.Projection(1) });
        }

        void DrawShadows() => shadows.Draw(frame.camera, frame.settings.shadowDistance, SetMatrices);

        // GetCameraClearFlag: Nothing and Skybox with a sky clear depth alone, everything else both.
        void Clear()
        {
            Camera camera = frame.camera;
            if (frame.isOverlay)
            {
                RenderState.Clear(frame.data.clearDepth, false, default, 1);
                return;
            }
            bool color = !(camera.clearFlags == CameraClearFlags.Nothing || camera.clearFlags == CameraClearFlags.Skybox
                && RenderSettings.skybox != null);
            RenderState.Clear(true, color, camera.backgroundColor, 1);
        }

        static void DrawOpaque() => UniversalVariables.DrawCulled(true, forward);

        void DrawSky()
        {
            if (frame.isOverlay || frame.camera.clearFlags != CameraClearFlags.Skybox)
                return;
            // The engine draws the sky, in any pipeline, with the variables that its procedural sky reads.
            BuiltinVariables.SetSun();
            if (frame.xr.singlePassEnabled)
                EachEye(eye =>
                {
                    BindNow(frame.color.rt, frame.depth.rt, eye);
                    BuiltinVariables.SetViewProjection(frame.matrices.View(eye), frame.matrices.Projection(eye));
                    Sky.Draw(frame.camera);
                });
            else
                Sky.Draw(frame.camera);
            UniversalVariables.SetLighting();
        }

        // For what has no variant for two eyes here.
        void EachEye(Action<int> draw)
        {
            frame.xr.StopSinglePass();
            for (int eye = 0; eye < frame.xr.viewCount; eye++)
                draw(eye);
            SetMatrices();
            BindNow(boundColor, boundDepth);
            frame.xr.StartSinglePass();
        }

        static void DrawTransparent()
        {
            UniversalVariables.DrawCulled(false, forward);
            PlayerLoop.RenderObjects.Run();
        }

        void DrawDepth()
        {
            BindNow(null, depthTexture.rt);
            (boundColor, boundDepth) = (null, depthTexture.rt);
            RenderState.Clear(true, false, default, 1);
            FrameRenderer.DrawCulled(true, depthOnly);
            SetGlobalDepth();
        }

        void CopyDepth()
        {
            Gpu.ClosePass();
            Gpu.Device.CopyTexture(frame.depth.rt.DepthTexture, depthTexture.rt.DepthTexture);
            (boundColor, boundDepth) = (null, depthTexture.rt);      // URP's copy binds its destination
            SetGlobalDepth();
        }

        void SetGlobalDepth()
        {
            Shader.Globals.SetTexture(depthTextureId, depthTexture.rt, RenderTextureSubElement.Depth);
#if SRP_17
            if (frame.graph != null)
            {
                frame.graph.MarkWritten(frame.resources.cameraDepthTexture);
                frame.graph.SetGlobal(depthTextureId, frame.resources.cameraDepthTexture);
            }
#endif
        }

        void DrawMotion()
        {
            if (!frame.needsMotion)
                return;
            frame.camera.depthTextureMode |= DepthTextureMode.MotionVectors | DepthTextureMode.Depth;
            BindNow(motionColor.rt, motionDepth.rt);
            (boundColor, boundDepth) = (motionColor.rt, motionDepth.rt);
            RenderState.Clear(true, true, Color.black, 1);
            Gpu.ClosePass();
            Gpu.Device.CopyTexture(depthTexture.rt.DepthTexture, motionDepth.rt.DepthTexture);
            Shader.SetGlobalVector(motionParams, new Vector4(0, 1, 0, 0));
            UniversalVariables.DrawCulled(true, motionVectors, draw => draw.Motion == MotionVectorGenerationMode.Object);
            Shader.SetGlobalVector(motionParams, Vector4.zero);
            Shader.SetGlobalTexture(motionTextureId, motionColor.rt);
            Shader.Globals.SetTexture(motionDepthId, motionDepth.rt, RenderTextureSubElement.Depth);
#if SRP_17
            if (frame.graph == null)
                return;
            frame.graph.MarkWritten(frame.resources.motionVectorColor);
            frame.graph.MarkWritten(frame.resources.motionVectorDepth);
            frame.graph.SetGlobal(motionTextureId, frame.resources.motionVectorColor);
#endif
        }

        void CopyColor()
        {
            (boundColor, boundDepth) = (opaqueTexture.rt, null);
            if (frame.xr.singlePassEnabled)
                EachEye(eye => Headless.Blitter.BlitSlice(frame.color.rt, opaqueTexture.rt, eye, eye));
            else
                Headless.Blitter.Blit(frame.color.rt, opaqueTexture.rt, null, -1);
            Shader.SetGlobalTexture(opaqueTextureId, opaqueTexture.rt);
#if SRP_17
            if (frame.graph != null)
            {
                frame.graph.MarkWritten(frame.resources.cameraOpaqueTexture);
                frame.graph.SetGlobal(opaqueTextureId, frame.resources.cameraOpaqueTexture);
            }
#endif
        }

        void Show()
        {
            if (frame.xr.singlePassEnabled)
                EachEye(eye => Headless.Blitter.BlitSlice(frame.color.rt, StereoView.Eyes, eye, eye));
            else if (frame.xr.enabled)
                Headless.Blitter.BlitSlice(frame.color.rt, StereoView.Eyes, 0, frame.xr.multipassId);
            else
                Headless.Blitter.Blit(frame.color.rt, frame.baseCamera.targetTexture, null, -1);
        }

        static readonly List<RenderTexture> colors = new List<RenderTexture>();

        static void BindNow(RenderTexture color, RenderTexture depth, int slice = RenderTargetIdentifier.AllDepthSlices)
        {
            colors.Clear();
            if (color is object)
                colors.Add(color);
            RenderState.SetTargets(colors, depth, 0, slice);
        }

        protected override void Dispose(bool disposing)
        {
            foreach (RTHandle handle in new[] { colorAttachment, depthAttachment, depthTexture, opaqueTexture, motionColor, motionDepth })
                handle?.Release();
            colorAttachment = depthAttachment = depthTexture = opaqueTexture = motionColor = motionDepth = null;
            shadows.Dispose();
        }
    }
}
