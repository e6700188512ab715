using System;
using UnityEngine;
using UnityEngine.Events;

namespace Rill
{
    /// <summary>When a fluid's contacts with colliders are told, and to whom.</summary>
    [Serializable]
    struct ContactEvents
    {
        [Tooltip("Impulse of one reading from which it is a hit, N s. 0.000001 to 1e9. The next can come below half of it.")]
        [SerializeField] float hitImpulse;

        [Tooltip("Called when water comes to a collider.")]
        [SerializeField] UnityEvent<FluidContact> touched;

        [Tooltip("Called when a reading's impulse is as large as Hit Impulse.")]
        [SerializeField] UnityEvent<FluidContact> hit;

        [Tooltip("Called when a collider has felt no water for 0.2 s, or has left the fluid's box.")]
        [SerializeField] UnityEvent<FluidContact> left;

        /// <summary>Of scripts.</summary>
        internal Action<FluidContact> Touched, Hit, Left;

        /// <summary>Nobody listens.</summary>
        public static ContactEvents Default => new ContactEvents
        {
            hitImpulse = 1f, touched = new UnityEvent<FluidContact>(),
            hit = new UnityEvent<FluidContact>(), left = new UnityEvent<FluidContact>()
        };

        /// <summary>N s.</summary>
        public float HitImpulse { get => hitImpulse; set => hitImpulse = value; }

        /// <summary>Whether anybody listens. Forces are read back while somebody does.</summary>
        public bool HasListeners => Touched != null || Hit != null || Left != null
            || touched.GetPersistentEventCount() + hit.GetPersistentEventCount() + left.GetPersistentEventCount() > 0;

        public void Validate(ref string problem) => Limit.Clamp("hit impulse", ref hitImpulse, 1e-6f, 1e9f, 1f, ref problem);

        /// <summary>Calls what a reading has changed.</summary>
        public void Raise(ContactChange change, in FluidContact contact)
        {
            if ((change & ContactChange.Touched) != 0)
                Raise(touched, Touched, contact);
            if ((change & ContactChange.Hit) != 0)
                Raise(hit, Hit, contact);
            if ((change & ContactChange.Left) != 0)
                Raise(left, Left, contact);
        }

        static void Raise(UnityEvent<FluidContact> listeners, Action<FluidContact> scripts, in FluidContact contact)
        {
            Listeners.Tell(listeners, contact, contact.Collider);
            Listeners.Tell(scripts, contact, contact.Collider);
        }
    }
}
