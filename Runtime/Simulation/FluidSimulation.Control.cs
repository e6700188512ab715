using System;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using Random = Unity.Mathematics.Random;
using static System.FormattableString;

namespace Rill
{
    // Control by scripts while the fluid runs: what they add, fill and remove between steps.
    public sealed partial class FluidSimulation
    {
        Action onRefusals;
        NativeArray<float4> batchPositions, batchVelocities;       // of the last small batch, used again
        [NonSerialized] bool saidRefused, saidOutside;

        /// <summary>
        /// Adds particles at once, wherever they are: keep them a spacing apart and out of water that is there. Those beyond the capacity
        /// are refused, counted in the statistics and logged once. Allocates no managed memory after the first call. Does nothing in a
        /// player without a graphics device, as on a dedicated server.
        /// </summary>
        /// <param name="positions">World space, m.</param>
        /// <param name="velocities">World space, m/s; as many as positions.</param>
        /// <param name="phase">Number of the look of all of them, 0 to 7. Other than 0 takes 8 bytes a particle of capacity.</param>
        /// <param name="lifetime">Fluid time after which they are removed, s; 0 for never. Other than 0 takes 8 bytes a particle of capacity.</param>
        /// <exception cref="InvalidOperationException">The simulation is not running, though there is a graphics device.</exception>
        /// <exception cref="ArgumentException">Unequal lengths.</exception>
        /// <exception cref="ArgumentOutOfRangeException">Phase or lifetime is out of range.</exception>
        public void AddParticles(NativeArray<float3> positions, NativeArray<float3> velocities, int phase = 0, float lifetime = 0f)
        {
            if (positions.Length != velocities.Length)
                throw new ArgumentException(Invariant($"{positions.Length:N0} positions with {velocities.Length:N0} velocities: give ") +
                    "each particle both.");
            CheckTag(phase, lifetime);
            if (!IsReadyTo("adding particles"))
                return;

            GetPose(out Vector3 place, out Quaternion rotation);
            Quaternion toDomain = Quaternion.Inverse(rotation);
            float3 low = float.MaxValue, high = float.MinValue, size = (float3)domainSize / particleSpacing;
            if (positions.Length == 0)
                return;
            Reserve(ref batchPositions, positions.Length);
            Reserve(ref batchVelocities, positions.Length);
            for (int i = 0; i < positions.Length; i++)
            {
                float4 position = new float4(ToDomain(positions[i], place, toDomain), 0f) / particleSpacing;
                batchPositions[i] = position;
                batchVelocities[i] = new float4((float3)(toDomain * (Vector3)velocities[i]), 0f) / particleSpacing;
                if (!math.all(math.isfinite(position.xyz)))
                    continue;       // the first step culls it
                low = math.min(low, math.clamp(position.xyz, 0f, size));
                high = math.max(high, math.clamp(position.xyz, 0f, size));
            }
            uint tag = TagFor(phase, lifetime);
            pbf.BeginBatch(onRefusals);
            pbf.AddInSpacings(batchPositions.GetSubArray(0, positions.Length), batchVelocities.GetSubArray(0, positions.Length), low, high, tag);
            pbf.EndBatch();
            if (positions.Length > ParticleUpload.KeptBatch)
                ReleaseBatches();
        }

        /// <summary>
        /// Removes all particles, also those kept outside the box, and their foam at once. The fluid's time, its statistics and its emitters
        /// go on; what is removed counts as drained. <see cref="Restart"/> also sets time and statistics to 0 and fills the volumes.
        /// Does nothing in a player without a
        /// graphics device.
        /// </summary>
        /// <exception cref="InvalidOperationException">The simulation is not running, though there is a graphics device, or this is called
        /// in a pass of <see cref="BeforeStep"/>.</exception>
        public void Clear()
        {
            if (IsReadyTo("clearing it"))
                pbf.RemoveAll();
        }

        /// <summary>
        /// Removes the particles whose center is inside a shape at once. They count as drained, and free their part of the capacity with the
        /// next fixed step. Does nothing in a player without a graphics device, and where the stage ParticleEdits is not in the build,
        /// which is logged.
        /// </summary>
        /// <param name="shape">World space.</param>
        /// <exception cref="InvalidOperationException">The simulation is not running, though there is a graphics device, or this is called
        /// in a pass of <see cref="BeforeStep"/>.</exception>
        public void RemoveInside(FluidShape shape)
        {
            if (!IsReadyTo("removing particles") || !HasBesideSteps(Features.ParticleEdits))
                return;
            RoundedBox box = shape.box;
            GetPose(out Vector3 place, out Quaternion rotation);
            Quaternion toDomain = Quaternion.Inverse(rotation);
            pbf.RemoveInside(new RoundedBox
            {
                center = ToDomain(box.center, place, toDomain) / particleSpacing,
                half = box.half / particleSpacing,
                radius = box.radius / particleSpacing,
                rotation = toDomain * box.rotation,
            });
        }

        /// <summary>
        /// Fills a shape at once, as far as there is room: not nearer than 0.9 spacings to a particle that is there, not in a collider where the
        /// last step left it (before the first, where that finds it), and not outside the box. What the capacity does not hold is refused,
        /// counted and logged once. Does nothing in a player without a graphics device, and where the stage ParticleEdits is not in the build,
        /// which is logged.
        /// </summary>
        /// <param name="shape">World space. A particle is put where all of it is inside.</param>
        /// <param name="velocity">World space, m/s.</param>
        /// <param name="phase">Number of the look of all of them, 0 to 7. Other than 0 takes 8 bytes a particle of capacity.</param>
        /// <param name="lifetime">Fluid time after which they are removed, s; 0 for never. Other than 0 takes 8 bytes a particle of capacity.</param>
        /// <exception cref="InvalidOperationException">The simulation is not running, though there is a graphics device, or this is called
        /// in a pass of <see cref="BeforeStep"/>.</exception>
        /// <exception cref="ArgumentException">The velocity is not finite, or the shape holds more particles than any simulation.</exception>
        /// <exception cref="ArgumentOutOfRangeException">Phase or lifetime is out of range.</exception>
        public void Fill(FluidShape shape, Vector3 velocity = default, int phase = 0, float lifetime = 0f)
        {
            CheckTag(phase, lifetime);
            if (!math.all(math.isfinite((float3)velocity)))
                throw new ArgumentException(Invariant($"A fill with velocity {velocity} m/s: give finite numbers."), nameof(velocity));
            if (!IsReadyTo("filling it") || !HasBesideSteps(Features.ParticleEdits))
                return;
            using (NativeArray<float4> positions = Lattice(shape.box))
                FillWhereFree(positions, velocity, phase, lifetime, "a shape");
        }

        /// <summary>Fills a volume at once, wherever it is in the scene, as far as there is room: as
        /// <see cref="Fill(FluidShape, Vector3, int, float)"/>, with the volume's velocity.</summary>
        /// <param name="volume">On any object; it need not be enabled.</param>
        /// <param name="phase">Number of the look of all of them, 0 to 7.</param>
        /// <param name="lifetime">Fluid time after which they are removed, s; 0 for never.</param>
        /// <exception cref="ArgumentNullException">There is none.</exception>
        /// <exception cref="InvalidOperationException">The simulation is not running, though there is a graphics device, or this is called
        /// in a pass of <see cref="BeforeStep"/>.</exception>
        /// <exception cref="ArgumentException">The volume cannot be filled; the message says why.</exception>
        /// <exception cref="ArgumentOutOfRangeException">Phase or lifetime is out of range.</exception>
        public void Fill(FluidVolume volume, int phase = 0, float lifetime = 0f)
        {
            if (volume == null)
                throw new ArgumentNullException(nameof(volume));
            CheckTag(phase, lifetime);
            if (!IsReadyTo("filling it") || !HasBesideSteps(Features.ParticleEdits))
                return;
            using (NativeArray<float4> positions = volume.Fill(particleSpacing, seed))
                FillWhereFree(positions, volume.Velocity, phase, lifetime, $"FluidVolume '{volume.name}'", volume);
        }

        // World space, m; where they lie in the box afterwards.
        void FillWhereFree(NativeArray<float4> positions, Vector3 velocity, int phase, float lifetime, string what, FluidVolume volume = null)
        {
            NativeArray<float4> all = positions;
            int inside = KeepInside(all.AsSpan(), out float3 low, out float3 high);
            if (inside == 0)
            {
                if (!saidOutside)
                    Debug.LogWarning($"Rill: FluidSimulation '{name}' filled nothing of {what}: none of its " +
                        Invariant($"{positions.Length:N0} particles lies in the box of {domainSize} m around {transform.position}. ") +
                        (volume != null ? ScaleBetween(volume) : "") +
                        Invariant($"Move it into the box, or make it larger than the particle spacing of {particleSpacing} m."), this);
                saidOutside = true;
                return;
            }
            GetPose(out _, out Quaternion rotation);
            uint tag = TagFor(phase, lifetime);
            pbf.BeginBatch(onRefusals);
            pbf.AddWhereFree(all.GetSubArray(0, inside), (float3)(Quaternion.Inverse(rotation) * velocity) / particleSpacing, low, high, tag);
            pbf.EndBatch();
        }

        // Particles of a shape on a cubic lattice, world space, m.
        NativeArray<float4> Lattice(in RoundedBox box)
        {
            float3 across = math.floor(2f * box.Extent / particleSpacing + 1e-3f);
            if (across.x * across.y * across.z > SolverLayout.MaxCapacity)
                throw new ArgumentException(Invariant($"The shape of {(Vector3)(2f * box.Extent)} m holds more than ") +
                    Invariant($"{SolverLayout.MaxCapacity:N0} particles of spacing {particleSpacing} m, the most of one simulation. ") +
                    "Shrink it or raise the spacing.");
            var lattice = new VolumeLattice((int3)across, particleSpacing);
            RoundedBox whole = box;      // in which the center of a particle lies whose sphere is inside
            float margin = 0.5f * particleSpacing, tolerance = 1e-3f * particleSpacing;      // rounding would leave a sphere a particle short
            whole.radius = math.max(box.radius - margin, 0f) + tolerance;
            whole.half = math.max(box.half - math.max(margin - box.radius, 0f), 0f);
            using (var marks = new NativeArray<byte>(lattice.Total, Allocator.Persistent, NativeArrayOptions.UninitializedMemory))
            {
                NativeArray<byte> to = marks;
                int inside = lattice.Mark(whole, to.AsSpan());
                var positions = new NativeArray<float4>(inside, Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
                if (inside > 0)
                    lattice.Fill(to.AsSpan(), new Random(math.hash(new int2(seed, inside)) | 1u), float3.zero, box.center, box.rotation,
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
            bool ends = lifetime > 0f && Gate.IsLoaded(Features.Drains);
            return pbf.TagFor(phase, ends ? math.max((int)math.round(lifetime * stepRate), 1) : 0);
        }

        static void Reserve(ref NativeArray<float4> array, int count)
        {
            if (array.IsCreated && array.Length >= count)
                return;
            if (array.IsCreated)
                array.Dispose();
            array = new NativeArray<float4>(Mathf.NextPowerOfTwo(count), Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
        }

        void ReleaseBatches()
        {
            if (batchPositions.IsCreated)
                batchPositions.Dispose();
            if (batchVelocities.IsCreated)
                batchVelocities.Dispose();
            batchPositions = batchVelocities = default;
        }

        // False where there is no graphics device, and so nothing to do.
        bool IsReadyTo(string act)
        {
            ThrowInPass(act);
            if (pbf == null && HasNoGraphics)
                return false;
            StartAgainIfChanged();
            if (pbf == null)
                throw new InvalidOperationException($"FluidSimulation '{name}' is not running: enable it before {act}.");
            onRefusals ??= ReportRefused;
            if (resampling != null)
                resampling.isStale = true;      // what is on its way lacks what comes now
            return true;
        }

        void ThrowInPass(string act)
        {
            if (isRecordingPasses)
                throw new InvalidOperationException(
                    $"FluidSimulation '{name}' is recording a step in this pass of BeforeStep, which is no time for {act}: do it in Update.");
        }

        // Where box, spacing or capacity are no longer what the solver was made for.
        void StartAgainIfChanged()
        {
            if (pbf == null || !layoutChanged)
                return;
            Release();
            OnEnable();
        }

        void ReportRefused()
        {
            if (pbf == null || pbf.RefusedOfScripts == 0 || saidRefused)
                return;
            saidRefused = true;
            Debug.LogWarning($"Rill: FluidSimulation '{name}' {RefusedProblem}", this);
        }

        string RefusedProblem => Invariant($"refused {pbf.RefusedOfScripts:N0} particles that scripts added: its capacity of ") +
            Invariant($"{capacity:N0} is full. Raise the capacity, remove particles first or add fewer.");
    }
}
