#if SRP_17
namespace UnityEngine.Rendering
{
    public class BaseCommandBuffer
    {
        protected internal CommandBuffer m_WrappedCommandBuffer;

        internal BaseCommandBuffer(CommandBuffer wrapped) => m_WrappedCommandBuffer = wrapped;
    }

    /// <summary>Of an unsafe pass: what it can do beyond handing out the buffer in it is not here.</summary>
    public class UnsafeCommandBuffer : BaseCommandBuffer
    {
        internal UnsafeCommandBuffer(CommandBuffer wrapped) : base(wrapped) { }
    }

    public struct CommandBufferHelpers
    {
        /// <summary>The wrapped one itself (SRP Core 17.1.0, Runtime/CommandBuffers/CommandBufferHelpers.cs): nothing that it is told is
        /// checked.</summary>
        public static CommandBuffer GetNativeCommandBuffer(UnsafeCommandBuffer baseBuffer) => baseBuffer.m_WrappedCommandBuffer;
    }
}
#endif
