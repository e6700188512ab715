using System;
using UnityEngine;

namespace Rill
{
    // Which features it has: what a build with it contains, what is loaded, and what the graphics device is too small for.
    public sealed partial class FluidSimulation : IUsesFeatures
    {
        [Tooltip("Shaders that a build with this fluid contains. Used By Settings: those that the settings stored here need. All " +
            "Features: also those that a script may switch on or add.")]
        [SerializeField] ShadersInBuild shadersInBuild = ShadersInBuild.UsedBySettings;

        [SerializeField, HideInInspector] StageReferences shaders = new StageReferences();

        static bool noGraphicsIsLogged;

        FeatureGate features;
        DeviceLimits limits;
        FeatureSet wanted;       // of the steps of this frame

        /// <summary>Shaders that a build with this fluid contains. Of use in the Editor alone: a player has those that it was built with.</summary>
        public ShadersInBuild ShadersInBuild { get => shadersInBuild; set { shadersInBuild = value; Changed(); } }

        StageReferences IUsesFeatures.StageReferences => shaders;

        FeatureSet IUsesFeatures.UsedFeatures => UsedFeatures;

        FeatureSet UsedFeatures
        {
            get
            {
                if (shadersInBuild == ShadersInBuild.AllFeatures)
                    return Features.OfFluids;
                var stored = new StepInput { settings = solver, material = material };
                FeatureSet used = ((FeatureSet)Features.Core).With(Features.DeepWater, solver.deepWater != DeepWater.Off)
                    .With(Features.Statistics, statisticsInterval > 0);
                foreach (Feature feature in Features.OfSettings)
                    used = used.With(feature, feature.IsAsked(null, stored));
                return used;
            }
        }

        /// <summary>Set before it is enabled by tests: limits instead of the device's own, within them.</summary>
        internal DeviceLimits? PretendedLimits { get; set; }

        FeatureGate Gate => features ??= new FeatureGate(this);

        /// <summary>Whether the shaders of a feature are loaded, and the device is not known to be too small for it; where not, that is logged
        /// once.</summary>
        internal bool Has(Feature feature) => Gate.IsLoaded(feature) && !Gate.Refused.Has(feature);

        /// <summary>As <see cref="Has"/>, of a feature that no step asks for.</summary>
        internal bool HasBesideSteps(Feature feature) => Gate.Holds(feature);

        /// <summary>Whether the fluid stays empty because the player has no graphics device.</summary>
        static bool HasNoGraphics => DeviceGate.HasNoGraphics;

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        static void ResetNoGraphics() => noGraphicsIsLogged = false;

        /// <summary>One line for all fluids: a dedicated server is no fault.</summary>
        void LogNoGraphics()
        {
            if (noGraphicsIsLogged)
                return;
            noGraphicsIsLogged = true;
            Debug.Log($"Rill: FluidSimulation '{name}' stays empty, like every other: {DeviceGate.MissingAbility()}", this);
        }

        string DeviceProblem
        {
            get
            {
                if (DeviceGate.MissingAbility() is string missing)
                    return missing;
                var gate = new FeatureGate();
                gate.Begin(DeviceLimits.Current, null);
                return gate.ProblemOf(FeatureSet.None);
            }
        }

        /// <summary>Begins on this device; says why a fluid of that layout cannot run on it, or null.</summary>
        string ProblemOnDevice(SolverLayout layout)
        {
            limits = PretendedLimits ?? DeviceLimits.Current;
            Gate.Begin(limits, LoadedKernels);
            return Gate.ProblemOf(FeatureSet.None.With(Features.TwoLists, layout.TwoLists));
        }

        // A stage that is not loaded is another problem, which is told apart.
        static ComputeShader LoadedKernels(string stage)
        {
            StageShader asset = StageShader.Find(stage);
            return asset != null ? asset.Compute : null;
        }

        /// <summary>Takes out of the coming step what the device is too small for. Allocates nothing while the scene wants the same
        /// features.</summary>
        void LimitToDevice()
        {
            wanted = wanted.With(Features.TwoLists, pbf.Layout.TwoLists).With(Features.Statistics, statisticsInterval > 0)
                .With(Features.SurfaceParticles, NeedsSurface).With(Features.Queries, queryPartCount > 0 || AsksBatches)
                .With(Features.ParticleAccess, !passes.IsEmpty);
            Gate.TurnOffRefused(pbf, ref input, ref wanted);
            if (Gate.Refused.Has(Features.DeepWater))
                input.settings.relaxation = effective.StableRelaxation(false);
        }
    }
}
