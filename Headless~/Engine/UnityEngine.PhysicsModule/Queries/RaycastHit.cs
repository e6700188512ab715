using UnityEngine.Headless;

namespace UnityEngine
{
    public struct RaycastHit
    {
        internal RaycastHit(Collider collider, in HitData hit) : this()
        {
            this.collider = collider;
            point = hit.Point;
            normal = hit.Normal;
            distance = hit.Distance;
        }

        public Collider collider { get; }
        public Vector3 point { get; set; }
        public Vector3 normal { get; set; }
        public float distance { get; set; }
        public Vector3 barycentricCoordinate { get => throw Missing.Member("RaycastHit.barycentricCoordinate"); set { } }
        public int triangleIndex => throw Missing.Member("RaycastHit.triangleIndex");
        public Vector2 textureCoord => throw Missing.Member("RaycastHit.textureCoord");
        public Vector2 textureCoord2 => throw Missing.Member("RaycastHit.textureCoord2");
        public Vector2 lightmapCoord => throw Missing.Member("RaycastHit.lightmapCoord");
        public int colliderInstanceID => collider != null ? collider.GetInstanceID() : 0;
        public Rigidbody rigidbody => collider != null ? collider.attachedRigidbody : null;
        public Transform transform => rigidbody != null ? rigidbody.transform : collider != null ? collider.transform : null;
    }
}
