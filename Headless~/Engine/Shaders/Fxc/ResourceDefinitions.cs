using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

namespace Host.Shaders
{
    /// <summary>D3D_SHADER_INPUT_TYPE.</summary>
    enum ShaderInputType
    {
        ConstantBuffer, TextureBuffer, Texture, Sampler, RWTyped, Structured, RWStructured, ByteAddress, RWByteAddress, Append, Consume,
            RWStructuredWithCounter,
    }

    /// <summary>D3D_SRV_DIMENSION, as far as a binding uses it.</summary>
    enum ShaderViewDimension { Unknown, Buffer, Texture1D, Texture1DArray, Texture2D, Texture2DArray, Texture2DMultisampled,
        Texture2DMultisampledArray, Texture3D, Cube, CubeArray }

    /// <summary>D3D_RESOURCE_RETURN_TYPE.</summary>
    enum ShaderReturnType { None, UNorm, SNorm, SInt, UInt, Float, Mixed, Double }

    /// <summary>D3D_SHADER_VARIABLE_CLASS.</summary>
    enum ShaderVariableClass { Scalar, Vector, MatrixRows, MatrixColumns, Object, Struct }

    /// <summary>D3D_SHADER_VARIABLE_TYPE, as far as a buffer may hold it.</summary>
    enum ShaderVariableType { Bool = 1, Int = 2, Float = 3, UInt = 19, Double = 39, Min8Float = 49, Min10Float = 50, Min16Float = 51,
        Min12Int = 52, Min16Int = 53, Min16UInt = 54 }

    /// <summary>A resource that the program uses, D3D11_SHADER_INPUT_BIND_DESC.</summary>
    sealed class BoundResource
    {
        public string Name;
        public ShaderInputType Type;
        public ShaderReturnType ReturnType;
        public ShaderViewDimension Dimension;
        /// <summary>Structured buffers: bytes of an element.</summary>
        public int Stride;
        /// <summary>The number of its t, u, s or b register.</summary>
        public int Register;
        /// <summary>1, or the length of an array of resources.</summary>
        public int Count;
        /// <summary>Typed buffers and textures: 1 to 4.</summary>
        public int Components;
    }

    sealed class DefinedType
    {
        public ShaderVariableClass Class;
        public ShaderVariableType Type;
        public int Rows, Columns;
        /// <summary>0 if it is not an array.</summary>
        public int Elements;
        public DefinedVariable[] Members = Array.Empty<DefinedVariable>();
    }

    /// <summary>A variable of a cbuffer, or a member of a struct in it.</summary>
    sealed class DefinedVariable
    {
        public string Name;
        public int Offset;
        /// <summary>Members of structs have none: 0.</summary>
        public int Bytes;
        /// <summary>Members of structs: always.</summary>
        public bool IsUsed;
        public DefinedType Type;
        /// <summary>Value that the source sets it to; null when it does not.</summary>
        public byte[] Default;
    }

    sealed class DefinedBuffer
    {
        public string Name;
        /// <summary>A multiple of 16 for cbuffers; an element of a structured buffer.</summary>
        public int Bytes;
        public DefinedVariable[] Variables;
    }

    /// <summary>
    /// The RDEF chunk of what FXC emits: the resources that a program uses, and the layout of its constant buffers and of
    /// the elements of its structured buffers. What D3DReflect shows, read from the bytes.
    /// </summary>
    sealed class ResourceDefinitions
    {
        const int HeaderBytes = 28, BindingBytes = 32, BufferBytes = 24, ShortVariableBytes = 24, LongVariableBytes = 40, MemberBytes = 12;
        const uint VariableIsUsed = 2, LongFormat = 0x31314452;     // "RD11"
        const uint ConstantBufferKind = 0, ElementKind = 3;

        readonly byte[] chunk;
        readonly Dictionary<int, DefinedType> types = new Dictionary<int, DefinedType>();

        public IReadOnlyList<BoundResource> Resources { get; }
        public IReadOnlyList<DefinedBuffer> ConstantBuffers { get; }
        /// <summary>By the structured buffer's name; the one variable is called $Element.</summary>
        public IReadOnlyList<DefinedBuffer> Elements { get; }

        /// <exception cref="FormatException">The chunk is missing or cut off.</exception>
        public ResourceDefinitions(DxbcContainer container) : this(container.Chunk("RDEF")) { }

        ResourceDefinitions(byte[] chunk)
        {
            this.chunk = chunk;
            int bufferCount = Int(0), bufferAt = Int(4), resourceCount = Int(8), resourceAt = Int(12);
            // Shader model 5 puts a header of its own behind the first, and more words into each variable.
            bool isLong = chunk.Length >= HeaderBytes + 4 && UInt(HeaderBytes) == LongFormat;
            Resources = Enumerable.Range(0, resourceCount).Select(i => ReadResource(resourceAt + i * BindingBytes)).ToList();
            var buffers = Enumerable.Range(0, bufferCount)
                .Select(i => (kind: UInt(bufferAt + i * BufferBytes + 20), buffer: ReadBuffer(bufferAt + i * BufferBytes, isLong)))
                .ToList();
            ConstantBuffers = buffers.Where(b => b.kind == ConstantBufferKind).Select(b => b.buffer).ToList();
            Elements = buffers.Where(b => b.kind == ElementKind).Select(b => b.buffer).ToList();
        }

        BoundResource ReadResource(int at)
        {
            const int componentBits = 2;
            var resource = new BoundResource
            {
                Name = Text(Int(at)),
                Type = (ShaderInputType)Int(at + 4),
                ReturnType = (ShaderReturnType)Int(at + 8),
                Dimension = (ShaderViewDimension)Int(at + 12),
                Register = Int(at + 20),
                Count = Int(at + 24),
                Components = (Int(at + 28) >> componentBits & 3) + 1,
            };
            if (resource.Type == ShaderInputType.Structured || resource.Type >= ShaderInputType.RWStructured
                && resource.Type != ShaderInputType.ByteAddress && resource.Type != ShaderInputType.RWByteAddress)
                resource.Stride = Int(at + 16);     // "number of samples"
            return resource;
        }

        DefinedBuffer ReadBuffer(int at, bool isLong)
        {
            int count = Int(at + 4), first = Int(at + 8), stride = isLong ? LongVariableBytes : ShortVariableBytes;
            return new DefinedBuffer
            {
                Name = Text(Int(at)),
                Bytes = Int(at + 12),
                Variables = Enumerable.Range(0, count).Select(i => ReadVariable(first + i * stride)).ToArray(),
            };
        }

        DefinedVariable ReadVariable(int at)
        {
            int bytes = Int(at + 8), value = Int(at + 20);
            return new DefinedVariable
            {
                Name = Text(Int(at)),
                Offset = Int(at + 4),
                Bytes = bytes,
                IsUsed = (UInt(at + 12) & VariableIsUsed) != 0,
                Type = ReadType(Int(at + 16)),
                Default = value == 0 ? null : Slice(value, bytes),
            };
        }

        DefinedType ReadType(int at)
        {
            if (types.TryGetValue(at, out DefinedType known))
                return known;
            int memberCount = Short(at + 10), memberAt = Int(at + 12);
            var type = new DefinedType
            {
                Class = (ShaderVariableClass)Short(at),
                Type = (ShaderVariableType)Short(at + 2),
                Rows = Short(at + 4),
                Columns = Short(at + 6),
                Elements = Short(at + 8),
                Members = Enumerable.Range(0, memberCount).Select(i => new DefinedVariable
                {
                    Name = Text(Int(memberAt + i * MemberBytes)),
                    Type = ReadType(Int(memberAt + i * MemberBytes + 4)),
                    Offset = Int(memberAt + i * MemberBytes + 8),
                    IsUsed = true,
                }).ToArray(),
            };
            types.Add(at, type);
            return type;
        }

        // ---- bytes

        byte[] Slice(int at, int count)
        {
            if (at < 0 || count < 0 || at + (long)count > chunk.Length)
                throw new FormatException($"The RDEF chunk has {chunk.Length} bytes; it points to bytes {at} to {at + (long)count}.");
            return chunk[at..(at + count)];
        }

        uint UInt(int at) => BitConverter.ToUInt32(Slice(at, 4));
        int Int(int at) => (int)UInt(at);
        int Short(int at) => BitConverter.ToUInt16(Slice(at, 2));

        string Text(int at)
        {
            Slice(at, 0);
            int end = Array.IndexOf(chunk, (byte)0, at);
            if (end < 0)
                throw new FormatException($"A name at byte {at} of the RDEF chunk has no end.");
            return Encoding.UTF8.GetString(chunk, at, end - at);
        }
    }
}
