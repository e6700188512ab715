using System.Collections.Generic;
using UnityEngine.Headless;

namespace Host.Check
{
    /// <summary>A graphics API beside Direct3D 11: whether programs translate to its language, and what it gives them at least.</summary>
    sealed class Target
    {
        public string Name;
        /// <summary>Whether the documentation says that the package runs there: then every program has to.</summary>
        public bool Supported;
        /// <summary>Null when nothing here translates to its language: then its limits alone are judged.</summary>
        public Translation Translation;
        /// <summary>Storage and constant buffers together.</summary>
        public int Buffers = int.MaxValue;
        public int StorageBuffers = int.MaxValue, StorageBuffersInGraphics = int.MaxValue, ConstantBuffers = int.MaxValue;
        public int Textures = int.MaxValue, StorageTextures = int.MaxValue, Samplers = int.MaxValue;
        public int Threads = int.MaxValue, SharedBytes = int.MaxValue;
        public bool HasTypedBuffers = true;

        public static readonly IReadOnlyList<Target> All = new[]
        {
            // Metal feature set tables, what every Mac and the Apple family 4 (A11) have.
            new Target { Name = "Metal", Supported = true, Translation = Translation.Metal, Buffers = 31, Textures = 31, Samplers = 16, Threads = 1024, SharedBytes = 32768 },
            // Desktop devices give at least what Direct3D 11 does; Vulkan's own minimum is that of OpenGL ES 3.1.
            new Target { Name = "Vulkan", Supported = true, Translation = Translation.Vulkan, Threads = 1024, SharedBytes = 32768 },
            // WebGPU specification, "Limits", the default ones. It also has at most 65,535 groups a dimension, which the size of a dispatch decides.
            new Target { Name = "WebGPU", StorageBuffers = 8, StorageBuffersInGraphics = 8, ConstantBuffers = 12, Textures = 16, StorageTextures = 4, Samplers = 16, Threads = 256, SharedBytes = 16384, HasTypedBuffers = false },
            // OpenGL ES 3.1 specification, "Implementation dependent values", the minimum ones.
            new Target { Name = "GLES 3.1", Translation = Translation.OpenGlEs31, StorageBuffers = 4, StorageBuffersInGraphics = 0, ConstantBuffers = 12, Textures = 16, StorageTextures = 4, Samplers = 16, Threads = 128, SharedBytes = 16384, HasTypedBuffers = false },
        };

        /// <summary>Why its limits do not hold the program; empty when they do.</summary>
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
            if (needs.SharedBytes > SharedBytes)
                yield return $"{needs.SharedBytes} shared bytes of {SharedBytes}";
        }
    }
}
