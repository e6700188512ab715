using System;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Limits of the graphics device for one program. Only these decide between variants of a kernel.</summary>
    /// <remarks>
    /// SystemInfo reports storage buffers and threads. It does not report groupshared memory, and two of its answers are not
    /// taken as they are. Metal: Unity reported 8 buffers there for years (31 in 6000.3), while Metal has 31; and the threads
    /// of a group are a pipeline's own limit, below the 1,024 that it states, so only 256 are counted on.
    /// </remarks>
    readonly struct DeviceLimits
    {
        const int Kilobyte = 1024;
        const int MetalBuffers = 31;        // the buffer argument table
        const int SafeThreads = 256;        // on which every pipeline of Metal can count

        /// <summary>Maximum number of buffers that a kernel reads or writes.</summary>
        public readonly int StorageBuffers;
        /// <summary>Maximum number of buffers that a vertex stage reads.</summary>
        public readonly int VertexStorageBuffers;
        /// <summary>Maximum number of threads in a group.</summary>
        public readonly int Threads;
        public readonly int GroupsharedBytes;

        public DeviceLimits(int storageBuffers, int vertexStorageBuffers, int threads, int groupsharedBytes)
        {
            StorageBuffers = storageBuffers;
            VertexStorageBuffers = vertexStorageBuffers;
            Threads = threads;
            GroupsharedBytes = groupsharedBytes;
        }

        /// <summary>Those of the device that runs this.</summary>
        public static DeviceLimits Current
        {
            get
            {
                GraphicsDeviceType api = SystemInfo.graphicsDeviceType;
                bool isMetal = api == GraphicsDeviceType.Metal;
                int buffers = SystemInfo.maxComputeBufferInputsCompute, vertexBuffers = SystemInfo.maxComputeBufferInputsVertex;
                int threads = Math.Min(SystemInfo.maxComputeWorkGroupSize, SystemInfo.maxComputeWorkGroupSizeX);
                return new DeviceLimits(isMetal ? Math.Max(buffers, MetalBuffers) : buffers, isMetal ? Math.Max(vertexBuffers, MetalBuffers)
                    : vertexBuffers,
                    isMetal ? Math.Min(threads, SafeThreads) : threads, GroupsharedOf(api, Application.isMobilePlatform));
            }
        }

        /// <summary>
        /// Bytes of groupshared memory that an API grants every kernel: 32 KB where shader model 5.0, OpenGL 4.3 or Metal says
        /// so, and on desktop Vulkan; 16 KB, the least of Vulkan, OpenGL ES 3.1 and WebGPU, wherever else.
        /// </summary>
        public static int GroupsharedOf(GraphicsDeviceType api, bool isMobile)
        {
            switch (api)
            {
                case GraphicsDeviceType.Direct3D11:
                case GraphicsDeviceType.Direct3D12:
                case GraphicsDeviceType.XboxOne:
                case GraphicsDeviceType.XboxOneD3D12:
                case GraphicsDeviceType.GameCoreXboxOne:
                case GraphicsDeviceType.GameCoreXboxSeries:
                case GraphicsDeviceType.OpenGLCore:
                case GraphicsDeviceType.Metal:
                    return 32 * Kilobyte;
                case GraphicsDeviceType.Vulkan:
                    return isMobile ? 16 * Kilobyte : 32 * Kilobyte;
                default:
                    return 16 * Kilobyte;
            }
        }

        /// <summary>Whether it runs a kernel, with no keyword enabled.</summary>
        public bool Holds(string file, string kernel)
        {
            foreach (KernelNeed need in KernelNeeds.OfKernels)
                if (need.File == file && need.Kernel == kernel)
                    return WhyNot(need) == null;        // the first variant is the one without keywords
            throw new ArgumentException($"{file}.compute has no kernel '{kernel}' in the table of what kernels need: run `Headless~/rill generate`.");
        }

        /// <summary>Returns which limit of the device a program exceeds; null if it runs.</summary>
        public string WhyNot(in KernelNeed need)
        {
            if (need.Kernel == KernelNeed.Vertex && need.StorageBuffers > VertexStorageBuffers)
                return Invariant($"the vertex stage of {need.File}.shader reads {need.StorageBuffers} storage buffers, and this device ") +
                    Invariant($"has {VertexStorageBuffers} there (SystemInfo.maxComputeBufferInputsVertex)");
            if (need.Threads == 0)
                return null;
            string kernel = $"kernel '{need.Kernel}' of {need.File}.compute";
            if (need.StorageBuffers > StorageBuffers)
                return Invariant($"{kernel} takes {need.StorageBuffers} storage buffers, and this device has {StorageBuffers} ") +
                    $"(SystemInfo.maxComputeBufferInputsCompute)";
            if (need.Threads > Threads)
                return Invariant($"{kernel} has groups of {need.Threads:N0} threads, and this device's have at most {Threads:N0} ") +
                    $"(SystemInfo.maxComputeWorkGroupSize)";
            if (need.GroupsharedBytes > GroupsharedBytes)
                return Invariant($"{kernel} takes {need.GroupsharedBytes:N0} bytes of groupshared memory, and ") +
                    Invariant($"{SystemInfo.graphicsDeviceType} grants {GroupsharedBytes:N0}");
            return null;
        }
    }
}
