using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Statistics of a fluid, measured every few steps, or at once for tests and tools, which wait for the GPU.</summary>
    sealed class Measurements
    {
        readonly FluidSimulation fluid;
        int stepsSince;

        public Measurements(FluidSimulation fluid) => this.fluid = fluid;

        /// <summary>Counts steps since the last measurement.</summary>
        public void Count(int steps) => stepsSince += steps;

        public void Restart() => stepsSince = 0;

        /// <summary>Gives the newest measurements; false before the first since a restart.</summary>
        public bool TryGet(out FluidStatistics statistics)
        {
            statistics = default;
            ref readonly StepInput input = ref fluid.Steps.Input;
            if (fluid.Solver == null || !fluid.Solver.TryGetStatistics(input, out statistics))
                return false;
            statistics.relaxation = input.settings.relaxation;
            statistics.relaxationClamped = input.settings.relaxation != fluid.Steps.Settings.relaxation;
            statistics.substeps = input.settings.substeps;
            statistics.droppedTime = fluid.Clock.Steps.Dropped;
            return true;
        }

        /// <summary>Records a measurement of the current state where one is due.</summary>
        /// <returns>Whether there is anything to request.</returns>
        public bool Record(CommandBuffer commands)
        {
            int interval = fluid.StatisticsInterval;
            bool measures = interval > 0 && stepsSince >= interval && !fluid.Solver.StatisticsPending
                && fluid.Support.Has(Features.Statistics);
            if (measures)
                fluid.Solver.RecordStatistics(commands, fluid.Steps.Input);
            else if (interval <= 0)
                fluid.Solver.ReleaseStatistics();
            return measures;
        }

        /// <summary>Requests what was recorded, after its commands ran.</summary>
        public void Request()
        {
            fluid.Solver.Foam?.Request();
            fluid.Solver.RequestStatistics();
            stepsSince = 0;
        }

        /// <summary>Measures the state after the newest step now, and waits for the GPU: for tests and tools, not for games.</summary>
        /// <exception cref="InvalidOperationException">The fluid does not run, has taken no step yet, or is built without statistics.</exception>
        public FluidStatistics MeasureNow()
        {
            PbfSolver solver = fluid.Solver;
            if (solver == null)
                throw new InvalidOperationException($"FluidSimulation '{fluid.name}' does not run, so there is nothing to measure: " +
                    $"{fluid.Failure ?? "it is disabled. Enable it first."}");
            if (fluid.StepCount == 0)
                throw new InvalidOperationException($"FluidSimulation '{fluid.name}' has taken no step yet. Let a frame pass first.");
            if (!fluid.Support.Has(Features.Statistics))
                throw new InvalidOperationException($"FluidSimulation '{fluid.name}' cannot be measured: its statistics are not in this " +
                    $"build or not for this device. Set Shaders In Build to All Features.");
            solver.CompleteStatistics();        // one that is pending is of an older state
            CommandBuffer commands = fluid.Commands;
            commands.Clear();
            solver.RecordStatistics(commands, fluid.Steps.Input);
            Graphics.ExecuteCommandBuffer(commands);
            solver.RequestStatistics();
            solver.CompleteStatistics();
            if (!TryGet(out FluidStatistics statistics))
                throw new InvalidOperationException(
                    $"FluidSimulation '{fluid.name}' cannot be measured: it {ReadbackErrors.Problem(ReadbackKinds.Statistics)}");
            return statistics;
        }

        /// <summary>Returns particles of the newest state by a measure, the smallest first; those without a finite one are left out. Waits for
        /// the GPU. Where colliders are in the box, call this after <see cref="MeasureNow"/>, which finds the distances from them.</summary>
        public List<FoundParticle> FindParticles(int maxCount, Func<FoundParticle, float> measure)
        {
            PbfSolver solver = fluid.Solver;
            float spacing = fluid.ParticleSpacing;
            var counters = new uint[ParticleBuffers.CounterCount];
            solver.Counters.GetData(counters);
            int count = (int)counters[(int)ParticleCounter.Alive];
            var positions = new float4[count];
            var velocities = new float4[count];
            var ids = new uint[count];
            float[] distances = null;
            solver.Positions.GetData(positions, 0, 0, count);
            solver.Velocities.GetData(velocities, 0, 0, count);
            solver.ParticleIds.GetData(ids, 0, 0, count);
            if (solver.Colliders != null)
            {
                distances = new float[count];
                solver.Colliders.ContactOffsets.GetData(distances, 0, 0, count);
            }
            Matrix4x4 toWorld = fluid.DomainToWorld;
            var found = new List<FoundParticle>();
            for (int i = 0; i < count; i++)
            {
                float3 p = positions[i].xyz;
                float outside = math.cmax(math.max(Colliders.ContactOffset - p, p - (solver.Layout.DomainSize - Colliders.ContactOffset)));
                if (distances != null)
                    outside = math.max(outside, Colliders.ContactOffset - distances[i]);
                var particle = new FoundParticle
                {
                    id = ids[i],
                    position = p * spacing,
                    velocity = velocities[i].xyz * spacing,
                    world = toWorld.MultiplyPoint3x4(p),
                    outside = outside * spacing,
                };
                particle.measure = measure(particle);
                if (math.isfinite(particle.measure))
                    found.Add(particle);
            }
            found.Sort((a, b) => a.measure != b.measure ? a.measure.CompareTo(b.measure) : a.id.CompareTo(b.id));
            return found.Count > maxCount ? found.GetRange(0, maxCount) : found;
        }
    }
}
