using System.Runtime.InteropServices;
using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    // Contents of a snapshot besides buffers, as they lie in its bytes: little endian, without gaps. A change of any is a new version.

    /// <summary>The solver's own numbers. Lengths in d.</summary>
    [StructLayout(LayoutKind.Sequential, Pack = 4)]
    struct SolverRecord
    {
        /// <summary>m.</summary>
        public float spacing;
        public float3 domainSize;
        public uint particles;
        /// <summary>Number of those that took part in the last step: the first.</summary>
        public uint moved;
        /// <summary>Particles at most, as far as is known without asking the GPU.</summary>
        public uint maxParticles;
        public uint stepIndex;
        public int lastSubsteps;
        public float3 minAdded, maxAdded;
        /// <summary>Flags: <see cref="HasNew"/>, <see cref="IsStart"/> and <see cref="HasMarked"/>.</summary>
        public uint flags;
        public uint hasLifetimes;

        /// <summary>Particles came after the last step.</summary>
        public const uint HasNew = 1;
        /// <summary>Particles of volumes may lie in colliders, since version 4.</summary>
        public const uint IsStart = 2;
        /// <summary>Particles are marked as removed that the next sort leaves out, since version 5.</summary>
        public const uint HasMarked = 4;
    }

    /// <summary>A <see cref="FixedStepClock"/>, s.</summary>
    [StructLayout(LayoutKind.Sequential, Pack = 4)]
    struct ClockRecord
    {
        public double accumulated, passing, dropped, frameInterval, lag, frameLag, lastFrameLag;
    }

    /// <summary>A pose; a rotation of length 0 is none.</summary>
    [StructLayout(LayoutKind.Sequential, Pack = 4)]
    struct PoseRecord
    {
        public float3 position;
        public float4 rotation;

        public PoseRecord(in RigidPose pose)
        {
            position = pose.position;
            rotation = pose.rotation.value;
        }

        public RigidPose Pose => new RigidPose(position, new quaternion(rotation));

        /// <summary>Whether an object is still where it was, but for rounding.</summary>
        /// <param name="distance">Up to which it is, in the unit of the positions.</param>
        public bool IsAt(in RigidPose pose, float distance)
        {
            return math.distance(position, pose.position) <= distance && math.abs(math.dot(rotation, pose.rotation.value)) >= 1f - 1e-6f;
        }

        public bool IsFinite => math.all(math.isfinite(position)) && math.all(math.isfinite(rotation));
    }

    /// <summary>The component's own numbers. World space, m.</summary>
    [StructLayout(LayoutKind.Sequential, Pack = 4)]
    struct TimeRecord
    {
        public int stepCount;
        /// <summary>s.</summary>
        public double fluidTime, lastFrameTime;
        public ClockRecord clock;
        /// <summary>Pose of the box as the snapshot was taken.</summary>
        public PoseRecord box;
        public float3 lastPosition, lastVelocity;
        public float lastDuration;
        public uint goneEmitters, goneDrains;
        public uint collidersJump;
    }

    /// <summary>State of <see cref="RestingRegions"/>: under what the water came to rest.</summary>
    [StructLayout(LayoutKind.Sequential, Pack = 4)]
    struct RestRecord
    {
        public float3 gravity;
        public float timeStep;
        /// <summary>Checksums of settings and material.</summary>
        public uint settings, material;
        public uint wake;
    }

    [StructLayout(LayoutKind.Sequential, Pack = 4)]
    struct CoarseRecord
    {
        /// <summary>d.</summary>
        public float wantedSize;
    }

    [StructLayout(LayoutKind.Sequential, Pack = 4)]
    struct ExtrapolationRecord
    {
        public float lastTimeStep, lastWeight;
    }

    /// <summary>How a part came to where it is, in the domain's frame, d.</summary>
    [StructLayout(LayoutKind.Sequential, Pack = 4)]
    struct PartRecord
    {
        public uint number;
        /// <summary>Pose as the snapshot was taken.</summary>
        public PoseRecord now;
        /// <summary>At the end of the last steps.</summary>
        public PoseRecord last;
        public uint follows;
    }

    [StructLayout(LayoutKind.Sequential, Pack = 4)]
    struct EmissionRecord
    {
        /// <summary>m³, s, particles.</summary>
        public double volume, time;
        public long due;
    }

    [StructLayout(LayoutKind.Sequential, Pack = 4)]
    struct EmitterRecord
    {
        public PartRecord part;
        public EmissionRecord clock;
        public uint isOn, saysLast;
    }

    [StructLayout(LayoutKind.Sequential, Pack = 4)]
    struct DrainRecord
    {
        public PartRecord part;
        /// <summary>m³.</summary>
        public double budget;
    }

    /// <summary>How a collider came to where it is, in the domain's frame, d.</summary>
    [StructLayout(LayoutKind.Sequential, Pack = 4)]
    struct ColliderRecord
    {
        public int shape;
        public float3 size;
        /// <summary>Pose as the snapshot was taken.</summary>
        public PoseRecord now;
        /// <summary>At the end of the last steps, and at their frame.</summary>
        public PoseRecord end, seen;
        /// <summary>Whether it had not jumped since.</summary>
        public uint follows;
    }

    /// <summary>Effects of scripts and frames since the last steps that are not a part of the water.</summary>
    [StructLayout(LayoutKind.Sequential, Pack = 4)]
    struct CallsRecord
    {
        /// <summary>s, see <see cref="FixedStepClock"/>.</summary>
        public double frameDropped;
        public int droppingFrames, sinceDrop;
        /// <summary>Pose of the box in the last steps, world space, m.</summary>
        public PoseRecord collected;
        /// <summary>Flags: <see cref="PositionIsKnown"/> and <see cref="IsTeleported"/>.</summary>
        public uint flags;
        /// <summary>Number of steps since the counts of emitters and drains were last requested.</summary>
        public int stepsSinceReadback;

        /// <summary>The box came from its last position.</summary>
        public const uint PositionIsKnown = 1;
        /// <summary>The box was teleported since the last steps.</summary>
        public const uint IsTeleported = 2;
    }

    /// <summary>State of <see cref="ColliderReactions"/> and of what waits for them.</summary>
    [StructLayout(LayoutKind.Sequential, Pack = 4)]
    struct ReactionsRecord
    {
        /// <summary>Fluid time of the sums and of what was asked for, s.</summary>
        public float time, takenTime;
        public uint hasWettedAreas;
        /// <summary>Number of frames after the snapshot in which the requested sums came; -1 if none were requested.</summary>
        public int frames;
        /// <summary>N s of a displacement of one particle by d.</summary>
        public double takenImpulse;
        /// <summary>Rotation of the domain, world space.</summary>
        public Quaternion takenRotation;
        /// <summary>How far the fluid was teleported since, m.</summary>
        public Vector3 shiftSince;
        public int takenStep;

        public const int NothingPending = -1;
    }

    /// <summary>A collider as it was when the sums were taken. World space, m.</summary>
    [StructLayout(LayoutKind.Sequential, Pack = 4)]
    struct TakenRecord
    {
        public RelativeMotion motion;
        public Vector3 position;
        /// <summary>d.</summary>
        public float arm;
    }
}
