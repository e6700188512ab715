using System;
using UnityEngine.Headless;

namespace UnityEngine
{
    /// <summary>
    /// Like in Unity, a query finds it where its object was at the last physics step, when it was enabled, or at the last
    /// Physics.SyncTransforms.
    /// </summary>
    public class Collider : Component
    {
        static int lastId;

        [NonSerialized] internal readonly int Id = ++lastId;

        /// <summary>Its place in Bullet's world; null where it has none.</summary>
        [NonSerialized] internal ColliderSlot Slot;

        [NonSerialized] bool m_Enabled = true, m_IsTrigger;
        [NonSerialized] PhysicMaterial m_SharedMaterial, m_Material;

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

        public bool isTrigger { get => m_IsTrigger; set { m_IsTrigger = value; PhysicsWorld.ShapesVersion++; } }
        public LayerMask includeLayers { get; set; }
        public LayerMask excludeLayers { get; set; }

        /// <summary>Held alone: an exclusion of either side wins.</summary>
        public int layerOverridePriority { get; set; }

        /// <summary>Held alone.</summary>
        public bool hasModifiableContacts { get; set; }
        public bool providesContacts { get; set; }

        /// <summary>Held; contacts are found from 0.02 m on whatever it is.</summary>
        public float contactOffset { get; set; } = Physics.defaultContactOffset;

        public PhysicMaterial sharedMaterial
        {
            get => m_SharedMaterial;
            set
            {
                m_SharedMaterial = value;
                m_Material = null;
            }
        }

        /// <summary>The collider's own copy, made at the first call.</summary>
        public PhysicMaterial material
        {
            get => m_Material ??= m_SharedMaterial != null ? m_SharedMaterial.Copy() : new PhysicMaterial("");
            set => sharedMaterial = value;
        }

        internal PhysicMaterial MaterialInUse => m_Material ?? m_SharedMaterial;

        /// <summary>On its object or the nearest parent that has one that is active.</summary>
        public Rigidbody attachedRigidbody
        {
            get
            {
                for (Transform node = transform; node != null; node = node.parent)
                    if (node.TryGetComponent(out Rigidbody body))
                        return body;
                return null;
            }
        }

        public Bounds bounds => Activated ? BoundsAt(PoseIn(null), Describe()) : default;

        internal override bool WantsActive => m_Enabled;

        internal override void OnActivated()
        {
            Sync();
            PhysicsWorld.Colliders.Add(this);
            PhysicsWorld.ShapesVersion++;
        }

        internal override void OnDeactivated()
        {
            PhysicsWorld.Colliders.Remove(this);
            PhysicsWorld.ShapesVersion++;
            Slot?.Leave();
        }

        internal override void OnCopied(Component source)
        {
            CopiedProperties.Into(source, this);
            m_Enabled = ((Collider)source).m_Enabled;
            m_IsTrigger = ((Collider)source).m_IsTrigger;
            sharedMaterial = ((Collider)source).sharedMaterial;
        }

        public Vector3 ClosestPointOnBounds(Vector3 position) => bounds.ClosestPoint(position);

        public Vector3 ClosestPoint(Vector3 position) => Physics.ClosestPoint(position, this, transform.position, transform.rotation);

        public bool Raycast(Ray ray, out RaycastHit hitInfo, float maxDistance)
        {
            foreach (RaycastHit hit in Casts.Rays(PhysicsWorld.SceneOf(gameObject), ray.origin, ray.direction, maxDistance,
                Physics.AllLayers, QueryTriggerInteraction.Collide))
                if (hit.collider == this)
                {
                    hitInfo = hit;
                    return true;
                }
            hitInfo = default;
            return false;
        }

        /// <summary>Its shape in the frame of <see cref="PoseIn"/>.</summary>
        internal virtual ShapeDescription Describe() => default;

        /// <summary>The center of its shape and the shape's axes in the frame of its object, unscaled.</summary>
        private protected virtual Vector3 Center => Vector3.zero;

        /// <summary>Whether it follows its object's rotation.</summary>
        private protected virtual bool Turns => true;

        /// <summary>Whether it is stretched by its object's scale about its object's position.</summary>
        private protected virtual bool IsScaled => true;

        internal void Sync()
        {
            Position = transform.position;
            Rotation = transform.rotation;
            Scale = transform.lossyScale;
        }

        /// <summary>Pose at the last sync, for queries.</summary>
        internal BodyPose SyncedPose => PoseAt(Position, Rotation, Scale);

        /// <summary>Pose if its object is there.</summary>
        internal BodyPose PoseAt(Vector3 position, Quaternion rotation, Vector3 scale)
        {
            rotation = Turns ? rotation : Quaternion.identity;
            return new BodyPose(position + rotation * Vector3.Scale(IsScaled ? scale : Vector3.one, Center), rotation);
        }

        /// <summary>Current pose in a frame above it without that frame's scale. Steps through the hierarchy, so that it stays the same
        /// to the last digit while the frame moves.</summary>
        /// <param name="frame">Null for the world.</param>
        internal BodyPose PoseIn(Transform frame)
        {
            if (frame == null || !Turns)
                return PoseAt(transform.position, transform.rotation, transform.lossyScale);
            Vector3 point = Center;
            Quaternion turn = Quaternion.identity;
            for (Transform at = transform; at != frame; at = at.parent)
            {
                point = at.localPosition + at.localRotation * Vector3.Scale(at.localScale, point);
                turn = at.localRotation * turn;
            }
            return new BodyPose(Vector3.Scale(frame.lossyScale, point), turn);
        }

        private protected Vector3 AbsoluteScale
        {
            get
            {
                Vector3 scale = transform.lossyScale;
                return new Vector3(Mathf.Abs(scale.x), Mathf.Abs(scale.y), Mathf.Abs(scale.z));
            }
        }

        static Bounds BoundsAt(BodyPose pose, in ShapeDescription shape)
        {
            Bounds local = shape.LocalBounds();
            if (shape.Kind == ShapeKind.Sphere)
                return new Bounds(pose.Position, local.size);
            Vector3 half = Vector3.zero;
            for (int i = 0; i < 3; i++)
            {
                Vector3 side = Vector3.zero;
                side[i] = local.extents[i];
                side = pose.Rotation * side;
                half += new Vector3(Mathf.Abs(side.x), Mathf.Abs(side.y), Mathf.Abs(side.z));
            }
            return new Bounds(pose.Position + pose.Rotation * local.center, 2f * half);
        }
    }
}
