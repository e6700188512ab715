using System;
using System.Collections.Generic;

namespace UnityEngine.Headless
{
    internal enum ShaderStage { Compute, Vertex, Fragment }

    /// <summary>One compiled entry point and what it needs bound. Made by the shader importer, consumed by both sides of
    /// <see cref="IGraphicsDevice"/>.</summary>
    internal sealed class ShaderProgram
    {
        /// <summary>For messages: file and kernel or pass, e.g. "Shaders/Gpu/PrefixSum.compute (SumTiles)".</summary>
        public string Name;
        public ShaderStage Stage;
        public byte[] Spirv;
        public string EntryPoint;
        /// <summary>Used resources only. All in descriptor set 0; bindings of fragment programs start at 32, others at 0.</summary>
        public ShaderResource[] Resources = Array.Empty<ShaderResource>();
        /// <summary>Compute only.</summary>
        public int GroupX, GroupY, GroupZ, GroupsharedBytes;
        /// <summary>Unordered access views: RW buffers and textures, append/consume (their counters count with them).</summary>
        public int UavCount;
        /// <summary>Vertex only: inputs other than system values.</summary>
        public ShaderInput[] Inputs = Array.Empty<ShaderInput>();
    }

    internal struct ShaderInput { public string Semantic; public int Location; }

    internal enum ShaderResourceKind
    {
        ConstantBuffer, StructuredBuffer, RWStructuredBuffer, RawBuffer, RWRawBuffer,
        /// <summary>The hidden counter of an append/consume/counter buffer: four bytes; Name is the buffer's name.</summary>
        Counter,
        TypedBuffer, RWTypedBuffer, Texture, RWTexture, Sampler,
    }

    internal sealed class ShaderResource
    {
        public string Name;
        public ShaderResourceKind Kind;
        /// <summary>An unordered access view; a counter goes with its buffer's.</summary>
        internal bool IsUnorderedAccess()
            => Kind is ShaderResourceKind.RWStructuredBuffer or ShaderResourceKind.RWRawBuffer or ShaderResourceKind.RWTypedBuffer or ShaderResourceKind.RWTexture;
        public int Binding;
        /// <summary>Structured: bytes of an element as Direct3D packs it. Raw: 4. Otherwise 0.</summary>
        public int Stride;
        public bool IsAppendConsume;
        public DeviceTextureDimension Dimension;
        /// <summary>Typed buffers and RW textures: the format that the declared element type names (RWBuffer of uint: R32_UInt); None =
        /// unnamed.</summary>
        public DeviceFormat ElementFormat;
        /// <summary>Inline samplers (linearClampSampler, sampler_linear_clamp ...): decided by the name; otherwise null and the texture's
        /// own.</summary>
        public DeviceSampler? InlineSampler;
        /// <summary>For a sampler named sampler_X: "X", whose texture's own filter and wrap it takes.</summary>
        public string SamplerOf;
        /// <summary>Textures that the program reads through a sampler; null where that is not known (FXC's bytecode).</summary>
        public string[] SampledTextures;
        public ConstantLayout Constants;
    }

    internal sealed class ConstantLayout
    {
        public int Bytes;
        /// <summary>"$Globals" for loose globals: then fields are set by name on the shader; a named cbuffer can also be bound whole.</summary>
        public bool IsGlobals;
        public ConstantField[] Fields = Array.Empty<ConstantField>();
    }

    internal enum ConstantType { Float, Int, UInt, Bool }

    internal struct ConstantField
    {
        public string Name;
        public int Offset, Bytes;
        public ConstantType Type;
        /// <summary>Scalar 1x1, vector 1xN, matrix RxC as declared (float4x4: 4, 4).</summary>
        public int Rows, Columns;
        /// <summary>0 when not an array.</summary>
        public int ArrayLength, ArrayStride;
        /// <summary>Bytes between columns (column-major, HLSL's default) or rows (row_major).</summary>
        public int MatrixStride;
        public bool RowMajor;
    }

    /// <summary>A .compute file as imported: kernels compile on first use for the keywords then enabled.</summary>
    internal abstract class ComputeShaderSource
    {
        /// <summary>Path for messages, relative to the project.</summary>
        public abstract string Path { get; }
        public abstract IReadOnlyList<string> Kernels { get; }
        /// <summary>Every keyword of multi_compile / multi_compile_local / shader_feature lines.</summary>
        public abstract IReadOnlyList<string> Keywords { get; }
        /// <summary>Only the enabled keywords that this kernel declares matter; results are cached.</summary>
        /// <exception cref="ShaderCompileException"/>
        public abstract ShaderProgram Compile(int kernel, ICollection<string> enabledKeywords);
    }

    /// <summary>A .shader file as imported.</summary>
    internal abstract class ShaderSource
    {
        public abstract string Path { get; }
        /// <summary>The name behind the Shader keyword, e.g. "Water/Particles".</summary>
        public abstract string Name { get; }
        public abstract IReadOnlyList<ShaderProperty> Properties { get; }
        public abstract IReadOnlyList<string> Keywords { get; }
        /// <summary>The passes of the first SubShader that this host can use.</summary>
        public abstract IReadOnlyList<ShaderPassSource> Passes { get; }
        /// <summary>RenderQueue of the SubShader's Queue tag (Geometry = 2000).</summary>
        public abstract int RenderQueue { get; }
        /// <summary>The shader whose ShadowCaster pass stands in where this one has none; empty for none.</summary>
        public virtual string Fallback => "";
        /// <summary>Requests of the file that this host leaves out (UsePass, Stencil ...), a line each.</summary>
        public virtual IReadOnlyList<string> Notes => Array.Empty<string>();
    }

    internal abstract class ShaderPassSource
    {
        public string Name;
        /// <summary>Pass and SubShader tags together, e.g. LightMode.</summary>
        public Dictionary<string, string> Tags = new Dictionary<string, string>();
        /// <summary>Topology is filled in at the draw. Values that name a property ("[_SrcBlend]") come from <see cref="ResolveState"/>.
        /// Compares and depth bias are those of the reversed depth buffer: LEqual is GreaterEqual.</summary>
        public abstract DeviceRasterState ResolveState(Func<string, float> property);
        public abstract ShaderProgram Compile(ShaderStage stage, ICollection<string> enabledKeywords);
    }

    internal enum ShaderPropertyKind { Float, Range, Int, Color, Vector, Texture2D, Texture3D, TextureCube, Texture2DArray }

    internal sealed class ShaderProperty
    {
        public string Name, Description;
        public ShaderPropertyKind Kind;
        public float[] Default = Array.Empty<float>();  // 1 or 4 values
        public string DefaultTexture;                   // "white", "black", "gray", "bump", ""
    }

    internal sealed class ShaderCompileException : Exception
    {
        public readonly string File; public readonly int Line;
        /// <summary>Message reads "file(line): error: what".</summary>
        public ShaderCompileException(string file, int line, string what) : base($"{file}({line}): error: {what}") { File = file; Line = line; }
    }
}
