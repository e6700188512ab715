using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using Random = Unity.Mathematics.Random;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Shape of a <see cref="FluidVolume"/>.</summary>
    public enum VolumeShape
    {
        /// <summary>A box with sides along the axes of the object.</summary>
        Box,
        /// <summary>A sphere.</summary>
        Sphere,
        /// <summary>The inside of a baked mesh.</summary>
        SignedDistanceField,
    }

    /// <summary>Fluid at the start: on a <see cref="FluidSimulation"/> or below it. Follows position and rotation, and with a field uniform
    /// scale; a negative one mirrors.</summary>
    [AddComponentMenu("Rill/Fluid Volume"), Icon(PackagePaths.Icon), ManualPage("sources", "fluid-volume")]
    public sealed class FluidVolume : MonoBehaviour, IHasProblems
    {
        [Tooltip("A box or a sphere around this object, or the inside of a baked mesh at its own position.")]
        [SerializeField] VolumeShape shape = VolumeShape.Box;

        [Tooltip("Size of the box, m, around this object.")]
        [SerializeField] Vector3 size = Vector3.one;

        [Tooltip("Radius of the sphere, m.")]
        [SerializeField] float radius = 0.5f;

        [Tooltip("Baked mesh whose inside is filled. Scaled with this object, uniformly.")]
        [SerializeField] SignedDistanceField field;

        [Tooltip("Velocity at the start in world space, m/s.")]
        [SerializeField] Vector3 velocity;

        [Tooltip("Material of its fluid: density and viscosity. None: the fluid's own.")]
        [SerializeField] FluidMaterialAsset material;

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

        /// <summary>Material of its fluid; null for the fluid's own.</summary>
        public FluidMaterialAsset Material { get => material; set => material = value; }

        /// <summary>Particles that fit along each axis of the shape, or of the box around it.</summary>
        /// <param name="spacing">m.</param>
        public int3 LatticeCounts(float spacing)
        {
            // A box of a whole number of spacings holds that many in spite of rounding.
            return (int3)math.floor(Extent / spacing + 1e-3f);
        }

        /// <summary>Positions of the particles on a cubic lattice, each offset a little; the caller disposes the array.</summary>
        /// <param name="spacing">m.</param>
        /// <returns>xyz, world space, m.</returns>
        /// <exception cref="ArgumentException">Field missing or unreadable, or size, velocity or transform is not finite, or the particles
        /// are too many for any simulation.</exception>
        internal NativeArray<float4> CreatePositions(float spacing, int seed)
        {
            if (ProblemWith(spacing) is string problem)
                throw new ArgumentException(problem);

            var lattice = new VolumeLattice(LatticeCounts(spacing), spacing);
            if (shape == VolumeShape.Box)       // the lattice fits into it
                return CreatePositions(lattice, lattice.Total, default, seed);
            using (var marks = new NativeArray<byte>(lattice.Total, Allocator.Persistent, NativeArrayOptions.UninitializedMemory))
                return CreatePositions(lattice, Mark(lattice, spacing, marks.AsSpan()), marks.AsSpan(), seed);
        }

        int Mark(in VolumeLattice lattice, float spacing, Span<byte> marks)
        {
            if (shape == VolumeShape.Sphere)
                return lattice.Mark(new SphereVolume(radius - 0.5f * spacing), marks);
            field.TryGetSampler(out FieldSampler sampler);
            return lattice.Mark(new FieldVolume(sampler, Center, SignedScale, -0.5f * spacing), marks);
        }

        NativeArray<float4> CreatePositions(in VolumeLattice lattice, int inside, ReadOnlySpan<byte> marks, int seed)
        {
            var positions = new NativeArray<float4>(inside, Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
            if (inside > 0)
                lattice.Fill(marks, new Random(math.hash(new int2(seed, inside)) | 1u), Center, transform.position, transform.rotation,
                    positions.AsSpan());
            return positions;
        }

        // Size of the box around the shape, m.
        float3 Extent
        {
            get
            {
                if (shape == VolumeShape.SignedDistanceField)
                    return field != null ? (float3)field.Bounds.size * Scale : float3.zero;
                return shape == VolumeShape.Sphere ? (float3)(2f * radius) : (float3)size;
            }
        }

        // Center of that box, m, in this object's frame without its scale.
        float3 Center => shape == VolumeShape.SignedDistanceField ? (float3)field.Bounds.center * SignedScale : float3.zero;

        float Scale => math.abs(transform.lossyScale.x);

        float3 SignedScale => Scale * math.select(new float3(1f, 1f, 1f), new float3(-1f, -1f, -1f), (float3)transform.lossyScale < 0f);

        string SizeText => shape == VolumeShape.Sphere ? Invariant($"radius {radius}") : Invariant($"size {(Vector3)Extent}");

        void IHasProblems.ListProblems(List<string> problems)
        {
            FluidSimulation fluid = GetComponentInParent<FluidSimulation>(true);
            problems.AddIfAny(fluid == null ? "there is no FluidSimulation on this object or above it, so it fills none. Put it below one." : null);
            problems.AddIfAny(ProblemWith(fluid != null && fluid.ParticleSpacing > 0f ? fluid.ParticleSpacing : float.PositiveInfinity));
        }

        /// <summary>Why it cannot be filled with particles of a spacing, m; null where it can.</summary>
        internal string ProblemWith(float spacing)
        {
            if (FieldProblem is string problem)
                return problem;
            if (!math.all(math.isfinite(Extent)) || !math.all(math.isfinite((float3)velocity))
                || !math.all(math.isfinite((float3)transform.position)))
                return Invariant($"{SizeText}, velocity {velocity} or position {transform.position} is not finite. Set them to numbers.");
            float3 across = math.max(Extent / spacing, 0f);
            if (across.x * across.y * across.z > SolverLayout.MaxCapacity)
                return Invariant($"{SizeText} m holds more than {SolverLayout.MaxCapacity:N0} particles of spacing {spacing} m, the ") +
                    "most of one simulation. Shrink it or raise the spacing.";
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
                    return $"its field '{field.name}' has a texture that cannot be read. Bake it again.";
                float3 scale = math.abs((float3)transform.lossyScale);
                if (!(math.cmin(scale) > 0f) || math.cmax(scale) - math.cmin(scale) > 1e-3f * math.cmax(scale))
                    return Invariant($"its scale {transform.lossyScale} is not the same along all axes, or 0, which distances do not ") +
                        "survive. Scale it uniformly.";
                return null;
            }
        }

        readonly struct SphereVolume : IVolume
        {
            readonly float radius;

            public SphereVolume(float radius) => this.radius = radius;

            public bool Contains(float3 point) => math.length(point) <= radius * (1f + 1e-4f);
        }

        readonly struct FieldVolume : IVolume
        {
            readonly FieldSampler field;
            readonly float3 center, scale;
            readonly float evenScale, maxDistance;

            /// <param name="center">Center of the field's bounds, scaled, m.</param>
            /// <param name="scale">The same along all axes but for its signs: a negative one mirrors.</param>
            public FieldVolume(in FieldSampler field, float3 center, float3 scale, float maxDistance)
            {
                this.field = field;
                this.center = center;
                this.scale = scale;
                this.maxDistance = maxDistance;
                evenScale = math.abs(scale.x);
            }

            public bool Contains(float3 point) => field.TrySample((point + center) / scale, out float distance)
                && distance * evenScale <= maxDistance;
        }
    }
}
