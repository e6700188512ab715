using UnityEngine.Headless;

namespace UnityEngine
{
    /// <summary>
    /// What the host has of it. In an assembly of its own, for the package alone: scripts of other projects find the stub with all members
    /// of Unity's, whose gravity is this one, and which throws for the rest.
    /// </summary>
    public class Physics
    {
        public const int IgnoreRaycastLayer = 1 << 2, DefaultRaycastLayers = ~IgnoreRaycastLayer, AllLayers = ~0;

        public static Vector3 gravity { get => PhysicsWorld.Gravity; set => PhysicsWorld.Gravity = value; }
        public static bool queriesHitTriggers { get; set; } = true;

        public static SimulationMode simulationMode
        {
            get => (SimulationMode)PhysicsWorld.Stepped;
            set => PhysicsWorld.Stepped = (PhysicsStepping)value;
        }

        public static void Simulate(float step) => defaultPhysicsScene.Simulate(step);

        public static void SyncTransforms() => PhysicsWorld.SyncTransforms();

        public static PhysicsScene defaultPhysicsScene => default;

        /// <summary>In the default physics scene.</summary>
        /// <returns>How many of the results are of this call; what does not fit is left out.</returns>
        public static int OverlapBoxNonAlloc(Vector3 center, Vector3 halfExtents, Collider[] results, Quaternion orientation, int mask,
            QueryTriggerInteraction queryTriggerInteraction)
            => defaultPhysicsScene.OverlapBox(center, halfExtents, results, orientation, mask, queryTriggerInteraction);
    }

    public enum SimulationMode { FixedUpdate = 0, Update = 1, Script = 2 }
    public enum QueryTriggerInteraction { UseGlobal = 0, Ignore = 1, Collide = 2 }
}
