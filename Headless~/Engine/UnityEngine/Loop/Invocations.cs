using System.Collections.Generic;

namespace UnityEngine.Headless
{
    /// <summary>MonoBehaviour.Invoke and InvokeRepeating.</summary>
    internal static class Invocations
    {
        sealed class Call { public MonoBehaviour Script; public string Method; public double Due; public float Every; public bool Canceled; }

        static readonly List<Call> calls = new List<Call>();

        public static void Add(MonoBehaviour script, string method, float delay, float every)
            => calls.Add(new Call { Script = script, Method = method, Due = Time.timeAsDouble + delay, Every = every });

        public static void CancelAll(MonoBehaviour script, string method)
            => calls.RemoveAll(c => c.Canceled |= ReferenceEquals(c.Script, script) && (method == null || c.Method == method));

        public static bool Any(MonoBehaviour script, string method)
            => calls.Exists(c => ReferenceEquals(c.Script, script) && (method == null || c.Method == method));

        public static void Run()
        {
            foreach (Call call in calls.ToArray())
            {
                while (!call.Canceled && call.Due <= Time.timeAsDouble)
                {
                    if (call.Every > 0)
                        call.Due += call.Every;
                    else
                    {
                        calls.Remove(call);
                        call.Canceled = true;
                    }
                    if (!Messages.Call(call.Script, call.Method, null, out _))
                        Debug.LogError($"Trying to Invoke method: {call.Script.GetType().Name}.{call.Method} couldn't be called.", call.Script);
                }
            }
        }

        public static void Clear() => calls.Clear();
    }
}
