using System;
using UnityEngine.Headless;

namespace UnityEngine
{
    /// <summary>Holds its object's body to another, or to the world where there is none. Bullet solves it with the contacts.</summary>
    [RequireComponent(typeof(Rigidbody))]
    public class Joint : Component, ICopiesMore
    {
        [NonSerialized] readonly JointAxis[] axes = new JointAxis[6];
        [NonSerialized] Rigidbody m_ConnectedBody;
        [NonSerialized] Vector3 m_Anchor, m_Axis = Vector3.right, m_ConnectedAnchor;
        [NonSerialized] SolvedJoint solved;
        [NonSerialized] bool isChanged;

        public Rigidbody connectedBody { get => m_ConnectedBody; set { m_ConnectedBody = value; LeaveWorld(); } }

        /// <summary>In the frame of its object, scaled with it.</summary>
        public Vector3 anchor { get => m_Anchor; set { m_Anchor = value; LeaveWorld(); } }

        public Vector3 axis { get => m_Axis; set { m_Axis = value; LeaveWorld(); } }

        /// <summary>In the frame of the connected object, or in the world. Where it is automatic it is where the anchor is as the joint is
        /// first stepped.</summary>
        public Vector3 connectedAnchor
        {
            get => autoConfigureConnectedAnchor && !IsSettled ? AnchorOnOther() : m_ConnectedAnchor;
            set { m_ConnectedAnchor = value; LeaveWorld(); }
        }

        public bool autoConfigureConnectedAnchor { get; set; } = true;
        public float breakForce { get; set; } = float.PositiveInfinity;
        public float breakTorque { get; set; } = float.PositiveInfinity;
        public bool enableCollision { get; set; }

        /// <summary>Held alone.</summary>
        public bool enablePreprocessing { get; set; } = true;
        public float massScale { get; set; } = 1f;
        public float connectedMassScale { get; set; } = 1f;

        /// <summary>On its own body in the last step, N and N m.</summary>
        public Vector3 currentForce { get; private protected set; }
        public Vector3 currentTorque { get; private protected set; }

        internal Rigidbody Body => TryGetComponent(out Rigidbody body) && body.Activated ? body : null;

        /// <summary>About the axis, radians.</summary>
        private protected float Angle { get; private set; }

        /// <summary>It has been stepped: what is automatic stays as it was found.</summary>
        private protected bool IsSettled { get; set; }

        internal bool Holds(Rigidbody body) => m_ConnectedBody == body || Body == body;

        internal override void OnActivated() => PhysicsWorld.Joints.Add(this);

        internal override void OnDeactivated()
        {
            PhysicsWorld.Joints.Remove(this);
            LeaveWorld();
            Body?.WakeUp();
            if (m_ConnectedBody != null)
                m_ConnectedBody.WakeUp();
        }

        internal override void OnCopied(Component source) => CopiedProperties.Into(source, this);

        void ICopiesMore.CopyInto(Component copy)
        {
            var joint = (Joint)copy;
            joint.m_Anchor = m_Anchor;
            joint.m_Axis = m_Axis;
            joint.m_ConnectedAnchor = m_ConnectedAnchor;
            joint.m_ConnectedBody = m_ConnectedBody != null ? CounterpartOf(m_ConnectedBody, joint) : null;
            CopyMore(joint);
        }

        private protected virtual void CopyMore(Joint copy) { }

        /// <summary>Before the bodies are given to Bullet.</summary>
        internal virtual void Prepare(ContactWorld world, float time)
        {
            if (Body == null || m_ConnectedBody != null && !m_ConnectedBody.Activated)
            {
                LeaveWorld();
                return;
            }
            if (solved != null && !solved.Fits(world))
                DropSolved();
            bool isNew = solved == null;
            if (!isNew && !isChanged || !Describe(axes))
                return;
            Settle();
            solved ??= new SolvedJoint(world, this, m_ConnectedAnchor);
            solved.Set(axes);
            isChanged = false;
        }

        private protected void Settle()
        {
            m_ConnectedAnchor = connectedAnchor;
            IsSettled = true;
        }

        /// <summary>Three displacements and three turns about the axes of the joint, which are zero, that is locked, as they come.</summary>
        /// <returns>Whether Bullet solves this kind of joint.</returns>
        private protected virtual bool Describe(JointAxis[] axes) => false;

        /// <summary>Marks the joint as changed: its axes are described again.</summary>
        private protected void Changed() => isChanged = true;

        /// <summary>It is made again at the next step.</summary>
        internal void LeaveWorld()
        {
            DropSolved();
            IsSettled = false;
        }

        void DropSolved()
        {
            solved?.Delete();
            solved = null;
        }

        /// <summary>After a step.</summary>
        internal void EndStep()
        {
            if (solved != null)
            {
                Angle = solved.Read(out Vector3 force, out Vector3 torque);
                currentForce = force;
                currentTorque = torque;
            }
            float pull = currentForce.magnitude, twist = currentTorque.magnitude;
            if (pull <= breakForce && twist <= breakTorque)
                return;
            Messages.Broadcast(gameObject, "OnJointBreak", pull > breakForce ? pull : twist);
            Destroy(this);
        }

        Vector3 AnchorOnOther()
        {
            Vector3 position = transform.TransformPoint(m_Anchor);
            return m_ConnectedBody != null ? m_ConnectedBody.transform.InverseTransformPoint(position) : position;
        }

        // In the copied tree the body that stands to the copy as the original's stands to it; beyond the tree the same one.
        Rigidbody CounterpartOf(Rigidbody original, Joint copy)
        {
            Transform here = transform, there = copy.transform;
            while (here != null && there != null && !original.transform.IsChildOf(here))
            {
                here = here.parent;
                there = there.parent;
            }
            if (here == null || there == null)
                return original;
            var path = new System.Collections.Generic.Stack<int>();
            for (Transform at = original.transform; at != here; at = at.parent)
                path.Push(at.GetSiblingIndex());
            foreach (int child in path)
                there = there.GetChild(child);
            return there.GetComponent<Rigidbody>();
        }
    }
}
