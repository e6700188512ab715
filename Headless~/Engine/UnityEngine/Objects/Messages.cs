using System;
using System.Collections;
using System.Collections.Generic;
using System.Reflection;

namespace UnityEngine.Headless
{
    /// <summary>Messages without parameters that the engine sends to scripts.</summary>
    internal enum Message
    {
        Awake, OnEnable, Start, FixedUpdate, Update, LateUpdate, OnDisable, OnDestroy, OnValidate,
        OnApplicationQuit, OnPreCull, OnPreRender, OnPostRender, OnRenderObject, OnWillRenderObject, OnBecameVisible, OnBecameInvisible,
    }

    /// <summary>Calls scripts' methods by name, private ones included. An exception is logged with its script and goes no further.</summary>
    internal static class Messages
    {
        const BindingFlags Any = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;
        static readonly string[] names = Enum.GetNames(typeof(Message));
        static readonly Dictionary<Type, Action<object>[]> tables = new Dictionary<Type, Action<object>[]>();

        public static bool Has(Type type, Message message) => Table(type)[(int)message] != null;

        /// <summary>False when the script has no such method.</summary>
        public static bool Send(Object target, Message message)
        {
            Action<object> call = Table(target.GetType())[(int)message];
            if (call == null)
                return false;
            try
            {
                call(target);
            }
            catch (Exception e)
            {
                Debug.LogException(e, target);
            }
            return true;
        }

        /// <summary>The most derived declaration of that name, whatever its parameters; null when there is none.</summary>
        public static MethodInfo Find(Type type, string name, params Type[] parameters)
        {
            for (Type t = type; t != null && t.Assembly != typeof(Messages).Assembly; t = t.BaseType)
                if (t.GetMethod(name, Any, null, parameters, null) is MethodInfo method)
                    return method;
            return null;
        }

        /// <summary>Calls by name with no or one argument; false without a fitting method.</summary>
        public static bool Call(Object target, string name, object value, out object result)
        {
            result = null;
            for (Type t = target.GetType(); t != null && t.Assembly != typeof(Messages).Assembly; t = t.BaseType)
                foreach (MethodInfo method in t.GetMethods(Any))
                {
                    if (method.Name != name || method.ContainsGenericParameters)
                        continue;
                    ParameterInfo[] parameters = method.GetParameters();
                    if (parameters.Length > 1 || parameters.Length == 1 && !Fits(parameters[0].ParameterType, value))
                        continue;
                    result = Invoke(target, method, parameters.Length == 0 ? null : new[] { value });
                    return true;
                }
            return false;
        }

        static bool Fits(Type type, object value) => value == null ? !type.IsValueType : type.IsInstanceOfType(value);

        /// <summary>Logs what the method throws and returns null then.</summary>
        public static object Invoke(Object target, MethodInfo method, params object[] arguments)
        {
            try
            {
                return method.Invoke(target, arguments);
            }
            catch (TargetInvocationException e)
            {
                Debug.LogException(e.InnerException ?? e, target);
                return null;
            }
        }

        /// <summary>To every script of the object, as SendMessage; whether any had the method. An IEnumerator runs as a coroutine.</summary>
        public static bool Broadcast(GameObject go, string name, object value)
        {
            bool received = false;
            if (!go.activeInHierarchy)
                return false;
            foreach (Component component in go.Components.ToArray())
                if (component is MonoBehaviour script && !script.Destroyed && EditMode.Runs(script)
                    && Call(script, name, value, out object result))
                {
                    received = true;
                    if (result is IEnumerator routine)
                        script.StartCoroutine(routine);
                }
            return received;
        }

        static Action<object>[] Table(Type type)
        {
            if (tables.TryGetValue(type, out Action<object>[] table))
                return table;
            table = new Action<object>[names.Length];
            for (int i = 0; i < names.Length; i++)
                if (Find(type, names[i]) is MethodInfo method)
                    table[i] = Compile(method);
            tables.Add(type, table);
            return table;
        }

        // Open delegates instead of MethodInfo.Invoke: updates run every frame, and exceptions keep their stack.
        static Action<object> Compile(MethodInfo method)
        {
            MethodInfo maker = typeof(Messages).GetMethod(method.ReturnType == typeof(void) ? nameof(Plain) : nameof(Routine),
                BindingFlags.Static | BindingFlags.NonPublic);
            if (method.ReturnType != typeof(void) && !typeof(IEnumerator).IsAssignableFrom(method.ReturnType))
                return target => method.Invoke(target, null);
            return (Action<object>)maker.MakeGenericMethod(method.DeclaringType).Invoke(null, new object[] { method });
        }

        static Action<object> Plain<T>(MethodInfo method) where T : class
        {
            var call = (Action<T>)method.CreateDelegate(typeof(Action<T>));
            return target => call((T)target);
        }

        // "IEnumerator Start()" runs as a coroutine.
        static Action<object> Routine<T>(MethodInfo method) where T : class
        {
            var call = (Func<T, IEnumerator>)method.CreateDelegate(typeof(Func<T, IEnumerator>));
            return target =>
            {
                IEnumerator routine = call((T)target);
                if (target is MonoBehaviour script && routine != null)
                    script.StartCoroutine(routine);
            };
        }
    }
}
