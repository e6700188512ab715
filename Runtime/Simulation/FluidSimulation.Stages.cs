using System;
using UnityEngine;

namespace Rill
{
    // Which stages a build with this fluid contains, and what is left out where one is missing.
    public sealed partial class FluidSimulation : IUsesStages
    {
        [Tooltip("Shaders that a build with this fluid contains. Used By Settings: those that the settings stored here need. All " +
            "Features: also those that a script may switch on or add.")]
        [SerializeField] ShadersInBuild shadersInBuild = ShadersInBuild.UsedBySettings;

        [SerializeField, HideInInspector] StageReferences shaders = new StageReferences();

        [NonSerialized] StageSet found, missing, missingSaid;
        [NonSerialized] int stagesSeen = -1;
        [NonSerialized] string missingProblem;

        /// <summary>Shaders that a build with this fluid contains. Of use in the Editor alone: a player has those that it was built with.</summary>
        public ShadersInBuild ShadersInBuild { get => shadersInBuild; set { shadersInBuild = value; Changed(); } }

        StageReferences IUsesStages.StageReferences => shaders;

        StageSet IUsesStages.UsedStages => UsedStages;

        StageSet UsedStages
        {
            get
            {
                if (shadersInBuild == ShadersInBuild.AllFeatures)
                    return StageSet.OfFluids;
                StageSet used = StageSet.Core;
                used |= solver.deepWater != DeepWater.Off ? StageSet.DeepWater : StageSet.None;
                used |= material.dynamicViscosity > 0f ? StageSet.ImplicitViscosity : StageSet.None;
                used |= material.shearModulus > 0f ? StageSet.Viscoelasticity : StageSet.None;
                used |= material.vorticity > 0f ? StageSet.Vorticity : StageSet.None;
                used |= solver.sleepSpeed > 0f && !(material.vorticity > 0f) ? StageSet.Sleep : StageSet.None;
                used |= statisticsInterval > 0 ? StageSet.Statistics : StageSet.None;
                return used;
            }
        }

        /// <summary>Whether the stages of a group are loaded; where not, that is logged once, by name.</summary>
        internal bool HasStages(StageSet group)
        {
            if (stagesSeen != StageShader.Changes)
            {
                stagesSeen = StageShader.Changes;
                found = missing = StageSet.None;
                missingProblem = null;
            }
            if ((found & group) != 0)
                return true;
            if ((missing & group) != 0)
                return false;
            string stage = StageSets.FirstMissing(group);
            if (stage == null)
            {
                found |= group;
                return true;
            }
            missing |= group;
            missingProblem = $"goes on without {NameOf(group)}: {StageShader.MissingProblem(stage)}";
            if ((missingSaid & group) == 0)
                Debug.LogError($"Rill: FluidSimulation '{name}' {missingProblem}", this);
            missingSaid |= group;
            return false;
        }

        /// <summary>Turns off in an input what it asks for and what has no shaders here.</summary>
        void LeaveOutMissing(ref StepInput step)
        {
            if (Rill.Colliders.IsNeeded(step) && !HasStages(StageSet.Colliders))
                step.colliders = null;
            if (ImplicitViscosity.IsNeeded(step) && !HasStages(StageSet.ImplicitViscosity))
                step.material.dynamicViscosity = 0f;
            if (Viscoelasticity.IsNeeded(step) && !HasStages(StageSet.Viscoelasticity))
                step.material.shearModulus = 0f;
            if (VorticityConfinement.IsNeeded(step) && !HasStages(StageSet.Vorticity))
                step.material.vorticity = 0f;
            if (RestingRegions.IsNeeded(step) && !HasStages(StageSet.Sleep))
                step.settings.sleepSpeed = 0f;
            if (Foam.IsNeeded(step) && !HasStages(StageSet.Foam))
                step.foam.budget = 0;
            if (pbf.IsDeep(step) && !HasStages(StageSet.DeepWater))
                step.settings.deepWater = DeepWater.Off;
        }

        static string NameOf(StageSet group)
        {
            switch (group)
            {
                case StageSet.DeepWater: return "deep water";
                case StageSet.ImplicitViscosity: return "dynamic viscosity";
                case StageSet.Viscoelasticity: return "elasticity";
                case StageSet.Vorticity: return "vorticity confinement";
                case StageSet.Sleep: return "sleep";
                case StageSet.Statistics: return "statistics";
                case StageSet.Foam: return "foam";
                case StageSet.Colliders: return "colliders";
                case StageSet.Emitters: return "emitters";
                case StageSet.Drains: return "drains and lifetimes";
                case StageSet.ForceFields: return "force fields";
                case StageSet.Queries: return "probes and detectors";
                case StageSet.ParticleAccess: return "the removal and the readback of particles by scripts";
                case StageSet.ParticleEdits: return "Fill, RemoveInside and Recenter";
                case StageSet.Transfer: return "connections, and what is kept outside the box";
                case StageSet.Recording: return "recording and playback";
                case StageSet.SurfaceParticles:
                case StageSet.SurfaceMesh: return "the water's surface";
                default: return group.ToString();
            }
        }
    }
}
