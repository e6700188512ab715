using System;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    // Filling: from world space into the domain's frame.
    public sealed partial class FluidSimulation
    {
        /// <summary>
        /// Adds particles at once. Those beyond the capacity are refused and counted in the statistics. Does nothing in a player
        /// without a graphics device, as on a dedicated server.
        /// </summary>
        /// <param name="positions">World space, m.</param>
        /// <param name="velocities">World space, m/s; as many as positions.</param>
        /// <exception cref="InvalidOperationException">The simulation is not running, though there is a graphics device.</exception>
        /// <exception cref="ArgumentException">Unequal lengths.</exception>
        public void AddParticles(NativeArray<float3> positions, NativeArray<float3> velocities)
        {
            if (positions.Length != velocities.Length)
                throw new ArgumentException($"{positions.Length:N0} positions with {velocities.Length:N0} velocities: give each particle both.");
            if (pbf == null && HasNoGraphics)
                return;
            if (pbf == null)
                throw new InvalidOperationException($"FluidSimulation '{name}' is not running: enable it before adding particles.");

            GetPose(out Vector3 place, out Quaternion rotation);
            Quaternion toDomain = Quaternion.Inverse(rotation);
            using (var local = new NativeArray<float4>(positions.Length, Allocator.Persistent))
            using (var localVelocities = new NativeArray<float4>(positions.Length, Allocator.Persistent))
            {
                NativeArray<float4> to = local, velocitiesTo = localVelocities;
                for (int i = 0; i < positions.Length; i++)
                {
                    to[i] = new float4(ToDomain(positions[i], place, toDomain), 0f);
                    velocitiesTo[i] = new float4((float3)(toDomain * (Vector3)velocities[i]), 0f);
                }
                pbf.Add(local, localVelocities);
            }
        }

        void FillVolumes()
        {
            long filled = 0;
            foreach (FluidVolume volume in GetComponentsInChildren<FluidVolume>())
                filled += Fill(volume);
            if (filled > capacity)
                Debug.LogWarning($"Rill: FluidSimulation '{name}' refused {filled - capacity:N0} of {filled:N0} particles of its volumes: the capacity is {capacity:N0}. Raise it, shrink the volumes or raise the particle spacing.", this);
        }

        // Returns the particles that it gave to the solver.
        int Fill(FluidVolume volume)
        {
            NativeArray<float4> positions = default;
            try
            {
                positions = volume.Fill(particleSpacing, seed);
                int inside = KeepInside(positions.AsSpan(), out float3 low, out float3 high);
                if (inside < positions.Length)
                    Debug.LogWarning($"Rill: {positions.Length - inside:N0} of {positions.Length:N0} particles of FluidVolume '{volume.name}' lie outside the domain of '{name}' and were left out. Move or shrink the volume, or enlarge the domain.", volume);
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
