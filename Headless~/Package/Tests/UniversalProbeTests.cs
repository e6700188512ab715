using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Rill;
using UnityEngine;
using UnityEngine.Rendering;

namespace Host.Tests
{
    /// <summary>Reflection probes and ambient light on a fluid's surface: an indoor pool mirrors its room, not the sky.</summary>
    public class UniversalProbeTests : UniversalSurfaceFixture
    {
        static readonly Color[] faces = { Color.red, Color.green, Color.blue, Color.yellow, Color.magenta, Color.cyan };

        readonly List<Texture> made = new List<Texture>();
        Vector4 dark;       // the picture's mean where nothing is around

        [TearDown]
        public void ForgetTheClusters()
        {
            Shader.SetGlobalFloat("urp_ReflProbes_Count", 0f);
            Shader.SetGlobalTexture("urp_ReflProbes_Atlas", null);
            RenderSettings.defaultReflectionMode = DefaultReflectionMode.Skybox;
            RenderSettings.customReflectionTexture = null;
            foreach (Texture texture in made)
                Object.DestroyImmediate(texture);
            made.Clear();
        }

        // Milk, which is seen by what it scatters and mirrors; in the dark but for what is around.
        void BuildRoom(string version)
        {
            if (version == "Built-in")
                Build(null, null);
            else
                Build(version);
            Object.FindObjectOfType<Light>().intensity = 0f;
            RenderSettings.ambientSkyColor = Color.black;
            RenderSettings.defaultReflectionMode = DefaultReflectionMode.Custom;
            RenderSettings.customReflectionTexture = Cube(Color.black);
            simulation.GetComponent<FluidSurface>().Preset = SurfacePreset.Milk;
            simulation.GetComponent<FluidSurface>().ReflectionStrength = 4f;
            Play(2);
            simulation.Paused = true;
            Play(1);
            dark = Vector4.zero;
            dark = Mean();
            RenderSettings.customReflectionTexture = Cube(Color.green);
            Play(1);
        }

        Cubemap Cube(params Color[] colors)
        {
            var cube = new Cubemap(4, TextureFormat.RGBAHalf, true);
            for (int mip = 0; mip < 3; mip++)
                for (int face = 0; face < 6; face++)
                    cube.SetPixels(Enumerable.Repeat(colors[face % colors.Length], 16 >> 2 * mip).ToArray(), (CubemapFace)face, mip);
            cube.Apply(false);
            made.Add(cube);
            return cube;
        }

        ReflectionProbe Probe(Color color, Vector3 size, int importance = 1)
        {
            ReflectionProbe probe = new GameObject("Probe").AddComponent<ReflectionProbe>();
            probe.mode = ReflectionProbeMode.Custom;
            probe.customBakedTexture = Cube(color);
            probe.size = size;
            probe.importance = importance;
            probe.blendDistance = 0.5f;
            return probe;
        }

        // Mean of the picture's colors, less those in the dark.
        Vector4 Mean() => Pixels().Aggregate(Vector4.zero, (sum, pixel) => sum + pixel) / (Width * Height) - dark;

        [Test]
        public void In_a_room_it_mirrors_the_probe_and_not_the_sky([Values("14", "17", "Built-in")] string version)
        {
            BuildRoom(version);
            Vector4 sky = Mean();
            ReflectionProbe probe = Probe(Color.red, new Vector3(8, 8, 8));
            Play(1);
            Vector4 room = Mean();
            TestContext.WriteLine($"{sky} under the sky, {room} in the room");
            Assert.That(sky.y, Is.GreaterThan(0.002f));
            Assert.That(sky.x, Is.Zero.Within(1e-4f));
            Assert.That(room.x, Is.EqualTo(sky.y).Within(0.06f * sky.y), "milk scatters a little more of red than of green");
            Assert.That(room.y, Is.Zero.Within(1e-4f));
            probe.transform.position = new Vector3(50, 0, 0);
            Play(1);
            Assert.That((Mean() - sky).magnitude, Is.LessThan(1e-4f), "elsewhere");
        }

        [Test]
        public void Of_two_probes_the_more_important_is_seen_and_the_other_beyond_its_box([Values("14", "17")] string version)
        {
            BuildRoom(version);
            float sky = Mean().y;
            Probe(Color.red, new Vector3(8, 8, 8), 1);
            ReflectionProbe leading = Probe(Color.blue, new Vector3(6, 6, 6), 2);
            Play(1);
            Assert.That(Mean().z, Is.EqualTo(sky).Within(0.02f * sky));
            leading.transform.position = new Vector3(3, 0, 0);      // half of the water
            Play(1);
            Vector4 both = Mean();
            Assert.That(both.x, Is.InRange(0.1f * sky, 0.9f * sky));
            Assert.That(both.z, Is.InRange(0.1f * sky, 0.9f * sky));
            Assert.That(both.x + both.z, Is.EqualTo(sky).Within(0.05f * sky));
        }

        [Test]
        public void A_box_decides_which_wall_is_seen([Values("14", "17", "Built-in")] string version)
        {
            BuildRoom(version);
            ReflectionProbe probe = Probe(Color.red, new Vector3(8, 8, 8));
            probe.customBakedTexture = Cube(faces);
            Play(1);
            Vector4 open = Mean();
            probe.boxProjection = true;
            probe.transform.position = new Vector3(0, 0, -3.9f);       // the wall behind the eye is near to the probe, not to the water
            probe.center = new Vector3(0, 0, 3.9f);
            Play(1);
            Assert.That((Mean() - open).magnitude, Is.GreaterThan(0.1f * open.magnitude));
        }

        [Test]
        public void In_a_clustered_renderer_probes_come_from_the_atlas([Values("14", "17")] string version)
        {
            BuildRoom(version);
            float sky = Mean().y;
            var atlas = new Texture2D(8, 8, TextureFormat.RGBAHalf, false);
            atlas.SetPixels(Enumerable.Repeat(Color.red, 64).ToArray());
            atlas.Apply();
            made.Add(atlas);
            Shader.SetGlobalTexture("urp_ReflProbes_Atlas", atlas);
            Shader.SetGlobalVectorArray("urp_ReflProbes_BoxMin", new[] { new Vector4(-4, -4, -4, 1) });
            Shader.SetGlobalVectorArray("urp_ReflProbes_BoxMax", new[] { new Vector4(4, 4, 4, 0.5f) });
            Shader.SetGlobalVectorArray("urp_ReflProbes_ProbePosition", new[] { new Vector4(0, 0, 0, -2) });
            Shader.SetGlobalVectorArray("urp_ReflProbes_MipScaleOffset", Enumerable.Repeat(new Vector4(1, 1, 0, 0), 7).ToArray());
            Shader.SetGlobalFloat("urp_ReflProbes_Count", 1f);
            Play(1);
            Assert.That(Mean().x, Is.EqualTo(sky).Within(0.02f * sky));
            Assert.That(Mean().y, Is.Zero.Within(1e-4f));
        }

        [Test]
        public void It_is_lit_by_the_ambient_light_of_where_it_is([Values("14", "17")] string version)
        {
            BuildRoom(version);
            Assert.That(Mean().z, Is.Zero.Within(1e-4f));
            RenderSettings.ambientMode = AmbientMode.Flat;
            RenderSettings.ambientSkyColor = Color.blue;
            Play(1);
            Assert.That(Mean().z, Is.GreaterThan(0.01f));
        }
    }
}
