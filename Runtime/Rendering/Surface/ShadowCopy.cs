using System;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>
    /// The shadow of a directional light for transparent draws of the Built-in pipeline, which gives it to opaque ones alone: its map and
    /// what belongs to it, copied as each camera draws them.
    /// </summary>
    /// <remarks>
    /// The pipeline draws the map and runs <see cref="LightEvent.BeforeScreenspaceMask"/> only where opaque receivers are seen, so a
    /// stamp in the copy says for which picture of which camera it holds. The cameras' own commands set it: one may be drawn from inside of
    /// another.
    /// </remarks>
    sealed class ShadowCopy : IDisposable
    {
        const int MapPass = 0, ValuesPass = 1;      // of ShadowCopy.shader
        const int MaxSize = 2048, Stamps = 1 << 20;

        /// <summary>Positions of the uniforms of the Built-in pipeline's shadow in the copy that ShadowCopy.hlsl makes of them,
        /// texels of one row.</summary>
        [GenerateHlsl("ShadowValues")]
        enum Value
        {
            /// <summary>of four cascades, four rows each</summary>
            WorldToShadow,
            /// <summary>four</summary>
            SplitSpheres = WorldToShadow + 16,
            SplitSquaredRadii = SplitSpheres + 4,
            SplitsFar,
            ShadowData,
            ShadowFade,
            /// <summary>x: which camera and frame they belong to</summary>
            ShadowStamp,
        }

        const int Values = (int)Value.ShadowStamp + 1;

        static readonly Vector4 NoStamp = new Vector4(-1f, 0f, 0f, 0f);

        readonly Light light;
        readonly CommandBuffer copy = new CommandBuffer { name = "Rill.Surface.ShadowMap" },
            values = new CommandBuffer { name = "Rill.Surface.ShadowValues" };
        Material material = new Material(StageShader.Load("ShadowCopy").Shader) { hideFlags = HideFlags.HideAndDontSave };
        RenderTexture map = Make("Rill.Surface.ShadowMap", Size, Size, GraphicsFormat.R32_SFloat);
        RenderTexture valueTexels = Make("Rill.Surface.ShadowValues", Values, 1, GraphicsFormat.R32G32B32A32_SFloat);
        int stamp;
        bool isOn;

        public ShadowCopy(Light light)
        {
            this.light = light;
            light.AddCommandBuffer(LightEvent.AfterShadowMap, copy);
            light.AddCommandBuffer(LightEvent.BeforeScreenspaceMask, values);
        }

        // Size of the pipeline's largest map, up to a limit.
        static int Size => Mathf.Min(512 << (int)QualitySettings.shadowResolution, MaxSize);

        /// <summary>Why there is none on this device; null where there is.</summary>
        public static string DeviceProblem => GpuTexture.WhyNot(RenderTextureFormat.RFloat, false)
            ?? GpuTexture.WhyNot(RenderTextureFormat.ARGBFloat, false);

        /// <summary>Whether it is that of this light, which is still there, at the quality of now.</summary>
        public bool IsOf(Light other) => light != null && ReferenceEquals(light, other) && map.width == Size;

        /// <summary>Whether the camera that draws next needs it: a draw as large as the map otherwise.</summary>
        public void Turn(bool on)
        {
            if (on == isOn)
                return;
            isOn = on;
            copy.Clear();
            values.Clear();
            if (!on)
                return;
            copy.SetShadowSamplingMode(BuiltinRenderTextureType.CurrentActive, ShadowSamplingMode.RawDepth);
            copy.SetGlobalTexture(Ids.ShadowMapSource, BuiltinRenderTextureType.CurrentActive);
            copy.SetGlobalVector(Ids.ShadowCopySize, new Vector4(map.width, map.height, 0f, 0f));
            // All of it is drawn: a tiler need not load what was there.
            copy.SetRenderTarget(map, RenderBufferLoadAction.DontCare, RenderBufferStoreAction.Store);
            copy.DrawProcedural(Matrix4x4.identity, material, MapPass, MeshTopology.Triangles, 3);
            values.SetRenderTarget(valueTexels, RenderBufferLoadAction.DontCare, RenderBufferStoreAction.Store);
            values.DrawProcedural(Matrix4x4.identity, material, ValuesPass, MeshTopology.Triangles, 3);
        }

        /// <summary>Records what a camera does before its shadows are drawn, for its next picture.</summary>
        public void Begin(CommandBuffer cmd)
        {
            stamp = stamp % Stamps + 1;
            cmd.SetGlobalVector(Ids.ShadowStamp, new Vector4(stamp, 0f, 0f, 0f));
        }

        /// <summary>For a draw of a camera.</summary>
        public void SetOn(MaterialPropertyBlock block)
        {
            block.SetTexture(Ids.Copy, map);
            block.SetTexture(Ids.ShadowValues, valueTexels);
        }

        /// <summary>For the constants of the picture that has begun.</summary>
        public void SetOn(ref SurfaceConstants constants)
        {
            constants.shadowReceived = new Vector4(stamp, QualitySettings.shadowCascades,
                QualitySettings.shadowProjection == ShadowProjection.StableFit ? 1f : 0f, 0f);
            constants.shadowLight = -light.transform.forward;
        }

        /// <summary>For a draw without.</summary>
        public static void SetNone(MaterialPropertyBlock block)
        {
            block.SetTexture(Ids.Copy, Texture2D.blackTexture);
            block.SetTexture(Ids.ShadowValues, Texture2D.blackTexture);
        }

        /// <summary>For the constants of the same draw.</summary>
        public static void SetNone(ref SurfaceConstants constants) => constants.shadowReceived = NoStamp;

        public void Dispose()
        {
            if (light != null)
            {
                light.RemoveCommandBuffer(LightEvent.AfterShadowMap, copy);
                light.RemoveCommandBuffer(LightEvent.BeforeScreenspaceMask, values);
            }
            copy.Dispose();
            values.Dispose();
            EngineObject.Release(ref map);
            EngineObject.Release(ref valueTexels);
            EngineObject.Destroy(ref material);
        }

        public void Describe(StageDescription stage)
        {
            stage.Draw("ShadowCopy", 2);
            stage.Texture(map.name, 4L * map.width * map.height);
            stage.Texture(valueTexels.name, 16L * valueTexels.width);
        }

        static RenderTexture Make(string name, int width, int height, GraphicsFormat format) =>
            GpuTexture.Create(name, new RenderTextureDescriptor(width, height, format, GraphicsFormat.None));

        static class Ids
        {
            public static readonly int ShadowMapSource = Shader.PropertyToID("_ShadowMapSource");
            public static readonly int ShadowCopySize = Shader.PropertyToID("_ShadowCopySize");
            public static readonly int ShadowStamp = Shader.PropertyToID("_ShadowStamp");
            public static readonly int Copy = Shader.PropertyToID("_ShadowCopy");
            public static readonly int ShadowValues = Shader.PropertyToID("_ShadowValues");
        }
    }
}
