using NUnit.Framework;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace Rill.Tests
{
    /// <summary>The filter on the picture and its normals, with depths by hand: 1 / z, and the filter of width 0, so that only gaps change.</summary>
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

        [Test]
        public void The_normal_on_a_ridge_does_not_jump_from_one_side_to_the_other()
        {
            float[] Ridge(float at)
            {
                var depths = new float[Size * Size];
                for (int i = 0; i < depths.Length; i++)
                    depths[i] = 0.9f - 0.05f * Mathf.Abs(i % Size - at);
                return depths;
            }

            Vector3 before = Normals(Ridge(6.99f))[8 * Size + 7], after = Normals(Ridge(7.01f))[8 * Size + 7],
                beside = Normals(Ridge(7f))[8 * Size + 11];
            Assert.That(Vector3.Angle(beside, Vector3.forward), Is.EqualTo(Mathf.Atan(0.4f) * Mathf.Rad2Deg).Within(0.1f), "its sides slope");
            Assert.That(Vector3.Angle(before, after), Is.LessThan(2f), "it has moved by a fiftieth of a texel");
        }

        [Test]
        public void The_normals_at_an_edge_are_those_of_their_own_side()
        {
            var depths = new float[Size * Size];
            for (int i = 0; i < depths.Length; i++)
                depths[i] = 0.02f * (i % Size) + (i % Size < 8 ? 0f : 0.5f);
            Vector3[] normals = Normals(depths);
            for (int x = 2; x < Size - 2; x++)
                Assert.That(Vector3.Angle(normals[8 * Size + x], new Vector3(-0.16f, 0f, 1f)), Is.LessThan(0.5f), $"texel {x}");
        }

        // In a picture whose clip space is the world.
        static Vector3[] Normals(float[] depths)
        {
            Color[] normals = null;
            Run("FindNormals", "_Normals", GraphicsFormat.R32G32B32A32_SFloat, depths, request => normals = request.GetData<Color>().ToArray());
            return System.Array.ConvertAll(normals, normal => new Vector3(normal.r, normal.g, normal.b));
        }

        static float[] Filter(string name, float[] depths)
        {
            float[] filtered = null;
            Run(name, "_Filtered", GraphicsFormat.R32_SFloat, depths, request => filtered = request.GetData<float>().ToArray());
            return filtered;
        }

        static void Run(string name, string result, GraphicsFormat format, float[] depths, System.Action<AsyncGPUReadbackRequest> read)
        {
            ComputeShader shader = StageShader.LoadCompute("SurfaceViews");
            int kernel = shader.FindKernel(name);
            var input = new Texture2DArray(Size, Size, 1, TextureFormat.RFloat, false, true);
            input.SetPixelData(depths, 0, 0);
            input.Apply(false);
            var output = new RenderTexture(new RenderTextureDescriptor(Size, Size, format,
                GraphicsFormat.None)
            { dimension = TextureDimension.Tex2DArray, volumeDepth = 1, enableRandomWrite = true });
            output.Create();
            GraphicsBuffer constants = GpuBuffer.Constants<SurfaceConstants>("Constants");
            var view = new SurfaceConstants
            {
                surfaceSize = new Vector4(Size, Size, 1f / Size, 1f / Size),
                surfaceWindow = new Vector4(0f, 0f, Size, Size),
            };
            view.surfaceDepths[0] = new Vector4(0f, 1f, 0f, 0f);
            view.surfaceClipX[0] = new Vector4(1f, 0f, 0f, 0f);
            view.surfaceClipY[0] = new Vector4(0f, 1f, 0f, 0f);
            view.surfaceClipZ[0] = new Vector4(0f, 0f, 1f, 0f);
            view.surfaceClipW[0] = new Vector4(0f, 0f, 0f, 1f);
            GpuTest.Run(cmd =>
            {
                cmd.SetBufferData(constants, new[] { view });
                cmd.SetComputeConstantBufferParam(shader, SurfaceIds.Constants, constants, 0, constants.stride);
                cmd.SetComputeVectorParam(shader, "_FilterBounds", new Vector4(0f, 0f, Size, Size));
                cmd.SetComputeVectorParam(shader, "_FilterRadius", new Vector4(0f, 0.1f, 0f, 0f));
                cmd.SetComputeIntParam(shader, "_SurfaceEye", 0);
                cmd.SetComputeTextureParam(shader, kernel, "_Depth", input);
                cmd.SetComputeTextureParam(shader, kernel, result, output);
                SurfaceIds.Dispatch(cmd, shader, kernel, Size, Size);
            });
            AsyncGPUReadbackRequest request = AsyncGPUReadback.Request(output);
            request.WaitForCompletion();
            read(request);
            constants.Release();
            output.Release();
            Object.DestroyImmediate(output);
            Object.DestroyImmediate(input);
        }
    }
}
