using System;
using System.Collections;
using System.Collections.Generic;

namespace UnityEngine.Headless
{
    internal enum CoroutinePoint { None, FixedUpdate, Update, EndOfFrame }

    internal static class CoroutineScheduler
    {
        static readonly List<Coroutine> waiting = new List<Coroutine>();

        /// <summary>The point of the frame whose coroutines run now.</summary>
        public static CoroutinePoint At { get; private set; }

        /// <summary>Runs to the first yield at once.</summary>
        public static Coroutine Start(MonoBehaviour owner, IEnumerator routine, string methodName)
        {
            if (!owner.Owner.activeInHierarchy)
            {
                Debug.LogError($"Coroutine couldn't be started because the the game object '{owner.NameOf}' is inactive!", owner);
                return null;
            }
            var coroutine = new Coroutine(owner, routine, methodName);
            owner.Coroutines.Add(coroutine);
            waiting.Add(coroutine);
            Advance(coroutine);
            return coroutine;
        }

        public static void Stop(Coroutine coroutine)
        {
            if (coroutine.Done)
                return;
            coroutine.Done = true;
            coroutine.Drop();
            coroutine.Owner.Coroutines.Remove(coroutine);
            waiting.Remove(coroutine);
        }

        public static void Resume(CoroutinePoint point)
        {
            At = point;
            foreach (Coroutine coroutine in waiting.ToArray())
                if (!coroutine.Done && coroutine.ResumeAt == point && coroutine.IsDue)
                    Advance(coroutine);
            At = CoroutinePoint.None;
        }

        static void Advance(Coroutine coroutine)
        {
            bool more = false;
            try
            {
                more = coroutine.Advance();
            }
            catch (Exception e)
            {
                Debug.LogException(e, coroutine.Owner);
            }
            if (more || coroutine.Done)
                return;
            Stop(coroutine);
            // Whoever waits for it goes on at once.
            foreach (Coroutine other in waiting.ToArray())
                if (!other.Done && other.Awaits(coroutine))
                    Advance(other);
        }

        public static void Clear()
        {
            foreach (Coroutine coroutine in waiting.ToArray())
                Stop(coroutine);
        }
    }
}
