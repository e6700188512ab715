using UnityEngine;

namespace Rill.Tests
{
    /// <summary>Moments of inertia of a solid box of even density about its center.</summary>
    static class BoxInertia
    {
        /// <summary>Gives a body the moments of a box of its mass, about its own axes.</summary>
        /// <param name="size">Sides of the box, m.</param>
        public static void Set(Rigidbody body, Vector3 size)
        {
            body.inertiaTensor = Of(size, body.mass);
            body.inertiaTensorRotation = Quaternion.identity;
        }

        /// <summary>Moments, kg m².</summary>
        static Vector3 Of(Vector3 size, float mass)
        {
            Vector3 squares = Vector3.Scale(size, size) * (mass / 12f);
            return new Vector3(squares.y + squares.z, squares.z + squares.x, squares.x + squares.y);
        }
    }
}
