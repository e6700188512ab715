using System.Collections.Generic;
using UnityEngine;

namespace Rill
{
    /// <summary>
    /// Lets the fluid carry this object's Rigidbody: at each fixed step it gets the force and the torque that the fluid exerts on its
    /// <see cref="FluidCollider"/>, stable although they come a few frames late.
    /// </summary>
    /// <remarks>
    /// The water looks at the object frame by frame, so a body that does not interpolate is set to. Kinematic bodies are left
    /// alone. See the page on floating bodies for how a late force is made stable. Without the physics module this component
    /// is not there; <see cref="FluidCollider.TryGetForce"/> gives the force to an integrator of your own.
    /// </remarks>
    [AddComponentMenu("Rill/Fluid Buoyancy"), Icon(PackagePaths.Icon)]
    [DisallowMultipleComponent]
    [RequireComponent(typeof(FluidCollider), typeof(Rigidbody))]
    public sealed class FluidBuoyancy : MonoBehaviour, IHasProblems
    {
        const float PatienceTime = 5f;          // s without a fluid before that is logged

        [Tooltip("Mass of water that the body is taken to carry along until the forces have told it, as a fraction of the water that " +
        "it displaces; of turns always. Steadies the late force; rest and draft do not depend on it. 0.25 to 16; flat plates that lie " +
        "on the water need more.")]
        [Range(0.25f, 16f)]
        [SerializeField] float virtualMass = FloatingResponse.DefaultVirtualMass;

        [Tooltip("Fraction of the critical damping with which heave and turns die out, beside what the water does. 0 to 2.")]
        [Range(0f, 2f)]
        [SerializeField] float damping = FloatingResponse.DefaultDamping;

        [Tooltip("Largest acceleration that the fluid gives to the body, m/s². Above 0. Impacts are cut off there.")]
        [SerializeField] float maxAcceleration = FloatingResponse.DefaultMaxAcceleration;

        FluidCollider obstacle;
        Rigidbody body;
        FloatingBody floating;
        float waited;
        bool measuredBefore, problemIsKnown;
        string clamped;         // what the newest validation changed

        /// <summary>Mass of water that the body is taken to carry along until the forces have told it, as a fraction of the water that it
        /// displaces, 0.25 to 16.</summary>
        public float VirtualMass { get => virtualMass; set { virtualMass = value; OnValidate(); } }

        /// <summary>Fraction of the critical damping with which heave and turns die out, beside what the water does; 0 to 2.</summary>
        public float Damping { get => damping; set { damping = value; OnValidate(); } }

        /// <summary>Largest acceleration that the fluid gives to the body, m/s²: to its center of mass, and by turning it, to its farthest
        /// points.</summary>
        public float MaxAcceleration { get => maxAcceleration; set { maxAcceleration = value; OnValidate(); } }

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
            obstacle = GetComponent<FluidCollider>();
            body = GetComponent<Rigidbody>();
            measuredBefore = obstacle.MeasuresForce;
            obstacle.MeasuresForce = true;
            FloatingBody.Smooth(body);
            waited = 0f;
        }

        void OnDisable()
        {
            if (obstacle != null)
                obstacle.MeasuresForce = measuredBefore;
            floating = default;
        }

        void OnValidate()
        {
            problemIsKnown = false;
            if (!Validate(out clamped))
                Debug.LogWarning($"Rill: FluidBuoyancy '{name}': {clamped}", this);
        }

        void IHasProblems.ListProblems(List<string> problems)
        {
            problems.AddIfAny(clamped);
            var collider = GetComponent<FluidCollider>();       // its own problems are its own to tell
            if (collider.Describe(out ColliderMotion shape) == null)
                problems.AddIfAny(Problem(shape, FloatingBody.VolumeOf(shape, collider.Field)));
        }

        void FixedUpdate()
        {
            if (body.isKinematic || !obstacle.isActiveAndEnabled || !obstacle.TryDescribe(out ColliderMotion shape))
                return;
            float volume = FloatingBody.VolumeOf(shape, obstacle.Field);
            Say(Problem(shape, volume));
            if (problemIsKnown)
                return;

            floating.Begin(body, shape, volume, virtualMass, damping);
            foreach (FluidForce force in obstacle.Forces)
                floating.Add(force);
            if (!floating.IsKnown)
            {
                Wait();
                return;
            }

            waited = float.NegativeInfinity;
            floating.Apply(body, maxAcceleration);
        }

        string Problem(in ColliderMotion shape, float volume)
        {
            if (shape.shape == ColliderShape.Plane || shape.shape == ColliderShape.HeightField || shape.insideOut)
                return "its FluidCollider is a plane, a height field or inside out, which has no volume that floats. Use another " +
                    "shape, or a kinematic body.";
            if (!(volume > 0f))
                return "its FluidCollider has no volume. Give the shape sizes above 0; a mesh needs a field whose texture can be read.";
            return null;
        }

        void Wait()
        {
            waited += Time.fixedDeltaTime;
            if (waited < PatienceTime || DeviceGate.HasNoGraphics)
                return;
            waited = float.NegativeInfinity;
            Debug.LogWarning($"Rill: FluidBuoyancy '{name}' has met no FluidSimulation in {PatienceTime} s: none that runs has it in " +
                $"its box. Place it there, or enable the simulation.", this);
        }

        void Say(string problem)
        {
            if (problem != null && !problemIsKnown)
                Debug.LogError($"Rill: FluidBuoyancy '{name}' carries nothing: {problem}", this);
            problemIsKnown = problem != null;
        }
    }
}
