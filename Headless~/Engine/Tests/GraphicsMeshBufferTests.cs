using System;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.Rendering;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Host.Tests
{
    /// <summary>Meshes whose vertices and indices kernels write.</summary>
    public class GraphicsMeshBufferTests : GraphicsFixture
    {
        const MeshUpdateFlags ByKernel = MeshUpdateFlags.DontValidateIndices | MeshUpdateFlags.DontRecalculateBounds;

        // The lower left half of a square of 4 x 4 pixels at the center of the picture, in yellow and blue.
        static readonly float[] Corners =
        {
            -1, -1, 5, 1, 1, 0, 1, 1, 0,
            -1, 1, 5, 1, 1, 0, 1, 1, 0,
            1, -1, 5, 1, 1, 0, 1, 1, 0,
        };

        static readonly int[] Triangle = { 0, 1, 2 };

        static Mesh NewMesh(int vertices = 3, int indices = 3)
        {
            var mesh = new Mesh { name = "Made" };
            mesh.vertexBufferTarget |= GraphicsBuffer.Target.Raw;
            mesh.indexBufferTarget |= GraphicsBuffer.Target.Raw;
            Lay(mesh, vertices);
            mesh.SetIndexBufferParams(indices, IndexFormat.UInt32);
            mesh.SetSubMesh(0, new SubMeshDescriptor(0, indices), ByKernel);
            mesh.bounds = new Bounds(Vector3.zero, Vector3.one * 20);
            return mesh;
        }

        static void Lay(Mesh mesh, int vertices) => mesh.SetVertexBufferParams(vertices,
            new VertexAttributeDescriptor(VertexAttribute.Position, VertexAttributeFormat.Float32, 3),
            new VertexAttributeDescriptor(VertexAttribute.Color, VertexAttributeFormat.Float32, 4),
            new VertexAttributeDescriptor(VertexAttribute.TexCoord0, VertexAttributeFormat.Float32, 2));

        static void Write<T>(GraphicsBuffer target, T[] words) where T : struct
        {
            ComputeShader shader = Compute("Strides");
            int kernel = shader.FindKernel("CopyRaw");
            using (var source = new GraphicsBuffer(GraphicsBuffer.Target.Raw, words.Length, 4))
            {
                source.SetData(words);
                shader.SetInt("_Count", words.Length);
                shader.SetBuffer(kernel, "_InRaw", source);
                shader.SetBuffer(kernel, "_OutRaw", target);
                shader.Dispatch(kernel, (words.Length + 63) / 64, 1, 1);
            }
        }

        static void Fill(Mesh mesh)
        {
            using (GraphicsBuffer vertices = mesh.GetVertexBuffer(0), indices = mesh.GetIndexBuffer())
            {
                Write(vertices, Corners);
                Write(indices, Triangle);
            }
        }

        static void Show(Mesh mesh)
        {
            var camera = new GameObject("Camera").AddComponent<Camera>();
            camera.orthographic = true;
            camera.orthographicSize = 8;
            camera.nearClipPlane = 1;
            camera.farClipPlane = 11;
            camera.clearFlags = CameraClearFlags.SolidColor;
            camera.backgroundColor = new Color(0, 0, 0, 1);
            var shown = new GameObject("Shown");
            shown.AddComponent<MeshFilter>().sharedMesh = mesh;
            shown.AddComponent<MeshRenderer>().sharedMaterial = new Material(DrawShader("Mesh"));
        }

        static int Lit()
        {
            Frame();
            byte[] picture = Screenshot.ReadRgba(null);
            return Enumerable.Range(0, 64 * 32).Count(i => (picture[4 * i], picture[4 * i + 1], picture[4 * i + 2]) == (255, 255, 255));
        }

        [Test]
        public void A_kernel_writes_what_a_mesh_renderer_draws()
        {
            Mesh mesh = NewMesh();
            Fill(mesh);
            Show(mesh);
            Assert.That(Lit(), Is.InRange(6, 10));
            using (GraphicsBuffer vertices = mesh.GetVertexBuffer(0))
                Write(vertices, Corners.Select(x => x == 1 ? 0.1f : x).ToArray());
            Assert.That(Lit(), Is.Zero, "in the next frame too");
            Object.DestroyImmediate(mesh);
        }

        [Test]
        public void Its_buffers_have_the_sizes_and_targets_that_were_asked_for()
        {
            Mesh mesh = NewMesh(7, 12);
            using (GraphicsBuffer vertices = mesh.GetVertexBuffer(0), indices = mesh.GetIndexBuffer())
            {
                Assert.That((vertices.count, vertices.stride, vertices.target),
                    Is.EqualTo((7, 36, GraphicsBuffer.Target.Vertex | GraphicsBuffer.Target.Raw)));
                Assert.That((indices.count, indices.stride, indices.target),
                    Is.EqualTo((12, 4, GraphicsBuffer.Target.Index | GraphicsBuffer.Target.Raw)));
            }
            Assert.That((mesh.vertexCount, mesh.GetIndexCount(0), mesh.indexFormat), Is.EqualTo((7, 12u, IndexFormat.UInt32)));
            Object.DestroyImmediate(mesh);
        }

        [Test]
        public void Without_the_target_a_kernel_does_not_get_them([Values] bool ofIndices)
        {
            Mesh mesh = NewMesh();
            if (ofIndices)
                mesh.indexBufferTarget = GraphicsBuffer.Target.Index;
            else
                mesh.vertexBufferTarget = GraphicsBuffer.Target.Vertex;
            using (GraphicsBuffer buffer = ofIndices ? mesh.GetIndexBuffer() : mesh.GetVertexBuffer(0))
                Assert.That(Assert.Throws<GpuUsageException>(() => Write(buffer, Triangle)).Message, Does.Contain("without Raw"));
            Object.DestroyImmediate(mesh);
        }

        [Test]
        public void Vertices_are_never_structured()
        {
            Assert.That(Assert.Throws<ArgumentException>(() => new Mesh().vertexBufferTarget |= GraphicsBuffer.Target.Structured).Message,
                Does.Contain("Structured").And.Contain("Raw"));
        }

        static readonly (string name, Action<Mesh> change)[] Changes =
        {
            ("SetVertexBufferParams", mesh => Lay(mesh, 5)),
            ("SetIndexBufferParams", mesh => mesh.SetIndexBufferParams(6, IndexFormat.UInt32)),
            ("vertexBufferTarget", mesh => mesh.vertexBufferTarget |= GraphicsBuffer.Target.CopySource),
            ("vertices", mesh => mesh.vertices = new Vector3[3]),
            ("Clear", mesh => mesh.Clear()),
            ("Destroy", Object.DestroyImmediate),
        };

        [Test]
        public void A_change_of_the_data_ends_what_was_handed_out([Values(0, 1, 2, 3, 4, 5)] int change)
        {
            Mesh mesh = NewMesh();
            GraphicsBuffer vertices = mesh.GetVertexBuffer(0), indices = mesh.GetIndexBuffer();
            Changes[change].change(mesh);
            Assert.That(vertices.IsValid() || indices.IsValid(), Is.False, Changes[change].name);
            Assert.That(() => Write(vertices, Corners), Throws.InstanceOf<Exception>().With.Message.Contains("released"));
            vertices.Dispose();
            indices.Dispose();
            if (mesh)
                Object.DestroyImmediate(mesh);
        }

        [Test]
        public void What_was_handed_out_is_given_back_and_the_mesh_keeps_its_content()
        {
            Mesh mesh = NewMesh();
            int before = LiveObjects.Count;
            GraphicsBuffer vertices = mesh.GetVertexBuffer(0);
            Assert.That(LiveObjects.Count, Is.EqualTo(before + 2), "the mesh's memory, and the handle to it");
            Write(vertices, Corners);
            vertices.Dispose();
            Assert.That(LiveObjects.Count, Is.EqualTo(before + 1));
            using (GraphicsBuffer again = mesh.GetVertexBuffer(0))
            {
                var read = new float[Corners.Length];
                again.GetData(read);
                Assert.That(read, Is.EqualTo(Corners));
            }
            Object.DestroyImmediate(mesh);
            Assert.That(LiveObjects.Count, Is.EqualTo(before));
        }

        [Test]
        public void Without_the_flags_a_submesh_is_checked_against_data_that_is_not_there()
        {
            Mesh mesh = NewMesh();
            var all = new SubMeshDescriptor(0, 3);
            Assert.That(Assert.Throws<GpuUsageException>(() => mesh.SetSubMesh(0, all, MeshUpdateFlags.DontRecalculateBounds)).Message,
                Does.Contain("DontValidateIndices"));
            Assert.That(Assert.Throws<GpuUsageException>(() => mesh.SetSubMesh(0, all, MeshUpdateFlags.DontValidateIndices)).Message,
                Does.Contain("DontRecalculateBounds"));
            Assert.That(Assert.Throws<ArgumentException>(() => mesh.SetSubMesh(0, new SubMeshDescriptor(0, 6), ByKernel)).Message,
                Does.Contain("room for 3"));
            Assert.Throws<IndexOutOfRangeException>(() => mesh.SetSubMesh(1, all, ByKernel));
            Object.DestroyImmediate(mesh);
        }

        [Test]
        public void What_no_kernel_has_written_is_not_drawn()
        {
            Mesh mesh = NewMesh();
            Show(mesh);
            LogAssert.Expect(LogType.Exception, new Regex("nothing has written its vertices"));
            Frame();
            using (GraphicsBuffer vertices = mesh.GetVertexBuffer(0))
                Write(vertices, Corners);
            LogAssert.Expect(LogType.Exception, new Regex("nothing has written its indices"));
            Frame();
            Object.DestroyImmediate(mesh);
        }

        [Test]
        public void It_is_not_laid_out_anew_once_it_is_no_longer_readable()
        {
            Mesh mesh = NewMesh();
            mesh.UploadMeshData(true);
            Fill(mesh);
            Assert.Throws<GpuUsageException>(() => Lay(mesh, 4));
            Assert.Throws<GpuUsageException>(() => mesh.SetIndexBufferParams(6, IndexFormat.UInt32));
            Assert.Throws<InvalidOperationException>(() => mesh.vertexBufferTarget = GraphicsBuffer.Target.Vertex);
            Show(mesh);
            Assert.That(Lit(), Is.InRange(6, 10));
            Object.DestroyImmediate(mesh);
        }

        [Test]
        public void What_scripts_set_lies_as_the_layout_says()
        {
            Mesh mesh = NewMesh();
            mesh.vertices = new[] { new Vector3(1, 2, 3), new Vector3(4, 5, 6), new Vector3(7, 8, 9) };
            mesh.SetUVs(0, new[] { new Vector2(0.5f, 0), Vector2.zero, Vector2.zero });
            mesh.triangles = Triangle;
            using (GraphicsBuffer vertices = mesh.GetVertexBuffer(0), indices = mesh.GetIndexBuffer())
            {
                var floats = new float[27];
                vertices.GetData(floats);
                Assert.That(floats.Take(9), Is.EqualTo(new float[] { 1, 2, 3, 0, 0, 0, 0, 0.5f, 0 }));
                Assert.That(floats.Skip(18).Take(3), Is.EqualTo(new float[] { 7, 8, 9 }));
                var three = new int[3];
                indices.GetData(three);
                Assert.That(three, Is.EqualTo(Triangle));
            }
            Object.DestroyImmediate(mesh);
        }

        [Test]
        public void A_layout_that_no_device_or_this_host_has_is_refused()
        {
            var position = new VertexAttributeDescriptor(VertexAttribute.Position);
            var normal = new VertexAttributeDescriptor(VertexAttribute.Normal);
            Assert.That(Assert.Throws<ArgumentException>(() => new Mesh().SetVertexBufferParams(3, position, normal, normal)).Message,
                Does.Contain("order"));
            Assert.Throws<NotSupportedException>(() => new Mesh().SetVertexBufferParams(3, normal));
            Assert.That(Assert.Throws<NotSupportedException>(() => new Mesh().SetVertexBufferParams(3, position,
                new VertexAttributeDescriptor(VertexAttribute.Normal, VertexAttributeFormat.SNorm16, 4))).Message, Does.Contain("SNorm16"));
            Assert.Throws<NotSupportedException>(() => new Mesh().GetVertexBuffer(0));
        }
    }
}
