using System;

namespace Rill
{
    /// <summary>A frame of a recording in memory, used again for others.</summary>
    sealed class RecordedFrame
    {
        /// <summary>Its place in the recording, from 0.</summary>
        public int number;

        public int particles;

        /// <summary>The id that the next new particle would have had.</summary>
        public uint nextId;

        /// <summary>Fixed steps that the fluid had taken.</summary>
        public int step;

        /// <summary>Fluid time, s.</summary>
        public double time;

        /// <summary>The particles, see <see cref="FrameLayout"/>; as long as the largest frame so far or longer.</summary>
        public uint[] words = Array.Empty<uint>();

        public void Reserve(long count)
        {
            if (words.Length < count)
                words = new uint[count];
        }
    }
}
