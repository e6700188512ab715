using NUnit.Framework;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace Rill.Tests
{
    /// <summary>The filter on the picture with depths by hand: 1 / z, of width 0, so that only gaps change.</summary>
    public class SurfaceFilterTests
    {
        const int Size = 16;
        const float Near = 0.5f, Far = 0.05f, None = 0f;

        [TestCase("FilterRowsAgain", 1, 0)]
        [TestCase("FilterColumns", 0, 1)]
        public void A_gap_of_one_texel_is_closed_and_no_other(string kernel, int x, int y)
        {
            var depths = new float[Size * Size];
            for (int i = 0; i < depths.Length; i++)
                depths[i] = Near;
            int along = x + y * Size, across = y + x * Size;
            int far = 4 * along + 2 * across, none = 8 * along + 4 * across, wide = 6 * along + 8 * across, step = 7 * along + 11 * across;
            depths[far] = Far;
            depths[none] = None;
            depths[wide] = depths[wide + along] = Far;
            // Beyond an edge between two surfaces: its neighbors are not of one.
            depths[step] = Far;
            for (int i = 1; i < 8; i++)
                depths[step + i * along] = 0.3f;
            depths[3 * along + 13 * across] = 0.49f;        // a dent of 0.04 m, within the range

            float[] filtered = Filter(kernel, depths);
            Assert.That(filtered[far], Is.EqualTo(Near), "water far behind");
            Assert.That(filtered[none], Is.EqualTo(Near), "no water");
            Assert.That(filtered[wide], Is.EqualTo(Far), "two texels wide");
            Assert.That(filtered[wide + along], Is.EqualTo(Far), "two texels wide");
            Assert.That(filtered[step], Is.EqualTo(Far), "between two surfaces");
            for (int i = 0; i < depths.Length; i++)
                if (i != far && i != none)
                    Assert.That(filtered[i], Is.EqualTo(depths[i]), $"texel {i}");
        }

        static float[] Filter(string name, float[] depths)
        {
            ComputeShader shader = StageShader.LoadCompute("SurfaceViews");
            int kernel = shader.FindKernel(name);
            var input = new Texture2DArray(Size, Size, 1, TextureFormat.RFloat, false, true);
            input.SetPixelData(depths, 0, 0);
            input.Apply(false);
            var output = new RenderTexture(new RenderTextureDescriptor(Size, Size, GraphicsFormat.R32_SFloat, GraphicsFormat.None) { dimension = TextureDimension.Tex2DArray, volumeDepth = 1, enableRandomWrite = true });
            output.Create();
            GpuTest.Run(cmd =>
            {
                cmd.SetComputeVectorArrayParam(shader, "_SurfaceDepths", new[] { new Vector4(0f, 1f, 0f, 0f), new Vector4(0f, 1f, 0f, 0f) });
                cmd.SetComputeVectorParam(shader, "_FilterBounds", new Vector4(0f, 0f, Size, Size));
                cmd.SetComputeVectorParam(shader, "_FilterRadius", new Vector4(0f, 0.1f, 0f, 0f));
                cmd.SetComputeIntParam(shader, "_SurfaceEye", 0);
                cmd.SetComputeTextureParam(shader, kernel, "_Depth", input);
                cmd.SetComputeTextureParam(shader, kernel, "_Filtered", output);
                SurfaceIds.Dispatch(cmd, shader, kernel, Size, Size);
            });
            AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(output);
            request.WaitForCompletion();
            float[] filtered = request.GetData<float>().ToArray();
            output.Release();
            Object.DestroyImmediate(output);
            Object.DestroyImmediate(input);
            return filtered;
        }
    }
}
