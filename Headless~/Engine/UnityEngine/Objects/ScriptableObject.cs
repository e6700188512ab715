using System;
using UnityEngine.Headless;

namespace UnityEngine
{
    public class ScriptableObject : Object
    {
        [NonSerialized] internal bool Awoken, Enabled;

        public ScriptableObject()
        {
            if (!ObjectFactory.Constructing)
                Debug.LogWarning($"{GetType().Name} must be instantiated using the ScriptableObject.CreateInstance method instead of " +
                    $"new {GetType().Name}.");
        }

        public static T CreateInstance<T>() where T : ScriptableObject => (T)CreateInstance(typeof(T));

        public static ScriptableObject CreateInstance(string className)
        {
            foreach (var assembly in AppDomain.CurrentDomain.GetAssemblies())
                if (assembly.GetType(className) is Type type)
                    return CreateInstance(type);
            Debug.LogWarning($"Instance of {className} couldn't be created because there is no script with that name.");
            return null;
        }

        public static ScriptableObject CreateInstance(Type type)
        {
            if (type == null || !typeof(ScriptableObject).IsAssignableFrom(type) || type.IsAbstract)
                throw new ArgumentException(
                    $"ScriptableObject.CreateInstance: {type?.FullName ?? "null"} is not a ScriptableObject that can be created.",
                    nameof(type));
            ScriptableObject made = ObjectFactory.CreateScriptableObject(type);
            Lifecycle.Wake(made);
            return made;
        }

        internal override Object CloneNative()
        {
            ScriptableObject copy = ObjectFactory.CreateScriptableObject(GetType());
            SerializedCopy.Into(this, copy, null);
            Lifecycle.Wake(copy);
            return copy;
        }
    }
}
