namespace UnityEditor
{
    /// <summary>Raised by <see cref="EditorReload"/>, which tests call: this host loads scripts once.</summary>
    public static class AssemblyReloadEvents
    {
        public delegate void AssemblyReloadCallback();

        public static event AssemblyReloadCallback beforeAssemblyReload;
        public static event AssemblyReloadCallback afterAssemblyReload;

        internal static void RaiseBefore() => beforeAssemblyReload?.Invoke();
        internal static void RaiseAfter() => afterAssemblyReload?.Invoke();
    }
}
