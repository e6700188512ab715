using System;
using System.Collections.Generic;
using UnityEngine.Headless;

namespace UnityEngine
{
    // Mass, its center and the inertia of a body: set by hand or found from its colliders, as Unity does.
    public partial class Rigidbody : ICopiesMore
    {
        const float DefaultInertia = 1f;        // kg m², of a body without a shape, as Unity has it

        [NonSerialized] Vector3 m_CenterOfMass, m_InertiaTensor = Vector3.one * DefaultInertia;
        [NonSerialized] Quaternion m_InertiaRotation = Quaternion.identity;
        [NonSerialized] bool m_AutomaticCenter = true, m_AutomaticTensor = true;
        [NonSerialized] int massVersion;        // of the shapes that the mass was found from; 0 for none

        public Vector3 centerOfMass
        {
            get
            {
                FindMass();
                return m_CenterOfMass;
            }
            set
            {
                FindMass();
                m_CenterOfMass = value;
                m_AutomaticCenter = false;
                massVersion = 0;
            }
        }

        public bool automaticCenterOfMass
        {
            get => m_AutomaticCenter;
            set
            {
                m_AutomaticCenter = value;
                massVersion = 0;
            }
        }

        public Vector3 worldCenterOfMass => position + rotation * centerOfMass;

        public Quaternion inertiaTensorRotation
        {
            get
            {
                FindMass();
                return m_InertiaRotation;
            }
            set
            {
                FindMass();
                m_InertiaRotation = value;
                m_AutomaticTensor = false;
            }
        }

        /// <summary>Automatic: that of the body's colliders, all of one density. Of a body without any it is that of a box around its object's
        /// mesh, or 1 without a mesh.</summary>
        public Vector3 inertiaTensor
        {
            get
            {
                FindMass();
                return m_InertiaTensor;
            }
            set
            {
                FindMass();
                m_InertiaTensor = value;
                m_AutomaticTensor = false;
            }
        }

        public bool automaticInertiaTensor
        {
            get => m_AutomaticTensor;
            set
            {
                m_AutomaticTensor = value;
                massVersion = 0;
            }
        }

        public void ResetCenterOfMass() => automaticCenterOfMass = true;

        public void ResetInertiaTensor() => automaticInertiaTensor = true;

        /// <summary>Sets the mass by the volume of the body's colliders, kg/m³.</summary>
        public void SetDensity(float density)
        {
            MassParts parts = Parts();
            if (parts.Volume > 0f)
                mass = parts.Volume * density;
        }

        void ICopiesMore.CopyInto(Component copy)
        {
            var body = (Rigidbody)copy;
            body.m_Mass = m_Mass;
            body.m_CenterOfMass = m_CenterOfMass;
            body.m_AutomaticCenter = m_AutomaticCenter;
            body.m_InertiaTensor = m_InertiaTensor;
            body.m_InertiaRotation = m_InertiaRotation;
            body.m_AutomaticTensor = m_AutomaticTensor;
        }

        void FindMass()
        {
            if (massVersion == PhysicsWorld.ShapesVersion)
                return;
            massVersion = PhysicsWorld.ShapesVersion;
            if (!m_AutomaticCenter && !m_AutomaticTensor)
                return;
            MassParts parts = Parts();
            if (m_AutomaticCenter)
                m_CenterOfMass = parts.Center;
            if (!m_AutomaticTensor)
                return;
            m_InertiaRotation = Quaternion.identity;
            m_InertiaTensor = Vector3.one * DefaultInertia;
            if (parts.Volume > 0f)
                parts.FindTensor(m_Mass, m_CenterOfMass, out m_InertiaTensor, out m_InertiaRotation);
            else if (TryGetComponent(out MeshFilter filter) && filter.sharedMesh != null)
                m_InertiaTensor = MassParts.BoxTensor(Vector3.Scale(filter.sharedMesh.bounds.size, transform.lossyScale)) * m_Mass;
        }

        MassParts Parts()
        {
            var parts = new MassParts();
            var colliders = new List<Collider>();
            GetComponentsInChildren(colliders);
            foreach (Collider collider in colliders)
                if (collider.enabled && !collider.isTrigger && collider.attachedRigidbody == this)
                    parts.Add(collider.Describe(), collider.PoseIn(transform));
            return parts;
        }
    }
}
