using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Shape of a drain.</summary>
    public enum DrainShape
    {
        /// <summary>A box with sides along the axes of the object.</summary>
        Box,
        /// <summary>A sphere.</summary>
        Sphere,
    }

    /// <summary>Takes the fluid out of a volume of a <see cref="FluidSimulation"/>, for good or to where an emitter lets it in again.</summary>
    /// <remarks>
    /// Looks at the particles at the start of every fixed step, and at the path that each came in the step before: what crosses it
    /// within one step is taken too, however thin it is and while it moves. The path is the velocity's, which contacts with colliders
    /// change: a particle that bounces counts as come from behind the surface, up to a step's path deep, and one that friction slows
    /// counts as come from nearer by as much. Keep a drain further than that from the back of a thin plate that bounces, and
    /// let one that stands on a floor with friction be thicker than friction times the path of a step.
    /// </remarks>
    [AddComponentMenu("Rill/Fluid Drain"), Icon(PackagePaths.Icon), ManualPage("sources", "fluid-drain")]
    public sealed class FluidDrain : FluidPart, IDrain
    {
        [Tooltip("A box or a sphere around this object.")]
        [SerializeField] DrainShape shape = DrainShape.Box;

        [Tooltip("Size of the box, m.")]
        [SerializeField] Vector3 size = new Vector3(0.5f, 0.2f, 0.5f);

        [Tooltip("Radius of the sphere, m.")]
        [SerializeField] float radius = 0.25f;

        [Tooltip("Most volume taken out, m³/s. 0: all that gets in.")]
        [SerializeField] float rateLimit;

        [Tooltip("Emitter of the same fluid that lets the particles in again, as soon as it has room. None: they are gone.")]
        [SerializeField] FluidEmitter recycleTo;

        const int NoSize = FirstOwnProblem, NoTarget = FirstOwnProblem + 1;

        [NonSerialized] double budget;      // m³ that may still go

        /// <summary>A box or a sphere.</summary>
        public DrainShape Shape { get => shape; set => shape = value; }
        /// <summary>Size of the box, m.</summary>
        public Vector3 Size { get => size; set { size = value; Changed(); } }
        /// <summary>Radius of the sphere, m.</summary>
        public float Radius { get => radius; set { radius = value; Changed(); } }
        /// <summary>Most volume taken out, m³/s; 0 for all that gets in. Out-of-range values are clamped with a warning.</summary>
        public float RateLimit { get => rateLimit; set { rateLimit = value; Changed(); } }
        /// <summary>Emitter of the same fluid that lets the particles in again; null for none.</summary>
        public FluidEmitter RecycleTo { get => recycleTo; set => recycleTo = value; }

        /// <summary>Particles taken out since the simulation's start, as far as the GPU has told: two or three frames ago. Begins again
        /// when this is disabled.</summary>
        public int Drained => Simulation != null && Number >= 0 ? Simulation.Inputs.Parts.DrainedCount(Number) : 0;

        internal override PartKind PartKind => PartKind.Drain;

        internal override void OnRestart()
        {
            base.OnRestart();
            budget = 0.0;
        }

        DrainRecord IDrain.Save(in DomainFrame frame) => new DrainRecord { part = SavePart(frame), budget = budget };

        void IDrain.Load(in DrainRecord record, in DomainFrame frame, float tolerance)
        {
            LoadPart(record.part, frame, tolerance);
            budget = record.budget;
        }

        /// <summary>Describes its work in the next step.</summary>
        /// <param name="from">Fraction of the frame at which the step starts.</param>
        /// <param name="to">Fraction of the frame at which it ends.</param>
        /// <returns>Whether it does anything.</returns>
        bool IDrain.TryGetStep(in DomainFrame frame, float spacing, float step, float from, float to, out DrainRegion region)
        {
            region = default;
            if (!TryGetMotion(frame, from, to, out RigidPose start, out RigidPose end))
                return false;
            float3 half = Half / spacing;
            if (ShouldLog(NoSize, IsEmpty))
                Warn(SizeProblem);
            if (IsEmpty)
                return false;
            region = new DrainRegion
            {
                rotation = end.rotation.value,
                lastRotation = start.rotation.value,
                center = end.position,
                isSphere = shape == DrainShape.Sphere ? 1u : 0u,
                lastCenter = start.position,
                inverseHalf = 1f / half,
                limit = LimitOf(step, (double)spacing * spacing * spacing),
                emitter = Target(),
                number = (uint)Number,
            };
            return true;
        }

        private protected override FeatureSet UsedFeatures => Features.Drains;

        private protected override string ValidateValues()
        {
            string problem = null;
            Limit.Clamp("rate limit", ref rateLimit, 0f, float.MaxValue, 0f, ref problem);
            Limit.Finite("size", ref size, Vector3.one * 0.5f, ref problem);
            Limit.Clamp("radius", ref radius, 0f, float.MaxValue, 0.25f, ref problem);
            return problem;
        }

        private protected override void ListOwnProblems(FluidSimulation fluid, List<string> problems)
        {
            problems.AddIfAny(IsEmpty ? SizeProblem : null);
            problems.AddIfAny(Simulation != null && recycleTo != null && !TargetTakes ? TargetProblem : null);
        }

        float3 Half => shape == DrainShape.Sphere ? Vector3.one * radius : size * 0.5f;

        bool IsEmpty => !(math.cmin(Half) > 0f);

        string SizeProblem
        {
            get
            {
                string what = shape == DrainShape.Sphere ? Invariant($"sphere of radius {radius} m")
                    : Invariant($"box of {size.x} x {size.y} x {size.z} m");
                return $"its {what} has no size, so it takes out nothing. Set its size above 0.";
            }
        }

        bool TargetTakes => recycleTo.isActiveAndEnabled && recycleTo.Simulation == Simulation && recycleTo.Number >= 0;

        string TargetProblem => $"its emitter '{recycleTo.name}' is disabled or belongs to another fluid, so particles are taken out " +
            $"for good. Enable it or choose one of '{Simulation.name}'.";

        // Whole particles; what is left of one is kept for the next step.
        uint LimitOf(float step, double particleVolume)
        {
            if (rateLimit <= 0f)
                return DrainRegion.NoLimit;
            budget += rateLimit * (double)step;
            double whole = math.min(math.floor(budget / particleVolume + 1e-9), SolverLayout.MaxCapacity);
            budget -= whole * particleVolume;
            return (uint)whole;
        }

        uint Target()
        {
            if (recycleTo == null)
                return DrainRegion.NoEmitter;
            bool takes = TargetTakes;
            if (ShouldLog(NoTarget, !takes))
                Warn(TargetProblem);
            return takes ? (uint)recycleTo.Number : DrainRegion.NoEmitter;
        }
    }
}
