using System;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    // Filling: from world space into the domain's frame.
    public sealed partial class FluidSimulation
    {
        void FillVolumes()
        {
            long filled = 0;
            foreach (FluidVolume volume in GetComponentsInChildren<FluidVolume>())
                filled += Fill(volume);
            if (filled > 0)
                pbf.LeaveOutCovered();
            if (filled > capacity)
                Debug.LogWarning(Invariant($"Rill: FluidSimulation '{name}' refused {filled - capacity:N0} of {filled:N0} particles of ") +
                    Invariant($"its volumes: the capacity is {capacity:N0}. Raise it, shrink the volumes or raise the particle ") +
                    "spacing.", this);
        }

        // Returns the particles that it gave to the solver.
        int Fill(FluidVolume volume)
        {
            NativeArray<float4> positions = default;
            try
            {
                positions = PositionsOf(volume, out int inside, out float3 low, out float3 high);
                if (inside < positions.Length)
                    Debug.LogWarning(Invariant($"Rill: {positions.Length - inside:N0} of {positions.Length:N0} particles of FluidVolume ") +
                        Invariant($"'{volume.name}' lie outside the domain of '{name}', {domainSize} m around {transform.position}, and ") +
                        $"were left out. {ScaleBetween(volume)}Move or shrink the volume, or enlarge the domain.", volume);
                if (inside > 0)
                    Add(positions.GetSubArray(0, inside), volume.Velocity, low, high);
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

        /// <summary>The particles of a volume as this fluid begins with them, in the domain's frame, in spacings; the caller disposes the
        /// array.</summary>
        /// <param name="inside">How many lie in the box: they come first, from <paramref name="low"/> to <paramref name="high"/>.</param>
        /// <exception cref="ArgumentException">The volume cannot be filled; the message says why.</exception>
        internal NativeArray<float4> PositionsOf(FluidVolume volume, out int inside, out float3 low, out float3 high)
        {
            NativeArray<float4> positions = volume.Fill(particleSpacing, seed);
            inside = KeepInside(positions.AsSpan(), out low, out high);
            return positions;
        }

        // A sentence for a scale that moves a volume, or enlarges its field, but not the domain; empty where there is none.
        string ScaleBetween(FluidVolume volume)
        {
            bool isField = volume.Shape == VolumeShape.SignedDistanceField, acts = isField;
            Transform own = volume.transform, scaled = null;
            Vector3 unscaled = Vector3.zero;
            for (Transform at = own; at != null; at = at.parent)
            {
                if (scaled == null && (at != own || isField) && math.cmax(math.abs((float3)at.localScale - 1f)) > 1e-3f)
                    scaled = at;
                if (at == transform)
                {
                    GetPose(out Vector3 place, out Quaternion rotation);
                    float moved = Vector3.Distance(unscaled, Quaternion.Inverse(rotation) * (own.position - place));
                    acts |= moved > 0.5f * particleSpacing;
                }
                unscaled = at.localRotation * unscaled + at.localPosition;
            }
            return scaled == null || !acts ? "" : Invariant($"The scale {scaled.localScale} of '{scaled.name}' moves what lies below ") +
                "it, and enlarges fields, but neither the domain nor boxes and spheres, whose sizes are in meters: set it to 1. ";
        }

        // From world space into the domain's frame, in spacings; those in the box come first, from low to high.
        int KeepInside(Span<float4> positions, out float3 low, out float3 high)
        {
            low = float.MaxValue;
            high = float.MinValue;
            GetPose(out Vector3 place, out Quaternion rotation);
            Quaternion toDomain = Quaternion.Inverse(rotation);
            float3 size = domainSize;
            int inside = 0;
            foreach (float4 position in positions)
            {
                float3 local = ToDomain(position.xyz, place, toDomain);
                if (math.any(local < 0f) || math.any(local > size))
                    continue;
                float4 scaled = new float4(local, 0f) / particleSpacing;
                positions[inside++] = scaled;
                low = math.min(low, scaled.xyz);
                high = math.max(high, scaled.xyz);
            }
            return inside;
        }

        // Particles in the domain's frame, in spacings, all with one velocity in world space, m/s.
        void Add(NativeArray<float4> positions, Vector3 velocity, float3 low, float3 high)
        {
            GetPose(out _, out Quaternion rotation);
            float4 local = new float4((float3)(Quaternion.Inverse(rotation) * velocity), 0f) / particleSpacing;
            using (var shared = new NativeArray<float4>(1, Allocator.Persistent))
            {
                shared.AsSpan()[0] = local;
                pbf.AddInSpacings(positions, shared, low, high);
            }
        }

        float3 ToDomain(float3 world, Vector3 place, Quaternion toDomain)
        {
            return (float3)(toDomain * ((Vector3)world - place)) + (float3)domainSize * 0.5f;
        }
    }
}
