using System;
using System.Collections.Generic;

namespace UnityEngine.Profiling
{
    public sealed class Profiler
    {
        public static bool supported => false;
        public static bool enabled { get; set; }
        public static bool enableBinaryLog { get; set; }
        public static bool enableAllocationCallstacks { get; set; }
        public static string logFile { get; set; } = "";
        public static int maxUsedMemory { get; set; }

        public static void BeginSample(string name) { }
        public static void BeginSample(string name, Object targetObject) { }
        public static void EndSample() { }
        public static void BeginThreadProfiling(string threadGroupName, string threadName) { }
        public static void EndThreadProfiling() { }

        public static long usedHeapSizeLong => GC.GetTotalMemory(false);
        public static long GetMonoHeapSizeLong() => GC.GetTotalMemory(false);
        public static long GetMonoUsedSizeLong() => GC.GetTotalMemory(false);
        public static long GetTotalAllocatedMemoryLong() => GC.GetTotalMemory(false);
        public static long GetTotalReservedMemoryLong() => GC.GetTotalMemory(false);
        public static long GetTotalUnusedReservedMemoryLong() => 0;
        public static long GetAllocatedMemoryForGraphicsDriver() => 0;
        public static long GetRuntimeMemorySizeLong(Object o) => 0;
    }

    public class Sampler
    {
        internal Sampler(string name) { this.name = name; }

        public string name { get; }
        public bool isValid => false;
        public Recorder GetRecorder() => new Recorder();
        public static Sampler Get(string name) => new Sampler(name);

        public static int GetNames(List<string> names)
        {
            names?.Clear();
            return 0;
        }
    }

    public sealed class CustomSampler : Sampler
    {
        CustomSampler(string name) : base(name) { }

        public static CustomSampler Create(string name, bool collectGpuData = false) => new CustomSampler(name);
        public void Begin() { }
        public void Begin(Object targetObject) { }
        public void End() { }
    }

    /// <summary>Never valid: see ProfilerRecorder.</summary>
    public sealed class Recorder
    {
        internal Recorder() { }

        public static Recorder Get(string samplerName) => new Recorder();
        public bool isValid => false;
        public bool enabled { get; set; }
        public long elapsedNanoseconds => 0;
        public long gpuElapsedNanoseconds => 0;
        public int sampleBlockCount => 0;
        public int gpuSampleBlockCount => 0;
        public void CollectFromAllThreads() { }
        public void FilterToCurrentThread() { }
    }
}
