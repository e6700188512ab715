using System;
using System.IO;
using System.Linq;
using Host.Assets;
using NUnit.Framework;
using Rill;
using UnityEngine;

namespace Host.Tests
{
    /// <summary>Distance fields as files: Unity's text form, written and read.</summary>
    public class SdfAssetTests : AssetFixture
    {
        const string ScriptGuid = "20000000000000000000000000000077", AssetGuid = "e0000000000000000000000000000077";

        static string Hex(params float[] values) => Convert.ToHexString(values.SelectMany(BitConverter.GetBytes).ToArray()).ToLowerInvariant();

        // Text as the editor saves it: the texture's id is one that it drew, and its document comes first.
        static readonly string Text = TemporaryProject.Header
            + "--- !u!117 &-3846215730123456789\nTexture3D:\n  m_ObjectHideFlags: 0\n  m_CorrespondingSourceObject: {fileID: 0}\n  " +
            "m_PrefabInstance: {fileID: 0}\n  m_PrefabAsset: {fileID: 0}\n"
            + "  m_Name: Box Distances\n  m_ImageContentsHash:\n    serializedVersion: 2\n    Hash: 00000000000000000000000000000000\n " +
            " m_IsAlphaChannelOptional: 0\n  serializedVersion: 4\n"
            + "  m_ColorSpace: 0\n  m_Format: 49\n  m_Width: 2\n  m_Height: 2\n  m_Depth: 2\n  m_MipCount: 1\n  m_DataSize: 32\n"
            + "  m_TextureSettings:\n    serializedVersion: 2\n    m_FilterMode: 1\n    m_Aniso: 1\n    m_MipBias: 0\n    m_WrapU: 1\n " +
            "   m_WrapV: 1\n    m_WrapW: 1\n  m_UsageMode: 0\n  m_IsReadable: 1\n"
            + $"  image data: 32\n  _typelessdata: {Hex(1, 2, 3, 4, 5, 6, 7, -8)}\n  m_StreamData:\n    serializedVersion: 2\n    " +
            $"offset: 0\n    size: 0\n    path: \n"
            + "--- !u!114 &11400000\nMonoBehaviour:\n  m_ObjectHideFlags: 0\n  m_CorrespondingSourceObject: {fileID: 0}\n  " +
            "m_PrefabInstance: {fileID: 0}\n  m_PrefabAsset: {fileID: 0}\n  m_GameObject: {fileID: 0}\n  m_Enabled: 1\n  " +
            "m_EditorHideFlags: 0\n"
            + $"  m_Script: {{fileID: 11500000, guid: {ScriptGuid}, type: 3}}\n  m_Name: Box\n  m_EditorClassIdentifier: \n"
            + "  version: 1\n  texture: {fileID: -3846215730123456789}\n  bounds:\n    m_Center: {x: 1, y: 2, z: 3}\n    m_Extent: {x: " +
            "0.5, y: 0.5, z: 0.5}\n  voxelSize: 0.5\n"
            + "  sign: 1\n  shellThickness: 0\n  storageError: 0.001\n  sourceMesh: 0123456789abcdef0123456789abcdef\n  sourceMeshId: " +
            "-4321000056780000999\n  sourceHash: 18446744073709551615\n"
            + "  settings:\n    voxelSize: 0.5\n    resolution: 64\n    padding: 3\n    memoryCap: 1024\n    sign: 0\n    " +
            "shellThickness: 0\n    format: 2\n    leaveOutFar: 0\n";

        TemporaryProject Project() => Temporary().Write("Assets/Scripts/SignedDistanceField.cs",
            "namespace Rill { class SignedDistanceField {} }", ScriptGuid);

        SignedDistanceField Load(string path)
        {
            ProjectAssets project = ProjectAssets.Open(Project().Root, new[] { typeof(SignedDistanceField).Assembly, typeof(AssetFixture).Assembly });
            Play(project, Project().Root);
            return project.LoadAtPath<SignedDistanceField>(path);
        }

        [Test]
        public void A_field_of_the_editor_is_loaded_with_its_texture() => WithDevice(() =>
        {
            Project().Write("Assets/Box.asset", Text, AssetGuid);
            SignedDistanceField field = Load("Assets/Box.asset");
            Assert.That(field.Validate(out string problem), problem);
            Assert.That((field.name, field.Version, field.VoxelSize, field.Sign, field.StorageError),
                Is.EqualTo(("Box", 1, 0.5f, MeshSdfSign.WindingNumber, 0.001f)));
            Assert.That(field.Bounds, Is.EqualTo(new Bounds(new Vector3(1, 2, 3), Vector3.one)));
            Assert.That(field.Resolution, Is.EqualTo(2 * Vector3Int.one));
            Assert.That(field.SourceMesh, Is.EqualTo("0123456789abcdef0123456789abcdef"));
            Assert.That((field.SourceMeshId, field.SourceHash), Is.EqualTo((-4321000056780000999, ulong.MaxValue)));
            Assert.That((field.Settings.memoryCap, field.Settings.format), Is.EqualTo((1024, SdfFormat.Float)));
            Assert.That((field.Texture.format, field.Texture.wrapMode, field.Texture.filterMode),
                Is.EqualTo((TextureFormat.RFloat, TextureWrapMode.Clamp, FilterMode.Bilinear)));
            Assert.That(field.TrySample(new Vector3(1.25f, 2.25f, 3.25f), out float distance));
            Assert.That(distance, Is.EqualTo(-8f));
        });

        [Test]
        public void A_field_of_a_newer_package_is_loaded_and_says_so() => WithDevice(() =>
        {
            Project().Write("Assets/Box.asset", Text.Replace("version: 1\n  texture", "version: 7\n  texture"), AssetGuid);
            Assert.That(Load("Assets/Box.asset").Validate(out string problem), Is.False);
            Assert.That(problem, Does.Contain("'Box' has version 7"));
        });

        [Test]
        public void A_texture_that_was_saved_unreadable_cannot_be_sampled_on_the_cpu() => WithDevice(() =>
        {
            Project().Write("Assets/Box.asset", Text.Replace("m_IsReadable: 1", "m_IsReadable: 0"), AssetGuid);
            SignedDistanceField field = Load("Assets/Box.asset");
            Assert.That(field.Texture.isReadable, Is.False);
            Assert.That(field.TrySample(new Vector3(1.25f, 2.25f, 3.25f), out _), Is.False);
        });

        [TestCase(SdfFormat.Half)]
        [TestCase(SdfFormat.Float)]
        public void A_field_that_was_written_is_read_the_same_and_keeps_its_guid(SdfFormat format) => WithDevice(() =>
        {
            TriangleMesh tetrahedron = new TriangleMesh("Tip: 'one'", new[] { Vector3.zero, Vector3.right, Vector3.up, Vector3.forward },
                new[] { 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3 });
            MeshSdfSettings settings = MeshSdfSettings.Default;
            settings.resolution = 12;
            settings.format = format;
            string file = Path.Combine(Project().Root, "Assets", "Baked", "Tip.asset");
            SignedDistanceField made = SignedDistanceField.Create(MeshSdfBaker.Bake(tetrahedron, settings), "0123456789abcdef0123456789abcdef");
            string guid = AssetWriter.Write(file, made, ScriptGuid);

            SignedDistanceField read = Load("Assets/Baked/Tip.asset");
            Assert.That(read.Validate(out string problem), problem);
            Assert.That((read.name, read.SourceMesh, read.Sign, read.StorageError, read.VoxelSize),
                Is.EqualTo((made.name, made.SourceMesh, made.Sign, made.StorageError, made.VoxelSize)));
            Assert.That(read.Bounds, Is.EqualTo(made.Bounds));
            Assert.That(read.Settings, Is.EqualTo(made.Settings));
            Assert.That(read.Texture.format, Is.EqualTo(made.Texture.format));
            Assert.That(read.Texture.GetPixelData<byte>(0).ToArray(), Is.EqualTo(made.Texture.GetPixelData<byte>(0).ToArray()));
            Assert.That(AssetWriter.Write(file, made, ScriptGuid), Is.EqualTo(guid), "a file that is replaced keeps its GUID");
            UnityEngine.Object.DestroyImmediate(made.Texture);
            UnityEngine.Object.DestroyImmediate(made);
        });

        [Test]
        public void The_text_has_unitys_keys_in_unitys_order() => WithDevice(() =>
        {
            Project().Write("Assets/Box.asset", Text, AssetGuid);
            SignedDistanceField field = Load("Assets/Box.asset");
            string file = Path.Combine(Project().Root, "Written.asset");
            AssetWriter.Write(file, field, ScriptGuid);
            string[] Part(string text, string from)
                => text.Substring(text.IndexOf(from)).Split("--- ")[0].Replace("-3846215730123456789", "11700000").Split('\n');
            string written = File.ReadAllText(file);
            Assert.That(Part(written, "MonoBehaviour:"), Is.EqualTo(Part(Text, "MonoBehaviour:")));
            Assert.That(Part(written, "Texture3D:"), Is.EqualTo(Part(Text, "Texture3D:")));
        });
    }
}
