using System;

namespace Host.Vulkan
{
    /// <summary>A Vulkan command failed where success was due.</summary>
    internal sealed class VulkanException : Exception
    {
        public readonly VkResult Result;
        public VulkanException(VkResult result, string what) : base($"{what} failed: {result}.") => Result = result;

        public static void Check(VkResult result, string what)
        {
            if (result < VkResult.SUCCESS) throw new VulkanException(result, what);
        }
    }
}
