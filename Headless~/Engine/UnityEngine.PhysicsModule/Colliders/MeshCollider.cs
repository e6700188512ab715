using System;
using UnityEngine.Headless;

namespace UnityEngine
{
    /// <summary>A mesh's triangles, met on their front, or its hull.</summary>
    public class MeshCollider : Collider
    {
        [NonSerialized] Mesh m_Mesh;
        [NonSerialized] MeshTriangles triangles;
        [NonSerialized] int version;

        /// <summary>Mesh; like in Unity, a changed mesh counts when it is set again.</summary>
        public Mesh sharedMesh
        {
            get => m_Mesh;
            set
            {
                m_Mesh = value;
                triangles = value != null ? new MeshTriangles(value) : null;
                version++;
                PhysicsWorld.ShapesVersion++;
            }
        }

        public bool convex { get; set; }
        public MeshColliderCookingOptions cookingOptions { get; set; } = MeshColliderCookingOptions.CookForFasterSimulation
            | MeshColliderCookingOptions.EnableMeshCleaning | MeshColliderCookingOptions.WeldColocatedVertices
            | MeshColliderCookingOptions.UseFastMidphase;

        internal override void OnCopied(Component source)
        {
            base.OnCopied(source);
            sharedMesh = ((MeshCollider)source).sharedMesh;
        }

        internal override ShapeDescription Describe() => m_Mesh == null ? default : new ShapeDescription
        {
            Kind = convex ? ShapeKind.Hull : ShapeKind.Triangles,
            Triangles = triangles,
            Version = version,
            Scale = transform.lossyScale,
        };
    }

    [Flags]
    public enum MeshColliderCookingOptions
    {
        None = 0,
        CookForFasterSimulation = 2,
        EnableMeshCleaning = 4,
        WeldColocatedVertices = 8,
        UseFastMidphase = 16,
    }
}

namespace UnityEngine.Headless
{
    internal sealed class MeshTriangles : ITriangles
    {
        readonly Mesh mesh;

        public MeshTriangles(Mesh mesh) => this.mesh = mesh;

        public Bounds Bounds => mesh.bounds;

        public void Read(out Vector3[] points, out int[] indices)
        {
            points = mesh.vertices;
            indices = mesh.triangles;
        }
    }
}
