using System.Collections.Generic;
using System.Linq;
using UnityEngine.Rendering;

namespace UnityEngine.Headless
{
    /// <summary>Limits that a graphics API, or a class of devices, grants a program, and SystemInfo's answers there.</summary>
    internal sealed class ApiLimits
    {
        /// <summary>Name on the command line; null for one that cannot be run under.</summary>
        public string Name;
        /// <summary>For messages.</summary>
        public string Title;
        public GraphicsDeviceType Type;
        /// <summary>SystemInfo.deviceType is Handheld and Application.isMobilePlatform is true.</summary>
        public bool IsHandheld;

        /// <summary>Storage and constant buffers of a stage together.</summary>
        public int Buffers = int.MaxValue;
        public int StorageBuffers = int.MaxValue, StorageBuffersInGraphics = int.MaxValue, ConstantBuffers = int.MaxValue;
        public int Textures = int.MaxValue, StorageTextures = int.MaxValue, Samplers = int.MaxValue;
        /// <summary>In a group, as the API states it.</summary>
        public int Threads = int.MaxValue, ThreadsZ = int.MaxValue;
        /// <summary>In a group, on which every program can count; where less than <see cref="Threads"/>, a pipeline's own limit depends on
        /// its registers.</summary>
        public int SafeThreads = int.MaxValue;
        public int GroupsharedBytes = int.MaxValue;
        public int ConstantBytes = 64 * 1024;
        public long BufferBytes = long.MaxValue;
        public bool HasTypedBuffers = true;
        /// <summary>Kernels write textures of one or two halves, and of 8 or 16 bits a channel; otherwise of four halves and of 32 bits
        /// alone.</summary>
        public bool WritesSmallTexels = true;

        /// <summary>Shader model 5.0 and feature level 11_0: 128 views to read (8 to write are Unity's limit everywhere), 1,024 threads of
        /// which 64 along z, 32 KB.</summary>
        public static readonly ApiLimits Direct3D11 = new ApiLimits
        {
            Name = "d3d11", Title = "Direct3D 11", Type = GraphicsDeviceType.Direct3D11,
            StorageBuffers = 128, StorageBuffersInGraphics = 128, Textures = 128, Samplers = 16, Threads = 1024, ThreadsZ = 64,
            GroupsharedBytes = 32768,
        };

        /// <summary>
        /// Apple's Metal feature set tables, what every Mac and the Apple family 4 (A11) have. maxTotalThreadsPerThreadgroup is
        /// a pipeline's, less the more registers it takes: 512 here. Unity 6000.3 reports 31 buffers on an M2 Pro.
        /// </summary>
        public static readonly ApiLimits Metal = new ApiLimits
        {
            Name = "metal", Title = "Metal", Type = GraphicsDeviceType.Metal,
            Buffers = 31, Textures = 31, Samplers = 16, Threads = 1024, ThreadsZ = 1024, SafeThreads = 512, GroupsharedBytes = 32768,
        };

        /// <summary>
        /// Vulkan on phones, a weak one that still has 16 storage buffers a stage, as nearly all do (gpuweb issue 4235, from
        /// vulkan.gpuinfo.org). Unity's Device Simulator reports 35 buffers and groups of 384 for a Mali-G76; older ones and
        /// PowerVR stop at 256 and 16 KB. 128 MB a buffer is the specification's least maxStorageBufferRange.
        /// </summary>
        public static readonly ApiLimits Mobile = new ApiLimits
        {
            Name = "mobile", Title = "Vulkan on a mobile device", Type = GraphicsDeviceType.Vulkan, IsHandheld = true,
            StorageBuffers = 16, StorageBuffersInGraphics = 16, ConstantBuffers = 12, Textures = 16, StorageTextures = 4, Samplers = 16,
                Threads = 256, ThreadsZ = 64, GroupsharedBytes = 16384,
            ConstantBytes = 16 * 1024, BufferBytes = 1 << 27,
        };

        /// <summary>WebGPU specification, "Limits", the default ones. GraphicsDeviceType has it from Unity 6000.0 on.</summary>
        public static readonly ApiLimits WebGpu = new ApiLimits
        {
            Name = "webgpu", Title = "WebGPU", Type = (GraphicsDeviceType)28,
            StorageBuffers = 8, StorageBuffersInGraphics = 8, ConstantBuffers = 12, Textures = 16, StorageTextures = 4, Samplers = 16,
                Threads = 256, ThreadsZ = 64, GroupsharedBytes = 16384,
            BufferBytes = 1 << 27, HasTypedBuffers = false, WritesSmallTexels = false,
        };

        /// <summary>OpenGL ES 3.1 specification, "Implementation dependent values", the least ones.</summary>
        public static readonly ApiLimits OpenGlEs31 = new ApiLimits
        {
            Title = "OpenGL ES 3.1", Type = GraphicsDeviceType.OpenGLES3, IsHandheld = true,
            StorageBuffers = 4, StorageBuffersInGraphics = 0, ConstantBuffers = 12, Textures = 16, StorageTextures = 4, Samplers = 16,
                Threads = 128, GroupsharedBytes = 16384, HasTypedBuffers = false, WritesSmallTexels = false,
        };

        /// <summary>Those that the command line names.</summary>
        public static readonly IReadOnlyList<ApiLimits> All = new[] { Direct3D11, Metal, Mobile, WebGpu };

        /// <summary>Why they do not hold a program; empty when they do.</summary>
        public IEnumerable<string> Excesses(ProgramNeeds needs)
        {
            int storage = needs.Stage == ShaderStage.Compute ? StorageBuffers : StorageBuffersInGraphics;
            if (needs.StorageBuffers > storage)
                yield return $"{needs.StorageBuffers} storage buffers of {storage}";
            if (needs.StorageBuffers + needs.ConstantBuffers > Buffers)
                yield return $"{needs.StorageBuffers + needs.ConstantBuffers} buffers of {Buffers}";
            if (needs.ConstantBuffers > ConstantBuffers)
                yield return $"{needs.ConstantBuffers} constant buffers of {ConstantBuffers}";
            if (needs.TypedBuffers > 0 && !HasTypedBuffers)
                yield return "has no Buffer<T>";
            if (needs.Textures > Textures)
                yield return $"{needs.Textures} textures of {Textures}";
            if (needs.StorageTextures > StorageTextures)
                yield return $"{needs.StorageTextures} writable textures of {StorageTextures}";
            if (needs.Samplers > Samplers)
                yield return $"{needs.Samplers} samplers of {Samplers}";
            if (needs.Threads > Threads)
                yield return $"{needs.Threads} threads of {Threads}";
            if (needs.GroupsharedBytes > GroupsharedBytes)
                yield return $"{needs.GroupsharedBytes} shared bytes of {GroupsharedBytes}";
        }

        /// <summary>Explains refusals, also for what a pipeline may fall short of although the API states more.</summary>
        public string WhyNot(ProgramNeeds needs)
        {
            List<string> reasons = Excesses(needs).ToList();
            if (needs.Threads > SafeThreads && needs.Threads <= Threads)
                reasons.Add($"{needs.Threads} threads where a pipeline may have no more than {SafeThreads}");
            return reasons.Count == 0 ? null : string.Join("; ", reasons);
        }
    }
}
