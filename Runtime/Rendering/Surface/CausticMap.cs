using System;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>The light of the sun below the surface of the water, found once a frame for all cameras; see Caustics.compute.</summary>
    sealed class CausticMap : IDisposable
    {
        const float MinLightSine = 0.15f;    // of the light's angle with the level of the water; below that layers lie across the light
        const int Columns = 4;
        const int SumWords = 2;             // a texel

        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.Caustics");

        readonly ComputeShader shader = StageShader.LoadCompute("Water");
        readonly CommandBuffer commands = new CommandBuffer { name = "Rill.Caustics" };
        readonly Kernel findRange, trace, store;
        GraphicsBuffer range = GpuBuffer.Structured<float>("Rill.Caustics.Range", 1), sums;
        RenderTexture texture;
        Vector4 axisX, axisY, light, up, size;

        public CausticMap()
        {
            findRange = new Kernel(shader, "FindCausticRange");
            trace = new Kernel(shader, "TraceCaustics");
            store = new Kernel(shader, "StoreCaustics");
        }

        /// <summary>Why there are none on this device; null where there are.</summary>
        public static string DeviceProblem
        {
            get
            {
                foreach (KernelNeed need in KernelNeeds.OfKernels)
                    if (need.File == "Caustics" && DeviceLimits.Current.WhyNot(need) is string why)
                        return why;
                return GpuTexture.WhyNot(RenderTextureFormat.RGHalf, true);
            }
        }

        /// <summary>Half floats: how much light there is, and that times its path through water.</summary>
        public RenderTexture Texture => texture;

        /// <summary>Most texels of the map along a side, and its layers.</summary>
        public static (int texels, int layers) DetailOf(SurfaceQuality quality) => quality == SurfaceQuality.Low ? (256, 4)
            : quality == SurfaceQuality.Medium ? (512, 8) : (768, 10);

        /// <summary>Finds the light of this frame, at once.</summary>
        /// <param name="toLight">World.</param>
        /// <param name="gravity">World; zero where there is none.</param>
        /// <param name="index">Index of refraction.</param>
        public void Update(in MeshFrame mesh, Vector3 toLight, Vector3 gravity, float index, SurfaceQuality quality)
        {
            (int texels, int layers) = DetailOf(quality);
            Matrix4x4 toDomain = mesh.domainToWorld.inverse;
            Vector3 lightward = toDomain.MultiplyVector(toLight).normalized, level = toDomain.MultiplyVector(-gravity).normalized;
            if (Vector3.Dot(level, lightward) < MinLightSine)
                level = lightward;
            Vector2 heights = LightGrid.Extent(level, mesh.domainSize);
            // Above all water, also where it goes on beyond the walls.
            var grid = new LightGrid(lightward, mesh.domainSize, 1f + (heights.y - heights.x) / Vector3.Dot(level, lightward), texels);
            Make(grid.Width, grid.Height, layers);
            (axisX, axisY) = (grid.AxisX, grid.AxisY);
            light = lightward;
            light.w = layers;
            up = level;
            up.w = heights.x;
            Vector4 origin = grid.Origin;
            origin.w = index;

            commands.Clear();
            commands.BeginSample(Marker);
            mesh.SetOn(commands, shader);
            SetOn(commands, shader);
            commands.SetComputeVectorParam(shader, Ids.Origin, origin);
            commands.SetComputeVectorParam(shader, Ids.StepX, grid.StepX);
            commands.SetComputeVectorParam(shader, Ids.StepY, grid.StepY);
            SetField(findRange, mesh);
            commands.DispatchCompute(shader, findRange, 1, 1, 1);
            SetField(trace, mesh);
            commands.SetComputeBufferParam(shader, trace, Ids.Sums, sums);
            SurfaceIds.Dispatch(commands, shader, trace, grid.Width, grid.Height);
            commands.SetComputeBufferParam(shader, store, Ids.Range, range);
            commands.SetComputeBufferParam(shader, store, Ids.Sums, sums);
            commands.SetComputeTextureParam(shader, store, Ids.MapOut, texture);
            shader.GetKernelThreadGroupSizes(store, out uint groupX, out uint groupY, out _);
            commands.DispatchCompute(shader, store, (grid.Width + (int)groupX - 1) / (int)groupX, (grid.Height + (int)groupY - 1)
                / (int)groupY, layers);
            commands.EndSample(Marker);
            Graphics.ExecuteCommandBuffer(commands);
        }

        /// <summary>Sets what CausticLight.hlsl reads for a draw, after <see cref="Update"/>.</summary>
        /// <param name="map">Null where there is none.</param>
        public static void SetOn(MaterialPropertyBlock block, CausticMap map)
        {
            block.SetTexture(Ids.Map, map != null ? (Texture)map.texture : Texture2D.blackTexture);
            block.SetVector(Ids.Light, map != null ? map.light : Vector4.zero);
            if (map == null)
                return;
            block.SetVector(Ids.AxisX, map.axisX);
            block.SetVector(Ids.AxisY, map.axisY);
            block.SetVector(Ids.Up, map.up);
            block.SetVector(Ids.Size, map.size);
        }

        /// <summary>Sets what CausticLight.hlsl reads for a kernel, after <see cref="Update"/>.</summary>
        public void SetOn(CommandBuffer cmd, ComputeShader target, int kernel)
        {
            cmd.SetComputeTextureParam(target, kernel, Ids.Map, texture);
            SetOn(cmd, target);
        }

        public void Describe(StageDescription stage)
        {
            if (texture == null)
                return;
            stage.Kernel(findRange, 1);
            stage.Kernel(trace, 1);
            stage.Kernel(store, 1);
            stage.Buffer("Rill.Caustics.Sums", sums);
            stage.Texture(texture.name, 4L * texture.width * texture.height);
        }

        public void Dispose()
        {
            commands.Dispose();
            GpuBuffer.Release(ref range);
            GpuBuffer.Release(ref sums);
            EngineObject.Release(ref texture);
        }

        void SetOn(CommandBuffer cmd, ComputeShader target)
        {
            cmd.SetComputeVectorParam(target, Ids.AxisX, axisX);
            cmd.SetComputeVectorParam(target, Ids.AxisY, axisY);
            cmd.SetComputeVectorParam(target, Ids.Light, light);
            cmd.SetComputeVectorParam(target, Ids.Up, up);
            cmd.SetComputeVectorParam(target, Ids.Size, size);
        }

        void SetField(Kernel kernel, in MeshFrame mesh)
        {
            mesh.SetField(commands, shader, kernel);
            commands.SetComputeBufferParam(shader, kernel, Ids.Range, range);
        }

        void Make(int width, int height, int layers)
        {
            int rows = (layers + Columns - 1) / Columns;
            var wanted = new Vector4(width, height, Columns, rows);
            if (texture != null && size == wanted)
                return;
            size = wanted;
            EngineObject.Release(ref texture);
            GpuBuffer.Release(ref sums);
            texture = GpuTexture.Create("Rill.Caustics.Map", new RenderTextureDescriptor(width * Columns, height * rows + 1,
                GraphicsFormat.R16G16_SFloat, GraphicsFormat.None)
            { enableRandomWrite = true }, FilterMode.Bilinear);
            sums = GpuBuffer.Structured<uint>("Rill.Caustics.Sums", (long)SumWords * width * height * layers);
            BufferClear.Now(sums);
        }

        static class Ids
        {
            public static readonly int Map = Shader.PropertyToID("_CausticMap");
            public static readonly int MapOut = Shader.PropertyToID("_CausticMapOut");
            public static readonly int AxisX = Shader.PropertyToID("_CausticAxisX");
            public static readonly int AxisY = Shader.PropertyToID("_CausticAxisY");
            public static readonly int Light = Shader.PropertyToID("_CausticLight");
            public static readonly int Up = Shader.PropertyToID("_CausticUp");
            public static readonly int Size = Shader.PropertyToID("_CausticSize");
            public static readonly int Origin = Shader.PropertyToID("_CausticOrigin");
            public static readonly int StepX = Shader.PropertyToID("_CausticStepX");
            public static readonly int StepY = Shader.PropertyToID("_CausticStepY");
            public static readonly int Range = Shader.PropertyToID("_CausticRange");
            public static readonly int Sums = Shader.PropertyToID("_CausticSums");
        }
    }
}
