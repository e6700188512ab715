namespace Rill
{
    /// <summary>Resources of a device that a variant of a kernel, or a stage of a draw shader, takes.</summary>
    readonly struct KernelNeed
    {
        /// <summary>Ends the name of a kernel that stands in for another where a group has 256 threads or 16 KB of groupshared memory.</summary>
        public const string Small = "Small";
        /// <summary>Ends the name of a kernel that stands in for another where a kernel has 8 storage buffers.</summary>
        public const string Narrow = "Narrow";
        /// <summary>Ends the name of a kernel that does the work of another faster where a kernel has more than 8 storage buffers.</summary>
        public const string Wide = "Wide";

        /// <summary>Instead of a kernel's name, the vertex stage of a draw shader.</summary>
        public const string Vertex = "Vertex";

        /// <summary>Shader file without its extension.</summary>
        public readonly string File;
        /// <summary>The kernel; <see cref="Vertex"/> or "Fragment" of a draw shader.</summary>
        public readonly string Kernel;
        /// <summary>Names that its #pragma kernel line defines, then keywords, with blanks between.</summary>
        public readonly string Defines;
        /// <summary>In a group; 0 of a draw shader.</summary>
        public readonly int Threads;
        public readonly int GroupsharedBytes;
        /// <summary>Structured and raw buffers, for reading or writing, as Vulkan, Metal and WebGPU count them.</summary>
        public readonly int StorageBuffers;
        /// <summary>Buffers and textures for writing: unordered access views.</summary>
        public readonly int Writable;
        public readonly int Textures;

        public KernelNeed(string file, string kernel, string defines, int threads, int groupsharedBytes, int storageBuffers, int writable,
            int textures)
        {
            File = file;
            Kernel = kernel;
            Defines = defines;
            Threads = threads;
            GroupsharedBytes = groupsharedBytes;
            StorageBuffers = storageBuffers;
            Writable = writable;
            Textures = textures;
        }
    }
}
