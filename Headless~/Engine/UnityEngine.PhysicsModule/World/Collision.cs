using System;
using System.Collections.Generic;

namespace UnityEngine
{
    /// <summary>Contact as a script gets it: the other collider, seen from its own.</summary>
    public class Collision
    {
        readonly ContactPoint[] points;

        public Collision() => points = Array.Empty<ContactPoint>();

        internal Collision(Collider other, ContactPoint[] points, Vector3 impulse, Vector3 relativeVelocity)
        {
            collider = other;
            this.points = points;
            this.impulse = impulse;
            this.relativeVelocity = relativeVelocity;
        }

        public Collider collider { get; }

        /// <summary>N s; what the contact's points gave to this side in the step, without friction.</summary>
        public Vector3 impulse { get; }

        /// <summary>Velocity of the other against this before the contact, m/s.</summary>
        public Vector3 relativeVelocity { get; }

        public Rigidbody rigidbody => collider != null ? collider.attachedRigidbody : null;
        public Component body => rigidbody;
        public Transform transform => rigidbody != null ? rigidbody.transform : collider.transform;
        public GameObject gameObject => transform.gameObject;
        public int contactCount => points.Length;
        public ContactPoint[] contacts => (ContactPoint[])points.Clone();
        public ContactPoint GetContact(int index) => index >= 0 && index < points.Length ? points[index]
            : throw new ArgumentOutOfRangeException($"Cannot get contact at index {index}. There are {points.Length} contact(s).");

        public int GetContacts(ContactPoint[] contacts)
        {
            int count = Math.Min(contacts.Length, points.Length);
            Array.Copy(points, contacts, count);
            return count;
        }

        public int GetContacts(List<ContactPoint> contacts)
        {
            contacts.Clear();
            contacts.AddRange(points);
            return points.Length;
        }
    }

    public struct ContactPoint
    {
        internal ContactPoint(Collider thisCollider, Collider otherCollider, Vector3 point, Vector3 normal, float separation, Vector3 impulse)
        {
            this.thisCollider = thisCollider;
            this.otherCollider = otherCollider;
            this.point = point;
            this.normal = normal;
            this.separation = separation;
            this.impulse = impulse;
        }

        public Vector3 point { get; }
        public Vector3 normal { get; }
        public Vector3 impulse { get; }
        public float separation { get; }
        public Collider thisCollider { get; }
        public Collider otherCollider { get; }
    }
}
