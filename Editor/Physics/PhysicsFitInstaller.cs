using UnityEditor;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>Lets a new Fluid Collider fit itself to the object's collider of the physics, and a new Fluid Buoyancy add one.</summary>
    static class PhysicsFitInstaller
    {
        [InitializeOnLoadMethod]
        static void Install()
        {
            ColliderFit.FitToPhysics = PhysicsFit.Fit;
            FluidBuoyancy.AddCollider = AddCollider;
        }

        static void AddCollider(GameObject to) => Undo.AddComponent<FluidCollider>(to);
    }
}
