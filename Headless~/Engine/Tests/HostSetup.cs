using System.Collections.Generic;
using System.IO;
using Host.Shaders;
using Host.Vulkan;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Headless;

namespace Host.Tests
{
    /// <summary>The test run's device, for all tests that go through the engine; without one, its own, under the validation layer.</summary>
    [SetUpFixture]
    public class HostSetup
    {
        static VulkanDevice device, own;

        internal static VulkanDevice Device => device ??= Player.Device as VulkanDevice ?? (own = new VulkanDevice(validation: true));

        [OneTimeTearDown]
        public void ValidationLayerIsSilentAndNothingIsLeft()
        {
            if (own == null)
                return;
            Player.Device = device;
            Gpu.Reset();
            device.WaitIdle();
            int left = device.LiveResources;
            device.Dispose();
            Player.Device = null;
            Assert.That(device.ValidationMessages, Is.Empty, string.Join("\n", device.ValidationMessages));
            Assert.That(left, Is.EqualTo(0), "objects left on the GPU");
        }
    }

    /// <summary>The engine on the device, strict, at the start of a run; afterwards nothing may be left alive and the validation layer must
    /// have kept silent.</summary>
    public abstract class GraphicsFixture
    {
        int liveBefore, messagesBefore;
        List<string> reportBefore;
        IGraphicsDevice deviceBefore;
        bool strictBefore;
        int widthBefore, heightBefore;
        protected readonly List<string> Logged = new List<string>();

        [SetUp]
        public void StartPlayer()
        {
            deviceBefore = Player.Device;
            strictBefore = Player.Strict;
            (widthBefore, heightBefore) = (Player.ScreenWidth, Player.ScreenHeight);
            Player.Device = HostSetup.Device;
            BuiltInShaders.Install();
            Player.Strict = true;
            Player.PretendNoCompute = false;
            Player.LinearColorSpace = true;
            Player.ScreenWidth = 64;
            Player.ScreenHeight = 32;
            PlayerLoop.Reset();
            liveBefore = LiveObjects.Count;
            reportBefore = LiveObjects.Report();
            messagesBefore = HostSetup.Device.ValidationMessages.Count;
            Logged.Clear();
            LogSink.Received += Log;
        }

        [TearDown]
        public void LeaveNothingBehind()
        {
            LogSink.Received -= Log;
            PlayerLoop.Reset();
            RenderTexture.ForgetTemporaries();
            List<string> messages = new List<string>(HostSetup.Device.ValidationMessages);
            int left = LiveObjects.Count;
            string report = string.Join(", ", LiveObjects.Report()) + "; before: " + string.Join(", ", reportBefore);
            Player.Device = deviceBefore;
            Player.Strict = strictBefore;
            (Player.ScreenWidth, Player.ScreenHeight) = (widthBefore, heightBefore);
            Player.PretendNoCompute = false;
            Assert.That(messages.Count, Is.EqualTo(messagesBefore), string.Join("\n", messages));
            Assert.That(left, Is.EqualTo(liveBefore), "left alive: " + report);
        }

        void Log(LogEntry entry) => Logged.Add(entry.ToString());

        static readonly Dictionary<string, ComputeShaderSource> computeSources = new Dictionary<string, ComputeShaderSource>();
        static readonly Dictionary<string, ShaderSource> shaderSources = new Dictionary<string, ShaderSource>();

        static string Folder() => Path.Combine(TestFolder.Path, "Shaders", "Graphics");

        /// <summary>A new object over a file of Shaders/Graphics, which is imported once.</summary>
        protected static ComputeShader Compute(string name)
        {
            if (!computeSources.TryGetValue(ShaderBackend.Current.Name + name, out ComputeShaderSource source))
                computeSources.Add(ShaderBackend.Current.Name + name,
                    source = ShaderImporter.ImportCompute(Path.Combine(Folder(), name + ".compute"), name + ".compute", _ => null,
                    new ShaderCache()));
            return ComputeShader.Create(source);
        }

        protected static Shader DrawShader(string name)
        {
            if (!shaderSources.TryGetValue(ShaderBackend.Current.Name + name, out ShaderSource source))
                shaderSources.Add(ShaderBackend.Current.Name + name,
                    source = ShaderImporter.ImportShader(Path.Combine(Folder(), name + ".shader"), name + ".shader", _ => null,
                    new ShaderCache()));
            return Shader.Create(source);
        }

        protected static void Frame() => PlayerLoop.Frame(1 / 60f);
    }
}
