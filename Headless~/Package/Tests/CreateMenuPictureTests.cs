using System;
using System.IO;
using System.Linq;
using System.Text;
using NUnit.Framework;
using Rill;
using Rill.Editor;
using UnityEngine;
using UnityEngine.Headless;
using Object = UnityEngine.Object;

namespace Host.Tests
{
    /// <summary>Objects of the menu GameObject > Rill look like water, without touching a field. Where the environment's RILL_PICTURES names a
    /// folder, the pictures are left there as PPM files to look at.</summary>
    public class CreateMenuPictureTests : InspectorFixture
    {
        const int Width = 320, Height = 180;

        [TestCase("Fluid", 2)]
        [TestCase("Fluid Scene", 2)]
        public void The_water_is_seen_in_its_basin(string item, int frames) => Draw(item, frames, Width, Height);

        [TestCase("Fluid", 24)]
        [TestCase("Fluid", 36)]
        [TestCase("Fluid Scene", 75)]
        [Category("GpuOnly")]
        public void The_water_is_seen_in_its_basin_later(string item, int frames) => Draw(item, frames, 4 * Width, 4 * Height);

        // Mean color of what the fluid changes in the picture: which of its channels is well above which, and by what factor.
        [TestCase("Basaltic lava", "rb", 1.8)]
        [TestCase("Viscoelastic slime", "gb", 1.5)]
        [TestCase("Pectin gel", "rg", 1.4)]
        [TestCase("Honey", "rb", 1.5)]
        [TestCase("Dry sand", "rb", 1.3)]
        [TestCase("Damp sand", "rb", 1.4)]
        [TestCase("Mercury", "", 1.0)]
        [TestCase("Glycerol", "", 1.0)]
        public void A_preset_has_its_color(string name, string channels, double factor)
        {
            FluidPreset preset = FluidPresets.All.Single(one => one.name == name);
            double[] color = Draw("Fluid", 2, Width, Height, fluid => FluidPresets.Apply(preset, new Object[] { fluid }), name);
            double Channel(int i) => color["rgb".IndexOf(channels[i])];
            if (channels != "")
                Assert.That(Channel(0), Is.GreaterThan(factor * Channel(1)));
            else
                Assert.That(color.Max(), Is.LessThan(1.3 * color.Min()), "gray");
        }

        // The water is what differs from the same picture without a fluid: bent tiles, a mirrored sky, glitter. Returns its mean color.
        double[] Draw(string item, int frames, int width, int height, Action<FluidSimulation> set = null, string name = null)
        {
            Player.ScreenWidth = width;
            Player.ScreenHeight = height;
            Material sky = Resources.GetBuiltinResource<Material>("Default-Skybox.mat");
            RenderSettings.skybox = sky;
            if (item == "Fluid")
                AddLight();
            GameObject made = item == "Fluid" ? SceneSetup.CreateFluid(null) : FluidSceneSetup.Create(null);
            FluidSimulation fluid = made.GetComponentInChildren<FluidSimulation>();
            set?.Invoke(fluid);
            Camera camera = item == "Fluid" ? LookAt(fluid) : made.GetComponentInChildren<Camera>();
            camera.enabled = false;
            for (int i = 0; i < frames - 1; i++)
                PlayerLoop.Frame(1f / 60f);
            camera.enabled = true;
            PlayerLoop.Frame(1f / 60f);
            byte[] wet = Screenshot.ReadRgba();
            fluid.GetComponent<FluidSurface>().enabled = false;
            fluid.GetComponent<FluidFoam>().enabled = false;
            PlayerLoop.Frame(1f / 60f);
            byte[] dry = Screenshot.ReadRgba();
            Save(name ?? $"{item} {frames}", wet, width, height);
            Assert.That(Logged, Is.Empty);

            int Differs(int i) => Enumerable.Range(4 * i, 3).Any(k => Math.Abs(wet[k] - dry[k]) > 12) ? 1 : 0;
            double water = Enumerable.Range(0, width * height).Sum(Differs) / (double)(width * height);
            TestContext.Out.WriteLine($"{item} at frame {frames}: {100 * water:0.0} % of the picture is changed by the water");
            Assert.That(water, Is.GreaterThan(0.08));
            Assert.That(camera.clearFlags, Is.EqualTo(CameraClearFlags.Skybox));
            double[] color = Enumerable.Range(0, 3).Select(k
                => Enumerable.Range(0, width * height).Where(i => Differs(i) > 0).Average(i => (double)wet[4 * i + k])).ToArray();
            TestContext.Out.WriteLine(FormattableString.Invariant($"mean color {color[0]:0} {color[1]:0} {color[2]:0}"));
            return color;
        }

        // Looks as the scene view does after F, from where it looks in a new project.
        static Camera LookAt(FluidSimulation fluid)
        {
            var camera = new GameObject("Camera").AddComponent<Camera>();
            camera.fieldOfView = 40f;
            camera.transform.rotation = Quaternion.Euler(26f, 35f, 0f);
            camera.transform.position = fluid.transform.position - 0.2f * Vector3.up - 3.5f * camera.transform.forward;
            return camera;
        }

        // That of a new scene.
        static void AddLight()
        {
            var light = new GameObject("Light").AddComponent<Light>();
            light.type = LightType.Directional;
            light.shadows = LightShadows.Soft;
            light.transform.rotation = Quaternion.Euler(50f, -30f, 0f);
        }

        static void Save(string name, byte[] rgba, int width, int height)
        {
            string folder = Environment.GetEnvironmentVariable("RILL_PICTURES");
            if (string.IsNullOrEmpty(folder))
                return;
            byte[] head = Encoding.ASCII.GetBytes(FormattableString.Invariant($"P6 {width} {height} 255\n"));
            File.WriteAllBytes(Path.Combine(folder, name + ".ppm"),
                head.Concat(rgba.Where((_, i) => i % 4 != 3)).ToArray());
        }
    }
}
