using UnityEngine.Headless;

namespace UnityEngine
{
    /// <summary>
    /// What the host has of it. In an assembly of its own, for the package alone: scripts of other projects find the stub with all members
    /// of Unity's, whose gravity is this one, and which throws for the rest.
    /// </summary>
    public class Physics
    {
        public static Vector3 gravity { get => PhysicsWorld.Gravity; set => PhysicsWorld.Gravity = value; }
        public static bool queriesHitTriggers { get; set; } = true;

        public static void SyncTransforms() => PhysicsWorld.SyncTransforms();

        /// <returns>How many of the results are of this call; what does not fit is left out.</returns>
        public static int OverlapBoxNonAlloc(Vector3 center, Vector3 halfExtents, Collider[] results, Quaternion orientation, int mask,
            QueryTriggerInteraction queryTriggerInteraction)
        {
            bool hitsTriggers = queryTriggerInteraction == QueryTriggerInteraction.Collide
                || queryTriggerInteraction == QueryTriggerInteraction.UseGlobal && queriesHitTriggers;
            int count = 0;
            foreach (PhysicsShape shape in PhysicsWorld.Shapes)
            {
                Collider collider = ((QueriedShape)shape).Owner;
                if (count == results.Length)
                    break;
                if ((mask & 1 << collider.gameObject.layer) == 0 || collider.isTrigger && !hitsTriggers
                    || !collider.Overlaps(center, halfExtents, orientation))
                    continue;
                results[count++] = collider;
            }
            return count;
        }
    }

    public enum QueryTriggerInteraction { UseGlobal = 0, Ignore = 1, Collide = 2 }
}
