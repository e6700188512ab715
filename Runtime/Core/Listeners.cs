using System;
using UnityEngine;
using UnityEngine.Events;
using Object = UnityEngine.Object;

namespace Rill
{
    /// <summary>Calls those who listen to an event of a component: first the list in its inspector, then scripts, in the order in which they
    /// came. What one of them throws is logged by Debug.LogException, as in any message of a script, and keeps no other script, event, object
    /// or step from going on. The list in an inspector ends at the one that throws, as Unity has it.</summary>
    static class Listeners
    {
        /// <param name="of">Whose event it is, for the console.</param>
        public static void Raise(UnityEvent listed, in Delegates<Action> scripts, Object of)
        {
            try
            {
                listed.Invoke();
            }
            catch (Exception problem)
            {
                Debug.LogException(problem, of);
            }
            foreach (Action script in scripts.All)
            {
                try
                {
                    script();
                }
                catch (Exception problem)
                {
                    Debug.LogException(problem, of);
                }
            }
        }

        /// <param name="of">Whose event it is, for the console.</param>
        public static void Raise<T>(UnityEvent<T> listed, in Delegates<Action<T>> scripts, in T what, Object of)
        {
            try
            {
                listed.Invoke(what);
            }
            catch (Exception problem)
            {
                Debug.LogException(problem, of);
            }
            foreach (Action<T> script in scripts.All)
            {
                try
                {
                    script(what);
                }
                catch (Exception problem)
                {
                    Debug.LogException(problem, of);
                }
            }
        }
    }
}
