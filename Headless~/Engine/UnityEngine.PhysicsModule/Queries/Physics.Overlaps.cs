using UnityEngine.Headless;

namespace UnityEngine
{
    // Standing shapes. Every shorter overload calls the longest.
    public partial class Physics
    {
        public static Collider[] OverlapBox(Vector3 center, Vector3 halfExtents)
            => OverlapBox(center, halfExtents, Quaternion.identity, AllLayers, QueryTriggerInteraction.UseGlobal);
        public static Collider[] OverlapBox(Vector3 center, Vector3 halfExtents, Quaternion orientation)
            => OverlapBox(center, halfExtents, orientation, AllLayers, QueryTriggerInteraction.UseGlobal);
        public static Collider[] OverlapBox(Vector3 center, Vector3 halfExtents, Quaternion orientation, int layerMask)
            => OverlapBox(center, halfExtents, orientation, layerMask, QueryTriggerInteraction.UseGlobal);
        public static Collider[] OverlapBox(Vector3 center, Vector3 halfExtents, Quaternion orientation, int layerMask,
            QueryTriggerInteraction queryTriggerInteraction)
            => defaultPhysicsScene.Overlaps(Casts.Box(halfExtents), new BodyPose(center, orientation), layerMask,
                queryTriggerInteraction).ToArray();

        public static int OverlapBoxNonAlloc(Vector3 center, Vector3 halfExtents, Collider[] results)
            => OverlapBoxNonAlloc(center, halfExtents, results, Quaternion.identity, AllLayers, QueryTriggerInteraction.UseGlobal);
        public static int OverlapBoxNonAlloc(Vector3 center, Vector3 halfExtents, Collider[] results, Quaternion orientation)
            => OverlapBoxNonAlloc(center, halfExtents, results, orientation, AllLayers, QueryTriggerInteraction.UseGlobal);
        public static int OverlapBoxNonAlloc(Vector3 center, Vector3 halfExtents, Collider[] results, Quaternion orientation, int mask)
            => OverlapBoxNonAlloc(center, halfExtents, results, orientation, mask, QueryTriggerInteraction.UseGlobal);
        public static int OverlapBoxNonAlloc(Vector3 center, Vector3 halfExtents, Collider[] results, Quaternion orientation, int mask,
            QueryTriggerInteraction queryTriggerInteraction)
            => defaultPhysicsScene.OverlapBox(center, halfExtents, results, orientation, mask, queryTriggerInteraction);

        public static Collider[] OverlapSphere(Vector3 position, float radius)
            => OverlapSphere(position, radius, AllLayers, QueryTriggerInteraction.UseGlobal);
        public static Collider[] OverlapSphere(Vector3 position, float radius, int layerMask)
            => OverlapSphere(position, radius, layerMask, QueryTriggerInteraction.UseGlobal);
        public static Collider[] OverlapSphere(Vector3 position, float radius, int layerMask,
            QueryTriggerInteraction queryTriggerInteraction)
            => defaultPhysicsScene.Overlaps(Casts.Sphere(radius), new BodyPose(position, Quaternion.identity), layerMask,
                queryTriggerInteraction).ToArray();

        public static int OverlapSphereNonAlloc(Vector3 position, float radius, Collider[] results)
            => OverlapSphereNonAlloc(position, radius, results, AllLayers, QueryTriggerInteraction.UseGlobal);
        public static int OverlapSphereNonAlloc(Vector3 position, float radius, Collider[] results, int layerMask)
            => OverlapSphereNonAlloc(position, radius, results, layerMask, QueryTriggerInteraction.UseGlobal);
        public static int OverlapSphereNonAlloc(Vector3 position, float radius, Collider[] results, int layerMask,
            QueryTriggerInteraction queryTriggerInteraction)
            => defaultPhysicsScene.OverlapSphere(position, radius, results, layerMask, queryTriggerInteraction);

        public static Collider[] OverlapCapsule(Vector3 point0, Vector3 point1, float radius)
            => OverlapCapsule(point0, point1, radius, AllLayers, QueryTriggerInteraction.UseGlobal);
        public static Collider[] OverlapCapsule(Vector3 point0, Vector3 point1, float radius, int layerMask)
            => OverlapCapsule(point0, point1, radius, layerMask, QueryTriggerInteraction.UseGlobal);
        public static Collider[] OverlapCapsule(Vector3 point0, Vector3 point1, float radius, int layerMask,
            QueryTriggerInteraction queryTriggerInteraction)
            => defaultPhysicsScene.Overlaps(Casts.Capsule(point0, point1, radius, out BodyPose pose), pose, layerMask,
                queryTriggerInteraction).ToArray();

        public static int OverlapCapsuleNonAlloc(Vector3 point0, Vector3 point1, float radius, Collider[] results)
            => OverlapCapsuleNonAlloc(point0, point1, radius, results, AllLayers, QueryTriggerInteraction.UseGlobal);
        public static int OverlapCapsuleNonAlloc(Vector3 point0, Vector3 point1, float radius, Collider[] results, int layerMask)
            => OverlapCapsuleNonAlloc(point0, point1, radius, results, layerMask, QueryTriggerInteraction.UseGlobal);
        public static int OverlapCapsuleNonAlloc(Vector3 point0, Vector3 point1, float radius, Collider[] results, int layerMask,
            QueryTriggerInteraction queryTriggerInteraction)
            => defaultPhysicsScene.OverlapCapsule(point0, point1, radius, results, layerMask, queryTriggerInteraction);

        public static bool CheckBox(Vector3 center, Vector3 halfExtents)
            => CheckBox(center, halfExtents, Quaternion.identity, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static bool CheckBox(Vector3 center, Vector3 halfExtents, Quaternion orientation)
            => CheckBox(center, halfExtents, orientation, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static bool CheckBox(Vector3 center, Vector3 halfExtents, Quaternion orientation, int layerMask)
            => CheckBox(center, halfExtents, orientation, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static bool CheckBox(Vector3 center, Vector3 halfExtents, Quaternion orientation, int layermask,
            QueryTriggerInteraction queryTriggerInteraction)
            => defaultPhysicsScene.Overlaps(Casts.Box(halfExtents), new BodyPose(center, orientation), layermask,
                queryTriggerInteraction).Count > 0;

        public static bool CheckSphere(Vector3 position, float radius)
            => CheckSphere(position, radius, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static bool CheckSphere(Vector3 position, float radius, int layerMask)
            => CheckSphere(position, radius, layerMask, QueryTriggerInteraction.UseGlobal);
        public static bool CheckSphere(Vector3 position, float radius, int layerMask, QueryTriggerInteraction queryTriggerInteraction)
            => defaultPhysicsScene.Overlaps(Casts.Sphere(radius), new BodyPose(position, Quaternion.identity), layerMask,
                queryTriggerInteraction).Count > 0;

        public static bool CheckCapsule(Vector3 start, Vector3 end, float radius)
            => CheckCapsule(start, end, radius, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static bool CheckCapsule(Vector3 start, Vector3 end, float radius, int layerMask)
            => CheckCapsule(start, end, radius, layerMask, QueryTriggerInteraction.UseGlobal);
        public static bool CheckCapsule(Vector3 start, Vector3 end, float radius, int layerMask,
            QueryTriggerInteraction queryTriggerInteraction)
            => defaultPhysicsScene.Overlaps(Casts.Capsule(start, end, radius, out BodyPose pose), pose, layerMask,
                queryTriggerInteraction).Count > 0;
    }
}
