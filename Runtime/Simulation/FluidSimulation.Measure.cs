using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    // Measuring at once, for tests and tools: it waits for the GPU.
    public sealed partial class FluidSimulation
    {
        /// <summary>Measures the state after the newest step now, and waits for the GPU: for tests and tools, not for games.</summary>
        /// <exception cref="InvalidOperationException">The fluid does not run, has taken no step yet, or is built without statistics.</exception>
        internal FluidStatistics MeasureNow()
        {
            if (pbf == null)
                throw new InvalidOperationException($"FluidSimulation '{name}' does not run, so there is nothing to measure: " +
                    $"{failure ?? "it is disabled. Enable it first."}");
            if (StepCount == 0)
                throw new InvalidOperationException($"FluidSimulation '{name}' has taken no step yet. Let a frame pass first.");
            if (IsRefused(DeviceFeature.Statistics) || !HasStages(StageSet.Statistics))
                throw new InvalidOperationException($"FluidSimulation '{name}' cannot be measured: its statistics are not in this " +
                    $"build or not for this device. Set Shaders In Build to All Features.");
            AsyncGPUReadback.WaitAllRequests();     // one that is pending is of an older state
            commands.Clear();
            pbf.RecordStatistics(commands, input);
            Graphics.ExecuteCommandBuffer(commands);
            pbf.RequestStatistics();
            AsyncGPUReadback.WaitAllRequests();
            if (!TryGetStatistics(out FluidStatistics statistics))
                throw new InvalidOperationException($"The measurement of FluidSimulation '{name}' did not come back.");
            return statistics;
        }

        /// <summary>Particles that are furthest beyond the walls or inside colliders, as the newest measurement found them, the furthest
        /// first. Waits for the GPU.</summary>
        /// <returns>Id, position in the box's frame, m, and how far it is out, m.</returns>
        internal List<(uint id, float3 position, float outside)> FindFurthestOut(int most)
        {
            var counters = new uint[ParticleBuffers.CounterCount];
            pbf.Counters.GetData(counters);
            int count = (int)counters[(int)ParticleCounter.Alive];
            var positions = new float4[count];
            var ids = new uint[count];
            float[] distances = null;
            pbf.Positions.GetData(positions, 0, 0, count);
            pbf.ParticleIds.GetData(ids, 0, 0, count);
            if (pbf.Colliders != null)
            {
                distances = new float[count];
                pbf.Colliders.Distances.GetData(distances, 0, 0, count);
            }
            var found = new List<(uint id, float3 position, float outside)>();
            for (int i = 0; i < count; i++)
            {
                float3 p = positions[i].xyz;
                float outside = math.cmax(math.max(Rill.Colliders.ContactOffset - p, p - (pbf.Layout.DomainSize - Rill.Colliders.ContactOffset)));
                if (distances != null)
                    outside = math.max(outside, Rill.Colliders.ContactOffset - distances[i]);
                if (outside > StatisticsPass.EscapedBeyond)
                    found.Add((ids[i], p * particleSpacing, outside * particleSpacing));
            }
            found.Sort((a, b) => b.outside.CompareTo(a.outside));
            return found.Count > most ? found.GetRange(0, most) : found;
        }
    }
}
