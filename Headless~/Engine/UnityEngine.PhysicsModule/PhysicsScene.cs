using System;
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
            foreach (PhysicsShape shape in PhysicsWorld.Shapes)
                if (Has(shape.Object))
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

        public int OverlapBox(Vector3 center, Vector3 halfExtents, Collider[] results)
            => OverlapBox(center, halfExtents, results, Quaternion.identity);

        /// <returns>How many of the results are of this call; what does not fit is left out.</returns>
        public int OverlapBox(Vector3 center, Vector3 halfExtents, Collider[] results, Quaternion orientation,
            int layerMask = Physics.DefaultRaycastLayers, QueryTriggerInteraction queryTriggerInteraction = QueryTriggerInteraction.UseGlobal)
        {
            bool hitsTriggers = queryTriggerInteraction == QueryTriggerInteraction.Collide
                || queryTriggerInteraction == QueryTriggerInteraction.UseGlobal && Physics.queriesHitTriggers;
            int count = 0;
            foreach (PhysicsShape shape in PhysicsWorld.Shapes)
            {
                Collider collider = ((QueriedShape)shape).Owner;
                if (count == results.Length)
                    break;
                if (!Has(shape.Object) || (layerMask & 1 << collider.gameObject.layer) == 0 || collider.isTrigger && !hitsTriggers
                    || !collider.Overlaps(center, halfExtents, orientation))
                    continue;
                results[count++] = collider;
            }
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
