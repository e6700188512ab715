#if SRP_17
namespace UnityEngine.Rendering
{
    public class BaseCommandBuffer
    {
        protected internal CommandBuffer m_WrappedCommandBuffer;

        internal BaseCommandBuffer(CommandBuffer wrapped) => m_WrappedCommandBuffer = wrapped;
    }

    /// <summary>Command buffer of an unsafe pass: it can only hand out the buffer in it.</summary>
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
