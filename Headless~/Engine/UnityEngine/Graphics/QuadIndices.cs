using System;

namespace UnityEngine.Headless
{
    /// <summary>Two triangles for each four vertices: Direct3D 11 has no quads.</summary>
    internal static class QuadIndices
    {
        static DeviceBuffer buffer;
        static int capacity;

        public static void Reset()
        {
            buffer?.Dispose();
            buffer = null;
            capacity = 0;
        }

        public static DeviceBuffer For(int quads)
        {
            if (quads <= capacity)
                return buffer;
            Reset();
            capacity = Math.Max(1024, Mathf.NextPowerOfTwo(quads));
            var indices = new uint[capacity * 6];
            for (uint q = 0; q < capacity; q++)
            {
                uint v = q * 4, i = q * 6;
                (indices[i], indices[i + 1], indices[i + 2]) = (v, v + 1, v + 2);
                (indices[i + 3], indices[i + 4], indices[i + 5]) = (v, v + 2, v + 3);
            }
            buffer = Gpu.Device.CreateBuffer("Quad indices", indices.Length * 4L);
            Gpu.Device.Upload(buffer, 0, System.Runtime.InteropServices.MemoryMarshal.AsBytes<uint>(indices));
            return buffer;
        }
    }
}
