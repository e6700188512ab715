using System;
using Unity.Collections;

namespace UnityEngine.Headless
{
    /// <summary>A NativeArray that a command uploads: strict mode wants it to hold at execution what it held when it was recorded.</summary>
    internal abstract class RecordedArray
    {
        /// <param name="recorded">What it held.</param>
        /// <param name="target">For the message.</param>
        public void Check(ReadOnlySpan<byte> recorded, BufferStorage target)
        {
            if (!Holds(recorded))
                GpuError.Strictly($"SetBufferData: the NativeArray that was recorded for {target} has changed since, or was disposed " +
                    $"of. Which of its contents Unity uploads is not documented: record from a managed array, which is copied, or from " +
                    $"a part of the array that stays.");
        }

        protected abstract bool Holds(ReadOnlySpan<byte> recorded);
    }

    internal sealed class RecordedArray<T> : RecordedArray where T : struct
    {
        readonly NativeArray<T> array;

        public RecordedArray(NativeArray<T> array) => this.array = array;

        protected override bool Holds(ReadOnlySpan<byte> recorded)
        {
            try
            {
                return recorded.SequenceEqual(Transfer.Bytes(array));
            }
            catch (ObjectDisposedException)
            {
                return false;
            }
        }
    }
}
