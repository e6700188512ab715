using System.IO;
using System.Linq;
using Fixtures;
using Host.Assets;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Headless;

namespace Host.Tests
{
    public class AssetProjectTests : AssetFixture
    {
        // ---- the index

        [Test]
        public void A_project_has_its_assets_and_the_packages_of_its_manifest()
        {
            var project = Open();
            Assert.That(project.Index.Mounts.Select(m => m.AssetPath), Is.EqualTo(new[] { "Assets", "Packages/com.example.tools" }));
            Assert.That(project.ResolvePath("Packages/com.example.tools/Shaders/Tools.hlsl"),
                Is.EqualTo(Path.Combine(PackageRoot, "Shaders", "Tools.hlsl")));
            Assert.That(project.GuidOfPath("Assets/Shaders/Sum.compute"), Is.EqualTo("20000000000000000000000000000001"));
            Assert.That(project.ResolvePath("Assets/Shaders/Absent.hlsl"), Is.Null);
        }

        [Test]
        public void Hidden_folders_are_not_seen()
        {
            var project = Open();
            Assert.That(project.ResolvePath("Packages/com.example.tools/Hidden~/Secret.txt"), Is.Null);
            Assert.That(project.Index.Problems, Is.Empty, "nor missed for their .meta files");
        }

        [Test]
        public void A_package_alone_is_mounted_below_its_name()
        {
            var package = ProjectAssets.Open(PackageRoot, new[] { typeof(Part).Assembly });
            Assert.That(package.Index.Mounts.Single().AssetPath, Is.EqualTo("Packages/com.example.tools"));
            Assert.That(package.LoadAtPath<TextAsset>("Packages/com.example.tools/Runtime/Note.txt").text, Is.EqualTo("visible\n"));
        }

        [Test]
        public void A_folder_that_is_neither_project_nor_package_is_refused() =>
            Assert.That(Assert.Throws<AssetException>(() => ProjectAssets.Open(Path.GetTempPath(),
            new[] { typeof(Part).Assembly })).Message, Does.Contain("no Unity project").And.Contain("no package"));

        [Test]
        public void Faulty_meta_files_are_listed()
        {
            var problems = Temporary().Write("Assets/A.txt", "a", null)
                .Write("Assets/B.txt", "b", "b0000000000000000000000000000001").Write("Assets/C.txt", "c", "b0000000000000000000000000000001")
                .Write("Assets/D.txt", "d", "B0000000000000000000000000000002")
                    .Write("Assets/E.txt.meta", "guid: b0000000000000000000000000000003\n", null).Open().Index.Problems;
            Assert.That(problems, Has.Some.Contains("Assets/A.txt has no .meta file"));
            Assert.That(problems, Has.Some.Contains("Assets/C.txt has the guid b0000000000000000000000000000001 of Assets/B.txt"));
            Assert.That(problems, Has.Some.Contains("Assets/D.txt.meta: the guid 'B0000000000000000000000000000002' is not 32 lower-case"));
            Assert.That(problems, Has.Some.Contains("Assets/E.txt.meta: the asset of this .meta file is gone"));
        }

        [Test]
        public void Execution_orders_come_from_meta_files()
        {
            Open();
            Assert.That(ExecutionOrder.FromMeta.ToDictionary(o => o.Key.Name, o => o.Value),
                Is.EquivalentTo(new[] { new System.Collections.Generic.KeyValuePair<string, int>("EarlyPart", -50) }));
        }

        // ---- assets

        [Test]
        public void A_scriptable_object_holds_shaders_and_other_assets()
        {
            var recipe = (Recipe)Open().LoadAsset("30000000000000000000000000000001", 11400000, typeof(Recipe));
            Assert.That(recipe.name, Is.EqualTo("Twice"));
            Assert.That(recipe.sum.FindKernel("Sum"), Is.EqualTo(0));
            Assert.That(recipe.draw.name, Is.EqualTo("Fixtures/Flat"));
            Assert.That(recipe.kernels, Is.EqualTo(new[] { recipe.sum, null }));
            Assert.That(recipe.amount, Is.EqualTo(14));
            Assert.That(recipe.next.amount, Is.EqualTo(15));
            Assert.That(recipe.next.next, Is.SameAs(recipe), "a circle of two files");
            Assert.That(recipe.nextWasReadWhenEnabled && recipe.next.nextWasReadWhenEnabled, "both had their values when OnEnable came");
        }

        [Test]
        public void Materials_have_shader_keywords_and_values() => WithDevice(() =>
        {
            var material = Open().LoadAtPath<Material>("Assets/Data/Water.mat");
            Assert.That(material.shader.name, Is.EqualTo("Fixtures/Flat"));
            Assert.That(material.IsKeywordEnabled("FOAM"));
            Assert.That(material.enableInstancing);
            Assert.That(material.renderQueue, Is.EqualTo(3001));
            Assert.That(material.GetFloat("_Gloss"), Is.EqualTo(0.75f));
            // Kept as the shader gets it, in linear space, and converted back.
            Assert.That(Enumerable.Range(0, 4).Select(i => material.GetColor("_Color")[i]),
                Is.EqualTo(new[] { 0.1f, 0.2f, 0.3f, 0.4f }).Within(1e-6f));
            Assert.That(material.GetVector("_Direction"), Is.EqualTo(new Vector4(1, 2, 3, 4)));
            Assert.That(material.GetTexture("_MainTex").name, Is.EqualTo("Four"));
            Assert.That(material.GetTextureScale("_MainTex"), Is.EqualTo(new Vector2(2, 3)));
            Assert.That(material.GetTextureOffset("_MainTex"), Is.EqualTo(new Vector2(0.5f, 0.25f)));
        });

        [Test]
        public void Textures_have_their_pixels_bottom_row_first() => WithDevice(() =>
        {
            var texture = Open().LoadAtPath<Texture2D>("Assets/Data/Four.png");
            Assert.That((texture.width, texture.height, texture.filterMode, texture.wrapModeU, texture.wrapModeV),
                Is.EqualTo((2, 2, FilterMode.Point, TextureWrapMode.Clamp, TextureWrapMode.Repeat)));
            Assert.That(texture.GetPixels32(),
                Is.EqualTo(new[] { new Color32(0, 0, 255, 255), new Color32(255, 255, 255, 128), new Color32(255, 0, 0, 255),
                new Color32(0, 255, 0, 255) }));
        });

        [Test]
        public void Everybody_gets_the_same_object_until_all_is_reloaded()
        {
            var project = Open();
            var first = project.LoadAtPath<ComputeShader>("Assets/Shaders/Sum.compute");
            Assert.That(project.LoadAsset("20000000000000000000000000000001", 7200000, typeof(ComputeShader)), Is.SameAs(first));
            project.ReloadAll();
            Assert.That(first == null, "destroyed");
            Assert.That(project.LoadAtPath<ComputeShader>("Assets/Shaders/Sum.compute") != null, "read again");
        }

        [Test]
        public void Shaders_are_found_by_name()
        {
            var project = Open();
            Assert.That(project.FindShader("Fixtures/Flat"), Is.SameAs(project.LoadAtPath<Shader>("Assets/Shaders/Flat.shader")));
            Assert.That(project.FindShader("Not/This"), Is.Null, "named in a comment only");
        }

        [TestCase(10202, 24)]
        [TestCase(10210, 4)]
        public void Built_in_meshes_are_found_by_their_ids(long fileId, int vertices)
        {
            var text = TemporaryProject.SceneText("  size: 1\n") + $"--- !u!33 &13\nMeshFilter:\n  m_GameObject: {{fileID: 10}}\n  " +
                $"m_Mesh: {{fileID: {fileId}, guid: 0000000000000000e000000000000000, type: 0}}\n";
            var scene = Temporary().Write("Assets/Main.unity", text, null).Load();
            Assert.That(Get<MeshFilter>(scene, "Tank").sharedMesh.vertexCount, Is.EqualTo(vertices));
        }

        // ---- Resources

        [Test]
        public void Resources_are_found_by_path_and_type()
        {
            Open();
            Assert.That(Resources.Load<TextAsset>("Fluid/Notes").text, Is.EqualTo("Fourteen drops.\n"));
            Assert.That(Resources.Load<TextAsset>("fluid/NOTES"), Is.Not.Null, "in any case, as in Unity");
            Assert.That(Resources.Load<Recipe>("Fluid/Twice").amount, Is.EqualTo(14));
            Assert.That(Resources.Load<TextAsset>("Fluid/Twice").text, Does.Contain("drops"), "two files of one name");
            Assert.That(Resources.Load<Recipe>("Fluid/Twice"), Is.SameAs(Resources.Load<Recipe>("Fluid/Twice")));
        }

        [Test]
        public void Resources_that_are_absent_are_null()
        {
            Open();
            Assert.That(Resources.Load<Recipe>("Fluid/Absent"), Is.Null);
            Assert.That(Resources.Load<Recipe>("Fluid/Notes"), Is.Null, "another type");
            Assert.That(Resources.Load<TextAsset>("Fluid/Notes.txt"), Is.Null, "an extension is not a part of the name");
            Assert.That(Resources.Load<Material>("Water"), Is.Null, "not below a Resources folder");
        }

        [Test]
        public void All_resources_of_a_folder_are_found()
        {
            Open();
            Assert.That(Resources.LoadAll<TextAsset>("Fluid").Select(t => t.name), Is.EquivalentTo(new[] { "Notes", "Twice" }));
            Assert.That(Resources.LoadAll<Recipe>("").Select(t => t.name), Is.EqualTo(new[] { "Twice" }));
        }

        // ---- locating scenes

        static TemporaryProject Samples(TemporaryProject project)
        {
            // A package with two samples, of which one has two scenes.
            Directory.Delete(Path.Combine(project.Root, "Assets"), true);
            Directory.Delete(Path.Combine(project.Root, "Packages"), true);
            return project.Write("package.json", "{\"name\": \"com.example.fluid\"}", null).Write("Samples~/Dam Break/Dam.unity", "", null)
                .Write("Samples~/Two/One.unity", "", null).Write("Samples~/Two/Other.unity", "", null);
        }

        [TestCase("Samples~/Dam Break")]
        [TestCase("Samples~/Dam Break/Dam.unity")]
        [TestCase("dam break")]
        [TestCase("Dam")]
        public void A_sample_scene_is_found_by_folder_file_and_name(string what)
        {
            var root = Samples(Temporary()).Root;
            var found = SceneLocator.Find(what, root);
            Assert.That(found.AssetPath, Is.EqualTo("Assets/Samples/Dam Break/Dam.unity"));
            Assert.That(found.Root, Is.EqualTo(root));
            Assert.That(found.Mounts.Select(m => m.AssetPath), Is.EqualTo(new[] { "Packages/com.example.fluid", "Assets/Samples/Dam Break" }));
        }

        [TestCase("Two", "'Two' has 2 scenes")]
        [TestCase("Tsunami", "scene 'Tsunami' does not exist")]
        public void An_unclear_scene_lists_what_there_is(string what, string expected)
        {
            var message = Assert.Throws<AssetException>(() => SceneLocator.Find(what, Samples(Temporary()).Root)).Message;
            Assert.That(message, Does.Contain(expected).And.Contain(Path.Combine("Samples~", "Two", "Other.unity")));
        }
    }
}
