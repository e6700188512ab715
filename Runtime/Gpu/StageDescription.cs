using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Experimental.Rendering;

namespace Rill
{
    /// <summary>Cost of a stage in a scene: its dispatches in a step, its buffers, and why it is there or not.</summary>
    sealed class StageDescription
    {
        public readonly string Name, Reason;
        public readonly bool IsUsed;
        /// <summary>"File.compute: Kernel" and how often it is dispatched in a step (0: not in every step), or a draw of a frame.</summary>
        public readonly List<(string kernel, int perStep)> Kernels = new List<(string, int)>();
        public readonly List<(string name, long bytes)> Buffers = new List<(string, long)>();

        public StageDescription(string name, bool isUsed, string reason)
        {
            Name = name;
            IsUsed = isUsed;
            Reason = reason;
        }

        public long Bytes
        {
            get
            {
                long bytes = 0;
                foreach ((string _, long size) in Buffers)
                    bytes += size;
                return bytes;
            }
        }

        /// <param name="variant">Enabled keywords, or null.</param>
        public void Kernel(Kernel kernel, int perStep, string variant = null)
        {
            string name = $"{kernel.File}.compute: {kernel.Name}";
            Kernels.Add((variant == null ? name : $"{name} [{variant}]", perStep));
        }

        public void Draw(string file, int perFrame) => Kernels.Add(($"{file}.shader, a draw in each pass of each camera", perFrame));

        public void Texture(string name, long bytes) => Buffers.Add((name, bytes));

        /// <summary>Null is a texture that this scene does without.</summary>
        public void Texture(RenderTexture texture)
        {
            if (texture != null)
                Texture(texture.name, (long)texture.width * texture.height * texture.volumeDepth * BytesOf(texture.graphicsFormat));
        }

        /// <summary>Null is a buffer that this scene does without.</summary>
        public void Buffer(string name, GraphicsBuffer buffer)
        {
            if (buffer != null)
                Buffers.Add((name, (long)buffer.count * buffer.stride));
        }

        // Bytes of a texel. A depth format is none of these, and has 4.
        static int BytesOf(GraphicsFormat format) => format == GraphicsFormat.R32G32B32A32_SFloat ? 16
            : format == GraphicsFormat.R16G16B16A16_SFloat ? 8 : 4;
    }
}
