using UnityEditor;

namespace Rill.Editor
{
    /// <summary>Before scripts are loaded again, what fluids that are gone asked for is waited for: nothing of it comes back afterwards. As
    /// they have been, during play too, the end of play is watched for again.</summary>
    static class ReadbackReload
    {
        [InitializeOnLoadMethod]
        static void Watch()
        {
            PendingReadbacks.Begin();
            AssemblyReloadEvents.beforeAssemblyReload += PendingReadbacks.End;
        }
    }
}
