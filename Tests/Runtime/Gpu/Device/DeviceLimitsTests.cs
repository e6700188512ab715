using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill.Tests
{
    /// <summary>Properties of a device that decide between kernels.</summary>
    public class DeviceLimitsTests
    {
        static readonly KernelNeed Need = new KernelNeed("File", "Kernel", "", 512, 20000, 9, 2, 0);

        [TestCase(GraphicsDeviceType.Direct3D11, false, 32768)]
        [TestCase(GraphicsDeviceType.Direct3D12, false, 32768)]
        [TestCase(GraphicsDeviceType.Metal, true, 32768)]
        [TestCase(GraphicsDeviceType.Vulkan, false, 32768)]
        [TestCase(GraphicsDeviceType.Vulkan, true, 16384)]
        [TestCase(GraphicsDeviceType.OpenGLES3, true, 16384)]
        [TestCase((GraphicsDeviceType)28, false, 16384, Description = "WebGPU, which Unity 2022.3 has no name for")]
        public void Groupshared_memory_is_that_which_the_API_grants(GraphicsDeviceType api, bool isMobile, int bytes)
        {
            Assert.That(DeviceLimits.GroupsharedOf(api, isMobile), Is.EqualTo(bytes));
        }

        [Test]
        public void What_is_too_much_is_named_with_the_kernel_and_the_limit()
        {
            Assert.That(new DeviceLimits(9, 9, 512, 20000).WhyNot(Need), Is.Null);
            Assert.That(new DeviceLimits(8, 9, 512, 20000).WhyNot(Need),
                Is.EqualTo(
                "kernel 'Kernel' of File.compute takes 9 storage buffers, and this device has 8 (SystemInfo.maxComputeBufferInputsCompute)"));
            Assert.That(new DeviceLimits(9, 9, 511, 20000).WhyNot(Need), Is.EqualTo("kernel 'Kernel' of File.compute has groups of 512 " +
                "threads, and this device's have at most 511 (SystemInfo.maxComputeWorkGroupSize)"));
            Assert.That(new DeviceLimits(9, 9, 512, 16384).WhyNot(Need), Is.EqualTo("kernel 'Kernel' of File.compute takes 20,000 " +
                $"bytes of groupshared memory, and {SystemInfo.graphicsDeviceType} grants 16,384"));
        }

        [Test]
        public void A_vertex_stage_counts_its_own_buffers()
        {
            var vertex = new KernelNeed("File", KernelNeed.Vertex, "", 0, 0, 2, 0, 0);
            Assert.That(new DeviceLimits(9, 2, 512, 20000).WhyNot(vertex), Is.Null);
            Assert.That(new DeviceLimits(9, 0, 512, 20000).WhyNot(vertex), Is.EqualTo("the vertex stage of File.shader reads 2 storage " +
                "buffers, and this device has 0 there (SystemInfo.maxComputeBufferInputsVertex)"));
        }

        [Test]
        public void A_kernel_that_the_table_lacks_is_named()
        {
            Assert.That(() => DeviceLimits.Current.Holds("Emitters", "None"),
                Throws.ArgumentException.With.Message.Contains("Emitters.compute has no kernel 'None'"));
        }

        [Test]
        public void The_device_of_the_tests_runs_a_fluid()
        {
            DeviceLimits limits = DeviceLimits.Current;
            Assert.That(limits.StorageBuffers, Is.AtLeast(8));
            Assert.That(limits.Threads, Is.AtLeast(256));
            Assert.That(DeviceGate.MissingAbility(), Is.Null);
            Assert.That(DeviceGate.HasNoGraphics, Is.False);
        }
    }
}
