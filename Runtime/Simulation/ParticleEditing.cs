using System;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using Random = Unity.Mathematics.Random;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Adds, fills and removes particles between the steps of a fluid, as scripts ask for it.</summary>
    sealed class ParticleEditing
    {
        const int Refused = 0, Outside = 1;     // problems of the log

        readonly FluidSimulation fluid;
        Action onRefusals;
        NativeArray<float4> batchPositions, batchVelocities;       // of the last small batch, used again
        OnceLog log;

        public ParticleEditing(FluidSimulation fluid)
        {
            this.fluid = fluid;
            Filling = new VolumeFilling(fluid);
            Recentering = new BoxRecentering(fluid);
        }

        public VolumeFilling Filling { get; }

        public BoxRecentering Recentering { get; }

        /// <summary>How many particles of scripts were refused, and what to do; null for none.</summary>
        public string Problem => fluid.Solver.RefusedOfScripts > 0 ? RefusedProblem : null;

        /// <summary>Adds particles at once, wherever they are.</summary>
        public void Add(NativeArray<float3> positions, NativeArray<float3> velocities, int phase, float lifetime)
        {
            if (positions.Length != velocities.Length)
                throw new ArgumentException(Invariant($"{positions.Length:N0} positions with {velocities.Length:N0} velocities: give ") +
                    "each particle both.");
            CheckTag(phase, lifetime);
            if (!IsReadyTo("adding particles"))
                return;

            fluid.GetPose(out Vector3 boxPosition, out Quaternion rotation);
            Quaternion toDomain = Quaternion.Inverse(rotation);
            float spacing = fluid.ParticleSpacing;
            float3 low = float.MaxValue, high = float.MinValue, size = (float3)fluid.DomainSize / spacing;
            if (positions.Length == 0)
                return;
            Reserve(ref batchPositions, positions.Length);
            Reserve(ref batchVelocities, positions.Length);
            for (int i = 0; i < positions.Length; i++)
            {
                float4 position = new float4(Filling.ToDomain(positions[i], boxPosition, toDomain), 0f) / spacing;
                batchPositions[i] = position;
                batchVelocities[i] = new float4((float3)(toDomain * (Vector3)velocities[i]), 0f) / spacing;
                if (!math.all(math.isfinite(position.xyz)))
                    continue;       // the first step culls it
                low = math.min(low, math.clamp(position.xyz, 0f, size));
                high = math.max(high, math.clamp(position.xyz, 0f, size));
            }
            uint tag = TagFor(phase, lifetime);
            fluid.Solver.BeginBatch(onRefusals);
            fluid.Solver.AddInSpacings(batchPositions.GetSubArray(0, positions.Length), batchVelocities.GetSubArray(0, positions.Length), low, high,
                tag);
            fluid.Solver.EndBatch();
            if (positions.Length > ParticleUpload.MaxRetainedBatch)
                Release();
        }

        /// <summary>Removes all particles.</summary>
        public void Clear()
        {
            if (IsReadyTo("clearing it"))
                fluid.Solver.RemoveAll();
        }

        /// <summary>Removes the particles whose center is inside a shape.</summary>
        public void RemoveInside(FluidShape shape)
        {
            if (!IsReadyTo("removing particles") || !fluid.Support.HasBesideSteps(Features.ParticleEdits))
                return;
            RoundedBox box = shape.box;
            fluid.GetPose(out Vector3 position, out Quaternion rotation);
            Quaternion toDomain = Quaternion.Inverse(rotation);
            float spacing = fluid.ParticleSpacing;
            fluid.Solver.RemoveInside(new RoundedBox
            {
                center = Filling.ToDomain(box.center, position, toDomain) / spacing,
                half = box.half / spacing,
                radius = box.radius / spacing,
                rotation = toDomain * box.rotation,
            });
        }

        /// <summary>Fills a shape as far as there is room.</summary>
        public void Fill(FluidShape shape, Vector3 velocity, int phase, float lifetime)
        {
            CheckTag(phase, lifetime);
            if (!math.all(math.isfinite((float3)velocity)))
                throw new ArgumentException(Invariant($"A fill with velocity {velocity} m/s: give finite numbers."), nameof(velocity));
            if (!IsReadyTo("filling it") || !fluid.Support.HasBesideSteps(Features.ParticleEdits))
                return;
            using (NativeArray<float4> positions = Lattice(shape.box))
                AddIntoFreeSpace(positions, velocity, phase, lifetime, "a shape");
        }

        /// <summary>Fills a volume as far as there is room.</summary>
        public void Fill(FluidVolume volume, int phase, float lifetime)
        {
            if (volume == null)
                throw new ArgumentNullException(nameof(volume));
            CheckTag(phase, lifetime);
            if (!IsReadyTo("filling it") || !fluid.Support.HasBesideSteps(Features.ParticleEdits))
                return;
            if (volume.Material != null)
                phase = fluid.Phases.PhaseOf(volume.Material);
            using (NativeArray<float4> positions = volume.CreatePositions(fluid.ParticleSpacing, fluid.Seed))
                AddIntoFreeSpace(positions, volume.Velocity, phase, lifetime, $"FluidVolume '{volume.name}'", volume);
        }

        /// <summary>Whether the particles of the fluid can be changed now: false without a graphics device, where nothing is to
        /// be done.</summary>
        /// <exception cref="InvalidOperationException">The fluid is not running, or this is called in a pass of a step.</exception>
        public bool IsReadyTo(string act)
        {
            fluid.Steps.Passes.ThrowInPass(act);
            if (fluid.Solver == null && FeatureSupport.HasNoGraphics)
                return false;
            fluid.BeginAgainIfChanged();
            if (fluid.Solver == null)
                throw new InvalidOperationException($"FluidSimulation '{fluid.name}' is not running: enable it before {act}.");
            onRefusals ??= LogRefused;
            fluid.Resolution.MarkChanged();
            return true;
        }

        /// <summary>Releases the memory of the last batch.</summary>
        public void Release()
        {
            if (batchPositions.IsCreated)
                batchPositions.Dispose();
            if (batchVelocities.IsCreated)
                batchVelocities.Dispose();
            batchPositions = batchVelocities = default;
        }

        // Positions in world space, m; in the domain's frame afterwards.
        void AddIntoFreeSpace(NativeArray<float4> positions, Vector3 velocity, int phase, float lifetime, string what, FluidVolume volume = null)
        {
            NativeArray<float4> all = positions;
            int inside = Filling.MoveInside(all.AsSpan(), out float3 low, out float3 high);
            if (inside == 0)
            {
                if (log.ShouldLog(Outside))
                    Debug.LogWarning($"Rill: FluidSimulation '{fluid.name}' filled nothing of {what}: none of its " +
                        Invariant($"{positions.Length:N0} particles lies in the box of {fluid.DomainSize} m around {fluid.transform.position}. ") +
                        (volume != null ? Filling.ScaleBetween(volume) : "") +
                        Invariant($"Move it into the box, or make it larger than the particle spacing of {fluid.ParticleSpacing} m."), fluid);
                return;
            }
            fluid.GetPose(out _, out Quaternion rotation);
            uint tag = TagFor(phase, lifetime);
            fluid.Solver.BeginBatch(onRefusals);
            fluid.Solver.AddIntoFreeSpace(all.GetSubArray(0, inside), (float3)(Quaternion.Inverse(rotation) * velocity) / fluid.ParticleSpacing,
                low, high, tag);
            fluid.Solver.EndBatch();
        }

        // Particles of a shape on a cubic lattice, world space, m.
        NativeArray<float4> Lattice(in RoundedBox box)
        {
            float spacing = fluid.ParticleSpacing;
            float3 across = math.floor(2f * box.Extent / spacing + 1e-3f);
            if (across.x * across.y * across.z > SolverLayout.MaxCapacity)
                throw new ArgumentException(Invariant($"The shape of {(Vector3)(2f * box.Extent)} m holds more than ") +
                    Invariant($"{SolverLayout.MaxCapacity:N0} particles of spacing {spacing} m, the most of one simulation. ") +
                    "Shrink it or raise the spacing.");
            var lattice = new VolumeLattice((int3)across, spacing);
            RoundedBox whole = box;      // in which the center of a particle lies whose sphere is inside
            float margin = 0.5f * spacing, tolerance = 1e-3f * spacing;      // rounding would leave a sphere a particle short
            whole.radius = math.max(box.radius - margin, 0f) + tolerance;
            whole.half = math.max(box.half - math.max(margin - box.radius, 0f), 0f);
            using (var marks = new NativeArray<byte>(lattice.Total, Allocator.Persistent, NativeArrayOptions.UninitializedMemory))
            {
                NativeArray<byte> to = marks;
                int inside = lattice.Mark(whole, to.AsSpan());
                var positions = new NativeArray<float4>(inside, Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
                if (inside > 0)
                    lattice.Fill(to.AsSpan(), new Random(math.hash(new int2(fluid.Seed, inside)) | 1u), float3.zero, box.center, box.rotation,
                        positions.AsSpan());
                return positions;
            }
        }

        static void CheckTag(int phase, float lifetime)
        {
            if (phase < 0 || phase > ParticleTags.MaxPhase)
                throw Limit.OutOfRange(nameof(phase), phase, Invariant($"A phase is 0 to {ParticleTags.MaxPhase}."));
            if (!(lifetime >= 0f) || lifetime > ParticleTags.MaxLifetime)
                throw Limit.OutOfRange(nameof(lifetime), lifetime, "A lifetime is 0, for ever, to " +
                    Invariant($"{ParticleTags.MaxLifetime} s."));
        }

        uint TagFor(int phase, float lifetime)
        {
            bool ends = lifetime > 0f && fluid.Support.Gate.IsLoaded(Features.Drains);
            return fluid.Solver.TagFor(phase, ends ? math.max((int)math.round(lifetime * fluid.StepRate), 1) : 0);
        }

        static void Reserve(ref NativeArray<float4> array, int count)
        {
            if (array.IsCreated && array.Length >= count)
                return;
            if (array.IsCreated)
                array.Dispose();
            array = new NativeArray<float4>(Mathf.NextPowerOfTwo(count), Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
        }

        void LogRefused()
        {
            if (fluid.Solver != null && fluid.Solver.RefusedOfScripts != 0 && log.ShouldLog(Refused))
                Debug.LogWarning($"Rill: FluidSimulation '{fluid.name}' {RefusedProblem}", fluid);
        }

        string RefusedProblem
            => Invariant($"refused {fluid.Solver.RefusedOfScripts:N0} particles that scripts added: its capacity of ") +
            Invariant($"{fluid.Capacity:N0} is full. Raise the capacity, remove particles first or add fewer.");
    }
}
