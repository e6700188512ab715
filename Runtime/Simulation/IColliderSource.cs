using System.Collections.Generic;
using UnityEngine;

namespace Rill
{
    /// <summary>Finds colliders for one fluid, beside the <see cref="FluidCollider"/> components, which all fluids look through.</summary>
    interface IColliderSource
    {
        /// <summary>Those that may reach into the fluid's box, in an order that stays while they do. Called before the steps of a frame.</summary>
        /// <param name="center">Center of the box, world space, m.</param>
        /// <param name="size">m.</param>
        /// <param name="spacing">Spacing of the particles, m.</param>
        List<IFluidCollider> Gather(Vector3 center, Quaternion rotation, Vector3 size, float spacing);
    }
}
