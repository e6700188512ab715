using System;
using System.Collections.Generic;

namespace UnityEngine.Headless
{
    /// <summary>The Editor while nothing plays: a script hears OnValidate, and the rest only where it asks to run there. The host
    /// plays unless a test turns this on.</summary>
    internal static class EditMode
    {
        static readonly Dictionary<Type, bool> always = new Dictionary<Type, bool>();

        /// <summary>Set while no scene is loaded, as by a test before it makes objects.</summary>
        public static bool IsOn { get; set; }

        /// <summary>Whether the player loop runs at the next update of the editor, although nothing of the scene changed.</summary>
        public static bool IsLoopQueued { get; set; }

        /// <summary>Whether a script hears Awake, OnEnable, its updates, OnDisable and OnDestroy.</summary>
        public static bool Runs(MonoBehaviour script) => !IsOn || script.runInEditMode || RunsAlways(script.GetType());

        static bool RunsAlways(Type type)
        {
            if (!always.TryGetValue(type, out bool runs))
                always[type] = runs = type.IsDefined(typeof(ExecuteAlways), true) || type.IsDefined(typeof(ExecuteInEditMode), true);
            return runs;
        }
    }
}
