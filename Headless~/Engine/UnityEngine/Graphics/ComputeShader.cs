using System;
using System.Runtime.InteropServices;
using UnityEngine.Headless;
using UnityEngine.Rendering;

namespace UnityEngine
{
    /// <summary>
    /// Values are per asset, buffers and textures per kernel. A command buffer's SetCompute* writes here when it executes,
    /// so its values stay for later dispatches of the same asset, as in Unity.
    /// </summary>
    public sealed class ComputeShader : Object
    {
        readonly ComputeShaderSource source;
        readonly Kernel[] kernels;
        readonly KeywordSet keywords = new KeywordSet();

        internal readonly KeywordSpace Keywords;
        internal readonly PropertyTable Values = new PropertyTable();

        struct Kernel
        {
            public PropertyTable Resources;
            public ProgramLayout Layout;
            /// <summary>For messages, made once: nothing is formatted while all is well.</summary>
            public string Name, IndirectCall;
            public int KeywordVersion, GlobalVersion;
            public bool Failed;
        }

        ComputeShader(ComputeShaderSource source)
        {
            this.source = source;
            name = System.IO.Path.GetFileNameWithoutExtension(source.Path);
            Keywords = new KeywordSpace(name, source.Keywords);
            kernels = new Kernel[source.Kernels.Count];
            for (int i = 0; i < kernels.Length; i++)
            {
                string label = $"{name}.compute ({source.Kernels[i]})";
                kernels[i] = new Kernel { Resources = new PropertyTable(), KeywordVersion = -1, Name = label,
                    IndirectCall = "DispatchIndirect of " + label };
            }
        }

        internal static ComputeShader Create(ComputeShaderSource source) => new ComputeShader(source);
        internal ComputeShaderSource Source => source;
        internal PropertyTable KernelResources(int kernel) => kernels[kernel].Resources;

        // ---- kernels

        public int FindKernel(string name)
        {
            for (int i = 0; i < kernels.Length; i++)
                if (source.Kernels[i] == name)
                    return i;
            throw new ArgumentException($"Kernel '{name}' not found in {source.Path}; it has: {string.Join(", ", source.Kernels)}.");
        }

        public bool HasKernel(string name)
        {
            for (int i = 0; i < kernels.Length; i++)
                if (source.Kernels[i] == name)
                    return true;
            return false;
        }

        public bool IsSupported(int kernelIndex)
        {
            if (!CheckKernel(kernelIndex, "IsSupported") || !Gpu.Available)
                return false;
            ProgramLayout layout = Layout(kernelIndex, report: false);
            return layout != null && layout.Excess == null
                && layout.Program.GroupX * layout.Program.GroupY * layout.Program.GroupZ <= Player.Device.Info.MaxGroupInvocations
                && layout.Program.GroupsharedBytes <= Player.Device.Info.MaxGroupsharedBytes;
        }

        public void GetKernelThreadGroupSizes(int kernelIndex, out uint x, out uint y, out uint z)
        {
            x = y = z = 0;
            if (!CheckKernel(kernelIndex, "GetKernelThreadGroupSizes"))
                return;
            ProgramLayout layout = Layout(kernelIndex, report: true);
            if (layout == null)
                return;
            x = (uint)layout.Program.GroupX;
            y = (uint)layout.Program.GroupY;
            z = (uint)layout.Program.GroupZ;
        }

        /// <summary>Changes with every change of a keyword.</summary>
        internal int KeywordVersion => keywords.Version;

        internal string KernelName(int kernel) => kernels[kernel].Name;

        /// <summary>Throws in strict mode, logs and answers false otherwise.</summary>
        internal bool CheckKernel(int kernel, string call)
        {
            if ((uint)kernel < (uint)kernels.Length)
                return true;
            GpuError.Report($"{call}: {source.Path} has no kernel of index {kernel}; it has {kernels.Length}.",
                $"{name}.compute: Kernel index ({kernel}) out of range");
            return false;
        }

        /// <summary>The program for the keywords now enabled; null when it does not compile (reported).</summary>
        internal ProgramLayout Layout(int index, bool report)
        {
            ref Kernel kernel = ref kernels[index];
            if (kernel.KeywordVersion == keywords.Version && kernel.GlobalVersion == GlobalKeywords.Set.Version)
                return kernel.Layout;
            try
            {
                kernel.Layout = ProgramLayout.Of(source.Compile(index, KeywordUnion.Of(keywords, GlobalKeywords.Set)));
                kernel.Failed = false;
            }
            catch (ShaderCompileException error) when (!Player.Strict)
            {
                if (report && !kernel.Failed)
                    Debug.LogError($"Shader error in '{name}': {error.Message}");
                kernel.Failed = true;
                kernel.Layout = null;
            }
            kernel.KeywordVersion = keywords.Version;
            kernel.GlobalVersion = GlobalKeywords.Set.Version;
            return kernel.Layout;
        }

        // ---- dispatch

        public void Dispatch(int kernelIndex, int threadGroupsX, int threadGroupsY, int threadGroupsZ)
        {
            if (!Prepare(kernelIndex, "Dispatch", out ProgramLayout layout)
                || !GpuChecks.Groups(KernelName(kernelIndex), threadGroupsX, threadGroupsY, threadGroupsZ))
                return;
            if (!Binder.Compute(this, kernelIndex, layout))
                return;
            Gpu.Device.Dispatch(DeviceObjects.Kernel(layout.Program), Binder.Bindings, threadGroupsX, threadGroupsY, threadGroupsZ);
            Binder.MarkWritten();
        }

        public void DispatchIndirect(int kernelIndex, ComputeBuffer argsBuffer) => DispatchIndirect(kernelIndex, argsBuffer?.Storage, 0);
        public void DispatchIndirect(int kernelIndex, ComputeBuffer argsBuffer, uint argsOffset)
            => DispatchIndirect(kernelIndex, argsBuffer?.Storage, argsOffset);
        public void DispatchIndirect(int kernelIndex, GraphicsBuffer argsBuffer) => DispatchIndirect(kernelIndex, argsBuffer?.Storage, 0);
        public void DispatchIndirect(int kernelIndex, GraphicsBuffer argsBuffer, uint argsOffset)
            => DispatchIndirect(kernelIndex, argsBuffer?.Storage, argsOffset);

        internal void DispatchIndirect(int kernelIndex, BufferStorage arguments, uint offset)
        {
            if (!Prepare(kernelIndex, "DispatchIndirect", out ProgramLayout layout) ||
                !BufferChecks.Arguments(arguments, kernels[kernelIndex].IndirectCall, offset, 12))
                return;
            GpuChecks.WatchArguments(KernelName(kernelIndex), arguments, offset);
            if (!Binder.Compute(this, kernelIndex, layout))
                return;
            Gpu.Device.DispatchIndirect(DeviceObjects.Kernel(layout.Program), Binder.Bindings, arguments.Device, offset);
            Binder.MarkWritten();
        }

        bool Prepare(int kernel, string call, out ProgramLayout layout)
        {
            layout = null;
            if (!Gpu.Available)
                throw Gpu.NoDevice($"{call} on {name}");
            if (!CheckKernel(kernel, call))
                return false;
            layout = Layout(kernel, report: true);
            if (layout == null)
            {
                Debug.LogError($"{name}.compute: Kernel at index ({kernel}) is invalid");
                return false;
            }
            return GpuChecks.Program(layout);
        }

        // ---- values; bits are taken as they are, arrays are not spread to 16 bytes an element

        internal void SetRaw(int id, PropertyKind kind, ReadOnlySpan<byte> bytes) => Values.Overwrite(id, kind, bytes);
        void Set<T>(int id, PropertyKind kind, T value) where T : struct
            => SetRaw(id, kind, MemoryMarshal.AsBytes(MemoryMarshal.CreateReadOnlySpan(ref value, 1)));
        void Set<T>(int id, PropertyKind kind, T[] values) where T : struct
            => SetRaw(id, kind, MemoryMarshal.AsBytes<T>(values ?? throw new ArgumentNullException(nameof(values))));

        public void SetFloat(int nameID, float val) => Set(nameID, PropertyKind.Float, val);
        public void SetFloat(string name, float val) => SetFloat(Shader.PropertyToID(name), val);
        public void SetFloats(int nameID, params float[] values) => Set(nameID, PropertyKind.Float, values);
        public void SetFloats(string name, params float[] values) => SetFloats(Shader.PropertyToID(name), values);
        public void SetInt(int nameID, int val) => Set(nameID, PropertyKind.Int, val);
        public void SetInt(string name, int val) => SetInt(Shader.PropertyToID(name), val);
        public void SetInts(int nameID, params int[] values) => Set(nameID, PropertyKind.Int, values);
        public void SetInts(string name, params int[] values) => SetInts(Shader.PropertyToID(name), values);
        public void SetBool(int nameID, bool val) => SetInt(nameID, val ? 1 : 0);
        public void SetBool(string name, bool val) => SetInt(Shader.PropertyToID(name), val ? 1 : 0);
        public void SetVector(int nameID, Vector4 val) => Set(nameID, PropertyKind.Vector, val);
        public void SetVector(string name, Vector4 val) => SetVector(Shader.PropertyToID(name), val);
        public void SetVectorArray(int nameID, Vector4[] values) => Set(nameID, PropertyKind.Vector, values);
        public void SetVectorArray(string name, Vector4[] values) => SetVectorArray(Shader.PropertyToID(name), values);
        public void SetMatrix(int nameID, Matrix4x4 val) => Set(nameID, PropertyKind.Matrix, val);
        public void SetMatrix(string name, Matrix4x4 val) => SetMatrix(Shader.PropertyToID(name), val);
        public void SetMatrixArray(int nameID, Matrix4x4[] values) => Set(nameID, PropertyKind.Matrix, values);
        public void SetMatrixArray(string name, Matrix4x4[] values) => SetMatrixArray(Shader.PropertyToID(name), values);

        // ---- buffers and textures

        internal void SetBuffer(int kernelIndex, int nameID, BufferStorage buffer)
        {
            if (buffer == null)
                throw new ArgumentNullException(nameof(buffer), $"SetBuffer of '{PropertyNames.ToName(nameID)}' on {name}: the buffer is null.");
            if (buffer.IsReleased)
                BufferChecks.Alive(buffer, $"SetBuffer of '{PropertyNames.ToName(nameID)}' on {name}");
            if (CheckKernel(kernelIndex, "SetBuffer"))
                kernels[kernelIndex].Resources.SetResource(nameID, new PropertyResource { Buffer = buffer, KeywordVersion = keywords.Version });
        }

        public void SetBuffer(int kernelIndex, int nameID, ComputeBuffer buffer) => SetBuffer(kernelIndex, nameID, buffer?.Storage);
        public void SetBuffer(int kernelIndex, string name, ComputeBuffer buffer)
            => SetBuffer(kernelIndex, Shader.PropertyToID(name), buffer?.Storage);
        public void SetBuffer(int kernelIndex, int nameID, GraphicsBuffer buffer) => SetBuffer(kernelIndex, nameID, buffer?.Storage);
        public void SetBuffer(int kernelIndex, string name, GraphicsBuffer buffer)
            => SetBuffer(kernelIndex, Shader.PropertyToID(name), buffer?.Storage);

        public void SetConstantBuffer(int nameID, ComputeBuffer buffer, int offset, int size)
            => Values.SetConstantBuffer(nameID, buffer?.Storage, offset, size);
        public void SetConstantBuffer(string name, ComputeBuffer buffer, int offset, int size)
            => SetConstantBuffer(Shader.PropertyToID(name), buffer, offset, size);
        public void SetConstantBuffer(int nameID, GraphicsBuffer buffer, int offset, int size)
            => Values.SetConstantBuffer(nameID, buffer?.Storage, offset, size);
        public void SetConstantBuffer(string name, GraphicsBuffer buffer, int offset, int size)
            => SetConstantBuffer(Shader.PropertyToID(name), buffer, offset, size);

        internal void SetTexture(int kernelIndex, int nameID, Texture texture, int mip, RenderTextureSubElement element)
        {
            if (texture == null)
                throw new ArgumentNullException(nameof(texture), $"SetTexture of '{PropertyNames.ToName(nameID)}' on {name}: the texture is null.");
            if (mip < 0 || mip >= texture.mipmapCount)
                throw new ArgumentOutOfRangeException(nameof(mip), mip, $"SetTexture of '{PropertyNames.ToName(nameID)}' on {name}: " +
                    $"texture '{texture.name}' has {texture.mipmapCount} mip levels.");
            if (CheckKernel(kernelIndex, "SetTexture"))
                kernels[kernelIndex].Resources.SetResource(nameID,
                    new PropertyResource { Texture = texture, Mip = mip, Element = element, KeywordVersion = keywords.Version });
        }

        public void SetTexture(int kernelIndex, int nameID, Texture texture)
            => SetTexture(kernelIndex, nameID, texture, 0, RenderTextureSubElement.Default);
        public void SetTexture(int kernelIndex, string name, Texture texture) => SetTexture(kernelIndex, Shader.PropertyToID(name), texture);
        public void SetTexture(int kernelIndex, int nameID, Texture texture, int mipLevel)
            => SetTexture(kernelIndex, nameID, texture, mipLevel, RenderTextureSubElement.Default);
        public void SetTexture(int kernelIndex, string name, Texture texture, int mipLevel)
            => SetTexture(kernelIndex, Shader.PropertyToID(name), texture, mipLevel);
        public void SetTexture(int kernelIndex, int nameID, RenderTexture texture, int mipLevel, RenderTextureSubElement element)
            => SetTexture(kernelIndex, nameID, (Texture)texture, mipLevel, element);
        public void SetTexture(int kernelIndex, string name, RenderTexture texture, int mipLevel, RenderTextureSubElement element)
            => SetTexture(kernelIndex, Shader.PropertyToID(name), (Texture)texture, mipLevel, element);

        public void SetTextureFromGlobal(int kernelIndex, int nameID, int globalTextureNameID)
        {
            Texture texture = Shader.Globals.GetTexture(globalTextureNameID);
            if (ReferenceEquals(texture, null))
                GpuError.Report($"SetTextureFromGlobal on {name}: no global texture '{PropertyNames.ToName(globalTextureNameID)}' is set.",
                    $"Global texture ({PropertyNames.ToName(globalTextureNameID)}) not found");
            else
                SetTexture(kernelIndex, nameID, texture);
        }

        public void SetTextureFromGlobal(int kernelIndex, string name, string globalTextureName)
            => SetTextureFromGlobal(kernelIndex, Shader.PropertyToID(name), Shader.PropertyToID(globalTextureName));

        // ---- keywords

        public LocalKeywordSpace keywordSpace => new LocalKeywordSpace(Keywords);
        public string[] shaderKeywords { get => keywords.ToArray(); set => keywords.Replace(value ?? Array.Empty<string>()); }

        public LocalKeyword[] enabledKeywords
        {
            get => KeywordUnion.Local(Keywords, keywords);
            set => keywords.Replace(Array.ConvertAll(value ?? Array.Empty<LocalKeyword>(), k => k.name));
        }

        public void EnableKeyword(string keyword) => keywords.Set(keyword, true);
        public void DisableKeyword(string keyword) => keywords.Set(keyword, false);
        public bool IsKeywordEnabled(string keyword) => keywords.Has(keyword);
        public void EnableKeyword(in LocalKeyword keyword) => SetKeyword(keyword, true);
        public void DisableKeyword(in LocalKeyword keyword) => SetKeyword(keyword, false);
        public bool IsKeywordEnabled(in LocalKeyword keyword) => keywords.Has(keyword.name);

        public void SetKeyword(in LocalKeyword keyword, bool value)
        {
            if (KeywordUnion.Belongs(keyword, Keywords))
                keywords.Set(keyword.name, value);
        }
    }
}
