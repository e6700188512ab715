using System;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Headless;

namespace UnityEngine.Rendering.Universal
{
    /// <summary>
    /// The main light's shadow map with one cascade, from the casters' ShadowCaster passes, with its matrix and keyword.
    /// Read in URP 17.1.0, not in 14: Runtime/Passes/MainLightShadowCasterPass.cs, Runtime/ShadowUtils.cs.
    /// </summary>
    internal sealed class MainLightShadows : IDisposable
    {
        const string Keyword = "_MAIN_LIGHT_SHADOWS";
        const int Texels = 2048;
        const float AssetBias = 1;      // of depth and of the normal

        static readonly Matrix4x4[] matrices = new Matrix4x4[5];
        RTHandle map;

        /// <param name="restore">Brings the camera's matrices back.</param>
        public void Draw(Camera camera, float distance, Action restore)
        {
            Light light = Light.MainDirectional();
            bool isOn = light is object && light.shadows != LightShadows.None && light.shadowStrength > 0
                && ScreenShadows.TryFit(camera, light, distance, FrameRenderer.InLayers, FrameRenderer.Seen, out Matrix4x4 view,
                out Matrix4x4 projection, out float width) && DrawMap(light, view, projection, width, distance);
            if (!isOn)
            {
                Shader.DisableKeyword(Keyword);
                return;
            }
            restore();
            Shader.EnableKeyword(Keyword);
        }

        bool DrawMap(Light light, in Matrix4x4 view, in Matrix4x4 projection, float width, float distance)
        {
            RTHandle.Need(ref map, "_MainLightShadowmapTexture",
                new RenderTextureDescriptor(Texels, Texels, GraphicsFormat.None, GraphicsFormat.D32_SFloat), FilterMode.Bilinear);
            float texel = width / Texels;
            // ShadowUtils.GetShadowBias: in texels of the map, away from the light. A light without settings of its own has those of the
            // asset, which begin at 1.
            Shader.SetGlobalVector("_ShadowBias", new Vector4(-AssetBias * texel, -AssetBias * texel, 0, 0));
            Shader.SetGlobalVector("_LightDirection", -light.transform.forward);
            RenderState.SetTarget(map.rt);
            BuiltinVariables.SetViewProjection(view, projection);
            RenderState.Clear(true, false, default, 1);
            foreach (QueuedDraw draw in FrameRenderer.InLayers)
                if (draw.Shadows != ShadowCastingMode.Off)
                    ShadowCasters.Draw(draw);

            Matrix4x4 toTexture = Matrix4x4.Translate(new Vector3(0.5f, 0.5f, 0)) * Matrix4x4.Scale(new Vector3(0.5f, 0.5f, 1));
            matrices[0] = toTexture * GL.GetGPUProjectionMatrix(projection, renderIntoTexture: false) * view;
            Shader.SetGlobalMatrixArray("_MainLightWorldToShadow", matrices);
            Shader.Globals.SetTexture(Shader.PropertyToID("_MainLightShadowmapTexture"), map.rt, RenderTextureSubElement.Depth);
            // z and w: fades out over the last part of the distance, by the square of it.
            float start = distance * 0.9f, scale = 1 / (distance * distance - start * start);
            Shader.SetGlobalVector("_MainLightShadowParams",
                new Vector4(light.shadowStrength, light.shadows == LightShadows.Soft ? 1 : 0, scale, -start * start * scale));
            Shader.SetGlobalVector("_MainLightShadowmapSize", new Vector4(1f / Texels, 1f / Texels, Texels, Texels));
            float half = 0.5f / Texels;
            Shader.SetGlobalVector("_MainLightShadowOffset0", new Vector4(-half, -half, half, -half));
            Shader.SetGlobalVector("_MainLightShadowOffset1", new Vector4(-half, half, half, half));
            return true;
        }

        public void Dispose()
        {
            Shader.DisableKeyword(Keyword);
            map?.Release();
            map = null;
        }
    }
}
