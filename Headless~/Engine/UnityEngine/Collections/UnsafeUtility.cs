using System;
using System.Reflection;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using UnityEngine.Headless;

namespace Unity.Collections.LowLevel.Unsafe
{
    public static unsafe class UnsafeUtility
    {
        // the span is measured, never read
        public static int SizeOf<T>() where T : struct => MemoryMarshal.AsBytes(new Span<T>((void*)16, 1)).Length;
        public static int SizeOf(Type type) => (int)Array.Find(typeof(UnsafeUtility).GetMethods(), m => m.Name == nameof(SizeOf)
            && m.IsGenericMethod).MakeGenericMethod(type).Invoke(null, null);

        public static int AlignOf<T>() where T : struct => SizeOf<AlignmentProbe<T>>() - SizeOf<T>();

        [StructLayout(LayoutKind.Sequential)]
        struct AlignmentProbe<T> where T : struct
        {
            public byte Shift;
            public T Data;
        }

        public static bool IsUnmanaged<T>() => !RuntimeHelpers.IsReferenceOrContainsReferences<T>();
        public static bool IsBlittable<T>() where T : struct => IsBlittable(typeof(T));
        public static bool IsUnmanaged(Type type)
            => (bool)typeof(RuntimeHelpers).GetMethod(nameof(RuntimeHelpers.IsReferenceOrContainsReferences)).MakeGenericMethod(type)
            .Invoke(null, null) == false;

        /// <summary>Unmanaged and without bool or char, whose size in native code is another matter.</summary>
        public static bool IsBlittable(Type type)
        {
            if (type == typeof(bool) || type == typeof(char) || !type.IsValueType)
                return false;
            if (type.IsPrimitive || type.IsEnum || type.IsPointer)
                return true;
            foreach (FieldInfo field in type.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic))
                if (!field.FieldType.IsPointer && !IsBlittable(field.FieldType))
                    return false;
            return true;
        }

        public static bool IsValidAllocator(Allocator allocator) => allocator > Allocator.None;
        public static int GetFieldOffset(FieldInfo field) => (int)Marshal.OffsetOf(field.DeclaringType, field.Name);

        public static void* Malloc(long size, int alignment, Allocator allocator)
        {
            // Aligned by hand, the raw pointer in front of the block.
            alignment = Math.Max(alignment, 16);
            byte* raw = (byte*)NativeMemory.Raw(size + alignment + sizeof(void*));
            byte* block = (byte*)(((long)raw + sizeof(void*) + alignment - 1) / alignment * alignment);
            ((void**)block)[-1] = raw;
            return block;
        }

        public static void Free(void* memory, Allocator allocator)
        {
            if (memory != null)
                NativeMemory.FreeRaw(((void**)memory)[-1]);
        }

        public static void* MallocTracked(long size, int alignment, Allocator allocator, int callstacksToSkip) => Malloc(size, alignment, allocator);
        public static void FreeTracked(void* memory, Allocator allocator) => Free(memory, allocator);

        public static void MemCpy(void* destination, void* source, long size) => Buffer.MemoryCopy(source, destination, size, size);
        public static void MemMove(void* destination, void* source, long size) => Buffer.MemoryCopy(source, destination, size, size);
        public static void MemSet(void* destination, byte value, long size) => NativeMemory.Clear(destination, size, value);
        public static void MemClear(void* destination, long size) => NativeMemory.Clear(destination, size, 0);

        public static int MemCmp(void* ptr1, void* ptr2, long size)
        {
            byte* a = (byte*)ptr1, b = (byte*)ptr2;
            for (long i = 0; i < size; i++)
                if (a[i] != b[i])
                    return a[i] < b[i] ? -1 : 1;
            return 0;
        }

        public static void MemCpyReplicate(void* destination, void* source, int size, int count)
        {
            for (long i = 0; i < count; i++)
                MemCpy((byte*)destination + i * size, source, size);
        }

        public static void MemCpyStride(void* destination, int destinationStride, void* source, int sourceStride, int elementSize, int count)
        {
            for (long i = 0; i < count; i++)
                MemCpy((byte*)destination + i * destinationStride, (byte*)source + i * sourceStride, elementSize);
        }

        public static T ReadArrayElement<T>(void* source, int index) => new Span<T>(source, index + 1)[index];
        public static T ReadArrayElementWithStride<T>(void* source, int index, int stride) => Ref<T>((byte*)source + (long)index * stride);
        public static void WriteArrayElement<T>(void* destination, int index, T value) => new Span<T>(destination, index + 1)[index] = value;
        public static void WriteArrayElementWithStride<T>(void* destination, int index, int stride, T value)
            => Ref<T>((byte*)destination + (long)index * stride) = value;
        public static void CopyPtrToStructure<T>(void* ptr, out T output) where T : struct => output = Ref<T>(ptr);
        public static void CopyStructureToPtr<T>(ref T input, void* ptr) where T : struct => Ref<T>(ptr) = input;
        public static ref T AsRef<T>(void* ptr) where T : struct => ref Ref<T>(ptr);
        public static ref T ArrayElementAsRef<T>(void* ptr, int index) where T : struct => ref Ref<T>((byte*)ptr + (long)index * SizeOf<T>());

        static ref T Ref<T>(void* ptr) => ref MemoryMarshal.GetReference(new Span<T>(ptr, 1));

        /// <summary>Address of something that does not move: a local, a field of one, unmanaged memory.</summary>
        public static void* AddressOf<T>(ref T output) where T : struct
        {
            fixed (byte* address = MemoryMarshal.AsBytes(MemoryMarshal.CreateSpan(ref output, 1)))
                return address;
        }

        public static int EnumToInt<T>(T enumValue) where T : struct, IConvertible => enumValue.ToInt32(null);
        public static bool EnumEquals<T>(T lhs, T rhs) where T : struct, IConvertible => lhs.Equals(rhs);

        public static void* PinGCArrayAndGetDataAddress(Array target, out ulong gcHandle)
        {
            GCHandle pin = GCHandle.Alloc(target, GCHandleType.Pinned);
            gcHandle = (ulong)GCHandle.ToIntPtr(pin).ToInt64();
            return pin.AddrOfPinnedObject().ToPointer();
        }

        public static void ReleaseGCObject(ulong gcHandle) => GCHandle.FromIntPtr(new IntPtr((long)gcHandle)).Free();
    }

    public static unsafe class NativeArrayUnsafeUtility
    {
        /// <summary>The caller keeps owning the memory.</summary>
        public static NativeArray<T> ConvertExistingDataToNativeArray<T>(void* dataPointer, int length, Allocator allocator) where T : struct
            => NativeArray<T>.View(dataPointer, length, allocator, default);

        public static void* GetUnsafePtr<T>(this NativeArray<T> nativeArray) where T : struct
        {
            nativeArray.Check();
            return nativeArray.m_Buffer;
        }

        public static void* GetUnsafeReadOnlyPtr<T>(this NativeArray<T> nativeArray) where T : struct => nativeArray.GetUnsafePtr();
        public static void* GetUnsafeReadOnlyPtr<T>(this NativeArray<T>.ReadOnly nativeArray) where T : struct => nativeArray.array.GetUnsafePtr();
        public static void* GetUnsafeBufferPointerWithoutChecks<T>(NativeArray<T> nativeArray) where T : struct => nativeArray.m_Buffer;
    }

    [AttributeUsage(AttributeTargets.Struct)] public sealed class NativeContainerAttribute : Attribute { }
    [AttributeUsage(AttributeTargets.Field)] public sealed class NativeDisableUnsafePtrRestrictionAttribute : Attribute { }
}

namespace Unity.Collections
{
    [AttributeUsage(AttributeTargets.Field | AttributeTargets.Parameter)] public sealed class ReadOnlyAttribute : Attribute { }
    [AttributeUsage(AttributeTargets.Field | AttributeTargets.Parameter)] public sealed class WriteOnlyAttribute : Attribute { }
}
