using System;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.HighDefinition;

namespace Rill.HighDefinition
{
    /// <summary>Draws what is wet for one camera and fills the textures of the surfaces that it sees, between its opaque draws and the copy of them
    /// that the water refracts; and draws the surfaces' motion vectors.</summary>
    [Serializable]
    sealed class SurfacePass : CustomPass
    {
        FluidViews views;
        [NonSerialized] int frame, begun, multiPassFrame = -1;

        public SurfacePass()
        {
            name = "Rill.Surface";
            // It binds what it draws into.
            targetColorBuffer = targetDepthBuffer = TargetBuffer.None;
        }

        /// <summary>For the camera of these views, in this frame. HDRP begins all that it draws before it draws the first: where a camera begins
        /// again before it has ended, its eyes are drawn one after the other.</summary>
        public void Prepare(in FluidViews camera)
        {
            views = camera;
            if (frame != Time.frameCount)
                (frame, begun) = (Time.frameCount, 0);
            if (++begun > 1)
                multiPassFrame = Time.frameCount;
            if (multiPassFrame == Time.frameCount)
                views.eyes = 1;
        }

        /// <summary>The camera has been drawn.</summary>
        public void End() => begun = Mathf.Max(begun - 1, 0);

        /// <inheritdoc/>
        protected override void Execute(CustomPassContext ctx)
        {
            SetMatrices(ctx.hdCamera);
            DrawWetness(ctx);
            FluidViews.Light main = BrightestOf(ctx.cameraCullingResults);
            for (int i = 0; i < FluidSurface.Active.Count; i++)
            {
                FluidSurface surface = FluidSurface.Active[i];
                views.light = surface.Sun != null ? LightOf(surface.Sun) : main;
                surface.Record(ctx.cmd, views);
            }
            if (views.needsMotion)
                DrawMotion(ctx);
        }

        // HDRP jitters them once the camera has begun, for antialiasing and upscaling. What it hands to the device is a projection with z
        // and y as that takes them.
        void SetMatrices(HDCamera camera)
        {
            if (views.eyes > 1)
                return;
            views.SetEye(0, camera.mainViewConstants.viewMatrix * Matrix4x4.Translate(-camera.mainViewConstants.worldSpaceCameraPos),
                GL.GetGPUProjectionMatrix(Matrix4x4.identity, true).inverse * camera.mainViewConstants.projMatrix);
        }

        void DrawWetness(in CustomPassContext ctx)
        {
            bool isAnySeen = false;
            for (int i = 0; i < FluidWetness.Active.Count; i++)
                isAnySeen |= FluidWetness.Active[i].IsPreparedFor(views.camera);
            if (!isAnySeen)
                return;
            ctx.cmd.SetRenderTarget(ctx.cameraColorBuffer, 0, CubemapFace.Unknown, RenderTargetIdentifier.AllDepthSlices);
            ctx.cmd.SetViewport(new Rect(0f, 0f, views.width, views.height));
            for (int i = 0; i < FluidWetness.Active.Count; i++)
                FluidWetness.Active[i].Record(ctx.cmd, views);
        }

        // HDRP has drawn its own motion vectors by now, and reads them after the transparent draws.
        void DrawMotion(in CustomPassContext ctx)
        {
            ctx.cmd.SetRenderTarget(ctx.cameraMotionVectorsBuffer, 0, CubemapFace.Unknown, RenderTargetIdentifier.AllDepthSlices);
            ctx.cmd.SetViewport(new Rect(0f, 0f, views.width, views.height));
            for (int i = 0; i < FluidSurface.Active.Count; i++)
                FluidSurface.Active[i].RecordMotion(ctx.cmd, views);
        }

        /// <summary>Lux. A light without HDRP's component has the Built-in pipeline's unit, of which HDRP makes π lux (14.0,
        /// GpuLightsBuilder.Jobs.cs).</summary>
        /// <param name="color">Linear, intensity applied.</param>
        static Color IlluminanceOf(Light light, Color color) => light.TryGetComponent(out HDAdditionalLightData _) ? color : color * Mathf.PI;

        static FluidViews.Light LightOf(Light light)
            => new FluidViews.Light(-light.transform.forward, IlluminanceOf(light, light.color.linear * light.intensity));

        // HDRP binds its lights in buffers whose layout differs from version to version.
        static FluidViews.Light BrightestOf(CullingResults culled)
        {
            var brightest = new FluidViews.Light(Vector3.up, Color.clear);
            foreach (VisibleLight light in culled.visibleLights)
            {
                if (light.lightType != LightType.Directional)
                    continue;
                Color color = IlluminanceOf(light.light, light.finalColor);
                if (color.maxColorComponent > brightest.Color.maxColorComponent)
                    brightest = new FluidViews.Light(-light.localToWorldMatrix.GetColumn(2), color);
            }
            return brightest;
        }
    }
}
