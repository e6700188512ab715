using System.Collections.Generic;

namespace UnityEngine.Headless
{
    /// <summary>What a collider is to the physics. The collider lies in an assembly of its own.</summary>
    internal abstract class PhysicsShape
    {
        /// <summary>Queries find it where its object is now.</summary>
        public abstract void Sync();
    }

    /// <summary>The free bodies of all scenes, moved after each FixedUpdate. No contacts, no joints.</summary>
    internal static class PhysicsWorld
    {
        static readonly Vector3 DefaultGravity = new Vector3(0f, -9.81f, 0f);

        public static readonly List<Rigidbody> Bodies = new List<Rigidbody>();

        /// <summary>What can be found by queries.</summary>
        public static readonly List<PhysicsShape> Shapes = new List<PhysicsShape>();

        /// <summary>Physics.gravity, m/s².</summary>
        public static Vector3 Gravity = DefaultGravity;

        /// <summary>Before the scripts of a fixed step.</summary>
        public static void BeginStep()
        {
            foreach (Rigidbody body in Bodies)
                body.State.ShowBody(body.transform);
        }

        /// <summary>Queries find shapes where their objects are now.</summary>
        public static void SyncTransforms()
        {
            foreach (PhysicsShape shape in Shapes)
                shape.Sync();
        }

        /// <summary>After them.</summary>
        public static void Step(float time)
        {
            foreach (Rigidbody body in Bodies)
            {
                body.State.Follow(body.transform);
                body.State.Step(body, time);
                body.State.ShowBody(body.transform);
            }
            SyncTransforms();
        }

        /// <summary>After the fixed steps of a frame.</summary>
        /// <param name="fraction">Of a fixed step that has passed since the last.</param>
        public static void Show(float fraction)
        {
            foreach (Rigidbody body in Bodies)
            {
                body.State.Follow(body.transform);
                if (body.interpolation == RigidbodyInterpolation.Interpolate)
                    body.State.ShowBetween(body.transform, fraction);
            }
        }

        public static void Reset()
        {
            Bodies.Clear();
            Shapes.Clear();
            Gravity = DefaultGravity;
        }
    }
}
