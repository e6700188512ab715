using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>
    /// A solid collider for every <see cref="FluidSimulation"/> whose box it reaches into, and whose
    /// <see cref="FluidSimulation.FluidColliderLayers"/> have the layer of its object. It follows its object: what moves between two steps
    /// sweeps the water along, however fast; what is switched on where water is lets it out slowly.
    /// </summary>
    /// <remarks>
    /// Sizes follow the object's scale: a box in all three sides, a sphere, a capsule and a mesh evenly, a height field not at all. A negative scale
    /// mirrors a mesh. A simulation takes up
    /// to 256 colliders. What is wrong is logged once, by name; the collider then stays where it last was, or is left out.
    /// </remarks>
    [AddComponentMenu("Rill/Fluid Collider"), Icon(PackagePaths.Icon), ManualPage("colliders", "fluid-collider")]
    public sealed class FluidCollider : MonoBehaviour, ISceneCollider, IHasProblems, IUsesFeatures, IRunsInEditMode, IAppliesSettings
    {
        [Tooltip("Shape of the collider for the water.")]
        [SerializeField] ColliderShape shape = ColliderShape.Box;

        [Tooltip("Center of the shape in the object's frame, m. Not for a mesh, whose field is placed by its bounds.")]
        [SerializeField] Vector3 center;

        [Tooltip("Sides of the box, m, above 0.")]
        [SerializeField] Vector3 size = Vector3.one;

        [Tooltip("Radius of the sphere or capsule, m, above 0.")]
        [SerializeField] float radius = 0.5f;

        [Tooltip("Height of the capsule from end to end, along y, m. At least twice the radius.")]
        [SerializeField] float height = 2f;

        [Tooltip("Signed distances of the mesh.")]
        [SerializeField] SignedDistanceField field;

        [Tooltip("Keeps the water inside: an aquarium, a pipe.")]
        [SerializeField] bool insideOut;

        [Tooltip("Fraction of the velocity along the surface that touching water loses in 1/60 s. 0 slips, 1 sticks.")]
        [Range(0f, 1f)]
        [SerializeField] float friction;

        [Tooltip("Fraction of the velocity into the surface that is given back. 0 to 1.")]
        [Range(0f, 1f)]
        [SerializeField] float bounciness;

        [Tooltip("Counts the solid as water in the density of what touches it. Without, water thins out towards the surface.")]
        [SerializeField] bool contributesDensity = true;

        [Tooltip("Sums the forces of the water on the collider and reads them back, a few frames late. Costs a little where on.")]
        [SerializeField] bool measuresForce;

        [SerializeField] ContactEvents contacts = ContactEvents.Default;

        [SerializeField, HideInInspector] StageReferences shaders = new StageReferences();


        HeightField heights;
        readonly List<FluidForce> forces = new List<FluidForce>();
        readonly List<ContactWatch> watches = new List<ContactWatch>();        // one beside each of forces
        ColliderTransform placement = ColliderTransform.Origin;
        [NonSerialized] bool problemIsKnown;
        [NonSerialized] ClampedSettings clamped;

        /// <summary>Shape of the collider.</summary>
        public ColliderShape Shape { get => shape; set => shape = value; }

        /// <summary>Center of the shape in the object's frame, m.</summary>
        public Vector3 Center { get => center; set => center = value; }

        /// <summary>Sides of the box, m.</summary>
        public Vector3 Size { get => size; set => size = value; }

        /// <summary>Radius of the sphere or capsule, m.</summary>
        public float Radius { get => radius; set => radius = value; }

        /// <summary>Height of the capsule from end to end, m.</summary>
        public float Height { get => height; set => height = value; }

        /// <summary>Signed distances of the mesh.</summary>
        public SignedDistanceField Field { get => field; set => field = value; }

        /// <summary>Heights of the ground; not saved with the scene. A <c>FluidTerrain</c> gives those of a Terrain.</summary>
        public HeightField Heights { get => heights; set => heights = value; }

        /// <summary>Makes a mesh deform, instead of the field; null where it keeps its shape.</summary>
        [field: NonSerialized] internal FluidDeformingMesh Deforming { get; set; }

        /// <summary>Whether the water is inside.</summary>
        public bool InsideOut { get => insideOut; set => insideOut = value; }

        /// <summary>Fraction of the velocity along the surface that touching water loses in 1/60 s, 0 to 1.</summary>
        public float Friction { get => friction; set { friction = value; Changed(); } }

        /// <summary>Fraction of the velocity into the surface that is given back, 0 to 1.</summary>
        public float Bounciness { get => bounciness; set { bounciness = value; Changed(); } }

        /// <summary>Whether the solid counts as water to the density of what touches it.</summary>
        public bool ContributesDensity { get => contributesDensity; set => contributesDensity = value; }

        /// <summary>Whether what the water does to the collider is summed and brought back.</summary>
        public bool MeasuresForce { get => measuresForce; set => measuresForce = value; }

        /// <summary>Impulse of one reading from which it is a hit, N s, 0.000001 to 1e9. The next can come below half of it.</summary>
        public float HitImpulse { get => contacts.HitImpulse; set { contacts.HitImpulse = value; Changed(); } }

        /// <summary>Water has come to it. Told two or three frames late, as all contacts are; forces are read back while somebody listens.</summary>
        public event Action<FluidContact> OnEnter { add => contacts.Enter.Add(value); remove => contacts.Enter.Remove(value); }

        /// <summary>The fluid gave it an impulse as large as <see cref="HitImpulse"/> in one reading, which is that of one to three frames.</summary>
        public event Action<FluidContact> OnHit { add => contacts.Hit.Add(value); remove => contacts.Hit.Remove(value); }

        /// <summary>It has felt no water for 0.2 s, or has left the fluid's box. Not told where the collider or the fluid is disabled.</summary>
        public event Action<FluidContact> OnExit { add => contacts.Exit.Add(value); remove => contacts.Exit.Remove(value); }

        /// <summary>Center of the shape now, world space, m: what torques are about.</summary>
        public Vector3 WorldCenter => shape == ColliderShape.Mesh && Deforming != null ? Deforming.WorldCenter
            : shape == ColliderShape.HeightField && heights != null ? transform.position + (Vector3)heights.Center
            : transform.TransformPoint(shape == ColliderShape.Mesh && field != null ? field.Bounds.center : center);

        /// <summary>Returns the effect of all simulations on the collider in the newest known steps, a few frames ago.</summary>
        /// <param name="force">Mean force, N, world space: pressure, impacts and friction. At rest the weight of the displaced water,
        /// upwards.</param>
        /// <param name="torque">Mean torque about <see cref="WorldCenter"/>, N m.</param>
        /// <returns>False before the first result, or while <see cref="MeasuresForce"/> is off and nothing lets the fluid carry its
        /// body.</returns>
        public bool TryGetForce(out Vector3 force, out Vector3 torque)
        {
            force = torque = Vector3.zero;
            bool known = false;
            PendingReadbacks.FinishResumed();
            foreach (FluidForce part in forces)
            {
                if (part.From == null || !part.From.IsRunning)
                    continue;
                force += part.Force;
                torque += part.Torque;
                known = true;
            }
            return known && (measuresForce || IsCarried);
        }

        /// <summary>Whether a component lets the fluid carry the collider's body, and needs its force.</summary>
        [field: NonSerialized] internal bool IsCarried { get; set; }

        /// <summary>The simulation that sums a first force; null while none does.</summary>
        [field: NonSerialized] internal FluidSimulation Awaited { get; private set; }

        /// <summary>The newest of each simulation; some may have ended since.</summary>
        internal List<FluidForce> Forces => forces;

        /// <summary>Takes a new result of a simulation instead of its last.</summary>
        internal void SetForce(in FluidForce force)
        {
            Awaited = null;
            int index = IndexOf(force.From);
            if (index >= 0)
            {
                forces[index] = force;
                return;
            }
            forces.Add(force);
            watches.Add(default);
        }

        /// <summary>The newest of one simulation.</summary>
        /// <returns>False where there is none.</returns>
        internal bool TryGetForceOf(FluidSimulation fluid, out FluidForce force)
        {
            int index = IndexOf(fluid);
            force = index >= 0 ? forces[index] : default;
            return index >= 0;
        }

        int IndexOf(FluidSimulation fluid)
        {
            for (int i = 0; i < forces.Count; i++)
                if (ReferenceEquals(forces[i].From, fluid))
                    return i;
            return -1;
        }

        /// <summary>Grows with each <see cref="Teleport"/>.</summary>
        [field: NonSerialized] internal int Teleports { get; private set; }

        /// <summary>Call after moving the object to another place: it has not moved through the water between, which stays where it is.</summary>
        public void Teleport() => Teleports++;

        /// <summary>Clamps what is out of range.</summary>
        /// <param name="problem">What was wrong and what is used instead; null if nothing was.</param>
        public bool Validate(out string problem)
        {
            problem = null;
            Limit.Finite("center", ref center, Vector3.zero, ref problem);
            Limit.Finite("size", ref size, Vector3.one, ref problem);
            Limit.Clamp("friction", ref friction, 0f, 1f, 0f, ref problem);
            Limit.Clamp("bounciness", ref bounciness, 0f, 1f, 0f, ref problem);
            contacts.Validate(ref problem);
            return problem == null;
        }

        /// <summary>Shape and place now, in world space and meters; false, logged once, where they make no collider.</summary>
        /// <param name="motion">Its poses are both the present one.</param>
        internal bool TryDescribe(out ColliderMotion motion)
        {
            string problem = Describe(out motion);
            LogProblem(problem);
            return problem == null;
        }

        void IHasProblems.ListProblems(List<string> problems)
        {
            problems.AddIfAny(clamped.Problem);
            bool heightsComeWithPlay = shape == ColliderShape.HeightField && heights == null && !Application.isPlaying;
            problems.AddIfAny(heightsComeWithPlay ? null : Describe(out _));
        }

        /// <summary>Works like <see cref="TryDescribe"/>, but logs nothing.</summary>
        /// <returns>Why it is not a collider; null if it is one.</returns>
        internal string Describe(out ColliderMotion motion)
        {
            string problem = placement.Follow(transform);
            RigidPose pose = new RigidPose(placement.PointOf(center), placement.rotation);
            float3 scale = placement.scale;
            motion = new ColliderMotion
            {
                shape = shape, friction = friction, bounciness = bounciness, insideOut = insideOut,
                contributesDensity = contributesDensity, reacts = NeedsForce, tellsWettedArea = contacts.HasListeners
            };
            switch (shape)
            {
                case ColliderShape.Sphere:
                    motion.size = radius * placement.EvenScale;
                    problem ??= Positive("radius", radius);
                    break;
                case ColliderShape.Capsule:
                    float scaled = radius * math.max(scale.x, scale.z);
                    motion.size = new float3(scaled, math.max(0.5f * height * scale.y - scaled, 0f), 0f);
                    problem ??= Positive("radius", radius) ?? Positive("height", height);
                    break;
                case ColliderShape.Box:
                    motion.size = 0.5f * (float3)size * scale;
                    problem ??= Positive("size", math.cmin(size));
                    break;
                case ColliderShape.Mesh when Deforming != null:
                    problem ??= Deforming.Describe(ref motion, ref pose);
                    break;
                case ColliderShape.Mesh:
                    problem ??= field == null ? "it is a mesh without a signed distance field. Bake one from the mesh and assign it."
                        : placement.DescribeField(field, ref motion, ref pose);
                    break;
                case ColliderShape.HeightField:
                    problem ??= DescribeHeights(ref motion, ref pose);
                    break;
            }
            problem ??= FieldAtlas.DeviceProblem(shape);
            motion.start = motion.end = pose;
            return problem;
        }

        bool NeedsForce => measuresForce || IsCarried || contacts.HasListeners;

        string IFluidCollider.Name => name;

        bool IFluidCollider.MeasuresForce => NeedsForce;

        bool IFluidCollider.IsCarried => IsCarried;

        int ISceneCollider.Layer => gameObject.layer;

        bool IFluidCollider.IsAlive => this != null && isActiveAndEnabled;

        int IFluidCollider.Teleports => Teleports;

        string IFluidCollider.Describe(out ColliderMotion motion) => Describe(out motion);

        bool IFluidCollider.TryDescribe(out ColliderMotion motion) => TryDescribe(out motion);

        void IFluidCollider.AwaitForce(FluidSimulation fluid) => Awaited = fluid;

        void IFluidCollider.SetForce(in FluidForce force) => SetForce(force);

        void IFluidCollider.RaiseContacts(FluidSimulation fluid)
        {
            int index = IndexOf(fluid);
            if (index < 0 || !contacts.HasListeners)
                return;
            FluidForce force = forces[index];
            ContactWatch watch = watches[index];
            ContactChange change = watch.Follow(force.Impulse.magnitude, force.Duration, contacts.HitImpulse);
            WettedArea wetted = watch.Follow(force.Wetted, WorldCenter);
            watches[index] = watch;
            contacts.Raise(change, new FluidContact(this, force, wetted));
        }

        // Its last result else acted for ever.
        bool IFluidCollider.Leave(FluidSimulation fluid)
        {
            if (ReferenceEquals(Awaited, fluid))
                Awaited = null;
            int index = IndexOf(fluid);
            if (index < 0)
                return false;
            bool touched = watches[index].Touches && contacts.HasListeners;
            forces.RemoveAt(index);
            watches.RemoveAt(index);
            return touched;
        }

        void IFluidCollider.SaveForce(FluidSimulation fluid, ref ForceRecord record)
        {
            record.flags |= ReferenceEquals(Awaited, fluid) ? ForceRecord.Awaits : 0;
            int index = IndexOf(fluid);
            if (index >= 0)
                record.Set(forces[index], watches[index]);
        }

        void IFluidCollider.LoadForce(FluidSimulation fluid, in ForceRecord record, Vector3 moved)
        {
            if (record.Has(ForceRecord.HasForce))
            {
                SetForce(record.ForceFrom(fluid, moved));
                watches[IndexOf(fluid)] = ContactWatch.Of(record);
            }
            if (record.Has(ForceRecord.Awaits))
                Awaited = fluid;
        }

        void IFluidCollider.RaiseExit(FluidSimulation fluid)
        {
            if (((IFluidCollider)this).IsAlive)     // disabled or destroyed since
                contacts.Raise(ContactChange.Exit, FluidContact.Exit(this, fluid));
        }

        // Any fluid whose box it reaches feels it.
        bool IRunsInEditMode.BelongsTo(FluidSimulation fluid) => true;

        FeatureSet IUsesFeatures.UsedFeatures => Features.Colliders;

        StageReferences IUsesFeatures.StageReferences => shaders;

        void OnEnable()
        {
            SceneColliders.Enabled.Add(this);
            Teleport();     // wherever it was before: also where no fluid has taken a step since
            shaders.Hold();
        }

        void OnDisable()
        {
            SceneColliders.Enabled.Remove(this);
            Awaited = null;
            forces.Clear();
            watches.Clear();
            shaders.Release();
        }

        // In the Editor, where the component was added or reset.
        void Reset() => ColliderFit.Fit(this);

        void OnValidate() => ChangedSettings.ApplyLater(this);

        void Changed() => ChangedSettings.Apply(this);

        void IAppliesSettings.CheckSettings()
        {
            problemIsKnown = false;
            Validate(out string problem);
            clamped.Set(problem);
        }

        void IAppliesSettings.ApplySettings()
        {
            clamped.Log(this);
            shaders.Follow(Features.Colliders);
        }

        string DescribeHeights(ref ColliderMotion motion, ref RigidPose pose)
        {
            if (heights == null)
                return "it is a height field without heights. Add a Fluid Terrain beside a Terrain, or set Heights.";
            if (heights.Texture == null)
                return "its heights were disposed of. Set others.";
            placement.DescribeHeights(heights, ref motion, ref pose);
            return null;
        }

        static string Positive(string what, float value) => value > 0f && !float.IsInfinity(value) ? null : $"its {what} is " +
            Invariant($"{value}. Set it above 0.");

        void LogProblem(string problem)
        {
            if (problem != null && !problemIsKnown)
                Debug.LogError($"Rill: FluidCollider '{name}' is left out: {problem}", this);
            problemIsKnown = problem != null;
        }
    }
}
