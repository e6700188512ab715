using System;
using UnityEngine.Headless;

namespace UnityEngine
{
    /// <summary>Stands upright however its object is turned. It does not walk here: Move and SimpleMove are not there.</summary>
    public class CharacterController : Collider
    {
        public Vector3 center { get; set; }
        public float radius { get; set; } = 0.5f;
        public float height { get; set; } = 2f;
        public float slopeLimit { get; set; } = 45f;
        public float stepOffset { get; set; } = 0.3f;
        public float skinWidth { get; set; } = 0.08f;
        public float minMoveDistance { get; set; } = 0.001f;
        public bool detectCollisions { get; set; } = true;
        public bool enableOverlapRecovery { get; set; } = true;

        public Vector3 velocity => throw Missing.Member("CharacterController.velocity");
        public bool isGrounded => throw Missing.Member("CharacterController.isGrounded");
        public CollisionFlags collisionFlags => throw Missing.Member("CharacterController.collisionFlags");
        public CollisionFlags Move(Vector3 motion) => throw Missing.Member("CharacterController.Move");
        public bool SimpleMove(Vector3 speed) => throw Missing.Member("CharacterController.SimpleMove");

        private protected override Vector3 Center => center;
        private protected override bool Turns => false;

        internal override ShapeDescription Describe() => CapsuleCollider.Along(1, radius, height, AbsoluteScale);
    }

    [Flags]
    public enum CollisionFlags { None = 0, Sides = 1, CollidedSides = 1, Above = 2, CollidedAbove = 2, Below = 4, CollidedBelow = 4 }
}
