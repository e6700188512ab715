using System.Collections.Generic;

namespace UnityEngine.Headless
{
    /// <summary>When the default physics scene steps, as Unity's SimulationMode.</summary>
    internal enum PhysicsStepping { FixedUpdate, Update, Script }

    /// <summary>
    /// The bodies, colliders and joints of all scenes. A physics scene is null, the default, whose bodies move after each FixedUpdate, before
    /// each Update or at a script's call, or the scene that has it for itself. Bullet's world of a physics scene is made when something
    /// can meet in it or is asked for.
    /// </summary>
    internal static class PhysicsWorld
    {
        static readonly Vector3 DefaultGravity = new Vector3(0f, -9.81f, 0f);
        static readonly Dictionary<int, ContactWorld> contactWorlds = new Dictionary<int, ContactWorld>();

        public static readonly List<Rigidbody> Bodies = new List<Rigidbody>();
        public static readonly List<Collider> Colliders = new List<Collider>();
        public static readonly List<Joint> Joints = new List<Joint>();

        /// <summary>Changes whenever a body may have got another shape.</summary>
        public static int ShapesVersion = 1;

        /// <summary>Physics.gravity, m/s².</summary>
        public static Vector3 Gravity = DefaultGravity;

        public static PhysicsStepping Stepped;

        /// <summary>From here on the player's loop steps the physics.</summary>
        public static void Install() => PhysicsLoop.Current ??= new PhysicsTurns();

        static PhysicsWorld() => Install();

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
            foreach (Rigidbody body in Bodies)
                body.State.Follow(body.transform);
            foreach (Collider collider in Colliders)
                collider.Sync();
        }

        /// <summary>After them; at the call of a script for a physics scene that is not the default. Unity does not say whether queries of
        /// other physics scenes then find their shapes at new places: here they do not.</summary>
        public static void Step(SceneData scene, float time)
        {
            if (time <= 0f)
                return;
            List<Rigidbody> bodies = Bodies.FindAll(body => SceneOf(body.gameObject) == scene);
            foreach (Rigidbody body in bodies)
            {
                body.State.Follow(body.transform);
                body.State.Accelerate(body, time);
            }
            ContactWorld contacts = Meets(scene, bodies) ? ContactsOf(scene) : Known(scene);
            contacts?.Solve(bodies, time);
            foreach (Rigidbody body in bodies)
            {
                body.State.Move(body, time);
                body.State.IsTouched = false;
                body.State.ShowBody(body.transform);
            }
            foreach (Collider collider in Colliders)
                if (SceneOf(collider.gameObject) == scene)
                    collider.Sync();
            contacts?.Events.Tell();
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

        /// <summary>With all colliders where queries find them.</summary>
        public static ContactWorld Queried(SceneData scene)
        {
            ContactWorld contacts = ContactsOf(scene);
            contacts.Sync();
            return contacts;
        }

        /// <summary>A body is gone: its colliders stand alone from the next step on.</summary>
        public static void Remove(Rigidbody body)
        {
            foreach (ContactWorld contacts in contactWorlds.Values)
                contacts.Remove(body);
        }

        public static IEnumerable<ContactWorld> ContactWorlds => contactWorlds.Values;

        public static void Reset()
        {
            foreach (ContactWorld contacts in contactWorlds.Values)
                contacts.Dispose();
            contactWorlds.Clear();
            Bodies.Clear();
            Colliders.Clear();
            Joints.Clear();
            Gravity = DefaultGravity;
            Stepped = PhysicsStepping.FixedUpdate;
            CollisionLayers.Reset();
            Physics.Reset();
        }

        static bool Meets(SceneData scene, List<Rigidbody> bodies) => bodies.Count > 0
            && (Colliders.Exists(collider => SceneOf(collider.gameObject) == scene) || Joints.Exists(joint => SceneOf(joint.gameObject) == scene));

        static ContactWorld Known(SceneData scene) => contactWorlds.TryGetValue(scene?.Handle ?? 0, out ContactWorld known) ? known : null;

        static ContactWorld ContactsOf(SceneData scene)
        {
            if (Known(scene) is ContactWorld known)
                return known;
            var made = new ContactWorld(scene);
            contactWorlds.Add(scene?.Handle ?? 0, made);
            return made;
        }
    }
}
