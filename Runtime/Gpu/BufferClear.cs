using System;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Fills structured buffers with zeros by a kernel: nothing is uploaded and no array is made for it.</summary>
    sealed class BufferClear
    {
        /// <summary>threads of a group</summary>
        [GenerateHlsl("Clear")] public const int Group = 256;

        readonly ComputeShader shader = StageShader.LoadCompute("Clear");
        readonly Kernel clearWords, clearBlocks, clearTriples;

        public BufferClear()
        {
            clearWords = new Kernel(shader, "ClearWords");
            clearBlocks = new Kernel(shader, "ClearBlocks");
            clearTriples = new Kernel(shader, "ClearTriples");
        }

        /// <summary>Clears buffers at once.</summary>
        /// <param name="buffers">Structured, with elements of 4, 16 or 24 bytes.</param>
        /// <exception cref="ArgumentException">The elements are of another size.</exception>
        public static void Now(params GraphicsBuffer[] buffers)
        {
            var clear = new BufferClear();
            using (var cmd = new CommandBuffer { name = "Rill.Clear" })
            {
                foreach (GraphicsBuffer buffer in buffers)
                    clear.Record(cmd, buffer);
                Graphics.ExecuteCommandBuffer(cmd);
            }
        }

        /// <summary>Records the clearing of a buffer with elements of 4, 16 or 24 bytes.</summary>
        /// <exception cref="ArgumentException">The elements are of another size.</exception>
        public void Record(CommandBuffer cmd, GraphicsBuffer buffer) => Record(cmd, buffer, buffer.count);

        /// <summary>Records a clear of the first elements of a buffer.</summary>
        /// <param name="count">At least 1.</param>
        /// <exception cref="ArgumentException">The elements are of another size.</exception>
        public void Record(CommandBuffer cmd, GraphicsBuffer buffer, int count)
        {
            int kernel = KernelFor(buffer.stride, out int property);
            cmd.SetComputeIntParam(shader, Ids.Count, count);
            cmd.SetComputeBufferParam(shader, kernel, property, buffer);
            ThreadGroups.Dispatch(cmd, shader, kernel, ((long)count + Group - 1) / Group);
        }

        /// <summary>Adds the kernel that clears elements of a size to those of a stage.</summary>
        /// <param name="stride">4, 16 or 24 bytes.</param>
        public void Describe(StageDescription stage, int stride, int perStep) => stage.Kernel(KernelFor(stride, out _), perStep);

        Kernel KernelFor(int stride, out int property)
        {
            switch (stride)
            {
                case 4: property = Ids.Words; return clearWords;
                case 16: property = Ids.Blocks; return clearBlocks;
                case 24: property = Ids.Triples; return clearTriples;
                default:
                    throw new ArgumentException(Invariant($"A buffer with elements of {stride} bytes has no kernel that clears it. Add ") +
                    "one to Clear.compute; there are those of 4, 16 and 24 bytes.");
            }
        }

        static class Ids
        {
            public static readonly int Words = Shader.PropertyToID("_Words");
            public static readonly int Blocks = Shader.PropertyToID("_Blocks");
            public static readonly int Triples = Shader.PropertyToID("_Triples");
            public static readonly int Count = Shader.PropertyToID("_Count");
        }
    }
}
