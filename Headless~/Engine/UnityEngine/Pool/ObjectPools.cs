using System;
using System.Collections.Generic;

namespace UnityEngine.Pool
{
    public interface IObjectPool<T> where T : class
    {
        int CountInactive { get; }
        T Get();
        PooledObject<T> Get(out T v);
        void Release(T element);
        void Clear();
    }

    /// <summary>Goes back to its pool at the end of a using block.</summary>
    public struct PooledObject<T> : IDisposable where T : class
    {
        readonly T value;
        readonly IObjectPool<T> pool;

        public PooledObject(T value, IObjectPool<T> pool)
        {
            this.value = value;
            this.pool = pool;
        }

        void IDisposable.Dispose() => pool.Release(value);
    }

    public class ObjectPool<T> : IDisposable, IObjectPool<T> where T : class
    {
        readonly List<T> idle;
        readonly Func<T> create;
        readonly Action<T> onGet, onRelease, onDestroy;
        readonly bool check;
        readonly int most;

        public ObjectPool(Func<T> createFunc, Action<T> actionOnGet = null, Action<T> actionOnRelease = null,
            Action<T> actionOnDestroy = null, bool collectionCheck = true, int defaultCapacity = 10, int maxSize = 10000)
        {
            create = createFunc ?? throw new ArgumentNullException(nameof(createFunc));
            if (maxSize <= 0)
                throw new ArgumentException("Max Size must be greater than 0", nameof(maxSize));
            idle = new List<T>(defaultCapacity);
            onGet = actionOnGet;
            onRelease = actionOnRelease;
            onDestroy = actionOnDestroy;
            check = collectionCheck;
            most = maxSize;
        }

        public int CountAll { get; private set; }
        public int CountActive => CountAll - CountInactive;
        public int CountInactive => idle.Count;

        public T Get()
        {
            T element;
            if (idle.Count == 0)
            {
                element = create();
                CountAll++;
            }
            else
            {
                element = idle[idle.Count - 1];
                idle.RemoveAt(idle.Count - 1);
            }
            onGet?.Invoke(element);
            return element;
        }

        public PooledObject<T> Get(out T v) => new PooledObject<T>(v = Get(), this);

        public void Release(T element)
        {
            if (check && idle.Contains(element))
                throw new InvalidOperationException("Trying to release an object that has already been released to the pool.");
            onRelease?.Invoke(element);
            if (idle.Count < most)
                idle.Add(element);
            else
            {
                CountAll--;
                onDestroy?.Invoke(element);
            }
        }

        public void Clear()
        {
            if (onDestroy != null)
                foreach (T element in idle)
                    onDestroy(element);
            idle.Clear();
            CountAll = 0;
        }

        public void Dispose() => Clear();
    }

    public class LinkedPool<T> : IDisposable, IObjectPool<T> where T : class
    {
        readonly ObjectPool<T> pool;

        public LinkedPool(Func<T> createFunc, Action<T> actionOnGet = null, Action<T> actionOnRelease = null,
            Action<T> actionOnDestroy = null, bool collectionCheck = true, int maxSize = 10000)
            => pool = new ObjectPool<T>(createFunc, actionOnGet, actionOnRelease, actionOnDestroy, collectionCheck, 0, maxSize);

        public int CountInactive => pool.CountInactive;
        public T Get() => pool.Get();
        public PooledObject<T> Get(out T v) => new PooledObject<T>(v = Get(), this);
        public void Release(T item) => pool.Release(item);
        public void Clear() => pool.Clear();
        public void Dispose() => pool.Dispose();
    }
}
