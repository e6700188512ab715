using System;
using System.Collections.Generic;

namespace UnityEngine.Headless
{
    /// <summary>State that the host gives to the engine assembly before anything runs, and that both look up.</summary>
    internal static class Player
    {
        /// <summary>Null = no graphics: SystemInfo reports it and every GPU object refuses by name.</summary>
        public static IGraphicsDevice Device;
        /// <summary>Throw where Unity is undefined or logs and goes on; garbage-fill new buffers. Off for foreign projects.</summary>
        public static bool Strict = true;
        public static IAssetSource Assets;
        public static int ScreenWidth = 1280, ScreenHeight = 720;
        public static string ProjectPath = "", ProductName = "Headless", CompanyName = "DefaultCompany";
        public static bool LinearColorSpace = true;
        /// <summary>Lets a test pretend that this is a player that tells less about its GPU time.</summary>
        public static GpuTimes GpuTimes = GpuTimes.Samples;
        /// <summary>While the device times, each dispatch of a command buffer is a sample of its own, named after its kernel.</summary>
        public static bool TimesKernels;
        /// <summary>Limits of the graphics API, or class of devices, that the player pretends to run on. Never null.</summary>
        public static ApiLimits Limits = ApiLimits.Direct3D11;
        /// <summary>Scriptable pipeline that draws: the RenderPipeline tag of its SubShaders, and its package with its version; ""
        /// and null for the Built-in pipeline.</summary>
        public static string PipelineTag = "", PipelinePackage, PipelineVersion;
        /// <summary>A headset is on: cameras without a target texture draw two eyes in one pass.</summary>
        public static bool Stereo;
        /// <summary>Lets a test or a command pretend that the machine cannot run compute shaders.</summary>
        public static bool PretendNoCompute;
    }

    internal enum GpuTimes
    {
        /// <summary>Like a development player on a device with GPU recorders.</summary>
        Samples,
        /// <summary>Like a release player with Frame Timing Stats.</summary>
        Frames,
        /// <summary>Like a release player.</summary>
        None,
    }

    /// <summary>Assets by path, name and GUID; implemented over a project's folders by the host.</summary>
    internal interface IAssetSource
    {
        /// <summary>Works like Resources.Load: path without extension below any Resources folder; null if it does not exist.</summary>
        Object LoadResource(string path, Type type);
        IEnumerable<Object> LoadAllResources(string path, Type type);
        /// <summary>By the name behind the Shader keyword; null when there is none.</summary>
        Shader FindShader(string name);
        /// <summary>By GUID of its .meta and local file id; null when there is none.</summary>
        Object LoadAsset(string guid, long fileId, Type type);
        /// <summary>"Assets/..." or "Packages/name/..." to a file on disk; null when there is none.</summary>
        string ResolvePath(string assetPath);
        /// <summary>The object of that type in the file at "Assets/..."; null when there is none.</summary>
        Object LoadAtPath(string assetPath, Type type);
        string GuidOfPath(string assetPath);
        string PathOfGuid(string guid);
        /// <summary>Paths of every file of the project.</summary>
        IEnumerable<string> AllPaths();
        /// <summary>Paths of the files that a text asset refers to; nothing for another kind of file.</summary>
        IEnumerable<string> ReferencesIn(string assetPath);
        /// <summary>Everything in the file, if it is one that makes objects.</summary>
        IEnumerable<Object> LoadAllAtPath(string assetPath);
        /// <summary>Tells where a loaded asset, or a part of one, came from. A built-in one is in "Library/unity default resources".</summary>
        bool TryIdentify(Object asset, out string assetPath, out string guid, out long fileId);
    }
}
