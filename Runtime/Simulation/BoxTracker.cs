using Unity.Mathematics;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Knows where the box of a fluid is, how it has moved since the last steps, and where it was before a teleport.</summary>
    /// <remarks>The box is at the fluid's object, or stays at its last finite pose while the transform is not finite.</remarks>
    sealed class BoxTracker
    {
        readonly FluidSimulation fluid;

        Vector3 validPosition;                              // of the last finite pose
        Quaternion validRotation = Quaternion.identity;
        bool waitsForPose;          // the fluid could not begin without one
        float3 lastPosition, lastVelocity;
        float lastDuration;         // in which the box had that velocity, s; 0 where the velocity is not known
        bool hasLastPosition;       // whether the box came from its last position
        DomainFrame collectedFrame;     // where the box was in the last steps
        bool isTeleported;              // since the last steps

        public BoxTracker(FluidSimulation fluid) => this.fluid = fluid;

        /// <summary>Whether the transform is not finite, so that the box stays where it last was.</summary>
        public bool IsPoseLost { get; private set; }

        /// <summary>Velocity of the box since the last steps, world space, m/s.</summary>
        public Vector3 Velocity => lastVelocity;

        /// <summary>Sum of the displacements of all teleports, m: a position that was measured before one is now this much further on.</summary>
        public Vector3 WorldShift { get; private set; }

        public DomainFrame Frame
        {
            get
            {
                GetPose(out Vector3 position, out Quaternion rotation);
                return new DomainFrame(position, rotation, fluid.DomainSize, fluid.ParticleSpacing);
            }
        }

        /// <summary>Position and rotation of the fluid's object; the last finite ones while a component of them is not finite.</summary>
        public void GetPose(out Vector3 position, out Quaternion rotation)
        {
            position = fluid.transform.position;
            rotation = fluid.transform.rotation;
            if (Limit.IsPose(position, rotation))
                return;
            position = validPosition;
            rotation = validRotation;
        }

        /// <summary>Whether there is a pose to begin at.</summary>
        /// <param name="problem">Says why not; null where there is one.</param>
        public bool TryBegin(out string problem)
        {
            problem = StartProblem;
            waitsForPose = problem != null;
            return !waitsForPose;
        }

        /// <summary>Whether the fluid could not begin for want of a pose, and there is one now.</summary>
        public bool CanBeginNow => waitsForPose && StartProblem == null;

        /// <summary>Remembers the pose of the transform for the time when it is not finite, which is logged once for as long as it lasts.</summary>
        /// <returns>Whether the box has a pose, and had one before.</returns>
        public bool Follow()
        {
            bool wasLost = IsPoseLost;
            Vector3 position = fluid.transform.position;
            Quaternion rotation = fluid.transform.rotation;
            IsPoseLost = !Limit.IsPose(position, rotation);
            if (!IsPoseLost)
            {
                validPosition = position;
                validRotation = rotation;
            }
            else if (!wasLost)
            {
                Debug.LogError($"Rill: FluidSimulation '{fluid.name}': {LostPoseProblem}", fluid);
            }
            return !IsPoseLost && !wasLost;
        }

        /// <summary>Takes the box to where it is now, and returns its acceleration since the last steps, m/s²: 0 until its velocity is known.
        /// A box that moves as time goes on, or as the fluid begins, does not come from rest.</summary>
        /// <param name="duration">Time in which the box moved, s.</param>
        public float3 Accelerate(float3 position, float duration)
        {
            float3 acceleration = 0f;
            if (hasLastPosition)
            {
                float3 velocity = (position - lastPosition) / duration;
                if (lastDuration > 0f)      // each velocity is that at the center of its time
                    acceleration = (velocity - lastVelocity) / (0.5f * (lastDuration + duration));
                lastVelocity = velocity;
                lastDuration = duration;
            }
            lastPosition = position;
            hasLastPosition = true;
            return acceleration;
        }

        /// <summary>Begins at rest: how the box came to its present position does not push the fluid.</summary>
        public void ResetMotion()
        {
            GetPose(out Vector3 position, out _);
            lastPosition = position;
            lastVelocity = 0f;
            lastDuration = 0f;
            hasLastPosition = false;
        }

        /// <summary>Remembers where the box is in the steps of this frame.</summary>
        public void MarkSteps()
        {
            collectedFrame = Frame;
            isTeleported = false;
        }

        /// <summary>Takes the box to where the transform was put, with all that it holds. Does nothing while the pose is invalid, or was
        /// before.</summary>
        public void Teleport()
        {
            RigidPose before = ValidCorner;
            if (!Follow())
                return;
            WorldShift += (Vector3)(ValidCorner.position - before.position);
            hasLastPosition = false;
            isTeleported = true;
            fluid.Solver?.TeleportOutside(before, ValidCorner);
        }

        /// <summary>Whether an object that was at one pose in the box after the last steps, and is at another now, went along with the box:
        /// always, unless the box was teleported and the object stayed where it was in the world.</summary>
        public bool WentAlong(in RigidPose last, in RigidPose now)
        {
            if (!isTeleported)
                return true;
            RigidPose world = collectedFrame.World(last);
            RigidPose stayed = Frame.Pose(world.position, world.rotation);
            float reach = 0.5f * ((Vector3)fluid.Solver.Layout.DomainSize).magnitude;
            return RigidPose.Distance(now, last, reach) <= RigidPose.Distance(now, stayed, reach);
        }

        /// <summary>Returns where a pose that went along with the box is now; world space, m, after the last steps.</summary>
        public RigidPose Teleported(in RigidPose world)
            => isTeleported ? Frame.World(collectedFrame.Pose(world.position, world.rotation)) : world;

        /// <summary>The lowest corner of the box at a pose.</summary>
        public RigidPose CornerAt(Vector3 position, Quaternion rotation)
            => new RigidPose(position - rotation * (fluid.DomainSize * 0.5f), rotation);

        RigidPose ValidCorner => CornerAt(validPosition, validRotation);

        /// <summary>Why the fluid has no pose to begin at; null where it has one.</summary>
        public string StartProblem
        {
            get
            {
                Transform transform = fluid.transform;
                return Limit.IsPose(transform.position, transform.rotation) ? null
                    : Invariant($"its transform is not finite (position {transform.position}, rotation {transform.rotation}). Set position and ") +
                    "rotation to numbers.";
            }
        }

        /// <summary>Why the box does not follow the transform, for while <see cref="IsPoseLost"/>.</summary>
        public string LostPoseProblem
            => Invariant($"its transform is not finite (position {fluid.transform.position}, rotation ") +
            Invariant($"{fluid.transform.rotation}). The fluid goes on where it last was, at {validPosition}. Set position, rotation and scale of ") +
            "this object and its parents to numbers that multiply to a finite pose.";

        /// <summary>Puts into a snapshot how the box came to where it is.</summary>
        public void Save(ref TimeRecord to)
        {
            GetPose(out Vector3 position, out Quaternion rotation);
            to.box = new PoseRecord(new RigidPose(position, rotation));
            to.lastPosition = lastPosition;
            to.lastVelocity = lastVelocity;
            to.lastDuration = lastDuration;
        }

        /// <summary>Puts into a snapshot what calls of scripts have changed since the last steps.</summary>
        public void Save(ref CallsRecord to)
        {
            to.collected = isTeleported ? new PoseRecord(collectedFrame.Box) : default;
            to.flags = (hasLastPosition ? CallsRecord.PositionIsKnown : 0) | (isTeleported ? CallsRecord.IsTeleported : 0);
        }

        /// <summary>Goes on as in a snapshot where the box is where it was.</summary>
        /// <param name="tolerance">Distance within which it is, m.</param>
        /// <returns>Whether it is.</returns>
        public bool TryLoad(in TimeRecord from, float tolerance)
        {
            GetPose(out Vector3 position, out Quaternion rotation);
            isTeleported = false;
            if (!from.box.IsAt(new RigidPose(position, rotation), tolerance))
                return false;
            lastPosition = from.lastPosition;
            lastVelocity = from.lastVelocity;
            lastDuration = from.lastDuration;
            hasLastPosition = lastDuration > 0f;
            return true;
        }

        /// <summary>Takes what calls of scripts had changed out of a snapshot.</summary>
        public void Load(in CallsRecord from)
        {
            hasLastPosition = (from.flags & CallsRecord.PositionIsKnown) != 0;
            isTeleported = (from.flags & CallsRecord.IsTeleported) != 0;
            if (isTeleported)
                collectedFrame = new DomainFrame(from.collected.position, from.collected.Pose.rotation, fluid.DomainSize, fluid.ParticleSpacing);
        }
    }
}
