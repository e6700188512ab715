using System;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>How much water the sun's light passes, found once a frame for all of its shadow maps; see WaterShadow.compute.</summary>
    sealed class SunPaths : IDisposable
    {
        const int MaxTexels = 512;      // along a side

        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.Water.SunPaths");

        readonly ComputeShader shader;
        readonly Kernel trace;
        readonly CommandBuffer commands = new CommandBuffer { name = "Rill.Water.SunPaths" };
        RenderTexture texture;

        /// <param name="shader">WaterShadow.compute.</param>
        public SunPaths(ComputeShader shader)
        {
            this.shader = shader;
            trace = new Kernel(shader, "TraceShadow");
        }

        /// <summary>Whether there can be a map of a light; others are followed where a shadow map is drawn.</summary>
        public static bool Knows(Light light) => light != null && light.type == LightType.Directional && light.isActiveAndEnabled
            && light.shadows != LightShadows.None && GpuTexture.WhyNot(RenderTextureFormat.ARGBHalf, true) == null;

        /// <summary>Finds those of this frame, at once.</summary>
        /// <param name="toLight">World.</param>
        /// <param name="block">Property block of the draw into shadow maps.</param>
        public void Update(in MeshFrame mesh, Vector3 toLight, MaterialPropertyBlock block)
        {
            Vector4 light = mesh.domainToWorld.inverse.MultiplyVector(toLight).normalized;
            var grid = new LightGrid(light, mesh.domainSize, 1f, MaxTexels);
            light.w = 1f;
            var size = new Vector4(grid.Width, grid.Height, 0f, 0f);
            Make(grid.Width, grid.Height);
            commands.Clear();
            commands.BeginSample(Marker);
            mesh.SetOn(commands, shader);
            mesh.SetField(commands, shader, trace);
            commands.SetComputeVectorParam(shader, Ids.Light, light);
            commands.SetComputeVectorParam(shader, Ids.Size, size);
            commands.SetComputeVectorParam(shader, Ids.Origin, grid.Origin);
            commands.SetComputeVectorParam(shader, Ids.StepX, grid.StepX);
            commands.SetComputeVectorParam(shader, Ids.StepY, grid.StepY);
            commands.SetComputeTextureParam(shader, trace, Ids.PathsOut, texture);
            SurfaceIds.Dispatch(commands, shader, trace, grid.Width, grid.Height);
            commands.EndSample(Marker);
            Graphics.ExecuteCommandBuffer(commands);
            block.SetTexture(Ids.Paths, texture);
            block.SetVector(Ids.AxisX, grid.AxisX);
            block.SetVector(Ids.AxisY, grid.AxisY);
            block.SetVector(Ids.Light, light);
            block.SetVector(Ids.Size, size);
        }

        /// <summary>For a draw without.</summary>
        public static void SetNone(MaterialPropertyBlock block)
        {
            block.SetTexture(Ids.Paths, Texture2D.blackTexture);
            block.SetVector(Ids.Light, Vector4.zero);
        }

        public void Describe(StageDescription stage)
        {
            stage.Kernel(trace, 1);
            stage.Texture(texture);
        }

        public void Dispose()
        {
            commands.Dispose();
            EngineObject.Release(ref texture);
        }

        void Make(int width, int height)
        {
            if (texture != null && texture.width == width && texture.height == height)
                return;
            EngineObject.Release(ref texture);
            texture = GpuTexture.Create("Rill.Water.SunPaths", new RenderTextureDescriptor(width, height, GraphicsFormat.R16G16B16A16_SFloat,
                GraphicsFormat.None)
            { enableRandomWrite = true });
        }

        static class Ids
        {
            public static readonly int Paths = Shader.PropertyToID("_SunPaths");
            public static readonly int PathsOut = Shader.PropertyToID("_SunPathsOut");
            public static readonly int AxisX = Shader.PropertyToID("_SunAxisX");
            public static readonly int AxisY = Shader.PropertyToID("_SunAxisY");
            public static readonly int Light = Shader.PropertyToID("_SunLight");
            public static readonly int Size = Shader.PropertyToID("_SunSize");
            public static readonly int Origin = Shader.PropertyToID("_SunOrigin");
            public static readonly int StepX = Shader.PropertyToID("_SunStepX");
            public static readonly int StepY = Shader.PropertyToID("_SunStepY");
        }
    }
}
