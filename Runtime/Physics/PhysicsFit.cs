using UnityEngine;

namespace Rill
{
    /// <summary>Fits a Fluid Collider to the collider of the physics on its object.</summary>
    static class PhysicsFit
    {
        /// <returns>Whether there was one that a Fluid Collider can be fitted to.</returns>
        public static bool Fit(FluidCollider collider)
        {
            if (!collider.TryGetComponent(out Collider own))
                return false;
            switch (own)
            {
                case BoxCollider box:
                    collider.Shape = ColliderShape.Box;
                    collider.Center = box.center;
                    collider.Size = box.size;
                    return true;
                case SphereCollider sphere:
                    collider.Shape = ColliderShape.Sphere;
                    collider.Center = sphere.center;
                    collider.Radius = sphere.radius;
                    return true;
                case CapsuleCollider capsule when capsule.direction == 1:
                    return FitCapsule(collider, capsule.center, capsule.radius, capsule.height);
                case CharacterController character:
                    return FitCapsule(collider, character.center, character.radius, character.height);
                case MeshCollider _:
                    collider.Shape = ColliderShape.Mesh;        // whose field is to be baked
                    return true;
                default:
                    return false;
            }
        }

        static bool FitCapsule(FluidCollider collider, Vector3 center, float radius, float height)
        {
            collider.Shape = ColliderShape.Capsule;
            collider.Center = center;
            collider.Radius = radius;
            collider.Height = height;
            return true;
        }
    }
}
