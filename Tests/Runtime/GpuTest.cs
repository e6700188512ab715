using System;
using System.Linq;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill.Tests
{
    /// <summary>Work on the device from a test: run, fill with garbage, read back.</summary>
    static class GpuTest
    {
        /// <summary>Content of outputs before a kernel writes them: not a number as a float, out of any range as an index.</summary>
        public const uint Garbage = 0xFFFFDEAD;

        /// <summary>Particle counts at and around a thread group, a prime, and one that takes many groups; 0 has tests of its own.</summary>
        public static readonly int[] Sizes = { 1, 127, 128, 129, 997, 100003 };

        /// <summary>Records commands and runs them at once.</summary>
        public static void Run(Action<CommandBuffer> record)
        {
            using (var cmd = new CommandBuffer { name = "Test" })
            {
                record(cmd);
                Graphics.ExecuteCommandBuffer(cmd);
            }
        }

        public static GraphicsBuffer Upload<T>(string name, T[] data) where T : struct
        {
            GraphicsBuffer buffer = GpuBuffer.Structured<T>(name, data.Length);
            buffer.SetData(data);
            return buffer;
        }

        public static GraphicsBuffer UploadConstants<T>(T constants) where T : struct
        {
            GraphicsBuffer buffer = GpuBuffer.Constants<T>("Constants");
            buffer.SetData(new[] { constants });
            return buffer;
        }

        /// <summary>Elements from the start of a buffer, waiting for the device.</summary>
        public static T[] Read<T>(GraphicsBuffer buffer, int count) where T : struct
        {
            var data = new T[count];
            if (count > 0)
                buffer.GetData(data, 0, 0, count);
            return data;
        }

        public static void FillWithGarbage(GraphicsBuffer buffer)
        {
            int words = buffer.count * buffer.stride / sizeof(uint);
            buffer.SetData(Enumerable.Repeat(Garbage, words).ToArray());
        }

        /// <summary>Whether an element is still what <see cref="FillWithGarbage"/> wrote.</summary>
        public static bool IsGarbage(uint element) => element == Garbage;

        /// <summary>Whether all four components are still what <see cref="FillWithGarbage"/> wrote.</summary>
        public static bool IsGarbage(float4 element) => math.all(math.asuint(element) == Garbage);
    }
}
