using System;
using UnityEngine;
using UnityEngine.Events;
using Object = UnityEngine.Object;

namespace Rill
{
    /// <summary>Calls those who listen to an event. What one of them throws is logged by Debug.LogException, as in any message of a script, and
    /// keeps no other event, object or step from going on. Of one event those after it are left out, as by UnityEvent and C# events.</summary>
    static class Listeners
    {
        /// <param name="of">Whose event it is, for the console.</param>
        public static void Tell(UnityEvent listeners, Object of)
        {
            try
            {
                listeners.Invoke();
            }
            catch (Exception problem)
            {
                Debug.LogException(problem, of);
            }
        }

        /// <param name="of">Whose event it is, for the console.</param>
        public static void Tell<T>(UnityEvent<T> listeners, in T what, Object of)
        {
            try
            {
                listeners.Invoke(what);
            }
            catch (Exception problem)
            {
                Debug.LogException(problem, of);
            }
        }

        /// <param name="listeners">Null for none.</param>
        /// <param name="of">Whose event it is, for the console.</param>
        public static void Tell<T>(Action<T> listeners, in T what, Object of)
        {
            try
            {
                listeners?.Invoke(what);
            }
            catch (Exception problem)
            {
                Debug.LogException(problem, of);
            }
        }
    }
}
