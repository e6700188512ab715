using System;
using Unity.Mathematics;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    // A box that is put elsewhere and leaves the water where it is: some leaves the box, and another fluid may take it.
    public sealed partial class FluidSimulation
    {
        [NonSerialized] FluidSimulation handedOverTo;       // the last one, for what is logged of it
        [NonSerialized] bool saidHandOverFull;

        /// <summary>After a running fluid's box was moved and has left the water: by how much that has moved in the box, d.</summary>
        internal event Action<Vector3> Recentered;

        /// <summary>
        /// Moves the box, and leaves the water where it is in the world: for a box that follows a target. What then lies outside goes to
        /// another fluid, is removed and counts as drained, or is kept and comes back as the box covers its place again. Nothing is pushed,
        /// neither by the box nor by what moved in it in this frame. Foam begins again.
        /// </summary>
        /// <remarks>
        /// Memory stays that of the box, however large the world. Setting the transform instead takes the water along. The part of the box that
        /// is new is empty: <see cref="Fill(FluidShape, Vector3, int, float)"/> of the whole box fills it and leaves the rest as it is.
        /// What is handed over keeps place, velocity, phase and lifetime, and gets a new id. It does not look for room.
        /// </remarks>
        /// <param name="position">Of this object, world space, m.</param>
        /// <param name="leaving">What happens to particles that then lie outside. What was kept before comes back in any case.</param>
        /// <param name="handOverTo">The fluid that gets those of them that lie in its box, whatever its rotation; null for none. Where its
        /// capacity is full, or it does not run, the rest is removed or kept as the others.</param>
        /// <exception cref="ArgumentException">The position is not finite, or the other fluid is this one or differs in particle spacing,
        /// material or step rate.</exception>
        /// <exception cref="InvalidOperationException">The simulation is not running, though there is a graphics device, or this is called
        /// in a pass of <see cref="BeforeStep"/> of either fluid.</exception>
        public void Recenter(Vector3 position, LeavingParticles leaving = LeavingParticles.Remove, FluidSimulation handOverTo = null)
        {
            if (!math.all(math.isfinite((float3)position)))
                throw new ArgumentException(Invariant($"A box at {position} is nowhere: give finite numbers."), nameof(position));
            if (handOverTo != null && HandOverProblem(handOverTo) is string problem)
                throw new ArgumentException(problem, nameof(handOverTo));
            bool isRunning = IsReadyTo("moving its box"), handsOver = isRunning && handOverTo != null && handOverTo.CanTake();
            bool keeps = leaving == LeavingParticles.Keep, shifts = isRunning && (keeps || pbf.KeepsParticles);
            if (isRunning && !HasBesideSteps(Features.ParticleEdits) || (shifts || handsOver) && !HasBesideSteps(Features.Transfer))
                return;
            GetPose(out Vector3 before, out Quaternion rotation);
            transform.position = position;
            if (!isRunning)
                return;
            DropGhosts();
            RigidPose from = CornerAt(before, rotation), to = CornerAt(position, rotation);
            if (handsOver)
                HandOver(handOverTo, from, to, keeps);
            if (shifts)
                pbf.Shift(from, to, keptCapacity, keeps);
            else
                pbf.Shift((float3)(Quaternion.Inverse(rotation) * (before - position)) / particleSpacing);
            Recentered?.Invoke(Quaternion.Inverse(rotation) * (before - position) / particleSpacing);
            FollowTransform();
            StandStill();
            ClearMotions();
        }

        /// <summary>Why a fluid cannot take particles of this one, with what to do; null where it can.</summary>
        internal string HandOverProblem(FluidSimulation other)
        {
            ConnectionFault fault = ConnectionFaults.Between(this, other);
            return fault == ConnectionFault.SameFluid ? $"FluidSimulation '{name}' cannot hand particles over to itself. Name another fluid."
                : ConnectionFaults.Describe(fault, this, other);
        }

        // Whether it runs, before another hands particles over.
        bool CanTake()
        {
            ThrowInPass("taking particles");
            StartAgainIfChanged();
            return pbf != null && playback == null;
        }

        void HandOver(FluidSimulation taker, in RigidPose from, in RigidPose to, bool keepsRest)
        {
            taker.DropGhosts();
            taker.GetPose(out Vector3 place, out Quaternion rotation);
            pbf.HandOver(taker.pbf, from, to, taker.CornerAt(place, rotation), keepsRest);
            handedOverTo = taker;
        }

        // After the steps of a frame.
        void ReadHandOver()
        {
            if (ReferenceEquals(handedOverTo, null))
                return;
            if (pbf.RefusedToHandOver > 0 && !saidHandOverFull)
            {
                saidHandOverFull = true;
                Debug.LogWarning($"Rill: FluidSimulation '{name}' {HandOverFullProblem}", this);
            }
            pbf.RequestTransferred();
        }

        string HandOverFullProblem => Invariant($"removed {pbf.RefusedToHandOver:N0} particles that its box left behind: the capacity ") +
            $"of '{(handedOverTo != null ? handedOverTo.name : "a fluid that is gone")}', which was to get them, is full. Raise it, or " +
            "keep them with LeavingParticles.Keep.";
    }
}
