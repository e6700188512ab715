using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Text.RegularExpressions;
using Host.Pipelines;
using NUnit.Framework;
using Rill;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Host.Tests
{
    /// <summary>Cameras that a script draws from inside of another's callbacks, as mirrors and portals do: each shows its water.</summary>
    public class NestedCameraTests : PipelineSurfaceFixture
    {
        Action<ScriptableRenderContext, Camera> nested;

        readonly List<RenderTexture> reflections = new List<RenderTexture>();

        [TearDown]
        public void LeaveNothing()
        {
            RenderPipelineManager.beginCameraRendering -= nested;
            reflections.ForEach(reflection => reflection.Release());
            reflections.Clear();
        }

        // Camera with the first one's view, off until a script draws it.
        Camera NewMirror()
        {
            Camera mirror = new GameObject("Mirror").AddComponent<Camera>();
            mirror.CopyFrom(camera);
            mirror.transform.SetPositionAndRotation(camera.transform.position, camera.transform.rotation);
            mirror.targetTexture = new RenderTexture(target.descriptor);
            reflections.Add(mirror.targetTexture);
            mirror.enabled = false;
            return mirror;
        }

        Vector4[] PixelsOf(Camera of)
        {
            AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(of.targetTexture);
            request.WaitForCompletion();
            return request.GetData<Vector4>().ToArray();
        }

        static int Unlike(Vector4[] a, Vector4[] b) => a.Where((pixel, i) => (pixel - b[i]).magnitude > 0.004f).Count();

        Vector4[] Alone()
        {
            Play(3);
            simulation.Paused = true;
            Play(2);
            return Pixels();
        }

        // Draws like a mirror's script.
        void DrawInside(params Camera[] mirrors)
        {
            MethodInfo draw = pipeline[PipelineKind.Universal.Assembly].GetType("UnityEngine.Rendering.Universal.UniversalRenderPipeline")
                .GetMethod("RenderSingleCamera", BindingFlags.Static | BindingFlags.Public);
            nested = (context, drawn) =>
            {
                if (ReferenceEquals(drawn, camera))
                    foreach (Camera mirror in mirrors)
                        draw.Invoke(null, new object[] { context, mirror });
            };
            RenderPipelineManager.beginCameraRendering += nested;
        }

        [Test]
        public void A_camera_that_draws_others_as_it_begins_keeps_its_water(
            [Values("14", "17", "17 by Execute", "17.3")] string version, [Values] bool heardFirst)
        {
            Build(PipelineKind.Universal, version);
            Vector4[] alone = Alone();
            DrawInside(NewMirror(), NewMirror());
            if (heardFirst)
                pipeline["Rill.Universal"].GetType("Rill.Universal.UniversalSurfaces")
                    .GetMethod("ListenLast", BindingFlags.Static | BindingFlags.NonPublic).Invoke(null, null);
            Play(heardFirst ? 1 : 2);       // who listens after the package takes its pass once
            Assert.That(Unlike(Pixels(), alone), Is.Zero);
            Assert.That(Errors, Is.Empty);
            Assert.That(Covered(alone), Is.GreaterThan(Width * Height / 20));
            if (!heardFirst)
                Assert.That(Logged.Count(line => line.Contains("Rill: camera 'Mirror' is drawn by UniversalRenderPipeline.RenderSingleCamera")
                    && line.Contains("Add the renderer feature")), Is.EqualTo(1));
        }

        [Test]
        public void With_the_feature_on_its_renderer_such_a_camera_shows_the_water_too([Values("14", "17", "17 by Execute", "17.3")] string version)
        {
            Build(PipelineKind.Universal, version);
            AddFeature();
            Vector4[] alone = Alone();
            Camera one = NewMirror(), two = NewMirror();
            DrawInside(one, two);
            Play(1);
            Assert.That(Unlike(Pixels(), alone), Is.Zero, "the first");
            Assert.That(Unlike(PixelsOf(one), alone), Is.Zero, "inside");
            Assert.That(Unlike(PixelsOf(two), alone), Is.Zero, "inside after another");
            Assert.That(Errors, Is.Empty);
            Assert.That(Logged, Has.None.Contains("RenderSingleCamera"));
        }

        void AddFeature()
        {
            object feature = ScriptableObject.CreateInstance(pipeline["Rill.Universal"].GetType("Rill.Universal.FluidSurfaceFeature"));
            object data = ((Array)Get(pipeline.Asset, "m_RendererDataList")).GetValue(0);
            ((System.Collections.IList)Get(data, "rendererFeatures")).Add(feature);
            data.GetType().GetMethod("SetDirty").Invoke(data, null);
        }

        [Test]
        public void Scriptable_pipelines_refuse_Camera_Render_there_and_the_camera_keeps_its_water([Values] bool highDefinition)
        {
            Build(highDefinition ? PipelineKind.HighDefinition : PipelineKind.Universal, "17");
            Vector4[] alone = Alone();
            Camera mirror = NewMirror();
            nested = (_, drawn) => mirror.Render();
            RenderPipelineManager.beginCameraRendering += nested;
            LogAssert.Expect(LogType.Error, new Regex("Recursive rendering is not supported in SRP"));
            Play(1);
            Assert.That(Unlike(Pixels(), alone), Is.Zero);
        }

        /// <summary>Draws another camera from inside of one.</summary>
        sealed class Inside : MonoBehaviour
        {
            public Camera inner;
            public string when;

            void OnPreCull() => Draw("OnPreCull");
            void OnPreRender() => Draw("OnPreRender");
            void OnWillRenderObject() => Draw("OnWillRenderObject");

            bool isDrawing;

            void Draw(string now)
            {
                if (now != when || isDrawing)
                    return;
                isDrawing = true;
                inner.Render();
                isDrawing = false;
            }
        }

        [Test]
        public void In_the_Built_in_pipeline_cameras_inside_of_cameras_show_what_they_show_alone(
            [Values("OnPreCull", "OnPreRender", "OnWillRenderObject")] string when, [Values] bool shaded)
        {
            Build(null, null);
            Light sun = UnityEngine.Object.FindObjectOfType<Light>();
            sun.shadows = shaded ? LightShadows.Hard : LightShadows.None;
            FluidSurface surface = simulation.GetComponent<FluidSurface>();
            surface.Preset = SurfacePreset.Milk;
            surface.Sun = sun;
            GameObject roof = GameObject.CreatePrimitive(PrimitiveType.Cube);
            roof.transform.position = new Vector3(0.8f, 3, 0);
            roof.transform.localScale = new Vector3(1.6f, 0.1f, 4);
            roof.GetComponent<MeshRenderer>().sharedMaterial = RenderPassFixture.MaterialOf("Solid.shader", Player.PipelineTag);
            Vector4[] alone = Alone();
            surface.ReceiveShadows = false;
            Play(1);
            Assert.That(Unlike(Pixels(), alone), shaded ? Is.GreaterThan(50) : Is.Zero, "the shadow is seen");
            surface.ReceiveShadows = true;
            Camera mirror = NewMirror(), mirrorInMirror = NewMirror();
            foreach ((Camera outer, Camera inner) in new[] { (camera, mirror), (mirror, mirrorInMirror) })
            {
                GameObject floor = UnityEngine.Object.FindObjectsOfType<MeshRenderer>().First(one => one.name == "Plane").gameObject;
                var script = (when == "OnWillRenderObject" ? floor : outer.gameObject).AddComponent<Inside>();
                (script.inner, script.when) = (inner, when);
                if (when == "OnWillRenderObject")
                    break;      // the same object is seen by the one inside
            }
            Play(2);
            Assert.That(Unlike(Pixels(), alone), Is.Zero, "the first");
            Assert.That(Unlike(PixelsOf(mirror), alone), Is.Zero, "inside");
            if (when != "OnWillRenderObject")
                Assert.That(Unlike(PixelsOf(mirrorInMirror), alone), Is.Zero, "inside of that");
            Assert.That(Errors, Is.Empty);
            Assert.That(Covered(alone), Is.GreaterThan(Width * Height / 30));
        }
    }
}
