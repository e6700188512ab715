using NUnit.Framework;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Headless;
using UnityEngine.TestTools;

namespace Host.Tests
{
    public class GraphicsMeshAccessTests : GraphicsFixture
    {
        static Mesh Sealed()
        {
            var mesh = new Mesh { name = "Sealed", vertices = new[] { Vector3.zero, Vector3.right, Vector3.up }, triangles = new[] { 0, 2, 1 } };
            mesh.UploadMeshData(false);
            Assert.That(mesh.isReadable);
            mesh.UploadMeshData(true);
            Assert.That(mesh.isReadable, Is.False);
            return mesh;
        }

        [Test]
        public void A_mesh_that_was_made_unreadable_refuses_its_data_and_keeps_its_counts()
        {
            Mesh mesh = Sealed();
            Assert.That(Assert.Throws<GpuUsageException>(() => _ = mesh.vertices).Message, Does.Contain("'Sealed'").And.Contain("Read/Write"));
            Assert.Throws<GpuUsageException>(() => _ = mesh.triangles);
            Assert.Throws<GpuUsageException>(() => mesh.GetIndices(0));
            Assert.Throws<GpuUsageException>(() => mesh.vertices = new Vector3[3]);
            Assert.Throws<GpuUsageException>(() => _ = mesh.normals);
            Assert.Throws<GpuUsageException>(() => _ = mesh.uv);
            Assert.Throws<GpuUsageException>(() => mesh.normals = new Vector3[3]);
            Assert.That((mesh.vertexCount, mesh.GetIndexCount(0), mesh.GetTopology(0)), Is.EqualTo((3, 3u, MeshTopology.Triangles)));
            Object.DestroyImmediate(mesh);
        }

        [Test]
        public void Foreign_projects_get_unitys_error_and_nothing()
        {
            Player.Strict = false;
            Mesh mesh = Sealed();
            LogAssert.Expect(LogType.Error,
                "Not allowed to access vertices on mesh 'Sealed' (isReadable is false; Read/Write must be enabled in import settings)");
            Assert.That(mesh.vertices, Is.Empty);
            LogAssert.Expect(LogType.Error,
                "Not allowed to access indices on mesh 'Sealed' (isReadable is false; Read/Write must be enabled in import settings)");
            Assert.That(mesh.GetIndices(0), Is.Empty);
            Object.DestroyImmediate(mesh);
        }

        [Test]
        public void The_editor_reads_what_scripts_may_not()
        {
            Mesh mesh = Sealed();
            Assert.That(Assert.Throws<System.InvalidOperationException>(() => Mesh.AcquireReadOnlyMeshData(mesh)).Message,
                Does.Contain("'Sealed'").And.Contain("Read/Write"));
            Mesh.MeshDataArray array = UnityEditor.MeshUtility.AcquireReadOnlyMeshData(mesh);
            Mesh.MeshData data = array[0];
            using (var vertices = new NativeArray<Vector3>(3, Allocator.Temp))
            using (var indices = new NativeArray<int>(3, Allocator.Temp))
            using (var few = new NativeArray<int>(2, Allocator.Temp))
            {
                data.GetVertices(vertices);
                data.GetIndices(indices, 0);
                Assert.That(vertices.ToArray(), Is.EqualTo(new[] { Vector3.zero, Vector3.right, Vector3.up }));
                Assert.That(indices.ToArray(), Is.EqualTo(new[] { 0, 2, 1 }));
                Assert.That(data.GetSubMesh(0).indexCount, Is.EqualTo(3));
                Assert.Throws<System.InvalidOperationException>(() => data.GetIndices(few, 0), "too small an array");
                Assert.Throws<System.IndexOutOfRangeException>(() => data.GetIndices(indices, 1));
            }
            array.Dispose();
            Assert.Throws<System.ObjectDisposedException>(() => _ = data.vertexCount);
            Object.DestroyImmediate(mesh);
        }

        [Test]
        public void A_snapshot_does_not_follow_its_mesh()
        {
            var mesh = new Mesh { vertices = new[] { Vector3.zero, Vector3.right, Vector3.up }, triangles = new[] { 0, 2, 1 } };
            using (Mesh.MeshDataArray array = Mesh.AcquireReadOnlyMeshData(mesh))
            {
                mesh.Clear();
                Assert.That((array[0].vertexCount, array[0].GetSubMesh(0).indexCount, mesh.vertexCount), Is.EqualTo((3, 3, 0)));
            }
            using (Mesh.MeshDataArray array = Mesh.AcquireReadOnlyMeshData(mesh))
            using (var none = new NativeArray<Vector3>(0, Allocator.Temp))
                Assert.Throws<System.InvalidOperationException>(() => array[0].GetVertices(none), "no such attribute");
            Object.DestroyImmediate(mesh);
        }

        [Test]
        public void A_copy_is_as_readable_as_its_original()
        {
            Mesh mesh = Sealed(), copy = Object.Instantiate(mesh);
            Assert.That(copy.isReadable, Is.False);
            Object.DestroyImmediate(copy);
            Object.DestroyImmediate(mesh);
        }
    }
}
