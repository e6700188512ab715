using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace Host.Tests
{
    /// <summary>Behavior of the player if the simulated device grants less than a program takes.</summary>
    public class LimitsTests : GraphicsFixture
    {
        ApiLimits before;

        [SetUp]
        public void Remember() => before = Player.Limits;

        [TearDown]
        public void Restore() => Player.Limits = before;

        static ApiLimits Named(string name) => ApiLimits.All.Single(limits => limits.Name == name);

        [TestCase("d3d11", GraphicsDeviceType.Direct3D11, 128, 1024, 64, DeviceType.Desktop)]
        [TestCase("metal", GraphicsDeviceType.Metal, 31, 1024, 1024, DeviceType.Desktop)]
        [TestCase("mobile", GraphicsDeviceType.Vulkan, 16, 256, 64, DeviceType.Handheld)]
        [TestCase("webgpu", (GraphicsDeviceType)28, 8, 256, 64, DeviceType.Desktop)]
        public void SystemInfo_reports_the_limits(string name, GraphicsDeviceType api, int buffers, int threads, int threadsZ, DeviceType device)
        {
            Player.Limits = Named(name);
            Assert.That(SystemInfo.graphicsDeviceType, Is.EqualTo(api));
            Assert.That(SystemInfo.maxComputeBufferInputsCompute, Is.EqualTo(buffers));
            Assert.That(SystemInfo.maxComputeBufferInputsVertex, Is.EqualTo(buffers));
            Assert.That(SystemInfo.maxComputeWorkGroupSize, Is.EqualTo(threads));
            Assert.That(SystemInfo.maxComputeWorkGroupSizeX, Is.EqualTo(threads));
            Assert.That(SystemInfo.maxComputeWorkGroupSizeZ, Is.EqualTo(Mathf.Min(threadsZ, Player.Device.Info.MaxGroupSizeZ)));
            Assert.That(SystemInfo.deviceType, Is.EqualTo(device));
            Assert.That(Application.isMobilePlatform, Is.EqualTo(device == DeviceType.Handheld));
        }

        [TestCase("d3d11", true)]
        [TestCase("metal", true)]
        [TestCase("mobile", true)]
        [TestCase("webgpu", false)]
        public void A_texture_of_halves_that_kernels_write_is_made_where_the_device_has_them(string name, bool has)
        {
            Player.Limits = Named(name);
            Assert.That(SystemInfo.SupportsRandomWriteOnRenderTextureFormat(RenderTextureFormat.RHalf), Is.EqualTo(has));
            Assert.That(SystemInfo.SupportsRandomWriteOnRenderTextureFormat(RenderTextureFormat.RFloat), Is.True);
            Assert.That(SystemInfo.SupportsRenderTextureFormat(RenderTextureFormat.RHalf), Is.True);
            var texture = new RenderTexture(8, 8, 0, RenderTextureFormat.RHalf) { name = "Halves", enableRandomWrite = true };
            if (has)
                Assert.That(texture.Create(), Is.True);
            else
                Assert.That(Assert.Throws<GpuUsageException>(() => texture.Create()).Message, Does.Contain("Halves").And.Contain("R16_SFloat"));
            Object.DestroyImmediate(texture);
        }

        [TestCase("d3d11", "")]
        [TestCase("metal", "Wide")]
        [TestCase("mobile", "Wide Groupshared Seventeen")]
        [TestCase("webgpu", "Wide Groupshared Seventeen Nine")]
        public void What_is_beyond_them_is_not_supported_and_its_dispatch_an_error(string name, string refused)
        {
            Player.Limits = Named(name);
            ComputeShader shader = Compute("Limits");
            using var output = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 1024, 4);
            using var input = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 1, 4);
            input.SetData(new uint[1]);
            foreach (string kernel in new[] { "Small", "Wide", "Groupshared", "Nine", "Seventeen" })
            {
                int index = shader.FindKernel(kernel);
                shader.SetBuffer(index, "_Out", output);
                for (int i = 0; i < 16; i++)
                    shader.SetBuffer(index, "_In" + i, input);
                bool holds = !refused.Split(' ').Contains(kernel);
                Assert.That(shader.IsSupported(index), Is.EqualTo(holds), kernel);
                if (holds)
                    shader.Dispatch(index, 1, 1, 1);
                else
                    Assert.That(() => shader.Dispatch(index, 1, 1, 1),
                    Throws.TypeOf<GpuUsageException>().With.Message.Contains($"({kernel}) is more than {Player.Limits.Title} holds: "),
                    kernel);
            }
        }

        [Test]
        public void Not_strict_it_is_logged_and_the_dispatch_skipped()
        {
            Player.Limits = ApiLimits.WebGpu;
            Player.Strict = false;
            ComputeShader shader = Compute("Limits");
            LogAssert.Expect(LogType.Error, new Regex("1024 threads of 256"));
            shader.Dispatch(shader.FindKernel("Wide"), 1, 1, 1);
        }

        [Test]
        public void A_draw_with_more_storage_buffers_than_the_vertex_stage_has_is_an_error()
        {
            var material = new Material(DrawShader("VertexBuffers"));
            using var positions = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 3, 16);
            positions.SetData(new Vector4[3]);
            for (int i = 0; i < 9; i++)
                material.SetBuffer("_At" + i, positions);
            void Draw()
            {
                using var cmd = new CommandBuffer();
                cmd.SetRenderTarget(BuiltinRenderTextureType.CameraTarget);
                cmd.DrawProcedural(Matrix4x4.identity, material, 0, MeshTopology.Triangles, 3);
                Graphics.ExecuteCommandBuffer(cmd);
            }
            Player.Limits = ApiLimits.Mobile;
            Assert.That(Draw, Throws.Nothing);
            Player.Limits = ApiLimits.WebGpu;
            Assert.That(Draw, Throws.TypeOf<GpuUsageException>().With.Message.Contains("9 storage buffers of 8"));
            Object.Destroy(material);
            Frame();
        }
    }
}
