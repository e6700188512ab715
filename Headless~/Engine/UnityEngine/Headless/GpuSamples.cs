using System.Collections.Generic;

namespace UnityEngine.Headless
{
    /// <summary>Samples of command buffers that recorders ask for, by name. Nothing is stamped while no recorder is enabled.</summary>
    internal static class GpuSamples
    {
        static readonly Dictionary<string, GpuSampler> samplers = new Dictionary<string, GpuSampler>();
        static readonly Stack<GpuSampler> open = new Stack<GpuSampler>();
        static int enabled;

        public static bool Supported => Player.Device != null && Player.GpuTimes == GpuTimes.Samples;
        public static int Count => samplers.Count;

        public static void Register(string name)
        {
            if (!samplers.ContainsKey(name))
                samplers.Add(name, new GpuSampler());
        }

        /// <summary>Null where nothing of that name samples the GPU.</summary>
        public static GpuSampler Find(string name) => name != null && samplers.TryGetValue(name, out GpuSampler sampler) ? sampler : null;

        public static void AddNames(List<string> names) => names.AddRange(samplers.Keys);

        public static void Enable(GpuSampler sampler, bool value)
        {
            if (sampler.Enabled == value)
                return;
            sampler.Enabled = value;
            enabled += value ? 1 : -1;
            if (!value)
                sampler.Reset();
        }

        public static void Begin(string name)
        {
            if (enabled == 0)
                return;
            GpuSampler sampler = Find(name);
            if (sampler != null && !sampler.Enabled)
                sampler = null;
            open.Push(sampler);
            sampler?.Begin();
        }

        public static void End()
        {
            // Begun before a recorder was enabled: not in the stack.
            if (open.Count > 0)
                open.Pop()?.End();
        }

        /// <summary>The device or the play mode ends: recorders stop.</summary>
        public static void Reset()
        {
            open.Clear();
            foreach (GpuSampler sampler in samplers.Values)
                Enable(sampler, false);
        }
    }
}
