using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;

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
            if (!Has(Features.Statistics))
                throw new InvalidOperationException($"FluidSimulation '{name}' cannot be measured: its statistics are not in this " +
                    $"build or not for this device. Set Shaders In Build to All Features.");
            pbf.CompleteStatistics();       // one that is pending is of an older state
            commands.Clear();
            pbf.RecordStatistics(commands, input);
            Graphics.ExecuteCommandBuffer(commands);
            pbf.RequestStatistics();
            pbf.CompleteStatistics();
            if (!TryGetStatistics(out FluidStatistics statistics))
                throw new InvalidOperationException(
                    $"FluidSimulation '{name}' cannot be measured: it {ReadbackErrors.Problem(ReadbackKinds.Statistics)}");
            return statistics;
        }

        /// <summary>Particles of the newest state by a measure, the least first; those without a finite one are left out. Waits for the
        /// GPU. Where colliders are in the box, after <see cref="MeasureNow"/>, which finds the distances from them.</summary>
        internal List<FoundParticle> FindParticles(int most, Func<FoundParticle, float> measure)
        {
            var counters = new uint[ParticleBuffers.CounterCount];
            pbf.Counters.GetData(counters);
            int count = (int)counters[(int)ParticleCounter.Alive];
            var positions = new float4[count];
            var velocities = new float4[count];
            var ids = new uint[count];
            float[] distances = null;
            pbf.Positions.GetData(positions, 0, 0, count);
            pbf.Velocities.GetData(velocities, 0, 0, count);
            pbf.ParticleIds.GetData(ids, 0, 0, count);
            if (pbf.Colliders != null)
            {
                distances = new float[count];
                pbf.Colliders.Distances.GetData(distances, 0, 0, count);
            }
            Matrix4x4 toWorld = DomainToWorld;
            var found = new List<FoundParticle>();
            for (int i = 0; i < count; i++)
            {
                float3 p = positions[i].xyz;
                float outside = math.cmax(math.max(Rill.Colliders.ContactOffset - p, p - (pbf.Layout.DomainSize - Rill.Colliders.ContactOffset)));
                if (distances != null)
                    outside = math.max(outside, Rill.Colliders.ContactOffset - distances[i]);
                var particle = new FoundParticle
                {
                    id = ids[i],
                    position = p * particleSpacing,
                    velocity = velocities[i].xyz * particleSpacing,
                    world = toWorld.MultiplyPoint3x4(p),
                    outside = outside * particleSpacing,
                };
                particle.measure = measure(particle);
                if (math.isfinite(particle.measure))
                    found.Add(particle);
            }
            found.Sort((a, b) => a.measure != b.measure ? a.measure.CompareTo(b.measure) : a.id.CompareTo(b.id));
            return found.Count > most ? found.GetRange(0, most) : found;
        }

        /// <summary>Emitters that gave particles up for want of room, as they count it now. Waits for the GPU.</summary>
        internal List<FluidPart> FindBlockedEmitters()
        {
            pbf.CompleteSourceCounts();     // one that is pending is of an older state
            pbf.RequestSourceCounts();
            pbf.CompleteSourceCounts();
            var blocked = new List<FluidPart>();
            foreach (FluidPart emitter in emitters)
                if (emitter != null && ((IEmitter)emitter).Blocked > 0)
                    blocked.Add(emitter);
            return blocked;
        }

        /// <summary>A particle that a message names.</summary>
        internal struct FoundParticle
        {
            public uint id;
            /// <summary>In the box's frame, m and m/s.</summary>
            public float3 position, velocity;
            /// <summary>World space, m.</summary>
            public float3 world;
            /// <summary>How far it is beyond walls or inside colliders, m.</summary>
            public float outside;
            /// <summary>By which it was found.</summary>
            public float measure;
        }
    }
}
