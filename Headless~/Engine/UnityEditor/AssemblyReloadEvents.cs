namespace UnityEditor
{
    /// <summary>This host loads scripts once; tests say when they would be loaded again.</summary>
    public static class AssemblyReloadEvents
    {
        public delegate void AssemblyReloadCallback();

        public static event AssemblyReloadCallback beforeAssemblyReload;
        public static event AssemblyReloadCallback afterAssemblyReload;

        internal static void SayBefore() => beforeAssemblyReload?.Invoke();
        internal static void SayAfter() => afterAssemblyReload?.Invoke();
    }
}
