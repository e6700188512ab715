using NUnit.Framework;
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
            Assert.That((mesh.vertexCount, mesh.GetIndexCount(0), mesh.GetTopology(0)), Is.EqualTo((3, 3u, MeshTopology.Triangles)));
            Object.DestroyImmediate(mesh);
        }

        [Test]
        public void Foreign_projects_get_unitys_error_and_nothing()
        {
            Player.Strict = false;
            Mesh mesh = Sealed();
            LogAssert.Expect(LogType.Error, "Not allowed to access vertices on mesh 'Sealed' (isReadable is false; Read/Write must be enabled in import settings)");
            Assert.That(mesh.vertices, Is.Empty);
            LogAssert.Expect(LogType.Error, "Not allowed to access indices on mesh 'Sealed' (isReadable is false; Read/Write must be enabled in import settings)");
            Assert.That(mesh.GetIndices(0), Is.Empty);
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
