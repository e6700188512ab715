using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using Unity.Profiling;
using UnityEngine.Headless;
using UnityEngine.Profiling;

namespace UnityEngine.Rendering
{
    /// <summary>
    /// A list of commands, each a small struct; numbers go into one byte array, what is bound is held by reference.
    /// Values are taken when a command is recorded, resources are looked at when it executes.
    /// </summary>
    public partial class CommandBuffer : IDisposable
    {
        enum Op : byte
        {
            ComputeValue, ComputeBuffer, ComputeConstantBuffer, ComputeTexture, ComputeKeyword, ComputeFromMaterial, Dispatch, DispatchIndirect,
            BufferData, BufferCounter, CopyCounter, CopyBuffer, CopyTexture,
            GlobalValue, GlobalTexture, GlobalBuffer, GlobalConstantBuffer, GlobalKeyword, MaterialKeyword,
            SetTarget, SetTargets, Clear, Viewport, ViewProjection, View, Projection, InvertCulling, Draw, Blit, BlitSlice, TemporaryTarget,
                ReleaseTemporary,
            BeginSample, EndSample, Readback, WaitReadbacks,
        }

        struct Command
        {
            public Op Op;
            public bool Flag;
            public PropertyKind Kind;
            public int A, B, C, D, E;
            /// <summary>Index of the command's numbers in <see cref="payload"/>.</summary>
            public int Data, DataLength;
            public object Subject, Object;
        }

        Command[] commands = new Command[32];
        int commandCount;
        byte[] payload = new byte[256];
        int payloadLength;
        readonly List<DrawCall> draws = new List<DrawCall>();
        readonly List<RenderTargetIdentifier> targets = new List<RenderTargetIdentifier>();
        readonly List<string> openSamples = new List<string>();
        /// <summary>Stands for this in the list of live objects, which must not keep it from being collected.</summary>
        readonly object life = new object();
        bool disposed;

        public CommandBuffer()
        {
            name = "";
            LiveObjects.Add(life, "CommandBuffer", "");
        }

        ~CommandBuffer() => LiveObjects.Remove(life);   // managed memory only: dropping one leaks nothing, as Unity has it

        public string name
        {
            get => label;
            set
            {
                label = value ?? "";
                if (!disposed)
                    LiveObjects.Add(life, "CommandBuffer", label);
            }
        }
        string label;

        public int sizeInBytes => commandCount * 64 + payloadLength;

        public void Clear()
        {
            Array.Clear(commands, 0, commandCount);     // lets go of what was bound
            commandCount = payloadLength = 0;
            draws.Clear();
            targets.Clear();
            openSamples.Clear();
        }

        public void Release() => Dispose();

        public void Dispose()
        {
            if (disposed)
                return;
            Clear();
            disposed = true;
            LiveObjects.Remove(life);
            GC.SuppressFinalize(this);
        }

        // ---- recording

        ref Command Add(Op op)
        {
            if (disposed)
                throw new ObjectDisposedException(nameof(CommandBuffer), $"CommandBuffer '{label}' was released before this use.");
            if (commandCount == commands.Length)
                Array.Resize(ref commands, commandCount * 2);
            ref Command command = ref commands[commandCount++];
            command = new Command { Op = op };
            return ref command;
        }

        void Store(ref Command command, ReadOnlySpan<byte> bytes)
        {
            if (payload.Length < payloadLength + bytes.Length)
                Array.Resize(ref payload, Math.Max(payload.Length * 2, payloadLength + bytes.Length));
            command.Data = payloadLength;
            command.DataLength = bytes.Length;
            bytes.CopyTo(payload.AsSpan(payloadLength));
            payloadLength = (payloadLength + bytes.Length + 3) & ~3;
        }

        void Store<T>(ref Command command, T value) where T : struct
            => Store(ref command, MemoryMarshal.AsBytes(MemoryMarshal.CreateReadOnlySpan(ref value, 1)));
        void Store<T>(ref Command command, T[] values) where T : struct => Store(ref command, MemoryMarshal.AsBytes<T>(values));

        int AddTarget(in RenderTargetIdentifier target)
        {
            targets.Add(target);
            return targets.Count - 1;
        }

        ReadOnlySpan<byte> Data(in Command command) => payload.AsSpan(command.Data, command.DataLength);
        T Data<T>(in Command command) where T : struct => MemoryMarshal.Read<T>(Data(command));

        // ---- samples

        public void BeginSample(string name)
        {
            Add(Op.BeginSample).Subject = name ?? "";
            openSamples.Add(name ?? "");
        }

        public void EndSample(string name)
        {
            int last = openSamples.Count - 1;
            if (last < 0 || openSamples[last] != (name ?? ""))
            {
                GpuError.Report($"CommandBuffer '{label}': EndSample(\"{name}\") does not end the sample that is open " +
                    $"({(last < 0 ? "none" : $"\"{openSamples[last]}\"")}).",
                    $"Non matching Profiler.EndSample (\"{name}\")");
                return;
            }
            openSamples.RemoveAt(last);
            Add(Op.EndSample);
        }

        public void BeginSample(CustomSampler sampler) => BeginSample(sampler.name);
        public void EndSample(CustomSampler sampler) => EndSample(sampler.name);
        public void BeginSample(ProfilerMarker marker) => BeginSample(marker.Name);
        public void EndSample(ProfilerMarker marker) => EndSample(marker.Name);

        // ---- execution

        /// <summary>Plays the commands; may be done again and again.</summary>
        internal void Execute()
        {
            if (disposed)
                throw new ObjectDisposedException(nameof(CommandBuffer), $"CommandBuffer '{label}' was released before it was executed.");
            for (int i = 0; i < commandCount; i++)
                Execute(ref commands[i]);
        }

        void Execute(ref Command c)
        {
            switch (c.Op)
            {
                case Op.ComputeValue: Alive((ComputeShader)c.Subject).SetRaw(c.A, c.Kind, Data(c)); break;
                case Op.ComputeBuffer: Alive((ComputeShader)c.Subject).SetBuffer(c.B, c.A, (BufferStorage)c.Object); break;
                case Op.ComputeConstantBuffer: Alive((ComputeShader)c.Subject).Values.SetConstantBuffer(c.A, (BufferStorage)c.Object, c.B,
                    c.C); break;
                case Op.ComputeTexture: Alive((ComputeShader)c.Subject).SetTexture(c.B, c.A, targets[c.C].Resolve(), c.D,
                    (RenderTextureSubElement)c.E); break;
                case Op.ComputeKeyword: Keyword((ComputeShader)c.Subject, (string)c.Object, c.Flag); break;
                case Op.ComputeFromMaterial: FromMaterial((ComputeShader)c.Subject, c.B, (Material)c.Object); break;
                case Op.Dispatch:
                    BeginKernel(c);
                    Alive((ComputeShader)c.Subject).Dispatch(c.B, c.C, c.D, c.E);
                    EndKernel();
                    break;
                case Op.DispatchIndirect:
                    BeginKernel(c);
                    Alive((ComputeShader)c.Subject).DispatchIndirect(c.B, (BufferStorage)c.Object, (uint)c.C);
                    EndKernel();
                    break;

                case Op.BufferData:
                    (c.Subject as RecordedArray)?.Check(Data(c), (BufferStorage)c.Object);
                    Upload((BufferStorage)c.Object, (uint)c.A, Data(c));
                    break;
                case Op.BufferCounter: ((BufferStorage)c.Object).SetCounter((uint)c.A); break;
                case Op.CopyCounter: BufferStorage.CopyCount((BufferStorage)c.Subject, (BufferStorage)c.Object, (uint)c.A); break;
                case Op.CopyBuffer: GraphicsCopies.Buffer((BufferStorage)c.Subject, (BufferStorage)c.Object); break;
                case Op.CopyTexture: CopyTexture(c); break;

                case Op.GlobalValue: Shader.Globals.Set(c.A, c.Kind, c.Flag, Data(c)); break;
                case Op.GlobalTexture: Shader.Globals.SetTexture(c.A, targets[c.B].Resolve(), (RenderTextureSubElement)c.C); break;
                case Op.GlobalBuffer: Shader.Globals.SetBuffer(c.A, (BufferStorage)c.Object); break;
                case Op.GlobalConstantBuffer: Shader.Globals.SetConstantBuffer(c.A, (BufferStorage)c.Object, c.B, c.C); break;
                case Op.GlobalKeyword: Shader.SetGlobalKeyword((string)c.Object, c.Flag); break;
                case Op.MaterialKeyword:
                    if (c.Flag)
                        ((Material)c.Subject).EnableKeyword((string)c.Object);
                    else
                        ((Material)c.Subject).DisableKeyword((string)c.Object);
                    break;

                case Op.SetTarget: SetTarget(c); break;
                case Op.SetTargets: SetTargets(c); break;
                case Op.Clear: RenderState.Clear((c.A & 1) != 0, (c.A & 2) != 0, (Color)Data<Vector4>(c), BitConverter.Int32BitsToSingle(c.B)); break;
                case Op.Viewport: RenderState.SetViewport(Data<Rect>(c)); break;
                case Op.ViewProjection:
                    ReadOnlySpan<Matrix4x4> both = MemoryMarshal.Cast<byte, Matrix4x4>(Data(c));
                    BuiltinVariables.SetViewProjection(both[0], both[1]);
                    break;
                case Op.View: BuiltinVariables.SetViewProjection(Data<Matrix4x4>(c), RenderState.Projection); break;
                case Op.Projection: BuiltinVariables.SetViewProjection(RenderState.View, Data<Matrix4x4>(c)); break;
                case Op.InvertCulling: RenderState.InvertCulling = c.Flag; break;
                case Op.Draw: Drawing.Draw(draws[c.A]); break;
                case Op.Blit: Blit(c); break;
                case Op.BlitSlice: BlitSlice(c); break;
                case Op.TemporaryTarget: TemporaryTargets.Get(c.A, (RenderTextureDescriptor)c.Object, (FilterMode)c.B); break;
                case Op.ReleaseTemporary: TemporaryTargets.Release(c.A); break;

                case Op.BeginSample:
                    if (Player.Device != null && Player.Device.Timing)
                        Gpu.Device.BeginSample((string)c.Subject);
                    GpuSamples.Begin((string)c.Subject);
                    break;
                case Op.EndSample:
                    if (Player.Device != null && Player.Device.Timing)
                        Gpu.Device.EndSample();
                    GpuSamples.End();
                    break;
                case Op.Readback: ((RecordedReadback)c.Subject).Execute(); break;
                case Op.WaitReadbacks: ReadbackQueue.WaitAll(); break;
                default: throw new InvalidOperationException($"Unknown command {c.Op}.");
            }
        }

        static bool TimesKernels => Player.TimesKernels && Player.Device != null && Player.Device.Timing;

        static void BeginKernel(in Command c)
        {
            if (TimesKernels)
                Gpu.Device.BeginSample(Alive((ComputeShader)c.Subject).KernelName(c.B));
        }

        static void EndKernel()
        {
            if (TimesKernels)
                Gpu.Device.EndSample();
        }

        static ComputeShader Alive(ComputeShader shader) =>
            shader.Destroyed ? throw new MissingReferenceException(
            "A ComputeShader recorded in a CommandBuffer was destroyed before it was executed.") : shader;

        static void Upload(BufferStorage buffer, long offset, ReadOnlySpan<byte> data)
        {
            BufferChecks.Alive(buffer, "SetBufferData");
            buffer.Upload(offset, data);
        }

        static void Keyword(ComputeShader shader, string keyword, bool value)
        {
            if (value)
                shader.EnableKeyword(keyword);
            else
                shader.DisableKeyword(keyword);
        }

        static void FromMaterial(ComputeShader shader, int kernel, Material material)
        {
            foreach (int id in material.Values.ValueIds)
                if (material.Values.TryGet(id, out PropertyValue value))
                    shader.SetRaw(id, value.Kind, value.Data.AsSpan(0, value.Length));
            foreach (KeyValuePair<int, PropertyResource> resource in material.Values.Resources)
            {
                PropertyResource bound = resource.Value;
                bound.KeywordVersion = shader.KeywordVersion;
                shader.KernelResources(kernel).SetResource(resource.Key, bound);
            }
        }
    }
}
