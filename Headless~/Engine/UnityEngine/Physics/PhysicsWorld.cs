using System.Collections.Generic;

namespace UnityEngine.Headless
{
    /// <summary>What a collider is to the physics. The collider lies in an assembly of its own.</summary>
    internal abstract class PhysicsShape
    {
        /// <summary>Whose scene decides in which physics scene it is.</summary>
        public abstract GameObject Object { get; }

        /// <summary>Queries find it where its object is now.</summary>
        public abstract void Sync();
    }

    /// <summary>When the default physics scene steps, as Unity's SimulationMode.</summary>
    internal enum PhysicsStepping { FixedUpdate, Update, Script }

    /// <summary>
    /// The free bodies and the shapes of all scenes. No contacts, no joints. A physics scene is null, the default, whose bodies move after
    /// each FixedUpdate, before each Update or at a script's call, or the scene that has it for itself.
    /// </summary>
    internal static class PhysicsWorld
    {
        static readonly Vector3 DefaultGravity = new Vector3(0f, -9.81f, 0f);

        public static readonly List<Rigidbody> Bodies = new List<Rigidbody>();

        /// <summary>What can be found by queries.</summary>
        public static readonly List<PhysicsShape> Shapes = new List<PhysicsShape>();

        /// <summary>Physics.gravity, m/s².</summary>
        public static Vector3 Gravity = DefaultGravity;

        public static PhysicsStepping Stepped;

        /// <summary>The physics scene of an object: null for the default.</summary>
        public static SceneData SceneOf(GameObject gameObject) => SceneOf(gameObject.SceneOf);

        /// <summary>The physics scene of a scene: null for the default.</summary>
        public static SceneData SceneOf(SceneData scene) => scene != null && scene.HasLocalPhysics ? scene : null;

        /// <summary>Before the scripts of a fixed step.</summary>
        public static void BeginStep()
        {
            foreach (Rigidbody body in Bodies)
                if (SceneOf(body.gameObject) == null)
                    body.State.ShowBody(body.transform);
        }

        /// <summary>Queries of every physics scene find shapes where their objects are now.</summary>
        public static void SyncTransforms()
        {
            foreach (PhysicsShape shape in Shapes)
                shape.Sync();
        }

        /// <summary>After them; at the call of a script for a physics scene that is not the default. Unity does not say whether queries of
        /// other physics scenes then find their shapes at new places: here they do not.</summary>
        public static void Step(SceneData scene, float time)
        {
            foreach (Rigidbody body in Bodies)
            {
                if (SceneOf(body.gameObject) != scene)
                    continue;
                body.State.Follow(body.transform);
                body.State.Step(body, time);
                body.State.ShowBody(body.transform);
            }
            foreach (PhysicsShape shape in Shapes)
                if (SceneOf(shape.Object) == scene)
                    shape.Sync();
        }

        /// <summary>After the fixed steps of a frame.</summary>
        /// <param name="fraction">Of a fixed step that has passed since the last.</param>
        public static void Show(float fraction)
        {
            foreach (Rigidbody body in Bodies)
            {
                if (SceneOf(body.gameObject) != null)
                    continue;
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
            Stepped = PhysicsStepping.FixedUpdate;
        }
    }
}
