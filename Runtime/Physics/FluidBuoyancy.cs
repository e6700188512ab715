using System;
using System.Collections.Generic;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>
    /// Lets the fluid carry this object's Rigidbody: at each step of the physics it gets the force and the torque that the fluid exerts on its
    /// <see cref="FluidCollider"/>s, here and on objects below that have no other Rigidbody, stable although they come a few frames late.
    /// </summary>
    /// <remarks>
    /// Forces, torques and volumes of several colliders add up: where they overlap, their volume counts twice.
    /// The water looks at the object frame by frame, so a body that does not interpolate is set to. Kinematic bodies are left
    /// alone. Code adds the colliders that shall carry the body; in the Editor a new one that finds none adds one that fits the object.
    /// See the page on floating bodies for how a late force is made stable. Without the physics module this component
    /// is not there; <see cref="FluidCollider.TryGetForce"/> gives the force to an integrator of your own.
    /// </remarks>
    [AddComponentMenu("Rill/Fluid Buoyancy"), Icon(PackagePaths.Icon), ManualPage("floating", "fluid-buoyancy")]
    [DisallowMultipleComponent]
    [RequireComponent(typeof(Rigidbody))]
    public sealed class FluidBuoyancy : MonoBehaviour, IHasProblems, IUsesFeatures, IAppliesSettings, ICarriedBody
    {
        const float PatienceTime = 5f;          // s without a fluid before that is logged

        [Tooltip("Added mass that is assumed until the forces show it, as a fraction of the water that the body displaces; for turns it is " +
            "always assumed. Steadies the late force; rest and draft do not depend on it. 0.25 to 16; flat plates that lie on the water need more.")]
        [Range(0.25f, 16f)]
        [SerializeField] float virtualMass = FloatingResponse.DefaultVirtualMass;

        [Tooltip("Fraction of the critical damping with which heave and turns die out, beside what the water does. 0 to 2.")]
        [Range(0f, 2f)]
        [SerializeField] float damping = FloatingResponse.DefaultDamping;

        [Tooltip("Largest acceleration that the fluid gives to the body, m/s². Above 0. Impacts are cut off there.")]
        [SerializeField] float maxAcceleration = FloatingResponse.DefaultMaxAcceleration;

        [SerializeField, HideInInspector] StageReferences shaders = new StageReferences();

        readonly FloatingBody floating = new FloatingBody();
        readonly List<FluidCollider> colliders = new List<FluidCollider>();     // of the body
        readonly List<BodyPart> parts = new List<BodyPart>();
        [NonSerialized] Rigidbody body;
        [NonSerialized] float waited;
        [NonSerialized] bool problemIsKnown, lackIsKnown;
        [NonSerialized] ClampedSettings clamped;

        [KeptBetweenPlays] static Action<GameObject> addCollider;

        /// <summary>Adds a <see cref="FluidCollider"/> in the Editor, where it can be undone. Null in a player.</summary>
        internal static Action<GameObject> AddCollider { get => addCollider; set => addCollider = value; }

        /// <summary>Added mass that is assumed until the forces show it, as a fraction of the water that the body displaces, 0.25 to
        /// 16.</summary>
        public float VirtualMass { get => virtualMass; set { virtualMass = value; Changed(); } }

        /// <summary>Fraction of the critical damping with which heave and turns die out, beside what the water does; 0 to 2.</summary>
        public float Damping { get => damping; set { damping = value; Changed(); } }

        /// <summary>Largest acceleration that the fluid gives to the body, m/s²: to its center of mass, and by turning it, to its farthest
        /// points.</summary>
        public float MaxAcceleration { get => maxAcceleration; set { maxAcceleration = value; Changed(); } }

        /// <summary>Fraction of the body that was under water in the newest steps that are known, 0 to 1.</summary>
        public float SubmergedFraction => floating.SubmergedFraction;

        /// <summary>Clamps what is out of range.</summary>
        /// <param name="problem">What was wrong and what is used instead; null if nothing was.</param>
        public bool Validate(out string problem)
        {
            problem = null;
            Limit.Clamp("virtual mass", ref virtualMass, 0.25f, 16f, FloatingResponse.DefaultVirtualMass, ref problem);
            Limit.Clamp("damping", ref damping, 0f, 2f, FloatingResponse.DefaultDamping, ref problem);
            Limit.Clamp("max acceleration", ref maxAcceleration, 0.01f, 1e6f, FloatingResponse.DefaultMaxAcceleration, ref problem);
            return problem == null;
        }

        void OnEnable()
        {
            body = GetComponent<Rigidbody>();
            FloatingBody.Smooth(body);
            FindColliders();
            CarriedBodies.Enabled.Add(this);
            waited = 0f;
            lackIsKnown = false;
            shaders.Hold();
        }

        // In the Editor, where the component was added or reset.
        void Reset() => AddMissingCollider();

        /// <summary>Adds a collider to the object where the body has none yet.</summary>
        internal void AddMissingCollider()
        {
            body = GetComponent<Rigidbody>();
            foreach (FluidCollider collider in GetComponentsInChildren<FluidCollider>(true))
                if (IsOf(body, collider))
                    return;
            addCollider?.Invoke(gameObject);
        }

        void OnDisable()
        {
            CarriedBodies.Enabled.Remove(this);
            SetCarried(false);
            colliders.Clear();
            parts.Clear();
            floating.Reset();
            shaders.Release();
        }

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
            shaders.Follow(UsedFeatures);
        }

        // The water is asked for its level where a body lies on the ground or is light.
        static FeatureSet UsedFeatures => Features.Queries;

        FeatureSet IUsesFeatures.UsedFeatures => UsedFeatures;

        StageReferences IUsesFeatures.StageReferences => shaders;

        void IHasProblems.ListProblems(List<string> problems)
        {
            problems.AddIfAny(clamped.Problem);
            bool lacksColliders = true;
            foreach (FluidCollider collider in GetComponentsInChildren<FluidCollider>())
            {
                if (!collider.enabled || !IsOf(GetComponent<Rigidbody>(), collider))
                    continue;
                lacksColliders = false;
                if (collider.Describe(out ColliderMotion shape) == null
                    && Problem(shape, FloatingBody.VolumeOf(shape, collider.Field)) is string problem)
                    problems.Add($"'{collider.name}': {problem}");
            }
            problems.AddIfAny(lacksColliders ? LackProblem : null);
        }

        Component ICarriedBody.Body => body;

        bool ICarriedBody.IsCarriedBy(FluidSimulation fluid)
        {
            if (body == null || body.isKinematic)
                return false;
            FindColliders();
            foreach (FluidCollider collider in colliders)
                if (fluid.Inputs.Colliders.IsNear(collider))
                    return true;
            return false;
        }

        void ICarriedBody.Save(FluidSimulation fluid, SnapshotBody to, SnapshotCapture capture) => floating.Save(body, fluid, to, capture);

        bool ICarriedBody.Restore(SnapshotBody from, in BoxMotion box) => BodyPlacement.Restore(body, from.record, box);

        void ICarriedBody.Load(FluidSimulation fluid, SnapshotBody from, in BoxMotion box) => floating.Load(fluid, from, box);

        void FixedUpdate() => Act(PhysicsStep.OfFixedUpdate(gameObject));

        void Update() => Act(PhysicsStep.OfUpdate(gameObject));

        void Act(in PhysicsStep step)
        {
            if (step.Time <= 0f || body.isKinematic)
                return;
            PendingReadbacks.FinishResumed();
            FindColliders();
            FindParts();
            if (colliders.Count == 0)
                LogLack();
            if (parts.Count == 0)
                return;
            floating.Begin(body, step, virtualMass, damping);
            foreach (BodyPart part in parts)
                floating.AddPart(part);
            for (int i = 0; i < parts.Count; i++)
            {
                floating.Await(ColliderOf(i).Awaited);
                foreach (FluidForce force in ColliderOf(i).Forces)
                    AddFluid(force.From, i);
            }
            if (floating.TryApply(body, maxAcceleration))
                waited = float.NegativeInfinity;
            else
                Wait(step.Time);
        }

        // Also those that came, went or were moved below another object since the last step.
        void FindColliders()
        {
            SetCarried(false);
            GetComponentsInChildren(false, colliders);
            for (int i = colliders.Count - 1; i >= 0; i--)
                if (!colliders[i].enabled || !IsOf(body, colliders[i]))
                    colliders.RemoveAt(i);
            SetCarried(true);
        }

        void SetCarried(bool isCarried)
        {
            foreach (FluidCollider collider in colliders)
                if (collider != null)       // destroyed since
                    collider.IsCarried = isCarried;
        }

        // Whether a collider belongs to a body, as in Unity's physics.
        static bool IsOf(Rigidbody body, FluidCollider collider) => collider.GetComponentInParent<Rigidbody>() == body;

        void FindParts()
        {
            parts.Clear();
            string problem = null;
            FluidCollider leftOut = null;
            foreach (FluidCollider collider in colliders)
            {
                if (!collider.TryDescribe(out ColliderMotion shape))
                    continue;       // which is logged
                float volume = FloatingBody.VolumeOf(shape, collider.Field);
                string own = Problem(shape, volume);
                if (own == null)
                {
                    parts.Add(new BodyPart { collider = collider, shape = shape, field = collider.Field, volume = volume });
                    continue;
                }
                problem = own;
                leftOut = collider;
            }
            LogProblem(problem, leftOut);
        }

        // All parts that one fluid told of, at the first of them.
        void AddFluid(FluidSimulation fluid, int first)
        {
            if (fluid == null || !fluid.IsRunning)
                return;         // it has ended
            for (int i = 0; i < first; i++)
                if (ColliderOf(i).TryGetForceOf(fluid, out _))
                    return;
            for (int i = first; i < parts.Count; i++)
                if (ColliderOf(i).TryGetForceOf(fluid, out FluidForce force))
                    floating.Add(parts[i], force);
            floating.EndFluid(fluid);
        }

        FluidCollider ColliderOf(int part) => (FluidCollider)parts[part].collider;

        static string Problem(in ColliderMotion shape, float volume)
        {
            if (shape.shape == ColliderShape.Plane || shape.shape == ColliderShape.HeightField || shape.insideOut)
                return "its FluidCollider is a plane, a height field or inside out, which has no volume that floats. Use another " +
                    "shape, or a kinematic body.";
            if (!(volume > 0f))
                return "its FluidCollider has no volume. Give the shape sizes above 0; a mesh needs a field whose texture can be read.";
            return null;
        }

        const string LackProblem = "neither its object nor one below, without a Rigidbody of its own, has a Fluid Collider that is enabled. " +
            "Add one to each shape that shall float, or leave the body to Floating Layers of a Fluid Physics Colliders.";

        void LogLack()
        {
            if (!lackIsKnown)
                Debug.LogWarning($"Rill: FluidBuoyancy '{name}' carries nothing: {LackProblem}", this);
            lackIsKnown = true;
        }

        void Wait(float time)
        {
            waited += time;
            if (waited < PatienceTime || DeviceGate.HasNoGraphics)
                return;
            waited = float.NegativeInfinity;
            Debug.LogWarning(Invariant($"Rill: FluidBuoyancy '{name}' has met no FluidSimulation in {PatienceTime} s: none that runs ") +
                "has it in its box and the layer of its FluidCollider in Fluid Collider Layers. Place it there, add the layer, or enable " +
                "the simulation.", this);
        }

        void LogProblem(string problem, FluidCollider leftOut)
        {
            if (problem != null && !problemIsKnown)
                Debug.LogError($"Rill: FluidBuoyancy '{name}' {(parts.Count == 0 ? "carries nothing" : $"leaves out '{leftOut.name}'")}: " +
                    problem, this);
            problemIsKnown = problem != null;
        }
    }
}
