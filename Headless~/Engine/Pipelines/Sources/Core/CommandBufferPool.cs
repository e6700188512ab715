using System.Collections.Generic;

namespace UnityEngine.Rendering
{
    public static class CommandBufferPool
    {
        static readonly Stack<CommandBuffer> spare = new Stack<CommandBuffer>();

        public static CommandBuffer Get() => Get("");

        public static CommandBuffer Get(string name)
        {
            CommandBuffer buffer = spare.Count > 0 ? spare.Pop() : new CommandBuffer();
            buffer.name = name;
            return buffer;
        }

        /// <summary>Cleared when it comes back (SRP Core 17.1.0, Runtime/Common/CommandBufferPool.cs).</summary>
        public static void Release(CommandBuffer buffer)
        {
            buffer.Clear();
            spare.Push(buffer);
        }

        internal static void Reset()
        {
            foreach (CommandBuffer buffer in spare)
                buffer.Dispose();
            spare.Clear();
        }
    }
}
