using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>Where two boxes overlap, whose side of it is whose, and whether the fluids in them have met.</summary>
    sealed class FluidConnectionState
    {
        const float SameAngle = 0.1f;       // degrees
        const float SameFraction = 1e-4f;
        const float MinOpening = 2f;        // d, across
        const float CoverTolerance = 0.5f;      // d: of a face that a box covers, what it may leave

        PbfSolver one, other;
        int oneGeneration, otherGeneration;

        /// <summary>The fluids have not met.</summary>
        public void Close()
        {
            one = other = null;
            TakenInFrame = -1;
        }

        /// <summary>Number of the frame in which one last took for both.</summary>
        public int TakenInFrame { get; set; } = -1;

        /// <summary>Before a step of either: parts what both were filled with, where they have not met or one began again.</summary>
        public void Meet(FluidSimulation a, FluidSimulation b, in TransferRegion toA, in TransferRegion toB)
        {
            if (one == b.Solver)
            {
                Meet(b, a, toB, toA);
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

        /// <summary>What goes from one fluid to another, whose boxes overlap as <see cref="ProblemOf"/> asks.</summary>
        public static TransferRegion RegionOf(FluidSimulation from, FluidSimulation to)
        {
            TryFindOverlap(from, to, out TransferRegion region, out _, out _);
            return region;
        }

        /// <summary>Why nothing can flow between two fluids, with what to do; null where it can.</summary>
        public static string ProblemOf(FluidSimulation a, FluidSimulation b)
        {
            if (a == null || b == null)
                return "it has no two fluids. Set First and Second.";
            if (a == b)
                return $"both ends are '{a.name}'. Set First and Second to two fluids.";
            if (math.abs(a.ParticleSpacing - b.ParticleSpacing) > SameFraction * a.ParticleSpacing)
                return $"'{a.name}' has a particle spacing of {a.ParticleSpacing} m and '{b.name}' one of {b.ParticleSpacing} m. Make them equal.";
            if (!StructBytes.AreSame(a.Material, b.Material))
                return $"'{a.name}' and '{b.name}' have different materials. Make them equal.";
            if (a.StepRate != b.StepRate)
                return $"'{a.name}' takes {a.StepRate} steps a second and '{b.name}' {b.StepRate}. Make their Step Rates equal.";
            if (Quaternion.Angle(a.transform.rotation, b.transform.rotation) > SameAngle)
                return $"'{a.name}' and '{b.name}' are turned differently. Give both the same rotation.";
            if (TryFindOverlap(a, b, out _, out int axis, out float overlap))
                return null;
            float d = a.ParticleSpacing;
            if (axis < 0)
                return $"the boxes of '{a.name}' and '{b.name}' have no end in each other. Put them one behind the other, and let them " +
                    $"overlap by {8f * d:0.###} m.";
            return $"the boxes of '{a.name}' and '{b.name}' overlap by {math.max(overlap, 0f) * d:0.###} m along {"xyz"[axis]}, less than " +
                $"{FluidConnection.MinOverlap:0} spacings of {d} m. Let them overlap by {8f * d:0.###} m.";
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
                float middle = 0.5f * (low[a] + high[a]);
                region.plane = 0f;
                region.plane[a] = isBefore ? 1f : -1f;
                region.plane.w = isBefore ? middle : -middle;
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
