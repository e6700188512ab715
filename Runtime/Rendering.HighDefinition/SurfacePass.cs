using System;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.HighDefinition;

namespace Rill.HighDefinition
{
    /// <summary>Fills the textures of the surfaces that one camera sees, between its opaque draws and the copy of them that the water
    /// refracts; and draws their motion vectors.</summary>
    [Serializable]
    sealed class SurfacePass : CustomPass
    {
        FluidViews views;
        [NonSerialized] bool isReady;

        /// <summary>Towards the brightest directional light that the camera saw last, world, unit; zero before it was first drawn.</summary>
        [field: NonSerialized] public Vector3 ToLight { get; private set; }

        /// <summary>Of that light, linear, lux.</summary>
        [field: NonSerialized] public Color LightColor { get; private set; }

        public SurfacePass()
        {
            name = "Rill.Surface";
            // It binds what it draws into.
            targetColorBuffer = targetDepthBuffer = TargetBuffer.None;
        }

        /// <summary>For the camera of these views, in this frame.</summary>
        public void Prepare(in FluidViews camera)
        {
            views = camera;
            isReady = true;
        }

        /// <summary>The camera has been drawn, or does not see the water.</summary>
        public void Invalidate()
        {
            views = default;
            isReady = false;
        }

        /// <inheritdoc/>
        protected override void Execute(CustomPassContext ctx)
        {
            FindLight(ctx.cameraCullingResults);
            if (!isReady)
                return;
            isReady = false;
            for (int i = 0; i < FluidSurface.Active.Count; i++)
                FluidSurface.Active[i].Record(ctx.cmd, views);
            if (views.needsMotion)
                DrawMotion(ctx);
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
        public static Color IlluminanceOf(Light light, Color color) => light.TryGetComponent(out HDAdditionalLightData _) ? color : color * Mathf.PI;

        // HDRP binds its lights in buffers whose layout differs from version to version.
        void FindLight(CullingResults culled)
        {
            ToLight = Vector3.up;
            LightColor = Color.clear;
            foreach (VisibleLight light in culled.visibleLights)
            {
                if (light.lightType != LightType.Directional)
                    continue;
                Color color = IlluminanceOf(light.light, light.finalColor);
                if (color.maxColorComponent <= LightColor.maxColorComponent)
                    continue;
                ToLight = -light.localToWorldMatrix.GetColumn(2);
                LightColor = color;
            }
        }
    }
}
