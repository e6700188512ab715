#if SRP_17
using System;
using System.Collections.Generic;
using System.Runtime.CompilerServices;
using UnityEngine.Headless;

namespace UnityEngine.Rendering.RenderGraphModule
{
    [Flags]
    public enum AccessFlags
    {
        None = 0,
        Read = 1 << 0,
        Write = 1 << 1,
        Discard = 1 << 2,
        WriteAll = Write | Discard,
        ReadWrite = Read | Write,
    }

    public delegate void BaseRenderFunc<PassData, ContextType>(PassData data, ContextType renderGraphContext) where PassData : class, new();

    public interface IRenderGraphRecorder
    {
        void RecordRenderGraph(RenderGraph renderGraph, ContextContainer frameData);
    }

    public class UnsafeGraphContext
    {
        public UnsafeCommandBuffer cmd;
    }

    public interface IBaseRenderGraphBuilder : IDisposable
    {
        void UseTexture(in TextureHandle input, AccessFlags flags = AccessFlags.Read);
        void UseGlobalTexture(int propertyId, AccessFlags flags = AccessFlags.Read);
        void UseAllGlobalTextures(bool enable);
        void AllowPassCulling(bool value);
        void AllowGlobalStateModification(bool value);
    }

    public interface IUnsafeRenderGraphBuilder : IBaseRenderGraphBuilder
    {
        void SetRenderFunc<PassData>(BaseRenderFunc<PassData, UnsafeGraphContext> renderFunc) where PassData : class, new();
    }

    /// <summary>
    /// Passes of a frame in the order of recording, with what each declares. As in Unity, a pass that writes nothing that the graph
    /// knows of is left out unless it says otherwise; a handle is good for one frame and inside of passes only. Stricter
    /// than Unity: a pass gets no texture that it has not declared, where Unity gives out whatever lies in memory.
    /// </summary>
    /// <remarks>Read in SRP Core 17.1.0: Runtime/RenderGraph/RenderGraph.cs, RenderGraphBuilders.cs, RenderGraphResourceRegistry.cs,
    /// Compiler/PassesData.cs.</remarks>
    public class RenderGraph
    {
        internal sealed class Resource
        {
            public string Name;
            public RTHandle Handle;
            public bool IsWritten;
        }

        readonly List<Resource> resources = new List<Resource>();
        readonly List<Pass> passes = new List<Pass>();
        readonly Dictionary<int, TextureHandle> globals = new Dictionary<int, TextureHandle>();
        int frame;
        bool isRecording;

        /// <summary>Graph in which conversions of handles look resources up; null outside of an execution.</summary>
        internal static RenderGraph Executing { get; private set; }

        internal static Pass Running { get; private set; }

        public string name { get; }

        public RenderGraph(string name = "RenderGraph") => this.name = name;

        internal void BeginRecording()
        {
            isRecording = true;
            frame++;
        }

        internal void End()
        {
            isRecording = false;
            passes.Clear();
            resources.Clear();
            globals.Clear();
        }

        internal TextureHandle Import(string name, RTHandle handle, bool isWritten)
        {
            resources.Add(new Resource { Name = name, Handle = handle, IsWritten = isWritten });
            return new TextureHandle { graph = this, frame = frame, index = resources.Count };
        }

        internal Resource Find(in TextureHandle handle) => resources[handle.index - 1];

        internal void MarkWritten(in TextureHandle handle) => Find(handle).IsWritten = true;

        internal void SetGlobal(int propertyId, in TextureHandle handle)
        {
            globals[propertyId] = handle;
            Shader.SetGlobalTexture(propertyId, Find(handle).Handle.rt);
        }

        internal bool IsCurrent(in TextureHandle handle) => handle.frame == frame && handle.index > 0 && handle.index <= resources.Count;

        public IUnsafeRenderGraphBuilder AddUnsafePass<PassData>(string passName, out PassData passData, [CallerFilePath] string file = "",
            [CallerLineNumber] int line = 0) where PassData : class, new()
        {
            if (!isRecording)
                throw new InvalidOperationException($"Render Graph Execution error: the pass '{passName}' is added outside of a recording.");
            passData = new PassData();
            var pass = new Pass(this, passName);
            passes.Add(pass);
            return new Builder<PassData>(pass, passData);
        }

        /// <summary>Runs what was recorded since the last call.</summary>
        internal void Execute(CommandBuffer cmd)
        {
            foreach (Pass pass in passes)
            {
                if (!pass.IsClosed)
                    throw new InvalidOperationException($"Render Graph Execution error: the builder of the pass '{pass.Name}' was not disposed of.");
                if (pass.Run == null)
                    throw new InvalidOperationException($"RenderPass {pass.Name} has no Execute function.");
                if (pass.IsCulled)
                    continue;
                Executing = this;
                Running = pass;
                try
                {
                    pass.CheckReads();
                    pass.Run(new UnsafeGraphContext { cmd = new UnsafeCommandBuffer(cmd) });
                    Withhold(pass);
                    cmd.Execute();
                }
                finally
                {
                    Executing = null;
                    Running = null;
                    GpuChecks.Withheld.Clear();
                    cmd.Clear();
                }
            }
            passes.Clear();
        }

        // Globals reach shaders past the handles: there Unity's memory may be released, or another's by now.
        void Withhold(Pass pass)
        {
            for (int i = 0; i < resources.Count; i++)
                if (!pass.HasDeclared(new TextureHandle { graph = this, frame = frame, index = i + 1 }))
                    GpuChecks.Withheld.Add(resources[i].Handle.rt);
            GpuChecks.WithheldBecause = $"which the pass '{pass.Name}' of the render graph has not declared: UseTexture";
        }

        internal sealed class Pass
        {
            readonly RenderGraph graph;
            readonly List<(TextureHandle Handle, AccessFlags Flags)> used = new List<(TextureHandle, AccessFlags)>();
            bool usesAllGlobals;

            public readonly string Name;
            public Action<UnsafeGraphContext> Run;
            public bool AllowsCulling = true, IsClosed;

            public Pass(RenderGraph graph, string name) => (this.graph, Name) = (graph, name);

            public bool IsCulled => AllowsCulling && !used.Exists(use => (use.Flags & AccessFlags.Write) != 0);

            public void Use(in TextureHandle handle, AccessFlags flags)
            {
                if (!handle.IsValid())
                    throw new ArgumentException($"Trying to use an invalid resource (pass {Name}).");
                if (!graph.IsCurrent(handle))
                    throw new ArgumentException($"Trying to use a texture of another frame or graph (pass {Name}).");
                used.Add((handle, flags));
            }

            public void UseGlobal(int propertyId, AccessFlags flags)
            {
                if (!graph.globals.TryGetValue(propertyId, out TextureHandle handle))
                    throw new ArgumentException($"Trying to read global texture property {propertyId} but no previous pass in the " +
                        $"graph assigned a value to this global.");
                Use(handle, flags);
            }

            public void UseGlobals(bool enable) => usesAllGlobals = enable;

            public bool HasDeclared(TextureHandle handle)
            {
                if (usesAllGlobals)
                    foreach (TextureHandle global in graph.globals.Values)
                        if (global.index == handle.index)
                            return true;
                return used.Exists(use => use.Handle.index == handle.index);
            }

            public void CheckReads()
            {
                foreach ((TextureHandle handle, AccessFlags flags) in used)
                    if ((flags & AccessFlags.Read) != 0 && !graph.Find(handle).IsWritten)
                        throw new InvalidOperationException(
                            $"In pass '{Name}' - Trying to read from a texture ({graph.Find(handle).Name}) that nothing has written to yet.");
            }
        }

        sealed class Builder<Data> : IUnsafeRenderGraphBuilder where Data : class, new()
        {
            readonly Pass pass;
            readonly Data data;

            public Builder(Pass pass, Data data) => (this.pass, this.data) = (pass, data);

            public void UseTexture(in TextureHandle input, AccessFlags flags = AccessFlags.Read) => Open().Use(input, flags);
            public void UseGlobalTexture(int propertyId, AccessFlags flags = AccessFlags.Read) => Open().UseGlobal(propertyId, flags);
            public void UseAllGlobalTextures(bool enable) => Open().UseGlobals(enable);
            public void AllowPassCulling(bool value) => Open().AllowsCulling = value;
            public void AllowGlobalStateModification(bool value)
            {
                // Such a pass is never left out: its effects are not known.
                if (value)
                    AllowPassCulling(false);
            }

            public void SetRenderFunc<PassData>(BaseRenderFunc<PassData, UnsafeGraphContext> renderFunc) where PassData : class, new() =>
                Open().Run = context => renderFunc((PassData)(object)data, context);

            public void Dispose() => pass.IsClosed = true;

            Pass Open() => pass.IsClosed ? throw new InvalidOperationException(
                $"The builder of the pass '{pass.Name}' is used after it was disposed of.") : pass;
        }
    }

    /// <summary>A texture of one frame's graph: good for what RenderGraph says.</summary>
    public struct TextureHandle
    {
        internal RenderGraph graph;
        internal int frame, index;

        public static TextureHandle nullHandle => default;

        public bool IsValid() => index > 0;

        public static implicit operator RTHandle(TextureHandle texture) => texture.IsValid() ? texture.Get() : null;
        public static implicit operator RenderTargetIdentifier(TextureHandle texture) => texture.IsValid() ? texture.Get().nameID : default;
        public static implicit operator Texture(TextureHandle texture) => texture.IsValid() ? texture.Get().rt : null;
        public static implicit operator RenderTexture(TextureHandle texture) => texture.IsValid() ? texture.Get().rt : null;

        RTHandle Get()
        {
            // Unity's registry is null there: a NullReferenceException without a word.
            RenderGraph running = RenderGraph.Executing
                ?? throw new InvalidOperationException("A TextureHandle is used outside of a pass of the render graph.");
            if (running != graph || !running.IsCurrent(this))
                throw new InvalidOperationException($"Trying to use a texture of another frame or graph (pass {RenderGraph.Running.Name}).");
            if (!RenderGraph.Running.HasDeclared(this))
                throw new InvalidOperationException($"Trying to use a texture ({running.Find(this).Name}) that the pass " +
                    $"'{RenderGraph.Running.Name}' has not declared: Make sure you declare it for reading in your pass.");
            return running.Find(this).Handle;
        }
    }
}
#endif
