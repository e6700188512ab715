using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Events;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Measures the water in a shape: volume, fill level, mean velocity and momentum, and how much there is of each phase.</summary>
    /// <remarks>
    /// Measured after the last step of each frame; the result comes two or three frames later, without waiting, and says of which step it
    /// is. A simulation takes 32 detectors. The shape follows the object's position and rotation, that of a mesh its scale too. A particle on
    /// the shape's surface counts by the part of it that is inside.
    /// </remarks>
    [AddComponentMenu("Rill/Fluid Detector"), Icon(PackagePaths.Icon), ManualPage("queries", "fluid-detector")]
    public sealed class FluidDetector : FluidQuery, IDetector
    {
        [Tooltip("A box, a sphere or a capsule along the y axis, around this object, or a mesh by its signed distance field.")]
        [SerializeField] DetectorShape shape = DetectorShape.Box;

        [Tooltip("Size of the box, m.")]
        [SerializeField] Vector3 size = new Vector3(0.5f, 0.5f, 0.5f);

        [Tooltip("Radius of the sphere or capsule, m.")]
        [SerializeField] float radius = 0.25f;

        [Tooltip("Height of the capsule from end to end, m. Less than twice the radius is a sphere.")]
        [SerializeField] float height = 1f;

        [Tooltip("Signed distance field of the mesh, baked in its frame. It follows this object's scale, which has to be the same along all axes.")]
        [SerializeField] SignedDistanceField field;

        [Tooltip("Fill from which water has entered. 0.001 to 1. It has left below half of it.")]
        [Range(0.001f, 1f)]
        [SerializeField] float enterFill = 0.01f;

        [Tooltip("Fill from which the shape counts as filled. 0 to 1.")]
        [Range(0f, 1f)]
        [SerializeField] float fillLevel = 0.5f;

        [Tooltip("How far the fill has to fall below the level before the shape counts as emptied. 0 to 1.")]
        [Range(0f, 1f)]
        [SerializeField] float hysteresis = 0.05f;

        [Tooltip("Mean speed of the water from which it counts as an impact, m/s. It can be one again below four fifths of it.")]
        [SerializeField] float impactSpeed = 2f;

        [Tooltip("Change of the fill after which On Level Changed is called again. 0 to 1; 0 calls it at each change.")]
        [Range(0f, 1f)]
        [SerializeField] float levelStep = 0.01f;

        [Tooltip("Called when water has entered.")]
        [SerializeField] UnityEvent onEnter = new UnityEvent();

        [Tooltip("Called when the water has left.")]
        [SerializeField] UnityEvent onExit = new UnityEvent();

        [Tooltip("Called when the fill has risen to the level.")]
        [SerializeField] UnityEvent onFilled = new UnityEvent();

        [Tooltip("Called when the fill has fallen below the level by the hysteresis.")]
        [SerializeField] UnityEvent onEmptied = new UnityEvent();

        [Tooltip("Called when the water has become as fast as the impact speed.")]
        [SerializeField] UnityEvent onImpact = new UnityEvent();

        [Tooltip("Called with the fill, 0 to 1, when it has changed by Level Step, and with the first one.")]
        [SerializeField] UnityEvent<float> onLevelChanged = new UnityEvent<float>();

        const int NoSize = FirstOwnProblem;
        const float OfParticle = 0.9f;      // half the diagonal of its cube, d
        const float LeaveFraction = 0.5f, CalmFraction = 0.8f;

        FluidDetectorSample latest;
        [NonSerialized] Vector3 latestShift;        // of the fluid, when it was asked for
        [NonSerialized] bool isNew, isEntered, isFilled, isImpact;
        [NonSerialized] LevelWatch level;
        Delegates<Action> enter, exit, fill, empty, impact;
        Delegates<Action<float>> levelChanged;

        /// <summary>A box, a sphere, a capsule or a mesh.</summary>
        public DetectorShape Shape { get => shape; set => shape = value; }
        /// <summary>Size of the box, m.</summary>
        public Vector3 Size { get => size; set { size = value; Changed(); } }
        /// <summary>Radius of the sphere or capsule, m. Out-of-range values are clamped with a warning.</summary>
        public float Radius { get => radius; set { radius = value; Changed(); } }
        /// <summary>Height of the capsule from end to end, m. Out-of-range values are clamped with a warning.</summary>
        public float Height { get => height; set { height = value; Changed(); } }

        /// <summary>Signed distance field of the mesh; null for none.</summary>
        public SignedDistanceField Field { get => field; set => field = value; }

        /// <summary>Fill from which water has entered; it has left below half of it. Out-of-range values are clamped with a warning.</summary>
        public float EnterFill { get => enterFill; set { enterFill = value; Changed(); } }
        /// <summary>Fill from which the shape counts as filled. Out-of-range values are clamped with a warning.</summary>
        public float FillLevel { get => fillLevel; set { fillLevel = value; Changed(); } }
        /// <summary>How far the fill has to fall below the level before the shape counts as emptied. Out-of-range values are clamped
        /// with a warning.</summary>
        public float Hysteresis { get => hysteresis; set { hysteresis = value; Changed(); } }
        /// <summary>Mean speed of the water from which it counts as an impact, m/s. Out-of-range values are clamped with a warning.</summary>
        public float ImpactSpeed { get => impactSpeed; set { impactSpeed = value; Changed(); } }

        /// <summary>Change of the fill after which <see cref="OnLevelChanged"/> is called again, 0 to 1. Out-of-range values are
        /// clamped with a warning.</summary>
        public float LevelStep { get => levelStep; set { levelStep = value; Changed(); } }

        /// <summary>Called when water has entered, in the frame in which the result comes. <see cref="Latest"/> is then of that state.</summary>
        public event Action OnEnter { add => enter.Add(value); remove => enter.Remove(value); }
        /// <summary>Called when the water has left.</summary>
        public event Action OnExit { add => exit.Add(value); remove => exit.Remove(value); }
        /// <summary>Called when the fill has risen to the level.</summary>
        public event Action OnFilled { add => fill.Add(value); remove => fill.Remove(value); }
        /// <summary>Called when the fill has fallen below the level by the hysteresis.</summary>
        public event Action OnEmptied { add => empty.Add(value); remove => empty.Remove(value); }
        /// <summary>Called when the water has become as fast as the impact speed.</summary>
        public event Action OnImpact { add => impact.Add(value); remove => impact.Remove(value); }
        /// <summary>Called with the fill, 0 to 1, when it has changed by <see cref="LevelStep"/> since the last call, and with the first one
        /// since the fluid started.</summary>
        public event Action<float> OnLevelChanged { add => levelChanged.Add(value); remove => levelChanged.Remove(value); }

        /// <summary>Volume of the shape, m³, whether it is within the fluid's box or not.</summary>
        public float ShapeVolume
        {
            get
            {
                float ball = 4f / 3f * Mathf.PI * radius * radius * radius;
                switch (shape)
                {
                    case DetectorShape.Sphere: return ball;
                    case DetectorShape.Capsule: return ball + Mathf.PI * radius * radius * Mathf.Max(height - 2f * radius, 0f);
                    case DetectorShape.Mesh: return MeshProblem == null ? field.Volume * math.pow(EvenScale, 3f) : 0f;
                    default: return size.x * size.y * size.z;
                }
            }
        }

        /// <summary>The newest sample, whether it is valid or not.</summary>
        public FluidDetectorSample Latest
        {
            get
            {
                TryGetSample(out FluidDetectorSample sample);
                return sample;
            }
        }

        /// <summary>The newest sample, a few frames old; its age is that of this call.</summary>
        /// <returns>Whether it is valid: false before the first since the fluid started, and while this or the fluid is off.</returns>
        public bool TryGetSample(out FluidDetectorSample sample)
        {
            sample = default;
            if (!IsAnswered)
                return false;
            sample = latest;
            if (latest.valid)
                sample.position += Simulation.Box.WorldShift - latestShift;
            sample.age = latest.valid ? AgeOf(latest.time) : 0f;
            return sample.valid;
        }

        /// <summary>Measures the water as it stands at this moment and waits for it: see <see cref="FluidSimulation.MeasureQueriesNow"/>, which costs
        /// no more for all of a fluid at once.</summary>
        /// <returns>The sample, which is not valid while this or the fluid is off.</returns>
        public FluidDetectorSample MeasureNow()
        {
            Measure();
            return Latest;
        }

        internal override PartKind PartKind => PartKind.Detector;

        internal override void OnRestart()
        {
            base.OnRestart();
            latest = default;
            isNew = isEntered = isFilled = isImpact = false;       // without a call: the water did not leave
            level = default;
        }

        SignedDistanceField IDetector.MeshField => shape == DetectorShape.Mesh ? field : null;

        /// <summary>Describes the region to measure in this frame.</summary>
        /// <returns>Whether there is anything to ask.</returns>
        bool IDetector.TryGetRegion(in DomainFrame frame, float spacing, out DetectorRegion region, out DetectorPose pose)
        {
            region = default;
            pose = default;
            if (ShouldLog(NoSize, IsEmpty))
                Warn(SizeProblem);
            if (IsEmpty || !TryGetPose(frame, out PoseInDomain inDomain))
            {
                latest.valid = false;
                return false;
            }
            pose = new DetectorPose { position = transform.position, volume = ShapeVolume };
            if (shape == DetectorShape.Mesh)
            {
                region = MeshRegion(frame, spacing);
                return true;
            }
            float straight = shape == DetectorShape.Capsule ? math.max(0.5f * height - radius, 0f) : 0f;
            float3 half = shape == DetectorShape.Box ? (float3)size * 0.5f / spacing : new float3(radius, straight, 0f) / spacing;
            float3 reach = shape == DetectorShape.Box
                ? math.abs(inDomain.axisX) * half.x + math.abs(inDomain.axisY) * half.y + math.abs(inDomain.axisZ) * half.z
                : half.x + math.abs(inDomain.axisY) * half.y;
            region = new DetectorRegion
            {
                rotation = ((quaternion)frame.Rotation(transform.rotation)).value,
                center = inDomain.position,
                shape = (uint)shape,
                size = half,
                low = inDomain.position - reach - OfParticle,
                high = inDomain.position + reach + OfParticle,
            };
            return true;
        }

        // Around the center of the field, which need not be where the object is.
        DetectorRegion MeshRegion(in DomainFrame frame, float spacing)
        {
            Bounds bounds = field.Bounds;
            float unit = EvenScale / spacing;
            PoseInDomain inDomain = frame.ToDomain(transform.TransformPoint(bounds.center), transform.rotation);
            float3 half = (float3)bounds.extents * unit;
            float3 reach = math.abs(inDomain.axisX) * half.x + math.abs(inDomain.axisY) * half.y + math.abs(inDomain.axisZ) * half.z;
            return new DetectorRegion
            {
                rotation = ((quaternion)frame.Rotation(transform.rotation)).value,
                center = inDomain.position,
                shape = (uint)DetectorShape.Mesh,
                size = math.select(half, -half, (float3)transform.lossyScale < 0f),
                fieldUnit = unit,
                halfVoxel = 0.5f * field.VoxelSize * unit,
                low = inDomain.position - reach - OfParticle,
                high = inDomain.position + reach + OfParticle,
            };
        }

        /// <summary>Returns the distance of a point in world space from the shape's boundary, m, below 0 within; infinite without a shape.</summary>
        internal float DistanceTo(float3 point)
        {
            if (IsEmpty)
                return float.PositiveInfinity;
            if (shape == DetectorShape.Mesh)
                return field.TrySample(transform.InverseTransformPoint(point), out float distance) ? distance * EvenScale : float.PositiveInfinity;
            float3 local = Quaternion.Inverse(transform.rotation) * ((Vector3)point - transform.position);
            if (shape == DetectorShape.Box)
            {
                float3 beyond = math.abs(local) - 0.5f * (float3)size;
                return math.length(math.max(beyond, 0f)) + math.min(math.cmax(beyond), 0f);
            }
            float straight = shape == DetectorShape.Capsule ? math.max(0.5f * height - radius, 0f) : 0f;
            local.y -= math.clamp(local.y, -straight, straight);
            return math.length(local) - radius;
        }

        void IDetector.SetResult(in QueryFrame frame, in DetectorPose pose, Queries queries, int slot, int index)
        {
            double particle = (double)frame.spacing * frame.spacing * frame.spacing, count = 0.0;
            latest = default;
            latest.valid = isNew = true;
            latest.step = frame.step;
            latest.time = frame.time;
            latest.position = pose.position;
            latestShift = frame.shift;
            for (int phase = 0; phase < Queries.Phases; phase++)
            {
                double volume = queries.DetectorSum(slot, index, 3 + phase);
                latest.phases[phase] = (float)(volume * particle);
                latest.masses[phase] = latest.phases[phase] * Simulation.Phases.Density(phase, frame.density);
                latest.mass += latest.masses[phase];
                count += volume;
            }
            var sum = new double3(queries.DetectorSum(slot, index, 0), queries.DetectorSum(slot, index, 1), queries.DetectorSum(slot, index, 2));
            latest.volume = (float)(count * particle);
            latest.fill = math.saturate(latest.volume / pose.volume);
            latest.hasVelocity = count > 0.0;
            if (!latest.hasVelocity)
                return;
            latest.velocity = frame.rotation * (Vector3)(float3)(sum * (frame.spacing / count));
            latest.momentum = latest.velocity * latest.mass;
        }

        internal override void RaiseEvents()
        {
            if (!isNew)
                return;
            isNew = false;
            FluidDetectorSample now = latest;
            bool wasEntered = isEntered, wasFilled = isFilled, wasImpact = isImpact;
            isEntered = now.fill >= (wasEntered ? LeaveFraction * enterFill : enterFill) && now.volume > 0f;
            isFilled = now.fill >= (wasFilled ? fillLevel - hysteresis : fillLevel) && now.volume > 0f;
            isImpact = isEntered && now.velocity.magnitude >= (wasImpact ? CalmFraction * impactSpeed : impactSpeed);
            // Changes by a listener, such as restarting the fluid, belong to the next result.
            bool hasLevelChanged = level.Follow(now.fill, levelStep);
            Raise(onEnter, enter, !wasEntered && isEntered);
            Raise(onFilled, fill, !wasFilled && isFilled);
            Raise(onImpact, impact, !wasImpact && isImpact);
            Raise(onEmptied, empty, wasFilled && !isFilled);
            Raise(onExit, exit, wasEntered && !isEntered);
            if (hasLevelChanged)
                Listeners.Raise(onLevelChanged, levelChanged, now.fill, this);
        }

        private protected override string ValidateValues()
        {
            string problem = null;
            Limit.Finite("size", ref size, Vector3.one * 0.5f, ref problem);
            Limit.Clamp("radius", ref radius, 0f, 1e6f, 0.25f, ref problem);
            Limit.Clamp("height", ref height, 0f, 1e6f, 1f, ref problem);
            Limit.Clamp("enter fill", ref enterFill, 0.001f, 1f, 0.01f, ref problem);
            Limit.Clamp("fill level", ref fillLevel, 0f, 1f, 0.5f, ref problem);
            Limit.Clamp("hysteresis", ref hysteresis, 0f, 1f, 0.05f, ref problem);
            Limit.Clamp("impact speed", ref impactSpeed, 0f, 1e4f, 2f, ref problem);
            Limit.Clamp("level step", ref levelStep, 0f, 1f, 0.01f, ref problem);
            return problem;
        }

        private protected override void ListOwnProblems(FluidSimulation fluid, List<string> problems)
            => problems.AddIfAny(IsEmpty ? SizeProblem : null);

        void Raise(UnityEvent listed, in Delegates<Action> scripts, bool hasHappened)
        {
            if (hasHappened)
                Listeners.Raise(listed, scripts, this);
        }

        float EvenScale => math.cmax(math.abs((float3)transform.lossyScale));

        // Why the mesh measures nothing; null where it does.
        string MeshProblem
        {
            get
            {
                if (field == null)
                    return "it is a mesh without a signed distance field, so it measures nothing. Bake one from the mesh and assign it.";
                if (!field.Validate(out string problem))
                    return problem;
                float3 scale = math.abs((float3)transform.lossyScale);
                if (math.cmin(scale) > 0f && math.cmax(scale) <= 1.001f * math.cmin(scale))
                    return null;
                return Invariant($"its scale {(Vector3)scale} is not the same along all axes, so it measures nothing: distances cannot ") +
                    "be stretched. Scale it evenly, or bake the mesh as it shall be.";
            }
        }

        bool IsEmpty => shape == DetectorShape.Mesh ? MeshProblem != null
            : shape == DetectorShape.Box ? !(math.cmin((float3)size) > 0f) : !(radius > 0f);

        string SizeProblem
        {
            get
            {
                if (shape == DetectorShape.Mesh)
                    return MeshProblem;
                string what = shape == DetectorShape.Box ? Invariant($"box of {size.x} x {size.y} x {size.z} m")
                    : Invariant($"{(shape == DetectorShape.Sphere ? "sphere" : "capsule")} of radius {radius} m");
                return $"its {what} has no size, so it measures nothing. Set its size above 0.";
            }
        }
    }
}
