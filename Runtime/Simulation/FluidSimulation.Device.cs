using System;
using UnityEngine;

namespace Rill
{
    // What the graphics device is too small for: the fluid is off, or goes on without the feature that asks for it.
    public sealed partial class FluidSimulation
    {
        static bool noGraphicsIsLogged;

        DeviceGate gate;
        DeviceLimits limits;
        [NonSerialized] DeviceFeature wanted;       // of the steps of this frame
        [NonSerialized] DeviceFeature loggedRefusals;

        /// <summary>Set before it is enabled by tests: limits instead of the device's own, within them.</summary>
        internal DeviceLimits? PretendedLimits { get; set; }

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

        string DeviceProblem => DeviceGate.MissingAbility() ?? new DeviceGate(DeviceLimits.Current, null).ProblemOf(DeviceFeature.None);

        /// <summary>Makes the gate of this device; says why a fluid of that layout cannot run on it, or null.</summary>
        string ProblemOnDevice(SolverLayout layout)
        {
            limits = PretendedLimits ?? DeviceLimits.Current;
            gate = new DeviceGate(limits, LoadedKernels);
            loggedRefusals = DeviceFeature.None;
            return gate.ProblemOf(layout.TwoLists ? DeviceFeature.TwoLists : DeviceFeature.None);
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
            wanted |= FeaturesWanted();
            if (gate.Decide(wanted))
                LogRefusals();
            DeviceFeature refused = gate.Refused;
            if (refused == DeviceFeature.None)
                return;

            if ((refused & DeviceFeature.Colliders) != 0)
                input.colliders = null;
            else if ((refused & DeviceFeature.Reactions) != 0)
                for (int i = 0; i < colliders.Set.Count; i++)
                    colliders.Set.Items[i].reacts = false;
            if ((refused & DeviceFeature.DeepWater) != 0)
            {
                input.settings.deepWater = DeepWater.Off;
                input.settings.relaxation = effective.StableRelaxation(false);
            }
            if ((refused & DeviceFeature.Viscosity) != 0)
            {
                input.material.velocitySmoothing = 0f;
                input.needsDensity = false;
            }
            if ((refused & DeviceFeature.DynamicViscosity) != 0)
                input.material.dynamicViscosity = 0f;
            if ((refused & DeviceFeature.Elasticity) != 0)
                input.material.shearModulus = 0f;
            if ((refused & DeviceFeature.Vorticity) != 0)
                input.material.vorticity = 0f;
            if ((refused & DeviceFeature.Sleep) != 0)
                input.settings.sleepSpeed = 0f;
            if ((refused & DeviceFeature.Extrapolation) != 0)
                input.settings.numericalDamping = 1f;
            if ((refused & DeviceFeature.Foam) != 0)
                input.foam.budget = 0;
            if ((refused & DeviceFeature.Tags) != 0)
                input.tracksPhases = false;
            LimitSources(refused);
        }

        void LimitSources(DeviceFeature refused)
        {
            if (sources == null)
                return;
            if ((refused & DeviceFeature.Emitters) != 0)
            {
                sources.emitterCount = 0;
                sources.goneEmitters = 0;
                sources.keepsEmitters = sources.needsTags = sources.needsLifetimes = sources.recycles = false;
            }
            if ((refused & DeviceFeature.Tags) != 0)
                sources.needsTags = sources.needsLifetimes = false;
            if ((refused & DeviceFeature.Drains) != 0)
            {
                sources.drainCount = 0;
                sources.goneDrains = 0;
                sources.keepsDrains = sources.recycles = sources.limitsDrains = false;
            }
            if ((refused & DeviceFeature.ForceFields) != 0)
            {
                sources.fieldCount = 0;
                sources.hasWind = false;
            }
        }

        bool IsRefused(DeviceFeature feature) => (gate.Refused & feature) != 0;

        DeviceFeature FeaturesWanted()
        {
            DeviceFeature features = pbf.Layout.TwoLists ? DeviceFeature.TwoLists : DeviceFeature.None;
            void Want(bool isWanted, DeviceFeature feature) => features |= isWanted ? feature : DeviceFeature.None;
            Want(Colliders.IsNeeded(input), DeviceFeature.Colliders);
            Want(Colliders.IsNeeded(input) && input.colliders.Reacts, DeviceFeature.Reactions);
            Want(pbf.IsDeep(input), DeviceFeature.DeepWater);
            Want(input.material.velocitySmoothing > 0f || input.needsDensity, DeviceFeature.Viscosity);
            Want(ImplicitViscosity.IsNeeded(input), DeviceFeature.DynamicViscosity);
            Want(Viscoelasticity.IsNeeded(input), DeviceFeature.Elasticity);
            Want(VorticityConfinement.IsNeeded(input), DeviceFeature.Vorticity);
            Want(RestingRegions.IsNeeded(input), DeviceFeature.Sleep);
            Want(VelocityExtrapolation.IsNeeded(input), DeviceFeature.Extrapolation);
            Want(Foam.IsNeeded(input), DeviceFeature.Foam);
            Want(statisticsInterval > 0, DeviceFeature.Statistics);
            Want(NeedsSurface, DeviceFeature.Surface);
            Want(queryPartCount > 0 || AsksBatches, DeviceFeature.Queries);
            Want(!passes.IsEmpty, DeviceFeature.ParticleAccess);
            Want(input.tracksPhases, DeviceFeature.Tags);
            if (sources != null)
            {
                Want(sources.keepsEmitters, DeviceFeature.Emitters);
                Want(sources.needsTags, DeviceFeature.Tags);
                Want(sources.keepsDrains || sources.needsLifetimes, DeviceFeature.Drains);
                Want(sources.fieldCount > 0, DeviceFeature.ForceFields);
            }
            return features;
        }

        // Each feature once, however often it comes and goes.
        void LogRefusals()
        {
            foreach ((DeviceFeature feature, string problem) in gate.Refusals)
                if ((loggedRefusals & feature) == 0)
                    Debug.LogError($"Rill: FluidSimulation '{name}' {problem}", this);
            loggedRefusals |= gate.Refused;
        }
    }
}
