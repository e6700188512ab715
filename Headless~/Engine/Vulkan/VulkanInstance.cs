using System;
using System.Collections.Generic;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using static Host.Vulkan.VulkanException;

namespace Host.Vulkan
{
    /// <summary>The loader (libvulkan.so.1), an instance of Vulkan 1.3 and, where asked for, the validation layer's ear.</summary>
    internal sealed unsafe class VulkanInstance : IDisposable
    {
        public const uint Api = 1u << 22 | 3u << 12;
        const string Layer = "VK_LAYER_KHRONOS_validation";

        public readonly VkInstance Handle;
        public readonly VkInstanceCommands Commands;
        public readonly bool HasValidation;
        public readonly List<string> Messages = new();

        readonly delegate* unmanaged<VkInstance, byte*, void*> getProcAddr;
        readonly VkDebugUtilsMessengerEXT messenger;
        GCHandle self;

        public VulkanInstance(bool validation)
        {
            if (!NativeLibrary.TryLoad("libvulkan.so.1", out nint library))
                throw new DllNotFoundException(
                    "libvulkan.so.1 was not found. Install Vulkan's loader (Debian: libvulkan1 and a driver such as mesa-vulkan-drivers).");
            getProcAddr = (delegate* unmanaged<VkInstance, byte*, void*>)NativeLibrary.GetExport(library, "vkGetInstanceProcAddr");
            var global = new VkGlobalCommands(Load);
            if (validation && !HasLayer(global))
                throw new InvalidOperationException($"{Layer} was asked for and is not installed (Debian: vulkan-validationlayers).");
            HasValidation = validation;
            self = GCHandle.Alloc(this);

            var ear = new VkDebugUtilsMessengerCreateInfoEXT
            {
                messageSeverity = VkDebugUtilsMessageSeverityFlagsEXT.WARNING | VkDebugUtilsMessageSeverityFlagsEXT.ERROR,
                messageType = VkDebugUtilsMessageTypeFlagsEXT.GENERAL | VkDebugUtilsMessageTypeFlagsEXT.VALIDATION,
                pfnUserCallback = (nint)(delegate* unmanaged<uint, uint, VkDebugUtilsMessengerCallbackDataEXT*, void*, VkBool32>)&Hear,
                pUserData = (void*)GCHandle.ToIntPtr(self),
            };
            fixed (byte* layer = "VK_LAYER_KHRONOS_validation"u8, debugUtils = "VK_EXT_debug_utils"u8)
            {
                var application = new VkApplicationInfo { apiVersion = Api };
                var info = new VkInstanceCreateInfo { pApplicationInfo = &application };
                if (validation)
                {
                    info.pNext = &ear;
                    info.enabledLayerCount = 1;
                    info.ppEnabledLayerNames = &layer;
                    info.enabledExtensionCount = 1;
                    info.ppEnabledExtensionNames = &debugUtils;
                }
                VkInstance handle;
                Check(global.CreateInstance(&info, null, &handle), "vkCreateInstance");
                Handle = handle;
            }
            Commands = new VkInstanceCommands(Load);
            if (validation)
            {
                VkDebugUtilsMessengerEXT made;
                Check(Commands.CreateDebugUtilsMessengerEXT(Handle, &ear, null, &made), "vkCreateDebugUtilsMessengerEXT");
                messenger = made;
            }
        }

        void* Load(ReadOnlySpan<byte> name)
        {
            fixed (byte* n = name)
            {
                var address = getProcAddr(Handle, n);
                return address != null || !HasValidation && name.IndexOf("DebugUtils"u8) >= 0 ? address
                    : throw new EntryPointNotFoundException($"libvulkan.so.1 has no {System.Text.Encoding.UTF8.GetString(name)}.");
            }
        }

        static bool HasLayer(VkGlobalCommands global)
        {
            uint count;
            Check(global.EnumerateInstanceLayerProperties(&count, null), "vkEnumerateInstanceLayerProperties");
            var layers = new VkLayerProperties[count];
            fixed (VkLayerProperties* p = layers) Check(global.EnumerateInstanceLayerProperties(&count, p), "vkEnumerateInstanceLayerProperties");
            return Array.Exists(layers, l => Marshal.PtrToStringUTF8((nint)l.layerName) == Layer);
        }

        [UnmanagedCallersOnly]
        static VkBool32 Hear(uint severity, uint types, VkDebugUtilsMessengerCallbackDataEXT* data, void* user)
        {
            var instance = (VulkanInstance)GCHandle.FromIntPtr((nint)user).Target;
            lock (instance.Messages) instance.Messages.Add(Marshal.PtrToStringUTF8((nint)data->pMessage));
            return VkBool32.False;
        }

        public void Dispose()
        {
            if (messenger != VkDebugUtilsMessengerEXT.Null) Commands.DestroyDebugUtilsMessengerEXT(Handle, messenger, null);
            Commands.DestroyInstance(Handle, null);
            self.Free();
        }
    }
}
