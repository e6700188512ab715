using System;
using UnityEngine;

namespace Rill
{
    /// <summary>The ground that a collider of the physics stands for, where it needs more of Unity than the physics module: see
    /// <see cref="ColliderGround"/>.</summary>
    interface IColliderGround : IDisposable
    {
        /// <summary>The heights as they are now, from the object's position.</summary>
        /// <param name="problem">Why there are none; null where there are.</param>
        HeightField GetHeights(out string problem);

        /// <summary>Parts that are left out of the heights; null for none.</summary>
        string LeftOut { get; }
    }

    /// <summary>Finds the ground that a collider stands for.</summary>
    static class ColliderGround
    {
        [KeptBetweenPlays] static Func<Collider, IColliderGround> find;

        /// <summary>Set where Unity's modules of terrain and its physics are there; gives null for a collider that is none. Null
        /// elsewhere.</summary>
        internal static Func<Collider, IColliderGround> Find { get => find; set => find = value; }

        /// <summary>Null for a collider that stands for no ground.</summary>
        public static IColliderGround Of(Collider collider) => find?.Invoke(collider);
    }
}
