using System.Collections.Generic;
using UnityEngine.Headless;

namespace UnityEngine
{
    // Sweeps of a body, and pushes of explosions.
    public partial class Rigidbody
    {
        public bool SweepTest(Vector3 direction, out RaycastHit hitInfo) => SweepTest(direction, out hitInfo, Mathf.Infinity);

        public bool SweepTest(Vector3 direction, out RaycastHit hitInfo, float maxDistance)
            => SweepTest(direction, out hitInfo, maxDistance, QueryTriggerInteraction.UseGlobal);

        public bool SweepTest(Vector3 direction, out RaycastHit hitInfo, float maxDistance, QueryTriggerInteraction queryTriggerInteraction)
        {
            RaycastHit[] hits = SweepTestAll(direction, maxDistance, queryTriggerInteraction);
            hitInfo = hits.Length > 0 ? hits[0] : default;
            return hits.Length > 0;
        }

        public RaycastHit[] SweepTestAll(Vector3 direction) => SweepTestAll(direction, Mathf.Infinity);

        public RaycastHit[] SweepTestAll(Vector3 direction, float maxDistance)
            => SweepTestAll(direction, maxDistance, QueryTriggerInteraction.UseGlobal);

        /// <summary>Nearest first, without what overlaps at the start.</summary>
        public RaycastHit[] SweepTestAll(Vector3 direction, float maxDistance, QueryTriggerInteraction queryTriggerInteraction)
        {
            var found = new List<RaycastHit>();
            foreach (Collider collider in GetComponentsInChildren<Collider>())
                if (collider.enabled && !collider.isTrigger && collider.attachedRigidbody == this)
                    found.AddRange(Casts.Sweeps(PhysicsWorld.SceneOf(gameObject), collider.Describe(),
                        State.Pose.Of(collider.PoseIn(transform)), direction, maxDistance, Physics.AllLayers, queryTriggerInteraction));
            found.RemoveAll(hit => hit.rigidbody == this || hit.distance <= 0f
                || Physics.GetIgnoreLayerCollision(gameObject.layer, hit.collider.gameObject.layer));
            found.Sort((a, b) => a.distance.CompareTo(b.distance));
            return found.ToArray();
        }

        /// <summary>On the bounds of its colliders.</summary>
        public Vector3 ClosestPointOnBounds(Vector3 position)
        {
            Vector3 closest = position;
            float least = float.PositiveInfinity;
            foreach (Collider collider in GetComponentsInChildren<Collider>())
                if (collider.attachedRigidbody == this && collider.ClosestPointOnBounds(position) is Vector3 point
                    && (point - position).sqrMagnitude < least)
                {
                    least = (point - position).sqrMagnitude;
                    closest = point;
                }
            return closest;
        }

        public void AddExplosionForce(float explosionForce, Vector3 explosionPosition, float explosionRadius)
            => AddExplosionForce(explosionForce, explosionPosition, explosionRadius, 0f, ForceMode.Force);

        public void AddExplosionForce(float explosionForce, Vector3 explosionPosition, float explosionRadius, float upwardsModifier)
            => AddExplosionForce(explosionForce, explosionPosition, explosionRadius, upwardsModifier, ForceMode.Force);

        /// <summary>Less with the distance of the nearest point of its bounds, from a point that lies lower by the modifier.</summary>
        public void AddExplosionForce(float explosionForce, Vector3 explosionPosition, float explosionRadius, float upwardsModifier, ForceMode mode)
        {
            Vector3 closest = ClosestPointOnBounds(explosionPosition);
            float distance = Vector3.Distance(closest, explosionPosition);
            if (explosionRadius > 0f && distance > explosionRadius)
                return;
            Vector3 from = explosionPosition - Vector3.up * upwardsModifier, along = worldCenterOfMass - from;
            float part = explosionRadius > 0f ? 1f - distance / explosionRadius : 1f;
            AddForceAtPosition((along == Vector3.zero ? Vector3.up : along.normalized) * (explosionForce * part), closest, mode);
        }
    }
}
