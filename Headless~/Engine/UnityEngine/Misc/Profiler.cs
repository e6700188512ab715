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
}
