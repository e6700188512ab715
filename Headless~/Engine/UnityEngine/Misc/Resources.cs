using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine.Headless;

namespace UnityEngine
{
    public sealed class Resources
    {
        public static Object Load(string path) => Load(path, typeof(Object));
        public static T Load<T>(string path) where T : Object => (T)Load(path, typeof(T));
        public static Object Load(string path, Type systemTypeInstance) => Player.Assets?.LoadResource(path, systemTypeInstance);
        public static Object[] LoadAll(string path) => LoadAll(path, typeof(Object));
        public static T[] LoadAll<T>(string path) where T : Object => LoadAll(path, typeof(T)).Cast<T>().ToArray();
        public static Object[] LoadAll(string path, Type systemTypeInstance)
            => Player.Assets?.LoadAllResources(path, systemTypeInstance).ToArray() ?? Array.Empty<Object>();
        public static ResourceRequest LoadAsync(string path) => LoadAsync(path, typeof(Object));
        public static ResourceRequest LoadAsync<T>(string path) where T : Object => LoadAsync(path, typeof(T));

        public static ResourceRequest LoadAsync(string path, Type type)
        {
            var request = new ResourceRequest { Loaded = Load(path, type) };
            request.Complete();
            return request;
        }

        /// <summary>Set by the part that owns the built-in meshes and textures: type and path, null when there is none.</summary>
        internal static Func<Type, string, Object> BuiltinResource;

        public static T GetBuiltinResource<T>(string path) where T : Object => (T)GetBuiltinResource(typeof(T), path);

        public static Object GetBuiltinResource(Type type, string path)
        {
            Object found = BuiltinResource?.Invoke(type, path);
            if (found is null)
                Debug.LogError($"The resource {path} could not be loaded from the resource file!");
            return found;
        }

        public static Object[] FindObjectsOfTypeAll(Type type) => ObjectRegistry.All(type).ToArray();
        public static T[] FindObjectsOfTypeAll<T>() where T : Object => ObjectRegistry.All(typeof(T)).Cast<T>().ToArray();
        public static Object InstanceIDToObject(int instanceID) => ObjectRegistry.Find(instanceID);
        public static bool InstanceIDIsValid(int instanceId) => Object.IsAlive(ObjectRegistry.Find(instanceId));

        /// <summary>Loaded assets stay with the host's asset database; nothing is unloaded.</summary>
        public static void UnloadAsset(Object assetToUnload) { }

        public static AsyncOperation UnloadUnusedAssets()
        {
            var operation = new AsyncOperation();
            operation.Complete();
            return operation;
        }
    }
}
