using System.Collections.Generic;

namespace UnityEngine.Headless
{
    /// <summary>The free bodies of all scenes, moved after each FixedUpdate. No contacts, no joints.</summary>
    internal static class PhysicsWorld
    {
        static readonly Vector3 DefaultGravity = new Vector3(0f, -9.81f, 0f);

        public static readonly List<Rigidbody> Bodies = new List<Rigidbody>();

        /// <summary>Physics.gravity, m/s².</summary>
        public static Vector3 Gravity = DefaultGravity;

        /// <summary>Before the scripts of a fixed step.</summary>
        public static void BeginStep()
        {
            foreach (Rigidbody body in Bodies)
                body.State.ShowBody(body.transform);
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
        }

        /// <summary>After the fixed steps of a frame.</summary>
        /// <param name="share">Of a fixed step that has passed since the last.</param>
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
            Gravity = DefaultGravity;
        }
    }
}
