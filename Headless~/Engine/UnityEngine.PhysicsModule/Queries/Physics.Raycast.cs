namespace UnityEngine
{
    // Rays and lines. Every shorter overload calls the longest.
    public partial class Physics
    {
        public static bool Raycast(Vector3 origin, Vector3 direction)
            => Raycast(origin, direction, Mathf.Infinity, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static bool Raycast(Vector3 origin, Vector3 direction, float maxDistance)
            => Raycast(origin, direction, maxDistance, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static bool Raycast(Vector3 origin, Vector3 direction, float maxDistance, int layerMask)
            => Raycast(origin, direction, maxDistance, layerMask, QueryTriggerInteraction.UseGlobal);
        public static bool Raycast(Vector3 origin, Vector3 direction, float maxDistance, int layerMask,
            QueryTriggerInteraction queryTriggerInteraction)
            => defaultPhysicsScene.Raycast(origin, direction, maxDistance, layerMask, queryTriggerInteraction);
        public static bool Raycast(Vector3 origin, Vector3 direction, out RaycastHit hitInfo)
            => Raycast(origin, direction, out hitInfo, Mathf.Infinity, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static bool Raycast(Vector3 origin, Vector3 direction, out RaycastHit hitInfo, float maxDistance)
            => Raycast(origin, direction, out hitInfo, maxDistance, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static bool Raycast(Vector3 origin, Vector3 direction, out RaycastHit hitInfo, float maxDistance, int layerMask)
            => Raycast(origin, direction, out hitInfo, maxDistance, layerMask, QueryTriggerInteraction.UseGlobal);
        public static bool Raycast(Vector3 origin, Vector3 direction, out RaycastHit hitInfo, float maxDistance, int layerMask,
            QueryTriggerInteraction queryTriggerInteraction)
            => defaultPhysicsScene.Raycast(origin, direction, out hitInfo, maxDistance, layerMask, queryTriggerInteraction);
        public static bool Raycast(Ray ray)
            => Raycast(ray.origin, ray.direction, Mathf.Infinity, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static bool Raycast(Ray ray, float maxDistance)
            => Raycast(ray.origin, ray.direction, maxDistance, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static bool Raycast(Ray ray, float maxDistance, int layerMask)
            => Raycast(ray.origin, ray.direction, maxDistance, layerMask, QueryTriggerInteraction.UseGlobal);
        public static bool Raycast(Ray ray, float maxDistance, int layerMask, QueryTriggerInteraction queryTriggerInteraction)
            => Raycast(ray.origin, ray.direction, maxDistance, layerMask, queryTriggerInteraction);
        public static bool Raycast(Ray ray, out RaycastHit hitInfo)
            => Raycast(ray.origin, ray.direction, out hitInfo, Mathf.Infinity, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static bool Raycast(Ray ray, out RaycastHit hitInfo, float maxDistance)
            => Raycast(ray.origin, ray.direction, out hitInfo, maxDistance, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static bool Raycast(Ray ray, out RaycastHit hitInfo, float maxDistance, int layerMask)
            => Raycast(ray.origin, ray.direction, out hitInfo, maxDistance, layerMask, QueryTriggerInteraction.UseGlobal);
        public static bool Raycast(Ray ray, out RaycastHit hitInfo, float maxDistance, int layerMask,
            QueryTriggerInteraction queryTriggerInteraction)
            => Raycast(ray.origin, ray.direction, out hitInfo, maxDistance, layerMask, queryTriggerInteraction);

        public static RaycastHit[] RaycastAll(Vector3 origin, Vector3 direction)
            => RaycastAll(origin, direction, Mathf.Infinity, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static RaycastHit[] RaycastAll(Vector3 origin, Vector3 direction, float maxDistance)
            => RaycastAll(origin, direction, maxDistance, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static RaycastHit[] RaycastAll(Vector3 origin, Vector3 direction, float maxDistance, int layerMask)
            => RaycastAll(origin, direction, maxDistance, layerMask, QueryTriggerInteraction.UseGlobal);
        public static RaycastHit[] RaycastAll(Vector3 origin, Vector3 direction, float maxDistance, int layerMask,
            QueryTriggerInteraction queryTriggerInteraction)
            => defaultPhysicsScene.Rays(origin, direction, maxDistance, layerMask, queryTriggerInteraction).ToArray();
        public static RaycastHit[] RaycastAll(Ray ray)
            => RaycastAll(ray.origin, ray.direction, Mathf.Infinity, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static RaycastHit[] RaycastAll(Ray ray, float maxDistance)
            => RaycastAll(ray.origin, ray.direction, maxDistance, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static RaycastHit[] RaycastAll(Ray ray, float maxDistance, int layerMask)
            => RaycastAll(ray.origin, ray.direction, maxDistance, layerMask, QueryTriggerInteraction.UseGlobal);
        public static RaycastHit[] RaycastAll(Ray ray, float maxDistance, int layerMask, QueryTriggerInteraction queryTriggerInteraction)
            => RaycastAll(ray.origin, ray.direction, maxDistance, layerMask, queryTriggerInteraction);

        public static int RaycastNonAlloc(Vector3 origin, Vector3 direction, RaycastHit[] results)
            => RaycastNonAlloc(origin, direction, results, Mathf.Infinity, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static int RaycastNonAlloc(Vector3 origin, Vector3 direction, RaycastHit[] results, float maxDistance)
            => RaycastNonAlloc(origin, direction, results, maxDistance, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static int RaycastNonAlloc(Vector3 origin, Vector3 direction, RaycastHit[] results, float maxDistance, int layerMask)
            => RaycastNonAlloc(origin, direction, results, maxDistance, layerMask, QueryTriggerInteraction.UseGlobal);
        public static int RaycastNonAlloc(Vector3 origin, Vector3 direction, RaycastHit[] results, float maxDistance, int layerMask,
            QueryTriggerInteraction queryTriggerInteraction)
            => defaultPhysicsScene.Raycast(origin, direction, results, maxDistance, layerMask, queryTriggerInteraction);
        public static int RaycastNonAlloc(Ray ray, RaycastHit[] results)
            => RaycastNonAlloc(ray.origin, ray.direction, results, Mathf.Infinity, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static int RaycastNonAlloc(Ray ray, RaycastHit[] results, float maxDistance)
            => RaycastNonAlloc(ray.origin, ray.direction, results, maxDistance, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static int RaycastNonAlloc(Ray ray, RaycastHit[] results, float maxDistance, int layerMask)
            => RaycastNonAlloc(ray.origin, ray.direction, results, maxDistance, layerMask, QueryTriggerInteraction.UseGlobal);
        public static int RaycastNonAlloc(Ray ray, RaycastHit[] results, float maxDistance, int layerMask,
            QueryTriggerInteraction queryTriggerInteraction)
            => RaycastNonAlloc(ray.origin, ray.direction, results, maxDistance, layerMask, queryTriggerInteraction);

        public static bool Linecast(Vector3 start, Vector3 end)
            => Linecast(start, end, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static bool Linecast(Vector3 start, Vector3 end, int layerMask)
            => Linecast(start, end, layerMask, QueryTriggerInteraction.UseGlobal);
        public static bool Linecast(Vector3 start, Vector3 end, int layerMask, QueryTriggerInteraction queryTriggerInteraction)
            => defaultPhysicsScene.Raycast(start, end - start, Vector3.Distance(start, end), layerMask, queryTriggerInteraction);
        public static bool Linecast(Vector3 start, Vector3 end, out RaycastHit hitInfo)
            => Linecast(start, end, out hitInfo, DefaultRaycastLayers, QueryTriggerInteraction.UseGlobal);
        public static bool Linecast(Vector3 start, Vector3 end, out RaycastHit hitInfo, int layerMask)
            => Linecast(start, end, out hitInfo, layerMask, QueryTriggerInteraction.UseGlobal);
        public static bool Linecast(Vector3 start, Vector3 end, out RaycastHit hitInfo, int layerMask,
            QueryTriggerInteraction queryTriggerInteraction)
            => defaultPhysicsScene.Raycast(start, end - start, out hitInfo, Vector3.Distance(start, end), layerMask,
                queryTriggerInteraction);
    }
}
