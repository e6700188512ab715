using System;
using System.Collections.Generic;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>
    /// Lets the water of two fluids flow from one box into the other where the boxes overlap. Each particle belongs to the fluid on whose
    /// side of the plane through the center of the overlap it is; each fluid feels the other's particles in its own box.
    /// </summary>
    /// <remarks>
    /// Both fluids have the same spacing, material, step rate and orientation. A particle that is handed over keeps position, velocity, phase
    /// and lifetime, and gets a new id. Where the capacity of its new fluid is full, it stays where it is and waits.
    /// </remarks>
    [AddComponentMenu("Rill/Fluid Connection"), Icon(PackagePaths.Icon), ManualPage("control", "fluid-connection")]
    public sealed class FluidConnection : MonoBehaviour, IHasProblems, IUsesFeatures, IRunsInEditMode, IAppliesSettings
    {
        /// <summary>Spacings that the boxes overlap by at least: two support radii, for what is felt of the other fluid.</summary>
        public const float MinOverlap = 4f;

        const int Waiting = 0;      // problem of the log

        [Tooltip("One of the fluids.")]
        [SerializeField] FluidSimulation first;

        [Tooltip("The other fluid, whose box overlaps the first's by at least 4 particle spacings; 8 are better.")]
        [SerializeField] FluidSimulation second;

        [SerializeField, HideInInspector] StageReferences shaders = new StageReferences();

        readonly FluidConnectionState state = new FluidConnectionState();
        [NonSerialized] FluidSimulation attachedFirst, attachedSecond;
        [NonSerialized] ConnectionFault loggedFault;
        [NonSerialized] OnceLog log;

        /// <summary>One of the fluids.</summary>
        public FluidSimulation First { get => first; set { first = value; Attach(); } }

        /// <summary>The other fluid.</summary>
        public FluidSimulation Second { get => second; set { second = value; Attach(); } }

        /// <summary>Whether water can flow: both fluids run and nothing is wrong.</summary>
        public bool IsOpen => isActiveAndEnabled && attachedFirst != null && attachedSecond != null && attachedFirst.IsRunning
            && attachedSecond.IsRunning && Fault == ConnectionFault.None;

        /// <summary>Particles that went from the first fluid to the second since the connection opened, or since either got another capacity, as
        /// far as the GPU has told: two or three frames ago.</summary>
        public int HandedToSecond => Count(attachedSecond, TransferWord.Handed);

        /// <summary>Number of those handed from the second to the first.</summary>
        public int HandedToFirst => Count(attachedFirst, TransferWord.Handed);

        /// <summary>Particles that are on the second fluid's side and wait in the first, since the second's capacity is full; as old.</summary>
        public int WaitingForSecond => Count(attachedSecond, TransferWord.Held);

        /// <summary>Number of those that wait in the second for the first.</summary>
        public int WaitingForFirst => Count(attachedFirst, TransferWord.Held);

        internal FluidConnectionState State => state;

        ConnectionFault Fault => FluidConnectionState.FaultBetween(FirstNow, SecondNow);

        string Problem => FluidConnectionState.Describe(Fault, FirstNow, SecondNow);

        FluidSimulation FirstNow => attachedFirst != null ? attachedFirst : first;

        FluidSimulation SecondNow => attachedSecond != null ? attachedSecond : second;

        FeatureSet IUsesFeatures.UsedFeatures => Features.Transfer;

        StageReferences IUsesFeatures.StageReferences => shaders;

        bool IRunsInEditMode.BelongsTo(FluidSimulation fluid) => fluid != null && (fluid == first || fluid == second);

        void IHasProblems.ListProblems(List<string> problems)
        {
            problems.AddIfAny(Problem);
            problems.AddIfAny(FullProblem(attachedFirst, WaitingForFirst));
            problems.AddIfAny(FullProblem(attachedSecond, WaitingForSecond));
        }

        /// <summary>Looks at both fluids, once a frame, and logs what is wrong once for as long as it stays.</summary>
        /// <returns>Whether water can flow.</returns>
        internal bool CanFlow()
        {
            state.Look(attachedFirst, attachedSecond);
            LogOnce(state.Fault);
            return state.Fault == ConnectionFault.None;
        }

        /// <summary>Region whose particles go to one of the fluids, where water can flow.</summary>
        internal TransferRegion RegionTo(FluidSimulation fluid)
        {
            TransferRegion region = state.RegionTo(fluid == attachedFirst);
            region.phaseChanges = fluid.Phases.ChangesFrom(Other(fluid).Phases);
            return region;
        }

        /// <summary>The fluid at the other end.</summary>
        internal FluidSimulation Other(FluidSimulation fluid) => fluid == attachedFirst ? attachedSecond : attachedFirst;

        /// <summary>After numbers have come back.</summary>
        internal void ReportWaiting()
        {
            bool waits = WaitingForFirst > 0 || WaitingForSecond > 0;
            if (waits && log.ShouldLog(Waiting))
                Warn(FullProblem(attachedFirst, WaitingForFirst) ?? FullProblem(attachedSecond, WaitingForSecond));
        }

        void OnEnable()
        {
            shaders.Hold();
            Attach();
        }

        void OnDisable()
        {
            Detach();
            shaders.Release();
        }

        void OnValidate() => ChangedSettings.ApplyLater(this);

        void IAppliesSettings.CheckSettings() { }

        void IAppliesSettings.ApplySettings()
        {
            shaders.Follow(Features.Transfer);
            if (attachedFirst != first || attachedSecond != second)
                Attach();
        }

        void Attach()
        {
            Detach();
            if (!isActiveAndEnabled)
                return;
            loggedFault = ConnectionFault.None;
            if (first == null || second == null || first == second)
            {
                LogOnce(Fault);
                return;
            }
            attachedFirst = first;
            attachedSecond = second;
            if (!first.Inputs.Connections.Connect(this))
                Warn(TooManyProblem(first));
            else if (!second.Inputs.Connections.Connect(this))
                Warn(TooManyProblem(second));
        }

        void Detach()
        {
            if (!ReferenceEquals(attachedFirst, null))
                attachedFirst.Inputs.Connections.Disconnect(this);
            if (!ReferenceEquals(attachedSecond, null))
                attachedSecond.Inputs.Connections.Disconnect(this);
            attachedFirst = attachedSecond = null;
            state.Close();
        }

        void LogOnce(ConnectionFault fault)
        {
            if (fault != loggedFault && fault != ConnectionFault.None)
                Warn(FluidConnectionState.Describe(fault, FirstNow, SecondNow));
            loggedFault = fault;
        }

        void Warn(string problem) => Debug.LogWarning($"Rill: FluidConnection '{name}': {problem}", this);

        int Count(FluidSimulation taker, TransferWord word) => taker != null ? taker.Inputs.Connections.Transferred(this, word) : 0;

        static string TooManyProblem(FluidSimulation fluid)
            => Invariant($"FluidSimulation '{fluid.name}' has {ParticleTransfer.MaxTransfers} connections, the most it takes, and ") +
            "leaves this one out. Disable another and enable this again.";

        static string FullProblem(FluidSimulation fluid, int waiting) => waiting == 0 ? null
            : Invariant($"{waiting:N0} particles wait to flow into '{fluid.name}', whose capacity of {fluid.Capacity:N0} is full. Raise ") +
            "its capacity, or let its water flow off.";
    }
}
