using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using Random = Unity.Mathematics.Random;

namespace Rill
{
    /// <summary>What a <see cref="FluidVolume"/> has the shape of.</summary>
    public enum VolumeShape { Box, Sphere, SignedDistanceField }

    /// <summary>Fluid at the start: on a <see cref="FluidSimulation"/> or below it. Follows position and rotation, and with a field uniform scale.</summary>
    [AddComponentMenu("Rill/Fluid Volume")]
    public sealed class FluidVolume : MonoBehaviour, IHasProblems
    {
        [Tooltip("A box or a sphere around this object, or the inside of a baked mesh in its own place.")]
        [SerializeField] VolumeShape shape = VolumeShape.Box;

        [Tooltip("Size of the box, m, around this object.")]
        [SerializeField] Vector3 size = Vector3.one;

        [Tooltip("Radius of the sphere, m.")]
        [SerializeField] float radius = 0.5f;

        [Tooltip("Baked mesh whose inside is filled. Scaled with this object, uniformly.")]
        [SerializeField] SignedDistanceField field;

        [Tooltip("Velocity at the start in world space, m/s.")]
        [SerializeField] Vector3 velocity;

        /// <summary>Offset of a particle from its lattice place, spacings: breaks the symmetry that a perfect lattice would keep.</summary>
        const float Jitter = 0.02f;

        /// <summary>A box, a sphere or the inside of a field.</summary>
        public VolumeShape Shape { get => shape; set => shape = value; }

        /// <summary>Radius of the sphere, m.</summary>
        public float Radius { get => radius; set => radius = value; }

        /// <summary>Baked mesh whose inside is filled.</summary>
        public SignedDistanceField Field { get => field; set => field = value; }

        /// <summary>Size of the box, m.</summary>
        public Vector3 Size { get => size; set => size = value; }

        /// <summary>Velocity at the start in world space, m/s.</summary>
        public Vector3 Velocity { get => velocity; set => velocity = value; }

        /// <summary>Particles that fit along each axis of the shape, or of the box around it.</summary>
        /// <param name="spacing">m.</param>
        public int3 LatticeCounts(float spacing)
        {
            // A box of a whole number of spacings holds that many in spite of rounding.
            return (int3)math.floor(Extent / spacing + 1e-3f);
        }

        /// <summary>Places of the particles on a cubic lattice, each offset a little; the caller disposes both arrays.</summary>
        /// <param name="spacing">m.</param>
        /// <param name="positions">xyz, world space, m.</param>
        /// <param name="velocities">xyz, world space, m/s.</param>
        /// <exception cref="ArgumentException">Field missing or unreadable, or size, velocity or transform is not finite, or the particles are too many for any simulation.</exception>
        internal void Fill(float spacing, int seed, out NativeArray<float4> positions, out NativeArray<float4> velocities)
        {
            if (ProblemWith(spacing) is string problem)
                throw new ArgumentException(problem);

            float3 center = transform.position;
            IVolume volume = Solid(spacing);
            int3 counts = math.max(LatticeCounts(spacing), 0);
            float3 first = (float3)(counts - 1) * -0.5f;
            float3 middle = Middle;
            int inside = 0;
            for (int i = 0; i < counts.x * counts.y * counts.z; i++)
                inside += volume.Contains(Place(i) * spacing) ? 1 : 0;
            positions = new NativeArray<float4>(inside, Allocator.Persistent);
            velocities = new NativeArray<float4>(inside, Allocator.Persistent);
            var random = new Random(math.hash(new int2(seed, inside)) | 1u);
            for (int i = 0, filled = 0; filled < inside; i++)
            {
                if (!volume.Contains(Place(i) * spacing))
                    continue;
                float3 local = middle + (Place(i) + random.NextFloat3(-Jitter, Jitter)) * spacing;
                positions[filled] = new float4(center + (float3)(transform.rotation * (Vector3)local), 0f);
                velocities[filled] = new float4(velocity, 0f);
                filled++;
            }

            // Spacings, in the volume's own frame.
            float3 Place(int i) => first + new float3(i % counts.x, i / counts.x % counts.y, i / (counts.x * counts.y));
        }

        // Of the box around the shape, m.
        float3 Extent
        {
            get
            {
                if (shape == VolumeShape.SignedDistanceField)
                    return field != null ? (float3)field.Bounds.size * Scale : float3.zero;
                return shape == VolumeShape.Sphere ? (float3)(2f * radius) : (float3)size;
            }
        }

        // Of that box, m, in this object's frame without its scale.
        float3 Middle => shape == VolumeShape.SignedDistanceField ? (float3)field.Bounds.center * Scale : float3.zero;

        float Scale => math.abs(transform.lossyScale.x);

        string SizeText => shape == VolumeShape.Sphere ? $"radius {radius}" : $"size {(Vector3)Extent}";

        void IHasProblems.ListProblems(List<string> problems)
        {
            FluidSimulation fluid = GetComponentInParent<FluidSimulation>(true);
            problems.AddIfAny(fluid == null ? "there is no FluidSimulation on this object or above it, so it fills none. Put it below one." : null);
            problems.AddIfAny(ProblemWith(fluid != null && fluid.ParticleSpacing > 0f ? fluid.ParticleSpacing : float.PositiveInfinity));
        }

        // Why it cannot be filled with particles of this spacing; null where it can.
        string ProblemWith(float spacing)
        {
            if (FieldProblem is string problem)
                return problem;
            if (!math.all(math.isfinite(Extent)) || !math.all(math.isfinite((float3)velocity)) || !math.all(math.isfinite((float3)transform.position)))
                return $"{SizeText}, velocity {velocity} or position {transform.position} is not finite. Set them to numbers.";
            float3 across = math.max(Extent / spacing, 0f);
            if (across.x * across.y * across.z > SolverLayout.MaxCapacity)
                return $"{SizeText} m holds more than {SolverLayout.MaxCapacity:N0} particles of spacing {spacing} m, the most of one simulation. Shrink it or raise the spacing.";
            return null;
        }

        string FieldProblem
        {
            get
            {
                if (shape != VolumeShape.SignedDistanceField)
                    return null;
                if (field == null)
                    return "it has no signed distance field. Bake one from a mesh and set it, or choose another shape.";
                if (!field.Validate(out string problem))
                    return "its field " + problem;
                if (!field.TrySample(field.Bounds.center, out _))
                    return $"its field '{field.name}' has a texture that cannot be read. Bake it anew.";
                float3 scale = math.abs((float3)transform.lossyScale);
                if (!(math.cmin(scale) > 0f) || math.cmax(scale) - math.cmin(scale) > 1e-3f * math.cmax(scale))
                    return $"its scale {transform.lossyScale} is not the same along all axes, or 0, which distances do not survive. Scale it uniformly.";
                return null;
            }
        }

        IVolume Solid(float spacing)
        {
            if (shape == VolumeShape.SignedDistanceField)
                return new FieldVolume(field, Middle, Scale, -0.5f * spacing);
            return shape == VolumeShape.Sphere ? (IVolume)new SphereVolume(radius - 0.5f * spacing) : new BoxVolume();
        }

        /// <summary>Says where particles may be.</summary>
        interface IVolume
        {
            /// <param name="place">Of a particle's centre, m, from the middle of the volume in its own frame.</param>
            /// <returns>Whether all of the particle is inside.</returns>
            bool Contains(float3 place);
        }

        // The lattice fits into the box.
        readonly struct BoxVolume : IVolume
        {
            public bool Contains(float3 place) => true;
        }

        readonly struct SphereVolume : IVolume
        {
            readonly float radius;

            public SphereVolume(float radius) => this.radius = radius;

            public bool Contains(float3 place) => math.length(place) <= radius * (1f + 1e-4f);
        }

        readonly struct FieldVolume : IVolume
        {
            readonly SignedDistanceField field;
            readonly float3 middle;
            readonly float scale, mostDistance;

            public FieldVolume(SignedDistanceField field, float3 middle, float scale, float mostDistance)
            {
                this.field = field;
                this.middle = middle;
                this.scale = scale;
                this.mostDistance = mostDistance;
            }

            public bool Contains(float3 place) => field.TrySample((place + middle) / scale, out float distance) && distance * scale <= mostDistance;
        }
    }
}
