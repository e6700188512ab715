using System.Collections.Generic;
using UnityEngine.Headless;

namespace UnityEngine.Profiling
{
    public class Sampler
    {
        internal Sampler(string name) { this.name = name; }

        public string name { get; }
        public bool isValid => GpuSamples.Find(name) != null;
        public Recorder GetRecorder() => Recorder.Get(name);
        public static Sampler Get(string name) => new Sampler(name);

        public static int GetNames(List<string> names)
        {
            if (names == null)
                return GpuSamples.Count;
            names.Clear();
            GpuSamples.AddNames(names);
            return names.Count;
        }
    }

    public sealed class CustomSampler : Sampler
    {
        CustomSampler(string name) : base(name) { }

        public static CustomSampler Create(string name, bool collectGpuData = false)
        {
            if (collectGpuData)
                GpuSamples.Register(name);
            return new CustomSampler(name);
        }

        public void Begin() { }
        public void Begin(Object targetObject) { }
        public void End() { }
    }

    /// <summary>GPU time of a command buffer's samples, three frames late, as Unity has it. CPU time is not recorded here: 0.</summary>
    public sealed class Recorder
    {
        readonly GpuSampler sampler;

        Recorder(GpuSampler sampler) { this.sampler = sampler; }

        /// <summary>Valid for markers and samplers that were created with GPU data.</summary>
        public static Recorder Get(string samplerName) => new Recorder(GpuSamples.Find(samplerName));

        public bool isValid => sampler != null && GpuSamples.Supported;
        public bool enabled { get => isValid && sampler.Enabled; set { if (isValid) GpuSamples.Enable(sampler, value); } }
        public long elapsedNanoseconds => 0;
        public int sampleBlockCount => 0;

        /// <summary>0 where it is not known yet, or nothing was sampled.</summary>
        public long gpuElapsedNanoseconds => isValid ? sampler.Read().Nanoseconds : 0;
        public int gpuSampleBlockCount => isValid ? sampler.Read().Blocks : 0;

        public void CollectFromAllThreads() { }
        public void FilterToCurrentThread() { }
    }
}
