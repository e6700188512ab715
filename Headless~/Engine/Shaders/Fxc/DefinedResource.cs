using System.Linq;
using UnityEngine.Headless;

namespace Host.Shaders
{
    /// <summary>Resources as the RDEF chunk defines them, in the terms of the engine.</summary>
    static class DefinedResource
    {
        /// <exception cref="ProgramException">A resource that this host does not bind.</exception>
        public static ShaderResource Describe(BoundResource bound, ResourceDefinitions definitions, SourceDeclarations declarations)
        {
            if (bound.Count != 1)
                throw new ProgramException($"'{bound.Name}' is an array of resources, which this host does not bind; declare them one by one.");
            var resource = new ShaderResource { Name = bound.Name, Stride = bound.Stride };
            switch (bound.Type)
            {
                case ShaderInputType.ConstantBuffer:
                    resource.Kind = ShaderResourceKind.ConstantBuffer;
                    resource.Constants = Constants(definitions.ConstantBuffers.Single(b => b.Name == bound.Name));
                    return resource;
                case ShaderInputType.Sampler:
                    // sampler2D of old: a texture and its sampler by one name.
                    return definitions.Resources.Any(r => r.Name == bound.Name && r.Type == ShaderInputType.Texture)
                        ? new ShaderResource { Name = bound.Name, Kind = ShaderResourceKind.Sampler, SamplerOf = bound.Name }
                        : InlineSampler.Describe(bound.Name, declarations);
                case ShaderInputType.Structured:
                    resource.Kind = ShaderResourceKind.StructuredBuffer;
                    return resource;
                case ShaderInputType.RWStructured:
                case ShaderInputType.RWStructuredWithCounter:
                    resource.Kind = ShaderResourceKind.RWStructuredBuffer;
                    return resource;
                case ShaderInputType.Append:
                case ShaderInputType.Consume:
                    resource.Kind = ShaderResourceKind.RWStructuredBuffer;
                    resource.IsAppendConsume = true;
                    return resource;
                case ShaderInputType.ByteAddress:
                case ShaderInputType.RWByteAddress:
                    resource.Kind = bound.Type == ShaderInputType.ByteAddress ? ShaderResourceKind.RawBuffer : ShaderResourceKind.RWRawBuffer;
                    resource.Stride = 4;
                    return resource;
                case ShaderInputType.Texture:
                case ShaderInputType.RWTyped:
                    return DescribeView(bound, resource);
                default:
                    throw new ProgramException($"'{bound.Name}' is a buffer of a kind that this host does not bind (a tbuffer?).");
            }
        }

        static ShaderResource DescribeView(BoundResource bound, ShaderResource resource)
        {
            bool writable = bound.Type == ShaderInputType.RWTyped;
            resource.Kind = writable ? ShaderResourceKind.RWTexture : ShaderResourceKind.Texture;
            if (writable || bound.Dimension == ShaderViewDimension.Buffer)
                resource.ElementFormat = FormatOf(bound);
            switch (bound.Dimension)
            {
                case ShaderViewDimension.Buffer:
                    resource.Kind = writable ? ShaderResourceKind.RWTypedBuffer : ShaderResourceKind.TypedBuffer;
                    return resource;
                case ShaderViewDimension.Texture2D:
                    resource.Dimension = DeviceTextureDimension.Tex2D;
                    return resource;
                case ShaderViewDimension.Texture2DArray:
                    resource.Dimension = DeviceTextureDimension.Tex2DArray;
                    return resource;
                case ShaderViewDimension.Texture3D:
                    resource.Dimension = DeviceTextureDimension.Tex3D;
                    return resource;
                case ShaderViewDimension.Cube:
                    resource.Dimension = DeviceTextureDimension.Cube;
                    return resource;
                case ShaderViewDimension.CubeArray:
                    resource.Dimension = DeviceTextureDimension.CubeArray;
                    return resource;
                default:
                    throw new ProgramException($"'{bound.Name}' is a 1D or multisampled texture, which this host does not bind.");
            }
        }

        static DeviceFormat FormatOf(BoundResource bound)
        {
            switch (bound.ReturnType, bound.Components)
            {
                case (ShaderReturnType.Float, 1): return DeviceFormat.R32_Float;
                case (ShaderReturnType.Float, 2): return DeviceFormat.RG32_Float;
                case (ShaderReturnType.Float, 4): return DeviceFormat.RGBA32_Float;
                case (ShaderReturnType.UInt, 1): return DeviceFormat.R32_UInt;
                case (ShaderReturnType.UInt, 2): return DeviceFormat.RG32_UInt;
                case (ShaderReturnType.UInt, 4): return DeviceFormat.RGBA32_UInt;
                case (ShaderReturnType.SInt, 1): return DeviceFormat.R32_SInt;
                case (ShaderReturnType.SInt, 2): return DeviceFormat.RG32_SInt;
                case (ShaderReturnType.SInt, 4): return DeviceFormat.RGBA32_SInt;
                default: return DeviceFormat.None;
            }
        }

        public static ConstantLayout Constants(DefinedBuffer buffer) => new ConstantLayout
        {
            Bytes = buffer.Bytes,
            IsGlobals = buffer.Name == "$Globals",
            // Unity sets numbers and arrays of numbers by name; a struct is reached only through a whole constant buffer.
            Fields = buffer.Variables.Where(v => v.Type.Class != ShaderVariableClass.Struct).Select(Field).ToArray(),
        };

        static ConstantField Field(DefinedVariable variable)
        {
            const int register = 16;
            DefinedType type = variable.Type;
            bool isMatrix = type.Class is ShaderVariableClass.MatrixRows or ShaderVariableClass.MatrixColumns;
            var field = new ConstantField
            {
                Name = variable.Name,
                Offset = variable.Offset,
                Bytes = variable.Bytes,
                Type = TypeOf(variable),
                Rows = type.Rows,
                Columns = type.Columns,
                ArrayLength = type.Elements,
                MatrixStride = isMatrix ? register : 0,
                RowMajor = type.Class == ShaderVariableClass.MatrixRows,
            };
            if (type.Elements > 0)
            {
                int vectors = !isMatrix ? 1 : field.RowMajor ? type.Rows : type.Columns;
                field.ArrayStride = vectors * register;
            }
            return field;
        }

        static ConstantType TypeOf(DefinedVariable variable)
        {
            switch (variable.Type.Type)
            {
                case ShaderVariableType.Bool: return ConstantType.Bool;
                case ShaderVariableType.Int:
                case ShaderVariableType.Min12Int:
                case ShaderVariableType.Min16Int: return ConstantType.Int;
                case ShaderVariableType.UInt:
                case ShaderVariableType.Min16UInt: return ConstantType.UInt;
                case ShaderVariableType.Double: throw new ProgramException(
                    $"'{variable.Name}' is a double in a constant buffer, which Unity cannot set.");
                default: return ConstantType.Float;
            }
        }
    }
}
