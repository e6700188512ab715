using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Decides which features a fluid has: those whose shaders are loaded, and that its device holds together. Logs once what it goes on
    /// without, by name and with what to do.</summary>
    sealed class FeatureGate
    {
        static readonly FeatureSet[] OfKernels = FeaturesOfKernels();

        readonly UnityEngine.Object owner;
        readonly List<(Feature feature, string problem)> refusals = new List<(Feature, string)>();
        DeviceLimits limits;
        Func<string, ComputeShader> load;
        FeatureSet decided, held, refusedAlone, loggedRefusals;
        FeatureSet found, missing, loggedMissing;
        int stagesSeen = -1;

        /// <param name="owner">Whose features they are, for messages; null for none.</param>
        public FeatureGate(UnityEngine.Object owner = null) => this.owner = owner;

        /// <summary>Features of the last decision that the device is too small for.</summary>
        public FeatureSet Refused { get; private set; }

        /// <summary>Each of the refused features, and why.</summary>
        public IReadOnlyList<(Feature feature, string problem)> Refusals => refusals;

        /// <summary>Why it goes on without a feature that has no shaders here; null where all that was looked for is loaded.</summary>
        public string MissingProblem { get; private set; }

        /// <summary>Begins on a device.</summary>
        /// <param name="load">Kernels of a stage, by its name, asked for those of the features wanted: one that is null is judged by the
        /// table alone, as all are without this.</param>
        public void Begin(in DeviceLimits limits, Func<string, ComputeShader> load)
        {
            this.limits = limits;
            this.load = load;
            decided = held = refusedAlone = loggedRefusals = Refused = FeatureSet.None;
            refusals.Clear();
        }

        /// <summary>Why the fluid itself cannot run; null where it can.</summary>
        /// <param name="needed">Features that are part of it.</param>
        public string ProblemOf(FeatureSet needed)
        {
            FeatureSet all = needed | Features.Core;
            string why = WhyNot(all, all);
            return why == null ? null : $"{why}. {DeviceGate.Remedy}.";
        }

        /// <summary>Whether the shaders of a feature are loaded; where not, that is logged once.</summary>
        public bool IsLoaded(Feature feature)
        {
            if (stagesSeen != StageShader.Changes)
            {
                stagesSeen = StageShader.Changes;
                found = missing = FeatureSet.None;
                MissingProblem = null;
            }
            if (found.Has(feature))
                return true;
            if (missing.Has(feature))
                return false;
            string stage = feature.FirstMissing();
            if (stage == null)
            {
                found |= feature;
                return true;
            }
            missing |= feature;
            MissingProblem = $"goes on without {feature.Name}: {StageShader.MissingProblem(stage)}";
            if (!loggedMissing.Has(feature))
                Log(MissingProblem);
            loggedMissing |= feature;
            return false;
        }

        /// <summary>Whether a feature that no step asks for is loaded, and the device holds it beside what every fluid has; where not, that is logged
        /// once.</summary>
        public bool Holds(Feature feature)
        {
            if (!IsLoaded(feature) || refusedAlone.Has(feature))
                return false;
            if (held.Has(feature))
                return true;
            if (WhyNot((FeatureSet)Features.Core | Features.TwoLists | feature, feature) is string why)
            {
                refusedAlone |= feature;
                Log(ProblemOf(feature, why));
                return false;
            }
            held |= feature;
            return true;
        }

        /// <summary>Turns off in a step what it asks for and what has no shaders here.</summary>
        public void TurnOffMissing(PbfSolver solver, ref StepInput step)
        {
            foreach (Feature feature in Features.All)
                if (feature.IsAsked(solver, step) && !IsLoaded(feature))
                    feature.TurnOff(ref step);
        }

        /// <summary>Turns off in a step what the device is too small for. Allocates nothing while the same features are wanted.</summary>
        /// <param name="wanted">Features that others than the step ask for; gets those of the step.</param>
        public void TurnOffRefused(PbfSolver solver, ref StepInput step, ref FeatureSet wanted)
        {
            foreach (Feature feature in Features.All)
                wanted = wanted.With(feature, feature.IsAsked(solver, step));
            Decide(wanted);
            if (Refused.IsEmpty)
                return;
            foreach (Feature feature in Features.All)
                if (Refused.Has(feature))
                    feature.TurnOff(ref step);
        }

        /// <summary>Decides which of the features a scene can have together; those that come first in <see cref="Features.All"/> do. Logs each that
        /// is refused, once.</summary>
        /// <returns>Whether the answer may differ from that of the last call.</returns>
        public bool Decide(FeatureSet wanted)
        {
            if (wanted == decided)
                return false;
            decided = wanted;
            Refused = FeatureSet.None;
            refusals.Clear();
            FeatureSet granted = ((FeatureSet)Features.Core).With(Features.TwoLists, wanted.Has(Features.TwoLists));
            foreach (Feature feature in Features.All)
            {
                if (!wanted.Has(feature) || granted.Has(feature))
                    continue;
                string why = WhyNot(granted | feature, feature);
                if (why == null)
                {
                    granted |= feature;
                    continue;
                }
                Refused |= feature;
                refusals.Add((feature, ProblemOf(feature, why)));
                if (!loggedRefusals.Has(feature))
                    Log(refusals[refusals.Count - 1].problem);
                loggedRefusals |= feature;
            }
            return true;
        }

        static string ProblemOf(Feature feature, string why)
            => $"goes on without {feature.Name}: {why}. {DeviceGate.Remedy}, or {feature.Remedy}.";

        void Log(string problem)
        {
            if (owner != null)
                Debug.LogError($"Rill: {owner.GetType().Name} '{owner.name}' {problem}", owner);
        }

        static FeatureSet[] FeaturesOfKernels()
        {
            var sets = new FeatureSet[KernelNeeds.OfKernels.Count];
            for (int i = 0; i < sets.Length; i++)
                sets[i] = Features.Of(KernelNeeds.OfKernels[i]);
            return sets;
        }

        // Why a kernel cannot run that a scene with these features takes; of one that has several, by its variant with all of them.
        string WhyNot(FeatureSet features, FeatureSet added)
        {
            string lastKernel = null, lastFile = null;
            for (int i = 0; i < KernelNeeds.OfKernels.Count; i++)
            {
                KernelNeed need = KernelNeeds.OfKernels[i];
                FeatureSet own = OfKernels[i];
                if (!features.HasAll(own) || !own.HasAny(added) || IsReplaced(need))
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
    }
}
