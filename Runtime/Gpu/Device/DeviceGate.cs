using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Says what a device lacks of what every fluid needs.</summary>
    static class DeviceGate
    {
        /// <summary>Remedy in messages about a device that is too small.</summary>
        public const string Remedy = "Run on Direct3D 11 or 12, Vulkan or Metal";

        /// <summary>Whether the player has no graphics at all: a dedicated server, or -nographics.</summary>
        public static bool HasNoGraphics => SystemInfo.graphicsDeviceType == GraphicsDeviceType.Null;

        /// <summary>Returns what every fluid needs and this device lacks; null if nothing is missing.</summary>
        public static string MissingAbility()
        {
            if (HasNoGraphics)
                return "this player has no graphics device, on which the fluid is computed.";
            return MissingAbility(SystemInfo.supportsComputeShaders, SystemInfo.supportsIndirectArgumentsBuffer,
                SystemInfo.supportsSetConstantBuffer, SystemInfo.supportsAsyncGPUReadback);
        }

        /// <summary>Returns what is missing on a device for which SystemInfo gives these answers; null for nothing.</summary>
        internal static string MissingAbility(bool computeShaders, bool indirectArguments, bool constantBuffers, bool asyncReadback)
        {
            string missing = !computeShaders ? "no compute shaders (SystemInfo.supportsComputeShaders), which the fluid is computed with"
                : !indirectArguments
                ? "no indirect arguments (SystemInfo.supportsIndirectArgumentsBuffer): how many particles there are is known on the GPU alone"
                : !constantBuffers
                ? "no constant buffers of one's own (SystemInfo.supportsSetConstantBuffer), in which the kernels get their settings"
                : !asyncReadback
                ? "no asynchronous readback (SystemInfo.supportsAsyncGPUReadback), by which statistics and emitters learn what the fluid did"
                : null;
            return missing == null ? null : Invariant($"this device ({SystemInfo.graphicsDeviceType}) has {missing}. {Remedy}.");
        }

        /// <summary>Why a draw shader cannot run; null where it can, and without compute shaders, which the fluid itself says.</summary>
        public static string ProblemOfDraw(string file, in DeviceLimits limits)
        {
            if (!SystemInfo.supportsComputeShaders)
                return null;
            foreach (KernelNeed need in KernelNeeds.OfDraws)
                if (need.File == file && limits.WhyNot(need) is string why)
                    return $"{why}. {Remedy}.";
            return null;
        }
    }
}
