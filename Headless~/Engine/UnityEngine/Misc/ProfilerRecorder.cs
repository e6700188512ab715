using System;
using System.Collections.Generic;
using Unity.Profiling.LowLevel;

namespace Unity.Profiling
{
    /// <summary>Never valid: code has to live without. GPU time of samples is told by UnityEngine.Profiling.Recorder.</summary>
    public struct ProfilerRecorder : IDisposable
    {
        public ProfilerRecorder(string statName, int capacity = 1, ProfilerRecorderOptions options = ProfilerRecorderOptions.Default) { }
        public ProfilerRecorder(string categoryName, string statName, int capacity = 1,
            ProfilerRecorderOptions options = ProfilerRecorderOptions.Default) { }
        public ProfilerRecorder(ProfilerCategory category, string statName, int capacity = 1,
            ProfilerRecorderOptions options = ProfilerRecorderOptions.Default) { }
        public ProfilerRecorder(ProfilerMarker marker, int capacity = 1, ProfilerRecorderOptions options = ProfilerRecorderOptions.Default) { }

        public static ProfilerRecorder StartNew(ProfilerCategory category, string statName, int capacity = 1,
            ProfilerRecorderOptions options = ProfilerRecorderOptions.Default) => default;
        public static ProfilerRecorder StartNew(ProfilerMarker marker, int capacity = 1,
            ProfilerRecorderOptions options = ProfilerRecorderOptions.Default) => default;

        public bool Valid => false;
        public bool IsRunning => false;
        public bool WrappedAround => false;
        public int Capacity => 0;
        public int Count => 0;
        public long CurrentValue => 0;
        public long LastValue => 0;
        public double CurrentValueAsDouble => 0;
        public double LastValueAsDouble => 0;
        public ProfilerMarkerDataType DataType => ProfilerMarkerDataType.Int64;
        public ProfilerMarkerDataUnit UnitType => ProfilerMarkerDataUnit.Undefined;
        public ProfilerRecorderSample GetSample(int index)
            => throw new InvalidOperationException("ProfilerRecorder is not valid: the headless host records no profiler samples.");
        public ProfilerRecorderSample[] ToArray() => Array.Empty<ProfilerRecorderSample>();
        public void CopyTo(List<ProfilerRecorderSample> outSamples, bool reset = false) => outSamples.Clear();
        public void Start() { }
        public void Stop() { }
        public void Reset() { }
        public void Dispose() { }
    }

    public struct ProfilerRecorderSample
    {
        public long Value => 0;
        public long Count => 0;
    }

    [Flags]
    public enum ProfilerRecorderOptions
    {
        None = 0, StartImmediately = 1, KeepAliveDuringDomainReload = 2, CollectOnlyOnCurrentThread = 4, WrapAroundWhenCapacityReached = 8,
        SumAllSamplesInFrame = 16, GpuRecorder = 64, Default = WrapAroundWhenCapacityReached | SumAllSamplesInFrame,
    }

    public enum ProfilerMarkerDataUnit : byte { Undefined = 0, TimeNanoseconds = 1, Bytes = 2, Count = 3, Percent = 4, FrequencyHz = 5 }
}
