using System;

namespace UnityEngine.Events
{
    [Serializable]
    public class UnityEvent : UnityEventBase
    {
        public UnityEvent() { }
        public void AddListener(UnityAction call) => Add(call);
        public void RemoveListener(UnityAction call) => Remove(call);
        public void Invoke() => Call(Type.EmptyTypes);
    }

    [Serializable]
    public class UnityEvent<T0> : UnityEventBase
    {
        public UnityEvent() { }
        public void AddListener(UnityAction<T0> call) => Add(call);
        public void RemoveListener(UnityAction<T0> call) => Remove(call);
        public void Invoke(T0 arg0) => Call(new[] { typeof(T0) }, arg0);
    }

    [Serializable]
    public class UnityEvent<T0, T1> : UnityEventBase
    {
        public UnityEvent() { }
        public void AddListener(UnityAction<T0, T1> call) => Add(call);
        public void RemoveListener(UnityAction<T0, T1> call) => Remove(call);
        public void Invoke(T0 arg0, T1 arg1) => Call(new[] { typeof(T0), typeof(T1) }, arg0, arg1);
    }

    [Serializable]
    public class UnityEvent<T0, T1, T2> : UnityEventBase
    {
        public UnityEvent() { }
        public void AddListener(UnityAction<T0, T1, T2> call) => Add(call);
        public void RemoveListener(UnityAction<T0, T1, T2> call) => Remove(call);
        public void Invoke(T0 arg0, T1 arg1, T2 arg2) => Call(new[] { typeof(T0), typeof(T1), typeof(T2) }, arg0, arg1, arg2);
    }

    [Serializable]
    public class UnityEvent<T0, T1, T2, T3> : UnityEventBase
    {
        public UnityEvent() { }
        public void AddListener(UnityAction<T0, T1, T2, T3> call) => Add(call);
        public void RemoveListener(UnityAction<T0, T1, T2, T3> call) => Remove(call);
        public void Invoke(T0 arg0, T1 arg1, T2 arg2, T3 arg3)
            => Call(new[] { typeof(T0), typeof(T1), typeof(T2), typeof(T3) }, arg0, arg1, arg2, arg3);
    }
}
