using System;
using System.Runtime.CompilerServices;
using UnityEngine.Headless;

namespace Host.Vulkan
{
    /// <summary>Key of a graphics pipeline, beside its shaders: state, target formats, vertex streams.</summary>
    internal struct PipelineKey : IEquatable<PipelineKey>
    {
        public const int MaxStreams = 16;

        public DeviceRasterState State;
        /// <summary>Five formats, a byte each: four colors and depth.</summary>
        public ulong Formats;
        public int StreamCount;
        public PackedStreams Streams;

        [InlineArray(MaxStreams)]
        public struct PackedStreams { uint first; }

        public static uint Pack(int location, DeviceFormat format, int stride) => (uint)location | (uint)format << 5 | (uint)stride << 10;
        public static int LocationOf(uint stream) => (int)(stream & 31);
        public static DeviceFormat FormatOf(uint stream) => (DeviceFormat)(stream >> 5 & 31);
        public static uint StrideOf(uint stream) => stream >> 10;

        public bool Equals(PipelineKey o)
        {
            if (Formats != o.Formats || StreamCount != o.StreamCount || !State.Equals(o.State)) return false;
            for (int i = 0; i < StreamCount; i++)
                if (Streams[i] != o.Streams[i]) return false;
            return true;
        }

        public override bool Equals(object o) => o is PipelineKey k && Equals(k);

        public override int GetHashCode()
        {
            int hash = HashCode.Combine(State, Formats, StreamCount);
            for (int i = 0; i < StreamCount; i++) hash = HashCode.Combine(hash, Streams[i]);
            return hash;
        }
    }
}
