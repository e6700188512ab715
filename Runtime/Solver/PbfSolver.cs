using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>
    /// Position Based Fluids (Macklin and Müller 2013) on the GPU: owns the particles and records steps into the caller's
    /// command buffer. It never submits a step, never waits for the GPU and allocates nothing per step.
    /// </summary>
    /// <remarks>
    /// Positions and velocities on the GPU are in particle spacings and in the domain's frame, whose lowest corner is 0;
    /// see <see cref="ParticleBuffers"/>.
    /// </remarks>
    sealed partial class PbfSolver : IDisposable
    {
        readonly ParticleBuffers particles;
        readonly ParticleUpload particleUpload;
        readonly NeighborSearch neighborSearch;
        readonly DensityConstraint densityConstraint;
        readonly VelocityUpdate velocityUpdate;

        GraphicsBuffer constants;
        // copied as it is recorded, as Unity's own ConstantBuffer relies on
        readonly SolverConstants[] constantsUpload = new SolverConstants[1];
        uint stepIndex;
        int lastSubsteps;       // of the last step
        bool hasLists;          // of the last substep
        bool isStart;           // particles of volumes may lie in colliders, which the next step is the first to know
        bool isRestored;        // with nothing but the state: not what a step leaves besides
        float3 minAdded, maxAdded;       // d, of all particles since the last Clear

        /// <exception cref="ArgumentOutOfRangeException">A buffer of this layout is more than the device can bind.</exception>
        public PbfSolver(SolverLayout layout) : this(layout, DeviceLimits.Current) { }

        /// <param name="limits">By which kernels that have stand-ins are chosen.</param>
        public PbfSolver(SolverLayout layout, in DeviceLimits limits)
        {
            Layout = layout;
            Limits = limits;
            try
            {
                particles = new ParticleBuffers(layout.Capacity);
                particleUpload = new ParticleUpload();
                neighborSearch = new NeighborSearch(layout, limits);
                densityConstraint = new DensityConstraint(layout);
                velocityUpdate = new VelocityUpdate();
                constants = GpuBuffer.Constants<SolverConstants>("Rill.Constants");
                Clear();
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        public SolverLayout Layout { get; }

        /// <summary>Limits of the device, by which kernels that have stand-ins are chosen.</summary>
        public DeviceLimits Limits { get; }

        /// <summary>Results that the graphics device gave an error for.</summary>
        public ReadbackErrors ReadbackErrors { get; } = new ReadbackErrors();

        /// <summary>float4 [capacity], xyz position, d; those of the particles alive come first.</summary>
        public GraphicsBuffer Positions => particles.Positions;

        /// <summary>float4 [capacity], xyz position at the start of the last substep, d; of those that took part in it.</summary>
        public GraphicsBuffer StartPositions => particles.Start;

        /// <summary>Number of the last step since the reset.</summary>
        public uint StepIndex => stepIndex;

        /// <summary>Substeps of the last step; 0 before the first.</summary>
        public int LastSubsteps => lastSubsteps;

        /// <summary>float4 [capacity], xyz velocity, d/s; w density relative to rest where a stage sums it, else 1.</summary>
        public GraphicsBuffer Velocities => particles.Velocities;

        /// <summary>uint [capacity].</summary>
        public GraphicsBuffer ParticleIds => particles.Ids;

        /// <summary>uint, by <see cref="ParticleCounter"/>.</summary>
        public GraphicsBuffer Counters => particles.Counters;

        /// <summary>Begins with the GraphicsBuffer.IndirectDrawArgs for the particles alive.</summary>
        public GraphicsBuffer DrawArguments => particles.AliveArguments;

        /// <summary>Forces and contacts of the fluid on colliders; null if none asks for them.</summary>
        public ColliderReactions Reactions => Colliders?.Reactions;

        /// <summary>Records how much of the colliders is wet after a step, where one wants to know.</summary>
        public void RecordWettedAreas(CommandBuffer cmd)
        {
            if (Reactions == null || !Reactions.HasWettedAreas)
                return;
            PrepareConstants();
            Colliders.RecordWettedAreas(BetweenSteps(cmd));
        }

        /// <summary>Removes all particles and resets the counters, at once.</summary>
        public void Clear()
        {
            stepIndex = 0;
            lastSubsteps = 0;
            hasLists = isRestored = isStart = neighborSearch.IsSorted = false;
            maxParticles = 0;
            InvalidateSurface();
            InvalidateParticles(true);
            ReleaseWhatEnds(ParticleChange.Restarted);
            hasLifetimes = hasGhosts = false;
            ReleaseOutside();
            refusals?.Clear();
            markedAfter = 0;
            minAdded = float.MaxValue;
            maxAdded = float.MinValue;
            using (var cmd = new CommandBuffer { name = "Rill.Clear" })
            {
                particleUpload.Clear(cmd, particles);
                Graphics.ExecuteCommandBuffer(cmd);
            }
        }

        /// <summary>Takes the count of steps and what particles carry from the solver before it, which gives its water to this one.</summary>
        public void ContinueFrom(PbfSolver before)
        {
            stepIndex = before.stepIndex;
            if (before.ParticleTags != null)
                NeedTags();
            hasLifetimes = before.hasLifetimes;
        }

        /// <summary>Adds particles at once. Those beyond the capacity are refused and counted.</summary>
        /// <param name="positions">xyz, m, in the domain's frame.</param>
        /// <param name="velocities">xyz, m/s; as many as positions.</param>
        public void Add(NativeArray<float4> positions, NativeArray<float4> velocities)
        {
            using (NativeArray<float4> scaledPositions = InSpacings(positions))
            using (NativeArray<float4> scaledVelocities = InSpacings(velocities))
            {
                float3 low = float.MaxValue, high = float.MinValue;
                foreach (float4 position in scaledPositions.AsReadOnlySpan())
                {
                    if (!math.all(math.isfinite(position.xyz)))
                        continue;       // the first step culls it
                    float3 inside = math.clamp(position.xyz, 0f, Layout.DomainSize);
                    low = math.min(low, inside);
                    high = math.max(high, inside);
                }
                AddInSpacings(scaledPositions, scaledVelocities, low, high);
            }
        }

        /// <summary>Adds particles like <see cref="Add"/>, in d and d/s; with one velocity for each position, or one for all.</summary>
        /// <param name="low">Lowest coordinates of the positions, d, within the domain.</param>
        /// <param name="high">Highest coordinates of the positions, d, within the domain.</param>
        /// <param name="tag">Tag of all of them, see ParticleTags.hlsl; what it asks for is there.</param>
        public void AddInSpacings(NativeArray<float4> positions, NativeArray<float4> velocities, float3 low, float3 high, uint tag = 0)
        {
            particleUpload.Append(particles, Layout.Capacity, positions, velocities, ParticleTags, tag);
            MarkAdded(positions.Length, low, high);
            if (lastSubsteps > 0)
                particleUpload.TrimLarge();
            else
                particleUpload.Trim();
        }

        /// <summary>Lets the next step leave out what lies in colliders: what is filled before the first step knows of none.</summary>
        public void LeaveOutCovered() => isStart = true;

        /// <summary>Records the measuring of the current state; <see cref="RequestStatistics"/> then fetches it.</summary>
        public void RecordStatistics(CommandBuffer cmd, in StepInput input)
        {
            StatisticsPass statistics = Statistics ?? Keep(Features.Statistics, new StatisticsPass(Layout.Capacity, ReadbackErrors));
            UploadConstants(cmd, input);
            StepContext step = Context(cmd, input);
            Colliders?.RecordBoundaryAtRest(step);
            statistics.Record(step);
        }

        /// <summary>Whether a step with this input solves for the pressure of deep water on the coarse grid.</summary>
        public bool IsDeep(in StepInput input)
            => CoarseCorrection.IsNeeded(input, WaterDepth(input.gravity), Coarse != null);

        /// <summary>Starts the readback of what was measured last; at most one is pending.</summary>
        public void RequestStatistics() => Statistics.Request();

        /// <summary>Waits for the statistics that are pending, and for nothing else.</summary>
        public void CompleteStatistics() => Statistics?.Complete();

        /// <summary>Whether a readback of statistics is pending.</summary>
        public bool StatisticsPending => Statistics != null && Statistics.IsPending;

        /// <summary>The newest statistics that have come back since the last <see cref="Clear"/>.</summary>
        public bool TryGetStatistics(in StepInput input, out FluidStatistics result)
        {
            result = default;
            if (Statistics == null || !Statistics.HasResult)
                return false;
            result = FluidStatistics.From(Statistics.Latest, Layout, input);
            if (!Rill.ImplicitViscosity.IsNeeded(input))
                result.viscosityChange = 0f;
            return true;
        }

        public void Dispose()
        {
            particles?.Dispose();
            particleUpload?.Dispose();
            neighborSearch?.Dispose();
            densityConstraint?.Dispose();
            ReleaseStages();
            ReleaseOutside();
            surfaceWorkspace.Dispose();
            refusals?.Dispose();
            refusals = null;
            GpuBuffer.Release(ref noTags);
            GpuBuffer.Release(ref constants);
        }

        /// <summary>Gives back what measuring needs, where it is no longer wanted.</summary>
        public void ReleaseStatistics()
        {
            if (Statistics == null)
                return;
            Release(Features.Statistics);
            if (Access == null)     // what a script has bound it keeps
                neighborSearch.ReleaseAtRest();
        }

        /// <summary>How deep the water can be, d: as far as what was added reaches along gravity; 0 where there is none.</summary>
        /// <param name="gravity">In the domain's frame; its length does not matter.</param>
        public float WaterDepth(float3 gravity)
        {
            float3 extent = math.max(maxAdded - minAdded + 1f, 0f);
            float strength = math.length(gravity);
            return strength > 0f ? math.dot(math.abs(gravity) / strength, extent) : 0f;
        }

        /// <summary>Side of a coarse cell, d, that a step with this input wants.</summary>
        public float CoarseCellSize(in StepInput input)
        {
            float substep = input.SubstepTime;
            return CoarseGrid.CellSizeFor(Layout.DomainSize, math.length(input.gravity) / Layout.Spacing * substep * substep,
                WaterDepth(input.gravity), Coarse?.Grid.WantedSize ?? 0f);
        }

        void UploadConstants(CommandBuffer cmd, in StepInput input)
        {
            constantsUpload[0] = SolverConstants.For(Layout, input, stepIndex);
            cmd.SetBufferData(constants, constantsUpload);
        }

        NativeArray<float4> InSpacings(NativeArray<float4> meters)
        {
            var scaled = new NativeArray<float4>(meters.Length, Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
            for (int i = 0; i < meters.Length; i++)
                scaled[i] = meters[i] / Layout.Spacing;
            return scaled;
        }
    }
}
