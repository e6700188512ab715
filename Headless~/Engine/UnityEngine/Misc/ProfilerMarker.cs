using System;
using Unity.Profiling.LowLevel;
using UnityEngine;

namespace Unity.Profiling
{
    /// <summary>Costs nothing here: the host times GPU work by command buffer samples.</summary>
    public struct ProfilerMarker
    {
        internal readonly string Name;

        public ProfilerMarker(string name) { Name = name; }
        public ProfilerMarker(ProfilerCategory category, string name) { Name = name; }
        public ProfilerMarker(ProfilerCategory category, string name, MarkerFlags flags)
        {
            Name = name;
            if ((flags & MarkerFlags.SampleGPU) != 0)
                UnityEngine.Headless.GpuSamples.Register(name);
        }

        public IntPtr Handle => IntPtr.Zero;
        public void Begin() { }
        public void Begin(UnityEngine.Object contextUnityObject) { }
        public void End() { }
        public AutoScope Auto() => default;

        public struct AutoScope : IDisposable
        {
            public void Dispose() { }
        }
    }

    public struct ProfilerCategory
    {
        readonly string name;

        public ProfilerCategory(string categoryName) { name = categoryName; }
        public ProfilerCategory(string categoryName, ProfilerCategoryColor color) { name = categoryName; }

        public string Name => name ?? "";
        public Color32 Color => new Color32(128, 128, 128, 255);
        public override string ToString() => Name;

        public static ProfilerCategory Render => new ProfilerCategory("Render");
        public static ProfilerCategory Scripts => new ProfilerCategory("Scripts");
        public static ProfilerCategory Gui => new ProfilerCategory("Gui");
        public static ProfilerCategory Physics => new ProfilerCategory("Physics");
        public static ProfilerCategory Physics2D => new ProfilerCategory("Physics2D");
        public static ProfilerCategory Animation => new ProfilerCategory("Animation");
        public static ProfilerCategory Ai => new ProfilerCategory("Ai");
        public static ProfilerCategory Audio => new ProfilerCategory("Audio");
        public static ProfilerCategory Video => new ProfilerCategory("Video");
        public static ProfilerCategory Particles => new ProfilerCategory("Particles");
        public static ProfilerCategory Lighting => new ProfilerCategory("Lighting");
        public static ProfilerCategory Network => new ProfilerCategory("Network");
        public static ProfilerCategory Loading => new ProfilerCategory("Loading");
        public static ProfilerCategory Vr => new ProfilerCategory("Vr");
        public static ProfilerCategory Input => new ProfilerCategory("Input");
        public static ProfilerCategory Memory => new ProfilerCategory("Memory");
        public static ProfilerCategory VirtualTexturing => new ProfilerCategory("VirtualTexturing");
        public static ProfilerCategory FileIO => new ProfilerCategory("FileIO");
        public static ProfilerCategory Internal => new ProfilerCategory("Internal");
    }

    public enum ProfilerCategoryColor : ushort
    {
        Render, Scripts, BurstJobs, Other, Physics, Animation, Audio, AudioJob, AudioUpdateJob, Lighting, GC, VSync, Memory, Internal, UI,
            Build, Input,
    }
}

namespace Unity.Profiling.LowLevel
{
    [Flags]
    public enum MarkerFlags : ushort
    {
        Default = 0, Script = 2, AvailabilityEditor = 4, AvailabilityNonDevelopment = 8, Warning = 16, ScriptInvoke = 32,
        ScriptDeepProfiler = 64, Counter = 128, SampleGPU = 256,
    }
}
