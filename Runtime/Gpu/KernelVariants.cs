using UnityEngine;

namespace Rill
{
    /// <summary>A kernel of a compute shader: its index for recording, its name and its shader's for descriptions.</summary>
    readonly struct Kernel
    {
        public readonly int Index;
        public readonly string File, Name;

        public Kernel(ComputeShader shader, string name)
        {
            Index = shader.FindKernel(name);
            File = shader.name;
            Name = name;
        }

        public static implicit operator int(Kernel kernel) => kernel.Index;
    }

    /// <summary>The variants of a kernel, by one or two things that it may have to do besides. Recording and describing both ask here, so
    /// that each name is spelled once.</summary>
    readonly struct KernelVariants
    {
        readonly Kernel[] kernels;

        public KernelVariants(ComputeShader shader, string plain, string first)
            => kernels = new[] { new Kernel(shader, plain), new Kernel(shader, first) };

        public KernelVariants(ComputeShader shader, string plain, string first, string second, string both)
            => kernels = new[] { new Kernel(shader, plain), new Kernel(shader, first), new Kernel(shader, second), new Kernel(shader, both) };

        public Kernel For(bool first) => kernels[first ? 1 : 0];

        public Kernel For(bool first, bool second) => kernels[(first ? 1 : 0) + (second ? 2 : 0)];
    }
}
