using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Bounds of a force field.</summary>
    public enum ForceFieldBounds
    {
        /// <summary>The field acts everywhere in the fluid.</summary>
        None,
        /// <summary>The field acts within a sphere.</summary>
        Sphere,
        /// <summary>The field acts within a box.</summary>
        Box,
    }

    /// <summary>Accelerates the particles of a <see cref="FluidSimulation"/> in its bounds.</summary>
    /// <remarks>
    /// All fields together accelerate a particle by at most 1000 m/s². A point or vortex fades to 0 towards its center over a
    /// tenth of its bounds' size, or over two particle spacings without bounds.
    /// </remarks>
    [AddComponentMenu("Rill/Fluid Force Field"), Icon(PackagePaths.Icon), ManualPage("sources", "fluid-force-field")]
    public sealed class FluidForceField : FluidPart, IForceField
    {
        const int NoSize = FirstOwnProblem;

        /// <summary>of the reach: inside it a point or vortex fades towards its center</summary>
        [GenerateHlsl("ForceFields")] const float CoreFraction = 0.1f;

        const float CoreWithoutBounds = 2f;     // d

        [Tooltip("Direction: along the forward axis. Point: towards this object. Vortex: around the forward axis. Wind: drags the " +
        "surface along the forward axis.")]
        [SerializeField] ForceFieldKind kind = ForceFieldKind.Direction;

        [Tooltip("Acceleration, m/s². -1000 to 1000. Of a wind: its speed, m/s.")]
        [SerializeField] float strength = 5f;

        [Tooltip("Drag of a wind: fraction of the difference to its velocity that a particle alone in the air loses in a second, at first. 0 " +
            "to 1000.")]
        [SerializeField] float drag = 2f;

        [Tooltip("How the strength falls from the center, t = 0, to the bounds, t = 1. None: it does not. Linear: 1 - t. Inverse " +
            "Square: (0.1 / t)², and 1 below t = 0.1. Smooth: (1 - t²)². Without bounds none.")]
        [SerializeField] ForceFieldFalloff falloff = ForceFieldFalloff.None;

        [Tooltip("Bounds of the field. None: all of the domain, without falloff; a direction then acts as more gravity and costs nothing.")]
        [SerializeField] ForceFieldBounds bounds = ForceFieldBounds.None;

        [Tooltip("Radius of the sphere, m.")]
        [SerializeField] float radius = 1f;

        [Tooltip("Size of the box, m.")]
        [SerializeField] Vector3 size = Vector3.one;

        /// <summary>Kind of the force.</summary>
        public ForceFieldKind Kind { get => kind; set => kind = value; }
        /// <summary>Acceleration, m/s², or a wind's speed, m/s. Out-of-range values are clamped with a warning.</summary>
        public float Strength { get => strength; set { strength = value; Changed(); } }
        /// <summary>Drag of a wind: fraction of the difference to its velocity that a particle alone in the air loses in a second, at
        /// first.</summary>
        public float Drag { get => drag; set { drag = value; Changed(); } }
        /// <summary>How the strength falls towards the bounds.</summary>
        public ForceFieldFalloff Falloff { get => falloff; set => falloff = value; }
        /// <summary>Bounds of the field.</summary>
        public ForceFieldBounds Bounds { get => bounds; set => bounds = value; }
        /// <summary>Radius of the sphere, m.</summary>
        public float Radius { get => radius; set { radius = value; Changed(); } }
        /// <summary>Size of the box, m.</summary>
        public Vector3 Size { get => size; set { size = value; Changed(); } }

        /// <summary>Largest acceleration that it asks for, m/s².</summary>
        float IForceField.MaxAcceleration => kind == ForceFieldKind.Wind ? 0f : math.abs(strength);

        /// <summary>Whether it pulls everywhere alike, as gravity does.</summary>
        bool IForceField.IsUniform => kind == ForceFieldKind.Direction && bounds == ForceFieldBounds.None;

        /// <summary>Describes its work in the next step.</summary>
        /// <returns>Whether it does anything.</returns>
        bool IForceField.TryGetStep(in DomainFrame frame, float spacing, out FieldRegion region)
        {
            region = default;
            if (!TryGetPose(frame, out PoseInDomain pose))
                return false;
            float3 half = Half / spacing;
            bool bounded = bounds != ForceFieldBounds.None;
            if (ShouldLog(NoSize, IsEmpty))
                Warn(SizeProblem);
            if (IsEmpty)
                return false;
            bool isWind = kind == ForceFieldKind.Wind;
            region = new FieldRegion
            {
                center = pose.position,
                kind = (uint)kind,
                axisX = bounded ? pose.axisX / half.x : 0f,
                axisY = bounded ? pose.axisY / half.y : 0f,
                axisZ = bounded ? pose.axisZ / half.z : 0f,
                falloff = (uint)(bounded ? falloff : ForceFieldFalloff.None),
                isSphere = bounds == ForceFieldBounds.Sphere ? 1u : 0u,
                strength = isWind ? drag : strength / spacing,
                flow = isWind ? pose.axisZ * (strength / spacing) : pose.axisZ,
                core = bounded ? math.max(CoreFraction * math.cmax(half), 1e-3f) : CoreWithoutBounds,
            };
            return true;
        }

        internal override PartKind PartKind => PartKind.ForceField;

        private protected override void ListOwnProblems(FluidSimulation fluid, List<string> problems)
            => problems.AddIfAny(IsEmpty ? SizeProblem : null);

        float3 Half => bounds == ForceFieldBounds.Sphere ? Vector3.one * radius : size * 0.5f;

        bool IsEmpty => bounds != ForceFieldBounds.None && !(math.cmin(Half) > 0f);

        string SizeProblem
        {
            get
            {
                string what = bounds == ForceFieldBounds.Sphere ? Invariant($"sphere of radius {radius} m")
                    : Invariant($"box of {size.x} x {size.y} x {size.z} m");
                return $"its {what} has no size, so it acts on nothing. Set its size above 0 or its bounds to none.";
            }
        }

        private protected override FeatureSet UsedFeatures => Features.ForceFields;

        private protected override string ValidateValues()
        {
            string problem = null;
            Limit.Clamp("strength", ref strength, -ForceFields.MaxAcceleration, ForceFields.MaxAcceleration, 0f, ref problem);
            Limit.Clamp("drag", ref drag, 0f, 1000f, 0f, ref problem);
            Limit.Clamp("radius", ref radius, 0f, float.MaxValue, 1f, ref problem);
            Limit.Finite("size", ref size, Vector3.one, ref problem);
            return problem;
        }
    }
}
