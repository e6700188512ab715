using System.Collections.Generic;
using System.Runtime.InteropServices;
using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>A body that a fluid carries, in a snapshot.</summary>
    sealed class SnapshotBody
    {
        /// <summary>Names of the object and of those above it.</summary>
        public string path;
        /// <summary>Null in a snapshot that was read from bytes.</summary>
        public Component body;
        public BodyRecord record;
        /// <summary>The water around it; null where it was not asked for.</summary>
        public SnapshotWater water;
    }

    /// <summary>Queries and answers about the water around a body.</summary>
    sealed class SnapshotWater
    {
        /// <summary>Time for which no answer was needed, s.</summary>
        public float unneeded;
        /// <summary>World space, m.</summary>
        public readonly List<float3> points = new List<float3>();
        /// <summary>The newest that had come first, then those that were pending.</summary>
        public readonly List<SnapshotAnswer> answers = new List<SnapshotAnswer>();
    }

    /// <summary>An answer of the water.</summary>
    sealed class SnapshotAnswer
    {
        public QueryFrame frame;
        /// <summary>How far the fluid was teleported since, m.</summary>
        public Vector3 shiftSince;
        /// <summary>Number of frames after the snapshot in which it came; 0 if it had come before.</summary>
        public int frames;
        /// <summary>World space, m; w 1 outside the box.</summary>
        public float4[] points;
        public uint[] words;
    }

    /// <summary>Pose and motion of a body, what acts on it in the coming step, and what is known of the water. World space, m.</summary>
    [StructLayout(LayoutKind.Sequential, Pack = 4)]
    struct BodyRecord
    {
        public PoseRecord pose;
        /// <summary>Pose of its object, which lags a body that interpolates.</summary>
        public PoseRecord shown;
        public Vector3 velocity, angularVelocity, force, torque;
        /// <summary>Flags: <see cref="Sleeps"/> and so on.</summary>
        public uint flags;
        /// <summary>s.</summary>
        public float awaitedTime;
        public int heldFrames;
        public ResponseRecord response;

        public const uint Sleeps = 1, Awaits = 2, HasActed = 4;
        public const uint All = 2 * HasActed - 1;

        public bool Has(uint flag) => (flags & flag) != 0;
    }

    /// <summary>State of a <see cref="FloatingResponse"/> from step to step.</summary>
    [StructLayout(LayoutKind.Sequential, Pack = 4)]
    struct ResponseRecord
    {
        public SlipVelocity slip, angularSlip;
        public float memory, level, volume, wetVolume;
        public VirtualMassEstimate estimate;
        /// <summary>How far the fluid was teleported since, m.</summary>
        public Vector3 shiftSince;
        public uint levelIsKnown;
    }
}
