using System.Collections.Generic;

namespace UnityEngine.Pool
{
    /// <summary>Collections to borrow; they come back empty.</summary>
    public class CollectionPool<TCollection, TItem> where TCollection : class, ICollection<TItem>, new()
    {
        static readonly ObjectPool<TCollection> pool = new ObjectPool<TCollection>(() => new TCollection(), null, collection => collection.Clear());
        public static TCollection Get() => pool.Get();
        public static PooledObject<TCollection> Get(out TCollection value) => pool.Get(out value);
        public static void Release(TCollection toRelease) => pool.Release(toRelease);
    }

    public class ListPool<T> : CollectionPool<List<T>, T> { }
    public class HashSetPool<T> : CollectionPool<HashSet<T>, T> { }
    public class DictionaryPool<TKey, TValue> : CollectionPool<Dictionary<TKey, TValue>, KeyValuePair<TKey, TValue>> { }

    public class GenericPool<T> where T : class, new()
    {
        static readonly ObjectPool<T> pool = new ObjectPool<T>(() => new T());
        public static T Get() => pool.Get();
        public static PooledObject<T> Get(out T value) => pool.Get(out value);
        public static void Release(T toRelease) => pool.Release(toRelease);
    }

    /// <summary>Without the check that nothing is given back twice.</summary>
    public class UnsafeGenericPool<T> where T : class, new()
    {
        static readonly ObjectPool<T> pool = new ObjectPool<T>(() => new T(), collectionCheck: false);
        public static T Get() => pool.Get();
        public static PooledObject<T> Get(out T value) => pool.Get(out value);
        public static void Release(T toRelease) => pool.Release(toRelease);
    }
}
