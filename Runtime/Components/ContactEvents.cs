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
        [SerializeField] UnityEvent<FluidContact> onEnter;

        [Tooltip("Called when a reading's impulse is as large as Hit Impulse.")]
        [SerializeField] UnityEvent<FluidContact> onHit;

        [Tooltip("Called when a collider has felt no water for 0.2 s, or has left the fluid's box.")]
        [SerializeField] UnityEvent<FluidContact> onExit;

        /// <summary>Scripts that listen.</summary>
        internal Delegates<Action<FluidContact>> Enter, Hit, Exit;

        /// <summary>Nobody listens.</summary>
        public static ContactEvents Default => new ContactEvents
        {
            hitImpulse = 1f, onEnter = new UnityEvent<FluidContact>(),
            onHit = new UnityEvent<FluidContact>(), onExit = new UnityEvent<FluidContact>()
        };

        /// <summary>N s.</summary>
        public float HitImpulse { get => hitImpulse; set => hitImpulse = value; }

        /// <summary>Whether anybody listens. Forces are read back while somebody does.</summary>
        public bool HasListeners => !Enter.IsEmpty || !Hit.IsEmpty || !Exit.IsEmpty
            || onEnter.GetPersistentEventCount() + onHit.GetPersistentEventCount() + onExit.GetPersistentEventCount() > 0;

        public void Validate(ref string problem) => Limit.Clamp("hit impulse", ref hitImpulse, 1e-6f, 1e9f, 1f, ref problem);

        /// <summary>Calls what a reading has changed.</summary>
        public void Raise(ContactChange change, in FluidContact contact)
        {
            if ((change & ContactChange.Enter) != 0)
                Listeners.Raise(onEnter, Enter, contact, contact.Collider);
            if ((change & ContactChange.Hit) != 0)
                Listeners.Raise(onHit, Hit, contact, contact.Collider);
            if ((change & ContactChange.Exit) != 0)
                Listeners.Raise(onExit, Exit, contact, contact.Collider);
        }
    }
}
