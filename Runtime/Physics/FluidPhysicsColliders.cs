using System;
using System.Collections.Generic;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>
    /// Lets the fluid on this object take the colliders of Unity's physics that lie on some layers, without a component on each: box,
    /// sphere, capsule, character controller, terrain, and mesh by a baked field.
    /// </summary>
    /// <remarks>
    /// Before the steps of a frame the physics is asked which colliders reach into the fluid's box and what lies half as far around it. It
    /// is the physics of the fluid's scene: a scene with local physics, and a prefab that is edited, have one of their own.
    /// They follow their objects, and have the sizes that the physics gives them. Triggers are not colliders. A collider beside an enabled
    /// <see cref="FluidCollider"/>, or whose Rigidbody has one or a <see cref="FluidBuoyancy"/>, is left to that, also where the fluid does
    /// not take its layer. Without the physics module this component is not there.
    /// </remarks>
    [AddComponentMenu("Rill/Fluid Physics Colliders"), Icon(PackagePaths.Icon), ManualPage("colliders", "fluid-physics-colliders")]
    [DisallowMultipleComponent]
    [RequireComponent(typeof(FluidSimulation))]
    public sealed class FluidPhysicsColliders : MonoBehaviour, IColliderSource, IBodySource, IHasProblems, IUsesFeatures, IRunsInEditMode,
        IAppliesSettings
    {
        const int FirstFound = 64, MaxFound = 4096;

        [Tooltip("Layers whose colliders hold the water. Nothing costs nothing.")]
        [SerializeField] LayerMask colliderLayers;

        [Tooltip("Layers whose colliders hold the water too, and whose free Rigidbodies it carries. Nothing costs nothing.")]
        [SerializeField] LayerMask floatingLayers;

        [Tooltip("Fields of meshes: a Mesh Collider is taken where its mesh has one.")]
        [SerializeField] List<MeshField> meshFields = new List<MeshField>();

        [Tooltip("Fraction of the velocity along the surface that touching water loses in 1/60 s. 0 slips, 1 sticks.")]
        [Range(0f, 1f)]
        [SerializeField] float friction;

        [Tooltip("Fraction of the velocity into the surface that is given back. 0 to 1.")]
        [Range(0f, 1f)]
        [SerializeField] float bounciness;

        [Tooltip("Counts the colliders as water in the density of what touches them. Without, water thins out towards the surface.")]
        [SerializeField] bool contributesDensity = true;

        [SerializeField] ContactEvents contacts = ContactEvents.Default;

        [SerializeField, HideInInspector] StageReferences shaders = new StageReferences();

        readonly Dictionary<Collider, GatheredCollider> known = new Dictionary<Collider, GatheredCollider>();
        readonly List<IFluidCollider> taken = new List<IFluidCollider>();       // all of known, in the order in which they came
        readonly List<GatheredCollider> leavers = new List<GatheredCollider>();     // whose listeners are to be told
        readonly Dictionary<Rigidbody, GatheredBody> carried = new Dictionary<Rigidbody, GatheredBody>();
        readonly List<GatheredBody> bodies = new List<GatheredBody>();      // all of carried, in the order in which they came
        [NonSerialized] Collider[] found;       // null until a query was made
        [NonSerialized] int round;
        [NonSerialized] bool tooManyIsKnown, listens;
        [NonSerialized] FluidSimulation fluid;
        [NonSerialized] ClampedSettings clamped;

        /// <summary>Layers whose colliders hold the water.</summary>
        public LayerMask ColliderLayers { get => colliderLayers; set => colliderLayers = value; }

        /// <summary>Layers whose colliders hold the water too, and whose free Rigidbodies it carries. They need not be among
        /// <see cref="ColliderLayers"/>.</summary>
        public LayerMask FloatingLayers { get => floatingLayers; set => floatingLayers = value; }

        /// <summary>Fields of meshes: a Mesh Collider is taken where its mesh has one. The list may be changed at any time.</summary>
        public List<MeshField> MeshFields { get => meshFields; set => meshFields = value ?? new List<MeshField>(); }

        /// <summary>Fraction of the velocity along the surface that touching water loses in 1/60 s, 0 to 1.</summary>
        public float Friction { get => friction; set { friction = value; Changed(); } }

        /// <summary>Fraction of the velocity into the surface that is given back, 0 to 1.</summary>
        public float Bounciness { get => bounciness; set { bounciness = value; Changed(); } }

        /// <summary>Whether the colliders count as water to the density of what touches them.</summary>
        public bool ContributesDensity { get => contributesDensity; set => contributesDensity = value; }

        /// <summary>Impulse of one reading from which it is a hit, N s, 0.000001 to 1e9. The next can come below half of it.</summary>
        public float HitImpulse { get => contacts.HitImpulse; set { contacts.HitImpulse = value; Changed(); } }

        /// <summary>Water has come to a collider. Told two or three frames late, as all contacts are; forces are read back while somebody
        /// listens.</summary>
        public event Action<FluidContact> OnEnter { add => contacts.Enter.Add(value); remove => contacts.Enter.Remove(value); }

        /// <summary>The fluid gave a collider an impulse as large as <see cref="HitImpulse"/> in one reading, which is that of one to three
        /// frames.</summary>
        public event Action<FluidContact> OnHit { add => contacts.Hit.Add(value); remove => contacts.Hit.Remove(value); }

        /// <summary>A collider has felt no water for 0.2 s, or has left the fluid's box. Not told where it or the fluid is disabled.</summary>
        public event Action<FluidContact> OnExit { add => contacts.Exit.Add(value); remove => contacts.Exit.Remove(value); }

        /// <summary>The fluid that it gathers for.</summary>
        internal FluidSimulation Fluid => fluid;

        /// <summary>Whether anybody listened before the newest steps.</summary>
        internal bool ListensToContacts => listens;

        /// <summary>Whether the physics has been asked.</summary>
        internal bool HasAsked => found != null;

        /// <summary>Those that the newest query found, in the order in which they came.</summary>
        internal List<IFluidCollider> Taken => taken;

        /// <summary>Those that the fluid carries.</summary>
        internal List<GatheredBody> Bodies => bodies;

        /// <summary>Clamps what is out of range.</summary>
        /// <param name="problem">What was wrong and what is used instead; null if nothing was.</param>
        public bool Validate(out string problem)
        {
            problem = null;
            Limit.Clamp("friction", ref friction, 0f, 1f, 0f, ref problem);
            Limit.Clamp("bounciness", ref bounciness, 0f, 1f, 0f, ref problem);
            contacts.Validate(ref problem);
            return problem == null;
        }

        /// <summary>Field of a mesh; null if it has none.</summary>
        internal SignedDistanceField FieldOf(Mesh mesh)
        {
            if (mesh == null)
                return null;
            foreach (MeshField pair in meshFields)
                if (pair.Mesh == mesh && pair.Field != null)
                    return pair.Field;
            return null;
        }

        /// <summary>Lists the meshes of the Mesh Colliders near the box, now and each once, that have no field. For the editor.</summary>
        internal void ListMissingFields(List<Mesh> missing)
        {
            var of = GetComponent<FluidSimulation>();
            of.GetPose(out Vector3 center, out Quaternion rotation);
            int count = FindOverlaps(center, rotation, of.DomainSize, of.ParticleSpacing);
            for (int i = 0; i < count; i++)
                if (found[i] is MeshCollider mesh && mesh.sharedMesh != null && FieldOf(mesh.sharedMesh) == null && !IsLeftOut(mesh)
                    && !missing.Contains(mesh.sharedMesh))
                    missing.Add(mesh.sharedMesh);
        }

        List<IFluidCollider> IColliderSource.Gather(Vector3 center, Quaternion rotation, Vector3 size, float spacing)
        {
            if (TakenLayers == 0)
            {
                DropAll();
                return taken;
            }
            round++;
            int count = FindOverlaps(center, rotation, size, spacing);
            for (int i = 0; i < count; i++)
                if (!IsLeftOut(found[i]))
                    TryCollect(found[i]);
            DropOthers();
            listens = contacts.HasListeners;
            FollowBodies();
            return taken;
        }

        void IBodySource.ListBodies(List<ICarriedBody> of)
        {
            foreach (GatheredBody body in bodies)
                of.Add(body);
        }

        ICarriedBody IBodySource.CarrierOf(Component body)
            => floatingLayers != 0 && body is Rigidbody rigid && rigid != null && !rigid.TryGetComponent(out FluidBuoyancy _) ? BodyOf(rigid) : null;

        void IHasProblems.ListProblems(List<string> problems)
        {
            problems.AddIfAny(clamped.Problem);
            problems.AddIfAny(TakenLayers == 0
                ? "it takes no colliders: Collider Layers is Nothing. Choose the layers of what holds the water." : null);
            problems.AddIfAny(tooManyIsKnown ? TooManyProblem : null);
            foreach (IFluidCollider collider in taken)
            {
                if (!collider.IsAlive)
                    continue;
                if (collider.Describe(out _) is string problem)
                    problems.Add($"The collider '{collider.Name}' is left out: {problem}");
                if (((GatheredCollider)collider).LeftOut is string leftOut)
                    problems.Add($"The collider '{collider.Name}': {leftOut}");
            }
        }

        bool IRunsInEditMode.BelongsTo(FluidSimulation of) => TryGetComponent(out FluidSimulation own) && own == of;

        /// <summary>Layers whose colliders hold the water.</summary>
        internal int TakenLayers => colliderLayers | floatingLayers;

        // The water is asked for its level where a body that it carries lies on the ground or is light.
        FeatureSet UsedFeatures => floatingLayers != 0 ? Features.Colliders | Features.Queries : Features.Colliders;

        FeatureSet IUsesFeatures.UsedFeatures => UsedFeatures;

        StageReferences IUsesFeatures.StageReferences => shaders;

        static string TooManyProblem
            => Invariant($"more than {MaxFound} colliders of its layers are near its box, and the rest is left out. Take objects out of ") +
            "Collider Layers.";

        void OnEnable()
        {
            fluid = GetComponent<FluidSimulation>();
            fluid.Inputs.Colliders.Source = this;
            shaders.Hold();
        }

        void OnDisable()
        {
            if (fluid != null && ReferenceEquals(fluid.Inputs.Colliders.Source, this))
                fluid.Inputs.Colliders.Source = null;
            leavers.Clear();
            DropAll();
            shaders.Release();
        }

        // Outside of the fluid's steps: listeners may do anything to the scene.
        void Update()
        {
            for (int i = 0; i < leavers.Count; i++)
                leavers[i].RaiseExit(fluid);
            leavers.Clear();
            foreach (GatheredBody body in bodies)
                body.Carry(fluid, true);
        }

        void FixedUpdate()
        {
            foreach (GatheredBody body in bodies)
                body.Carry(fluid, false);
        }

        /// <summary>Calls who listens.</summary>
        internal void Raise(ContactChange change, in FluidContact contact) => contacts.Raise(change, contact);

        void OnValidate() => ChangedSettings.ApplyLater(this);

        void Changed() => ChangedSettings.Apply(this);

        void IAppliesSettings.CheckSettings()
        {
            Validate(out string problem);
            clamped.Set(problem);
        }

        void IAppliesSettings.ApplySettings()
        {
            clamped.Log(this);
            shaders.Follow(UsedFeatures);
        }

        int FindOverlaps(Vector3 center, Quaternion rotation, Vector3 size, float spacing)
        {
            Vector3 half = size + 2f * spacing * Vector3.one;       // half the box more on all sides: what is fast is seen before it comes
            found ??= new Collider[FirstFound];
            if (!Application.isPlaying)     // no step of the physics follows the objects there
                UnityEngine.Physics.SyncTransforms();
            PhysicsScene physics = gameObject.scene.GetPhysicsScene();
            int count;
            while ((count = physics.OverlapBox(center, half, found, rotation, TakenLayers,
                QueryTriggerInteraction.Ignore)) == found.Length && count < MaxFound)
                Array.Resize(ref found, Math.Max(2 * count, FirstFound));
            bool tooMany = count == MaxFound;
            if (tooMany && !tooManyIsKnown)
                Debug.LogError($"Rill: FluidPhysicsColliders '{name}': {TooManyProblem}", this);
            tooManyIsKnown = tooMany;
            return count;
        }

        // Whether components of the fluid stand for it.
        static bool IsLeftOut(Collider collider)
        {
            if (collider.TryGetComponent(out FluidCollider own) && own.isActiveAndEnabled)
                return true;
            Rigidbody body = collider.attachedRigidbody;
            return body != null && (body.TryGetComponent(out own) && own.isActiveAndEnabled
                || body.TryGetComponent(out FluidBuoyancy buoyancy) && buoyancy.isActiveAndEnabled);
        }

        // A collider's ground may throw: the others are collected all the same.
        void TryCollect(Collider collider)
        {
            try
            {
                Collect(collider);
            }
            catch (Exception problem) when (fluid != null)
            {
                fluid.Inputs.Thrown.Log(problem, collider, fluid);
            }
        }

        void Collect(Collider collider)
        {
            if (!known.TryGetValue(collider, out GatheredCollider gathered))
            {
                gathered = new GatheredCollider(this, collider);
                known.Add(collider, gathered);
                taken.Add(gathered);
            }
            gathered.Round = round;
        }

        // Drops what the newest query did not find; the others keep their order.
        void DropOthers()
        {
            int kept = 0;
            for (int i = 0; i < taken.Count; i++)
            {
                var gathered = (GatheredCollider)taken[i];
                if (gathered.Round == round)
                {
                    taken[kept++] = gathered;
                    continue;
                }
                if (gathered.Leave(fluid) && gathered.IsAlive)
                    leavers.Add(gathered);
                Drop(gathered);
            }
            taken.RemoveRange(kept, taken.Count - kept);
        }

        void FollowBodies()
        {
            foreach (GatheredBody body in bodies)
                body.Parts.Clear();
            foreach (IFluidCollider collider in taken)
            {
                var gathered = (GatheredCollider)collider;
                Rigidbody body = floatingLayers != 0 ? gathered.FreeBody(floatingLayers) : null;
                gathered.Floats = body != null;
                if (gathered.Floats)
                    BodyOf(body).Parts.Add(gathered);
            }
            for (int i = bodies.Count - 1; i >= 0; i--)
            {
                if (bodies[i].Parts.Count > 0)
                    continue;
                bodies[i].Drop();
                carried.Remove(bodies[i].Body);
                bodies.RemoveAt(i);
            }
        }

        GatheredBody BodyOf(Rigidbody body)
        {
            if (carried.TryGetValue(body, out GatheredBody known))
                return known;
            known = new GatheredBody(body);
            carried.Add(body, known);
            bodies.Add(known);
            return known;
        }

        void DropAll()
        {
            foreach (IFluidCollider collider in taken)
                Drop((GatheredCollider)collider);
            taken.Clear();
            foreach (GatheredBody body in bodies)
                body.Drop();
            bodies.Clear();
            carried.Clear();
        }

        void Drop(GatheredCollider gathered)
        {
            known.Remove(gathered.Collider);
            gathered.Drop();
        }
    }
}
