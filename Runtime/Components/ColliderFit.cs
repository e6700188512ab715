using System;
using UnityEngine;

namespace Rill
{
    /// <summary>Fits a new Fluid Collider to what its object has already.</summary>
    static class ColliderFit
    {
        [KeptBetweenPlays] static Func<FluidCollider, bool> fitToPhysics;

        /// <summary>Fits to a collider of the physics, and tells whether there was one. Null in a player, and without the physics module.</summary>
        internal static Func<FluidCollider, bool> FitToPhysics { get => fitToPhysics; set => fitToPhysics = value; }

        /// <summary>Fits to the object's collider of the physics, or else to its mesh; leaves all as it is where there is neither.</summary>
        public static void Fit(FluidCollider collider)
        {
            if (fitToPhysics != null && fitToPhysics(collider))
                return;
            if (collider.TryGetComponent(out MeshFilter filter) && filter.sharedMesh != null)
                FitToMesh(collider, filter.sharedMesh);
        }

        // Unity's own sphere and capsule are round; of anything else the box around it.
        static void FitToMesh(FluidCollider collider, Mesh mesh)
        {
            Bounds bounds = mesh.bounds;
            collider.Center = bounds.center;
            collider.Size = bounds.size;
            collider.Radius = bounds.extents.x;
            collider.Height = bounds.size.y;
            collider.Shape = mesh.name == "Sphere" ? ColliderShape.Sphere : mesh.name == "Capsule" ? ColliderShape.Capsule : ColliderShape.Box;
        }
    }
}
