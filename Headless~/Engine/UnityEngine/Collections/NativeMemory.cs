using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using Unity.Collections;

namespace UnityEngine.Headless
{
    /// <summary>Refers to memory that may be given back while copies of a NativeArray still point to it. The default one is never checked.</summary>
    internal readonly struct SafetyHandle : IEquatable<SafetyHandle>
    {
        public readonly int Slot, Version;
        public SafetyHandle(int slot, int version) { Slot = slot; Version = version; }
        public bool Equals(SafetyHandle other) => Slot == other.Slot && Version == other.Version;
    }

    /// <summary>Unmanaged memory with an owner: who still holds some is told by LiveObjects, use after dispose throws.</summary>
    internal static unsafe class NativeMemory
    {
        sealed class Allocation
        {
            public int Version = 1;
            public void* Memory;
            public Allocator Allocator;
            public bool InUse;
        }

        const byte Garbage = 0xCD;

        // Slot 0 stands for "not checked".
        static readonly List<Allocation> slots = new List<Allocation> { new Allocation() };
        static readonly Stack<int> free = new Stack<int>();

        public static void* Allocate(long bytes, Allocator allocator, bool clear, string name, out SafetyHandle handle)
        {
            if (allocator <= Allocator.None)
                throw new ArgumentException("Allocator must be Temp, TempJob or Persistent", nameof(allocator));
            void* memory = Raw(bytes);
            if (clear)
                Clear(memory, bytes, 0);
            else if (Player.Strict)
                Clear(memory, bytes, Garbage);
            handle = Open(memory, allocator, name);
            return memory;
        }

        public static void* Raw(long bytes)
        {
            IntPtr memory = Marshal.AllocHGlobal(new IntPtr(Math.Max(bytes, 1)));
            return memory.ToPointer();
        }

        public static void FreeRaw(void* memory) => Marshal.FreeHGlobal(new IntPtr(memory));

        public static void Clear(void* memory, long bytes, byte value)
        {
            byte* at = (byte*)memory;
            for (; bytes > 0; bytes -= int.MaxValue, at += int.MaxValue)
                new Span<byte>(at, (int)Math.Min(bytes, int.MaxValue)).Fill(value);
        }

        /// <summary>For memory that somebody else frees (a read-back, a mapped buffer): valid until <see cref="Close"/>.</summary>
        public static SafetyHandle OpenView() => Open(null, Allocator.None, null);

        static SafetyHandle Open(void* memory, Allocator allocator, string name)
        {
            lock (slots)
            {
                int slot;
                if (free.Count > 0)
                    slot = free.Pop();
                else
                {
                    slot = slots.Count;
                    slots.Add(new Allocation());
                }
                Allocation allocation = slots[slot];
                allocation.Memory = memory;
                allocation.Allocator = allocator;
                allocation.InUse = true;
                if (allocator == Allocator.Persistent || allocator == Allocator.TempJob)
                    LiveObjects.Add(allocation, "NativeArray", name);
                return new SafetyHandle(slot, allocation.Version);
            }
        }

        public static bool IsValid(SafetyHandle handle)
            => handle.Slot == 0 || slots[handle.Slot].Version == handle.Version;

        /// <summary>Frees what it owns; every copy that holds the handle becomes invalid.</summary>
        public static void Close(SafetyHandle handle)
        {
            lock (slots)
            {
                if (handle.Slot == 0 || !IsValid(handle))
                    return;
                Allocation allocation = slots[handle.Slot];
                if (allocation.Memory != null)
                    FreeRaw(allocation.Memory);
                LiveObjects.Remove(allocation);
                allocation.Memory = null;
                allocation.InUse = false;
                allocation.Version++;
                free.Push(handle.Slot);
            }
        }

        /// <summary>At the end of a frame, as Unity rewinds its Temp allocator.</summary>
        public static void FreeTemporary()
        {
            for (int slot = 1; slot < slots.Count; slot++)
                if (slots[slot].InUse && slots[slot].Allocator == Allocator.Temp)
                    Close(new SafetyHandle(slot, slots[slot].Version));
        }
    }
}
