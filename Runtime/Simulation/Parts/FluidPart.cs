using System;
using System.Collections;
using System.Collections.Generic;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Something in the scene that acts on one <see cref="FluidSimulation"/> while it is enabled.</summary>
    /// <remarks>On the simulation's object, below it, or anywhere with a reference to it. Follows position and rotation.</remarks>
    public abstract class FluidPart : MonoBehaviour, IHasProblems, IUsesFeatures, IRunsInEditMode, IAppliesSettings
    {
        [Tooltip("Fluid that this acts on. None: the one on this object or the nearest above it.")]
        [SerializeField] FluidSimulation simulation;

        [SerializeField, HideInInspector] StageReferences shaders = new StageReferences();

        [NonSerialized] FluidSimulation attached;
        RigidPose lastPose;         // at the end of the last steps, in the domain's frame
        [NonSerialized] bool follows;               // whether it came from there
        [NonSerialized] OnceLog log;
        [NonSerialized] ClampedSettings clamped;

        /// <summary>The fluid that this acts on; null while there is none or this is disabled. Setting null means the nearest above it.</summary>
        public FluidSimulation Simulation
        {
            get => attached;
            set
            {
                simulation = value;
                Reattach();
            }
        }

        /// <summary>Call after putting this somewhere else: it has then not moved through the fluid between.</summary>
        public void Teleport() => follows = false;

        /// <summary>Number among its kind in the simulation, -1 where it has none.</summary>
        [field: NonSerialized] internal int Number { get; set; } = -1;

        /// <summary>Problems of every part; those of a kind of its own come from <see cref="FirstOwnProblem"/> on.</summary>
        const int InvalidPose = 0, NoSimulation = 1, TooMany = 2;
        private protected const int FirstOwnProblem = 3;

        /// <summary>Each kind has numbers of its own in a simulation.</summary>
        internal abstract PartKind PartKind { get; }

        /// <summary>Puts every value into its range.</summary>
        /// <returns>What was wrong and what it became; null if nothing was.</returns>
        private protected abstract string ValidateValues();

        /// <summary>Lists what is wrong with a part of this kind in a simulation.</summary>
        private protected abstract void ListOwnProblems(FluidSimulation fluid, List<string> problems);

        /// <summary>The stages that a part of this kind makes a fluid use.</summary>
        private protected abstract FeatureSet UsedFeatures { get; }

        FeatureSet IUsesFeatures.UsedFeatures => UsedFeatures;

        StageReferences IUsesFeatures.StageReferences => shaders;

        bool IRunsInEditMode.BelongsTo(FluidSimulation fluid) => Wanted == fluid;

        void IHasProblems.ListProblems(List<string> problems)
        {
            problems.AddIfAny(clamped.Problem);
            problems.AddIfAny(PoseProblem);
            FluidSimulation fluid = attached != null ? attached : Wanted;
            problems.AddIfAny(fluid == null ? NoSimulationProblem : attached != null && Number < 0 ? TooManyProblem : null);
            if (fluid != null && fluid.ParticleSpacing > 0f)
                ListOwnProblems(fluid, problems);
        }

        /// <summary>The simulation begins again.</summary>
        internal virtual void OnRestart() => Teleport();

        /// <summary>Whether a problem is there that is yet to be logged: true once for as long as it stays.</summary>
        private protected bool ShouldLog(int problem, bool isThere) => log.ShouldLog(problem, isThere);

        private protected void Warn(string problem) => Debug.LogWarning($"Rill: {GetType().Name} '{name}': {problem}", this);

        /// <summary>Gives the pose of this part in the domain's frame, d; false, and logged once, where the pose is not finite.</summary>
        internal bool TryGetPose(in DomainFrame frame, out PoseInDomain pose)
        {
            bool isValid = HasValidPose();
            pose = isValid ? frame.ToDomain(transform.position, transform.rotation) : default;
            return isValid;
        }

        /// <summary>How this moves in one of the steps of a frame, in the domain's frame, d: evenly over all of them, from where it was
        /// after the last; false as for <see cref="TryGetPose"/>.</summary>
        /// <param name="from">Fraction of the frame at which the step starts.</param>
        /// <param name="to">Fraction of the frame at which it ends.</param>
        private protected bool TryGetMotion(in DomainFrame frame, float from, float to, out RigidPose start, out RigidPose end)
        {
            start = end = default;
            if (!HasValidPose())
            {
                Teleport();
                return false;
            }
            RigidPose pose = frame.Pose(transform.position, transform.rotation);
            RigidPose first = follows && attached.Box.WentAlong(lastPose, pose) ? lastPose : pose;
            start = RigidPose.Between(first, pose, from);
            end = RigidPose.Between(first, pose, to);
            if (to >= 1f)
            {
                lastPose = pose;
                follows = true;
            }
            return true;
        }

        /// <summary>How this came to where it is, for a snapshot.</summary>
        private protected PartRecord SavePart(in DomainFrame frame)
        {
            bool isValid = Limit.IsPose(transform.position, transform.rotation);
            return new PartRecord
            {
                number = (uint)Number,
                now = isValid ? new PoseRecord(frame.Pose(transform.position, transform.rotation)) : default,
                last = follows ? new PoseRecord(lastPose) : default,
                follows = isValid && follows ? 1u : 0u,
            };
        }

        /// <summary>Goes on as it came there, if it is where it was.</summary>
        /// <param name="tolerance">Distance within which it is, d.</param>
        private protected void LoadPart(in PartRecord record, in DomainFrame frame, float tolerance)
        {
            follows = record.follows != 0 && Limit.IsPose(transform.position, transform.rotation)
                && record.now.IsAt(frame.Pose(transform.position, transform.rotation), tolerance);
            lastPose = record.last.Pose;
        }

        private protected void Changed() => ChangedSettings.Apply(this);

        void OnEnable()
        {
            shaders.Hold();
            Changed();
            Attach();
        }

        void OnDisable()
        {
            Detach();
            shaders.Release();
        }

        void OnValidate() => ChangedSettings.ApplyLater(this);

        void IAppliesSettings.CheckSettings() => clamped.Set(ValidateValues());

        void IAppliesSettings.ApplySettings()
        {
            clamped.Log(this);
            shaders.Follow(UsedFeatures);
            if (attached != null && simulation != null && simulation != attached)
                Reattach();
        }

        void OnTransformParentChanged() => Reattach();

        void Reattach()
        {
            FluidSimulation wanted = Wanted;
            if (!isActiveAndEnabled || wanted == attached)
                return;
            Detach();
            Attach();
        }

        bool HasValidPose()
        {
            bool isInvalid = !Limit.IsPose(transform.position, transform.rotation);
            if (ShouldLog(InvalidPose, isInvalid))
                Warn(PoseProblem);
            return !isInvalid;
        }

        string PoseProblem => Limit.IsPose(transform.position, transform.rotation) ? null
            : Invariant($"its transform is not finite (position {transform.position}, rotation {transform.rotation}). It does nothing ") +
            "until position, rotation and scale of this object and its parents are numbers.";

        string NoSimulationProblem
            => "there is no FluidSimulation on this object or above it, so it acts on none. Put it below one or set its Simulation.";

        string TooManyProblem => Invariant($"FluidSimulation '{attached.name}' has {attached.Inputs.Parts.MaxOf(this)} of its kind, the most it ") +
            "takes, and leaves this one out. Disable another and enable this again.";

        FluidSimulation Wanted => simulation != null ? simulation : GetComponentInParent<FluidSimulation>(true);

        void Attach()
        {
            attached = Wanted;
            if (attached == null)
            {
                StartCoroutine(WarnIfDetached());
                return;
            }
            ShouldLog(NoSimulation, false);
            attached.Inputs.Parts.Attach(this);
            if (ShouldLog(TooMany, Number < 0))
                Warn(TooManyProblem);
        }

        // A frame later: what is instantiated is put below its fluid right after.
        IEnumerator WarnIfDetached()
        {
            yield return null;
            if (isActiveAndEnabled && ShouldLog(NoSimulation, attached == null))
                Warn(NoSimulationProblem);
        }

        void Detach()
        {
            if (attached != null)       // it may have been destroyed first
                attached.Inputs.Parts.Detach(this);
            attached = null;
            Number = -1;
        }
    }
}
