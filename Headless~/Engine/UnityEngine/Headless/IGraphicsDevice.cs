using System;
using System.Collections.Generic;

namespace UnityEngine.Headless
{
    /// <summary>
    /// The one line between Unity's API shape (above: validation, property names, keywords, command buffers) and a GPU
    /// (below: memory, descriptors, barriers, queues). Nothing above it knows Vulkan, nothing below it knows Unity.
    /// </summary>
    /// <remarks>
    /// Work methods append to one stream that the device executes in order: every call sees what earlier calls wrote
    /// (the device inserts the barriers). The stream runs when <see cref="Flush"/> or a read-back needs it.
    /// Calls are made from one thread. Arguments were validated above; a device throws only for what it alone can know.
    /// Out-of-range buffer and texture reads give 0 and such writes vanish, as Direct3D has it.
    /// </remarks>
    internal interface IGraphicsDevice : IDisposable
    {
        DeviceInfo Info { get; }

        /// <summary>Bytes are uninitialized. Size is rounded up to a multiple of 4.</summary>
        /// <exception cref="OutOfGpuMemoryException">The device has no room.</exception>
        DeviceBuffer CreateBuffer(string name, long bytes);
        DeviceTexture CreateTexture(in DeviceTextureDescription description);
        DeviceKernel CreateKernel(ShaderProgram program);
        DevicePass CreatePass(ShaderProgram vertex, ShaderProgram fragment);

        // ---- transfers, in stream order
        void Upload(DeviceBuffer target, long offset, ReadOnlySpan<byte> data);
        /// <summary>Sets 32-bit words; offset and bytes are multiples of 4.</summary>
        void Fill(DeviceBuffer target, long offset, long bytes, uint word);
        void Copy(DeviceBuffer source, long sourceOffset, DeviceBuffer target, long targetOffset, long bytes);
        /// <summary>Tightly packed texels of one mip level and array slice (or the whole depth of a 3D texture).</summary>
        void UploadTexture(DeviceTexture target, int mip, int slice, ReadOnlySpan<byte> texels);
        /// <summary>Every mip and slice. A depth texture takes depth from color.x.</summary>
        void ClearTexture(DeviceTexture target, in DeviceColor color);
        /// <summary>Same size and format, mip 0 and all slices.</summary>
        void CopyTexture(DeviceTexture source, DeviceTexture target);

        // ---- compute; bindings parallel to the kernel's Program.Resources
        void Dispatch(DeviceKernel kernel, ReadOnlySpan<DeviceBinding> bindings, int x, int y, int z);
        /// <summary>Three uints at offset: groups in x, y, z.</summary>
        void DispatchIndirect(DeviceKernel kernel, ReadOnlySpan<DeviceBinding> bindings, DeviceBuffer arguments, long offset);

        // ---- raster
        void BeginPass(in DeviceTargets targets);
        /// <summary>bindings: those of the vertex program's Resources, then those of the fragment program's.</summary>
        void Draw(DevicePass pass, in DeviceRasterState state, ReadOnlySpan<DeviceBinding> bindings, in DeviceDraw draw);
        void EndPass();

        // ---- time
        /// <summary>While false, samples cost nothing. Pairs nest; GPU time stamps at both ends.</summary>
        bool Timing { get; set; }
        void BeginSample(string name);
        void EndSample();
        /// <summary>Samples finished since the last call, in order of their begin. Waits for the device.</summary>
        List<DeviceSample> CollectSamples();
        /// <summary>The moment at which all work before this call is done.</summary>
        DeviceTimeMark MarkTime();

        // ---- submission and reading
        /// <summary>Submits what was recorded, without waiting.</summary>
        void Flush();
        /// <summary>Flushes and waits until all of it is done.</summary>
        void WaitIdle();
        /// <summary>Flushes, waits, copies. For synchronous GetData and tests.</summary>
        void Read(DeviceBuffer source, long offset, Span<byte> target);
        /// <summary>Tightly packed texels of a mip and slice (whole depth of a 3D texture). Flushes and waits.</summary>
        byte[] ReadTexture(DeviceTexture source, int mip, int slice);
        /// <summary>Copies in stream order into host-visible memory, to be fetched later without stalling.</summary>
        DeviceReadback BeginReadback(DeviceBuffer source, long offset, long bytes);
        DeviceReadback BeginReadback(DeviceTexture source, int mip, int slice);
    }

    internal sealed class DeviceInfo
    {
        public string Name = "", Vendor = "", Driver = "", Api = "";
        public bool IsSoftware;
        public bool SupportsCompute = true;
        /// <summary>Largest storage buffer one binding can cover, bytes.</summary>
        public long MaxBufferBytes;
        public int MaxGroupsharedBytes, MaxGroupInvocations, MaxGroupSizeX, MaxGroupSizeY, MaxGroupSizeZ, MaxTexture2D, MaxTexture3D;
        public long MemoryBytes;
        public int SubgroupSize;
    }

    /// <summary>A resource of the device. Dispose releases it once the stream no longer uses it; twice is harmless.</summary>
    internal abstract class DeviceResource : IDisposable
    {
        public string Name = "";
        public abstract void Dispose();
    }

    internal abstract class DeviceBuffer : DeviceResource { public long Bytes; }
    internal abstract class DeviceTexture : DeviceResource { public DeviceTextureDescription Description; }
    internal abstract class DeviceKernel : DeviceResource { public ShaderProgram Program; }
    internal abstract class DevicePass : DeviceResource { public ShaderProgram Vertex, Fragment; }

    internal abstract class DeviceReadback : DeviceResource
    {
        /// <summary>Whether the copy has happened; never waits.</summary>
        public abstract bool IsDone { get; }
        public abstract void Wait();
        /// <summary>The bytes, valid until Dispose; waits if need be.</summary>
        public abstract ReadOnlySpan<byte> Data { get; }
    }

    /// <summary>A moment of the stream. Dispose when it is no longer wanted, read or not.</summary>
    internal abstract class DeviceTimeMark : IDisposable
    {
        /// <summary>GPU clock, ms since a common start of all marks; false while the stream has not got there. Never waits.</summary>
        public abstract bool TryRead(out double milliseconds);
        public abstract void Dispose();
    }

    internal enum DeviceTextureDimension { Tex2D, Tex2DArray, Tex3D, Cube, CubeArray }

    internal enum DeviceFormat
    {
        None, R8_UNorm, RG8_UNorm, RGBA8_UNorm, RGBA8_SRGB, BGRA8_UNorm, BGRA8_SRGB, R16_UNorm, R16_Float, RG16_Float, RGBA16_Float,
        R32_Float, RG32_Float, RGBA32_Float, R32_UInt, RG32_UInt, RGBA32_UInt, R32_SInt, RG32_SInt, RGBA32_SInt, R11G11B10_Float,
        D16_UNorm, D32_Float, D24_S8, D32_S8,
        RGB32_Float,    // vertex streams only
    }

    internal struct DeviceTextureDescription
    {
        public string Name;
        public DeviceTextureDimension Dimension;
        public DeviceFormat Format;
        public int Width, Height, Depth, Slices, Mips, Samples;
        /// <summary>May be bound as RWTexture; may be a color or depth target.</summary>
        public bool RandomWrite, Target;
    }

    internal struct DeviceColor { public float R, G, B, A; }

    internal struct DeviceSampler : IEquatable<DeviceSampler>
    {
        public bool Linear, LinearMip, Comparison;
        public DeviceWrap U, V, W;
        public int Anisotropy;
        public bool Equals(DeviceSampler o) => Linear == o.Linear && LinearMip == o.LinearMip && Comparison == o.Comparison && U == o.U
            && V == o.V && W == o.W && Anisotropy == o.Anisotropy;
        public override bool Equals(object o) => o is DeviceSampler s && Equals(s);
        public override int GetHashCode() => HashCode.Combine(Linear, LinearMip, Comparison, U, V, W, Anisotropy);
    }

    internal enum DeviceWrap { Repeat, Clamp, Mirror, MirrorOnce }

    /// <summary>Binding of one <see cref="ShaderResource"/> of a program; the field that fits its kind is set.</summary>
    internal struct DeviceBinding
    {
        public DeviceBuffer Buffer;     // any buffer kind; null = reads 0, writes vanish
        public long Offset, Bytes;      // window of Buffer; Bytes 0 = to its end
        public DeviceTexture Texture;   // Texture and RWTexture; null = reads 0
        public int Mip;                 // RWTexture: level bound; Texture: all levels
        public DeviceSampler Sampler;   // Sampler
        public byte[] Constants;        // ConstantBuffer: the bytes, copied by the call
        public int ConstantsLength;
    }

    internal struct DeviceTargets
    {
        public DeviceTexture Color0, Color1, Color2, Color3, Depth;
        public int ColorCount;
        /// <summary>Mip and slice of the color target.</summary>
        public int Mip, Slice;
        /// <summary>Above 1: so many slices from <see cref="Slice"/> on, among which SV_RenderTargetArrayIndex chooses.</summary>
        public int Slices;
        public bool ClearColor, ClearDepth;
        public DeviceColor ClearValue;
        /// <summary>Stencil goes to 0 with it.</summary>
        public float ClearDepthValue;
        /// <summary>In pixels, origin at the target's first row, as Direct3D's viewport: clip y = +1 is row 0.</summary>
        public float ViewportX, ViewportY, ViewportWidth, ViewportHeight;
    }

    internal enum DeviceTopology { Triangles, TriangleStrip, Lines, LineStrip, Points }
    internal enum DeviceCull { Off, Front, Back }
    internal enum DeviceCompare { Never, Less, Equal, LessEqual, Greater, NotEqual, GreaterEqual, Always }
    internal enum DeviceBlend { Zero, One, SrcColor, OneMinusSrcColor, DstColor, OneMinusDstColor, SrcAlpha, OneMinusSrcAlpha, DstAlpha,
        OneMinusDstAlpha, SrcAlphaSaturate }
    internal enum DeviceBlendOp { Add, Sub, RevSub, Min, Max }

    internal enum DeviceStencilOp { Keep, Zero, Replace, IncrementSaturate, DecrementSaturate, Invert, IncrementWrap, DecrementWrap }

    /// <summary>Off while not Enabled; front and back faces alike.</summary>
    internal struct DeviceStencil : IEquatable<DeviceStencil>
    {
        public bool Enabled;
        public byte Reference, ReadMask, WriteMask;
        public DeviceCompare Compare;
        public DeviceStencilOp Pass, Fail, DepthFail;
        public bool Equals(DeviceStencil o) => Enabled == o.Enabled && Reference == o.Reference && ReadMask == o.ReadMask
            && WriteMask == o.WriteMask && Compare == o.Compare && Pass == o.Pass && Fail == o.Fail && DepthFail == o.DepthFail;
        public override bool Equals(object o) => o is DeviceStencil s && Equals(s);
        public override int GetHashCode() => HashCode.Combine(Enabled, Reference, ReadMask, WriteMask, Compare, Pass, Fail, DepthFail);
    }

    /// <summary>Front faces are clockwise, as in Direct3D.</summary>
    internal struct DeviceRasterState : IEquatable<DeviceRasterState>
    {
        public DeviceTopology Topology;
        public DeviceCull Cull;
        public bool FrontIsCounterClockwise;    // in the target's rows from 0 down
        public bool DepthWrite, Blend;
        public DeviceCompare DepthTest;
        public DeviceBlend SrcColor, DstColor, SrcAlpha, DstAlpha;
        public DeviceBlendOp ColorOp, AlphaOp;
        public int ColorMask;           // bits R 8, G 4, B 2, A 1
        public float DepthBiasFactor, DepthBiasUnits;
        public DeviceStencil Stencil;
        public bool Equals(DeviceRasterState o) => Stencil.Equals(o.Stencil) && Topology == o.Topology && Cull == o.Cull
            && FrontIsCounterClockwise == o.FrontIsCounterClockwise && DepthWrite == o.DepthWrite && Blend == o.Blend
            && DepthTest == o.DepthTest
            && SrcColor == o.SrcColor && DstColor == o.DstColor && SrcAlpha == o.SrcAlpha && DstAlpha == o.DstAlpha && ColorOp == o.ColorOp
            && AlphaOp == o.AlphaOp
            && ColorMask == o.ColorMask && DepthBiasFactor == o.DepthBiasFactor && DepthBiasUnits == o.DepthBiasUnits;
        public override bool Equals(object o) => o is DeviceRasterState s && Equals(s);
        public override int GetHashCode() => HashCode.Combine(HashCode.Combine(Topology, (Cull, FrontIsCounterClockwise), DepthWrite, Blend,
            DepthTest, SrcColor, DstColor, ColorMask), SrcAlpha, DstAlpha, ColorOp, AlphaOp, DepthBiasFactor, DepthBiasUnits, Stencil);
    }

    internal struct DeviceDraw
    {
        public int VertexCount, InstanceCount, FirstVertex, FirstInstance;  // IndexCount in VertexCount when indexed
        public DeviceBuffer Indices;        // null = not indexed
        public bool Indices32;
        public DeviceBuffer Arguments;      // not null = indirect: counts come from here
        // D3D layout: {vertices, instances, first vertex, first instance} or indexed {indices, instances, first index, base vertex, first instance}
        public long ArgumentsOffset;
        public DeviceVertexStream[] Streams; // null = none: vertices from SV_VertexID
    }

    /// <summary>A mesh attribute fed to the vertex program's input of that location.</summary>
    internal struct DeviceVertexStream { public int Location; public DeviceBuffer Buffer; public long Offset; public int Stride;
        public DeviceFormat Format; }

    internal struct DeviceSample { public string Name; public int Depth; public double BeginMs, Milliseconds; }

    internal sealed class OutOfGpuMemoryException : Exception { public OutOfGpuMemoryException(string message) : base(message) { } }
}
