using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;

namespace UnityEngine.Headless
{
    /// <summary>Calls into scripts that the engine holds: a domain that goes takes them along.</summary>
    internal static class ScriptCallbacks
    {
        const BindingFlags Own = BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;

        static readonly Dictionary<Type, FieldInfo[]> ofInstances = new Dictionary<Type, FieldInfo[]>();

        /// <summary>Takes scripts out of the events of the engine's classes and objects, and of read-backs that are pending; ends their
        /// coroutines and timed calls.</summary>
        public static void Drop()
        {
            foreach (FieldInfo field in AppDomain.CurrentDomain.GetAssemblies().Where(a => !a.IsDynamic && ScriptAssemblies.IsEngines(a))
                .SelectMany(assembly => assembly.GetTypes()).Where(type => !type.ContainsGenericParameters)
                .SelectMany(type => CallbacksOf(type, BindingFlags.Static)))
                Strip(field, null);
            foreach (Object o in ObjectRegistry.All(typeof(Object)))
            {
                if (o is MonoBehaviour script && !ScriptAssemblies.IsEngines(o.GetType().Assembly))
                {
                    script.StopAllCoroutines();
                    script.CancelInvoke();
                }
                for (Type type = o.GetType(); type != typeof(object); type = type.BaseType)
                    if (ScriptAssemblies.IsEngines(type.Assembly))
                    {
                        if (!ofInstances.TryGetValue(type, out FieldInfo[] fields))
                            ofInstances.Add(type, fields = CallbacksOf(type, BindingFlags.Instance));
                        foreach (FieldInfo field in fields)
                            Strip(field, o);
                    }
            }
            ReadbackQueue.DropCallbacks(IsOfScripts);
        }

        static FieldInfo[] CallbacksOf(Type type, BindingFlags which)
            => type.GetFields(Own | which).Where(field => typeof(Delegate).IsAssignableFrom(field.FieldType) && !field.IsInitOnly).ToArray();

        static void Strip(FieldInfo field, object owner)
        {
            if (!(field.GetValue(owner) is Delegate all))
                return;
            Delegate left = all;
            foreach (Delegate one in all.GetInvocationList())
                if (IsOfScripts(one))
                    left = Delegate.Remove(left, one);
            if (!ReferenceEquals(left, all))
                field.SetValue(owner, left);
        }

        static bool IsOfScripts(Delegate callback)
            => ScriptAssemblies.IsOfScripts(callback.Method.Module.Assembly)
            || callback.Target is object target && ScriptAssemblies.IsOfScripts(target.GetType().Assembly);
    }
}
