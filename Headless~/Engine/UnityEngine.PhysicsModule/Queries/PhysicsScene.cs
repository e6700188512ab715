using System;
using System.Collections.Generic;
using UnityEngine.Headless;
using UnityEngine.SceneManagement;

namespace UnityEngine
{
    /// <summary>
    /// Bodies and colliders that know of each other: those of a scene that was made with LocalPhysicsMode.Physics3D, or of all other scenes.
    /// </summary>
    public struct PhysicsScene : IEquatable<PhysicsScene>
    {
        readonly SceneData scene;       // null for the default

        internal PhysicsScene(SceneData scene) => this.scene = scene;

        public bool IsValid() => scene == null || !scene.IsGone;

        public bool IsEmpty()
        {
            if (!IsValid())
                throw new InvalidOperationException("Cannot check if physics scene is empty as it is invalid.");
            foreach (Collider collider in PhysicsWorld.Colliders)
                if (Has(collider.gameObject))
                    return false;
            foreach (Rigidbody body in PhysicsWorld.Bodies)
                if (Has(body.gameObject))
                    return false;
            return true;
        }

        /// <summary>One step. Those of the default scene are a script's in one mode alone.</summary>
        public void Simulate(float step)
        {
            if (!IsValid())
                throw new InvalidOperationException("Cannot simulate the physics scene as it is invalid.");
            if (scene == null && PhysicsWorld.Stepped != PhysicsStepping.Script)
            {
                Debug.LogWarning("PhysicsScene.Simulate(...) was called but simulation mode is not set to Script. You should set simulation mode " +
                    "to Script first before calling this function therefore the simulation was not run.");
                return;
            }
            PhysicsWorld.Step(scene, step);
        }

        /// <summary>Bodies of the default scene are shown between steps by the player's loop; here this does nothing.</summary>
        public void InterpolateBodies() { }

        /// <summary>Works like <see cref="InterpolateBodies"/>.</summary>
        public void ResetInterpolationPoses() { }

        // ---- overlaps: how many of the results are of the call; what does not fit is left out

        public int OverlapBox(Vector3 center, Vector3 halfExtents, Collider[] results)
            => OverlapBox(center, halfExtents, results, Quaternion.identity);

        public int OverlapBox(Vector3 center, Vector3 halfExtents, Collider[] results, Quaternion orientation,
            int layerMask = Physics.DefaultRaycastLayers, QueryTriggerInteraction queryTriggerInteraction = QueryTriggerInteraction.UseGlobal)
            => Fill(results, Overlaps(Casts.Box(halfExtents), new BodyPose(center, orientation), layerMask, queryTriggerInteraction));

        public int OverlapSphere(Vector3 position, float radius, Collider[] results, int layerMask,
            QueryTriggerInteraction queryTriggerInteraction)
            => Fill(results, Overlaps(Casts.Sphere(radius), new BodyPose(position, Quaternion.identity), layerMask, queryTriggerInteraction));

        public int OverlapCapsule(Vector3 point0, Vector3 point1, float radius, Collider[] results, int layerMask = Physics.AllLayers,
            QueryTriggerInteraction queryTriggerInteraction = QueryTriggerInteraction.UseGlobal)
            => Fill(results, Overlaps(Casts.Capsule(point0, point1, radius, out BodyPose pose), pose, layerMask, queryTriggerInteraction));

        // ---- rays

        public bool Raycast(Vector3 origin, Vector3 direction, float maxDistance = Mathf.Infinity, int layerMask = Physics.DefaultRaycastLayers,
            QueryTriggerInteraction queryTriggerInteraction = QueryTriggerInteraction.UseGlobal)
            => Rays(origin, direction, maxDistance, layerMask, queryTriggerInteraction).Count > 0;

        public bool Raycast(Vector3 origin, Vector3 direction, out RaycastHit hitInfo, float maxDistance = Mathf.Infinity,
            int layerMask = Physics.DefaultRaycastLayers, QueryTriggerInteraction queryTriggerInteraction = QueryTriggerInteraction.UseGlobal)
            => First(Rays(origin, direction, maxDistance, layerMask, queryTriggerInteraction), out hitInfo);

        public int Raycast(Vector3 origin, Vector3 direction, RaycastHit[] raycastHits, float maxDistance = Mathf.Infinity,
            int layerMask = Physics.DefaultRaycastLayers, QueryTriggerInteraction queryTriggerInteraction = QueryTriggerInteraction.UseGlobal)
            => Fill(raycastHits, Rays(origin, direction, maxDistance, layerMask, queryTriggerInteraction));

        // ---- moved shapes

        public bool BoxCast(Vector3 center, Vector3 halfExtents, Vector3 direction, out RaycastHit hitInfo)
            => BoxCast(center, halfExtents, direction, out hitInfo, Quaternion.identity);

        public bool BoxCast(Vector3 center, Vector3 halfExtents, Vector3 direction, out RaycastHit hitInfo, Quaternion orientation,
            float maxDistance = Mathf.Infinity, int layerMask = Physics.DefaultRaycastLayers,
            QueryTriggerInteraction queryTriggerInteraction = QueryTriggerInteraction.UseGlobal)
            => FirstSwept(Casts.Box(halfExtents), new BodyPose(center, orientation), direction, maxDistance, layerMask, queryTriggerInteraction,
                out hitInfo);

        public int BoxCast(Vector3 center, Vector3 halfExtents, Vector3 direction, RaycastHit[] results)
            => BoxCast(center, halfExtents, direction, results, Quaternion.identity);

        public int BoxCast(Vector3 center, Vector3 halfExtents, Vector3 direction, RaycastHit[] results, Quaternion orientation,
            float maxDistance = Mathf.Infinity, int layerMask = Physics.DefaultRaycastLayers,
            QueryTriggerInteraction queryTriggerInteraction = QueryTriggerInteraction.UseGlobal)
            => Fill(results, Sweeps(Casts.Box(halfExtents), new BodyPose(center, orientation), direction, maxDistance, layerMask,
                queryTriggerInteraction));

        public bool SphereCast(Vector3 origin, float radius, Vector3 direction, out RaycastHit hitInfo, float maxDistance = Mathf.Infinity,
            int layerMask = Physics.DefaultRaycastLayers, QueryTriggerInteraction queryTriggerInteraction = QueryTriggerInteraction.UseGlobal)
            => FirstSwept(Casts.Sphere(radius), new BodyPose(origin, Quaternion.identity), direction, maxDistance, layerMask,
                queryTriggerInteraction, out hitInfo);

        public int SphereCast(Vector3 origin, float radius, Vector3 direction, RaycastHit[] results, float maxDistance = Mathf.Infinity,
            int layerMask = Physics.DefaultRaycastLayers, QueryTriggerInteraction queryTriggerInteraction = QueryTriggerInteraction.UseGlobal)
            => Fill(results, Sweeps(Casts.Sphere(radius), new BodyPose(origin, Quaternion.identity), direction, maxDistance, layerMask,
                queryTriggerInteraction));

        public bool CapsuleCast(Vector3 point1, Vector3 point2, float radius, Vector3 direction, out RaycastHit hitInfo,
            float maxDistance = Mathf.Infinity, int layerMask = Physics.DefaultRaycastLayers,
            QueryTriggerInteraction queryTriggerInteraction = QueryTriggerInteraction.UseGlobal)
            => FirstSwept(Casts.Capsule(point1, point2, radius, out BodyPose pose), pose, direction, maxDistance, layerMask,
                queryTriggerInteraction, out hitInfo);

        public int CapsuleCast(Vector3 point1, Vector3 point2, float radius, Vector3 direction, RaycastHit[] results,
            float maxDistance = Mathf.Infinity, int layerMask = Physics.DefaultRaycastLayers,
            QueryTriggerInteraction queryTriggerInteraction = QueryTriggerInteraction.UseGlobal)
            => Fill(results, Sweeps(Casts.Capsule(point1, point2, radius, out BodyPose pose), pose, direction, maxDistance, layerMask,
                queryTriggerInteraction));

        // ---- what all of them find

        internal List<Collider> Overlaps(in ShapeDescription shape, BodyPose pose, int layerMask, QueryTriggerInteraction triggers)
            => Casts.Overlaps(scene, shape, pose, layerMask, triggers);

        internal List<RaycastHit> Rays(Vector3 origin, Vector3 direction, float distance, int layerMask, QueryTriggerInteraction triggers)
            => Casts.Rays(scene, origin, direction, distance, layerMask, triggers);

        internal List<RaycastHit> Sweeps(in ShapeDescription shape, BodyPose from, Vector3 direction, float distance, int layerMask,
            QueryTriggerInteraction triggers)
            => Casts.Sweeps(scene, shape, from, direction, distance, layerMask, triggers);

        // Like in Unity, the first hit leaves out what overlaps at the start.
        bool FirstSwept(in ShapeDescription shape, BodyPose from, Vector3 direction, float distance, int layerMask,
            QueryTriggerInteraction triggers, out RaycastHit hit)
        {
            foreach (RaycastHit found in Sweeps(shape, from, direction, distance, layerMask, triggers))
                if (found.distance > 0f)
                {
                    hit = found;
                    return true;
                }
            hit = default;
            return false;
        }

        static bool First(List<RaycastHit> found, out RaycastHit hit)
        {
            hit = found.Count > 0 ? found[0] : default;
            return found.Count > 0;
        }

        static int Fill<T>(T[] results, List<T> found)
        {
            int count = Math.Min(results.Length, found.Count);
            found.CopyTo(0, results, 0, count);
            return count;
        }

        bool Has(GameObject gameObject) => PhysicsWorld.SceneOf(gameObject) == scene;

        public bool Equals(PhysicsScene other) => scene == other.scene;
        public override bool Equals(object other) => other is PhysicsScene physics && Equals(physics);
        public override int GetHashCode() => scene?.Handle ?? 0;
        public override string ToString() => $"({GetHashCode()})";
        public static bool operator ==(PhysicsScene lhs, PhysicsScene rhs) => lhs.Equals(rhs);
        public static bool operator !=(PhysicsScene lhs, PhysicsScene rhs) => !lhs.Equals(rhs);
    }

    public static class PhysicsSceneExtensions
    {
        /// <summary>The scene's own, or the default.</summary>
        public static PhysicsScene GetPhysicsScene(this Scene scene) => scene.IsValid() ? new PhysicsScene(PhysicsWorld.SceneOf(scene.Data))
            : throw new ArgumentException("Cannot get physics scene; Unity scene is invalid.", nameof(scene));
    }
}
