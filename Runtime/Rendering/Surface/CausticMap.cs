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
        const float TexelSize = 0.25f;      // d, or more where the map would be too large
        const float MinLightSine = 0.15f;    // of the light's angle with the level of the water; below that layers lie across the light
        const int SizeStep = 32;            // texels: a light that turns slowly must not ask for another texture in each frame
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
        /// <param name="index">Of refraction.</param>
        public void Update(in MeshFrame mesh, Vector3 toLight, Vector3 gravity, float index, SurfaceQuality quality)
        {
            (int texels, int layers) = DetailOf(quality);
            Matrix4x4 toDomain = mesh.domainToWorld.inverse;
            Vector3 lightward = toDomain.MultiplyVector(toLight).normalized, level = toDomain.MultiplyVector(-gravity).normalized;
            if (Vector3.Dot(level, lightward) < MinLightSine)
                level = lightward;
            Vector3 x = Vector3.Cross(lightward, Mathf.Abs(lightward.y) < 0.9f ? Vector3.up : Vector3.right).normalized;
            Vector3 y = Vector3.Cross(lightward, x);
            Vector2 heights = Extent(level, mesh.domainSize);
            Vector2 alongX = Extent(x, mesh.domainSize), alongY = Extent(y, mesh.domainSize);
            float texel = Mathf.Max(TexelSize, Mathf.Max(alongX.y - alongX.x, alongY.y - alongY.x) / (texels - 2));
            int width = Mathf.Min(Steps((alongX.y - alongX.x) / texel + 2f), texels);
            int height = Mathf.Min(Steps((alongY.y - alongY.x) / texel + 2f), texels);
            Make(width, height, layers);

            // The box in the center.
            float left = 0.5f * (alongX.x + alongX.y) - 0.5f * width * texel, bottom = 0.5f * (alongY.x + alongY.y) - 0.5f * height * texel;
            axisX = x / texel;
            axisX.w = -left / texel;
            axisY = y / texel;
            axisY.w = -bottom / texel;
            light = lightward;
            light.w = layers;
            up = level;
            up.w = heights.x;
            // Above all water, also where it goes on beyond the walls.
            float above = Extent(lightward, mesh.domainSize).y + 1f + (heights.y - heights.x) / Vector3.Dot(level, lightward);
            Vector4 origin = x * left + y * bottom + lightward * above;
            origin.w = index;

            commands.Clear();
            commands.BeginSample(Marker);
            SetOn(mesh);
            commands.SetComputeVectorParam(shader, Ids.Origin, origin);
            commands.SetComputeVectorParam(shader, Ids.StepX, x * texel);
            commands.SetComputeVectorParam(shader, Ids.StepY, y * texel);
            SetField(findRange, mesh);
            commands.DispatchCompute(shader, findRange, 1, 1, 1);
            SetField(trace, mesh);
            commands.SetComputeBufferParam(shader, trace, Ids.Sums, sums);
            SurfaceIds.Dispatch(commands, shader, trace, width, height);
            commands.SetComputeBufferParam(shader, store, Ids.Range, range);
            commands.SetComputeBufferParam(shader, store, Ids.Sums, sums);
            commands.SetComputeTextureParam(shader, store, Ids.MapOut, texture);
            shader.GetKernelThreadGroupSizes(store, out uint groupX, out uint groupY, out _);
            commands.DispatchCompute(shader, store, (width + (int)groupX - 1) / (int)groupX, (height + (int)groupY - 1) / (int)groupY, layers);
            commands.EndSample(Marker);
            Graphics.ExecuteCommandBuffer(commands);
        }

        /// <summary>For a draw of a camera, after <see cref="Update"/>.</summary>
        public void SetOn(MaterialPropertyBlock block)
        {
            block.SetTexture(Ids.Map, texture);
            block.SetVector(Ids.AxisX, axisX);
            block.SetVector(Ids.AxisY, axisY);
            block.SetVector(Ids.Light, light);
            block.SetVector(Ids.Up, up);
            block.SetVector(Ids.Size, size);
        }

        /// <summary>For a draw without.</summary>
        public static void SetNone(MaterialPropertyBlock block)
        {
            block.SetTexture(Ids.Map, Texture2D.blackTexture);
            block.SetVector(Ids.Light, Vector4.zero);
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

        void SetOn(in MeshFrame mesh)
        {
            mesh.SetOn(commands, shader);
            commands.SetComputeVectorParam(shader, Ids.AxisX, axisX);
            commands.SetComputeVectorParam(shader, Ids.AxisY, axisY);
            commands.SetComputeVectorParam(shader, Ids.Light, light);
            commands.SetComputeVectorParam(shader, Ids.Up, up);
            commands.SetComputeVectorParam(shader, Ids.Size, size);
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

        static int Steps(float texels) => (Mathf.CeilToInt(texels) + SizeStep - 1) / SizeStep * SizeStep;

        // Of the domain along an axis: lowest and highest, d.
        static Vector2 Extent(Vector3 axis, Vector3 box)
        {
            Vector3 reach = Vector3.Scale(axis, box);
            return new Vector2(Mathf.Min(reach.x, 0f) + Mathf.Min(reach.y, 0f) + Mathf.Min(reach.z, 0f),
                Mathf.Max(reach.x, 0f) + Mathf.Max(reach.y, 0f) + Mathf.Max(reach.z, 0f));
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
