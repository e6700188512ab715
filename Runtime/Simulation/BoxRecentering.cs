using System;
using Unity.Mathematics;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Moves the box of a fluid and leaves the water where it is. Particles that the box leaves behind are removed, handed over to
    /// another fluid, or kept outside the box.</summary>
    sealed class BoxRecentering
    {
        const int OutsideFull = 0, OutsideNotSaved = 1, TakerFull = 2;      // problems of the log

        readonly FluidSimulation fluid;
        FluidSimulation taker;      // the last fluid to which particles were handed over
        OnceLog log;

        public BoxRecentering(FluidSimulation fluid) => this.fluid = fluid;

        /// <summary>Raised after a running fluid's box was moved and has left the water: by how much that has moved in the box, d.</summary>
        public event Action<Vector3> Recentered;

        /// <summary>Why particles outside the box were removed; null where none was.</summary>
        public string OutsideProblem => fluid.Solver.OutsideOverflow > 0 ? OutsideFullProblem : null;

        /// <summary>Why particles that were to be handed over were removed; null where none was.</summary>
        public string TakerProblem => fluid.Solver.RefusedToHandOver > 0 ? TakerFullProblem : null;

        /// <summary>Moves the box.</summary>
        public void Recenter(Vector3 position, LeavingParticles leaving, FluidSimulation handOverTo)
        {
            if (!math.all(math.isfinite((float3)position)))
                throw new ArgumentException(Invariant($"A box at {position} is nowhere: give finite numbers."), nameof(position));
            if (handOverTo != null && HandOverProblem(handOverTo) is string problem)
                throw new ArgumentException(problem, nameof(handOverTo));
            bool isRunning = fluid.Editing.IsReadyTo("moving its box"),
                handsOver = isRunning && handOverTo != null && handOverTo.Editing.Recentering.CanTake();
            bool keeps = leaving == LeavingParticles.Keep, shifts = isRunning && (keeps || fluid.Solver.KeepsOutside);
            FeatureSupport support = fluid.Support;
            if (isRunning && !support.HasBesideSteps(Features.ParticleEdits) || (shifts || handsOver) && !support.HasBesideSteps(Features.Transfer))
                return;
            fluid.GetPose(out Vector3 before, out Quaternion rotation);
            fluid.transform.position = position;
            if (!isRunning)
                return;
            fluid.Inputs.Connections.DropGhosts();
            RigidPose from = fluid.Box.CornerAt(before, rotation), to = fluid.Box.CornerAt(position, rotation);
            if (handsOver)
                HandOver(handOverTo, from, to, keeps);
            if (shifts)
                fluid.Solver.Shift(from, to, fluid.KeptCapacity, keeps);
            else
                fluid.Solver.Shift((float3)(Quaternion.Inverse(rotation) * (before - position)) / fluid.ParticleSpacing);
            Recentered?.Invoke(Quaternion.Inverse(rotation) * (before - position) / fluid.ParticleSpacing);
            fluid.Box.Follow();
            fluid.ResetMotion();
        }

        /// <summary>Why a fluid cannot take particles of this one, with what to do; null where it can.</summary>
        public string HandOverProblem(FluidSimulation other)
        {
            ConnectionFault fault = ConnectionFaults.Between(fluid, other);
            return fault == ConnectionFault.SameFluid
                ? $"FluidSimulation '{fluid.name}' cannot hand particles over to itself. Name another fluid."
                : ConnectionFaults.Describe(fault, fluid, other);
        }

        /// <summary>Requests the numbers of particles outside and handed over, after the steps of a frame, and logs what the last ones
        /// mean.</summary>
        public void RequestCounts()
        {
            PbfSolver solver = fluid.Solver;
            if (solver.KeepsOutside)
            {
                if (solver.OutsideOverflow > 0 && log.ShouldLog(OutsideFull))
                    Debug.LogWarning($"Rill: FluidSimulation '{fluid.name}' {OutsideFullProblem}", fluid);
                solver.RequestTransferred();
            }
            if (!ReferenceEquals(taker, null))
            {
                if (solver.RefusedToHandOver > 0 && log.ShouldLog(TakerFull))
                    Debug.LogWarning($"Rill: FluidSimulation '{fluid.name}' {TakerFullProblem}", fluid);
                solver.RequestTransferred();
            }
        }

        /// <summary>Logs once that a snapshot leaves out the particles outside the box.</summary>
        public void LogNotSaved()
        {
            if (fluid.Solver.KeepsOutside && log.ShouldLog(OutsideNotSaved))
                Debug.LogWarning($"Rill: FluidSimulation '{fluid.name}' takes a snapshot without the particles that are kept outside its box. Put " +
                    $"the box where they are first, or fill that space after you restore it.", fluid);
        }

        // Whether the fluid runs, before another hands particles over.
        bool CanTake()
        {
            fluid.Steps.Passes.ThrowInPass("taking particles");
            fluid.BeginAgainIfChanged();
            return fluid.Solver != null && !fluid.IsPlayedBack;
        }

        void HandOver(FluidSimulation to, in RigidPose fromCorner, in RigidPose toCorner, bool keepsRest)
        {
            to.Inputs.Connections.DropGhosts();
            to.GetPose(out Vector3 position, out Quaternion rotation);
            fluid.Solver.HandOver(to.Solver, fromCorner, toCorner, to.Box.CornerAt(position, rotation), keepsRest);
            taker = to;
        }

        string OutsideFullProblem
            => Invariant($"removed {fluid.Solver.OutsideOverflow:N0} particles that its box left behind: its kept capacity of ") +
            Invariant($"{fluid.KeptCapacity:N0} is full. Raise it, or let the box move within a smaller region.");

        string TakerFullProblem
            => Invariant($"removed {fluid.Solver.RefusedToHandOver:N0} particles that its box left behind: the capacity ") +
            $"of '{(taker != null ? taker.name : "a fluid that is gone")}', which was to get them, is full. Raise it, or " +
            "keep them with LeavingParticles.Keep.";
    }
}
