using System;
using UnityEngine;

namespace Rill
{
    /// <summary>Memory that one thing after the other uses while the surface of a frame is found.</summary>
    /// <remarks>
    /// In the order of a frame: the planes and contacts of <see cref="SurfaceParticles"/>; once the elements are made, the sums of
    /// <see cref="SurfaceMesh"/> at the nodes of its field; once that is found, the mesh's vertices while they are smoothed, and their links.
    /// Last, the list of its drops, which stays until the surface of the next frame is recorded. Each user writes what it reads, and asks for
    /// its room before anything of a frame is recorded.
    /// </remarks>
    sealed class SurfaceWorkspace : IDisposable
    {
        public static readonly int Id = Shader.PropertyToID("_Workspace");

        GraphicsBuffer memory;

        /// <summary>Raw; null before the first <see cref="Reserve"/>. What is in it at the start of a frame means nothing.</summary>
        public GraphicsBuffer Memory => memory;

        /// <summary>Makes it at least so large; what was in it is lost then.</summary>
        /// <exception cref="ArgumentOutOfRangeException">It is more than the device can bind.</exception>
        public void Reserve(long bytes)
        {
            long words = (bytes + sizeof(uint) - 1) / sizeof(uint);
            if (memory != null && words <= memory.count)
                return;
            Dispose();
            memory = GpuBuffer.Raw("Rill.Surface.Workspace", words, 0);
        }

        /// <summary>It is made again when asked for.</summary>
        public void Dispose() => GpuBuffer.Release(ref memory);
    }
}
