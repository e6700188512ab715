using System;
using System.Collections;
using System.Collections.Generic;
using System.Threading;
using UnityEngine.Headless;

namespace UnityEngine
{
    public class MonoBehaviour : Behaviour
    {
        [NonSerialized] internal readonly List<Coroutine> Coroutines = new List<Coroutine>();
        [NonSerialized] internal bool Awoken, Started, SaidEnabled;
        [NonSerialized] CancellationTokenSource destroyCancellation;
        [NonSerialized] bool runsInEditMode;

        public MonoBehaviour()
        {
            if (ObjectFactory.Constructing)
                return;
            Debug.LogWarning("You are trying to create a MonoBehaviour using the 'new' keyword.  This is not allowed.  MonoBehaviours " +
                "can only be added using AddComponent(). Alternatively, your script can inherit from ScriptableObject or no base class at all");
            Destroyed = true;
        }

        public bool useGUILayout { get; set; } = true;

        /// <summary>In edit mode a script that is enabled hears OnDisable and OnEnable when this is set, and nothing when it is taken
        /// back.</summary>
        public bool runInEditMode
        {
            get => runsInEditMode;
            set
            {
                if (runsInEditMode == value)
                    return;
                runsInEditMode = value;
                if (value && EditMode.IsOn)
                    Lifecycle.BeginInEditMode(this);
            }
        }

        /// <summary>Canceled when this is destroyed.</summary>
        public CancellationToken destroyCancellationToken
        {
            get
            {
                ThrowIfDestroyed();
                return (destroyCancellation ??= new CancellationTokenSource()).Token;
            }
        }

        internal override void ReleaseNative()
        {
            StopAllCoroutines();
            Invocations.CancelAll(this, null);
            destroyCancellation?.Cancel();
            destroyCancellation?.Dispose();
        }

        // ---- coroutines
        public Coroutine StartCoroutine(IEnumerator routine)
        {
            ThrowIfDestroyed();
            if (routine == null)
                throw new NullReferenceException("routine is null");
            return CoroutineScheduler.Start(this, routine, null);
        }

        public Coroutine StartCoroutine(string methodName) => StartCoroutine(methodName, null);

        public Coroutine StartCoroutine(string methodName, object value)
        {
            ThrowIfDestroyed();
            if (Messages.Call(this, methodName, value, out object result) && result is IEnumerator routine)
                return CoroutineScheduler.Start(this, routine, methodName);
            Debug.LogError($"Coroutine '{methodName}' couldn't be started!", this);
            return null;
        }

        public void StopCoroutine(Coroutine routine)
        {
            if (routine == null)
                throw new NullReferenceException("routine is null");
            CoroutineScheduler.Stop(routine);
        }

        public void StopCoroutine(IEnumerator routine) => StopWhere(c => c.Runs(routine));
        public void StopCoroutine(string methodName) => StopWhere(c => c.MethodName == methodName);
        public void StopAllCoroutines() => StopWhere(_ => true);

        void StopWhere(Predicate<Coroutine> which)
        {
            foreach (Coroutine coroutine in Coroutines.FindAll(which))
                CoroutineScheduler.Stop(coroutine);
        }

        // ---- timed calls
        public void Invoke(string methodName, float time) => Invocations.Add(this, methodName, time, 0);

        public void InvokeRepeating(string methodName, float time, float repeatRate)
        {
            if (repeatRate <= 0.00001f && repeatRate != 0)
                throw new UnityException("Invoke repeat rate has to be larger than 0.00001F)");
            Invocations.Add(this, methodName, time, repeatRate);
        }

        public void CancelInvoke() => Invocations.CancelAll(this, null);
        public void CancelInvoke(string methodName) => Invocations.CancelAll(this, methodName);
        public bool IsInvoking() => Invocations.Any(this, null);
        public bool IsInvoking(string methodName) => Invocations.Any(this, methodName);

        public static void print(object message) => Debug.Log(message);
    }
}
