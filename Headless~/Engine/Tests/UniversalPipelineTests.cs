using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace Host.Tests
{
    /// <summary>The stand-in of URP runs a frame's steps in URP's order, makes the textures that passes ask for, and refuses what URP would
    /// let pass in silence.</summary>
    public class UniversalPipelineTests : UniversalFixture
    {
        // Notes at its event which camera and textures are there, and does one thing wrong if told so; a pass for every camera.
        const string Notes = @"
            public class Planted
            {
                public static List<string> Said = new List<string>();
                public static string Fault = """";
                public static RenderTexture Other = new RenderTexture(8, 8, 0);
                public int[] Events = { 450 };
                public int Input;
                public Planted() { Said.Clear(); Fault = """"; RenderPipelineManager.beginCameraRendering += Begin; }
                public void End()
                {
                    RenderPipelineManager.beginCameraRendering -= Begin;
                    UnityEngine.Object.DestroyImmediate(Other);
                }
                void Begin(ScriptableRenderContext context, Camera camera)
                {
                    foreach (int at in Events)
                    {
                        var pass = new Pass { renderPassEvent = (RenderPassEvent)at };
                        pass.ConfigureInput((ScriptableRenderPassInput)Input);
                        UniversalRenderPipeline.asset.scriptableRenderer.EnqueuePass(pass);
                    }
                }
                public static void Note(ScriptableRenderPass pass, Camera camera)
                {
                    Texture depth = Shader.GetGlobalTexture(""_CameraDepthTexture""), color = Shader.GetGlobalTexture(""_CameraOpaqueTexture"");
                    Said.Add($""{(int)pass.renderPassEvent} {camera.name}"");
                    if ((pass.input & ScriptableRenderPassInput.Color) != 0)
                        Said.Add($""color {color.width} x {color.height}"");
                    if (pass.input != 0)
                        Said.Add($""depth {depth.name} {depth.width} x {depth.height}"");
                }
                public static void Do(CommandBuffer cmd)
                {
                    if (Fault == ""matrices"")
                        cmd.SetViewProjectionMatrices(Matrix4x4.identity, Matrix4x4.identity);
                    if (Fault == ""target"")
                        cmd.SetRenderTarget(Other);
                }
            }
            class Pass : ScriptableRenderPass
            {
                public override void Execute(ScriptableRenderContext context, ref RenderingData data)
                {
                    Planted.Note(this, data.cameraData.camera);
                    CommandBuffer cmd = CommandBufferPool.Get(""planted"");
                    Planted.Do(cmd);
                    context.ExecuteCommandBuffer(cmd);
                    CommandBufferPool.Release(cmd);
                }
            #if UNITY_6000_0_OR_NEWER
                static TextureHandle kept;
                class Data { public Pass pass; public Camera camera; public TextureHandle texture; }
                public override void RecordRenderGraph(RenderGraph graph, ContextContainer frame)
                {
                    using (var builder = graph.AddUnsafePass<Data>(""planted pass"", out var data))
                    {
                        UniversalResourceData resources = frame.Get<UniversalResourceData>();
                        data.pass = this;
                        data.camera = frame.Get<UniversalCameraData>().camera;
                        if (Planted.Fault != ""culled"")
                            builder.AllowPassCulling(false);
                        if (Planted.Fault == ""undeclared"" || Planted.Fault == ""declared"" || Planted.Fault == ""outside"")
                            data.texture = resources.cameraDepthTexture;
                        if (Planted.Fault == ""declared"")
                            builder.UseTexture(resources.cameraDepthTexture);
                        if (Planted.Fault == ""kept"")
                        {
                            data.texture = kept;
                            kept = resources.cameraDepthTexture;
                            builder.UseTexture(resources.cameraDepthTexture);
                        }
                        if (Planted.Fault == ""outside"")
                        {
                            RTHandle now = data.texture;
                        }
                        if (Planted.Fault == ""without function"")
                            return;
                        builder.SetRenderFunc((Data d, UnsafeGraphContext context) =>
                        {
                            Planted.Note(d.pass, d.camera);
                            if (d.texture.IsValid())
                                Planted.Said.Add(((RTHandle)d.texture).name);
                            Planted.Do(CommandBufferHelpers.GetNativeCommandBuffer(context.cmd));
                        });
                    }
                }
            #endif
            }";

        object planted;

        [TearDown]
        public void EndPlanted()
        {
            planted?.GetType().GetMethod("End")?.Invoke(planted, null);
            planted = null;
        }

        List<string> Said => (List<string>)Get(planted, "Said");

        void Begin(string version, string fault = "", int input = 0, params int[] events)
        {
            Start(version);
            planted = Plant(Notes);
            Set(planted, "Fault", fault);
            Set(planted, "Input", input);
            if (events.Length > 0)
                Set(planted, "Events", events);
        }

        const int Depth = 1, Opaque = 4;       // ScriptableRenderPassInput

        static void Fails(string words)
        {
            LogAssert.Expect(LogType.Exception, new Regex(Regex.Escape(words)));
            Frame();
        }

        [Test]
        public void Passes_run_in_the_order_of_their_events([Values("14", "17", "17 by Execute")] string version)
        {
            Begin(version, "", 0, 1000, 450, 0, 300);
            Frame();
            Assert.That(Errors, Is.Empty);
            Assert.That(Said, Is.EqualTo(new[] { "0 Camera", "300 Camera", "450 Camera", "1000 Camera" }));
            Said.Clear();
            Frame();
            Assert.That(Said, Has.Count.EqualTo(4), "no pass of the last frame is left");
        }

        [Test]
        public void A_pass_that_was_enqueued_for_a_camera_that_is_not_culled_runs_with_the_next_one([Values("14", "17")] string version)
        {
            Begin(version);
            camera.rect = new Rect(0, 0, 0, 0);
            Frame();
            Assert.That(Said, Is.Empty);
            camera.rect = new Rect(0, 0, 1, 1);
            Frame();
            Assert.That(Said, Is.EqualTo(new[] { "450 Camera", "450 Camera" }), "the left one and its own");
        }

        [Test]
        public void Depth_and_color_are_there_where_a_pass_asks_for_them([Values("14", "17", "17 by Execute")] string version)
        {
            Begin(version, "", Depth | Opaque);
            Frame();
            Assert.That(Errors, Is.Empty);
            Assert.That(Said, Is.EqualTo(new[] { "450 Camera", "color 48 x 32", "depth _CameraDepthTexture 96 x 64" }),
                "the copy of the color is of half size, as a new asset has it");
        }

        [Test]
        public void Depth_that_a_pass_reads_before_the_opaque_draws_is_drawn_for_it([Values("14", "17")] string version)
        {
            Begin(version, "", Depth, 250);
            Frame();
            Assert.That(Errors, Is.Empty);
            Assert.That(Said, Is.EqualTo(new[] { "250 Camera", "depth _CameraDepthTexture 96 x 64" }));
        }

        [Test]
        public void What_is_drawn_follows_the_render_scale_and_what_is_shown_does_not([Values("14", "17")] string version)
        {
            Begin(version, "", Depth);
            Set(pipeline.Asset, "renderScale", 0.5f);
            Frame();
            Assert.That(Said, Has.Some.EqualTo("depth _CameraDepthTexture 48 x 32"));
            Assert.That(Shader.GetGlobalVector("_ScreenParams").x, Is.EqualTo(Width));
            Assert.That(Shader.GetGlobalVector("_ScaledScreenParams").x, Is.EqualTo(Width / 2));
        }

        [Test]
        public void Only_a_pass_that_declares_a_texture_gets_it()
        {
            Begin("17", "declared", Depth);
            Frame();
            Assert.That(Errors, Is.Empty);
            Assert.That(Said.Last(), Is.EqualTo("_CameraDepthTexture"));
            Set(planted, "Fault", "undeclared");
            Fails("(_CameraDepthTexture) that the pass 'planted pass' has not declared");
        }

        [Test]
        public void A_handle_is_refused_in_the_next_frame()
        {
            Begin("17", "kept", Depth);
            Frame();
            Assert.That(Errors, Is.Empty);
            Fails("another frame");
        }

        [Test]
        public void A_handle_is_refused_outside_of_its_pass()
        {
            Begin("17", "outside", Depth);
            Fails("outside of a pass");
        }

        [Test]
        public void A_texture_that_nothing_has_written_to_yet_is_refused()
        {
            // The project has the texture on; it is copied after the opaque draws.
            Begin("17", "declared", 0, 100);
            Set(pipeline.Asset, "supportsCameraDepthTexture", true);
            Fails("(_CameraDepthTexture) that nothing has written to yet");
        }

        [Test]
        public void A_pass_without_effect_on_the_graph_is_left_out_unless_it_says_otherwise()
        {
            Begin("17", "culled");
            Frame();
            Assert.That(Said, Is.Empty);
            Assert.That(Errors, Is.Empty);
        }

        [Test]
        public void A_pass_without_a_function_is_named()
        {
            Begin("17", "without function");
            Fails("planted pass");
        }

        [Test]
        public void A_pass_that_leaves_other_matrices_behind_is_named([Values("14", "17", "17 by Execute")] string version)
        {
            Begin(version, "matrices");
            Fails("The pass Pass leaves other view and projection matrices behind");
        }

        [TestCase("14", false)]
        [TestCase("17 by Execute", false)]
        [TestCase("17", true)]
        public void A_pass_that_leaves_its_own_target_bound_takes_the_next_draws_with_it_except_in_the_graph(string version, bool isSeen)
        {
            Begin(version, "target");
            var quad = GameObject.CreatePrimitive(PrimitiveType.Quad);
            quad.transform.localScale = Vector3.one * 100;
            quad.transform.rotation = camera.transform.rotation;
            quad.GetComponent<MeshRenderer>().sharedMaterial = new Material(Shader.Find("Unlit/Color")) { color = Color.white };
            quad.GetComponent<MeshRenderer>().sharedMaterial.renderQueue = 3000;
            RenderSettings.ambientMode = UnityEngine.Rendering.AmbientMode.Flat;
            RenderSettings.ambientSkyColor = Color.white;
            Frame();
            Assert.That(Errors, Is.Empty);
            Assert.That(Pixels()[Height / 2 * Width + Width / 2].x > 0, Is.EqualTo(isSeen));
        }

        [Test]
        public void An_overlay_camera_draws_over_its_base_camera_and_not_by_itself([Values("14", "17")] string version)
        {
            Begin(version, "", Depth);
            Camera over = new GameObject("Over").AddComponent<Camera>();
            over.targetTexture = target;
            System.Type type = pipeline[Pipelines.PipelineKind.Universal.Assembly]
                .GetType("UnityEngine.Rendering.Universal.UniversalAdditionalCameraData");
            object overlay = over.gameObject.AddComponent(type), stack = camera.gameObject.AddComponent(type);
            Set(overlay, "renderType", System.Enum.Parse(type.Assembly.GetType("UnityEngine.Rendering.Universal.CameraRenderType"), "Overlay"));
            Frame();
            Assert.That(Said.Where(line => line.StartsWith("450")), Is.EqualTo(new[] { "450 Camera" }));
            Said.Clear();
            ((List<Camera>)Get(stack, "cameraStack")).Add(over);
            Frame();
            Assert.That(Errors, Is.Empty);
            Assert.That(Said.Where(line => line.StartsWith("450")), Is.EqualTo(new[] { "450 Camera", "450 Over" }));
        }

        [Test]
        public void A_feature_of_the_renderer_adds_its_passes([Values("14", "17")] string version)
        {
            Start(version);
            object feature = Plant(@"
                public class Planted : ScriptableRendererFeature
                {
                    public static List<string> Said = new List<string>();
                    public override void Create() => Said.Add(""create"");
                    public override void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData data)
                        => Said.Add(""add "" + data.cameraData.camera.name);
                }");
            object data = ((System.Collections.IList)Get(pipeline.Asset, "m_RendererDataList"))[0];
            ((System.Collections.IList)Get(data, "rendererFeatures")).Add(feature);
            data.GetType().GetMethod("SetDirty").Invoke(data, null);
            Frame();
            Assert.That(Get(feature, "Said"), Is.EqualTo(new[] { "create", "add Camera" }));
        }

        [Test]
        public void Events_of_the_Built_in_pipeline_stay_silent()
        {
            Start("17");
            int raised = 0;
            Camera.CameraCallback count = _ => raised++;
            Camera.onPreCull += count;
            Frame();
            Camera.onPreCull -= count;
            Assert.That(raised, Is.EqualTo(0));
            pipeline.Dispose();
            pipeline = null;
            Camera.onPreCull += count;
            Frame();
            Camera.onPreCull -= count;
            Assert.That(raised, Is.EqualTo(1), "without the asset the Built-in pipeline draws again");
        }
    }
}
