using UnityEditor;

namespace Rill.Editor
{
    /// <summary>Lets a new Fluid Collider fit itself to the object's collider of the physics.</summary>
    static class PhysicsFitInstaller
    {
        [InitializeOnLoadMethod]
        static void Install() => ColliderFit.FitToPhysics = PhysicsFit.Fit;
    }
}
