using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Compares what a scene needs with what the device grants, by name, and says which features are left out.</summary>
    sealed class DeviceGate
    {
        const string Remedy = "Run on Direct3D 11 or 12, Vulkan or Metal";

        readonly DeviceLimits limits;
        readonly Func<string, ComputeShader> load;
        readonly List<(DeviceFeature feature, string problem)> refusals = new List<(DeviceFeature, string)>();
        DeviceFeature decided = (DeviceFeature)(-1);

        /// <param name="load">Kernels of a stage, by its name, asked for those of the features wanted: one that is null is judged by the
        /// table alone, as all are without this.</param>
        public DeviceGate(in DeviceLimits limits, Func<string, ComputeShader> load)
        {
            this.limits = limits;
            this.load = load;
        }

        /// <summary>Whether the player has no graphics at all: a dedicated server, or -nographics.</summary>
        public static bool HasNoGraphics => SystemInfo.graphicsDeviceType == GraphicsDeviceType.Null;

        /// <summary>Of the features last asked for, those that the device is too small for.</summary>
        public DeviceFeature Refused { get; private set; }

        /// <summary>The same one by one, and why.</summary>
        public IReadOnlyList<(DeviceFeature feature, string problem)> Refusals => refusals;

        /// <summary>What every fluid needs and this device lacks; null where nothing is missing.</summary>
        public static string MissingAbility()
        {
            if (HasNoGraphics)
                return "this player has no graphics device, on which the fluid is computed.";
            return MissingAbility(SystemInfo.supportsComputeShaders, SystemInfo.supportsIndirectArgumentsBuffer,
                SystemInfo.supportsSetConstantBuffer, SystemInfo.supportsAsyncGPUReadback);
        }

        /// <summary>The same by what SystemInfo says of the device.</summary>
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

        /// <summary>Why the fluid itself cannot run; null where it can.</summary>
        /// <param name="needed"><see cref="DeviceFeature.TwoLists"/> where its layout has them.</param>
        public string ProblemOf(DeviceFeature needed)
        {
            string why = WhyNot(needed, DeviceFeature.None);
            return why == null ? null : $"{why}. {Remedy}.";
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

        /// <summary>Decides which of the features a scene can have together; those that come first in <see cref="DeviceFeature"/> do.</summary>
        /// <returns>Whether the answer may differ from that of the last call.</returns>
        public bool Decide(DeviceFeature wanted)
        {
            if (wanted == decided)
                return false;
            decided = wanted;
            Refused = DeviceFeature.None;
            refusals.Clear();
            DeviceFeature granted = wanted & DeviceFeature.TwoLists;
            for (var feature = DeviceFeature.Colliders; feature <= DeviceFeature.ParticleAccess; feature = (DeviceFeature)((int)feature << 1))
            {
                if ((wanted & feature) == 0)
                    continue;
                string why = WhyNot(granted | feature, feature);
                if (why == null)
                {
                    granted |= feature;
                    continue;
                }
                Refused |= feature;
                refusals.Add((feature, $"goes on without {NameOf(feature)}: {why}. {Remedy}, or {RemedyOf(feature)}."));
            }
            return true;
        }

        // Why a kernel cannot run that a scene with these features takes; of one that has several, by its variant with all of them.
        string WhyNot(DeviceFeature features, DeviceFeature added)
        {
            string lastKernel = null, lastFile = null;
            foreach (KernelNeed need in KernelNeeds.OfKernels)
            {
                DeviceFeature own = KernelNeeds.FeaturesOf(need);
                if ((own & ~features) != 0 || added != DeviceFeature.None && (own & added) == 0 || IsReplaced(need))
                    continue;
                if (limits.WhyNot(need) is string why)
                    return why;
                if (need.Kernel == lastKernel && need.File == lastFile)
                    continue;
                lastKernel = need.Kernel;
                lastFile = need.File;
                ComputeShader shader = load?.Invoke(need.File);
                if (shader != null && !IsSupported(shader, need.Kernel))
                    return $"kernel '{need.Kernel}' of {need.File}.compute is not supported by this device (ComputeShader.IsSupported)";
            }
            return null;
        }

        // Unity answers for the keywords that are enabled, and another fluid may have left some on the shared shader. Each step sets its own.
        static bool IsSupported(ComputeShader shader, string kernel)
        {
            LocalKeyword[] left = shader.enabledKeywords;
            shader.enabledKeywords = Array.Empty<LocalKeyword>();
            bool isSupported = shader.IsSupported(shader.FindKernel(kernel));
            shader.enabledKeywords = left;
            return isSupported;
        }

        // Whether another kernel runs in its place: the stand-in where the device holds the large one, the large one where it does
        // not, and the one for more buffers where it has not enough.
        bool IsReplaced(in KernelNeed need)
        {
            if (IsStandIn(need.Kernel, KernelNeed.Small, out string large) || IsStandIn(need.Kernel, KernelNeed.Narrow, out large))
                return limits.Holds(need.File, large);
            if (IsStandIn(need.Kernel, KernelNeed.Wide, out _))
                return !limits.Holds(need.File, need.Kernel);
            return HasStandIn(need, KernelNeed.Small) || HasStandIn(need, KernelNeed.Narrow);
        }

        static bool IsStandIn(string kernel, string suffix, out string large)
        {
            bool ends = kernel.EndsWith(suffix, StringComparison.Ordinal);
            large = ends ? kernel.Substring(0, kernel.Length - suffix.Length) : null;
            return ends;
        }

        bool HasStandIn(in KernelNeed need, string suffix)
        {
            string name = need.Kernel + suffix;
            foreach (KernelNeed other in KernelNeeds.OfKernels)
                if (other.File == need.File && other.Kernel == name)
                    return !limits.Holds(need.File, need.Kernel);
            return false;
        }

        static string NameOf(DeviceFeature feature)
        {
            switch (feature)
            {
                case DeviceFeature.Colliders: return "colliders";
                case DeviceFeature.DeepWater: return "the pressure of deep water";
                case DeviceFeature.Viscosity: return "velocity smoothing";
                case DeviceFeature.Emitters: return "emitters";
                case DeviceFeature.Tags: return "phases and lifetimes of emitted particles";
                case DeviceFeature.Drains: return "drains";
                case DeviceFeature.ForceFields: return "force fields";
                case DeviceFeature.DynamicViscosity: return "dynamic viscosity";
                case DeviceFeature.Elasticity: return "elasticity";
                case DeviceFeature.Vorticity: return "vorticity confinement";
                case DeviceFeature.Reactions: return "forces on colliders";
                case DeviceFeature.Sleep: return "sleep";
                case DeviceFeature.Extrapolation: return "less numerical damping";
                case DeviceFeature.Foam: return "foam";
                case DeviceFeature.Statistics: return "statistics";
                case DeviceFeature.Surface: return "the water's surface";
                case DeviceFeature.Queries: return "probes and detectors";
                case DeviceFeature.ParticleAccess: return "passes of scripts";
                default: throw Limit.OutOfRange(nameof(feature), feature, "Not a feature of a scene.");
            }
        }

        static string RemedyOf(DeviceFeature feature)
        {
            switch (feature)
            {
                case DeviceFeature.Colliders: return "disable the colliders in its box";
                case DeviceFeature.DeepWater: return "set Deep Water to Off and keep the water shallow";
                case DeviceFeature.Viscosity: return "set the velocity smoothing to 0";
                case DeviceFeature.Emitters: return "disable its emitters";
                case DeviceFeature.Tags: return "set phase and lifetime of its emitters to 0";
                case DeviceFeature.Drains: return "disable its drains";
                case DeviceFeature.ForceFields: return "disable its force fields";
                case DeviceFeature.DynamicViscosity: return "set the dynamic viscosity to 0";
                case DeviceFeature.Elasticity: return "set the shear modulus to 0";
                case DeviceFeature.Vorticity: return "set vorticity to 0";
                case DeviceFeature.Reactions: return "let no collider measure its force";
                case DeviceFeature.Sleep: return "set the sleep speed to 0";
                case DeviceFeature.Extrapolation: return "set the numerical damping to 1";
                case DeviceFeature.Foam: return "disable its FluidFoam";
                case DeviceFeature.Statistics: return "set the statistics interval to 0";
                case DeviceFeature.Surface: return "draw it with a ParticleRenderer";
                case DeviceFeature.Queries: return "disable its probes and detectors";
                case DeviceFeature.ParticleAccess: return "let no script listen to BeforeStep";
                default: throw Limit.OutOfRange(nameof(feature), feature, "Not a feature of a scene.");
            }
        }
    }
}
