using System.Collections.Generic;
using System.Linq;
using Host.Assets;
using Host.Shaders;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace Host.Tests
{
    /// <summary>Shaders, materials and meshes that come with the editor.</summary>
    public class GraphicsBuiltInTests : ShaderTextFixture
    {
        static IEnumerable<string> Names() => BuiltInShaders.Names.OrderBy(n => n);

        static readonly string[] ModeKeywords = { "INSTANCING_ON", "_NORMALMAP", "_EMISSION", "_ALPHATEST_ON", "_METALLICGLOSSMAP", "_SPECGLOSSMAP" };

        [TestCaseSource(nameof(Names))]
        public void Every_built_in_shader_compiles_in_every_variant(string name)
        {
            Shader shader = Shader.Find(name);
            Assert.That(shader.name, Is.EqualTo(name));
            Assert.That(shader.Source.Notes, Is.Empty);
            foreach (ShaderPassSource pass in shader.Source.Passes)
                foreach (string keyword in ModeKeywords.Where(k => shader.Source.Keywords.Contains(k)).Append(""))
                {
                    ShaderFolder.Checked(pass.Compile(ShaderStage.Vertex, new[] { keyword }));
                    ShaderFolder.Checked(pass.Compile(ShaderStage.Fragment, new[] { keyword }));
                }
        }

        [TestCase("Standard")]
        [TestCase("Unlit/Color")]
        [TestCase("Unlit/Texture")]
        [TestCase("Unlit/Transparent")]
        [TestCase("Sprites/Default")]
        [TestCase("Legacy Shaders/Diffuse")]
        [TestCase("Diffuse")]
        public void Shader_Find_knows_it(string name) => Assert.That(new Material(Shader.Find(name)).passCount, Is.GreaterThan(0));

        [Test]
        public void Shader_Find_gives_null_for_what_no_one_has() => Assert.That(Shader.Find("Nobody/Has This"), Is.Null);

        [TestCase(10303, "Default-Material", "Standard")]
        [TestCase(10302, "Default-Diffuse", "Legacy Shaders/Diffuse")]
        [TestCase(10304, "Default-Skybox", "Skybox/Procedural")]
        [TestCase(10308, "Default-ParticleSystem", "Sprites/Default")]
        [TestCase(10754, "Sprites-Default", "Sprites/Default")]
        public void Materials_are_found_by_their_file_ids(long id, string name, string shader)
        {
            var material = (Material)BuiltInAssets.Load(id, typeof(Material));
            Assert.That(material.name, Is.EqualTo(name));
            Assert.That(material.shader.name, Is.EqualTo(shader));
            Assert.That(BuiltInAssets.Load(id, typeof(Material)), Is.SameAs(material));
        }

        [TestCase(46, "Standard")]
        [TestCase(10755, "Unlit/Color")]
        public void Shaders_are_found_by_their_file_ids(long id, string name)
            => Assert.That(BuiltInAssets.Load(id, typeof(Shader)).name, Is.EqualTo(name));

        new static Camera NewCamera()
        {
            var camera = new GameObject("Camera").AddComponent<Camera>();
            camera.transform.position = new Vector3(0, 0, -5);
            camera.clearFlags = CameraClearFlags.SolidColor;
            camera.backgroundColor = Color.blue;
            return camera;
        }

        static void NewLight(Vector3 towards)
        {
            var light = new GameObject("Light").AddComponent<Light>();
            light.type = LightType.Directional;
            light.transform.rotation = Quaternion.LookRotation(towards);
        }

        [Test]
        public void A_primitive_is_lit_by_the_sun_on_the_side_that_faces_it()
        {
            NewCamera();
            NewLight(Vector3.left);
            RenderSettings.ambientMode = AmbientMode.Flat;
            RenderSettings.ambientLight = Color.black;
            GameObject sphere = GameObject.CreatePrimitive(PrimitiveType.Sphere);
            sphere.transform.localScale = Vector3.one * 3;
            Assert.That(sphere.GetComponent<MeshRenderer>().sharedMaterial.name, Is.EqualTo("Default-Material"));
            Frame();
            Assert.That(Pixel(38, 16).r, Is.GreaterThan(150), "right");
            Assert.That(Pixel(26, 16).r, Is.LessThan(30), "left");
            Assert.That(Pixel(38, 16).r, Is.EqualTo(Pixel(38, 16).g), "white");
            Assert.That(Pixel(2, 16), Is.EqualTo(new Color32(0, 0, 255, 255)));
        }

        [Test]
        public void A_colored_material_tints_a_primitive_without_changing_the_default_one()
        {
            NewCamera();
            NewLight(Vector3.forward);
            GameObject cube = GameObject.CreatePrimitive(PrimitiveType.Cube);
            cube.GetComponent<Renderer>().material.color = Color.red;
            Frame();
            Assert.That(Pixel(32, 16).r, Is.GreaterThan(200));
            Assert.That(Pixel(32, 16).g, Is.LessThan(130), "the highlight and the default ambient light");
            Assert.That(BuiltinResources.DefaultMaterial.color, Is.EqualTo(Color.white));
        }

        [Test]
        public void Unlit_color_and_transparency_are_exact()
        {
            NewCamera();
            GameObject quad = GameObject.CreatePrimitive(PrimitiveType.Quad);
            quad.transform.localScale = Vector3.one * 4;
            Renderer renderer = quad.GetComponent<Renderer>();
            renderer.material = new Material(Shader.Find("Unlit/Color")) { color = new Color(1, 0.5f, 0.25f) };
            Frame();
            Color32 pixel = Pixel(32, 16);
            Assert.That(new[] { (int)pixel.r, pixel.g, pixel.b }, Is.EqualTo(new[] { 255, 128, 64 }).Within(1));
            renderer.material = new Material(Shader.Find("Sprites/Default")) { color = new Color(1, 0, 0, 0.5f) };
            Frame();
            pixel = Pixel(32, 16);
            Assert.That(new[] { (int)pixel.r, pixel.g, pixel.b }, Is.EqualTo(new[] { 188, 0, 188 }).Within(1),
                "half of linear red over half of linear blue");
        }

        [Test]
        public void The_default_sky_is_brighter_than_its_ground_and_behind_everything()
        {
            Camera camera = NewCamera();
            camera.clearFlags = CameraClearFlags.Skybox;
            NewLight(new Vector3(0, -1, 0.5f));
            RenderSettings.skybox = Resources.GetBuiltinResource<Material>("Default-Skybox.mat");
            GameObject quad = GameObject.CreatePrimitive(PrimitiveType.Quad);
            quad.GetComponent<Renderer>().material = new Material(Shader.Find("Unlit/Color")) { color = Color.red };
            Frame();
            Assert.That(Pixel(32, 16), Is.EqualTo(new Color32(255, 0, 0, 255)));
            Color32 up = Pixel(5, 0), horizon = Pixel(5, 15), down = Pixel(5, 31);
            Assert.That(up.b, Is.GreaterThan(up.r), "blue above");
            Assert.That(horizon.r, Is.GreaterThan(up.r), "bright at the horizon");
            Assert.That(Mathf.Abs(down.r - down.b), Is.LessThan(20), "gray below");
            RenderSettings.skybox = null;
            Frame();
            Assert.That(Pixel(5, 0), Is.EqualTo(new Color32(0, 0, 255, 255)), "without a skybox the background color stands");
        }
    }
}
