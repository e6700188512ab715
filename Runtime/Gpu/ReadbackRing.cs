using System;
using System.Collections.Generic;
using Unity.Collections;
using UnityEngine;

namespace Rill
{
    /// <summary>Buffers of words that are filled and read back by turns, so that a request need not wait for the one before.</summary>
    sealed class ReadbackRing : IDisposable
    {
        readonly string name;
        readonly Readback[] slots;
        readonly long[] numbers;        // of the newest request of each slot
        long requests;

        /// <param name="name">Name of each buffer.</param>
        /// <param name="count">Buffers.</param>
        /// <param name="words">Number of words of each buffer.</param>
        /// <param name="arrived">Called with the slot of each answer that has come, in the order of the requests.</param>
        /// <param name="lost">Called with the slot of each request that ended with an error; may be null.</param>
        public ReadbackRing(string name, int count, int words, Action<int> arrived, Action<int> lost = null)
        {
            this.name = name;
            slots = new Readback[count];
            numbers = new long[count];
            for (int i = 0; i < count; i++)
            {
                int slot = i;
                slots[i] = new Readback(GpuBuffer.Structured<uint>(name, words))
                {
                    Arrived = () => arrived(slot),
                    Lost = () => lost?.Invoke(slot),
                };
            }
        }

        /// <summary>Notes from now on how requests end.</summary>
        /// <param name="to">Null to report to none.</param>
        /// <param name="what">One kind.</param>
        public void Report(ReadbackErrors to, ReadbackKinds what)
        {
            foreach (Readback slot in slots)
                slot.Report(to, what);
        }

        /// <summary>Slot of the next request; -1 while all are pending.</summary>
        /// <param name="except">A slot that is still read, or -1.</param>
        public int Free(int except = -1)
        {
            for (int i = 0; i < slots.Length; i++)
                if (i != except && !slots[i].IsPending)
                    return i;
            return -1;
        }

        /// <summary>Returns the buffer that a slot's answer is written into.</summary>
        public GraphicsBuffer Buffer(int slot) => slots[slot].Buffer;

        /// <summary>Asks for what was recorded for a slot, after its command buffer was executed.</summary>
        public void Request(int slot)
        {
            numbers[slot] = requests++;
            slots[slot].Request();
        }

        /// <summary>Takes words that a request of before a snapshot was to bring.</summary>
        /// <param name="slot">One without a request so far.</param>
        /// <param name="frames">Number of frames in which they come.</param>
        public void Resume(int slot, ReadOnlySpan<uint> words, int frames)
        {
            numbers[slot] = requests++;
            slots[slot].Resume(words, frames);
            if (frames == 0)
                slots[slot].TryFinishResumed();
        }

        /// <summary>Follows what is pending of a slot; null where nothing is.</summary>
        public ReadbackArrival Follow(int slot) => slots[slot].Follow();

        /// <summary>Lists the slots whose answers are pending, in the order of the requests.</summary>
        public void ListPending(List<int> pending)
        {
            for (int i = 0; i < slots.Length; i++)
                if (slots[i].IsPending)
                    pending.Add(i);
            pending.Sort((a, b) => numbers[a].CompareTo(numbers[b]));
        }

        /// <summary>Waits for the requests that are pending, and for no others; their answers are handed over in the order of the requests.</summary>
        public void Complete()
        {
            for (int i = 0; i < slots.Length; i++)
            {
                int oldest = -1;
                for (int slot = 0; slot < slots.Length; slot++)
                    if (slots[slot].IsPending && (oldest < 0 || numbers[slot] < numbers[oldest]))
                        oldest = slot;
                if (oldest < 0)
                    return;
                slots[oldest].Complete();
            }
        }

        /// <summary>The words that have come to a slot.</summary>
        public NativeArray<uint> Latest(int slot) => slots[slot].Latest;

        /// <summary>Answers from before this call are dropped when they come.</summary>
        public void Invalidate()
        {
            foreach (Readback slot in slots)
                slot.Invalidate();
        }

        public void Describe(StageDescription description)
        {
            foreach (Readback slot in slots)
                description.Buffer(name, slot.Buffer);
        }

        public void Dispose()
        {
            foreach (Readback slot in slots)
                slot?.Dispose();
        }
    }
}
