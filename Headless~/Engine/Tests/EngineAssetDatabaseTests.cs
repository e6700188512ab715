using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Host.Tests
{
    /// <summary>Assets that scripts make: in memory, but found and named as files are.</summary>
    public class EngineAssetDatabaseTests : GraphicsFixture
    {
        const string Folder = "Assets/Made", Path = Folder + "/Pot.asset";

        [SetUp]
        public void Start() => Assert.That(AssetDatabase.CreateFolder("Assets", "Made"), Has.Length.EqualTo(32));

        [TearDown]
        public void End() => AssetDatabase.DeleteAsset(Folder);

        [Test]
        public void What_was_made_is_found_by_path_and_guid_with_its_parts()
        {
            var mesh = new Mesh();
            var part = new Mesh { name = "Part" };
            AssetDatabase.CreateAsset(mesh, Path);
            AssetDatabase.AddObjectToAsset(part, mesh);
            Assert.That(mesh.name, Is.EqualTo("Pot"));
            string guid = AssetDatabase.AssetPathToGUID(Path);
            Assert.That(AssetDatabase.GUIDToAssetPath(guid), Is.EqualTo(Path));
            Assert.That((AssetDatabase.GetAssetPath(mesh), AssetDatabase.GetAssetPath(part)), Is.EqualTo((Path, Path)));
            Assert.That(AssetDatabase.TryGetGUIDAndLocalFileIdentifier(mesh, out string same, out long first) && same == guid);
            Assert.That(AssetDatabase.TryGetGUIDAndLocalFileIdentifier(part, out same, out long second) && same == guid && second != first);
            Assert.That(AssetDatabase.LoadAllAssetsAtPath(Path), Is.EqualTo(new[] { mesh, part }));
            Assert.That(AssetDatabase.LoadAssetAtPath<Mesh>(Path), Is.SameAs(mesh));
            Assert.That(AssetDatabase.GenerateUniqueAssetPath(Path), Is.EqualTo(Folder + "/Pot 1.asset"));
            AssetDatabase.RemoveObjectFromAsset(part);
            Assert.That(AssetDatabase.Contains(mesh) && !AssetDatabase.Contains(part));
            Object.DestroyImmediate(part);
            Assert.That(AssetDatabase.DeleteAsset(Path));
            Assert.That(mesh == null && AssetDatabase.LoadMainAssetAtPath(Path) == null);
        }

        [Test]
        public void What_was_made_is_found_by_its_type_and_no_longer_when_it_is_deleted()
        {
            AssetDatabase.CreateAsset(new Mesh(), Path);
            string guid = AssetDatabase.AssetPathToGUID(Path);
            Assert.That(AssetDatabase.FindAssets("t:Mesh"), Has.Member(guid));
            Assert.That(AssetDatabase.FindAssets("t:Pot"), Has.No.Member(guid));
            AssetDatabase.DeleteAsset(Path);
            Assert.That(AssetDatabase.FindAssets("t:Mesh"), Has.No.Member(guid));
            Assert.Throws<System.NotSupportedException>(() => AssetDatabase.FindAssets("Pot t:Mesh"));
        }

        [Test]
        public void Faults_are_unitys()
        {
            var mesh = new Mesh();
            Assert.That(Assert.Throws<UnityException>(() => AssetDatabase.CreateAsset(mesh, "Assets/None/Pot.asset")).Message,
                Does.Contain("parent folder not found"));
            AssetDatabase.CreateAsset(mesh, Path);
            Assert.That(Assert.Throws<UnityException>(() => AssetDatabase.CreateAsset(mesh, Folder + "/Other.asset")).Message,
                Does.Contain("already an asset at 'Assets/Made/Pot.asset'"));
            Assert.That(AssetDatabase.GenerateUniqueAssetPath("Assets/None/Pot.asset"), Is.Empty);
            Assert.That(AssetDatabase.CreateFolder("Nowhere", "Deep"), Is.Empty);
        }

        [Test]
        public void A_built_in_mesh_has_unitys_identifiers()
        {
            GameObject cube = GameObject.CreatePrimitive(PrimitiveType.Cube);
            Mesh mesh = cube.GetComponent<MeshFilter>().sharedMesh;
            // Without a project nothing is identified; with one, as in every scene file.
            Assert.That(UnityEngine.Headless.Player.Assets == null
                || AssetDatabase.TryGetGUIDAndLocalFileIdentifier(mesh, out string guid, out long id)
                && (guid, id) == ("0000000000000000e000000000000000", 10202));
            Object.DestroyImmediate(cube);
        }
    }
}
