namespace UnityEditor
{
    /// <summary>One update of the editor: what asked to be called at each, then what asked to be called once.</summary>
    internal static class EditorTick
    {
        public static void Run()
        {
            EditorApplication.update?.Invoke();
            EditorApplication.CallbackFunction once = EditorApplication.delayCall;
            EditorApplication.delayCall = null;     // what these ask for comes at the next
            once?.Invoke();
        }
    }
}
