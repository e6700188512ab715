using System;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Fills a fluid with the particles of its volumes as it begins: from world space into the domain's frame.</summary>
    sealed class VolumeFilling
    {
        readonly FluidSimulation fluid;

        public VolumeFilling(FluidSimulation fluid) => this.fluid = fluid;

        /// <summary>Gives the solver the particles of all volumes on the fluid's object and its children.</summary>
        public void UploadVolumes()
        {
            long filled = 0;
            foreach (FluidVolume volume in fluid.GetComponentsInChildren<FluidVolume>())
                filled += UploadVolume(volume);
            if (filled > 0)
                fluid.Solver.LeaveOutCovered();
            if (filled > fluid.Capacity)
                Debug.LogWarning(Invariant($"Rill: FluidSimulation '{fluid.name}' refused {filled - fluid.Capacity:N0} of {filled:N0} particles ") +
                    Invariant($"of its volumes: the capacity is {fluid.Capacity:N0}. Raise it, shrink the volumes or raise the particle ") +
                    "spacing.", fluid);
        }

        /// <summary>Returns the particles of a volume as this fluid begins with them, in the domain's frame, in spacings; the caller disposes
        /// the array.</summary>
        /// <param name="inside">How many lie in the box: they come first, from <paramref name="low"/> to <paramref name="high"/>.</param>
        /// <exception cref="ArgumentException">The volume cannot be filled; the message says why.</exception>
        public NativeArray<float4> PositionsOf(FluidVolume volume, out int inside, out float3 low, out float3 high)
        {
            NativeArray<float4> positions = volume.CreatePositions(fluid.ParticleSpacing, fluid.Seed);
            inside = MoveInside(positions.AsSpan(), out low, out high);
            return positions;
        }

        /// <summary>Takes positions from world space into the domain's frame, in spacings. Those in the box come first, from low to
        /// high.</summary>
        /// <returns>Number of those in the box.</returns>
        public int MoveInside(Span<float4> positions, out float3 low, out float3 high)
        {
            low = float.MaxValue;
            high = float.MinValue;
            fluid.GetPose(out Vector3 position, out Quaternion rotation);
            Quaternion toDomain = Quaternion.Inverse(rotation);
            float3 size = fluid.DomainSize;
            int inside = 0;
            foreach (float4 world in positions)
            {
                float3 local = ToDomain(world.xyz, position, toDomain);
                if (math.any(local < 0f) || math.any(local > size))
                    continue;
                float4 scaled = new float4(local, 0f) / fluid.ParticleSpacing;
                positions[inside++] = scaled;
                low = math.min(low, scaled.xyz);
                high = math.max(high, scaled.xyz);
            }
            return inside;
        }

        /// <summary>Returns a point in the domain's frame, m.</summary>
        /// <param name="world">World space, m.</param>
        /// <param name="position">Position of the box, world space, m.</param>
        /// <param name="toDomain">Inverse of its rotation.</param>
        public float3 ToDomain(float3 world, Vector3 position, Quaternion toDomain)
            => (float3)(toDomain * ((Vector3)world - position)) + (float3)fluid.DomainSize * 0.5f;

        /// <summary>Returns a sentence for a scale that moves a volume, or enlarges its field, but not the domain; empty where there is
        /// none.</summary>
        public string ScaleBetween(FluidVolume volume)
        {
            bool isField = volume.Shape == VolumeShape.SignedDistanceField, acts = isField;
            Transform own = volume.transform, scaled = null;
            Vector3 unscaled = Vector3.zero;
            for (Transform at = own; at != null; at = at.parent)
            {
                if (scaled == null && (at != own || isField) && math.cmax(math.abs((float3)at.localScale - 1f)) > 1e-3f)
                    scaled = at;
                if (at == fluid.transform)
                {
                    fluid.GetPose(out Vector3 position, out Quaternion rotation);
                    float moved = Vector3.Distance(unscaled, Quaternion.Inverse(rotation) * (own.position - position));
                    acts |= moved > 0.5f * fluid.ParticleSpacing;
                }
                unscaled = at.localRotation * unscaled + at.localPosition;
            }
            return scaled == null || !acts ? "" : Invariant($"The scale {scaled.localScale} of '{scaled.name}' moves what lies below ") +
                "it, and enlarges fields, but neither the domain nor boxes and spheres, whose sizes are in meters: set it to 1. ";
        }

        // Returns the particles that it gave to the solver.
        int UploadVolume(FluidVolume volume)
        {
            NativeArray<float4> positions = default;
            try
            {
                positions = PositionsOf(volume, out int inside, out float3 low, out float3 high);
                if (inside < positions.Length)
                    Debug.LogWarning(Invariant($"Rill: {positions.Length - inside:N0} of {positions.Length:N0} particles of FluidVolume ") +
                        Invariant($"'{volume.name}' lie outside the domain of '{fluid.name}', {fluid.DomainSize} m around ") +
                        Invariant($"{fluid.transform.position}, and were left out. ") +
                        $"{ScaleBetween(volume)}Move or shrink the volume, or enlarge the domain.", volume);
                if (inside > 0)
                    Upload(positions.GetSubArray(0, inside), volume.Velocity, low, high,
                        fluid.Solver.TagFor(fluid.Phases.PhaseOf(volume.Material), 0));
                return inside;
            }
            catch (ArgumentException problem)
            {
                Debug.LogError($"Rill: FluidVolume '{volume.name}' was not filled: {problem.Message}", volume);
                return 0;
            }
            finally
            {
                if (positions.IsCreated)
                    positions.Dispose();
            }
        }

        // Particles in the domain's frame, in spacings, all with one velocity in world space, m/s.
        void Upload(NativeArray<float4> positions, Vector3 velocity, float3 low, float3 high, uint tag)
        {
            fluid.GetPose(out _, out Quaternion rotation);
            float4 local = new float4((float3)(Quaternion.Inverse(rotation) * velocity), 0f) / fluid.ParticleSpacing;
            using (var shared = new NativeArray<float4>(1, Allocator.Persistent))
            {
                shared.AsSpan()[0] = local;
                fluid.Solver.AddInSpacings(positions, shared, low, high, tag);
            }
        }
    }
}
