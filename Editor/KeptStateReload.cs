using UnityEditor;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>Before scripts are loaded again, fluids that are disabled give back what they keep on the GPU: no reference to it would be
    /// left. Unity disables the others after this, and these keep nothing.</summary>
    static class KeptStateReload
    {
        [InitializeOnLoadMethod]
        static void Watch() => AssemblyReloadEvents.beforeAssemblyReload += Release;

        internal static void Release()
        {
            SolverOwner.SuspendsNothing = true;
            foreach (FluidSimulation fluid in Resources.FindObjectsOfTypeAll<FluidSimulation>())
                fluid.ReleaseSuspended();
        }
    }
}
