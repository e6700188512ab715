using UnityEngine.Headless;

namespace UnityEngine
{
    /// <summary>
    /// Found by queries, and meets nothing: the host has no collisions. As in Unity a query finds it where its object was at the last physics
    /// step, when it was enabled, or at the last Physics.SyncTransforms.
    /// </summary>
    public class Collider : Component
    {
        readonly QueriedShape shape;
        bool m_Enabled = true;

        public Collider() => shape = new QueriedShape(this);

        internal Vector3 Position { get; private set; }
        internal Quaternion Rotation { get; private set; }
        internal Vector3 Scale { get; private set; }

        public bool enabled
        {
            get => m_Enabled;
            set
            {
                m_Enabled = value;
                Lifecycle.Refresh(this);
            }
        }

        public bool isTrigger { get; set; }

        /// <summary>On its object or the nearest parent that has one.</summary>
        public Rigidbody attachedRigidbody
        {
            get
            {
                for (Transform place = transform; place != null; place = place.parent)
                    if (place.TryGetComponent(out Rigidbody body))
                        return body;
                return null;
            }
        }

        internal override bool WantsActive => m_Enabled;

        internal override void OnActivated()
        {
            Sync();
            PhysicsWorld.Shapes.Add(shape);
        }

        internal override void OnDeactivated() => PhysicsWorld.Shapes.Remove(shape);

        /// <summary>Whether it reaches into a box: sides from -half to half in the frame that the pose leads to.</summary>
        internal virtual bool Overlaps(Vector3 center, Vector3 half, Quaternion rotation) => false;

        internal void Sync()
        {
            Position = transform.position;
            Rotation = transform.rotation;
            Vector3 scale = transform.lossyScale;
            Scale = new Vector3(Mathf.Abs(scale.x), Mathf.Abs(scale.y), Mathf.Abs(scale.z));
        }

        private protected Vector3 PointOf(Vector3 local) => Position + Rotation * Vector3.Scale(transform.lossyScale, local);
    }

    public class BoxCollider : Collider
    {
        public Vector3 center { get; set; }
        public Vector3 size { get; set; } = Vector3.one;

        internal override bool Overlaps(Vector3 boxCenter, Vector3 half, Quaternion rotation) =>
            BoxOverlap.WithBox(boxCenter, half, rotation, PointOf(center), Vector3.Scale(size, Scale) * 0.5f, Rotation);
    }

    public class SphereCollider : Collider
    {
        public Vector3 center { get; set; }
        public float radius { get; set; } = 0.5f;

        internal override bool Overlaps(Vector3 boxCenter, Vector3 half, Quaternion rotation)
        {
            Vector3 place = PointOf(center);
            return BoxOverlap.WithCapsule(boxCenter, half, rotation, place, place, radius * Mathf.Max(Scale.x, Mathf.Max(Scale.y, Scale.z)));
        }
    }

    public class CapsuleCollider : Collider
    {
        public Vector3 center { get; set; }
        public float radius { get; set; } = 0.5f;
        public float height { get; set; } = 2f;

        /// <summary>0 along x, 1 along y, 2 along z.</summary>
        public int direction { get; set; } = 1;

        internal override bool Overlaps(Vector3 boxCenter, Vector3 half, Quaternion rotation)
        {
            float thick = radius * Mathf.Max(Scale[(direction + 1) % 3], Scale[(direction + 2) % 3]);
            Vector3 axis = Vector3.zero;
            axis[direction] = Mathf.Max(0.5f * height * Scale[direction] - thick, 0f);
            Vector3 place = PointOf(center), end = Rotation * axis;
            return BoxOverlap.WithCapsule(boxCenter, half, rotation, place - end, place + end, thick);
        }
    }

    /// <summary>Stands upright however its object is turned.</summary>
    public class CharacterController : Collider
    {
        public Vector3 center { get; set; }
        public float radius { get; set; } = 0.5f;
        public float height { get; set; } = 2f;

        internal override bool Overlaps(Vector3 boxCenter, Vector3 half, Quaternion rotation)
        {
            float thick = radius * Mathf.Max(Scale.x, Scale.z);
            Vector3 place = PointOf(center), end = Vector3.up * Mathf.Max(0.5f * height * Scale.y - thick, 0f);
            return BoxOverlap.WithCapsule(boxCenter, half, rotation, place - end, place + end, thick);
        }
    }

    /// <summary>Queries find the box around its mesh, where Unity finds its triangles.</summary>
    public class MeshCollider : Collider
    {
        public Mesh sharedMesh { get; set; }
        public bool convex { get; set; }

        internal override bool Overlaps(Vector3 boxCenter, Vector3 half, Quaternion rotation)
        {
            if (sharedMesh == null)
                return false;
            Bounds bounds = sharedMesh.bounds;
            return BoxOverlap.WithBox(boxCenter, half, rotation, PointOf(bounds.center), Vector3.Scale(bounds.extents, Scale), Rotation);
        }
    }
}
