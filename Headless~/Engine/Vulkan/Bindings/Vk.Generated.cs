// Written by generate.py beside this file from Khronos's registry vk.xml, version 1.3.239. Change the lists there, not this.
using System;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

#pragma warning disable CS0169, CS0649

namespace Host.Vulkan
{
    /// <summary>Address of a command by its zero-terminated name; throws when the driver has none.</summary>
    internal unsafe delegate void* VulkanLoader(ReadOnlySpan<byte> name);

    internal enum VkBool32 : uint { False, True }

    internal static class Vk
    {
        public const ulong VK_WHOLE_SIZE = ~0UL;
        public const uint VK_REMAINING_MIP_LEVELS = ~0U;
        public const uint VK_REMAINING_ARRAY_LAYERS = ~0U;
        public const uint VK_QUEUE_FAMILY_IGNORED = ~0U;
        public const float VK_LOD_CLAMP_NONE = 1000.0f;
    }

    /// <summary>Commands that need no instance.</summary>
    internal sealed unsafe class VkGlobalCommands
    {
        public readonly delegate* unmanaged<VkInstanceCreateInfo*, void*, VkInstance*, VkResult> CreateInstance;
        public readonly delegate* unmanaged<uint*, VkLayerProperties*, VkResult> EnumerateInstanceLayerProperties;
        public readonly delegate* unmanaged<byte*, uint*, VkExtensionProperties*, VkResult> EnumerateInstanceExtensionProperties;

        public VkGlobalCommands(VulkanLoader load)
        {
            CreateInstance = (delegate* unmanaged<VkInstanceCreateInfo*, void*, VkInstance*, VkResult>)load("vkCreateInstance"u8);
            EnumerateInstanceLayerProperties = (delegate* unmanaged<uint*, VkLayerProperties*, VkResult>)load("vkEnumerateInstanceLayerProperties"u8);
            EnumerateInstanceExtensionProperties = (delegate* unmanaged<byte*, uint*, VkExtensionProperties*, VkResult>)load("vkEnumerateInstanceExtensionProperties"u8);
        }
    }

    /// <summary>Commands of one instance and its physical devices.</summary>
    internal sealed unsafe class VkInstanceCommands
    {
        public readonly delegate* unmanaged<VkInstance, void*, void> DestroyInstance;
        public readonly delegate* unmanaged<VkInstance, uint*, VkPhysicalDevice*, VkResult> EnumeratePhysicalDevices;
        public readonly delegate* unmanaged<VkPhysicalDevice, VkPhysicalDeviceProperties2*, void> GetPhysicalDeviceProperties2;
        public readonly delegate* unmanaged<VkPhysicalDevice, VkPhysicalDeviceFeatures2*, void> GetPhysicalDeviceFeatures2;
        public readonly delegate* unmanaged<VkPhysicalDevice, VkPhysicalDeviceMemoryProperties*, void> GetPhysicalDeviceMemoryProperties;
        public readonly delegate* unmanaged<VkPhysicalDevice, uint*, VkQueueFamilyProperties*, void> GetPhysicalDeviceQueueFamilyProperties;
        public readonly delegate* unmanaged<VkPhysicalDevice, VkFormat, VkFormatProperties*, void> GetPhysicalDeviceFormatProperties;
        public readonly delegate* unmanaged<VkPhysicalDevice, byte*, uint*, VkExtensionProperties*, VkResult> EnumerateDeviceExtensionProperties;
        public readonly delegate* unmanaged<VkPhysicalDevice, VkDeviceCreateInfo*, void*, VkDevice*, VkResult> CreateDevice;
        public readonly delegate* unmanaged<VkDevice, byte*, nint> GetDeviceProcAddr;
        public readonly delegate* unmanaged<VkInstance, VkDebugUtilsMessengerCreateInfoEXT*, void*, VkDebugUtilsMessengerEXT*, VkResult> CreateDebugUtilsMessengerEXT;
        public readonly delegate* unmanaged<VkInstance, VkDebugUtilsMessengerEXT, void*, void> DestroyDebugUtilsMessengerEXT;

        public VkInstanceCommands(VulkanLoader load)
        {
            DestroyInstance = (delegate* unmanaged<VkInstance, void*, void>)load("vkDestroyInstance"u8);
            EnumeratePhysicalDevices = (delegate* unmanaged<VkInstance, uint*, VkPhysicalDevice*, VkResult>)load("vkEnumeratePhysicalDevices"u8);
            GetPhysicalDeviceProperties2 = (delegate* unmanaged<VkPhysicalDevice, VkPhysicalDeviceProperties2*, void>)load("vkGetPhysicalDeviceProperties2"u8);
            GetPhysicalDeviceFeatures2 = (delegate* unmanaged<VkPhysicalDevice, VkPhysicalDeviceFeatures2*, void>)load("vkGetPhysicalDeviceFeatures2"u8);
            GetPhysicalDeviceMemoryProperties = (delegate* unmanaged<VkPhysicalDevice, VkPhysicalDeviceMemoryProperties*, void>)load("vkGetPhysicalDeviceMemoryProperties"u8);
            GetPhysicalDeviceQueueFamilyProperties = (delegate* unmanaged<VkPhysicalDevice, uint*, VkQueueFamilyProperties*, void>)load("vkGetPhysicalDeviceQueueFamilyProperties"u8);
            GetPhysicalDeviceFormatProperties = (delegate* unmanaged<VkPhysicalDevice, VkFormat, VkFormatProperties*, void>)load("vkGetPhysicalDeviceFormatProperties"u8);
            EnumerateDeviceExtensionProperties = (delegate* unmanaged<VkPhysicalDevice, byte*, uint*, VkExtensionProperties*, VkResult>)load("vkEnumerateDeviceExtensionProperties"u8);
            CreateDevice = (delegate* unmanaged<VkPhysicalDevice, VkDeviceCreateInfo*, void*, VkDevice*, VkResult>)load("vkCreateDevice"u8);
            GetDeviceProcAddr = (delegate* unmanaged<VkDevice, byte*, nint>)load("vkGetDeviceProcAddr"u8);
            CreateDebugUtilsMessengerEXT = (delegate* unmanaged<VkInstance, VkDebugUtilsMessengerCreateInfoEXT*, void*, VkDebugUtilsMessengerEXT*, VkResult>)load("vkCreateDebugUtilsMessengerEXT"u8);
            DestroyDebugUtilsMessengerEXT = (delegate* unmanaged<VkInstance, VkDebugUtilsMessengerEXT, void*, void>)load("vkDestroyDebugUtilsMessengerEXT"u8);
        }
    }

    /// <summary>Commands of one device, without the loader's indirection.</summary>
    internal sealed unsafe class VkDeviceCommands
    {
        public readonly delegate* unmanaged<VkDevice, void*, void> DestroyDevice;
        public readonly delegate* unmanaged<VkDevice, uint, uint, VkQueue*, void> GetDeviceQueue;
        public readonly delegate* unmanaged<VkQueue, uint, VkSubmitInfo2*, VkFence, VkResult> QueueSubmit2;
        public readonly delegate* unmanaged<VkDevice, VkResult> DeviceWaitIdle;
        public readonly delegate* unmanaged<VkDevice, VkDebugUtilsObjectNameInfoEXT*, VkResult> SetDebugUtilsObjectNameEXT;
        public readonly delegate* unmanaged<VkDevice, VkMemoryAllocateInfo*, void*, VkDeviceMemory*, VkResult> AllocateMemory;
        public readonly delegate* unmanaged<VkDevice, VkDeviceMemory, void*, void> FreeMemory;
        public readonly delegate* unmanaged<VkDevice, VkDeviceMemory, ulong, ulong, uint, void**, VkResult> MapMemory;
        public readonly delegate* unmanaged<VkDevice, VkBufferCreateInfo*, void*, VkBuffer*, VkResult> CreateBuffer;
        public readonly delegate* unmanaged<VkDevice, VkBuffer, void*, void> DestroyBuffer;
        public readonly delegate* unmanaged<VkDevice, VkBuffer, VkMemoryRequirements*, void> GetBufferMemoryRequirements;
        public readonly delegate* unmanaged<VkDevice, VkBuffer, VkDeviceMemory, ulong, VkResult> BindBufferMemory;
        public readonly delegate* unmanaged<VkDevice, VkBufferViewCreateInfo*, void*, VkBufferView*, VkResult> CreateBufferView;
        public readonly delegate* unmanaged<VkDevice, VkBufferView, void*, void> DestroyBufferView;
        public readonly delegate* unmanaged<VkDevice, VkImageCreateInfo*, void*, VkImage*, VkResult> CreateImage;
        public readonly delegate* unmanaged<VkDevice, VkImage, void*, void> DestroyImage;
        public readonly delegate* unmanaged<VkDevice, VkImage, VkMemoryRequirements*, void> GetImageMemoryRequirements;
        public readonly delegate* unmanaged<VkDevice, VkImage, VkDeviceMemory, ulong, VkResult> BindImageMemory;
        public readonly delegate* unmanaged<VkDevice, VkImageViewCreateInfo*, void*, VkImageView*, VkResult> CreateImageView;
        public readonly delegate* unmanaged<VkDevice, VkImageView, void*, void> DestroyImageView;
        public readonly delegate* unmanaged<VkDevice, VkSamplerCreateInfo*, void*, VkSampler*, VkResult> CreateSampler;
        public readonly delegate* unmanaged<VkDevice, VkSampler, void*, void> DestroySampler;
        public readonly delegate* unmanaged<VkDevice, VkShaderModuleCreateInfo*, void*, VkShaderModule*, VkResult> CreateShaderModule;
        public readonly delegate* unmanaged<VkDevice, VkShaderModule, void*, void> DestroyShaderModule;
        public readonly delegate* unmanaged<VkDevice, VkPipelineCacheCreateInfo*, void*, VkPipelineCache*, VkResult> CreatePipelineCache;
        public readonly delegate* unmanaged<VkDevice, VkPipelineCache, void*, void> DestroyPipelineCache;
        public readonly delegate* unmanaged<VkDevice, VkPipelineCache, nuint*, void*, VkResult> GetPipelineCacheData;
        public readonly delegate* unmanaged<VkDevice, VkDescriptorSetLayoutCreateInfo*, void*, VkDescriptorSetLayout*, VkResult> CreateDescriptorSetLayout;
        public readonly delegate* unmanaged<VkDevice, VkDescriptorSetLayout, void*, void> DestroyDescriptorSetLayout;
        public readonly delegate* unmanaged<VkDevice, VkPipelineLayoutCreateInfo*, void*, VkPipelineLayout*, VkResult> CreatePipelineLayout;
        public readonly delegate* unmanaged<VkDevice, VkPipelineLayout, void*, void> DestroyPipelineLayout;
        public readonly delegate* unmanaged<VkDevice, VkPipelineCache, uint, VkComputePipelineCreateInfo*, void*, VkPipeline*, VkResult> CreateComputePipelines;
        public readonly delegate* unmanaged<VkDevice, VkPipelineCache, uint, VkGraphicsPipelineCreateInfo*, void*, VkPipeline*, VkResult> CreateGraphicsPipelines;
        public readonly delegate* unmanaged<VkDevice, VkPipeline, void*, void> DestroyPipeline;
        public readonly delegate* unmanaged<VkDevice, VkQueryPoolCreateInfo*, void*, VkQueryPool*, VkResult> CreateQueryPool;
        public readonly delegate* unmanaged<VkDevice, VkQueryPool, void*, void> DestroyQueryPool;
        public readonly delegate* unmanaged<VkDevice, VkQueryPool, uint, uint, void> ResetQueryPool;
        public readonly delegate* unmanaged<VkDevice, VkQueryPool, uint, uint, nuint, void*, ulong, VkQueryResultFlags, VkResult> GetQueryPoolResults;
        public readonly delegate* unmanaged<VkDevice, VkSemaphoreCreateInfo*, void*, VkSemaphore*, VkResult> CreateSemaphore;
        public readonly delegate* unmanaged<VkDevice, VkSemaphore, void*, void> DestroySemaphore;
        public readonly delegate* unmanaged<VkDevice, VkSemaphoreWaitInfo*, ulong, VkResult> WaitSemaphores;
        public readonly delegate* unmanaged<VkDevice, VkSemaphore, ulong*, VkResult> GetSemaphoreCounterValue;
        public readonly delegate* unmanaged<VkDevice, VkCommandPoolCreateInfo*, void*, VkCommandPool*, VkResult> CreateCommandPool;
        public readonly delegate* unmanaged<VkDevice, VkCommandPool, void*, void> DestroyCommandPool;
        public readonly delegate* unmanaged<VkDevice, VkCommandPool, VkCommandPoolResetFlags, VkResult> ResetCommandPool;
        public readonly delegate* unmanaged<VkDevice, VkCommandBufferAllocateInfo*, VkCommandBuffer*, VkResult> AllocateCommandBuffers;
        public readonly delegate* unmanaged<VkCommandBuffer, VkCommandBufferBeginInfo*, VkResult> BeginCommandBuffer;
        public readonly delegate* unmanaged<VkCommandBuffer, VkResult> EndCommandBuffer;
        public readonly delegate* unmanaged<VkCommandBuffer, VkPipelineBindPoint, VkPipeline, void> CmdBindPipeline;
        public readonly delegate* unmanaged<VkCommandBuffer, VkPipelineBindPoint, VkPipelineLayout, uint, uint, VkWriteDescriptorSet*, void> CmdPushDescriptorSetKHR;
        public readonly delegate* unmanaged<VkCommandBuffer, uint, uint, uint, void> CmdDispatch;
        public readonly delegate* unmanaged<VkCommandBuffer, VkBuffer, ulong, void> CmdDispatchIndirect;
        public readonly delegate* unmanaged<VkCommandBuffer, VkDependencyInfo*, void> CmdPipelineBarrier2;
        public readonly delegate* unmanaged<VkCommandBuffer, VkBuffer, VkBuffer, uint, VkBufferCopy*, void> CmdCopyBuffer;
        public readonly delegate* unmanaged<VkCommandBuffer, VkBuffer, ulong, ulong, uint, void> CmdFillBuffer;
        public readonly delegate* unmanaged<VkCommandBuffer, VkBuffer, VkImage, VkImageLayout, uint, VkBufferImageCopy*, void> CmdCopyBufferToImage;
        public readonly delegate* unmanaged<VkCommandBuffer, VkImage, VkImageLayout, VkBuffer, uint, VkBufferImageCopy*, void> CmdCopyImageToBuffer;
        public readonly delegate* unmanaged<VkCommandBuffer, VkImage, VkImageLayout, VkImage, VkImageLayout, uint, VkImageCopy*, void> CmdCopyImage;
        public readonly delegate* unmanaged<VkCommandBuffer, VkImage, VkImageLayout, VkClearColorValue*, uint, VkImageSubresourceRange*, void> CmdClearColorImage;
        public readonly delegate* unmanaged<VkCommandBuffer, VkImage, VkImageLayout, VkClearDepthStencilValue*, uint, VkImageSubresourceRange*, void> CmdClearDepthStencilImage;
        public readonly delegate* unmanaged<VkCommandBuffer, VkRenderingInfo*, void> CmdBeginRendering;
        public readonly delegate* unmanaged<VkCommandBuffer, void> CmdEndRendering;
        public readonly delegate* unmanaged<VkCommandBuffer, uint, uint, VkViewport*, void> CmdSetViewport;
        public readonly delegate* unmanaged<VkCommandBuffer, uint, uint, VkRect2D*, void> CmdSetScissor;
        public readonly delegate* unmanaged<VkCommandBuffer, uint, uint, VkBuffer*, ulong*, void> CmdBindVertexBuffers;
        public readonly delegate* unmanaged<VkCommandBuffer, VkBuffer, ulong, VkIndexType, void> CmdBindIndexBuffer;
        public readonly delegate* unmanaged<VkCommandBuffer, uint, uint, uint, uint, void> CmdDraw;
        public readonly delegate* unmanaged<VkCommandBuffer, uint, uint, uint, int, uint, void> CmdDrawIndexed;
        public readonly delegate* unmanaged<VkCommandBuffer, VkBuffer, ulong, uint, uint, void> CmdDrawIndirect;
        public readonly delegate* unmanaged<VkCommandBuffer, VkBuffer, ulong, uint, uint, void> CmdDrawIndexedIndirect;
        public readonly delegate* unmanaged<VkCommandBuffer, VkPipelineStageFlags2, VkQueryPool, uint, void> CmdWriteTimestamp2;

        public VkDeviceCommands(VulkanLoader load)
        {
            DestroyDevice = (delegate* unmanaged<VkDevice, void*, void>)load("vkDestroyDevice"u8);
            GetDeviceQueue = (delegate* unmanaged<VkDevice, uint, uint, VkQueue*, void>)load("vkGetDeviceQueue"u8);
            QueueSubmit2 = (delegate* unmanaged<VkQueue, uint, VkSubmitInfo2*, VkFence, VkResult>)load("vkQueueSubmit2"u8);
            DeviceWaitIdle = (delegate* unmanaged<VkDevice, VkResult>)load("vkDeviceWaitIdle"u8);
            SetDebugUtilsObjectNameEXT = (delegate* unmanaged<VkDevice, VkDebugUtilsObjectNameInfoEXT*, VkResult>)load("vkSetDebugUtilsObjectNameEXT"u8);
            AllocateMemory = (delegate* unmanaged<VkDevice, VkMemoryAllocateInfo*, void*, VkDeviceMemory*, VkResult>)load("vkAllocateMemory"u8);
            FreeMemory = (delegate* unmanaged<VkDevice, VkDeviceMemory, void*, void>)load("vkFreeMemory"u8);
            MapMemory = (delegate* unmanaged<VkDevice, VkDeviceMemory, ulong, ulong, uint, void**, VkResult>)load("vkMapMemory"u8);
            CreateBuffer = (delegate* unmanaged<VkDevice, VkBufferCreateInfo*, void*, VkBuffer*, VkResult>)load("vkCreateBuffer"u8);
            DestroyBuffer = (delegate* unmanaged<VkDevice, VkBuffer, void*, void>)load("vkDestroyBuffer"u8);
            GetBufferMemoryRequirements = (delegate* unmanaged<VkDevice, VkBuffer, VkMemoryRequirements*, void>)load("vkGetBufferMemoryRequirements"u8);
            BindBufferMemory = (delegate* unmanaged<VkDevice, VkBuffer, VkDeviceMemory, ulong, VkResult>)load("vkBindBufferMemory"u8);
            CreateBufferView = (delegate* unmanaged<VkDevice, VkBufferViewCreateInfo*, void*, VkBufferView*, VkResult>)load("vkCreateBufferView"u8);
            DestroyBufferView = (delegate* unmanaged<VkDevice, VkBufferView, void*, void>)load("vkDestroyBufferView"u8);
            CreateImage = (delegate* unmanaged<VkDevice, VkImageCreateInfo*, void*, VkImage*, VkResult>)load("vkCreateImage"u8);
            DestroyImage = (delegate* unmanaged<VkDevice, VkImage, void*, void>)load("vkDestroyImage"u8);
            GetImageMemoryRequirements = (delegate* unmanaged<VkDevice, VkImage, VkMemoryRequirements*, void>)load("vkGetImageMemoryRequirements"u8);
            BindImageMemory = (delegate* unmanaged<VkDevice, VkImage, VkDeviceMemory, ulong, VkResult>)load("vkBindImageMemory"u8);
            CreateImageView = (delegate* unmanaged<VkDevice, VkImageViewCreateInfo*, void*, VkImageView*, VkResult>)load("vkCreateImageView"u8);
            DestroyImageView = (delegate* unmanaged<VkDevice, VkImageView, void*, void>)load("vkDestroyImageView"u8);
            CreateSampler = (delegate* unmanaged<VkDevice, VkSamplerCreateInfo*, void*, VkSampler*, VkResult>)load("vkCreateSampler"u8);
            DestroySampler = (delegate* unmanaged<VkDevice, VkSampler, void*, void>)load("vkDestroySampler"u8);
            CreateShaderModule = (delegate* unmanaged<VkDevice, VkShaderModuleCreateInfo*, void*, VkShaderModule*, VkResult>)load("vkCreateShaderModule"u8);
            DestroyShaderModule = (delegate* unmanaged<VkDevice, VkShaderModule, void*, void>)load("vkDestroyShaderModule"u8);
            CreatePipelineCache = (delegate* unmanaged<VkDevice, VkPipelineCacheCreateInfo*, void*, VkPipelineCache*, VkResult>)load("vkCreatePipelineCache"u8);
            DestroyPipelineCache = (delegate* unmanaged<VkDevice, VkPipelineCache, void*, void>)load("vkDestroyPipelineCache"u8);
            GetPipelineCacheData = (delegate* unmanaged<VkDevice, VkPipelineCache, nuint*, void*, VkResult>)load("vkGetPipelineCacheData"u8);
            CreateDescriptorSetLayout = (delegate* unmanaged<VkDevice, VkDescriptorSetLayoutCreateInfo*, void*, VkDescriptorSetLayout*, VkResult>)load("vkCreateDescriptorSetLayout"u8);
            DestroyDescriptorSetLayout = (delegate* unmanaged<VkDevice, VkDescriptorSetLayout, void*, void>)load("vkDestroyDescriptorSetLayout"u8);
            CreatePipelineLayout = (delegate* unmanaged<VkDevice, VkPipelineLayoutCreateInfo*, void*, VkPipelineLayout*, VkResult>)load("vkCreatePipelineLayout"u8);
            DestroyPipelineLayout = (delegate* unmanaged<VkDevice, VkPipelineLayout, void*, void>)load("vkDestroyPipelineLayout"u8);
            CreateComputePipelines = (delegate* unmanaged<VkDevice, VkPipelineCache, uint, VkComputePipelineCreateInfo*, void*, VkPipeline*, VkResult>)load("vkCreateComputePipelines"u8);
            CreateGraphicsPipelines = (delegate* unmanaged<VkDevice, VkPipelineCache, uint, VkGraphicsPipelineCreateInfo*, void*, VkPipeline*, VkResult>)load("vkCreateGraphicsPipelines"u8);
            DestroyPipeline = (delegate* unmanaged<VkDevice, VkPipeline, void*, void>)load("vkDestroyPipeline"u8);
            CreateQueryPool = (delegate* unmanaged<VkDevice, VkQueryPoolCreateInfo*, void*, VkQueryPool*, VkResult>)load("vkCreateQueryPool"u8);
            DestroyQueryPool = (delegate* unmanaged<VkDevice, VkQueryPool, void*, void>)load("vkDestroyQueryPool"u8);
            ResetQueryPool = (delegate* unmanaged<VkDevice, VkQueryPool, uint, uint, void>)load("vkResetQueryPool"u8);
            GetQueryPoolResults = (delegate* unmanaged<VkDevice, VkQueryPool, uint, uint, nuint, void*, ulong, VkQueryResultFlags, VkResult>)load("vkGetQueryPoolResults"u8);
            CreateSemaphore = (delegate* unmanaged<VkDevice, VkSemaphoreCreateInfo*, void*, VkSemaphore*, VkResult>)load("vkCreateSemaphore"u8);
            DestroySemaphore = (delegate* unmanaged<VkDevice, VkSemaphore, void*, void>)load("vkDestroySemaphore"u8);
            WaitSemaphores = (delegate* unmanaged<VkDevice, VkSemaphoreWaitInfo*, ulong, VkResult>)load("vkWaitSemaphores"u8);
            GetSemaphoreCounterValue = (delegate* unmanaged<VkDevice, VkSemaphore, ulong*, VkResult>)load("vkGetSemaphoreCounterValue"u8);
            CreateCommandPool = (delegate* unmanaged<VkDevice, VkCommandPoolCreateInfo*, void*, VkCommandPool*, VkResult>)load("vkCreateCommandPool"u8);
            DestroyCommandPool = (delegate* unmanaged<VkDevice, VkCommandPool, void*, void>)load("vkDestroyCommandPool"u8);
            ResetCommandPool = (delegate* unmanaged<VkDevice, VkCommandPool, VkCommandPoolResetFlags, VkResult>)load("vkResetCommandPool"u8);
            AllocateCommandBuffers = (delegate* unmanaged<VkDevice, VkCommandBufferAllocateInfo*, VkCommandBuffer*, VkResult>)load("vkAllocateCommandBuffers"u8);
            BeginCommandBuffer = (delegate* unmanaged<VkCommandBuffer, VkCommandBufferBeginInfo*, VkResult>)load("vkBeginCommandBuffer"u8);
            EndCommandBuffer = (delegate* unmanaged<VkCommandBuffer, VkResult>)load("vkEndCommandBuffer"u8);
            CmdBindPipeline = (delegate* unmanaged<VkCommandBuffer, VkPipelineBindPoint, VkPipeline, void>)load("vkCmdBindPipeline"u8);
            CmdPushDescriptorSetKHR = (delegate* unmanaged<VkCommandBuffer, VkPipelineBindPoint, VkPipelineLayout, uint, uint, VkWriteDescriptorSet*, void>)load("vkCmdPushDescriptorSetKHR"u8);
            CmdDispatch = (delegate* unmanaged<VkCommandBuffer, uint, uint, uint, void>)load("vkCmdDispatch"u8);
            CmdDispatchIndirect = (delegate* unmanaged<VkCommandBuffer, VkBuffer, ulong, void>)load("vkCmdDispatchIndirect"u8);
            CmdPipelineBarrier2 = (delegate* unmanaged<VkCommandBuffer, VkDependencyInfo*, void>)load("vkCmdPipelineBarrier2"u8);
            CmdCopyBuffer = (delegate* unmanaged<VkCommandBuffer, VkBuffer, VkBuffer, uint, VkBufferCopy*, void>)load("vkCmdCopyBuffer"u8);
            CmdFillBuffer = (delegate* unmanaged<VkCommandBuffer, VkBuffer, ulong, ulong, uint, void>)load("vkCmdFillBuffer"u8);
            CmdCopyBufferToImage = (delegate* unmanaged<VkCommandBuffer, VkBuffer, VkImage, VkImageLayout, uint, VkBufferImageCopy*, void>)load("vkCmdCopyBufferToImage"u8);
            CmdCopyImageToBuffer = (delegate* unmanaged<VkCommandBuffer, VkImage, VkImageLayout, VkBuffer, uint, VkBufferImageCopy*, void>)load("vkCmdCopyImageToBuffer"u8);
            CmdCopyImage = (delegate* unmanaged<VkCommandBuffer, VkImage, VkImageLayout, VkImage, VkImageLayout, uint, VkImageCopy*, void>)load("vkCmdCopyImage"u8);
            CmdClearColorImage = (delegate* unmanaged<VkCommandBuffer, VkImage, VkImageLayout, VkClearColorValue*, uint, VkImageSubresourceRange*, void>)load("vkCmdClearColorImage"u8);
            CmdClearDepthStencilImage = (delegate* unmanaged<VkCommandBuffer, VkImage, VkImageLayout, VkClearDepthStencilValue*, uint, VkImageSubresourceRange*, void>)load("vkCmdClearDepthStencilImage"u8);
            CmdBeginRendering = (delegate* unmanaged<VkCommandBuffer, VkRenderingInfo*, void>)load("vkCmdBeginRendering"u8);
            CmdEndRendering = (delegate* unmanaged<VkCommandBuffer, void>)load("vkCmdEndRendering"u8);
            CmdSetViewport = (delegate* unmanaged<VkCommandBuffer, uint, uint, VkViewport*, void>)load("vkCmdSetViewport"u8);
            CmdSetScissor = (delegate* unmanaged<VkCommandBuffer, uint, uint, VkRect2D*, void>)load("vkCmdSetScissor"u8);
            CmdBindVertexBuffers = (delegate* unmanaged<VkCommandBuffer, uint, uint, VkBuffer*, ulong*, void>)load("vkCmdBindVertexBuffers"u8);
            CmdBindIndexBuffer = (delegate* unmanaged<VkCommandBuffer, VkBuffer, ulong, VkIndexType, void>)load("vkCmdBindIndexBuffer"u8);
            CmdDraw = (delegate* unmanaged<VkCommandBuffer, uint, uint, uint, uint, void>)load("vkCmdDraw"u8);
            CmdDrawIndexed = (delegate* unmanaged<VkCommandBuffer, uint, uint, uint, int, uint, void>)load("vkCmdDrawIndexed"u8);
            CmdDrawIndirect = (delegate* unmanaged<VkCommandBuffer, VkBuffer, ulong, uint, uint, void>)load("vkCmdDrawIndirect"u8);
            CmdDrawIndexedIndirect = (delegate* unmanaged<VkCommandBuffer, VkBuffer, ulong, uint, uint, void>)load("vkCmdDrawIndexedIndirect"u8);
            CmdWriteTimestamp2 = (delegate* unmanaged<VkCommandBuffer, VkPipelineStageFlags2, VkQueryPool, uint, void>)load("vkCmdWriteTimestamp2"u8);
        }
    }

    [Flags]
    internal enum VkAccessFlags2 : ulong
    {
        NONE = 0x0,
        INDIRECT_COMMAND_READ = 0x1,
        INDEX_READ = 0x2,
        VERTEX_ATTRIBUTE_READ = 0x4,
        UNIFORM_READ = 0x8,
        INPUT_ATTACHMENT_READ = 0x10,
        SHADER_READ = 0x20,
        SHADER_WRITE = 0x40,
        COLOR_ATTACHMENT_READ = 0x80,
        COLOR_ATTACHMENT_WRITE = 0x100,
        DEPTH_STENCIL_ATTACHMENT_READ = 0x200,
        DEPTH_STENCIL_ATTACHMENT_WRITE = 0x400,
        TRANSFER_READ = 0x800,
        TRANSFER_WRITE = 0x1000,
        HOST_READ = 0x2000,
        HOST_WRITE = 0x4000,
        MEMORY_READ = 0x8000,
        MEMORY_WRITE = 0x10000,
        SHADER_SAMPLED_READ = 0x100000000,
        SHADER_STORAGE_READ = 0x200000000,
        SHADER_STORAGE_WRITE = 0x400000000,
    }

    internal unsafe struct VkApplicationInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public byte* pApplicationName;
        public uint applicationVersion;
        public byte* pEngineName;
        public uint engineVersion;
        public uint apiVersion;
        public VkApplicationInfo() { sType = VkStructureType.APPLICATION_INFO; }
    }

    internal enum VkAttachmentLoadOp : int
    {
        LOAD = 0,
        CLEAR = 1,
        DONT_CARE = 2,
    }

    internal enum VkAttachmentStoreOp : int
    {
        STORE = 0,
        DONT_CARE = 1,
        NONE = 1000301000,
    }

    internal enum VkBlendFactor : int
    {
        ZERO = 0,
        ONE = 1,
        SRC_COLOR = 2,
        ONE_MINUS_SRC_COLOR = 3,
        DST_COLOR = 4,
        ONE_MINUS_DST_COLOR = 5,
        SRC_ALPHA = 6,
        ONE_MINUS_SRC_ALPHA = 7,
        DST_ALPHA = 8,
        ONE_MINUS_DST_ALPHA = 9,
        CONSTANT_COLOR = 10,
        ONE_MINUS_CONSTANT_COLOR = 11,
        CONSTANT_ALPHA = 12,
        ONE_MINUS_CONSTANT_ALPHA = 13,
        SRC_ALPHA_SATURATE = 14,
        SRC1_COLOR = 15,
        ONE_MINUS_SRC1_COLOR = 16,
        SRC1_ALPHA = 17,
        ONE_MINUS_SRC1_ALPHA = 18,
    }

    internal enum VkBlendOp : int
    {
        ADD = 0,
        SUBTRACT = 1,
        REVERSE_SUBTRACT = 2,
        MIN = 3,
        MAX = 4,
    }

    internal enum VkBorderColor : int
    {
        FLOAT_TRANSPARENT_BLACK = 0,
        INT_TRANSPARENT_BLACK = 1,
        FLOAT_OPAQUE_BLACK = 2,
        INT_OPAQUE_BLACK = 3,
        FLOAT_OPAQUE_WHITE = 4,
        INT_OPAQUE_WHITE = 5,
    }

    internal enum VkBuffer : ulong { Null }

    internal unsafe struct VkBufferCopy
    {
        public ulong srcOffset;
        public ulong dstOffset;
        public ulong size;
    }

    [Flags]
    internal enum VkBufferCreateFlags : uint
    {
        SPARSE_BINDING = 0x1,
        SPARSE_RESIDENCY = 0x2,
        SPARSE_ALIASED = 0x4,
        PROTECTED = 0x8,
        DEVICE_ADDRESS_CAPTURE_REPLAY = 0x10,
    }

    internal unsafe struct VkBufferCreateInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public VkBufferCreateFlags flags;
        public ulong size;
        public VkBufferUsageFlags usage;
        public VkSharingMode sharingMode;
        public uint queueFamilyIndexCount;
        public uint* pQueueFamilyIndices;
        public VkBufferCreateInfo() { sType = VkStructureType.BUFFER_CREATE_INFO; }
    }

    internal unsafe struct VkBufferImageCopy
    {
        public ulong bufferOffset;
        public uint bufferRowLength;
        public uint bufferImageHeight;
        public VkImageSubresourceLayers imageSubresource;
        public VkOffset3D imageOffset;
        public VkExtent3D imageExtent;
    }

    internal unsafe struct VkBufferMemoryBarrier2
    {
        public VkStructureType sType;
        public void* pNext;
        public VkPipelineStageFlags2 srcStageMask;
        public VkAccessFlags2 srcAccessMask;
        public VkPipelineStageFlags2 dstStageMask;
        public VkAccessFlags2 dstAccessMask;
        public uint srcQueueFamilyIndex;
        public uint dstQueueFamilyIndex;
        public VkBuffer buffer;
        public ulong offset;
        public ulong size;
        public VkBufferMemoryBarrier2() { sType = VkStructureType.BUFFER_MEMORY_BARRIER_2; }
    }

    [Flags]
    internal enum VkBufferUsageFlags : uint
    {
        TRANSFER_SRC = 0x1,
        TRANSFER_DST = 0x2,
        UNIFORM_TEXEL_BUFFER = 0x4,
        STORAGE_TEXEL_BUFFER = 0x8,
        UNIFORM_BUFFER = 0x10,
        STORAGE_BUFFER = 0x20,
        INDEX_BUFFER = 0x40,
        VERTEX_BUFFER = 0x80,
        INDIRECT_BUFFER = 0x100,
        SHADER_DEVICE_ADDRESS = 0x20000,
    }

    internal enum VkBufferView : ulong { Null }

    internal unsafe struct VkBufferViewCreateInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public uint flags;
        public VkBuffer buffer;
        public VkFormat format;
        public ulong offset;
        public ulong range;
        public VkBufferViewCreateInfo() { sType = VkStructureType.BUFFER_VIEW_CREATE_INFO; }
    }

    [StructLayout(LayoutKind.Explicit)]
    internal unsafe struct VkClearColorValue
    {
        [FieldOffset(0)] public fixed float float32[4];
        [FieldOffset(0)] public fixed int int32[4];
        [FieldOffset(0)] public fixed uint uint32[4];
    }

    internal unsafe struct VkClearDepthStencilValue
    {
        public float depth;
        public uint stencil;
    }

    [StructLayout(LayoutKind.Explicit)]
    internal unsafe struct VkClearValue
    {
        [FieldOffset(0)] public VkClearColorValue color;
        [FieldOffset(0)] public VkClearDepthStencilValue depthStencil;
    }

    [Flags]
    internal enum VkColorComponentFlags : uint
    {
        R = 0x1,
        G = 0x2,
        B = 0x4,
        A = 0x8,
    }

    internal enum VkCommandBuffer : ulong { Null }

    internal unsafe struct VkCommandBufferAllocateInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public VkCommandPool commandPool;
        public VkCommandBufferLevel level;
        public uint commandBufferCount;
        public VkCommandBufferAllocateInfo() { sType = VkStructureType.COMMAND_BUFFER_ALLOCATE_INFO; }
    }

    internal unsafe struct VkCommandBufferBeginInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public VkCommandBufferUsageFlags flags;
        public VkCommandBufferInheritanceInfo* pInheritanceInfo;
        public VkCommandBufferBeginInfo() { sType = VkStructureType.COMMAND_BUFFER_BEGIN_INFO; }
    }

    internal unsafe struct VkCommandBufferInheritanceInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public VkRenderPass renderPass;
        public uint subpass;
        public VkFramebuffer framebuffer;
        public VkBool32 occlusionQueryEnable;
        public VkQueryControlFlags queryFlags;
        public VkQueryPipelineStatisticFlags pipelineStatistics;
        public VkCommandBufferInheritanceInfo() { sType = VkStructureType.COMMAND_BUFFER_INHERITANCE_INFO; }
    }

    internal enum VkCommandBufferLevel : int
    {
        PRIMARY = 0,
        SECONDARY = 1,
    }

    internal unsafe struct VkCommandBufferSubmitInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public VkCommandBuffer commandBuffer;
        public uint deviceMask;
        public VkCommandBufferSubmitInfo() { sType = VkStructureType.COMMAND_BUFFER_SUBMIT_INFO; }
    }

    [Flags]
    internal enum VkCommandBufferUsageFlags : uint
    {
        ONE_TIME_SUBMIT = 0x1,
        RENDER_PASS_CONTINUE = 0x2,
        SIMULTANEOUS_USE = 0x4,
    }

    internal enum VkCommandPool : ulong { Null }

    [Flags]
    internal enum VkCommandPoolCreateFlags : uint
    {
        TRANSIENT = 0x1,
        RESET_COMMAND_BUFFER = 0x2,
        PROTECTED = 0x4,
    }

    internal unsafe struct VkCommandPoolCreateInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public VkCommandPoolCreateFlags flags;
        public uint queueFamilyIndex;
        public VkCommandPoolCreateInfo() { sType = VkStructureType.COMMAND_POOL_CREATE_INFO; }
    }

    [Flags]
    internal enum VkCommandPoolResetFlags : uint
    {
        RELEASE_RESOURCES = 0x1,
    }

    internal enum VkCompareOp : int
    {
        NEVER = 0,
        LESS = 1,
        EQUAL = 2,
        LESS_OR_EQUAL = 3,
        GREATER = 4,
        NOT_EQUAL = 5,
        GREATER_OR_EQUAL = 6,
        ALWAYS = 7,
    }

    internal unsafe struct VkComponentMapping
    {
        public VkComponentSwizzle r;
        public VkComponentSwizzle g;
        public VkComponentSwizzle b;
        public VkComponentSwizzle a;
    }

    internal enum VkComponentSwizzle : int
    {
        IDENTITY = 0,
        ZERO = 1,
        ONE = 2,
        R = 3,
        G = 4,
        B = 5,
        A = 6,
    }

    internal unsafe struct VkComputePipelineCreateInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public VkPipelineCreateFlags flags;
        public VkPipelineShaderStageCreateInfo stage;
        public VkPipelineLayout layout;
        public VkPipeline basePipelineHandle;
        public int basePipelineIndex;
        public VkComputePipelineCreateInfo() { sType = VkStructureType.COMPUTE_PIPELINE_CREATE_INFO; }
    }

    internal unsafe struct VkConformanceVersion
    {
        public byte major;
        public byte minor;
        public byte subminor;
        public byte patch;
    }

    [Flags]
    internal enum VkCullModeFlags : uint
    {
        NONE = 0x0,
        FRONT = 0x1,
        BACK = 0x2,
        FRONT_AND_BACK = 0x3,
    }

    internal unsafe struct VkDebugUtilsLabelEXT
    {
        public VkStructureType sType;
        public void* pNext;
        public byte* pLabelName;
        public fixed float color[4];
        public VkDebugUtilsLabelEXT() { sType = VkStructureType.DEBUG_UTILS_LABEL_EXT; }
    }

    [Flags]
    internal enum VkDebugUtilsMessageSeverityFlagsEXT : uint
    {
        VERBOSE = 0x1,
        INFO = 0x10,
        WARNING = 0x100,
        ERROR = 0x1000,
    }

    [Flags]
    internal enum VkDebugUtilsMessageTypeFlagsEXT : uint
    {
        GENERAL = 0x1,
        VALIDATION = 0x2,
        PERFORMANCE = 0x4,
    }

    internal unsafe struct VkDebugUtilsMessengerCallbackDataEXT
    {
        public VkStructureType sType;
        public void* pNext;
        public uint flags;
        public byte* pMessageIdName;
        public int messageIdNumber;
        public byte* pMessage;
        public uint queueLabelCount;
        public VkDebugUtilsLabelEXT* pQueueLabels;
        public uint cmdBufLabelCount;
        public VkDebugUtilsLabelEXT* pCmdBufLabels;
        public uint objectCount;
        public VkDebugUtilsObjectNameInfoEXT* pObjects;
        public VkDebugUtilsMessengerCallbackDataEXT() { sType = VkStructureType.DEBUG_UTILS_MESSENGER_CALLBACK_DATA_EXT; }
    }

    internal unsafe struct VkDebugUtilsMessengerCreateInfoEXT
    {
        public VkStructureType sType;
        public void* pNext;
        public uint flags;
        public VkDebugUtilsMessageSeverityFlagsEXT messageSeverity;
        public VkDebugUtilsMessageTypeFlagsEXT messageType;
        public nint pfnUserCallback;
        public void* pUserData;
        public VkDebugUtilsMessengerCreateInfoEXT() { sType = VkStructureType.DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT; }
    }

    internal enum VkDebugUtilsMessengerEXT : ulong { Null }

    internal unsafe struct VkDebugUtilsObjectNameInfoEXT
    {
        public VkStructureType sType;
        public void* pNext;
        public VkObjectType objectType;
        public ulong objectHandle;
        public byte* pObjectName;
        public VkDebugUtilsObjectNameInfoEXT() { sType = VkStructureType.DEBUG_UTILS_OBJECT_NAME_INFO_EXT; }
    }

    [Flags]
    internal enum VkDependencyFlags : uint
    {
        BY_REGION = 0x1,
        DEVICE_GROUP = 0x4,
        VIEW_LOCAL = 0x2,
    }

    internal unsafe struct VkDependencyInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public VkDependencyFlags dependencyFlags;
        public uint memoryBarrierCount;
        public VkMemoryBarrier2* pMemoryBarriers;
        public uint bufferMemoryBarrierCount;
        public VkBufferMemoryBarrier2* pBufferMemoryBarriers;
        public uint imageMemoryBarrierCount;
        public VkImageMemoryBarrier2* pImageMemoryBarriers;
        public VkDependencyInfo() { sType = VkStructureType.DEPENDENCY_INFO; }
    }

    internal unsafe struct VkDescriptorBufferInfo
    {
        public VkBuffer buffer;
        public ulong offset;
        public ulong range;
    }

    internal unsafe struct VkDescriptorImageInfo
    {
        public VkSampler sampler;
        public VkImageView imageView;
        public VkImageLayout imageLayout;
    }

    internal enum VkDescriptorSet : ulong { Null }

    internal enum VkDescriptorSetLayout : ulong { Null }

    internal unsafe struct VkDescriptorSetLayoutBinding
    {
        public uint binding;
        public VkDescriptorType descriptorType;
        public uint descriptorCount;
        public VkShaderStageFlags stageFlags;
        public VkSampler* pImmutableSamplers;
    }

    [Flags]
    internal enum VkDescriptorSetLayoutCreateFlags : uint
    {
        UPDATE_AFTER_BIND_POOL = 0x2,
        PUSH_DESCRIPTOR_KHR = 0x1,
    }

    internal unsafe struct VkDescriptorSetLayoutCreateInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public VkDescriptorSetLayoutCreateFlags flags;
        public uint bindingCount;
        public VkDescriptorSetLayoutBinding* pBindings;
        public VkDescriptorSetLayoutCreateInfo() { sType = VkStructureType.DESCRIPTOR_SET_LAYOUT_CREATE_INFO; }
    }

    internal enum VkDescriptorType : int
    {
        SAMPLER = 0,
        COMBINED_IMAGE_SAMPLER = 1,
        SAMPLED_IMAGE = 2,
        STORAGE_IMAGE = 3,
        UNIFORM_TEXEL_BUFFER = 4,
        STORAGE_TEXEL_BUFFER = 5,
        UNIFORM_BUFFER = 6,
        STORAGE_BUFFER = 7,
        UNIFORM_BUFFER_DYNAMIC = 8,
        STORAGE_BUFFER_DYNAMIC = 9,
        INPUT_ATTACHMENT = 10,
        INLINE_UNIFORM_BLOCK = 1000138000,
    }

    internal enum VkDevice : ulong { Null }

    internal unsafe struct VkDeviceCreateInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public uint flags;
        public uint queueCreateInfoCount;
        public VkDeviceQueueCreateInfo* pQueueCreateInfos;
        public uint enabledLayerCount;
        public byte** ppEnabledLayerNames;
        public uint enabledExtensionCount;
        public byte** ppEnabledExtensionNames;
        public VkPhysicalDeviceFeatures* pEnabledFeatures;
        public VkDeviceCreateInfo() { sType = VkStructureType.DEVICE_CREATE_INFO; }
    }

    internal enum VkDeviceMemory : ulong { Null }

    [Flags]
    internal enum VkDeviceQueueCreateFlags : uint
    {
        PROTECTED = 0x1,
    }

    internal unsafe struct VkDeviceQueueCreateInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public VkDeviceQueueCreateFlags flags;
        public uint queueFamilyIndex;
        public uint queueCount;
        public float* pQueuePriorities;
        public VkDeviceQueueCreateInfo() { sType = VkStructureType.DEVICE_QUEUE_CREATE_INFO; }
    }

    internal enum VkDriverId : int
    {
        AMD_PROPRIETARY = 1,
        AMD_OPEN_SOURCE = 2,
        MESA_RADV = 3,
        NVIDIA_PROPRIETARY = 4,
        INTEL_PROPRIETARY_WINDOWS = 5,
        INTEL_OPEN_SOURCE_MESA = 6,
        IMAGINATION_PROPRIETARY = 7,
        QUALCOMM_PROPRIETARY = 8,
        ARM_PROPRIETARY = 9,
        GOOGLE_SWIFTSHADER = 10,
        GGP_PROPRIETARY = 11,
        BROADCOM_PROPRIETARY = 12,
        MESA_LLVMPIPE = 13,
        MOLTENVK = 14,
        COREAVI_PROPRIETARY = 15,
        JUICE_PROPRIETARY = 16,
        VERISILICON_PROPRIETARY = 17,
        MESA_TURNIP = 18,
        MESA_V3DV = 19,
        MESA_PANVK = 20,
        SAMSUNG_PROPRIETARY = 21,
        MESA_VENUS = 22,
        MESA_DOZEN = 23,
        MESA_NVK = 24,
        IMAGINATION_OPEN_SOURCE_MESA = 25,
    }

    internal enum VkDynamicState : int
    {
        VIEWPORT = 0,
        SCISSOR = 1,
        LINE_WIDTH = 2,
        DEPTH_BIAS = 3,
        BLEND_CONSTANTS = 4,
        DEPTH_BOUNDS = 5,
        STENCIL_COMPARE_MASK = 6,
        STENCIL_WRITE_MASK = 7,
        STENCIL_REFERENCE = 8,
        CULL_MODE = 1000267000,
        FRONT_FACE = 1000267001,
        PRIMITIVE_TOPOLOGY = 1000267002,
        VIEWPORT_WITH_COUNT = 1000267003,
        SCISSOR_WITH_COUNT = 1000267004,
        VERTEX_INPUT_BINDING_STRIDE = 1000267005,
        DEPTH_TEST_ENABLE = 1000267006,
        DEPTH_WRITE_ENABLE = 1000267007,
        DEPTH_COMPARE_OP = 1000267008,
        DEPTH_BOUNDS_TEST_ENABLE = 1000267009,
        STENCIL_TEST_ENABLE = 1000267010,
        STENCIL_OP = 1000267011,
        RASTERIZER_DISCARD_ENABLE = 1000377001,
        DEPTH_BIAS_ENABLE = 1000377002,
        PRIMITIVE_RESTART_ENABLE = 1000377004,
    }

    internal unsafe struct VkExtensionProperties
    {
        public fixed byte extensionName[256];
        public uint specVersion;
    }

    internal unsafe struct VkExtent2D
    {
        public uint width;
        public uint height;
    }

    internal unsafe struct VkExtent3D
    {
        public uint width;
        public uint height;
        public uint depth;
    }

    internal enum VkFence : ulong { Null }

    internal enum VkFilter : int
    {
        NEAREST = 0,
        LINEAR = 1,
    }

    internal enum VkFormat : int
    {
        UNDEFINED = 0,
        R4G4_UNORM_PACK8 = 1,
        R4G4B4A4_UNORM_PACK16 = 2,
        B4G4R4A4_UNORM_PACK16 = 3,
        R5G6B5_UNORM_PACK16 = 4,
        B5G6R5_UNORM_PACK16 = 5,
        R5G5B5A1_UNORM_PACK16 = 6,
        B5G5R5A1_UNORM_PACK16 = 7,
        A1R5G5B5_UNORM_PACK16 = 8,
        R8_UNORM = 9,
        R8_SNORM = 10,
        R8_USCALED = 11,
        R8_SSCALED = 12,
        R8_UINT = 13,
        R8_SINT = 14,
        R8_SRGB = 15,
        R8G8_UNORM = 16,
        R8G8_SNORM = 17,
        R8G8_USCALED = 18,
        R8G8_SSCALED = 19,
        R8G8_UINT = 20,
        R8G8_SINT = 21,
        R8G8_SRGB = 22,
        R8G8B8_UNORM = 23,
        R8G8B8_SNORM = 24,
        R8G8B8_USCALED = 25,
        R8G8B8_SSCALED = 26,
        R8G8B8_UINT = 27,
        R8G8B8_SINT = 28,
        R8G8B8_SRGB = 29,
        B8G8R8_UNORM = 30,
        B8G8R8_SNORM = 31,
        B8G8R8_USCALED = 32,
        B8G8R8_SSCALED = 33,
        B8G8R8_UINT = 34,
        B8G8R8_SINT = 35,
        B8G8R8_SRGB = 36,
        R8G8B8A8_UNORM = 37,
        R8G8B8A8_SNORM = 38,
        R8G8B8A8_USCALED = 39,
        R8G8B8A8_SSCALED = 40,
        R8G8B8A8_UINT = 41,
        R8G8B8A8_SINT = 42,
        R8G8B8A8_SRGB = 43,
        B8G8R8A8_UNORM = 44,
        B8G8R8A8_SNORM = 45,
        B8G8R8A8_USCALED = 46,
        B8G8R8A8_SSCALED = 47,
        B8G8R8A8_UINT = 48,
        B8G8R8A8_SINT = 49,
        B8G8R8A8_SRGB = 50,
        A8B8G8R8_UNORM_PACK32 = 51,
        A8B8G8R8_SNORM_PACK32 = 52,
        A8B8G8R8_USCALED_PACK32 = 53,
        A8B8G8R8_SSCALED_PACK32 = 54,
        A8B8G8R8_UINT_PACK32 = 55,
        A8B8G8R8_SINT_PACK32 = 56,
        A8B8G8R8_SRGB_PACK32 = 57,
        A2R10G10B10_UNORM_PACK32 = 58,
        A2R10G10B10_SNORM_PACK32 = 59,
        A2R10G10B10_USCALED_PACK32 = 60,
        A2R10G10B10_SSCALED_PACK32 = 61,
        A2R10G10B10_UINT_PACK32 = 62,
        A2R10G10B10_SINT_PACK32 = 63,
        A2B10G10R10_UNORM_PACK32 = 64,
        A2B10G10R10_SNORM_PACK32 = 65,
        A2B10G10R10_USCALED_PACK32 = 66,
        A2B10G10R10_SSCALED_PACK32 = 67,
        A2B10G10R10_UINT_PACK32 = 68,
        A2B10G10R10_SINT_PACK32 = 69,
        R16_UNORM = 70,
        R16_SNORM = 71,
        R16_USCALED = 72,
        R16_SSCALED = 73,
        R16_UINT = 74,
        R16_SINT = 75,
        R16_SFLOAT = 76,
        R16G16_UNORM = 77,
        R16G16_SNORM = 78,
        R16G16_USCALED = 79,
        R16G16_SSCALED = 80,
        R16G16_UINT = 81,
        R16G16_SINT = 82,
        R16G16_SFLOAT = 83,
        R16G16B16_UNORM = 84,
        R16G16B16_SNORM = 85,
        R16G16B16_USCALED = 86,
        R16G16B16_SSCALED = 87,
        R16G16B16_UINT = 88,
        R16G16B16_SINT = 89,
        R16G16B16_SFLOAT = 90,
        R16G16B16A16_UNORM = 91,
        R16G16B16A16_SNORM = 92,
        R16G16B16A16_USCALED = 93,
        R16G16B16A16_SSCALED = 94,
        R16G16B16A16_UINT = 95,
        R16G16B16A16_SINT = 96,
        R16G16B16A16_SFLOAT = 97,
        R32_UINT = 98,
        R32_SINT = 99,
        R32_SFLOAT = 100,
        R32G32_UINT = 101,
        R32G32_SINT = 102,
        R32G32_SFLOAT = 103,
        R32G32B32_UINT = 104,
        R32G32B32_SINT = 105,
        R32G32B32_SFLOAT = 106,
        R32G32B32A32_UINT = 107,
        R32G32B32A32_SINT = 108,
        R32G32B32A32_SFLOAT = 109,
        R64_UINT = 110,
        R64_SINT = 111,
        R64_SFLOAT = 112,
        R64G64_UINT = 113,
        R64G64_SINT = 114,
        R64G64_SFLOAT = 115,
        R64G64B64_UINT = 116,
        R64G64B64_SINT = 117,
        R64G64B64_SFLOAT = 118,
        R64G64B64A64_UINT = 119,
        R64G64B64A64_SINT = 120,
        R64G64B64A64_SFLOAT = 121,
        B10G11R11_UFLOAT_PACK32 = 122,
        E5B9G9R9_UFLOAT_PACK32 = 123,
        D16_UNORM = 124,
        X8_D24_UNORM_PACK32 = 125,
        D32_SFLOAT = 126,
        S8_UINT = 127,
        D16_UNORM_S8_UINT = 128,
        D24_UNORM_S8_UINT = 129,
        D32_SFLOAT_S8_UINT = 130,
        BC1_RGB_UNORM_BLOCK = 131,
        BC1_RGB_SRGB_BLOCK = 132,
        BC1_RGBA_UNORM_BLOCK = 133,
        BC1_RGBA_SRGB_BLOCK = 134,
        BC2_UNORM_BLOCK = 135,
        BC2_SRGB_BLOCK = 136,
        BC3_UNORM_BLOCK = 137,
        BC3_SRGB_BLOCK = 138,
        BC4_UNORM_BLOCK = 139,
        BC4_SNORM_BLOCK = 140,
        BC5_UNORM_BLOCK = 141,
        BC5_SNORM_BLOCK = 142,
        BC6H_UFLOAT_BLOCK = 143,
        BC6H_SFLOAT_BLOCK = 144,
        BC7_UNORM_BLOCK = 145,
        BC7_SRGB_BLOCK = 146,
        ETC2_R8G8B8_UNORM_BLOCK = 147,
        ETC2_R8G8B8_SRGB_BLOCK = 148,
        ETC2_R8G8B8A1_UNORM_BLOCK = 149,
        ETC2_R8G8B8A1_SRGB_BLOCK = 150,
        ETC2_R8G8B8A8_UNORM_BLOCK = 151,
        ETC2_R8G8B8A8_SRGB_BLOCK = 152,
        EAC_R11_UNORM_BLOCK = 153,
        EAC_R11_SNORM_BLOCK = 154,
        EAC_R11G11_UNORM_BLOCK = 155,
        EAC_R11G11_SNORM_BLOCK = 156,
        ASTC_4x4_UNORM_BLOCK = 157,
        ASTC_4x4_SRGB_BLOCK = 158,
        ASTC_5x4_UNORM_BLOCK = 159,
        ASTC_5x4_SRGB_BLOCK = 160,
        ASTC_5x5_UNORM_BLOCK = 161,
        ASTC_5x5_SRGB_BLOCK = 162,
        ASTC_6x5_UNORM_BLOCK = 163,
        ASTC_6x5_SRGB_BLOCK = 164,
        ASTC_6x6_UNORM_BLOCK = 165,
        ASTC_6x6_SRGB_BLOCK = 166,
        ASTC_8x5_UNORM_BLOCK = 167,
        ASTC_8x5_SRGB_BLOCK = 168,
        ASTC_8x6_UNORM_BLOCK = 169,
        ASTC_8x6_SRGB_BLOCK = 170,
        ASTC_8x8_UNORM_BLOCK = 171,
        ASTC_8x8_SRGB_BLOCK = 172,
        ASTC_10x5_UNORM_BLOCK = 173,
        ASTC_10x5_SRGB_BLOCK = 174,
        ASTC_10x6_UNORM_BLOCK = 175,
        ASTC_10x6_SRGB_BLOCK = 176,
        ASTC_10x8_UNORM_BLOCK = 177,
        ASTC_10x8_SRGB_BLOCK = 178,
        ASTC_10x10_UNORM_BLOCK = 179,
        ASTC_10x10_SRGB_BLOCK = 180,
        ASTC_12x10_UNORM_BLOCK = 181,
        ASTC_12x10_SRGB_BLOCK = 182,
        ASTC_12x12_UNORM_BLOCK = 183,
        ASTC_12x12_SRGB_BLOCK = 184,
        G8B8G8R8_422_UNORM = 1000156000,
        B8G8R8G8_422_UNORM = 1000156001,
        G8_B8_R8_3PLANE_420_UNORM = 1000156002,
        G8_B8R8_2PLANE_420_UNORM = 1000156003,
        G8_B8_R8_3PLANE_422_UNORM = 1000156004,
        G8_B8R8_2PLANE_422_UNORM = 1000156005,
        G8_B8_R8_3PLANE_444_UNORM = 1000156006,
        R10X6_UNORM_PACK16 = 1000156007,
        R10X6G10X6_UNORM_2PACK16 = 1000156008,
        R10X6G10X6B10X6A10X6_UNORM_4PACK16 = 1000156009,
        G10X6B10X6G10X6R10X6_422_UNORM_4PACK16 = 1000156010,
        B10X6G10X6R10X6G10X6_422_UNORM_4PACK16 = 1000156011,
        G10X6_B10X6_R10X6_3PLANE_420_UNORM_3PACK16 = 1000156012,
        G10X6_B10X6R10X6_2PLANE_420_UNORM_3PACK16 = 1000156013,
        G10X6_B10X6_R10X6_3PLANE_422_UNORM_3PACK16 = 1000156014,
        G10X6_B10X6R10X6_2PLANE_422_UNORM_3PACK16 = 1000156015,
        G10X6_B10X6_R10X6_3PLANE_444_UNORM_3PACK16 = 1000156016,
        R12X4_UNORM_PACK16 = 1000156017,
        R12X4G12X4_UNORM_2PACK16 = 1000156018,
        R12X4G12X4B12X4A12X4_UNORM_4PACK16 = 1000156019,
        G12X4B12X4G12X4R12X4_422_UNORM_4PACK16 = 1000156020,
        B12X4G12X4R12X4G12X4_422_UNORM_4PACK16 = 1000156021,
        G12X4_B12X4_R12X4_3PLANE_420_UNORM_3PACK16 = 1000156022,
        G12X4_B12X4R12X4_2PLANE_420_UNORM_3PACK16 = 1000156023,
        G12X4_B12X4_R12X4_3PLANE_422_UNORM_3PACK16 = 1000156024,
        G12X4_B12X4R12X4_2PLANE_422_UNORM_3PACK16 = 1000156025,
        G12X4_B12X4_R12X4_3PLANE_444_UNORM_3PACK16 = 1000156026,
        G16B16G16R16_422_UNORM = 1000156027,
        B16G16R16G16_422_UNORM = 1000156028,
        G16_B16_R16_3PLANE_420_UNORM = 1000156029,
        G16_B16R16_2PLANE_420_UNORM = 1000156030,
        G16_B16_R16_3PLANE_422_UNORM = 1000156031,
        G16_B16R16_2PLANE_422_UNORM = 1000156032,
        G16_B16_R16_3PLANE_444_UNORM = 1000156033,
        G8_B8R8_2PLANE_444_UNORM = 1000330000,
        G10X6_B10X6R10X6_2PLANE_444_UNORM_3PACK16 = 1000330001,
        G12X4_B12X4R12X4_2PLANE_444_UNORM_3PACK16 = 1000330002,
        G16_B16R16_2PLANE_444_UNORM = 1000330003,
        A4R4G4B4_UNORM_PACK16 = 1000340000,
        A4B4G4R4_UNORM_PACK16 = 1000340001,
        ASTC_4x4_SFLOAT_BLOCK = 1000066000,
        ASTC_5x4_SFLOAT_BLOCK = 1000066001,
        ASTC_5x5_SFLOAT_BLOCK = 1000066002,
        ASTC_6x5_SFLOAT_BLOCK = 1000066003,
        ASTC_6x6_SFLOAT_BLOCK = 1000066004,
        ASTC_8x5_SFLOAT_BLOCK = 1000066005,
        ASTC_8x6_SFLOAT_BLOCK = 1000066006,
        ASTC_8x8_SFLOAT_BLOCK = 1000066007,
        ASTC_10x5_SFLOAT_BLOCK = 1000066008,
        ASTC_10x6_SFLOAT_BLOCK = 1000066009,
        ASTC_10x8_SFLOAT_BLOCK = 1000066010,
        ASTC_10x10_SFLOAT_BLOCK = 1000066011,
        ASTC_12x10_SFLOAT_BLOCK = 1000066012,
        ASTC_12x12_SFLOAT_BLOCK = 1000066013,
    }

    [Flags]
    internal enum VkFormatFeatureFlags : uint
    {
        SAMPLED_IMAGE = 0x1,
        STORAGE_IMAGE = 0x2,
        STORAGE_IMAGE_ATOMIC = 0x4,
        UNIFORM_TEXEL_BUFFER = 0x8,
        STORAGE_TEXEL_BUFFER = 0x10,
        STORAGE_TEXEL_BUFFER_ATOMIC = 0x20,
        VERTEX_BUFFER = 0x40,
        COLOR_ATTACHMENT = 0x80,
        COLOR_ATTACHMENT_BLEND = 0x100,
        DEPTH_STENCIL_ATTACHMENT = 0x200,
        BLIT_SRC = 0x400,
        BLIT_DST = 0x800,
        SAMPLED_IMAGE_FILTER_LINEAR = 0x1000,
        TRANSFER_SRC = 0x4000,
        TRANSFER_DST = 0x8000,
        MIDPOINT_CHROMA_SAMPLES = 0x20000,
        SAMPLED_IMAGE_YCBCR_CONVERSION_LINEAR_FILTER = 0x40000,
        SAMPLED_IMAGE_YCBCR_CONVERSION_SEPARATE_RECONSTRUCTION_FILTER = 0x80000,
        SAMPLED_IMAGE_YCBCR_CONVERSION_CHROMA_RECONSTRUCTION_EXPLICIT = 0x100000,
        SAMPLED_IMAGE_YCBCR_CONVERSION_CHROMA_RECONSTRUCTION_EXPLICIT_FORCEABLE = 0x200000,
        DISJOINT = 0x400000,
        COSITED_CHROMA_SAMPLES = 0x800000,
        SAMPLED_IMAGE_FILTER_MINMAX = 0x10000,
    }

    internal unsafe struct VkFormatProperties
    {
        public VkFormatFeatureFlags linearTilingFeatures;
        public VkFormatFeatureFlags optimalTilingFeatures;
        public VkFormatFeatureFlags bufferFeatures;
    }

    internal enum VkFramebuffer : ulong { Null }

    internal enum VkFrontFace : int
    {
        COUNTER_CLOCKWISE = 0,
        CLOCKWISE = 1,
    }

    internal unsafe struct VkGraphicsPipelineCreateInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public VkPipelineCreateFlags flags;
        public uint stageCount;
        public VkPipelineShaderStageCreateInfo* pStages;
        public VkPipelineVertexInputStateCreateInfo* pVertexInputState;
        public VkPipelineInputAssemblyStateCreateInfo* pInputAssemblyState;
        public VkPipelineTessellationStateCreateInfo* pTessellationState;
        public VkPipelineViewportStateCreateInfo* pViewportState;
        public VkPipelineRasterizationStateCreateInfo* pRasterizationState;
        public VkPipelineMultisampleStateCreateInfo* pMultisampleState;
        public VkPipelineDepthStencilStateCreateInfo* pDepthStencilState;
        public VkPipelineColorBlendStateCreateInfo* pColorBlendState;
        public VkPipelineDynamicStateCreateInfo* pDynamicState;
        public VkPipelineLayout layout;
        public VkRenderPass renderPass;
        public uint subpass;
        public VkPipeline basePipelineHandle;
        public int basePipelineIndex;
        public VkGraphicsPipelineCreateInfo() { sType = VkStructureType.GRAPHICS_PIPELINE_CREATE_INFO; }
    }

    internal enum VkImage : ulong { Null }

    [Flags]
    internal enum VkImageAspectFlags : uint
    {
        COLOR = 0x1,
        DEPTH = 0x2,
        STENCIL = 0x4,
        METADATA = 0x8,
        PLANE_0 = 0x10,
        PLANE_1 = 0x20,
        PLANE_2 = 0x40,
        NONE = 0x0,
    }

    internal unsafe struct VkImageCopy
    {
        public VkImageSubresourceLayers srcSubresource;
        public VkOffset3D srcOffset;
        public VkImageSubresourceLayers dstSubresource;
        public VkOffset3D dstOffset;
        public VkExtent3D extent;
    }

    [Flags]
    internal enum VkImageCreateFlags : uint
    {
        SPARSE_BINDING = 0x1,
        SPARSE_RESIDENCY = 0x2,
        SPARSE_ALIASED = 0x4,
        MUTABLE_FORMAT = 0x8,
        CUBE_COMPATIBLE = 0x10,
        ALIAS = 0x400,
        SPLIT_INSTANCE_BIND_REGIONS = 0x40,
        _2D_ARRAY_COMPATIBLE = 0x20,
        BLOCK_TEXEL_VIEW_COMPATIBLE = 0x80,
        EXTENDED_USAGE = 0x100,
        PROTECTED = 0x800,
        DISJOINT = 0x200,
    }

    internal unsafe struct VkImageCreateInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public VkImageCreateFlags flags;
        public VkImageType imageType;
        public VkFormat format;
        public VkExtent3D extent;
        public uint mipLevels;
        public uint arrayLayers;
        public VkSampleCountFlags samples;
        public VkImageTiling tiling;
        public VkImageUsageFlags usage;
        public VkSharingMode sharingMode;
        public uint queueFamilyIndexCount;
        public uint* pQueueFamilyIndices;
        public VkImageLayout initialLayout;
        public VkImageCreateInfo() { sType = VkStructureType.IMAGE_CREATE_INFO; }
    }

    internal enum VkImageLayout : int
    {
        UNDEFINED = 0,
        GENERAL = 1,
        COLOR_ATTACHMENT_OPTIMAL = 2,
        DEPTH_STENCIL_ATTACHMENT_OPTIMAL = 3,
        DEPTH_STENCIL_READ_ONLY_OPTIMAL = 4,
        SHADER_READ_ONLY_OPTIMAL = 5,
        TRANSFER_SRC_OPTIMAL = 6,
        TRANSFER_DST_OPTIMAL = 7,
        PREINITIALIZED = 8,
        DEPTH_READ_ONLY_STENCIL_ATTACHMENT_OPTIMAL = 1000117000,
        DEPTH_ATTACHMENT_STENCIL_READ_ONLY_OPTIMAL = 1000117001,
        DEPTH_ATTACHMENT_OPTIMAL = 1000241000,
        DEPTH_READ_ONLY_OPTIMAL = 1000241001,
        STENCIL_ATTACHMENT_OPTIMAL = 1000241002,
        STENCIL_READ_ONLY_OPTIMAL = 1000241003,
        READ_ONLY_OPTIMAL = 1000314000,
        ATTACHMENT_OPTIMAL = 1000314001,
    }

    internal unsafe struct VkImageMemoryBarrier2
    {
        public VkStructureType sType;
        public void* pNext;
        public VkPipelineStageFlags2 srcStageMask;
        public VkAccessFlags2 srcAccessMask;
        public VkPipelineStageFlags2 dstStageMask;
        public VkAccessFlags2 dstAccessMask;
        public VkImageLayout oldLayout;
        public VkImageLayout newLayout;
        public uint srcQueueFamilyIndex;
        public uint dstQueueFamilyIndex;
        public VkImage image;
        public VkImageSubresourceRange subresourceRange;
        public VkImageMemoryBarrier2() { sType = VkStructureType.IMAGE_MEMORY_BARRIER_2; }
    }

    internal unsafe struct VkImageSubresourceLayers
    {
        public VkImageAspectFlags aspectMask;
        public uint mipLevel;
        public uint baseArrayLayer;
        public uint layerCount;
    }

    internal unsafe struct VkImageSubresourceRange
    {
        public VkImageAspectFlags aspectMask;
        public uint baseMipLevel;
        public uint levelCount;
        public uint baseArrayLayer;
        public uint layerCount;
    }

    internal enum VkImageTiling : int
    {
        OPTIMAL = 0,
        LINEAR = 1,
    }

    internal enum VkImageType : int
    {
        _1D = 0,
        _2D = 1,
        _3D = 2,
    }

    [Flags]
    internal enum VkImageUsageFlags : uint
    {
        TRANSFER_SRC = 0x1,
        TRANSFER_DST = 0x2,
        SAMPLED = 0x4,
        STORAGE = 0x8,
        COLOR_ATTACHMENT = 0x10,
        DEPTH_STENCIL_ATTACHMENT = 0x20,
        TRANSIENT_ATTACHMENT = 0x40,
        INPUT_ATTACHMENT = 0x80,
    }

    internal enum VkImageView : ulong { Null }

    internal unsafe struct VkImageViewCreateInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public uint flags;
        public VkImage image;
        public VkImageViewType viewType;
        public VkFormat format;
        public VkComponentMapping components;
        public VkImageSubresourceRange subresourceRange;
        public VkImageViewCreateInfo() { sType = VkStructureType.IMAGE_VIEW_CREATE_INFO; }
    }

    internal enum VkImageViewType : int
    {
        _1D = 0,
        _2D = 1,
        _3D = 2,
        CUBE = 3,
        _1D_ARRAY = 4,
        _2D_ARRAY = 5,
        CUBE_ARRAY = 6,
    }

    internal enum VkIndexType : int
    {
        UINT16 = 0,
        UINT32 = 1,
    }

    internal enum VkInstance : ulong { Null }

    internal unsafe struct VkInstanceCreateInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public uint flags;
        public VkApplicationInfo* pApplicationInfo;
        public uint enabledLayerCount;
        public byte** ppEnabledLayerNames;
        public uint enabledExtensionCount;
        public byte** ppEnabledExtensionNames;
        public VkInstanceCreateInfo() { sType = VkStructureType.INSTANCE_CREATE_INFO; }
    }

    internal unsafe struct VkLayerProperties
    {
        public fixed byte layerName[256];
        public uint specVersion;
        public uint implementationVersion;
        public fixed byte description[256];
    }

    internal enum VkLogicOp : int
    {
        CLEAR = 0,
        AND = 1,
        AND_REVERSE = 2,
        COPY = 3,
        AND_INVERTED = 4,
        NO_OP = 5,
        XOR = 6,
        OR = 7,
        NOR = 8,
        EQUIVALENT = 9,
        INVERT = 10,
        OR_REVERSE = 11,
        COPY_INVERTED = 12,
        OR_INVERTED = 13,
        NAND = 14,
        SET = 15,
    }

    internal unsafe struct VkMemoryAllocateInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public ulong allocationSize;
        public uint memoryTypeIndex;
        public VkMemoryAllocateInfo() { sType = VkStructureType.MEMORY_ALLOCATE_INFO; }
    }

    internal unsafe struct VkMemoryBarrier2
    {
        public VkStructureType sType;
        public void* pNext;
        public VkPipelineStageFlags2 srcStageMask;
        public VkAccessFlags2 srcAccessMask;
        public VkPipelineStageFlags2 dstStageMask;
        public VkAccessFlags2 dstAccessMask;
        public VkMemoryBarrier2() { sType = VkStructureType.MEMORY_BARRIER_2; }
    }

    internal unsafe struct VkMemoryHeap
    {
        public ulong size;
        public VkMemoryHeapFlags flags;
    }

    [Flags]
    internal enum VkMemoryHeapFlags : uint
    {
        DEVICE_LOCAL = 0x1,
        MULTI_INSTANCE = 0x2,
    }

    [Flags]
    internal enum VkMemoryPropertyFlags : uint
    {
        DEVICE_LOCAL = 0x1,
        HOST_VISIBLE = 0x2,
        HOST_COHERENT = 0x4,
        HOST_CACHED = 0x8,
        LAZILY_ALLOCATED = 0x10,
        PROTECTED = 0x20,
    }

    internal unsafe struct VkMemoryRequirements
    {
        public ulong size;
        public ulong alignment;
        public uint memoryTypeBits;
    }

    internal unsafe struct VkMemoryType
    {
        public VkMemoryPropertyFlags propertyFlags;
        public uint heapIndex;
    }

    internal enum VkObjectType : int
    {
        UNKNOWN = 0,
        INSTANCE = 1,
        PHYSICAL_DEVICE = 2,
        DEVICE = 3,
        QUEUE = 4,
        SEMAPHORE = 5,
        COMMAND_BUFFER = 6,
        FENCE = 7,
        DEVICE_MEMORY = 8,
        BUFFER = 9,
        IMAGE = 10,
        EVENT = 11,
        QUERY_POOL = 12,
        BUFFER_VIEW = 13,
        IMAGE_VIEW = 14,
        SHADER_MODULE = 15,
        PIPELINE_CACHE = 16,
        PIPELINE_LAYOUT = 17,
        RENDER_PASS = 18,
        PIPELINE = 19,
        DESCRIPTOR_SET_LAYOUT = 20,
        SAMPLER = 21,
        DESCRIPTOR_POOL = 22,
        DESCRIPTOR_SET = 23,
        FRAMEBUFFER = 24,
        COMMAND_POOL = 25,
        SAMPLER_YCBCR_CONVERSION = 1000156000,
        DESCRIPTOR_UPDATE_TEMPLATE = 1000085000,
        PRIVATE_DATA_SLOT = 1000295000,
        DEBUG_UTILS_MESSENGER_EXT = 1000128000,
    }

    internal unsafe struct VkOffset2D
    {
        public int x;
        public int y;
    }

    internal unsafe struct VkOffset3D
    {
        public int x;
        public int y;
        public int z;
    }

    internal enum VkPhysicalDevice : ulong { Null }

    internal unsafe struct VkPhysicalDeviceFeatures
    {
        public VkBool32 robustBufferAccess;
        public VkBool32 fullDrawIndexUint32;
        public VkBool32 imageCubeArray;
        public VkBool32 independentBlend;
        public VkBool32 geometryShader;
        public VkBool32 tessellationShader;
        public VkBool32 sampleRateShading;
        public VkBool32 dualSrcBlend;
        public VkBool32 logicOp;
        public VkBool32 multiDrawIndirect;
        public VkBool32 drawIndirectFirstInstance;
        public VkBool32 depthClamp;
        public VkBool32 depthBiasClamp;
        public VkBool32 fillModeNonSolid;
        public VkBool32 depthBounds;
        public VkBool32 wideLines;
        public VkBool32 largePoints;
        public VkBool32 alphaToOne;
        public VkBool32 multiViewport;
        public VkBool32 samplerAnisotropy;
        public VkBool32 textureCompressionETC2;
        public VkBool32 textureCompressionASTC_LDR;
        public VkBool32 textureCompressionBC;
        public VkBool32 occlusionQueryPrecise;
        public VkBool32 pipelineStatisticsQuery;
        public VkBool32 vertexPipelineStoresAndAtomics;
        public VkBool32 fragmentStoresAndAtomics;
        public VkBool32 shaderTessellationAndGeometryPointSize;
        public VkBool32 shaderImageGatherExtended;
        public VkBool32 shaderStorageImageExtendedFormats;
        public VkBool32 shaderStorageImageMultisample;
        public VkBool32 shaderStorageImageReadWithoutFormat;
        public VkBool32 shaderStorageImageWriteWithoutFormat;
        public VkBool32 shaderUniformBufferArrayDynamicIndexing;
        public VkBool32 shaderSampledImageArrayDynamicIndexing;
        public VkBool32 shaderStorageBufferArrayDynamicIndexing;
        public VkBool32 shaderStorageImageArrayDynamicIndexing;
        public VkBool32 shaderClipDistance;
        public VkBool32 shaderCullDistance;
        public VkBool32 shaderFloat64;
        public VkBool32 shaderInt64;
        public VkBool32 shaderInt16;
        public VkBool32 shaderResourceResidency;
        public VkBool32 shaderResourceMinLod;
        public VkBool32 sparseBinding;
        public VkBool32 sparseResidencyBuffer;
        public VkBool32 sparseResidencyImage2D;
        public VkBool32 sparseResidencyImage3D;
        public VkBool32 sparseResidency2Samples;
        public VkBool32 sparseResidency4Samples;
        public VkBool32 sparseResidency8Samples;
        public VkBool32 sparseResidency16Samples;
        public VkBool32 sparseResidencyAliased;
        public VkBool32 variableMultisampleRate;
        public VkBool32 inheritedQueries;
    }

    internal unsafe struct VkPhysicalDeviceFeatures2
    {
        public VkStructureType sType;
        public void* pNext;
        public VkPhysicalDeviceFeatures features;
        public VkPhysicalDeviceFeatures2() { sType = VkStructureType.PHYSICAL_DEVICE_FEATURES_2; }
    }

    internal unsafe struct VkPhysicalDeviceLimits
    {
        public uint maxImageDimension1D;
        public uint maxImageDimension2D;
        public uint maxImageDimension3D;
        public uint maxImageDimensionCube;
        public uint maxImageArrayLayers;
        public uint maxTexelBufferElements;
        public uint maxUniformBufferRange;
        public uint maxStorageBufferRange;
        public uint maxPushConstantsSize;
        public uint maxMemoryAllocationCount;
        public uint maxSamplerAllocationCount;
        public ulong bufferImageGranularity;
        public ulong sparseAddressSpaceSize;
        public uint maxBoundDescriptorSets;
        public uint maxPerStageDescriptorSamplers;
        public uint maxPerStageDescriptorUniformBuffers;
        public uint maxPerStageDescriptorStorageBuffers;
        public uint maxPerStageDescriptorSampledImages;
        public uint maxPerStageDescriptorStorageImages;
        public uint maxPerStageDescriptorInputAttachments;
        public uint maxPerStageResources;
        public uint maxDescriptorSetSamplers;
        public uint maxDescriptorSetUniformBuffers;
        public uint maxDescriptorSetUniformBuffersDynamic;
        public uint maxDescriptorSetStorageBuffers;
        public uint maxDescriptorSetStorageBuffersDynamic;
        public uint maxDescriptorSetSampledImages;
        public uint maxDescriptorSetStorageImages;
        public uint maxDescriptorSetInputAttachments;
        public uint maxVertexInputAttributes;
        public uint maxVertexInputBindings;
        public uint maxVertexInputAttributeOffset;
        public uint maxVertexInputBindingStride;
        public uint maxVertexOutputComponents;
        public uint maxTessellationGenerationLevel;
        public uint maxTessellationPatchSize;
        public uint maxTessellationControlPerVertexInputComponents;
        public uint maxTessellationControlPerVertexOutputComponents;
        public uint maxTessellationControlPerPatchOutputComponents;
        public uint maxTessellationControlTotalOutputComponents;
        public uint maxTessellationEvaluationInputComponents;
        public uint maxTessellationEvaluationOutputComponents;
        public uint maxGeometryShaderInvocations;
        public uint maxGeometryInputComponents;
        public uint maxGeometryOutputComponents;
        public uint maxGeometryOutputVertices;
        public uint maxGeometryTotalOutputComponents;
        public uint maxFragmentInputComponents;
        public uint maxFragmentOutputAttachments;
        public uint maxFragmentDualSrcAttachments;
        public uint maxFragmentCombinedOutputResources;
        public uint maxComputeSharedMemorySize;
        public fixed uint maxComputeWorkGroupCount[3];
        public uint maxComputeWorkGroupInvocations;
        public fixed uint maxComputeWorkGroupSize[3];
        public uint subPixelPrecisionBits;
        public uint subTexelPrecisionBits;
        public uint mipmapPrecisionBits;
        public uint maxDrawIndexedIndexValue;
        public uint maxDrawIndirectCount;
        public float maxSamplerLodBias;
        public float maxSamplerAnisotropy;
        public uint maxViewports;
        public fixed uint maxViewportDimensions[2];
        public fixed float viewportBoundsRange[2];
        public uint viewportSubPixelBits;
        public nuint minMemoryMapAlignment;
        public ulong minTexelBufferOffsetAlignment;
        public ulong minUniformBufferOffsetAlignment;
        public ulong minStorageBufferOffsetAlignment;
        public int minTexelOffset;
        public uint maxTexelOffset;
        public int minTexelGatherOffset;
        public uint maxTexelGatherOffset;
        public float minInterpolationOffset;
        public float maxInterpolationOffset;
        public uint subPixelInterpolationOffsetBits;
        public uint maxFramebufferWidth;
        public uint maxFramebufferHeight;
        public uint maxFramebufferLayers;
        public VkSampleCountFlags framebufferColorSampleCounts;
        public VkSampleCountFlags framebufferDepthSampleCounts;
        public VkSampleCountFlags framebufferStencilSampleCounts;
        public VkSampleCountFlags framebufferNoAttachmentsSampleCounts;
        public uint maxColorAttachments;
        public VkSampleCountFlags sampledImageColorSampleCounts;
        public VkSampleCountFlags sampledImageIntegerSampleCounts;
        public VkSampleCountFlags sampledImageDepthSampleCounts;
        public VkSampleCountFlags sampledImageStencilSampleCounts;
        public VkSampleCountFlags storageImageSampleCounts;
        public uint maxSampleMaskWords;
        public VkBool32 timestampComputeAndGraphics;
        public float timestampPeriod;
        public uint maxClipDistances;
        public uint maxCullDistances;
        public uint maxCombinedClipAndCullDistances;
        public uint discreteQueuePriorities;
        public fixed float pointSizeRange[2];
        public fixed float lineWidthRange[2];
        public float pointSizeGranularity;
        public float lineWidthGranularity;
        public VkBool32 strictLines;
        public VkBool32 standardSampleLocations;
        public ulong optimalBufferCopyOffsetAlignment;
        public ulong optimalBufferCopyRowPitchAlignment;
        public ulong nonCoherentAtomSize;
    }

    internal unsafe struct VkPhysicalDeviceMemoryProperties
    {
        public uint memoryTypeCount;
        public VkMemoryTypeArray32 memoryTypes;
        public uint memoryHeapCount;
        public VkMemoryHeapArray16 memoryHeaps;
    }

    internal unsafe struct VkPhysicalDeviceProperties
    {
        public uint apiVersion;
        public uint driverVersion;
        public uint vendorID;
        public uint deviceID;
        public VkPhysicalDeviceType deviceType;
        public fixed byte deviceName[256];
        public fixed byte pipelineCacheUUID[16];
        public VkPhysicalDeviceLimits limits;
        public VkPhysicalDeviceSparseProperties sparseProperties;
    }

    internal unsafe struct VkPhysicalDeviceProperties2
    {
        public VkStructureType sType;
        public void* pNext;
        public VkPhysicalDeviceProperties properties;
        public VkPhysicalDeviceProperties2() { sType = VkStructureType.PHYSICAL_DEVICE_PROPERTIES_2; }
    }

    internal unsafe struct VkPhysicalDevicePushDescriptorPropertiesKHR
    {
        public VkStructureType sType;
        public void* pNext;
        public uint maxPushDescriptors;
        public VkPhysicalDevicePushDescriptorPropertiesKHR() { sType = VkStructureType.PHYSICAL_DEVICE_PUSH_DESCRIPTOR_PROPERTIES_KHR; }
    }

    internal unsafe struct VkPhysicalDeviceRobustness2FeaturesEXT
    {
        public VkStructureType sType;
        public void* pNext;
        public VkBool32 robustBufferAccess2;
        public VkBool32 robustImageAccess2;
        public VkBool32 nullDescriptor;
        public VkPhysicalDeviceRobustness2FeaturesEXT() { sType = VkStructureType.PHYSICAL_DEVICE_ROBUSTNESS_2_FEATURES_EXT; }
    }

    internal unsafe struct VkPhysicalDeviceRobustness2PropertiesEXT
    {
        public VkStructureType sType;
        public void* pNext;
        public ulong robustStorageBufferAccessSizeAlignment;
        public ulong robustUniformBufferAccessSizeAlignment;
        public VkPhysicalDeviceRobustness2PropertiesEXT() { sType = VkStructureType.PHYSICAL_DEVICE_ROBUSTNESS_2_PROPERTIES_EXT; }
    }

    internal unsafe struct VkPhysicalDeviceSparseProperties
    {
        public VkBool32 residencyStandard2DBlockShape;
        public VkBool32 residencyStandard2DMultisampleBlockShape;
        public VkBool32 residencyStandard3DBlockShape;
        public VkBool32 residencyAlignedMipSize;
        public VkBool32 residencyNonResidentStrict;
    }

    internal enum VkPhysicalDeviceType : int
    {
        OTHER = 0,
        INTEGRATED_GPU = 1,
        DISCRETE_GPU = 2,
        VIRTUAL_GPU = 3,
        CPU = 4,
    }

    internal unsafe struct VkPhysicalDeviceVulkan11Features
    {
        public VkStructureType sType;
        public void* pNext;
        public VkBool32 storageBuffer16BitAccess;
        public VkBool32 uniformAndStorageBuffer16BitAccess;
        public VkBool32 storagePushConstant16;
        public VkBool32 storageInputOutput16;
        public VkBool32 multiview;
        public VkBool32 multiviewGeometryShader;
        public VkBool32 multiviewTessellationShader;
        public VkBool32 variablePointersStorageBuffer;
        public VkBool32 variablePointers;
        public VkBool32 protectedMemory;
        public VkBool32 samplerYcbcrConversion;
        public VkBool32 shaderDrawParameters;
        public VkPhysicalDeviceVulkan11Features() { sType = VkStructureType.PHYSICAL_DEVICE_VULKAN_1_1_FEATURES; }
    }

    internal unsafe struct VkPhysicalDeviceVulkan11Properties
    {
        public VkStructureType sType;
        public void* pNext;
        public fixed byte deviceUUID[16];
        public fixed byte driverUUID[16];
        public fixed byte deviceLUID[8];
        public uint deviceNodeMask;
        public VkBool32 deviceLUIDValid;
        public uint subgroupSize;
        public VkShaderStageFlags subgroupSupportedStages;
        public VkSubgroupFeatureFlags subgroupSupportedOperations;
        public VkBool32 subgroupQuadOperationsInAllStages;
        public VkPointClippingBehavior pointClippingBehavior;
        public uint maxMultiviewViewCount;
        public uint maxMultiviewInstanceIndex;
        public VkBool32 protectedNoFault;
        public uint maxPerSetDescriptors;
        public ulong maxMemoryAllocationSize;
        public VkPhysicalDeviceVulkan11Properties() { sType = VkStructureType.PHYSICAL_DEVICE_VULKAN_1_1_PROPERTIES; }
    }

    internal unsafe struct VkPhysicalDeviceVulkan12Features
    {
        public VkStructureType sType;
        public void* pNext;
        public VkBool32 samplerMirrorClampToEdge;
        public VkBool32 drawIndirectCount;
        public VkBool32 storageBuffer8BitAccess;
        public VkBool32 uniformAndStorageBuffer8BitAccess;
        public VkBool32 storagePushConstant8;
        public VkBool32 shaderBufferInt64Atomics;
        public VkBool32 shaderSharedInt64Atomics;
        public VkBool32 shaderFloat16;
        public VkBool32 shaderInt8;
        public VkBool32 descriptorIndexing;
        public VkBool32 shaderInputAttachmentArrayDynamicIndexing;
        public VkBool32 shaderUniformTexelBufferArrayDynamicIndexing;
        public VkBool32 shaderStorageTexelBufferArrayDynamicIndexing;
        public VkBool32 shaderUniformBufferArrayNonUniformIndexing;
        public VkBool32 shaderSampledImageArrayNonUniformIndexing;
        public VkBool32 shaderStorageBufferArrayNonUniformIndexing;
        public VkBool32 shaderStorageImageArrayNonUniformIndexing;
        public VkBool32 shaderInputAttachmentArrayNonUniformIndexing;
        public VkBool32 shaderUniformTexelBufferArrayNonUniformIndexing;
        public VkBool32 shaderStorageTexelBufferArrayNonUniformIndexing;
        public VkBool32 descriptorBindingUniformBufferUpdateAfterBind;
        public VkBool32 descriptorBindingSampledImageUpdateAfterBind;
        public VkBool32 descriptorBindingStorageImageUpdateAfterBind;
        public VkBool32 descriptorBindingStorageBufferUpdateAfterBind;
        public VkBool32 descriptorBindingUniformTexelBufferUpdateAfterBind;
        public VkBool32 descriptorBindingStorageTexelBufferUpdateAfterBind;
        public VkBool32 descriptorBindingUpdateUnusedWhilePending;
        public VkBool32 descriptorBindingPartiallyBound;
        public VkBool32 descriptorBindingVariableDescriptorCount;
        public VkBool32 runtimeDescriptorArray;
        public VkBool32 samplerFilterMinmax;
        public VkBool32 scalarBlockLayout;
        public VkBool32 imagelessFramebuffer;
        public VkBool32 uniformBufferStandardLayout;
        public VkBool32 shaderSubgroupExtendedTypes;
        public VkBool32 separateDepthStencilLayouts;
        public VkBool32 hostQueryReset;
        public VkBool32 timelineSemaphore;
        public VkBool32 bufferDeviceAddress;
        public VkBool32 bufferDeviceAddressCaptureReplay;
        public VkBool32 bufferDeviceAddressMultiDevice;
        public VkBool32 vulkanMemoryModel;
        public VkBool32 vulkanMemoryModelDeviceScope;
        public VkBool32 vulkanMemoryModelAvailabilityVisibilityChains;
        public VkBool32 shaderOutputViewportIndex;
        public VkBool32 shaderOutputLayer;
        public VkBool32 subgroupBroadcastDynamicId;
        public VkPhysicalDeviceVulkan12Features() { sType = VkStructureType.PHYSICAL_DEVICE_VULKAN_1_2_FEATURES; }
    }

    internal unsafe struct VkPhysicalDeviceVulkan12Properties
    {
        public VkStructureType sType;
        public void* pNext;
        public VkDriverId driverID;
        public fixed byte driverName[256];
        public fixed byte driverInfo[256];
        public VkConformanceVersion conformanceVersion;
        public VkShaderFloatControlsIndependence denormBehaviorIndependence;
        public VkShaderFloatControlsIndependence roundingModeIndependence;
        public VkBool32 shaderSignedZeroInfNanPreserveFloat16;
        public VkBool32 shaderSignedZeroInfNanPreserveFloat32;
        public VkBool32 shaderSignedZeroInfNanPreserveFloat64;
        public VkBool32 shaderDenormPreserveFloat16;
        public VkBool32 shaderDenormPreserveFloat32;
        public VkBool32 shaderDenormPreserveFloat64;
        public VkBool32 shaderDenormFlushToZeroFloat16;
        public VkBool32 shaderDenormFlushToZeroFloat32;
        public VkBool32 shaderDenormFlushToZeroFloat64;
        public VkBool32 shaderRoundingModeRTEFloat16;
        public VkBool32 shaderRoundingModeRTEFloat32;
        public VkBool32 shaderRoundingModeRTEFloat64;
        public VkBool32 shaderRoundingModeRTZFloat16;
        public VkBool32 shaderRoundingModeRTZFloat32;
        public VkBool32 shaderRoundingModeRTZFloat64;
        public uint maxUpdateAfterBindDescriptorsInAllPools;
        public VkBool32 shaderUniformBufferArrayNonUniformIndexingNative;
        public VkBool32 shaderSampledImageArrayNonUniformIndexingNative;
        public VkBool32 shaderStorageBufferArrayNonUniformIndexingNative;
        public VkBool32 shaderStorageImageArrayNonUniformIndexingNative;
        public VkBool32 shaderInputAttachmentArrayNonUniformIndexingNative;
        public VkBool32 robustBufferAccessUpdateAfterBind;
        public VkBool32 quadDivergentImplicitLod;
        public uint maxPerStageDescriptorUpdateAfterBindSamplers;
        public uint maxPerStageDescriptorUpdateAfterBindUniformBuffers;
        public uint maxPerStageDescriptorUpdateAfterBindStorageBuffers;
        public uint maxPerStageDescriptorUpdateAfterBindSampledImages;
        public uint maxPerStageDescriptorUpdateAfterBindStorageImages;
        public uint maxPerStageDescriptorUpdateAfterBindInputAttachments;
        public uint maxPerStageUpdateAfterBindResources;
        public uint maxDescriptorSetUpdateAfterBindSamplers;
        public uint maxDescriptorSetUpdateAfterBindUniformBuffers;
        public uint maxDescriptorSetUpdateAfterBindUniformBuffersDynamic;
        public uint maxDescriptorSetUpdateAfterBindStorageBuffers;
        public uint maxDescriptorSetUpdateAfterBindStorageBuffersDynamic;
        public uint maxDescriptorSetUpdateAfterBindSampledImages;
        public uint maxDescriptorSetUpdateAfterBindStorageImages;
        public uint maxDescriptorSetUpdateAfterBindInputAttachments;
        public VkResolveModeFlags supportedDepthResolveModes;
        public VkResolveModeFlags supportedStencilResolveModes;
        public VkBool32 independentResolveNone;
        public VkBool32 independentResolve;
        public VkBool32 filterMinmaxSingleComponentFormats;
        public VkBool32 filterMinmaxImageComponentMapping;
        public ulong maxTimelineSemaphoreValueDifference;
        public VkSampleCountFlags framebufferIntegerColorSampleCounts;
        public VkPhysicalDeviceVulkan12Properties() { sType = VkStructureType.PHYSICAL_DEVICE_VULKAN_1_2_PROPERTIES; }
    }

    internal unsafe struct VkPhysicalDeviceVulkan13Features
    {
        public VkStructureType sType;
        public void* pNext;
        public VkBool32 robustImageAccess;
        public VkBool32 inlineUniformBlock;
        public VkBool32 descriptorBindingInlineUniformBlockUpdateAfterBind;
        public VkBool32 pipelineCreationCacheControl;
        public VkBool32 privateData;
        public VkBool32 shaderDemoteToHelperInvocation;
        public VkBool32 shaderTerminateInvocation;
        public VkBool32 subgroupSizeControl;
        public VkBool32 computeFullSubgroups;
        public VkBool32 synchronization2;
        public VkBool32 textureCompressionASTC_HDR;
        public VkBool32 shaderZeroInitializeWorkgroupMemory;
        public VkBool32 dynamicRendering;
        public VkBool32 shaderIntegerDotProduct;
        public VkBool32 maintenance4;
        public VkPhysicalDeviceVulkan13Features() { sType = VkStructureType.PHYSICAL_DEVICE_VULKAN_1_3_FEATURES; }
    }

    internal unsafe struct VkPhysicalDeviceVulkan13Properties
    {
        public VkStructureType sType;
        public void* pNext;
        public uint minSubgroupSize;
        public uint maxSubgroupSize;
        public uint maxComputeWorkgroupSubgroups;
        public VkShaderStageFlags requiredSubgroupSizeStages;
        public uint maxInlineUniformBlockSize;
        public uint maxPerStageDescriptorInlineUniformBlocks;
        public uint maxPerStageDescriptorUpdateAfterBindInlineUniformBlocks;
        public uint maxDescriptorSetInlineUniformBlocks;
        public uint maxDescriptorSetUpdateAfterBindInlineUniformBlocks;
        public uint maxInlineUniformTotalSize;
        public VkBool32 integerDotProduct8BitUnsignedAccelerated;
        public VkBool32 integerDotProduct8BitSignedAccelerated;
        public VkBool32 integerDotProduct8BitMixedSignednessAccelerated;
        public VkBool32 integerDotProduct4x8BitPackedUnsignedAccelerated;
        public VkBool32 integerDotProduct4x8BitPackedSignedAccelerated;
        public VkBool32 integerDotProduct4x8BitPackedMixedSignednessAccelerated;
        public VkBool32 integerDotProduct16BitUnsignedAccelerated;
        public VkBool32 integerDotProduct16BitSignedAccelerated;
        public VkBool32 integerDotProduct16BitMixedSignednessAccelerated;
        public VkBool32 integerDotProduct32BitUnsignedAccelerated;
        public VkBool32 integerDotProduct32BitSignedAccelerated;
        public VkBool32 integerDotProduct32BitMixedSignednessAccelerated;
        public VkBool32 integerDotProduct64BitUnsignedAccelerated;
        public VkBool32 integerDotProduct64BitSignedAccelerated;
        public VkBool32 integerDotProduct64BitMixedSignednessAccelerated;
        public VkBool32 integerDotProductAccumulatingSaturating8BitUnsignedAccelerated;
        public VkBool32 integerDotProductAccumulatingSaturating8BitSignedAccelerated;
        public VkBool32 integerDotProductAccumulatingSaturating8BitMixedSignednessAccelerated;
        public VkBool32 integerDotProductAccumulatingSaturating4x8BitPackedUnsignedAccelerated;
        public VkBool32 integerDotProductAccumulatingSaturating4x8BitPackedSignedAccelerated;
        public VkBool32 integerDotProductAccumulatingSaturating4x8BitPackedMixedSignednessAccelerated;
        public VkBool32 integerDotProductAccumulatingSaturating16BitUnsignedAccelerated;
        public VkBool32 integerDotProductAccumulatingSaturating16BitSignedAccelerated;
        public VkBool32 integerDotProductAccumulatingSaturating16BitMixedSignednessAccelerated;
        public VkBool32 integerDotProductAccumulatingSaturating32BitUnsignedAccelerated;
        public VkBool32 integerDotProductAccumulatingSaturating32BitSignedAccelerated;
        public VkBool32 integerDotProductAccumulatingSaturating32BitMixedSignednessAccelerated;
        public VkBool32 integerDotProductAccumulatingSaturating64BitUnsignedAccelerated;
        public VkBool32 integerDotProductAccumulatingSaturating64BitSignedAccelerated;
        public VkBool32 integerDotProductAccumulatingSaturating64BitMixedSignednessAccelerated;
        public ulong storageTexelBufferOffsetAlignmentBytes;
        public VkBool32 storageTexelBufferOffsetSingleTexelAlignment;
        public ulong uniformTexelBufferOffsetAlignmentBytes;
        public VkBool32 uniformTexelBufferOffsetSingleTexelAlignment;
        public ulong maxBufferSize;
        public VkPhysicalDeviceVulkan13Properties() { sType = VkStructureType.PHYSICAL_DEVICE_VULKAN_1_3_PROPERTIES; }
    }

    internal enum VkPipeline : ulong { Null }

    internal enum VkPipelineBindPoint : int
    {
        GRAPHICS = 0,
        COMPUTE = 1,
    }

    internal enum VkPipelineCache : ulong { Null }

    [Flags]
    internal enum VkPipelineCacheCreateFlags : uint
    {
        EXTERNALLY_SYNCHRONIZED = 0x1,
    }

    internal unsafe struct VkPipelineCacheCreateInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public VkPipelineCacheCreateFlags flags;
        public nuint initialDataSize;
        public void* pInitialData;
        public VkPipelineCacheCreateInfo() { sType = VkStructureType.PIPELINE_CACHE_CREATE_INFO; }
    }

    internal unsafe struct VkPipelineColorBlendAttachmentState
    {
        public VkBool32 blendEnable;
        public VkBlendFactor srcColorBlendFactor;
        public VkBlendFactor dstColorBlendFactor;
        public VkBlendOp colorBlendOp;
        public VkBlendFactor srcAlphaBlendFactor;
        public VkBlendFactor dstAlphaBlendFactor;
        public VkBlendOp alphaBlendOp;
        public VkColorComponentFlags colorWriteMask;
    }

    internal unsafe struct VkPipelineColorBlendStateCreateInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public uint flags;
        public VkBool32 logicOpEnable;
        public VkLogicOp logicOp;
        public uint attachmentCount;
        public VkPipelineColorBlendAttachmentState* pAttachments;
        public fixed float blendConstants[4];
        public VkPipelineColorBlendStateCreateInfo() { sType = VkStructureType.PIPELINE_COLOR_BLEND_STATE_CREATE_INFO; }
    }

    [Flags]
    internal enum VkPipelineCreateFlags : uint
    {
        DISABLE_OPTIMIZATION = 0x1,
        ALLOW_DERIVATIVES = 0x2,
        DERIVATIVE = 0x4,
        VIEW_INDEX_FROM_DEVICE_INDEX = 0x8,
        DISPATCH_BASE = 0x10,
        FAIL_ON_PIPELINE_COMPILE_REQUIRED = 0x100,
        EARLY_RETURN_ON_FAILURE = 0x200,
    }

    internal unsafe struct VkPipelineDepthStencilStateCreateInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public uint flags;
        public VkBool32 depthTestEnable;
        public VkBool32 depthWriteEnable;
        public VkCompareOp depthCompareOp;
        public VkBool32 depthBoundsTestEnable;
        public VkBool32 stencilTestEnable;
        public VkStencilOpState front;
        public VkStencilOpState back;
        public float minDepthBounds;
        public float maxDepthBounds;
        public VkPipelineDepthStencilStateCreateInfo() { sType = VkStructureType.PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO; }
    }

    internal unsafe struct VkPipelineDynamicStateCreateInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public uint flags;
        public uint dynamicStateCount;
        public VkDynamicState* pDynamicStates;
        public VkPipelineDynamicStateCreateInfo() { sType = VkStructureType.PIPELINE_DYNAMIC_STATE_CREATE_INFO; }
    }

    internal unsafe struct VkPipelineInputAssemblyStateCreateInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public uint flags;
        public VkPrimitiveTopology topology;
        public VkBool32 primitiveRestartEnable;
        public VkPipelineInputAssemblyStateCreateInfo() { sType = VkStructureType.PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO; }
    }

    internal enum VkPipelineLayout : ulong { Null }

    internal unsafe struct VkPipelineLayoutCreateInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public uint flags;
        public uint setLayoutCount;
        public VkDescriptorSetLayout* pSetLayouts;
        public uint pushConstantRangeCount;
        public VkPushConstantRange* pPushConstantRanges;
        public VkPipelineLayoutCreateInfo() { sType = VkStructureType.PIPELINE_LAYOUT_CREATE_INFO; }
    }

    internal unsafe struct VkPipelineMultisampleStateCreateInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public uint flags;
        public VkSampleCountFlags rasterizationSamples;
        public VkBool32 sampleShadingEnable;
        public float minSampleShading;
        public uint* pSampleMask;
        public VkBool32 alphaToCoverageEnable;
        public VkBool32 alphaToOneEnable;
        public VkPipelineMultisampleStateCreateInfo() { sType = VkStructureType.PIPELINE_MULTISAMPLE_STATE_CREATE_INFO; }
    }

    internal unsafe struct VkPipelineRasterizationStateCreateInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public uint flags;
        public VkBool32 depthClampEnable;
        public VkBool32 rasterizerDiscardEnable;
        public VkPolygonMode polygonMode;
        public VkCullModeFlags cullMode;
        public VkFrontFace frontFace;
        public VkBool32 depthBiasEnable;
        public float depthBiasConstantFactor;
        public float depthBiasClamp;
        public float depthBiasSlopeFactor;
        public float lineWidth;
        public VkPipelineRasterizationStateCreateInfo() { sType = VkStructureType.PIPELINE_RASTERIZATION_STATE_CREATE_INFO; }
    }

    internal unsafe struct VkPipelineRenderingCreateInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public uint viewMask;
        public uint colorAttachmentCount;
        public VkFormat* pColorAttachmentFormats;
        public VkFormat depthAttachmentFormat;
        public VkFormat stencilAttachmentFormat;
        public VkPipelineRenderingCreateInfo() { sType = VkStructureType.PIPELINE_RENDERING_CREATE_INFO; }
    }

    [Flags]
    internal enum VkPipelineShaderStageCreateFlags : uint
    {
        ALLOW_VARYING_SUBGROUP_SIZE = 0x1,
        REQUIRE_FULL_SUBGROUPS = 0x2,
    }

    internal unsafe struct VkPipelineShaderStageCreateInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public VkPipelineShaderStageCreateFlags flags;
        public VkShaderStageFlags stage;
        public VkShaderModule module;
        public byte* pName;
        public VkSpecializationInfo* pSpecializationInfo;
        public VkPipelineShaderStageCreateInfo() { sType = VkStructureType.PIPELINE_SHADER_STAGE_CREATE_INFO; }
    }

    [Flags]
    internal enum VkPipelineStageFlags2 : ulong
    {
        NONE = 0x0,
        TOP_OF_PIPE = 0x1,
        DRAW_INDIRECT = 0x2,
        VERTEX_INPUT = 0x4,
        VERTEX_SHADER = 0x8,
        TESSELLATION_CONTROL_SHADER = 0x10,
        TESSELLATION_EVALUATION_SHADER = 0x20,
        GEOMETRY_SHADER = 0x40,
        FRAGMENT_SHADER = 0x80,
        EARLY_FRAGMENT_TESTS = 0x100,
        LATE_FRAGMENT_TESTS = 0x200,
        COLOR_ATTACHMENT_OUTPUT = 0x400,
        COMPUTE_SHADER = 0x800,
        ALL_TRANSFER = 0x1000,
        BOTTOM_OF_PIPE = 0x2000,
        HOST = 0x4000,
        ALL_GRAPHICS = 0x8000,
        ALL_COMMANDS = 0x10000,
        COPY = 0x100000000,
        RESOLVE = 0x200000000,
        BLIT = 0x400000000,
        CLEAR = 0x800000000,
        INDEX_INPUT = 0x1000000000,
        VERTEX_ATTRIBUTE_INPUT = 0x2000000000,
        PRE_RASTERIZATION_SHADERS = 0x4000000000,
    }

    internal unsafe struct VkPipelineTessellationStateCreateInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public uint flags;
        public uint patchControlPoints;
        public VkPipelineTessellationStateCreateInfo() { sType = VkStructureType.PIPELINE_TESSELLATION_STATE_CREATE_INFO; }
    }

    internal unsafe struct VkPipelineVertexInputStateCreateInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public uint flags;
        public uint vertexBindingDescriptionCount;
        public VkVertexInputBindingDescription* pVertexBindingDescriptions;
        public uint vertexAttributeDescriptionCount;
        public VkVertexInputAttributeDescription* pVertexAttributeDescriptions;
        public VkPipelineVertexInputStateCreateInfo() { sType = VkStructureType.PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO; }
    }

    internal unsafe struct VkPipelineViewportStateCreateInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public uint flags;
        public uint viewportCount;
        public VkViewport* pViewports;
        public uint scissorCount;
        public VkRect2D* pScissors;
        public VkPipelineViewportStateCreateInfo() { sType = VkStructureType.PIPELINE_VIEWPORT_STATE_CREATE_INFO; }
    }

    internal enum VkPointClippingBehavior : int
    {
        ALL_CLIP_PLANES = 0,
        USER_CLIP_PLANES_ONLY = 1,
    }

    internal enum VkPolygonMode : int
    {
        FILL = 0,
        LINE = 1,
        POINT = 2,
    }

    internal enum VkPrimitiveTopology : int
    {
        POINT_LIST = 0,
        LINE_LIST = 1,
        LINE_STRIP = 2,
        TRIANGLE_LIST = 3,
        TRIANGLE_STRIP = 4,
        TRIANGLE_FAN = 5,
        LINE_LIST_WITH_ADJACENCY = 6,
        LINE_STRIP_WITH_ADJACENCY = 7,
        TRIANGLE_LIST_WITH_ADJACENCY = 8,
        TRIANGLE_STRIP_WITH_ADJACENCY = 9,
        PATCH_LIST = 10,
    }

    internal unsafe struct VkPushConstantRange
    {
        public VkShaderStageFlags stageFlags;
        public uint offset;
        public uint size;
    }

    [Flags]
    internal enum VkQueryControlFlags : uint
    {
        PRECISE = 0x1,
    }

    [Flags]
    internal enum VkQueryPipelineStatisticFlags : uint
    {
        INPUT_ASSEMBLY_VERTICES = 0x1,
        INPUT_ASSEMBLY_PRIMITIVES = 0x2,
        VERTEX_SHADER_INVOCATIONS = 0x4,
        GEOMETRY_SHADER_INVOCATIONS = 0x8,
        GEOMETRY_SHADER_PRIMITIVES = 0x10,
        CLIPPING_INVOCATIONS = 0x20,
        CLIPPING_PRIMITIVES = 0x40,
        FRAGMENT_SHADER_INVOCATIONS = 0x80,
        TESSELLATION_CONTROL_SHADER_PATCHES = 0x100,
        TESSELLATION_EVALUATION_SHADER_INVOCATIONS = 0x200,
        COMPUTE_SHADER_INVOCATIONS = 0x400,
    }

    internal enum VkQueryPool : ulong { Null }

    internal unsafe struct VkQueryPoolCreateInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public uint flags;
        public VkQueryType queryType;
        public uint queryCount;
        public VkQueryPipelineStatisticFlags pipelineStatistics;
        public VkQueryPoolCreateInfo() { sType = VkStructureType.QUERY_POOL_CREATE_INFO; }
    }

    [Flags]
    internal enum VkQueryResultFlags : uint
    {
        _64 = 0x1,
        WAIT = 0x2,
        WITH_AVAILABILITY = 0x4,
        PARTIAL = 0x8,
    }

    internal enum VkQueryType : int
    {
        OCCLUSION = 0,
        PIPELINE_STATISTICS = 1,
        TIMESTAMP = 2,
    }

    internal enum VkQueue : ulong { Null }

    internal unsafe struct VkQueueFamilyProperties
    {
        public VkQueueFlags queueFlags;
        public uint queueCount;
        public uint timestampValidBits;
        public VkExtent3D minImageTransferGranularity;
    }

    [Flags]
    internal enum VkQueueFlags : uint
    {
        GRAPHICS = 0x1,
        COMPUTE = 0x2,
        TRANSFER = 0x4,
        SPARSE_BINDING = 0x8,
        PROTECTED = 0x10,
    }

    internal unsafe struct VkRect2D
    {
        public VkOffset2D offset;
        public VkExtent2D extent;
    }

    internal enum VkRenderPass : ulong { Null }

    internal unsafe struct VkRenderingAttachmentInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public VkImageView imageView;
        public VkImageLayout imageLayout;
        public VkResolveModeFlags resolveMode;
        public VkImageView resolveImageView;
        public VkImageLayout resolveImageLayout;
        public VkAttachmentLoadOp loadOp;
        public VkAttachmentStoreOp storeOp;
        public VkClearValue clearValue;
        public VkRenderingAttachmentInfo() { sType = VkStructureType.RENDERING_ATTACHMENT_INFO; }
    }

    [Flags]
    internal enum VkRenderingFlags : uint
    {
        CONTENTS_SECONDARY_COMMAND_BUFFERS = 0x1,
        SUSPENDING = 0x2,
        RESUMING = 0x4,
    }

    internal unsafe struct VkRenderingInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public VkRenderingFlags flags;
        public VkRect2D renderArea;
        public uint layerCount;
        public uint viewMask;
        public uint colorAttachmentCount;
        public VkRenderingAttachmentInfo* pColorAttachments;
        public VkRenderingAttachmentInfo* pDepthAttachment;
        public VkRenderingAttachmentInfo* pStencilAttachment;
        public VkRenderingInfo() { sType = VkStructureType.RENDERING_INFO; }
    }

    [Flags]
    internal enum VkResolveModeFlags : uint
    {
        NONE = 0x0,
        SAMPLE_ZERO = 0x1,
        AVERAGE = 0x2,
        MIN = 0x4,
        MAX = 0x8,
    }

    internal enum VkResult : int
    {
        SUCCESS = 0,
        NOT_READY = 1,
        TIMEOUT = 2,
        EVENT_SET = 3,
        EVENT_RESET = 4,
        INCOMPLETE = 5,
        ERROR_OUT_OF_HOST_MEMORY = -1,
        ERROR_OUT_OF_DEVICE_MEMORY = -2,
        ERROR_INITIALIZATION_FAILED = -3,
        ERROR_DEVICE_LOST = -4,
        ERROR_MEMORY_MAP_FAILED = -5,
        ERROR_LAYER_NOT_PRESENT = -6,
        ERROR_EXTENSION_NOT_PRESENT = -7,
        ERROR_FEATURE_NOT_PRESENT = -8,
        ERROR_INCOMPATIBLE_DRIVER = -9,
        ERROR_TOO_MANY_OBJECTS = -10,
        ERROR_FORMAT_NOT_SUPPORTED = -11,
        ERROR_FRAGMENTED_POOL = -12,
        ERROR_UNKNOWN = -13,
        ERROR_OUT_OF_POOL_MEMORY = -1000069000,
        ERROR_INVALID_EXTERNAL_HANDLE = -1000072003,
        ERROR_FRAGMENTATION = -1000161000,
        ERROR_INVALID_OPAQUE_CAPTURE_ADDRESS = -1000257000,
        PIPELINE_COMPILE_REQUIRED = 1000297000,
    }

    [Flags]
    internal enum VkSampleCountFlags : uint
    {
        _1 = 0x1,
        _2 = 0x2,
        _4 = 0x4,
        _8 = 0x8,
        _16 = 0x10,
        _32 = 0x20,
        _64 = 0x40,
    }

    internal enum VkSampler : ulong { Null }

    internal enum VkSamplerAddressMode : int
    {
        REPEAT = 0,
        MIRRORED_REPEAT = 1,
        CLAMP_TO_EDGE = 2,
        CLAMP_TO_BORDER = 3,
        MIRROR_CLAMP_TO_EDGE = 4,
    }

    internal unsafe struct VkSamplerCreateInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public uint flags;
        public VkFilter magFilter;
        public VkFilter minFilter;
        public VkSamplerMipmapMode mipmapMode;
        public VkSamplerAddressMode addressModeU;
        public VkSamplerAddressMode addressModeV;
        public VkSamplerAddressMode addressModeW;
        public float mipLodBias;
        public VkBool32 anisotropyEnable;
        public float maxAnisotropy;
        public VkBool32 compareEnable;
        public VkCompareOp compareOp;
        public float minLod;
        public float maxLod;
        public VkBorderColor borderColor;
        public VkBool32 unnormalizedCoordinates;
        public VkSamplerCreateInfo() { sType = VkStructureType.SAMPLER_CREATE_INFO; }
    }

    internal enum VkSamplerMipmapMode : int
    {
        NEAREST = 0,
        LINEAR = 1,
    }

    internal enum VkSemaphore : ulong { Null }

    internal unsafe struct VkSemaphoreCreateInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public uint flags;
        public VkSemaphoreCreateInfo() { sType = VkStructureType.SEMAPHORE_CREATE_INFO; }
    }

    internal unsafe struct VkSemaphoreSubmitInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public VkSemaphore semaphore;
        public ulong value;
        public VkPipelineStageFlags2 stageMask;
        public uint deviceIndex;
        public VkSemaphoreSubmitInfo() { sType = VkStructureType.SEMAPHORE_SUBMIT_INFO; }
    }

    internal enum VkSemaphoreType : int
    {
        BINARY = 0,
        TIMELINE = 1,
    }

    internal unsafe struct VkSemaphoreTypeCreateInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public VkSemaphoreType semaphoreType;
        public ulong initialValue;
        public VkSemaphoreTypeCreateInfo() { sType = VkStructureType.SEMAPHORE_TYPE_CREATE_INFO; }
    }

    [Flags]
    internal enum VkSemaphoreWaitFlags : uint
    {
        ANY = 0x1,
    }

    internal unsafe struct VkSemaphoreWaitInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public VkSemaphoreWaitFlags flags;
        public uint semaphoreCount;
        public VkSemaphore* pSemaphores;
        public ulong* pValues;
        public VkSemaphoreWaitInfo() { sType = VkStructureType.SEMAPHORE_WAIT_INFO; }
    }

    internal enum VkShaderFloatControlsIndependence : int
    {
        _32_ONLY = 0,
        ALL = 1,
        NONE = 2,
    }

    internal enum VkShaderModule : ulong { Null }

    internal unsafe struct VkShaderModuleCreateInfo
    {
        public VkStructureType sType;
        public void* pNext;
        public uint flags;
        public nuint codeSize;
        public uint* pCode;
        public VkShaderModuleCreateInfo() { sType = VkStructureType.SHADER_MODULE_CREATE_INFO; }
    }

    [Flags]
    internal enum VkShaderStageFlags : uint
    {
        VERTEX = 0x1,
        TESSELLATION_CONTROL = 0x2,
        TESSELLATION_EVALUATION = 0x4,
        GEOMETRY = 0x8,
        FRAGMENT = 0x10,
        COMPUTE = 0x20,
        ALL_GRAPHICS = 0x1f,
        ALL = 0x7fffffff,
    }

    internal enum VkSharingMode : int
    {
        EXCLUSIVE = 0,
        CONCURRENT = 1,
    }

    internal unsafe struct VkSpecializationInfo
    {
        public uint mapEntryCount;
        public VkSpecializationMapEntry* pMapEntries;
        public nuint dataSize;
        public void* pData;
    }

    internal unsafe struct VkSpecializationMapEntry
    {
        public uint constantID;
        public uint offset;
        public nuint size;
    }

    internal enum VkStencilOp : int
    {
        KEEP = 0,
        ZERO = 1,
        REPLACE = 2,
        INCREMENT_AND_CLAMP = 3,
        DECREMENT_AND_CLAMP = 4,
        INVERT = 5,
        INCREMENT_AND_WRAP = 6,
        DECREMENT_AND_WRAP = 7,
    }

    internal unsafe struct VkStencilOpState
    {
        public VkStencilOp failOp;
        public VkStencilOp passOp;
        public VkStencilOp depthFailOp;
        public VkCompareOp compareOp;
        public uint compareMask;
        public uint writeMask;
        public uint reference;
    }

    internal enum VkStructureType : int
    {
        APPLICATION_INFO = 0,
        INSTANCE_CREATE_INFO = 1,
        DEVICE_QUEUE_CREATE_INFO = 2,
        DEVICE_CREATE_INFO = 3,
        MEMORY_ALLOCATE_INFO = 5,
        SEMAPHORE_CREATE_INFO = 9,
        QUERY_POOL_CREATE_INFO = 11,
        BUFFER_CREATE_INFO = 12,
        BUFFER_VIEW_CREATE_INFO = 13,
        IMAGE_CREATE_INFO = 14,
        IMAGE_VIEW_CREATE_INFO = 15,
        SHADER_MODULE_CREATE_INFO = 16,
        PIPELINE_CACHE_CREATE_INFO = 17,
        PIPELINE_SHADER_STAGE_CREATE_INFO = 18,
        PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO = 19,
        PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO = 20,
        PIPELINE_TESSELLATION_STATE_CREATE_INFO = 21,
        PIPELINE_VIEWPORT_STATE_CREATE_INFO = 22,
        PIPELINE_RASTERIZATION_STATE_CREATE_INFO = 23,
        PIPELINE_MULTISAMPLE_STATE_CREATE_INFO = 24,
        PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO = 25,
        PIPELINE_COLOR_BLEND_STATE_CREATE_INFO = 26,
        PIPELINE_DYNAMIC_STATE_CREATE_INFO = 27,
        GRAPHICS_PIPELINE_CREATE_INFO = 28,
        COMPUTE_PIPELINE_CREATE_INFO = 29,
        PIPELINE_LAYOUT_CREATE_INFO = 30,
        SAMPLER_CREATE_INFO = 31,
        DESCRIPTOR_SET_LAYOUT_CREATE_INFO = 32,
        WRITE_DESCRIPTOR_SET = 35,
        COMMAND_POOL_CREATE_INFO = 39,
        COMMAND_BUFFER_ALLOCATE_INFO = 40,
        COMMAND_BUFFER_INHERITANCE_INFO = 41,
        COMMAND_BUFFER_BEGIN_INFO = 42,
        PHYSICAL_DEVICE_FEATURES_2 = 1000059000,
        PHYSICAL_DEVICE_PROPERTIES_2 = 1000059001,
        PHYSICAL_DEVICE_VULKAN_1_1_FEATURES = 49,
        PHYSICAL_DEVICE_VULKAN_1_1_PROPERTIES = 50,
        PHYSICAL_DEVICE_VULKAN_1_2_FEATURES = 51,
        PHYSICAL_DEVICE_VULKAN_1_2_PROPERTIES = 52,
        SEMAPHORE_TYPE_CREATE_INFO = 1000207002,
        SEMAPHORE_WAIT_INFO = 1000207004,
        PHYSICAL_DEVICE_VULKAN_1_3_FEATURES = 53,
        PHYSICAL_DEVICE_VULKAN_1_3_PROPERTIES = 54,
        MEMORY_BARRIER_2 = 1000314000,
        BUFFER_MEMORY_BARRIER_2 = 1000314001,
        IMAGE_MEMORY_BARRIER_2 = 1000314002,
        DEPENDENCY_INFO = 1000314003,
        SUBMIT_INFO_2 = 1000314004,
        SEMAPHORE_SUBMIT_INFO = 1000314005,
        COMMAND_BUFFER_SUBMIT_INFO = 1000314006,
        RENDERING_INFO = 1000044000,
        RENDERING_ATTACHMENT_INFO = 1000044001,
        PIPELINE_RENDERING_CREATE_INFO = 1000044002,
        PHYSICAL_DEVICE_PUSH_DESCRIPTOR_PROPERTIES_KHR = 1000080000,
        DEBUG_UTILS_OBJECT_NAME_INFO_EXT = 1000128000,
        DEBUG_UTILS_LABEL_EXT = 1000128002,
        DEBUG_UTILS_MESSENGER_CALLBACK_DATA_EXT = 1000128003,
        DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT = 1000128004,
        PHYSICAL_DEVICE_ROBUSTNESS_2_FEATURES_EXT = 1000286000,
        PHYSICAL_DEVICE_ROBUSTNESS_2_PROPERTIES_EXT = 1000286001,
    }

    [Flags]
    internal enum VkSubgroupFeatureFlags : uint
    {
        BASIC = 0x1,
        VOTE = 0x2,
        ARITHMETIC = 0x4,
        BALLOT = 0x8,
        SHUFFLE = 0x10,
        SHUFFLE_RELATIVE = 0x20,
        CLUSTERED = 0x40,
        QUAD = 0x80,
    }

    [Flags]
    internal enum VkSubmitFlags : uint
    {
        PROTECTED = 0x1,
    }

    internal unsafe struct VkSubmitInfo2
    {
        public VkStructureType sType;
        public void* pNext;
        public VkSubmitFlags flags;
        public uint waitSemaphoreInfoCount;
        public VkSemaphoreSubmitInfo* pWaitSemaphoreInfos;
        public uint commandBufferInfoCount;
        public VkCommandBufferSubmitInfo* pCommandBufferInfos;
        public uint signalSemaphoreInfoCount;
        public VkSemaphoreSubmitInfo* pSignalSemaphoreInfos;
        public VkSubmitInfo2() { sType = VkStructureType.SUBMIT_INFO_2; }
    }

    internal unsafe struct VkVertexInputAttributeDescription
    {
        public uint location;
        public uint binding;
        public VkFormat format;
        public uint offset;
    }

    internal unsafe struct VkVertexInputBindingDescription
    {
        public uint binding;
        public uint stride;
        public VkVertexInputRate inputRate;
    }

    internal enum VkVertexInputRate : int
    {
        VERTEX = 0,
        INSTANCE = 1,
    }

    internal unsafe struct VkViewport
    {
        public float x;
        public float y;
        public float width;
        public float height;
        public float minDepth;
        public float maxDepth;
    }

    internal unsafe struct VkWriteDescriptorSet
    {
        public VkStructureType sType;
        public void* pNext;
        public VkDescriptorSet dstSet;
        public uint dstBinding;
        public uint dstArrayElement;
        public uint descriptorCount;
        public VkDescriptorType descriptorType;
        public VkDescriptorImageInfo* pImageInfo;
        public VkDescriptorBufferInfo* pBufferInfo;
        public VkBufferView* pTexelBufferView;
        public VkWriteDescriptorSet() { sType = VkStructureType.WRITE_DESCRIPTOR_SET; }
    }

    [InlineArray(16)] internal unsafe struct VkMemoryHeapArray16 { VkMemoryHeap first; }
    [InlineArray(32)] internal unsafe struct VkMemoryTypeArray32 { VkMemoryType first; }
}
