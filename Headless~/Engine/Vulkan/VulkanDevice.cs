using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Runtime.InteropServices;
using UnityEngine.Headless;
using static Host.Vulkan.VulkanException;

namespace Host.Vulkan
{
    /// <summary><see cref="IGraphicsDevice"/> over Vulkan 1.3: one device, one queue, one stream.</summary>
    /// <remarks>
    /// Environment: RILL_DEVICE picks the device whose name contains it; RILL_VALIDATION=1 turns the validation layer on;
    /// RILL_CACHE names a folder for the driver's pipeline cache.
    /// </remarks>
    internal sealed unsafe partial class VulkanDevice : IGraphicsDevice
    {
        readonly VulkanInstance instance;
        readonly VkPhysicalDevice physical;
        readonly VkDevice device;
        readonly VkQueue queue;
        readonly uint queueFamily;
        readonly VkDeviceCommands vk;
        readonly GpuMemory memory;
        readonly VkPhysicalDeviceLimits limits;
        readonly ulong maxBufferBytes;
        readonly int maxPushDescriptors;
        readonly float timestampPeriod;
        readonly ulong timestampMask;
        readonly bool hasMirrorOnce, hasAnisotropy;
        readonly VkPipelineCache pipelineCache;
        readonly string pipelineCacheFile;
        readonly HashSet<IRetirable> live = new();
        bool disposed;

        public DeviceInfo Info { get; }

        /// <summary>Messages of the validation layer, from warnings up. Empty while the layer is off.</summary>
        public IReadOnlyList<string> ValidationMessages => instance.Messages;

        /// <summary>Resources whose GPU objects exist: those not yet disposed and those that the stream still needs.</summary>
        public int LiveResources => live.Count - ownBuffers;

        /// <param name="validation">Also on when RILL_VALIDATION=1.</param>
        /// <param name="deviceName">Part of the wanted device's name; null: RILL_DEVICE, or else the best there is.</param>
        public VulkanDevice(bool validation = false, string deviceName = null)
        {
            instance = new VulkanInstance(validation || Environment.GetEnvironmentVariable("RILL_VALIDATION") == "1");
            var vki = instance.Commands;
            physical = Pick(deviceName ?? Environment.GetEnvironmentVariable("RILL_DEVICE"));

            var push = new VkPhysicalDevicePushDescriptorPropertiesKHR();
            var in13 = new VkPhysicalDeviceVulkan13Properties { pNext = &push };
            var in12 = new VkPhysicalDeviceVulkan12Properties { pNext = &in13 };
            var in11 = new VkPhysicalDeviceVulkan11Properties { pNext = &in12 };
            var properties = new VkPhysicalDeviceProperties2 { pNext = &in11 };
            vki.GetPhysicalDeviceProperties2(physical, &properties);
            limits = properties.properties.limits;
            maxBufferBytes = in13.maxBufferSize;
            maxPushDescriptors = (int)push.maxPushDescriptors;
            timestampPeriod = limits.timestampPeriod;

            (queueFamily, timestampMask) = PickQueueFamily();
            device = CreateDevice(out hasMirrorOnce, out hasAnisotropy);
            vk = new VkDeviceCommands(LoadDeviceCommand);
            VkQueue q;
            vk.GetDeviceQueue(device, queueFamily, 0, &q);
            queue = q;

            VkPhysicalDeviceMemoryProperties memoryProperties;
            vki.GetPhysicalDeviceMemoryProperties(physical, &memoryProperties);
            memory = new GpuMemory(vk, device, memoryProperties);

            Info = new DeviceInfo
            {
                Name = Utf8(properties.properties.deviceName),
                Vendor = VendorName(properties.properties.vendorID),
                Driver = $"{Utf8(in12.driverName)} {Utf8(in12.driverInfo)}".Trim(),
                Api = "Vulkan " + Version(properties.properties.apiVersion),
                IsSoftware = properties.properties.deviceType == VkPhysicalDeviceType.CPU,
                MaxBufferBytes = (long)Math.Min(limits.maxStorageBufferRange, maxBufferBytes),
                MaxGroupsharedBytes = (int)limits.maxComputeSharedMemorySize,
                MaxGroupInvocations = (int)limits.maxComputeWorkGroupInvocations,
                MaxGroupSizeX = (int)limits.maxComputeWorkGroupSize[0],
                MaxGroupSizeY = (int)limits.maxComputeWorkGroupSize[1],
                MaxGroupSizeZ = (int)limits.maxComputeWorkGroupSize[2],
                MaxTexture2D = (int)limits.maxImageDimension2D,
                MaxTexture3D = (int)limits.maxImageDimension3D,
                MemoryBytes = memory.DeviceLocalBytes,
                SubgroupSize = (int)in11.subgroupSize,
            };

            pipelineCacheFile = PipelineCacheFile(properties.properties);
            pipelineCache = LoadPipelineCache();
            CreateStream();
            constants = new HostMemoryRing(this, MemoryUse.Constants, 1 << 20);
            uploads = new HostMemoryRing(this, MemoryUse.Upload, PieceBytes);
            CreateScratch();
        }

        // ---- choosing

        VkPhysicalDevice Pick(string wanted)
        {
            var vki = instance.Commands;
            uint count;
            Check(vki.EnumeratePhysicalDevices(instance.Handle, &count, null), "vkEnumeratePhysicalDevices");
            var handles = new VkPhysicalDevice[count];
            fixed (VkPhysicalDevice* p = handles) Check(vki.EnumeratePhysicalDevices(instance.Handle, &count, p), "vkEnumeratePhysicalDevices");

            VkPhysicalDevice best = default;
            int bestRank = -1;
            var seen = new List<string>();
            foreach (var handle in handles)
            {
                var properties = new VkPhysicalDeviceProperties2();
                vki.GetPhysicalDeviceProperties2(handle, &properties);
                string name = Utf8(properties.properties.deviceName);
                uint version = properties.properties.apiVersion;
                seen.Add($"{name} (Vulkan {Version(version)})");
                if (version < VulkanInstance.Api) continue;
                if (!string.IsNullOrEmpty(wanted) && !name.Contains(wanted, StringComparison.OrdinalIgnoreCase)) continue;
                int rank = properties.properties.deviceType switch
                {
                    VkPhysicalDeviceType.DISCRETE_GPU => 4,
                    VkPhysicalDeviceType.INTEGRATED_GPU => 3,
                    VkPhysicalDeviceType.VIRTUAL_GPU => 2,
                    VkPhysicalDeviceType.CPU => 1,
                    _ => 0,
                };
                if (rank > bestRank) (best, bestRank) = (handle, rank);
            }
            if (bestRank >= 0) return best;
            throw new InvalidOperationException(string.IsNullOrEmpty(wanted)
                ? $"No device with Vulkan 1.3 was found; there are: {(seen.Count == 0 ? "none" : string.Join(", ", seen))}. Install a " +
                    $"driver (Debian: mesa-vulkan-drivers)."
                : $"No device with Vulkan 1.3 has \"{wanted}\" in its name; there are: {(seen.Count == 0 ? "none" : string.Join(", ", seen))}.");
        }

        (uint Family, ulong TimestampMask) PickQueueFamily()
        {
            uint count;
            instance.Commands.GetPhysicalDeviceQueueFamilyProperties(physical, &count, null);
            var families = new VkQueueFamilyProperties[count];
            fixed (VkQueueFamilyProperties* p = families) instance.Commands.GetPhysicalDeviceQueueFamilyProperties(physical, &count, p);
            const VkQueueFlags need = VkQueueFlags.COMPUTE | VkQueueFlags.GRAPHICS;
            for (uint i = 0; i < count; i++)
            {
                if ((families[i].queueFlags & need) != need) continue;
                uint bits = families[i].timestampValidBits;
                return (i, bits >= 64 ? ulong.MaxValue : (1UL << (int)bits) - 1);
            }
            throw new InvalidOperationException("The device has no queue that both computes and draws.");
        }

        VkDevice CreateDevice(out bool mirrorOnce, out bool anisotropy)
        {
            var vki = instance.Commands;
            RequireExtensions("VK_KHR_push_descriptor", "VK_EXT_robustness2");

            var hasRobust = new VkPhysicalDeviceRobustness2FeaturesEXT();
            var has13 = new VkPhysicalDeviceVulkan13Features { pNext = &hasRobust };
            var has12 = new VkPhysicalDeviceVulkan12Features { pNext = &has13 };
            var has11 = new VkPhysicalDeviceVulkan11Features { pNext = &has12 };
            var has = new VkPhysicalDeviceFeatures2 { pNext = &has11 };
            vki.GetPhysicalDeviceFeatures2(physical, &has);
            ref var core = ref has.features;

            // Direct3D's rules for what lies outside a resource stand or fall with these; the rest is Vulkan 1.3's own minimum.
            Require(hasRobust.robustBufferAccess2, "robustBufferAccess2");
            Require(hasRobust.nullDescriptor, "nullDescriptor");
            Require(has12.scalarBlockLayout, "scalarBlockLayout");
            Require(has12.timelineSemaphore, "timelineSemaphore");
            Require(has12.hostQueryReset, "hostQueryReset");
            Require(has13.dynamicRendering, "dynamicRendering");
            Require(has13.synchronization2, "synchronization2");
            Require(has13.maintenance4, "maintenance4");

            var robust = new VkPhysicalDeviceRobustness2FeaturesEXT
            {
                robustBufferAccess2 = VkBool32.True, robustImageAccess2 = hasRobust.robustImageAccess2, nullDescriptor = VkBool32.True,
            };
            var use13 = new VkPhysicalDeviceVulkan13Features
            {
                pNext = &robust, dynamicRendering = VkBool32.True, synchronization2 = VkBool32.True, maintenance4 = VkBool32.True,
                shaderDemoteToHelperInvocation = has13.shaderDemoteToHelperInvocation, robustImageAccess = has13.robustImageAccess,
            };
            var use12 = new VkPhysicalDeviceVulkan12Features
            {
                pNext = &use13, scalarBlockLayout = VkBool32.True, uniformBufferStandardLayout = has12.uniformBufferStandardLayout,
                timelineSemaphore = VkBool32.True, hostQueryReset = VkBool32.True, samplerMirrorClampToEdge = has12.samplerMirrorClampToEdge,
                shaderFloat16 = has12.shaderFloat16, shaderOutputLayer = has12.shaderOutputLayer,
                    shaderOutputViewportIndex = has12.shaderOutputViewportIndex,
            };
            var use11 = new VkPhysicalDeviceVulkan11Features
            {
                pNext = &use12, shaderDrawParameters = has11.shaderDrawParameters, storageBuffer16BitAccess = has11.storageBuffer16BitAccess,
            };
            var use = new VkPhysicalDeviceFeatures2 { pNext = &use11 };
            use.features = new VkPhysicalDeviceFeatures
            {
                robustBufferAccess = core.robustBufferAccess,
                imageCubeArray = core.imageCubeArray,
                geometryShader = core.geometryShader,       // a fragment program that declares SV_RenderTargetArrayIndex asks for it
                independentBlend = core.independentBlend,
                depthBiasClamp = core.depthBiasClamp,
                fillModeNonSolid = core.fillModeNonSolid,
                samplerAnisotropy = core.samplerAnisotropy,
                fullDrawIndexUint32 = core.fullDrawIndexUint32,
                drawIndirectFirstInstance = core.drawIndirectFirstInstance,
                vertexPipelineStoresAndAtomics = core.vertexPipelineStoresAndAtomics,
                fragmentStoresAndAtomics = core.fragmentStoresAndAtomics,
                shaderImageGatherExtended = core.shaderImageGatherExtended,
                shaderStorageImageExtendedFormats = core.shaderStorageImageExtendedFormats,
                shaderStorageImageReadWithoutFormat = core.shaderStorageImageReadWithoutFormat,
                shaderStorageImageWriteWithoutFormat = core.shaderStorageImageWriteWithoutFormat,
                shaderClipDistance = core.shaderClipDistance,
                shaderCullDistance = core.shaderCullDistance,
                shaderFloat64 = core.shaderFloat64,
                shaderInt64 = core.shaderInt64,
                shaderInt16 = core.shaderInt16,
            };
            mirrorOnce = use12.samplerMirrorClampToEdge == VkBool32.True;
            anisotropy = core.samplerAnisotropy == VkBool32.True;

            float priority = 1;
            var queueInfo = new VkDeviceQueueCreateInfo { queueFamilyIndex = queueFamily, queueCount = 1, pQueuePriorities = &priority };
            // SV_RenderTargetArrayIndex of vertex programs; without it those do not draw.
            const string layers = "VK_EXT_shader_viewport_index_layer";
            fixed (byte* pushDescriptor = "VK_KHR_push_descriptor"u8, robustness = "VK_EXT_robustness2"u8,
                viewportIndexLayer = "VK_EXT_shader_viewport_index_layer"u8)
            {
                var names = stackalloc byte*[] { pushDescriptor, robustness, viewportIndexLayer };
                var info = new VkDeviceCreateInfo
                {
                    pNext = &use, queueCreateInfoCount = 1, pQueueCreateInfos = &queueInfo, enabledExtensionCount = HasExtension(layers)
                        ? 3u : 2u, ppEnabledExtensionNames = names,
                };
                VkDevice made;
                Check(vki.CreateDevice(physical, &info, null, &made), "vkCreateDevice");
                return made;
            }
        }

        void RequireExtensions(params string[] names)
        {
            foreach (string name in names)
                Require(HasExtension(name) ? VkBool32.True : VkBool32.False, name);
        }

        bool HasExtension(string name)
        {
            uint count;
            Check(instance.Commands.EnumerateDeviceExtensionProperties(physical, null, &count, null), "vkEnumerateDeviceExtensionProperties");
            var extensions = new VkExtensionProperties[count];
            fixed (VkExtensionProperties* p = extensions)
                Check(instance.Commands.EnumerateDeviceExtensionProperties(physical, null, &count, p),
                "vkEnumerateDeviceExtensionProperties");
            return Array.Exists(extensions, e => Utf8(e.extensionName) == name);
        }

        static void Require(VkBool32 present, string feature)
        {
            if (present != VkBool32.True)
                throw new NotSupportedException(
                $"The Vulkan device lacks {feature}, which Direct3D's rules need. Choose another with RILL_DEVICE.");
        }

        void* LoadDeviceCommand(ReadOnlySpan<byte> name)
        {
            fixed (byte* n = name)
            {
                var address = (void*)instance.Commands.GetDeviceProcAddr(device, n);
                // Debug names come from the instance's extension, on only with the layer.
                return address != null || name.SequenceEqual("vkSetDebugUtilsObjectNameEXT"u8) ? address
                    : throw new EntryPointNotFoundException($"The Vulkan driver has no {System.Text.Encoding.UTF8.GetString(name)}.");
            }
        }

        // ---- pipeline cache on disk

        static string PipelineCacheFile(in VkPhysicalDeviceProperties properties)
        {
            string folder = Environment.GetEnvironmentVariable("RILL_CACHE");
            if (string.IsNullOrEmpty(folder)) return null;
            var uuid = new byte[16];
            for (int i = 0; i < 16; i++) uuid[i] = properties.pipelineCacheUUID[i];
            return Path.Combine(folder, $"pipelines-{Convert.ToHexStringLower(uuid)}.bin");
        }

        VkPipelineCache LoadPipelineCache()
        {
            byte[] data = pipelineCacheFile != null && File.Exists(pipelineCacheFile) ? File.ReadAllBytes(pipelineCacheFile) : Array.Empty<byte>();
            fixed (byte* p = data)
            {
                var info = new VkPipelineCacheCreateInfo { initialDataSize = (nuint)data.Length, pInitialData = p };
                VkPipelineCache cache;
                Check(vk.CreatePipelineCache(device, &info, null, &cache), "vkCreatePipelineCache");
                return cache;
            }
        }

        void SavePipelineCache()
        {
            if (pipelineCacheFile == null) return;
            nuint size;
            Check(vk.GetPipelineCacheData(device, pipelineCache, &size, null), "vkGetPipelineCacheData");
            var data = new byte[size];
            fixed (byte* p = data) Check(vk.GetPipelineCacheData(device, pipelineCache, &size, p), "vkGetPipelineCacheData");
            Directory.CreateDirectory(Path.GetDirectoryName(pipelineCacheFile));
            // Written aside and moved, since several processes may use the folder.
            string aside = $"{pipelineCacheFile}.{Environment.ProcessId}";
            File.WriteAllBytes(aside, data);
            File.Move(aside, pipelineCacheFile, overwrite: true);
        }

        // ---- the rest

        internal void SetName(VkObjectType type, ulong handle, string name)
        {
            if (!instance.HasValidation || string.IsNullOrEmpty(name)) return;
            fixed (byte* text = System.Text.Encoding.UTF8.GetBytes(name + "\0"))
            {
                var info = new VkDebugUtilsObjectNameInfoEXT { objectType = type, objectHandle = handle, pObjectName = text };
                Check(vk.SetDebugUtilsObjectNameEXT(device, &info), "vkSetDebugUtilsObjectNameEXT");
            }
        }

        static string Utf8(byte* text) => Marshal.PtrToStringUTF8((nint)text);
        static string Version(uint v) => $"{v >> 22 & 0x7f}.{v >> 12 & 0x3ff}.{v & 0xfff}";

        static string VendorName(uint id) => id switch
        {
            0x10DE => "NVIDIA", 0x1002 => "AMD", 0x8086 => "Intel", 0x13B5 => "ARM", 0x106B => "Apple", 0x5143 => "Qualcomm", 0x10005 => "Mesa",
            _ => $"0x{id:X}",
        };

        public void Dispose()
        {
            if (disposed) return;
            WaitIdle();
            disposed = true;
            SavePipelineCache();
            foreach (var resource in live.ToArray()) Destroy(resource);
            DestroyTiming();
            DestroyMarks();
            DestroySamplers();
            DestroyScratch();
            DestroyStream();
            memory.Dispose();
            vk.DestroyPipelineCache(device, pipelineCache, null);
            vk.DestroyDevice(device, null);
            instance.Dispose();
        }
    }
}
