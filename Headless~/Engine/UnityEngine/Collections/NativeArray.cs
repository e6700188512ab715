using System;
using System.Collections;
using System.Collections.Generic;
using System.Runtime.CompilerServices;
using Unity.Collections.LowLevel.Unsafe;
using UnityEngine.Headless;

namespace Unity.Collections
{
    public enum Allocator { Invalid = 0, None = 1, Temp = 2, TempJob = 3, Persistent = 4, AudioKernel = 5, FirstUserIndex = 64 }
    public enum NativeArrayOptions { UninitializedMemory = 0, ClearMemory = 1 }

    /// <summary>Copies of the struct refer to one memory; disposing of any invalidates all, and their use throws.</summary>
    public unsafe struct NativeArray<T> : IDisposable, IEnumerable<T>, IEquatable<NativeArray<T>> where T : struct
    {
        internal void* m_Buffer;
        internal int m_Length;
        internal Allocator m_AllocatorLabel;
        internal SafetyHandle m_Safety;

        public NativeArray(int length, Allocator allocator, NativeArrayOptions options = NativeArrayOptions.ClearMemory)
        {
            if (length < 0)
                throw new ArgumentOutOfRangeException(nameof(length), "Length must be >= 0");
            if (RuntimeHelpers.IsReferenceOrContainsReferences<T>())
                throw new InvalidOperationException($"{typeof(T)} used in NativeArray<{typeof(T)}> must be unmanaged (contain no managed types).");
            m_Buffer = NativeMemory.Allocate((long)length * UnsafeUtility.SizeOf<T>(), allocator, options == NativeArrayOptions.ClearMemory,
                $"{typeof(T).Name}[{length}]", out m_Safety);
            m_Length = length;
            m_AllocatorLabel = allocator;
        }

        public NativeArray(T[] array, Allocator allocator) : this(NotNull(array).Length, allocator, NativeArrayOptions.UninitializedMemory)
            => CopyFrom(array);
        public NativeArray(NativeArray<T> array, Allocator allocator)
            : this(array.Length, allocator, NativeArrayOptions.UninitializedMemory) => CopyFrom(array);

        static T[] NotNull(T[] array) => array ?? throw new ArgumentNullException(nameof(array));

        /// <summary>Over memory that somebody else owns; a default handle is never checked.</summary>
        internal static NativeArray<T> View(void* memory, int length, Allocator allocator, SafetyHandle safety)
        {
            NativeArray<T> view = default;
            view.m_Buffer = memory;
            view.m_Length = length;
            view.m_AllocatorLabel = allocator;
            view.m_Safety = safety;
            return view;
        }

        public int Length => m_Length;
        public bool IsCreated => m_Buffer != null;

        public T this[int index]
        {
            get => UnsafeUtility.AsRef<T>(At(index));
            set => UnsafeUtility.AsRef<T>(At(index)) = value;
        }

        void* At(int index)
        {
            Check();
            if ((uint)index >= (uint)m_Length)
                throw new IndexOutOfRangeException($"Index {index} is out of range of '{m_Length}' Length.");
            return (byte*)m_Buffer + (long)index * UnsafeUtility.SizeOf<T>();
        }

        internal readonly void Check()
        {
            if (m_Buffer == null)
                throw new NullReferenceException($"The NativeArray<{typeof(T).Name}> has not been allocated.");
            if (!NativeMemory.IsValid(m_Safety))
                throw new ObjectDisposedException($"NativeArray<{typeof(T).Name}>",
                    $"The NativeArray<{typeof(T).Name}> has been deallocated, it is not allowed to access it.");
        }

        public void Dispose()
        {
            if (m_Buffer == null)
                throw new ObjectDisposedException($"NativeArray<{typeof(T).Name}>", "The NativeArray is already disposed.");
            if (m_AllocatorLabel <= Allocator.None)
                throw new InvalidOperationException("The NativeArray can not be Disposed because it was not allocated with a valid allocator.");
            Check();
            NativeMemory.Close(m_Safety);
            m_Buffer = null;
            m_Length = 0;
        }

        public readonly Span<T> AsSpan()
        {
            if (m_Length == 0 && m_Buffer == null)
                return default;
            Check();
            return new Span<T>(m_Buffer, m_Length);
        }

        public readonly ReadOnlySpan<T> AsReadOnlySpan() => AsSpan();
        public static implicit operator Span<T>(in NativeArray<T> source) => source.AsSpan();
        public static implicit operator ReadOnlySpan<T>(in NativeArray<T> source) => source.AsSpan();

        public T[] ToArray() => AsSpan().ToArray();
        public void CopyFrom(T[] array) => Copy(array, this);
        public void CopyFrom(NativeArray<T> array) => Copy(array, this);
        public void CopyTo(T[] array) => Copy(this, array);
        public void CopyTo(NativeArray<T> array) => Copy(this, array);

        public NativeArray<T> GetSubArray(int start, int length)
        {
            Check();
            if (start < 0 || length < 0 || start + (long)length > m_Length)
                throw new ArgumentOutOfRangeException(nameof(length),
                    $"sub array range {start}-{start + (long)length - 1} is outside the range of the native array 0-{m_Length - 1}");
            return View((byte*)m_Buffer + (long)start * UnsafeUtility.SizeOf<T>(), length, Allocator.None, m_Safety);
        }

        public NativeArray<U> Reinterpret<U>() where U : struct
        {
            Check();
            if (UnsafeUtility.SizeOf<T>() != UnsafeUtility.SizeOf<U>())
                throw new InvalidOperationException($"Types {typeof(T)} and {typeof(U)} are different sizes - direct reinterpretation " +
                    $"is not possible. If this is what you intended, use Reinterpret(<type size>)");
            return NativeArray<U>.View(m_Buffer, m_Length, m_AllocatorLabel, m_Safety);
        }

        public NativeArray<U> Reinterpret<U>(int expectedTypeSize) where U : struct
        {
            Check();
            int size = UnsafeUtility.SizeOf<T>();
            if (expectedTypeSize != size)
                throw new InvalidOperationException($"Type {typeof(T)} was expected to be {expectedTypeSize} but is {size} bytes");
            long bytes = (long)m_Length * size, target = UnsafeUtility.SizeOf<U>();
            if (bytes % target != 0)
                throw new InvalidOperationException($"Types {typeof(T)} (array length {m_Length}) and {typeof(U)} cannot be aliased " +
                    $"due to size constraints. The size of the types and lengths involved must line up.");
            return NativeArray<U>.View(m_Buffer, (int)(bytes / target), m_AllocatorLabel, m_Safety);
        }

        public U ReinterpretLoad<U>(int sourceIndex) where U : struct
        {
            CheckBytes<U>(sourceIndex);
            return UnsafeUtility.AsRef<U>(At(sourceIndex));
        }

        public void ReinterpretStore<U>(int destIndex, U data) where U : struct
        {
            CheckBytes<U>(destIndex);
            UnsafeUtility.AsRef<U>(At(destIndex)) = data;
        }

        void CheckBytes<U>(int index) where U : struct
        {
            if ((long)index * UnsafeUtility.SizeOf<T>() + UnsafeUtility.SizeOf<U>() > (long)m_Length * UnsafeUtility.SizeOf<T>())
                throw new ArgumentOutOfRangeException(nameof(index),
                    $"A {typeof(U).Name} at element {index} reaches past the array's {m_Length} elements.");
        }

        public ReadOnly AsReadOnly() => new ReadOnly(this);

        // ---- copies between arrays of any kind: lengths must be equal unless one is given
        public static void Copy(NativeArray<T> src, NativeArray<T> dst) => Same(src.AsSpan(), dst.AsSpan());
        public static void Copy(ReadOnly src, NativeArray<T> dst) => Same(src.AsReadOnlySpan(), dst.AsSpan());
        public static void Copy(T[] src, NativeArray<T> dst) => Same(NotNull(src), dst.AsSpan());
        public static void Copy(NativeArray<T> src, T[] dst) => Same(src.AsSpan(), NotNull(dst));
        public static void Copy(ReadOnly src, T[] dst) => Same(src.AsReadOnlySpan(), NotNull(dst));
        public static void Copy(NativeArray<T> src, NativeArray<T> dst, int length) => Part(src.AsSpan(), 0, dst.AsSpan(), 0, length);
        public static void Copy(ReadOnly src, NativeArray<T> dst, int length) => Part(src.AsReadOnlySpan(), 0, dst.AsSpan(), 0, length);
        public static void Copy(T[] src, NativeArray<T> dst, int length) => Part(NotNull(src), 0, dst.AsSpan(), 0, length);
        public static void Copy(NativeArray<T> src, T[] dst, int length) => Part(src.AsSpan(), 0, NotNull(dst), 0, length);
        public static void Copy(ReadOnly src, T[] dst, int length) => Part(src.AsReadOnlySpan(), 0, NotNull(dst), 0, length);
        public static void Copy(NativeArray<T> src, int srcIndex, NativeArray<T> dst, int dstIndex, int length)
            => Part(src.AsSpan(), srcIndex, dst.AsSpan(), dstIndex, length);
        public static void Copy(ReadOnly src, int srcIndex, NativeArray<T> dst, int dstIndex, int length)
            => Part(src.AsReadOnlySpan(), srcIndex, dst.AsSpan(), dstIndex, length);
        public static void Copy(T[] src, int srcIndex, NativeArray<T> dst, int dstIndex, int length)
            => Part(NotNull(src), srcIndex, dst.AsSpan(), dstIndex, length);
        public static void Copy(NativeArray<T> src, int srcIndex, T[] dst, int dstIndex, int length)
            => Part(src.AsSpan(), srcIndex, NotNull(dst), dstIndex, length);
        public static void Copy(ReadOnly src, int srcIndex, T[] dst, int dstIndex, int length)
            => Part(src.AsReadOnlySpan(), srcIndex, NotNull(dst), dstIndex, length);

        static void Same(ReadOnlySpan<T> from, Span<T> to)
        {
            if (from.Length != to.Length)
                throw new ArgumentException($"source and destination length must be the same ({from.Length} and {to.Length})");
            from.CopyTo(to);
        }

        static void Part(ReadOnlySpan<T> from, int fromIndex, Span<T> to, int toIndex, int length)
        {
            if (length < 0)
                throw new ArgumentOutOfRangeException(nameof(length), "length must be equal or greater than zero.");
            if (fromIndex < 0 || fromIndex + (long)length > from.Length)
                throw new ArgumentException(
                    $"length {length} from index {fromIndex} is greater than the number of elements in the source ({from.Length}).",
                    nameof(length));
            if (toIndex < 0 || toIndex + (long)length > to.Length)
                throw new ArgumentException(
                    $"length {length} at index {toIndex} is greater than the number of elements in the destination ({to.Length}).",
                    nameof(length));
            from.Slice(fromIndex, length).CopyTo(to.Slice(toIndex));
        }

        public bool Equals(NativeArray<T> other) => m_Buffer == other.m_Buffer && m_Length == other.m_Length;
        public override bool Equals(object obj) => obj is NativeArray<T> other && Equals(other);
        public override int GetHashCode() => HashCode.Combine((long)m_Buffer, m_Length);
        public static bool operator ==(NativeArray<T> left, NativeArray<T> right) => left.Equals(right);
        public static bool operator !=(NativeArray<T> left, NativeArray<T> right) => !left.Equals(right);

        public Enumerator GetEnumerator() => new Enumerator(ref this);
        IEnumerator<T> IEnumerable<T>.GetEnumerator() => new Enumerator(ref this);
        IEnumerator IEnumerable.GetEnumerator() => new Enumerator(ref this);

        public struct Enumerator : IEnumerator<T>
        {
            NativeArray<T> array;
            int index;

            public Enumerator(ref NativeArray<T> array) { this.array = array; index = -1; }

            public T Current => array[index];
            object IEnumerator.Current => Current;
            public bool MoveNext() => ++index < array.Length;
            public void Reset() => index = -1;
            public void Dispose() { }
        }

        public struct ReadOnly : IEnumerable<T>
        {
            internal NativeArray<T> array;
            internal ReadOnly(NativeArray<T> array) { this.array = array; }

            public int Length => array.Length;
            public bool IsCreated => array.IsCreated;
            public T this[int index] => array[index];
            public T[] ToArray() => array.ToArray();
            public void CopyTo(T[] array) => this.array.CopyTo(array);
            public void CopyTo(NativeArray<T> array) => this.array.CopyTo(array);
            public NativeArray<U>.ReadOnly Reinterpret<U>() where U : struct => array.Reinterpret<U>().AsReadOnly();
            public readonly ReadOnlySpan<T> AsReadOnlySpan() => array.AsReadOnlySpan();
            public static implicit operator ReadOnlySpan<T>(in ReadOnly source) => source.AsReadOnlySpan();

            public Enumerator GetEnumerator() => new Enumerator(this);
            IEnumerator<T> IEnumerable<T>.GetEnumerator() => GetEnumerator();
            IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

            public struct Enumerator : IEnumerator<T>
            {
                ReadOnly array;
                int index;

                public Enumerator(in ReadOnly array) { this.array = array; index = -1; }

                public T Current => array[index];
                object IEnumerator.Current => Current;
                public bool MoveNext() => ++index < array.Length;
                public void Reset() => index = -1;
                public void Dispose() { }
            }
        }
    }
}
