using System.Collections.Generic;
using UnityEngine;

namespace Rill
{
    /// <summary>Features of a fluid: those that a build with it contains, those that are loaded, and those that the graphics device is too
    /// small for.</summary>
    sealed class FeatureSupport
    {
        static bool noGraphicsIsLogged;

        readonly FluidSimulation fluid;
        readonly List<FluidVolume> volumes = new List<FluidVolume>();
        FeatureGate gate;
        FeatureSet wanted;       // of the steps of this frame

        public FeatureSupport(FluidSimulation fluid) => this.fluid = fluid;

        /// <summary>Limits instead of the device's own, within them: set by tests before the fluid is enabled.</summary>
        public DeviceLimits? PretendedLimits { get; set; }

        /// <summary>Limits of the device on which the fluid began.</summary>
        public DeviceLimits Limits { get; private set; }

        public FeatureGate Gate => gate ??= new FeatureGate(fluid);

        /// <summary>Features that a build with this fluid contains.</summary>
        public FeatureSet Used
        {
            get
            {
                if (fluid.ShadersInBuild == ShadersInBuild.AllFeatures)
                    return Features.OfFluids;
                var stored = new StepInput
                {
                    settings = fluid.Settings, material = fluid.Material, phases = fluid.Phases.ForStep(), borders = fluid.Borders
                };
                FeatureSet used = ((FeatureSet)Features.Core)
                    .With(Features.DeepWater, stored.settings.deepWater != DeepWater.Off && !stored.material.contacts)
                    .With(Features.Statistics, fluid.StatisticsInterval > 0)
                    .With(Features.Emitters, stored.borders.HasOpen).With(Features.Drains, stored.borders.HasOpen);
                foreach (Feature feature in Features.OfSettings)
                    used = used.With(feature, feature.IsAsked(null, stored));
                // Their materials may be known to emitters and scripts alone.
                foreach (FluidMaterialPair pair in fluid.MaterialPairs)
                    used = used.With(Features.Diffusion, pair.diffusion > 0f);
                fluid.GetComponentsInChildren(true, volumes);
                foreach (FluidVolume volume in volumes)
                    if (volume.Material != null)
                        used |= volume.Material.UsedFeatures;
                volumes.Clear();
                return used;
            }
        }

        /// <summary>Whether the shaders of a feature are loaded, and the device is not known to be too small for it; where not, that is logged
        /// once.</summary>
        public bool Has(Feature feature) => Gate.IsLoaded(feature) && !Gate.Refused.Has(feature);

        /// <summary>Whether the fluid has a feature that no step asks for; where not, that is logged once.</summary>
        public bool HasBesideSteps(Feature feature) => Gate.Holds(feature);

        /// <summary>Ability that this device lacks for any fluid; null where it lacks none.</summary>
        public static string MissingAbility => DeviceGate.MissingAbility();

        /// <summary>Whether fluids are inactive because the player has no graphics device.</summary>
        public static bool HasNoGraphics => DeviceGate.HasNoGraphics;

        /// <summary>Why no fluid can run on this device; null where one can.</summary>
        public static string DeviceProblem
        {
            get
            {
                if (MissingAbility is string missing)
                    return missing;
                var gate = new FeatureGate();
                gate.Begin(DeviceLimits.Current, null);
                return gate.ProblemOf(FeatureSet.None);
            }
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        static void ResetNoGraphics() => noGraphicsIsLogged = false;

        /// <summary>Logs one line for all fluids: a dedicated server is not a fault.</summary>
        public void LogNoGraphics()
        {
            if (noGraphicsIsLogged)
                return;
            noGraphicsIsLogged = true;
            Debug.Log($"Rill: FluidSimulation '{fluid.name}' is inactive, like every other: {MissingAbility}", fluid);
        }

        /// <summary>Begins on this device.</summary>
        /// <returns>Why a fluid of that layout cannot run on it; null where it can.</returns>
        public string Begin(SolverLayout layout)
        {
            Limits = PretendedLimits ?? DeviceLimits.Current;
            Gate.Begin(Limits, LoadedKernels);
            return Gate.ProblemOf(FeatureSet.None.With(Features.TwoLists, layout.TwoLists));
        }

        /// <summary>Begins the steps of a frame.</summary>
        public void BeginSteps() => wanted = FeatureSet.None;

        /// <summary>Turns off in the coming step what the device is too small for. Allocates nothing while the scene wants the same
        /// features.</summary>
        /// <param name="settings">Settings that the step is made from.</param>
        public void TurnOffRefused(ref StepInput input, in SolverSettings settings)
        {
            wanted = wanted.With(Features.TwoLists, fluid.Solver.Layout.TwoLists).With(Features.Statistics, fluid.StatisticsInterval > 0)
                .With(Features.SurfaceParticles, fluid.Results.Surface.IsNeeded)
                .With(Features.Queries, fluid.Inputs.Parts.QueryCount > 0 || fluid.Results.Queries.HasBatches)
                .With(Features.ParticleAccess, !fluid.Steps.Passes.IsEmpty);
            Gate.TurnOffRefused(fluid.Solver, ref input, ref wanted);
            if (Gate.Refused.Has(Features.DeepWater))
                input.settings.relaxation = settings.StableRelaxation(false);
        }

        /// <summary>Whether the fluid has a feature that is asked for after the steps of a frame.</summary>
        public bool HasAfterSteps(Feature feature)
        {
            wanted |= feature;
            Gate.Decide(wanted);
            return Has(feature);
        }

        // A stage that is not loaded is another problem, which is told apart.
        static ComputeShader LoadedKernels(string stage)
        {
            StageShader asset = StageShader.Find(stage);
            return asset != null ? asset.Compute : null;
        }
    }
}
