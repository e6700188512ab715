using UnityEngine.Headless;

namespace UnityEditor
{
    /// <summary>One update of the editor: what asked to be called at each, then what asked to be called once, then the player loop
    /// where edit mode has it queued.</summary>
    internal static class EditorTick
    {
        const float FrameTime = 1f / 60f;

        /// <summary>The calls alone, without the player loop.</summary>
        public static void Call()
        {
            EditorApplication.update?.Invoke();
            EditorApplication.CallbackFunction once = EditorApplication.delayCall;
            EditorApplication.delayCall = null;     // what these ask for comes at the next
            once?.Invoke();
        }

        public static void Run()
        {
            Call();
            if (!EditMode.IsLoopQueued)
                return;
            EditMode.IsLoopQueued = false;
            PlayerLoop.Frame(FrameTime);
        }
    }
}
