using System;
using System.Collections.Generic;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace UnityEngine.Headless
{
    /// <summary>
    /// Built-in pipeline, forward: cameras by depth; in each the queue's and the renderers' draws by render queue, opaque ones in
    /// order of submission, transparent ones from back to front, then what OnRenderObject and OnPostRender draw. The main directional light has a
    /// shadow (<see cref="ScreenShadows"/>); no additional lights.
    /// </summary>
    internal static partial class FrameRenderer
    {
        internal const int LastOpaqueQueue = 2500;

        struct Item
        {
            public QueuedDraw Draw;
            public int Queue;
            public float Distance;
        }

        static List<Item> items = new List<Item>();
        static List<QueuedDraw> all = new List<QueuedDraw>(), seen = new List<QueuedDraw>();     // of the camera's layers; of its frustum
        static readonly Comparison<Item> order = Compare;
        static bool isInPipeline;

        public static void Render()
        {
            if (Player.Device == null)
                return;
            try
            {
                if (RenderPipelineManager.Prepare() is RenderPipeline pipeline)
                    Render(pipeline, Camera.InDrawOrder());
                else
                    foreach (Camera camera in Camera.InDrawOrder())
                        Render(camera);
            }
            finally
            {
                StereoView.SetSinglePass(false);
                RenderState.SetTarget(null);
                Gpu.ClosePass();
                FrameTimes.EndFrame();
                Player.Device.Flush();
            }
        }

        static void Render(RenderPipeline pipeline, List<Camera> cameras)
        {
            isInPipeline = true;
            try
            {
                pipeline.RenderCameras(cameras);
            }
            finally
            {
                isInPipeline = false;
            }
        }

        public static void Render(Camera camera)
        {
            if (Player.Device == null)
                throw Gpu.NoDevice("Camera.Render");
            if (isInPipeline)
            {
                Debug.LogError("Recursive rendering is not supported in SRP (are you calling Camera.Render from within a render pipeline?).");
                return;
            }
            if (RenderPipelineManager.Prepare() is RenderPipeline pipeline)
            {
                Render(pipeline, new List<Camera> { camera });
                return;
            }
            // One that is drawn from inside of another's callbacks leaves what that one sees alone.
            (List<Item>, List<QueuedDraw>, List<QueuedDraw>) outer = (items, all, seen);
            (items, all, seen) = (new List<Item>(), new List<QueuedDraw>(), new List<QueuedDraw>());
            try
            {
                RenderBuiltIn(camera);
            }
            finally
            {
                (items, all, seen) = outer;
            }
        }

        static void RenderBuiltIn(Camera camera)
        {
            RenderTexture target = Begin(camera);
            RenderTexture previous = RenderTexture.active;
            Camera previousCamera = Camera.current;
            Camera.current = camera;
            Say(camera, Message.OnPreCull);
            Camera.onPreCull?.Invoke(camera);
            Collect(camera);
            Say(camera, Message.OnPreRender);
            Camera.onPreRender?.Invoke(camera);

            bool stereo = camera.stereoEnabled;
            if (stereo)
                StereoView.Begin(camera);
            RenderState.SetCameraTarget(stereo ? StereoView.Eyes : target);
            BuiltinVariables.SetTime();
            BuiltinVariables.SetSun();
            EnvironmentLighting.Update();
            BuiltinVariables.SetAmbient();
            Restore(camera, target);

            bool shadows = ScreenShadows.AreWanted(all);
            if (shadows || DepthTexture.IsWanted(camera))
            {
                Run(camera, target, CameraEvent.BeforeDepthTexture);
                EndEyes(stereo);
                DepthTexture.Draw(camera, seen);
                Restore(camera, target);
                Run(camera, target, CameraEvent.AfterDepthTexture);
            }
            EndEyes(stereo);
            shadows = shadows && ScreenShadows.Draw(camera, all, seen);
            Restore(camera, target);

            Clear(camera);
            Run(camera, target, CameraEvent.BeforeForwardOpaque);
            Draw(opaque: true, shadows);
            Run(camera, target, CameraEvent.AfterForwardOpaque, CameraEvent.BeforeSkybox);
            if (camera.clearFlags == CameraClearFlags.Skybox)
                DrawSky(camera, target);
            Run(camera, target, CameraEvent.AfterSkybox, CameraEvent.BeforeImageEffectsOpaque,
                CameraEvent.AfterImageEffectsOpaque, CameraEvent.BeforeForwardAlpha);
            Draw(opaque: false, shadows: false);
            Run(camera, target, CameraEvent.AfterForwardAlpha);
            PlayerLoop.RenderObjects.Run();
            Say(camera, Message.OnPostRender);
            Camera.onPostRender?.Invoke(camera);
            Restore(camera, target);
            Run(camera, target, CameraEvent.BeforeImageEffects);
            if (!stereo)    // nothing here needs image effects for two eyes
                ImageEffects.Run(camera, target);
            Run(camera, target, CameraEvent.AfterImageEffects, CameraEvent.AfterEverything);
            EndEyes(stereo);
            if (stereo)
                StereoView.Show();
            Show(camera, target);
            Finish(camera, target, previous, previousCamera);
        }

        static bool IsPart(Camera camera) => camera.rect != new Rect(0, 0, 1, 1);

        // Scripts of Unity's own rely on this (PostProcessing 2, PostProcessLayer.OnEnable, which copies the camera's target into a texture
        // of the camera's
        // size): a camera that is forced to draws a part of its target by way of a texture of that part's size. Others draw into the target itself.
        static RenderTexture Begin(Camera camera)
        {
            RenderTexture target = camera.targetTexture;
            bool clears = camera.clearFlags == CameraClearFlags.Skybox || camera.clearFlags == CameraClearFlags.SolidColor;
            if (DrawsToBackBuffer(camera))
                return BackBuffer.Begin();
            if (!camera.forceIntoRenderTexture || !IsPart(camera) || !clears || camera.pixelWidth < 1 || camera.pixelHeight < 1)
                return target;
            return RenderTexture.GetTemporary(new RenderTextureDescriptor(camera.pixelWidth, camera.pixelHeight,
                (target is object ? target : ScreenTarget.Texture).graphicsFormat, GraphicsFormat.D32_SFloat));
        }

        // A player's, which has no reason to draw into a texture first. Until something asks for one, a camera's picture is not flipped there.
        static bool DrawsToBackBuffer(Camera camera) => camera.targetTexture is null && !camera.stereoEnabled && !camera.forceIntoRenderTexture
            && !camera.allowHDR && !(camera.allowMSAA && QualitySettings.antiAliasing > 1) && !ImageEffects.Has(camera);

        static void Show(Camera camera, RenderTexture target)
        {
            if (ReferenceEquals(target, camera.targetTexture))
                return;
            if (target.IsUpright)
            {
                BackBuffer.End(target);
                return;
            }
            Blitter.BlitSlice(target, camera.targetTexture, 0, 0, viewport: camera.pixelRect);
            RenderTexture.ReleaseTemporary(target);
        }

        // Its shaders have no variant for two eyes here: one after the other.
        static void DrawSky(Camera camera, RenderTexture target)
        {
            if (!camera.stereoEnabled)
            {
                Sky.Draw(camera);
                return;
            }
            StereoView.SetSinglePass(false);
            for (int eye = 0; eye < 2; eye++)
            {
                StereoView.SetEye(eye);
                Sky.Draw(camera);
            }
            Restore(camera, target);
        }

        static void EndEyes(bool stereo)
        {
            if (stereo)
                StereoView.SetSinglePass(false);
        }

        static void Finish(Camera camera, RenderTexture target, RenderTexture previous, Camera previousCamera)
        {
            items.Clear();
            all.Clear();
            seen.Clear();
            Gpu.ClosePass();
            RenderState.SetCameraTarget(null);
            RenderState.SetTarget(previous);
            Camera.current = previousCamera;
        }

        /// <summary>To the scripts beside the camera or renderer.</summary>
        static void Say(Component beside, Message message)
        {
            foreach (Component component in beside.gameObject.Components)
                if (component is MonoBehaviour script && script.isActiveAndEnabled && EditMode.Runs(script))
                    Messages.Send(script, message);
        }

        static void SetTarget(Camera camera, RenderTexture target)
        {
            if (camera.stereoEnabled)
            {
                StereoView.SetSinglePass(true);
                return;
            }
            RenderState.SetTarget(target is object ? target : ScreenTarget.Texture);
            if (IsPart(camera) && (ReferenceEquals(target, camera.targetTexture) || target.IsUpright))
                RenderState.SetViewport(camera.pixelRect);
        }

        static void Clear(Camera camera)
        {
            bool color = camera.clearFlags == CameraClearFlags.Skybox || camera.clearFlags == CameraClearFlags.SolidColor;
            RenderState.Clear(camera.clearFlags != CameraClearFlags.Nothing, color, camera.backgroundColor, 1);
        }

        // A command buffer may leave other targets and matrices behind: the camera's come back.
        static void Run(Camera camera, RenderTexture target, params CameraEvent[] events)
        {
            if (camera.commandBufferCount == 0)
                return;
            foreach (CameraEvent e in events)
                camera.Execute(e);
            RenderState.InvertCulling = false;
            Restore(camera, target);
        }

        static void Restore(Camera camera, RenderTexture target)
        {
            SetTarget(camera, target);
            BuiltinVariables.SetCamera(camera, camera.pixelWidth, camera.pixelHeight);
        }

        static void Collect(Camera camera)
        {
            items.Clear();
            all.Clear();
            seen.Clear();
            Matrix4x4 culling = camera.cullingMatrix;
            Vector3 eye = camera.transform.position;
            foreach (QueuedDraw draw in DrawQueue.Draws)
                if (draw.Camera is null || ReferenceEquals(draw.Camera, camera))
                    Add(draw, camera, culling, eye);
            DrawQueue.MarkCulled();

            int next = DrawQueue.Draws.Count;
            foreach (Renderer renderer in Renderer.Active)
            {
                Mesh mesh = renderer.forceRenderingOff ? null : renderer.MeshToDraw;
                if (mesh == null)
                    continue;
                int draws = Math.Max(mesh.subMeshCount, renderer.MaterialCount);
                for (int i = 0; i < draws; i++)
                {
                    Material material = renderer.MaterialFor(i);
                    if (material == null)
                        continue;
                    int submesh = Math.Min(i, mesh.subMeshCount - 1);
                    Add(new QueuedDraw
                    {
                        Call = new DrawCall
                        {
                            Call = $"renderer '{renderer.name}'", Material = material, Pass = -1, Block = renderer.Block,
                                Matrix = renderer.localToWorldMatrix,
                            Mesh = mesh, Submesh = submesh, Topology = mesh.GetTopology(submesh), Instances = 1,
                        },
                        Bounds = renderer.bounds, HasBounds = true, Layer = renderer.gameObject.layer, Priority = renderer.rendererPriority,
                            Order = next++,
                        Shadows = renderer.shadowCastingMode, ReceivesShadows = renderer.receiveShadows, Motion = renderer.motionVectorGenerationMode,
                        Reflections = renderer.reflectionProbeUsage,
                    }, camera, culling, eye);
                }
            }
            items.Sort(order);
            for (int i = 0; i < Renderer.Active.Count; i++)
            {
                Renderer renderer = Renderer.Active[i];
                if (!renderer.forceRenderingOff && renderer.MeshToDraw != null && (camera.cullingMask & 1 << renderer.gameObject.layer) != 0
                    && !Culling.IsOutside(culling, renderer.bounds))
                    Say(renderer, Message.OnWillRenderObject);
            }
        }

        static void Add(in QueuedDraw draw, Camera camera, in Matrix4x4 culling, Vector3 eye)
        {
            if (draw.Call.Material == null || (camera.cullingMask & 1 << draw.Layer) == 0)
                return;
            all.Add(draw);
            if (draw.HasBounds && Culling.IsOutside(culling, draw.Bounds) || draw.Shadows == ShadowCastingMode.ShadowsOnly)
                return;
            seen.Add(draw);
            items.Add(new Item { Draw = draw, Queue = draw.Call.Material.renderQueue, Distance = (draw.Bounds.center - eye).sqrMagnitude });
        }

        static int Compare(Item a, Item b)
        {
            int c = a.Queue.CompareTo(b.Queue);
            if (c == 0)
                c = a.Draw.Priority.CompareTo(b.Draw.Priority);
            if (c == 0 && a.Queue > LastOpaqueQueue)
                c = b.Distance.CompareTo(a.Distance);
            return c != 0 ? c : a.Draw.Order.CompareTo(b.Draw.Order);
        }

        static void Draw(bool opaque, bool shadows)
        {
            EnvironmentLighting.Bind();
            foreach (Item item in items)
            {
                if (item.Queue <= LastOpaqueQueue != opaque)
                    continue;
                Material material = item.Draw.Call.Material;
                // Unity turns it on for the one draw, whatever the keywords of scripts.
                GlobalKeywords.Set.Set(ScreenShadows.Keyword, shadows && item.Draw.ReceivesShadows);
                ObjectProbes.Bind(item.Draw, universal: false);
                for (int pass = 0; pass < material.passCount; pass++)
                    if (IsForward(material, pass))
                        Drawing.DrawPass(item.Draw.Call, pass);
            }
            GlobalKeywords.Set.Set(ScreenShadows.Keyword, false);
            ObjectProbes.Unbind();
            EnvironmentLighting.Unbind();
        }

        static bool IsForward(Material material, int pass)
        {
            if (!material.shader.Source.Passes[pass].Tags.TryGetValue("LightMode", out string mode))
                return true;
            return material.GetShaderPassEnabled(mode) && (mode == "Always" || mode == "ForwardBase" || mode == "SRPDefaultUnlit");
        }
    }
}
