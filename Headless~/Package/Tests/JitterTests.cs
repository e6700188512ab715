using System;
using System.Linq;
using System.Reflection;
using Host.Pipelines;
using NUnit.Framework;
using Rill;
using UnityEngine;
using UnityEngine.Headless;

namespace Host.Tests
{
    /// <summary>Antialiasing over time moves a camera's projection by a part of a pixel in each frame: the water's edges go along with the
    /// scene's.</summary>
    public class JitterTests : PipelineSurfaceFixture
    {
        // The water alone, standing still.
        void Arrange()
        {
            foreach (MeshRenderer renderer in UnityEngine.Object.FindObjectsOfType<MeshRenderer>())
                renderer.enabled = false;
            simulation.GetComponent<FluidSurface>().Preset = SurfacePreset.Milk;
            Play(3);
            simulation.Paused = true;
            Play(1);
        }

        Matrix4x4 JitterNow() => (Matrix4x4)pipeline["Unity.RenderPipelines.Core.Runtime"].GetType("UnityEngine.Rendering.Jitter")
            .GetMethod("MatrixOf").Invoke(null, new object[] { Time.frameCount, Width, Height });

        [Test]
        public void The_water_is_drawn_where_the_frames_jitter_puts_it(
            [Values("Universal 14", "Universal 17", "Universal 17 by Execute", "HighDefinition 14", "HighDefinition 17")] string name)
        {
            PipelineKind kind = PipelineKind.All.First(one => name.StartsWith(one.Folder, StringComparison.Ordinal));
            Build(kind, name.Substring(kind.Folder.Length + 1));
            Arrange();
            Type data = pipeline[kind.Assembly].GetType(kind == PipelineKind.Universal
                ? "UnityEngine.Rendering.Universal.UniversalAdditionalCameraData" : "UnityEngine.Rendering.HighDefinition.HDAdditionalCameraData");
            Component settings = camera.gameObject.AddComponent(data);
            const BindingFlags all = BindingFlags.Instance | BindingFlags.Public | BindingFlags.GetProperty | BindingFlags.GetField;
            void Antialias(bool isOn)
            {
                if (kind == PipelineKind.Universal)
                    Set(settings, "renderPostProcessing", isOn);
                Type type = data.InvokeMember("antialiasing", all, null, settings, null).GetType();
                Set(settings, "antialiasing", Enum.ToObject(type, isOn ? kind == PipelineKind.Universal ? 3 : 2 : 0));
            }
            Antialias(true);
            Play(2);
            for (int frame = 0; frame < 3; frame++)
            {
                Antialias(true);
                Play(1);
                Vector4[] jittered = Pixels();
                Matrix4x4 jitter = JitterNow(), projection = camera.projectionMatrix;
                // Compares by hand.
                Antialias(false);
                camera.projectionMatrix = jitter * projection;
                camera.Render();
                Vector4[] byHand = Pixels();
                camera.ResetProjectionMatrix();
                camera.Render();
                Vector4[] still = Pixels();
                Assert.That(Unlike(jittered, byHand), Is.LessThanOrEqualTo(4), "as a camera with that projection shows it");
                Assert.That(Unlike(jittered, still), Is.GreaterThan(20), "and not as one without");
            }
            Assert.That(Errors, Is.Empty);
        }

        static int Unlike(Vector4[] a, Vector4[] b) => a.Where((pixel, i) => (pixel - b[i]).magnitude > 0.02f).Count();

        // Less than half a pixel.
        static Matrix4x4 ByScript(Camera camera) => Matrix4x4.Translate(new Vector3(0.8f / Width, 0.6f / Height)) * camera.projectionMatrix;

        /// <summary>Jitters like image effects of the Built-in pipeline: in OnPreCull, and back in OnPostRender.</summary>
        sealed class Jittering : MonoBehaviour
        {
            void OnPreCull() => GetComponent<Camera>().projectionMatrix = ByScript(GetComponent<Camera>());
            void OnPostRender() => GetComponent<Camera>().ResetProjectionMatrix();
        }

        /// <summary>Jitters as the camera begins to draw.</summary>
        sealed class JitteringLate : MonoBehaviour
        {
            void OnPreRender() => GetComponent<Camera>().projectionMatrix = ByScript(GetComponent<Camera>());
            void OnPostRender() => GetComponent<Camera>().ResetProjectionMatrix();
        }

        [Test]
        public void In_the_Built_in_pipeline_a_script_may_jitter_up_to_when_the_camera_draws([Values] bool late)
        {
            Build(null, null);
            Arrange();
            Vector4[] still = Pixels();
            camera.projectionMatrix = ByScript(camera);
            Play(1);
            Vector4[] byHand = Pixels();
            camera.ResetProjectionMatrix();
            if (late)
                camera.gameObject.AddComponent<JitteringLate>();
            else
                camera.gameObject.AddComponent<Jittering>();
            Play(2);
            Assert.That(Unlike(Pixels(), byHand), Is.Zero);
            Assert.That(Unlike(byHand, still), Is.GreaterThan(20));
        }
    }
}
