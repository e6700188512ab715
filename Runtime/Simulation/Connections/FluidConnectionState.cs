using Unity.Mathematics;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>The overlap of two boxes, the side of it that each fluid owns, and whether the fluids have met.</summary>
    sealed class FluidConnectionState
    {
        const float SameAngle = 0.1f;       // degrees
        const float MinOpening = 2f;        // d, across
        const float CoverTolerance = 0.5f;      // d: of a face that a box covers, what it may leave

        PbfSolver one, other;
        int oneGeneration, otherGeneration, lookedInFrame = -1;
        TransferRegion toFirst, toSecond;

        /// <summary>The fluids have not met.</summary>
        public void Close()
        {
            one = other = null;
            TakenInFrame = lookedInFrame = -1;
        }

        /// <summary>Number of the frame in which one last took for both.</summary>
        public int TakenInFrame { get; set; } = -1;

        /// <summary>Before a step of either: parts what both were filled with, where they have not met or one began again.</summary>
        public void PrepareExchange(FluidSimulation a, FluidSimulation b, in TransferRegion toA, in TransferRegion toB)
        {
            if (one == b.Solver)
            {
                PrepareExchange(b, a, toB, toA);
                return;
            }
            bool hasMet = one == a.Solver && other == b.Solver && oneGeneration == one.Generation && otherGeneration == other.Generation;
            if (hasMet)
                return;
            one = a.Solver;
            other = b.Solver;
            if (!one.IsRestored && !other.IsRestored)       // what was saved was parted
                PbfSolver.PartFrom(one, toA, other, toB);
            oneGeneration = one.Generation;
            otherGeneration = other.Generation;
        }

        /// <summary>The particles of a solver are another's from here on.</summary>
        public void Continue(PbfSolver before, PbfSolver next)
        {
            if (one == before)
                (one, oneGeneration) = (next, next.Generation);
            else if (other == before)
                (other, otherGeneration) = (next, next.Generation);
        }

        /// <summary>Looks at two fluids where it has not in this frame.</summary>
        public void Look(FluidSimulation first, FluidSimulation second)
        {
            if (lookedInFrame == Time.frameCount)
                return;
            lookedInFrame = Time.frameCount;
            Fault = FaultBetween(first, second, out toFirst, out toSecond);
        }

        /// <summary>Fault that keeps the fluids apart, as last looked at.</summary>
        public ConnectionFault Fault { get; private set; }

        /// <summary>Region whose particles go to the first fluid or to the second, where nothing keeps them apart.</summary>
        public TransferRegion RegionTo(bool isFirst) => isFirst ? toFirst : toSecond;

        /// <summary>Returns the fault that keeps two fluids apart now.</summary>
        public static ConnectionFault FaultBetween(FluidSimulation a, FluidSimulation b)
            => FaultBetween(a, b, out _, out _);

        /// <summary>A fault in words, with what to do; null for none.</summary>
        public static string Describe(ConnectionFault fault, FluidSimulation a, FluidSimulation b)
        {
            if (fault != ConnectionFault.NoEnd && fault != ConnectionFault.SmallOverlap)
                return ConnectionFaults.Describe(fault, a, b);
            TryFindOverlap(a, b, out _, out int axis, out float overlap);
            float d = a.ParticleSpacing;
            if (axis < 0)
                return $"the boxes of '{a.name}' and '{b.name}' have no end in each other. Put them one behind the other, and let them " +
                    Invariant($"overlap by {8f * d:0.###} m.");
            return Invariant($"the boxes of '{a.name}' and '{b.name}' overlap by {math.max(overlap, 0f) * d:0.###} m along ") +
                Invariant($"{"xyz"[axis]}, less than {FluidConnection.MinOverlap:0} spacings of {d} m. Let them overlap by ") +
                Invariant($"{8f * d:0.###} m.");
        }

        static ConnectionFault FaultBetween(FluidSimulation a, FluidSimulation b, out TransferRegion toA, out TransferRegion toB)
        {
            toA = toB = default;
            ConnectionFault fault = ConnectionFaults.Between(a, b);
            if (fault != ConnectionFault.None)
                return fault;
            if (Quaternion.Angle(a.transform.rotation, b.transform.rotation) > SameAngle)
                return ConnectionFault.Rotations;
            if (TryFindOverlap(a, b, out toB, out int axis, out _) && TryFindOverlap(b, a, out toA, out _, out _))
                return ConnectionFault.None;
            return axis < 0 ? ConnectionFault.NoEnd : ConnectionFault.SmallOverlap;
        }

        // Along the axis on which each box ends in the other, the one of the smallest overlap.
        static bool TryFindOverlap(FluidSimulation from, FluidSimulation to, out TransferRegion region, out int axis, out float overlap)
        {
            float d = to.ParticleSpacing;
            Quaternion toTaker = Quaternion.Inverse(to.transform.rotation);
            float3 size = (float3)to.DomainSize / d, fromSize = (float3)from.DomainSize / d;
            float3 offset = (float3)(toTaker * (from.transform.position - to.transform.position)) / d + 0.5f * (size - fromSize);
            float3 low = math.max(offset, 0f), high = math.min(offset + fromSize, size);
            region = new TransferRegion { offset = offset, rotation = quaternion.identity, size = size };
            axis = -1;
            overlap = float.MaxValue;
            for (int a = 0; a < 3; a++)
            {
                bool isBefore = offset[a] < -0.5f && offset[a] + fromSize[a] < size[a] - 0.5f;
                bool isBehind = offset[a] > 0.5f && offset[a] + fromSize[a] > size[a] + 0.5f;
                float depth = high[a] - low[a];
                if (!isBefore && !isBehind || depth >= overlap)
                    continue;
                axis = a;
                overlap = depth;
                float center = 0.5f * (low[a] + high[a]);
                region.plane = 0f;
                region.plane[a] = isBefore ? 1f : -1f;
                region.plane.w = isBefore ? center : -center;
            }
            if (axis < 0 || overlap < FluidConnection.MinOverlap - 1e-3f)
                return false;
            float3 opening = high - low;
            opening[axis] = MinOpening;
            bool isCovered = true;
            for (int a = 0; a < 3; a++)
                isCovered &= a == axis || size[a] - opening[a] < CoverTolerance;
            region.openFaces = isCovered ? 1u << 2 * axis + (region.plane[axis] < 0f ? 1 : 0) : 0u;
            return math.all(opening >= MinOpening - 1e-3f);
        }
    }
}
