using System;
using System.IO;
using System.IO.Compression;
using System.Linq;
using Host.Assets;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace Host.Tests
{
    /// <summary>Assets that hold bytes: meshes, textures, images.</summary>
    public class AssetDataTests : AssetFixture
    {
        static string Hex(params float[] values) => Convert.ToHexString(values.SelectMany(BitConverter.GetBytes).ToArray()).ToLowerInvariant();
        static string Hex(params ushort[] values) => Convert.ToHexString(values.SelectMany(BitConverter.GetBytes).ToArray()).ToLowerInvariant();

        T Asset<T>(string file, string body) where T : UnityEngine.Object =>
            Temporary().Write("Assets/" + file, TemporaryProject.Header + body, "e0000000000000000000000000000009").Open()
            .LoadAtPath<T>("Assets/" + file);

        const string Channels = "    m_Channels:\n    - {stream: 0, offset: 0, format: 0, dimension: 3}\n    - {stream: 0, offset: 12, " +
            "format: 0, dimension: 3}\n    - {stream: 0, offset: 0, format: 0, dimension: 0}\n"
            + "    - {stream: 1, offset: 0, format: 2, dimension: 4}\n    - {stream: 1, offset: 4, format: 0, dimension: 2}\n";

        static string MeshText(int vertices, string data) => "--- !u!43 &4300000\nMesh:\n  m_Name: Triangle\n  m_SubMeshes:\n"
            + "  - {firstByte: 0, indexCount: 3, topology: 0, baseVertex: 0, firstVertex: 0, vertexCount: 3}\n  - {firstByte: 6, " +
            "indexCount: 2, topology: 3, baseVertex: 1, firstVertex: 1, vertexCount: 2}\n"
            + $"  m_MeshCompression: 0\n  m_IndexFormat: 0\n  m_IndexBuffer: {Hex((ushort)0, 2, 1, 0, 1)}\n"
            + $"  m_VertexData:\n    m_VertexCount: {vertices}\n{Channels}    m_DataSize: {data.Length / 2}\n    _typelessdata: {data}\n"
            + "  m_LocalAABB:\n    m_Center: {x: 1, y: 1, z: 0}\n    m_Extent: {x: 1, y: 1, z: 0}\n";

        // Three vertices of 24 bytes end at 72; the second stream starts at 80.
        static readonly string TriangleData = Hex(0f, 0, 0, 0, 0, -1, 2, 0, 0, 0, 0, -1, 0, 2, 0, 0, 0, -1) + "0000000000000000"
            + "ff000080" + Hex(0f, 0) + "00ff00ff" + Hex(1f, 0) + "0000ffff" + Hex(0f, 1);

        [Test]
        public void Meshes_have_their_streams_and_parts()
        {
            var mesh = Asset<Mesh>("Triangle.asset", MeshText(3, TriangleData));
            Assert.That(mesh.name, Is.EqualTo("Triangle"));
            Assert.That(mesh.vertices, Is.EqualTo(new[] { Vector3.zero, new Vector3(2, 0, 0), new Vector3(0, 2, 0) }));
            Assert.That(mesh.normals, Is.EqualTo(Enumerable.Repeat(Vector3.back, 3)));
            Assert.That(mesh.tangents, Is.Empty);
            Assert.That(mesh.colors32, Is.EqualTo(new[] { new Color32(255, 0, 0, 128), new Color32(0, 255, 0, 255), new Color32(0, 0, 255, 255) }));
            Assert.That(mesh.uv, Is.EqualTo(new[] { Vector2.zero, Vector2.right, Vector2.up }));
            Assert.That(mesh.subMeshCount, Is.EqualTo(2));
            Assert.That(mesh.GetIndices(0), Is.EqualTo(new[] { 0, 2, 1 }));
            Assert.That(mesh.GetTopology(1), Is.EqualTo(MeshTopology.Lines));
            Assert.That(mesh.GetIndices(1), Is.EqualTo(new[] { 1, 2 }), "with the base vertex added");
            Assert.That(mesh.bounds, Is.EqualTo(new Bounds(new Vector3(1, 1, 0), new Vector3(2, 2, 0))));
        }

        [Test]
        public void A_mesh_that_is_cut_off_is_refused() =>
            Assert.That(Assert.Throws<AssetException>(() => Asset<Mesh>("Triangle.asset", MeshText(4, TriangleData))).Message,
            Does.Contain("its 4 vertices need more"));

        [TestCase("m_VertexCount: 3", "m_VertexCount: -1", "it has -1 vertices")]
        [TestCase("m_VertexCount: 3", "m_VertexCount: 2147483647", "its 2147483647 vertices need more")]
        [TestCase("{stream: 0, offset: 12, format: 0, dimension: 3}", "{stream: -1, offset: 12, format: 0, dimension: 3}", "channel 1")]
        [TestCase("{stream: 0, offset: 12, format: 0, dimension: 3}", "{stream: 9, offset: 12, format: 0, dimension: 3}", "channel 1")]
        [TestCase("{stream: 0, offset: 12, format: 0, dimension: 3}", "{stream: 0, offset: -4, format: 0, dimension: 3}", "channel 1")]
        [TestCase("{stream: 0, offset: 12, format: 0, dimension: 3}", "{stream: 0, offset: 13, format: 0, dimension: 3}", "channel 1")]
        [TestCase("{stream: 0, offset: 12, format: 0, dimension: 3}", "{stream: 0, offset: 12, format: 0, dimension: 5}", "channel 1")]
        [TestCase("{stream: 0, offset: 12, format: 0, dimension: 3}", "{stream: 0, offset: 12, format: 10, dimension: 3}", "format UInt32")]
        [TestCase("{stream: 0, offset: 12, format: 0, dimension: 3}", "{stream: 0, offset: 12, format: -1, dimension: 3}", "channel 1")]
        [TestCase("firstByte: 6", "firstByte: -2", "sub-mesh 1")]
        [TestCase("firstByte: 6", "firstByte: 8", "sub-mesh 1 ends at index 6, but the buffer has 5")]
        [TestCase("firstByte: 6", "firstByte: 5", "sub-mesh 1")]
        [TestCase("indexCount: 2", "indexCount: -1", "sub-mesh 1")]
        [TestCase("indexCount: 2", "indexCount: 2147483647", "sub-mesh 1")]
        [TestCase("indexCount: 2", "indexCount: 3", "sub-mesh 1 ends at index 6, but the buffer has 5")]
        [TestCase("topology: 3", "topology: 1", "sub-mesh 1")]
        [TestCase("m_IndexFormat: 0", "m_IndexFormat: 2", "index format 2")]
        [TestCase("m_IndexBuffer: 0000", "m_IndexBuffer: 00", "index buffer is damaged")]
        [TestCase("_typelessdata: 00", "_typelessdata: 0", "vertex data is damaged")]
        [TestCase("_typelessdata: 00", "_typelessdata: x0", "vertex data is damaged")]
        public void A_mesh_with_one_number_damaged_is_refused(string field, string damaged, string message)
        {
            string text = MeshText(3, TriangleData);
            Assert.That(text, Does.Contain(field));
            Assert.That(Assert.Throws<AssetException>(() => Asset<Mesh>("Triangle.asset", text.Replace(field, damaged))).Message,
                Does.Contain(message));
        }

        [Test]
        public void Render_textures_have_their_description()
        {
            var texture = Asset<RenderTexture>("Target.renderTexture",
                "--- !u!84 &8400000\nRenderTexture:\n  m_Name: Target\n  m_Width: 64\n  m_Height: 32\n  m_AntiAliasing: 1\n"
                + $"  m_DepthStencilFormat: 0\n  m_ColorFormat: {(int)GraphicsFormat.R32G32B32A32_SFloat}\n  m_MipMap: 0\n  " +
                $"m_GenerateMips: 1\n  m_EnableRandomWrite: 1\n"
                + "  m_TextureSettings:\n    m_FilterMode: 0\n    m_WrapU: 1\n    m_WrapV: 1\n    m_WrapW: 1\n  m_Dimension: 2\n  " +
                "m_VolumeDepth: 1\n");
            Assert.That((texture.width, texture.height, texture.graphicsFormat, texture.enableRandomWrite, texture.dimension,
                texture.filterMode, texture.wrapMode),
                Is.EqualTo((64, 32, GraphicsFormat.R32G32B32A32_SFloat, true, TextureDimension.Tex2D, FilterMode.Point, TextureWrapMode.Clamp)));
        }

        [Test]
        public void Volume_textures_have_their_voxels() => WithDevice(() =>
        {
            var texture = Asset<Texture3D>("Field.asset", "--- !u!117 &11700000\nTexture3D:\n  m_Name: Field\n  m_ColorSpace: 0\n"
                + $"  m_Format: {(int)GraphicsFormat.R32_SFloat}\n  m_Width: 2\n  m_Height: 1\n  m_Depth: 2\n  m_MipCount: 1\n  image " +
                $"data: 16\n  _typelessdata: {Hex(1f, 2, 3, -4)}\n");
            Assert.That((texture.width, texture.height, texture.depth), Is.EqualTo((2, 1, 2)));
            Assert.That(texture.GetPixels().Select(c => c.r), Is.EqualTo(new[] { 1f, 2, 3, -4 }));
        });

        // ---- PNG: files made here, byte by byte

        static byte[] Png(int width, int height, int depth, int kind, byte[] rows, byte[] palette = null, byte[] alpha = null, int interlace = 0)
        {
            using var file = new MemoryStream();
            void Big(int value) => file.Write(new[] { (byte)(value >> 24), (byte)(value >> 16), (byte)(value >> 8), (byte)value });
            void Chunk(string name, byte[] data)
            {
                if (data == null) return;
                Big(data.Length);
                file.Write(System.Text.Encoding.ASCII.GetBytes(name));
                file.Write(data);
                Big(0);
            }
            using var packed = new MemoryStream();
            using (var zlib = new ZLibStream(packed, CompressionMode.Compress, true)) zlib.Write(rows);
            file.Write(new byte[] { 0x89, (byte)'P', (byte)'N', (byte)'G', 13, 10, 26, 10 });
            Chunk("IHDR", new byte[] { 0, 0, 0, (byte)width, 0, 0, 0, (byte)height, (byte)depth, (byte)kind, 0, 0, (byte)interlace });
            Chunk("PLTE", palette);
            Chunk("tRNS", alpha);
            Chunk("IDAT", packed.ToArray());
            Chunk("IEND", Array.Empty<byte>());
            return file.ToArray();
        }

        [Test]
        public void Images_of_every_row_filter_read_the_same()
        {
            // Four rows of two gray pixels 10, 30 by the filters none, sub, up, average and paeth.
            var image = PngImage.Read(Png(2, 5, 8, 0, new byte[] { 0, 10, 30, 1, 10, 20, 2, 0, 0, 3, 5, 10, 4, 0, 0 }), "x.png");
            Assert.That(image.Pixels.Select(p => p.r), Is.EqualTo(Enumerable.Repeat(new byte[] { 10, 30 }, 5).SelectMany(p => p)));
        }

        [Test]
        public void Images_with_palettes_and_few_bits_are_read()
        {
            // Indices 2, 0, 1 in two bits each.
            var image = PngImage.Read(Png(3, 1, 2, 3, new byte[] { 0, 0b10_00_01_00 }, new byte[] { 1, 2, 3, 4, 5, 6, 7, 8, 9 },
                new byte[] { 100, 200 }), "x.png");
            Assert.That(image.Pixels, Is.EqualTo(new[] { new Color32(7, 8, 9, 255), new Color32(1, 2, 3, 100), new Color32(4, 5, 6, 200) }));
            var bits = PngImage.Read(Png(3, 1, 1, 0, new byte[] { 0, 0b101_00000 }), "x.png");
            Assert.That(bits.Pixels.Select(p => p.g), Is.EqualTo(new byte[] { 255, 0, 255 }));
        }

        [Test]
        public void Images_with_16_bits_keep_the_upper_8()
        {
            var image = PngImage.Read(Png(1, 1, 16, 4, new byte[] { 0, 200, 99, 50, 1 }), "x.png");
            Assert.That(image.Pixels.Single(), Is.EqualTo(new Color32(200, 200, 200, 50)));
        }

        [Test]
        public void Images_that_cannot_be_read_say_why()
        {
            string Fault(byte[] file) => Assert.Throws<AssetException>(() => PngImage.Read(file, "Assets/x.png")).Message;
            Assert.That(Fault(new byte[50]), Is.EqualTo("Assets/x.png: this is no PNG file"));
            Assert.That(Fault(Png(1, 1, 8, 0, new byte[] { 0, 1 }, interlace: 1)), Does.Contain("interlaced"));
            Assert.That(Fault(Png(2, 2, 8, 0, new byte[] { 0, 1, 2 })), Does.Contain("ends in row 1 of 2"));
            Assert.That(Fault(Png(1, 1, 8, 0, new byte[] { 9, 1 })), Does.Contain("row filter 9"));
        }
    }
}
