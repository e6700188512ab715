using Unity.Profiling;
using Unity.Profiling.LowLevel;

namespace Rill
{
    /// <summary>Markers around recorded work, so that recorders can read its time on the GPU too.</summary>
    static class GpuMarker
    {
        public static ProfilerMarker Create(string name) => new ProfilerMarker(ProfilerCategory.Render, name, MarkerFlags.SampleGPU);
    }
}
