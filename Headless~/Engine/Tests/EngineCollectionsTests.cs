using System;
using System.Linq;
using NUnit.Framework;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using UnityEngine;
using UnityEngine.Headless;

namespace Host.Tests
{
    public class EngineCollectionsTests : EngineFixture
    {
        [Test]
        public void A_native_array_holds_what_is_written()
        {
            using (var array = new NativeArray<Vector3>(100003, Allocator.Persistent))
            {
                NativeArray<Vector3> same = array;
                Assert.That(array.All(v => v.Equals(Vector3.zero)));
                for (int i = 0; i < array.Length; i++)
                    same[i] = new Vector3(i, 2 * i, 3 * i);
                for (int i = 0; i < array.Length; i++)
                    Assert.That(array[i].Equals(new Vector3(i, 2 * i, 3 * i)));
            }
        }

        [Test]
        public void Use_after_dispose_throws_through_every_copy()
        {
            var array = new NativeArray<int>(4, Allocator.Persistent);
            NativeArray<int> copy = array, part = array.GetSubArray(1, 2);
            NativeArray<uint> other = array.Reinterpret<uint>();
            array.Dispose();
            Assert.That(array.IsCreated, Is.False);
            Assert.Throws<ObjectDisposedException>(() => _ = copy[0]);
            Assert.Throws<ObjectDisposedException>(() => copy[0] = 1);
            Assert.Throws<ObjectDisposedException>(() => _ = part[0]);
            Assert.Throws<ObjectDisposedException>(() => _ = other[0]);
            Assert.Throws<ObjectDisposedException>(() => copy.AsSpan());
            Assert.Throws<ObjectDisposedException>(() => copy.Dispose());
            Assert.Throws<ObjectDisposedException>(() => array.Dispose());
            // The slot is taken again: the old handles must not fit the new memory.
            using (new NativeArray<int>(4, Allocator.Persistent))
                Assert.Throws<ObjectDisposedException>(() => _ = copy[0]);
        }

        [Test]
        public void An_index_outside_is_refused_with_the_length()
        {
            using (var array = new NativeArray<int>(3, Allocator.Persistent))
            {
                Assert.That(Assert.Throws<IndexOutOfRangeException>(() => _ = array[3]).Message, Does.Contain("'3'"));
                Assert.Throws<IndexOutOfRangeException>(() => _ = array[-1]);
                Assert.Throws<ArgumentOutOfRangeException>(() => array.GetSubArray(2, 2));
                Assert.Throws<ArgumentException>(() => array.CopyFrom(new int[4]));
            }
            Assert.Throws<ArgumentOutOfRangeException>(() => new NativeArray<int>(-1, Allocator.Persistent));
            Assert.Throws<ArgumentException>(() => new NativeArray<int>(1, Allocator.None));
        }

        [Test]
        public void Uninitialized_memory_is_garbage()
        {
            using (var array = new NativeArray<int>(8, Allocator.Persistent, NativeArrayOptions.UninitializedMemory))
                Assert.That(array, Is.All.Not.EqualTo(0));
        }

        [Test]
        public void Parts_and_other_types_see_the_same_memory()
        {
            using (var array = new NativeArray<float>(new[] { 1f, 2f, 3f, 4f }, Allocator.Persistent))
            {
                NativeArray<float> part = array.GetSubArray(1, 2);
                part[0] = 20;
                Assert.That(array.ToArray(), Is.EqualTo(new[] { 1f, 20f, 3f, 4f }));
                Assert.That(array.Reinterpret<Vector2>(4)[1], Is.EqualTo(new Vector2(3, 4)));
                Assert.That(array.Reinterpret<uint>()[0], Is.EqualTo(0x3F800000));
                Assert.Throws<InvalidOperationException>(() => array.Reinterpret<Vector2>());
                Assert.Throws<InvalidOperationException>(() => array.Reinterpret<Vector3>(4));
                Assert.Throws<InvalidOperationException>(() => part.Dispose());
                var target = new float[6];
                NativeArray<float>.Copy(array, 2, target, 3, 2);
                Assert.That(target, Is.EqualTo(new[] { 0f, 0, 0, 3, 4, 0 }));
            }
        }

        [Test]
        public void Temporary_memory_ends_with_the_frame()
        {
            var array = new NativeArray<int>(4, Allocator.Temp);
            array[0] = 1;
            Frames(1);
            Assert.Throws<ObjectDisposedException>(() => _ = array[0]);
        }

        [Test]
        public void What_is_not_disposed_is_reported_by_name()
        {
            int before = LiveObjects.Count;
            var array = new NativeArray<float>(7, Allocator.Persistent);
            Assert.That(LiveObjects.Report().Last(), Is.EqualTo("NativeArray 'Single[7]'"));
            array.Dispose();
            Assert.That(LiveObjects.Count, Is.EqualTo(before));
        }

        struct Mixed { public byte a; public double b; public short c; }

        [Test]
        public unsafe void Sizes_alignments_and_copies_are_those_of_memory()
        {
            Assert.That(UnsafeUtility.SizeOf<Vector3>(), Is.EqualTo(12));
            Assert.That(UnsafeUtility.SizeOf(typeof(Matrix4x4)), Is.EqualTo(64));
            Assert.That(UnsafeUtility.SizeOf<Mixed>(), Is.EqualTo(24));
            Assert.That(UnsafeUtility.AlignOf<Mixed>(), Is.EqualTo(8));
            Assert.That(UnsafeUtility.IsBlittable<Vector3>());
            Assert.That(UnsafeUtility.IsBlittable<bool>(), Is.False);

            byte* memory = (byte*)UnsafeUtility.Malloc(64, 64, Allocator.Persistent);
            Assert.That((long)memory % 64, Is.EqualTo(0));
            UnsafeUtility.MemSet(memory, 0xAB, 64);
            UnsafeUtility.WriteArrayElement(memory, 3, 0x12345678);
            Assert.That(UnsafeUtility.ReadArrayElement<int>(memory, 3), Is.EqualTo(0x12345678));
            Assert.That(memory[11], Is.EqualTo(0xAB));
            Assert.That(memory[12], Is.EqualTo(0x78));
            Assert.That(UnsafeUtility.MemCmp(memory, memory + 1, 8), Is.EqualTo(0));
            UnsafeUtility.Free(memory, Allocator.Persistent);
        }
    }
}
