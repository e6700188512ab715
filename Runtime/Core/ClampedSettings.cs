using UnityEngine;

namespace Rill
{
    /// <summary>Corrections by the newest check of a component's settings.</summary>
    struct ClampedSettings
    {
        bool isLogged;

        /// <summary>For the inspector; null where nothing was wrong.</summary>
        public string Problem { get; private set; }

        /// <summary>Sets the result of a check. An unread result stays if the next check finds nothing.</summary>
        /// <param name="problem">Null if nothing was wrong.</param>
        public void Set(string problem)
        {
            if (problem == null && Problem != null && !isLogged)
                return;
            Problem = problem;
            isLogged = false;
        }

        /// <summary>Logs it once, by name.</summary>
        public void Log(Object of)
        {
            if (Problem != null && !isLogged)
                Debug.LogWarning($"Rill: {of.GetType().Name} '{of.name}': {Problem}", of);
            isLogged = true;
        }
    }
}
