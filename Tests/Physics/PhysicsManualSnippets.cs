using NUnit.Framework;
using UnityEngine;

namespace Rill.Tests
{
    /// <summary>The snippets of the manual that need the physics, as in ManualSnippets.</summary>
    public class PhysicsManualSnippets
    {
        static void TakeColliders(FluidSimulation fluid)
        {
            #region Take the colliders of the physics
            var taken = fluid.gameObject.AddComponent<FluidPhysicsColliders>();
            taken.ColliderLayers = 1 << 0;                  // what the water meets: the layer Default
            taken.FloatingLayers = 1 << 8;                  // whose Rigidbodies it carries
            taken.OnEnter += contact => Debug.Log($"{contact.Collider.name} got wet in step {contact.Step}");
            #endregion
        }

        [Test]
        public void The_snippet_of_the_manual_takes_layers()
        {
            var pool = new GameObject("Pool");
            pool.SetActive(false);
            try
            {
                TakeColliders(pool.AddComponent<FluidSimulation>());
                var taken = pool.GetComponent<FluidPhysicsColliders>();
                Assert.That((taken.ColliderLayers.value, taken.FloatingLayers.value), Is.EqualTo((1, 256)));
                Assert.That(taken.Validate(out string problem), problem);
            }
            finally
            {
                Object.DestroyImmediate(pool);
            }
        }
    }
}
