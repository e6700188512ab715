using System;
using Rill;
using UnityEngine;
using UnityEngine.Rendering;

namespace Host.Bench
{
    /// <summary>The passes of a surface on the screen, for a camera that has the whole of a scene's box in view.</summary>
    sealed class ScreenPasses : IDisposable
    {
        const float FieldOfView = 40f, EyeDistance = 0.064f;       // degrees, m

        readonly FluidSurfaceRecorder recorder = new FluidSurfaceRecorder();
        readonly GameObject eye = new GameObject("Eye");
        readonly Texture2D nothing = new Texture2D(1, 1, TextureFormat.RFloat, false, true);
        readonly FluidViews views;
        readonly Matrix4x4 domainToWorld;

        /// <param name="domain">Size of the box, m.</param>
        /// <param name="width">Pixels of an eye.</param>
        /// <param name="eyes">1 or 2.</param>
        public ScreenPasses(Vector3 domain, float spacing, int width, int height, int eyes)
        {
            eye.AddComponent<Camera>().enabled = false;
            domainToWorld = Matrix4x4.TRS(-0.5f * domain, Quaternion.identity, Vector3.one * spacing);
            float distance = 0.5f * domain.magnitude / Mathf.Tan(0.5f * FieldOfView * Mathf.Deg2Rad);
            Vector3 from = new Vector3(0.35f, 0.35f, -0.87f).normalized * distance;
            Matrix4x4 view = Matrix4x4.TRS(from, Quaternion.LookRotation(-from), new Vector3(1f, 1f, -1f)).inverse;
            Matrix4x4 projection = Matrix4x4.Perspective(FieldOfView, (float)width / height, 0.1f, 4f * distance);
            views = new FluidViews
            {
                camera = eye.GetComponent<Camera>(), eyes = eyes, width = width, height = height, sceneSize = Vector2.one,
                view = Shifted(view, eyes == 2 ? -1f : 0f), rightView = Shifted(view, 1f), projection = projection, rightProjection = projection,
            };
            // Nothing stands in front: 0 is the far plane.
            nothing.SetPixelData(new[] { 0f }, 0);
            nothing.Apply(false);
            Shader.SetGlobalTexture("_CameraDepthTexture", nothing);
        }

        static Matrix4x4 Shifted(Matrix4x4 view, float side) => Matrix4x4.Translate(new Vector3(-0.5f * side * EyeDistance, 0f, 0f)) * view;

        /// <summary>Records all passes for the surface that was just recorded.</summary>
        public void Record(CommandBuffer cmd, PbfSolver solver, SurfaceQuality quality)
        {
            SurfaceFrame frame = SurfaceFrame.Of(solver, domainToWorld, Vector4.zero, 1f, quality);
            recorder.Prepare(views, frame);
            recorder.Record(cmd, views, frame);
        }

        /// <summary>Bytes of the textures.</summary>
        public long Bytes
        {
            get
            {
                var description = new StageDescription("Surface", true, "");
                recorder.Describe(description, 1);
                return description.Bytes;
            }
        }

        /// <summary>Texels with water in the first eye, and those of its textures.</summary>
        public (int Water, int All) Texels
        {
            get
            {
                SurfaceView view = recorder.ViewOf(views.camera);
                RenderTexture depth = view.Smoothed;
                AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(depth, 0, 0, view.Window.Width, 0, view.Window.Height, 0,
                    depth.volumeDepth);
                request.WaitForCompletion();
                int water = 0;
                foreach (float one in request.GetData<float>(0))
                    water += one > 0f ? 1 : 0;
                return (water, depth.width * depth.height);
            }
        }

        public void Dispose()
        {
            recorder.Dispose();
            UnityEngine.Object.DestroyImmediate(eye);
            UnityEngine.Object.DestroyImmediate(nothing);
        }
    }
}
