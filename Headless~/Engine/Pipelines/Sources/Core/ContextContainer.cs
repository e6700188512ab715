#if SRP_17
using System;
using System.Collections.Generic;

namespace UnityEngine.Rendering
{
    /// <summary>Data of a frame by type (SRP Core 17.1.0, Runtime/Utilities/ContextContainer.cs).</summary>
    public class ContextContainer : IDisposable
    {
        readonly Dictionary<Type, ContextItem> items = new Dictionary<Type, ContextItem>();

        public T Get<T>() where T : ContextItem, new() =>
            items.TryGetValue(typeof(T), out ContextItem item) ? (T)item
            : throw new InvalidOperationException($"Type {typeof(T).FullName} has not been created yet.");

        public T Create<T>() where T : ContextItem, new()
        {
            if (Contains<T>())
                throw new InvalidOperationException($"Type {typeof(T).FullName} has already been created.");
            var item = new T();
            items.Add(typeof(T), item);
            return item;
        }

        public T GetOrCreate<T>() where T : ContextItem, new() => Contains<T>() ? Get<T>() : Create<T>();
        public bool Contains<T>() where T : ContextItem, new() => items.ContainsKey(typeof(T));

        public void Dispose()
        {
            foreach (ContextItem item in items.Values)
                item.Reset();
            items.Clear();
        }
    }

    public abstract class ContextItem
    {
        public abstract void Reset();
    }
}
#endif
