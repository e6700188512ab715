using UnityEngine.Headless;

namespace UnityEngine
{
    // Moved shapes. Every shorter overload calls the longest.
    public partial class Physics
    {
        public static bool BoxCast(Vector3 center, Vector3 halfExtents, Vector3 direction)
            => BoxCast(center, halfExtents, direction, Quaternion.identity, Mathf.Infinity, DefaultRaycastLayers,
                QueryTriggerInteraction.UseGlobal);
        public static bool BoxCast(Vector3 center, Vector3 halfExtents, Vector3 direction, Quaternion orientation)
            => BoxCast(center, halfExtents, direction, orientation, Mathf.Infinity, DefaultRaycastLayers,
                QueryTriggerInteraction.UseGlobal);
        public static bool BoxCast(Vector3 center, Vector3 halfExtents, Vector3 direction, Quaternion orientation, float maxDistance)
            => BoxCast(center, halfExtents, direction, orientation, maxDistance, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static bool BoxCast(Vector3 center, Vector3 halfExtents, Vector3 direction, Quaternion orientation, float maxDistance,
            int layerMask)
            => BoxCast(center, halfExtents, direction, orientation, maxDistance, layerMask, QueryTriggerInteraction.UseGlobal);
        public static bool BoxCast(Vector3 center, Vector3 halfExtents, Vector3 direction, Quaternion orientation, float maxDistance,
            int layerMask, QueryTriggerInteraction queryTriggerInteraction)
            => defaultPhysicsScene.BoxCast(center, halfExtents, direction, out _, orientation, maxDistance, layerMask,
                queryTriggerInteraction);
        public static bool BoxCast(Vector3 center, Vector3 halfExtents, Vector3 direction, out RaycastHit hitInfo)
            => BoxCast(center, halfExtents, direction, out hitInfo, Quaternion.identity, Mathf.Infinity, DefaultRaycastLayers,
                QueryTriggerInteraction.UseGlobal);
        public static bool BoxCast(Vector3 center, Vector3 halfExtents, Vector3 direction, out RaycastHit hitInfo, Quaternion orientation)
            => BoxCast(center, halfExtents, direction, out hitInfo, orientation, Mathf.Infinity, DefaultRaycastLayers,
                QueryTriggerInteraction.UseGlobal);
        public static bool BoxCast(Vector3 center, Vector3 halfExtents, Vector3 direction, out RaycastHit hitInfo, Quaternion orientation,
            float maxDistance)
            => BoxCast(center, halfExtents, direction, out hitInfo, orientation, maxDistance, DefaultRaycastLayers,
                QueryTriggerInteraction.UseGlobal);
        public static bool BoxCast(Vector3 center, Vector3 halfExtents, Vector3 direction, out RaycastHit hitInfo, Quaternion orientation,
            float maxDistance, int layerMask)
            => BoxCast(center, halfExtents, direction, out hitInfo, orientation, maxDistance, layerMask, QueryTriggerInteraction.UseGlobal);
        public static bool BoxCast(Vector3 center, Vector3 halfExtents, Vector3 direction, out RaycastHit hitInfo, Quaternion orientation,
            float maxDistance, int layerMask, QueryTriggerInteraction queryTriggerInteraction)
            => defaultPhysicsScene.BoxCast(center, halfExtents, direction, out hitInfo, orientation, maxDistance, layerMask,
                queryTriggerInteraction);

        public static RaycastHit[] BoxCastAll(Vector3 center, Vector3 halfExtents, Vector3 direction)
            => BoxCastAll(center, halfExtents, direction, Quaternion.identity, Mathf.Infinity, DefaultRaycastLayers,
                QueryTriggerInteraction.UseGlobal);
        public static RaycastHit[] BoxCastAll(Vector3 center, Vector3 halfExtents, Vector3 direction, Quaternion orientation)
            => BoxCastAll(center, halfExtents, direction, orientation, Mathf.Infinity, DefaultRaycastLayers,
                QueryTriggerInteraction.UseGlobal);
        public static RaycastHit[] BoxCastAll(Vector3 center, Vector3 halfExtents, Vector3 direction, Quaternion orientation,
            float maxDistance)
            => BoxCastAll(center, halfExtents, direction, orientation, maxDistance, DefaultRaycastLayers,
                QueryTriggerInteraction.UseGlobal);
        public static RaycastHit[] BoxCastAll(Vector3 center, Vector3 halfExtents, Vector3 direction, Quaternion orientation,
            float maxDistance, int layerMask)
            => BoxCastAll(center, halfExtents, direction, orientation, maxDistance, layerMask, QueryTriggerInteraction.UseGlobal);
        public static RaycastHit[] BoxCastAll(Vector3 center, Vector3 halfExtents, Vector3 direction, Quaternion orientation,
            float maxDistance, int layerMask, QueryTriggerInteraction queryTriggerInteraction)
            => defaultPhysicsScene.Sweeps(Casts.Box(halfExtents), new BodyPose(center, orientation), direction, maxDistance, layerMask,
                queryTriggerInteraction).ToArray();

        public static int BoxCastNonAlloc(Vector3 center, Vector3 halfExtents, Vector3 direction, RaycastHit[] results)
            => BoxCastNonAlloc(center, halfExtents, direction, results, Quaternion.identity, Mathf.Infinity, DefaultRaycastLayers,
                QueryTriggerInteraction.UseGlobal);
        public static int BoxCastNonAlloc(Vector3 center, Vector3 halfExtents, Vector3 direction, RaycastHit[] results,
            Quaternion orientation)
            => BoxCastNonAlloc(center, halfExtents, direction, results, orientation, Mathf.Infinity, DefaultRaycastLayers,
                QueryTriggerInteraction.UseGlobal);
        public static int BoxCastNonAlloc(Vector3 center, Vector3 halfExtents, Vector3 direction, RaycastHit[] results,
            Quaternion orientation, float maxDistance)
            => BoxCastNonAlloc(center, halfExtents, direction, results, orientation, maxDistance, DefaultRaycastLayers,
                QueryTriggerInteraction.UseGlobal);
        public static int BoxCastNonAlloc(Vector3 center, Vector3 halfExtents, Vector3 direction, RaycastHit[] results,
            Quaternion orientation, float maxDistance, int layerMask)
            => BoxCastNonAlloc(center, halfExtents, direction, results, orientation, maxDistance, layerMask,
                QueryTriggerInteraction.UseGlobal);
        public static int BoxCastNonAlloc(Vector3 center, Vector3 halfExtents, Vector3 direction, RaycastHit[] results,
            Quaternion orientation, float maxDistance, int layerMask, QueryTriggerInteraction queryTriggerInteraction)
            => defaultPhysicsScene.BoxCast(center, halfExtents, direction, results, orientation, maxDistance, layerMask,
                queryTriggerInteraction);

        public static bool SphereCast(Vector3 origin, float radius, Vector3 direction, out RaycastHit hitInfo)
            => SphereCast(origin, radius, direction, out hitInfo, Mathf.Infinity, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static bool SphereCast(Vector3 origin, float radius, Vector3 direction, out RaycastHit hitInfo, float maxDistance)
            => SphereCast(origin, radius, direction, out hitInfo, maxDistance, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static bool SphereCast(Vector3 origin, float radius, Vector3 direction, out RaycastHit hitInfo, float maxDistance,
            int layerMask)
            => SphereCast(origin, radius, direction, out hitInfo, maxDistance, layerMask, QueryTriggerInteraction.UseGlobal);
        public static bool SphereCast(Vector3 origin, float radius, Vector3 direction, out RaycastHit hitInfo, float maxDistance,
            int layerMask, QueryTriggerInteraction queryTriggerInteraction)
            => defaultPhysicsScene.SphereCast(origin, radius, direction, out hitInfo, maxDistance, layerMask, queryTriggerInteraction);
        public static bool SphereCast(Ray ray, float radius)
            => SphereCast(ray.origin, radius, ray.direction, out _, Mathf.Infinity, DefaultRaycastLayers,
                QueryTriggerInteraction.UseGlobal);
        public static bool SphereCast(Ray ray, float radius, float maxDistance)
            => SphereCast(ray.origin, radius, ray.direction, out _, maxDistance, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static bool SphereCast(Ray ray, float radius, float maxDistance, int layerMask)
            => SphereCast(ray.origin, radius, ray.direction, out _, maxDistance, layerMask, QueryTriggerInteraction.UseGlobal);
        public static bool SphereCast(Ray ray, float radius, float maxDistance, int layerMask,
            QueryTriggerInteraction queryTriggerInteraction)
            => SphereCast(ray.origin, radius, ray.direction, out _, maxDistance, layerMask, queryTriggerInteraction);
        public static bool SphereCast(Ray ray, float radius, out RaycastHit hitInfo)
            => SphereCast(ray.origin, radius, ray.direction, out hitInfo, Mathf.Infinity, DefaultRaycastLayers,
                QueryTriggerInteraction.UseGlobal);
        public static bool SphereCast(Ray ray, float radius, out RaycastHit hitInfo, float maxDistance)
            => SphereCast(ray.origin, radius, ray.direction, out hitInfo, maxDistance, DefaultRaycastLayers,
                QueryTriggerInteraction.UseGlobal);
        public static bool SphereCast(Ray ray, float radius, out RaycastHit hitInfo, float maxDistance, int layerMask)
            => SphereCast(ray.origin, radius, ray.direction, out hitInfo, maxDistance, layerMask, QueryTriggerInteraction.UseGlobal);
        public static bool SphereCast(Ray ray, float radius, out RaycastHit hitInfo, float maxDistance, int layerMask,
            QueryTriggerInteraction queryTriggerInteraction)
            => SphereCast(ray.origin, radius, ray.direction, out hitInfo, maxDistance, layerMask, queryTriggerInteraction);

        public static RaycastHit[] SphereCastAll(Vector3 origin, float radius, Vector3 direction)
            => SphereCastAll(origin, radius, direction, Mathf.Infinity, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static RaycastHit[] SphereCastAll(Vector3 origin, float radius, Vector3 direction, float maxDistance)
            => SphereCastAll(origin, radius, direction, maxDistance, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static RaycastHit[] SphereCastAll(Vector3 origin, float radius, Vector3 direction, float maxDistance, int layerMask)
            => SphereCastAll(origin, radius, direction, maxDistance, layerMask, QueryTriggerInteraction.UseGlobal);
        public static RaycastHit[] SphereCastAll(Vector3 origin, float radius, Vector3 direction, float maxDistance, int layerMask,
            QueryTriggerInteraction queryTriggerInteraction)
            => defaultPhysicsScene.Sweeps(Casts.Sphere(radius), new BodyPose(origin, Quaternion.identity), direction, maxDistance,
                layerMask, queryTriggerInteraction).ToArray();
        public static RaycastHit[] SphereCastAll(Ray ray, float radius)
            => SphereCastAll(ray.origin, radius, ray.direction, Mathf.Infinity, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static RaycastHit[] SphereCastAll(Ray ray, float radius, float maxDistance)
            => SphereCastAll(ray.origin, radius, ray.direction, maxDistance, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static RaycastHit[] SphereCastAll(Ray ray, float radius, float maxDistance, int layerMask)
            => SphereCastAll(ray.origin, radius, ray.direction, maxDistance, layerMask, QueryTriggerInteraction.UseGlobal);
        public static RaycastHit[] SphereCastAll(Ray ray, float radius, float maxDistance, int layerMask,
            QueryTriggerInteraction queryTriggerInteraction)
            => SphereCastAll(ray.origin, radius, ray.direction, maxDistance, layerMask, queryTriggerInteraction);

        public static int SphereCastNonAlloc(Vector3 origin, float radius, Vector3 direction, RaycastHit[] results)
            => SphereCastNonAlloc(origin, radius, direction, results, Mathf.Infinity, DefaultRaycastLayers,
                QueryTriggerInteraction.UseGlobal);
        public static int SphereCastNonAlloc(Vector3 origin, float radius, Vector3 direction, RaycastHit[] results, float maxDistance)
            => SphereCastNonAlloc(origin, radius, direction, results, maxDistance, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static int SphereCastNonAlloc(Vector3 origin, float radius, Vector3 direction, RaycastHit[] results, float maxDistance,
            int layerMask)
            => SphereCastNonAlloc(origin, radius, direction, results, maxDistance, layerMask, QueryTriggerInteraction.UseGlobal);
        public static int SphereCastNonAlloc(Vector3 origin, float radius, Vector3 direction, RaycastHit[] results, float maxDistance,
            int layerMask, QueryTriggerInteraction queryTriggerInteraction)
            => defaultPhysicsScene.SphereCast(origin, radius, direction, results, maxDistance, layerMask, queryTriggerInteraction);
        public static int SphereCastNonAlloc(Ray ray, float radius, RaycastHit[] results)
            => SphereCastNonAlloc(ray.origin, radius, ray.direction, results, Mathf.Infinity, DefaultRaycastLayers,
                QueryTriggerInteraction.UseGlobal);
        public static int SphereCastNonAlloc(Ray ray, float radius, RaycastHit[] results, float maxDistance)
            => SphereCastNonAlloc(ray.origin, radius, ray.direction, results, maxDistance, DefaultRaycastLayers,
                QueryTriggerInteraction.UseGlobal);
        public static int SphereCastNonAlloc(Ray ray, float radius, RaycastHit[] results, float maxDistance, int layerMask)
            => SphereCastNonAlloc(ray.origin, radius, ray.direction, results, maxDistance, layerMask, QueryTriggerInteraction.UseGlobal);
        public static int SphereCastNonAlloc(Ray ray, float radius, RaycastHit[] results, float maxDistance, int layerMask,
            QueryTriggerInteraction queryTriggerInteraction)
            => SphereCastNonAlloc(ray.origin, radius, ray.direction, results, maxDistance, layerMask, queryTriggerInteraction);

        public static bool CapsuleCast(Vector3 point1, Vector3 point2, float radius, Vector3 direction)
            => CapsuleCast(point1, point2, radius, direction, Mathf.Infinity, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static bool CapsuleCast(Vector3 point1, Vector3 point2, float radius, Vector3 direction, float maxDistance)
            => CapsuleCast(point1, point2, radius, direction, maxDistance, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static bool CapsuleCast(Vector3 point1, Vector3 point2, float radius, Vector3 direction, float maxDistance, int layerMask)
            => CapsuleCast(point1, point2, radius, direction, maxDistance, layerMask, QueryTriggerInteraction.UseGlobal);
        public static bool CapsuleCast(Vector3 point1, Vector3 point2, float radius, Vector3 direction, float maxDistance, int layerMask,
            QueryTriggerInteraction queryTriggerInteraction)
            => defaultPhysicsScene.CapsuleCast(point1, point2, radius, direction, out _, maxDistance, layerMask, queryTriggerInteraction);
        public static bool CapsuleCast(Vector3 point1, Vector3 point2, float radius, Vector3 direction, out RaycastHit hitInfo)
            => CapsuleCast(point1, point2, radius, direction, out hitInfo, Mathf.Infinity, DefaultRaycastLayers,
                QueryTriggerInteraction.UseGlobal);
        public static bool CapsuleCast(Vector3 point1, Vector3 point2, float radius, Vector3 direction, out RaycastHit hitInfo,
            float maxDistance)
            => CapsuleCast(point1, point2, radius, direction, out hitInfo, maxDistance, DefaultRaycastLayers,
                QueryTriggerInteraction.UseGlobal);
        public static bool CapsuleCast(Vector3 point1, Vector3 point2, float radius, Vector3 direction, out RaycastHit hitInfo,
            float maxDistance, int layerMask)
            => CapsuleCast(point1, point2, radius, direction, out hitInfo, maxDistance, layerMask, QueryTriggerInteraction.UseGlobal);
        public static bool CapsuleCast(Vector3 point1, Vector3 point2, float radius, Vector3 direction, out RaycastHit hitInfo,
            float maxDistance, int layerMask, QueryTriggerInteraction queryTriggerInteraction)
            => defaultPhysicsScene.CapsuleCast(point1, point2, radius, direction, out hitInfo, maxDistance, layerMask,
                queryTriggerInteraction);

        public static RaycastHit[] CapsuleCastAll(Vector3 point1, Vector3 point2, float radius, Vector3 direction)
            => CapsuleCastAll(point1, point2, radius, direction, Mathf.Infinity, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static RaycastHit[] CapsuleCastAll(Vector3 point1, Vector3 point2, float radius, Vector3 direction, float maxDistance)
            => CapsuleCastAll(point1, point2, radius, direction, maxDistance, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static RaycastHit[] CapsuleCastAll(Vector3 point1, Vector3 point2, float radius, Vector3 direction, float maxDistance,
            int layerMask)
            => CapsuleCastAll(point1, point2, radius, direction, maxDistance, layerMask, QueryTriggerInteraction.UseGlobal);
        public static RaycastHit[] CapsuleCastAll(Vector3 point1, Vector3 point2, float radius, Vector3 direction, float maxDistance,
            int layerMask, QueryTriggerInteraction queryTriggerInteraction)
            => defaultPhysicsScene.Sweeps(Casts.Capsule(point1, point2, radius, out BodyPose pose), pose, direction, maxDistance,
                layerMask, queryTriggerInteraction).ToArray();

        public static int CapsuleCastNonAlloc(Vector3 point1, Vector3 point2, float radius, Vector3 direction, RaycastHit[] results)
            => CapsuleCastNonAlloc(point1, point2, radius, direction, results, Mathf.Infinity, DefaultRaycastLayers,
                QueryTriggerInteraction.UseGlobal);
        public static int CapsuleCastNonAlloc(Vector3 point1, Vector3 point2, float radius, Vector3 direction, RaycastHit[] results,
            float maxDistance)
            => CapsuleCastNonAlloc(point1, point2, radius, direction, results, maxDistance, DefaultRaycastLayers,
                QueryTriggerInteraction.UseGlobal);
        public static int CapsuleCastNonAlloc(Vector3 point1, Vector3 point2, float radius, Vector3 direction, RaycastHit[] results,
            float maxDistance, int layerMask)
            => CapsuleCastNonAlloc(point1, point2, radius, direction, results, maxDistance, layerMask, QueryTriggerInteraction.UseGlobal);
        public static int CapsuleCastNonAlloc(Vector3 point1, Vector3 point2, float radius, Vector3 direction, RaycastHit[] results,
            float maxDistance, int layerMask, QueryTriggerInteraction queryTriggerInteraction)
            => defaultPhysicsScene.CapsuleCast(point1, point2, radius, direction, results, maxDistance, layerMask, queryTriggerInteraction);
    }
}
