using UnityEditor;

namespace Rill.Editor
{
    /// <summary>Before scripts are loaded again, what fluids that are gone asked for is waited for: nothing of it comes back afterwards.</summary>
    static class ReadbackReload
    {
        [InitializeOnLoadMethod]
        static void Watch() => AssemblyReloadEvents.beforeAssemblyReload += PendingReadbacks.End;
    }
}
