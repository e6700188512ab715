using System.Linq;

namespace UnityEngine.Headless
{
    /// <summary>Resources that a program needs of a device, counted as other graphics APIs count them.</summary>
    internal sealed class ProgramNeeds
    {
        public readonly ShaderStage Stage;
        public readonly int StorageBuffers, ConstantBuffers, TypedBuffers, Textures, StorageTextures, Samplers, Threads, GroupsharedBytes;

        public ProgramNeeds(ShaderProgram program)
        {
            int Count(params ShaderResourceKind[] kinds) => program.Resources.Count(r => kinds.Contains(r.Kind));
            Stage = program.Stage;
            // The hidden counter of an append buffer is a buffer of its own outside Direct3D.
            StorageBuffers = Count(ShaderResourceKind.StructuredBuffer, ShaderResourceKind.RWStructuredBuffer, ShaderResourceKind.RawBuffer,
                ShaderResourceKind.RWRawBuffer, ShaderResourceKind.Counter);
            ConstantBuffers = Count(ShaderResourceKind.ConstantBuffer);
            TypedBuffers = Count(ShaderResourceKind.TypedBuffer, ShaderResourceKind.RWTypedBuffer);
            Textures = Count(ShaderResourceKind.Texture);
            StorageTextures = Count(ShaderResourceKind.RWTexture);
            Samplers = Count(ShaderResourceKind.Sampler);
            Threads = Stage == ShaderStage.Compute ? program.GroupX * program.GroupY * program.GroupZ : 0;
            GroupsharedBytes = program.GroupsharedBytes;
        }
    }
}
