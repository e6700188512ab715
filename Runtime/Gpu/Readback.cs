using System;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Brings a small buffer back without waiting: at most one request pending, and what was asked for before a reset is dropped.</summary>
    /// <remarks>
    /// The data are copied in the callback out of Unity's memory: whether an array of ours may be read there, or disposed of
    /// before, Unity does not say. Nor whether a buffer that is released first still comes back: it is released after. A request that
    /// ends with an error leaves the result of before; who owns this decides whether that still counts.
    /// </remarks>
    sealed class Readback : IDisposable, IPendingReadback
    {
        readonly Action<AsyncGPUReadbackRequest> onRead;
        AsyncGPUReadbackRequest request;
        GraphicsBuffer buffer;
        NativeArray<uint> latest;
        int generation, pendingGeneration, calls, collected;
        bool disposed;
        uint[] resumed;         // what is pending, of a request before a snapshot; null else
        int resumedFrame;       // of the game, from which on it has come
        ReadbackArrival arrival;        // of what is pending, where a snapshot follows it
        ReadbackErrors errors;
        ReadbackKinds kind;

        /// <param name="buffer">uint; released with this, or when the last request for it has come back.</param>
        public Readback(GraphicsBuffer buffer)
        {
            this.buffer = buffer;
            latest = new NativeArray<uint>(buffer.count, Allocator.Persistent);
            onRead = OnRead;
        }

        /// <summary>Called when a result has come.</summary>
        public Action Arrived;

        /// <summary>Called when a request that still counts ended with an error and brought nothing.</summary>
        public Action Lost;

        /// <summary>Buffer that is read back; null after <see cref="Dispose"/>.</summary>
        public GraphicsBuffer Buffer => disposed ? null : buffer;

        /// <summary>Whether a result is pending.</summary>
        public bool IsPending { get; private set; }

        /// <summary>Whether <see cref="Latest"/> holds a result of the time since the last <see cref="Invalidate"/>.</summary>
        public bool HasResult { get; private set; }

        public NativeArray<uint> Latest => latest;

        /// <summary>Notes from now on how requests end.</summary>
        /// <param name="to">Null to report to none.</param>
        /// <param name="what">One kind.</param>
        public void Report(ReadbackErrors to, ReadbackKinds what) => (errors, kind) = (to, what);

        /// <summary>Asks for the buffer as the commands executed so far leave it. Nothing while a result is pending.</summary>
        public void Request()
        {
            if (IsPending)
                return;
            IsPending = true;
            pendingGeneration = generation;
            request = AsyncGPUReadback.Request(buffer, onRead);
        }

        /// <summary>Results from before this call are dropped when they come.</summary>
        public void Invalidate()
        {
            generation++;
            HasResult = false;
        }

        /// <summary>Takes words that a request of before a snapshot was to bring: they come by themselves. Of one that has made no request.</summary>
        /// <param name="frames">Number of frames from now on in which they come.</param>
        public void Resume(ReadOnlySpan<uint> words, int frames)
        {
            resumed = words.ToArray();
            buffer.SetData(resumed);
            resumedFrame = Time.frameCount + frames;
            IsPending = true;
            pendingGeneration = generation;
            PendingReadbacks.AddResumed(this);
        }

        /// <summary>Hands over what was resumed, if its frame has come.</summary>
        /// <returns>Whether it had.</returns>
        public bool TryFinishResumed()
        {
            if (Time.frameCount < resumedFrame)
                return false;
            FinishResumed();
            return true;
        }

        /// <summary>Follows what is pending: in which frame it comes. Null while nothing is.</summary>
        public ReadbackArrival Follow() => !IsPending || pendingGeneration != generation ? null
            : resumed != null ? new ReadbackArrival { Frame = Math.Max(resumedFrame, Time.frameCount) }
            : arrival ??= new ReadbackArrival();

        /// <summary>Words that are 0 from now on; what is pending may not know yet and is dropped.</summary>
        public void Zero(int first, int count)
        {
            generation++;
            for (int word = first; word < first + count; word++)
                latest[word] = 0;
        }

        /// <summary>Waits for nothing: a buffer that is pending is released when it has come.</summary>
        public void Dispose()
        {
            if (disposed)
                return;
            disposed = true;
            Arrived = Lost = null;
            if (resumed != null)
                PendingReadbacks.RemoveResumed(this);
            latest.Dispose();
            if (IsPending && resumed == null)
                PendingReadbacks.Add(this);
            else
                GpuBuffer.Release(ref buffer);
        }

        /// <summary>Waits for the request that is pending, and for no other; its result has been handed over when this returns.</summary>
        public void Complete()
        {
            if (!IsPending)
                return;
            if (resumed != null)
            {
                FinishResumed();
                return;
            }
            int before = calls;
            request.WaitForCompletion();
            if (calls != before)
                return;
            collected++;        // Unity does not say when the callback comes: this one is late
            Collect(request);
        }

        void OnRead(AsyncGPUReadbackRequest arrived)
        {
            calls++;
            if (collected > 0)
                collected--;
            else
                Collect(arrived);
        }

        void FinishResumed()
        {
            uint[] words = resumed;
            resumed = null;
            PendingReadbacks.RemoveResumed(this);
            IsPending = false;
            if (pendingGeneration != generation)
                return;
            latest.CopyFrom(words);
            HasResult = true;
            Arrived?.Invoke();
        }

        void Collect(in AsyncGPUReadbackRequest arrived)
        {
            if (arrival != null)
                arrival.Frame = Time.frameCount;
            arrival = null;
            if (disposed)
            {
                Finish();
                return;
            }
            IsPending = false;
            if (pendingGeneration != generation)
                return;
            errors?.Mark(kind, arrived.hasError);
            if (arrived.hasError)
            {
                Lost?.Invoke();
                return;
            }
            latest.CopyFrom(arrived.GetData<uint>());
            HasResult = true;
            Arrived?.Invoke();
        }

        void Finish()
        {
            IsPending = false;
            if (!disposed)
                return;
            GpuBuffer.Release(ref buffer);
            PendingReadbacks.Remove(this);
        }
    }

    /// <summary>When a request comes that was pending as a snapshot was taken.</summary>
    sealed class ReadbackArrival
    {
        const int NotYet = -1;

        /// <summary>Frame of the game in which it ended; -1 while it is pending.</summary>
        public int Frame = NotYet;

        /// <summary>Frames from a frame to that in which it has come; where it is pending still, to the present one.</summary>
        public int FramesAfter(int frame) => Math.Max((Frame != NotYet ? Frame : Time.frameCount) - frame, 0);
    }
}
