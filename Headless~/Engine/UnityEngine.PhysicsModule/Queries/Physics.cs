using UnityEngine.Headless;

namespace UnityEngine
{
    public partial class Physics
    {
        public const int IgnoreRaycastLayer = 1 << 2, DefaultRaycastLayers = ~IgnoreRaycastLayer, AllLayers = ~0;

        public static Vector3 gravity { get => PhysicsWorld.Gravity; set => PhysicsWorld.Gravity = value; }
        public static bool queriesHitTriggers { get; set; } = true;
        public static bool queriesHitBackfaces { get; set; }
        public static bool reuseCollisionCallbacks { get; set; } = true;

        /// <summary>Below it nothing bounces, m/s.</summary>
        public static float bounceThreshold { get; set; } = 2f;

        /// <summary>Threshold of new bodies, J/kg.</summary>
        public static float sleepThreshold { get; set; } = 0.005f;

        /// <summary>Transforms are taken over at steps and by SyncTransforms alone.</summary>
        public static bool autoSyncTransforms { get => false; set { if (value) throw Missing.Member("Physics.autoSyncTransforms"); } }

        /// <summary>Whether scripts hear of collisions; of triggers they do in any case.</summary>
        public static bool invokeCollisionCallbacks { get; set; } = true;

        /// <summary>Held alone.</summary>
        public static bool improvedPatchFriction { get; set; }
        public static bool interCollisionSettingsToggle { get; set; }
        public static float interCollisionDistance { get; set; }
        public static float interCollisionStiffness { get; set; }
        public static Vector3 clothGravity { get; set; } = new Vector3(0f, -9.81f, 0f);

        public static void RebuildBroadphaseRegions(Bounds worldBounds, int subdivisions) { }

        public static float defaultContactOffset { get; set; } = 0.01f;
        public static float defaultMaxAngularSpeed { get; set; } = 7f;
        public static float defaultMaxDepenetrationVelocity { get; set; } = 10f;
        public static int defaultSolverIterations { get; set; } = 6;
        public static int defaultSolverVelocityIterations { get; set; } = 1;

        public static SimulationMode simulationMode
        {
            get => (SimulationMode)PhysicsWorld.Stepped;
            set => PhysicsWorld.Stepped = (PhysicsStepping)value;
        }

        public static PhysicsScene defaultPhysicsScene => default;

        public static void Simulate(float step) => defaultPhysicsScene.Simulate(step);

        public static void SyncTransforms() => PhysicsWorld.SyncTransforms();

        public static bool GetIgnoreLayerCollision(int layer1, int layer2) => CollisionLayers.Ignores(layer1, layer2);
        public static void IgnoreLayerCollision(int layer1, int layer2) => IgnoreLayerCollision(layer1, layer2, true);
        public static void IgnoreLayerCollision(int layer1, int layer2, bool ignore) => CollisionLayers.Ignore(layer1, layer2, ignore);
        public static bool GetIgnoreCollision(Collider collider1, Collider collider2) => CollisionLayers.Ignores(collider1, collider2);
        public static void IgnoreCollision(Collider collider1, Collider collider2) => IgnoreCollision(collider1, collider2, true);

        public static void IgnoreCollision(Collider collider1, Collider collider2, bool ignore)
            => CollisionLayers.Ignore(collider1, collider2, ignore);

        /// <summary>Computes for convex shapes; false with a mesh that is not convex.</summary>
        public static bool ComputePenetration(Collider colliderA, Vector3 positionA, Quaternion rotationA, Collider colliderB, Vector3 positionB,
            Quaternion rotationB, out Vector3 direction, out float distance)
        {
            direction = Vector3.zero;
            distance = 0f;
            System.IntPtr a = colliderA.Describe().Make(), b = colliderB.Describe().Make();
            bool overlaps = a != System.IntPtr.Zero && b != System.IntPtr.Zero
                && Bullet.Penetration(a, colliderA.PoseAt(positionA, rotationA, colliderA.transform.lossyScale), b,
                    colliderB.PoseAt(positionB, rotationB, colliderB.transform.lossyScale), out direction, out distance) != 0 && distance > 0f;
            Bullet.ShapeDelete(a);
            Bullet.ShapeDelete(b);
            if (!overlaps)
            {
                direction = Vector3.zero;
                distance = 0f;
            }
            return overlaps;
        }

        /// <summary>On a convex shape; the point itself where it is inside.</summary>
        public static Vector3 ClosestPoint(Vector3 point, Collider collider, Vector3 position, Quaternion rotation)
        {
            ShapeDescription shape = collider.Describe();
            if (shape.Kind == ShapeKind.Triangles || shape.Kind == ShapeKind.None)
            {
                Debug.LogError("Physics.ClosestPoint can only be used with a BoxCollider, SphereCollider, CapsuleCollider and a convex MeshCollider.",
                    collider);
                return point;
            }
            System.IntPtr made = shape.Make();
            Vector3 closest = Bullet.Closest(made, collider.PoseAt(position, rotation, collider.transform.lossyScale), point);
            Bullet.ShapeDelete(made);
            return closest;
        }

        /// <summary>Bullet takes meshes as they are.</summary>
        public static void BakeMesh(int meshID, bool convex) { }

        /// <summary>Bullet takes meshes as they are.</summary>
        public static void BakeMesh(int meshID, bool convex, MeshColliderCookingOptions cookingOptions) { }

        internal static void Reset()
        {
            queriesHitTriggers = true;
            queriesHitBackfaces = false;
            reuseCollisionCallbacks = invokeCollisionCallbacks = true;
            bounceThreshold = 2f;
            sleepThreshold = 0.005f;
            defaultContactOffset = 0.01f;
            defaultMaxAngularSpeed = 7f;
            defaultMaxDepenetrationVelocity = 10f;
            defaultSolverIterations = 6;
            defaultSolverVelocityIterations = 1;
        }
    }

    public enum SimulationMode { FixedUpdate = 0, Update = 1, Script = 2 }
    public enum QueryTriggerInteraction { UseGlobal = 0, Ignore = 1, Collide = 2 }
}
