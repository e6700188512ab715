using System;
using System.Collections.Generic;
using System.Reflection;

namespace UnityEngine.Events
{
    public enum PersistentListenerMode { EventDefined = 0, Void = 1, Object = 2, Int = 3, Float = 4, String = 5, Bool = 6 }
    public enum UnityEventCallState { Off = 0, EditorAndRuntime = 1, RuntimeOnly = 2 }

    /// <summary>Listeners that scripts add, after those that the inspector stored.</summary>
    [Serializable]
    public abstract class UnityEventBase : ISerializationCallbackReceiver
    {
        [SerializeField] PersistentCalls m_PersistentCalls = new PersistentCalls();
        [NonSerialized] readonly List<Delegate> added = new List<Delegate>();

        protected UnityEventBase() { }

        public int GetPersistentEventCount() => m_PersistentCalls.m_Calls.Count;
        public Object GetPersistentTarget(int index) => m_PersistentCalls.m_Calls[index].m_Target;
        public string GetPersistentMethodName(int index) => m_PersistentCalls.m_Calls[index].m_MethodName;
        public UnityEventCallState GetPersistentListenerState(int index) => m_PersistentCalls.m_Calls[index].m_CallState;
        public void SetPersistentListenerState(int index, UnityEventCallState state) => m_PersistentCalls.m_Calls[index].m_CallState = state;

        /// <summary>Removes listeners that scripts added; stored ones stay.</summary>
        public void RemoveAllListeners() => added.Clear();

        public override string ToString() => base.ToString() + " " + GetType().FullName;

        public static MethodInfo GetValidMethodInfo(object obj, string functionName, Type[] argumentTypes)
            => GetValidMethodInfo(obj.GetType(), functionName, argumentTypes);

        public static MethodInfo GetValidMethodInfo(Type objectType, string functionName, Type[] argumentTypes)
        {
            for (; objectType != null && objectType != typeof(object); objectType = objectType.BaseType)
                if (objectType.GetMethod(functionName, BindingFlags.Instance | BindingFlags.Static | BindingFlags.Public
                    | BindingFlags.NonPublic, null, argumentTypes, null) is MethodInfo method)
                    return method;
            return null;
        }

        void ISerializationCallbackReceiver.OnBeforeSerialize() { }
        void ISerializationCallbackReceiver.OnAfterDeserialize() { }

        internal void Add(Delegate call) => added.Add(call ?? throw new ArgumentNullException("action"));
        internal void Remove(Delegate call) => added.RemoveAll(c => c.Equals(call));

        /// <summary>Like in Unity, a listener that throws keeps the later ones from being called.</summary>
        internal void Call(Type[] types, params object[] arguments)
        {
            foreach (PersistentCall stored in m_PersistentCalls.m_Calls.ToArray())
                stored.Call(this, types, arguments);
            foreach (Delegate call in added.ToArray())
                if (!(call.Target is Object target) || Object.IsAlive(target) || call.Method.IsStatic)
                    Invoke(() => call.DynamicInvoke(arguments));
        }

        internal static void Invoke(Action call)
        {
            try
            {
                call();
            }
            catch (TargetInvocationException e)
            {
                System.Runtime.ExceptionServices.ExceptionDispatchInfo.Capture(e.InnerException ?? e).Throw();
            }
        }
    }

    /// <summary>The list as files hold it: m_PersistentCalls.m_Calls.</summary>
    [Serializable]
    internal sealed class PersistentCalls
    {
        [SerializeField] internal List<PersistentCall> m_Calls = new List<PersistentCall>();
    }

    /// <summary>A listener set in the inspector.</summary>
    [Serializable]
    internal sealed class PersistentCall
    {
        [SerializeField] internal Object m_Target;
        [SerializeField] internal string m_TargetAssemblyTypeName = "";
        [SerializeField] internal string m_MethodName = "";
        [SerializeField] internal PersistentListenerMode m_Mode;
        [SerializeField] internal PersistentArguments m_Arguments = new PersistentArguments();
        [SerializeField] internal UnityEventCallState m_CallState = UnityEventCallState.RuntimeOnly;

        internal void Call(UnityEventBase owner, Type[] types, object[] arguments)
        {
            if (m_CallState == UnityEventCallState.Off || !Object.IsAlive(m_Target) || m_MethodName.Length == 0)
                return;
            switch (m_Mode)
            {
                case PersistentListenerMode.Void: types = Type.EmptyTypes; arguments = null; break;
                case PersistentListenerMode.Object: types = new[] { ObjectType() }; arguments = new object[] { m_Arguments.m_ObjectArgument }; break;
                case PersistentListenerMode.Int: types = new[] { typeof(int) }; arguments = new object[] { m_Arguments.m_IntArgument }; break;
                case PersistentListenerMode.Float: types = new[] { typeof(float) }; arguments = new object[] { m_Arguments.m_FloatArgument }; break;
                case PersistentListenerMode.String: types = new[] { typeof(string) };
                    arguments = new object[] { m_Arguments.m_StringArgument }; break;
                case PersistentListenerMode.Bool: types = new[] { typeof(bool) }; arguments = new object[] { m_Arguments.m_BoolArgument }; break;
            }
            MethodInfo method = UnityEventBase.GetValidMethodInfo(m_Target, m_MethodName, types);
            // Unity passes over a method that has gone; here that would hide a broken scene.
            if (method == null)
                Debug.LogWarning($"{owner.GetType().Name}: '{m_Target.name}' ({m_Target.GetType().Name}) has no method " +
                    $"{m_MethodName}({string.Join(", ", Array.ConvertAll(types, t => t.Name))}), so this listener is not called", m_Target);
            else
                UnityEventBase.Invoke(() => method.Invoke(m_Target, arguments));
        }

        /// <summary>The parameter's type as stored, "UnityEngine.Material, UnityEngine.CoreModule"; of the engine's the assembly is another
        /// here.</summary>
        Type ObjectType()
        {
            string name = m_Arguments.m_ObjectArgumentAssemblyTypeName ?? "";
            return Type.GetType(name) ?? typeof(Object).Assembly.GetType(name.Split(',')[0])
                ?? m_Target.GetType().Assembly.GetType(name.Split(',')[0]) ?? typeof(Object);
        }
    }

    [Serializable]
    internal sealed class PersistentArguments
    {
        [SerializeField] internal Object m_ObjectArgument;
        [SerializeField] internal string m_ObjectArgumentAssemblyTypeName = "";
        [SerializeField] internal int m_IntArgument;
        [SerializeField] internal float m_FloatArgument;
        [SerializeField] internal string m_StringArgument = "";
        [SerializeField] internal bool m_BoolArgument;
    }
}
