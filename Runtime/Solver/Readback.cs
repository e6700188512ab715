using System;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Brings a small buffer back without waiting: at most one on its way, and what was asked for before a reset is dropped.</summary>
    sealed class Readback : IDisposable
    {
        readonly Action<AsyncGPUReadbackRequest> onRead;
        NativeArray<uint> arriving, latest;
        int generation, pendingGeneration;
        bool disposed;

        /// <param name="words">Of the buffer.</param>
        public Readback(int words)
        {
            arriving = new NativeArray<uint>(words, Allocator.Persistent);
            latest = new NativeArray<uint>(words, Allocator.Persistent);
            onRead = OnRead;
        }

        /// <summary>Called when a result has come.</summary>
        public Action Arrived;

        /// <summary>Whether a result is on its way.</summary>
        public bool IsPending { get; private set; }

        /// <summary>Whether <see cref="Latest"/> holds a result of the time since the last <see cref="Forget"/>.</summary>
        public bool HasResult { get; private set; }

        public NativeArray<uint> Latest => latest;

        /// <summary>Asks for the buffer as the commands executed so far leave it. Nothing while a result is under way.</summary>
        public void Request(GraphicsBuffer buffer)
        {
            if (IsPending)
                return;
            IsPending = true;
            pendingGeneration = generation;
            AsyncGPUReadback.RequestIntoNativeArray(ref arriving, buffer, onRead);
        }

        /// <summary>Results from before this call are dropped when they come.</summary>
        public void Forget()
        {
            generation++;
            HasResult = false;
        }

        /// <summary>Words that are 0 from now on; what is on its way may not know yet and is dropped.</summary>
        public void Zero(int first, int count)
        {
            generation++;
            for (int word = first; word < first + count; word++)
                latest[word] = 0;
        }

        public void Dispose()
        {
            disposed = true;
            if (IsPending)
                AsyncGPUReadback.WaitAllRequests();     // it writes into memory that is about to go
            arriving.Dispose();
            latest.Dispose();
        }

        void OnRead(AsyncGPUReadbackRequest request)
        {
            IsPending = false;
            if (disposed || request.hasError || pendingGeneration != generation)
                return;
            latest.CopyFrom(arriving);      // which the next request may be writing while this one is read
            HasResult = true;
            Arrived?.Invoke();
        }
    }
}
