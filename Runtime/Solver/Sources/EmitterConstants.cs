using System.Runtime.InteropServices;
using Unity.Mathematics;

namespace Rill
{
    /// <summary>Constants of one emitter in a step that the kernels read; lengths in d, in the domain's frame.</summary>
    [GenerateHlsl("Emitters", ConstantBuffer = "RillEmitter")]
    [StructLayout(LayoutKind.Sequential)]
    struct EmitterConstants
    {
        const float PressMargin = 1f;       // d: how far a particle may be from where it was sorted

        /// <summary>at the end of the step, d</summary>
        public float3 origin;
        /// <summary>along each position's direction of flow, d/s</summary>
        public float speed;
        /// <summary>at its start, d</summary>
        public float3 lastOrigin;
        /// <summary>cosine of the largest angle from the direction of flow</summary>
        public float cosSpread;
        /// <summary>from the emitter's frame to the domain's, quaternion, at the end of the step; z points along the flow</summary>
        public float4 rotation;
        /// <summary>at its start, on the same side of the sphere</summary>
        public float4 lastRotation;
        /// <summary>what particles take along of the emitter's own, d/s</summary>
        public float3 velocity;
        /// <summary>of the first particle due, at the end of the step, s</summary>
        public float firstAge;
        /// <summary>the same of its angular velocity, rad/s</summary>
        public float3 spin;
        /// <summary>between two particles, s</summary>
        public float interval;
        /// <summary>of the whole step, s</summary>
        public float duration;
        /// <summary>number of its states</summary>
        public int emitter;
        /// <summary>particles due in this step</summary>
        public int due;
        /// <summary>number of the first of them</summary>
        public uint firstSerial;
        /// <summary>positions of the cross-section that are filled in turn</summary>
        public int layerPositions;
        /// <summary>all of them</summary>
        public int positionCount;
        /// <summary>positions tried, at most kMaxCandidates</summary>
        public int candidates;
        /// <summary>particles beyond that are given up</summary>
        public int maxWaiting;
        /// <summary>1: the positions fill a volume, 0: they are those of a cross-section</summary>
        public uint fills;
        /// <summary>1: another emitter has put particles nearby in this step</summary>
        public uint seesNew;
        /// <summary>1: it does nothing from here on</summary>
        public uint isLast;
        /// <summary>of the particles, see ParticleTags.hlsl</summary>
        public uint tag;
        /// <summary>half of what all positions take of the cross-section along x, d; of a round one its radius</summary>
        public float sectionX;
        /// <summary>half of it along y, d; 0: it is round</summary>
        public float sectionY;
        /// <summary>how far before the outlet it presses water away, d</summary>
        public float pressDepth;
        /// <summary>cells around what it presses away; 0: it never does</summary>
        public int pressCells;
        /// <summary>the lowest of them, along each axis</summary>
        public int4 pressFrom;
        /// <summary>how many along each axis</summary>
        public int4 pressCounts;

        /// <param name="step">Length of the step, s.</param>
        /// <param name="stepIndex">Number of the step since the reset.</param>
        public static EmitterConstants For(in EmitterStep emitter, float step, bool seesNew, uint stepIndex, SolverLayout layout)
        {
            float depth = emitter.PressDepth(step);
            int3 from = 0, counts = 0;
            if (depth > 0f)
                emitter.CellsBefore(layout, depth + emitter.speed * step + PressMargin, out from, out counts);
            float4 rotation = emitter.end.rotation.value, lastRotation = emitter.start.rotation.value;
            return new EmitterConstants
            {
                origin = emitter.end.position,
                speed = emitter.speed,
                lastOrigin = emitter.start.position,
                cosSpread = emitter.cosSpread,
                rotation = rotation,
                lastRotation = math.dot(rotation, lastRotation) < 0f ? -lastRotation : lastRotation,
                velocity = emitter.velocity,
                firstAge = emitter.firstAge,
                spin = emitter.spin,
                interval = emitter.interval,
                duration = step,
                emitter = emitter.number,
                due = emitter.due,
                firstSerial = emitter.firstSerial,
                layerPositions = emitter.layerPositions,
                positionCount = emitter.positions.Count,
                candidates = emitter.candidates,
                maxWaiting = emitter.maxWaiting,
                fills = emitter.positions.FillsVolume ? 1u : 0u,
                seesNew = seesNew ? 1u : 0u,
                isLast = emitter.isLast ? 1u : 0u,
                tag = emitter.TagIn(stepIndex),
                sectionX = emitter.positions.HalfSection.x,
                sectionY = emitter.positions.HalfSection.y,
                pressDepth = depth,
                pressCells = counts.x * counts.y * counts.z,
                pressFrom = new int4(from, 0),
                pressCounts = new int4(counts, 0),
            };
        }
    }
}
