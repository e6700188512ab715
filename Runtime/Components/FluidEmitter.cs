using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>
    /// Lets fluid into a <see cref="FluidSimulation"/>: a tap, a hose, a shower, a volume that is kept full. After any time it
    /// has let in its rate times that time, to within one particle, as far as there is room and capacity.
    /// </summary>
    /// <remarks>
    /// A particle due is put where it would have got to by the end of the substep. A jet and a spray press away the water that is there; a fill and a
    /// mesh wait for room. Where a collider lies there or before it, or the water cannot yield, it waits, and after a second's worth of
    /// waiting particles the oldest are given up and counted as blocked. What the simulation's
    /// capacity does not hold is refused and counted. Changes to the vertices of a mesh are seen when the mesh is set again.
    /// </remarks>
    [AddComponentMenu("Rill/Fluid Emitter"), Icon(PackagePaths.Icon), ManualPage("sources", "fluid-emitter")]
    public sealed class FluidEmitter : FluidPart, IEmitter
    {
        const int NoShape = FirstOwnProblem, TooFast = FirstOwnProblem + 1, NoCapacity = FirstOwnProblem + 2, Shut = FirstOwnProblem + 3,
            Torn = FirstOwnProblem + 4;
        const float MaxWait = 1f;           // s
        const float MaxTravel = 1f;         // spacings in a step, of a jet of thick fluid
        const float MinSpeed = 0.01f, MaxSpeed = 1000f, MaxRate = 1e6f;

        [Tooltip("Where the fluid comes from: a box, sphere or disc around this object, or the surface of a mesh along its normals.")]
        [SerializeField] EmitterShape shape = EmitterShape.Disc;

        [Tooltip("Jet: a closed stream along this object's forward axis, as wide as rate and speed make it. Spray: from the whole " +
            "cross-section in turn. Fill: into the volume, where there is room.")]
        [SerializeField] EmitterMode mode = EmitterMode.Jet;

        [Tooltip("Size of the box, m. A jet leaves through x and y.")]
        [SerializeField] Vector3 size = new Vector3(0.2f, 0.2f, 0.2f);

        [Tooltip("Radius of the sphere or disc, m.")]
        [SerializeField] float radius = 0.1f;

        [Tooltip("Mesh whose surface emits. Scaled with this object.")]
        [SerializeField] Mesh mesh;

        [Tooltip("Volume let in, m³/s. 0 to 1e6. 0.001 is a liter a second.")]
        [SerializeField] float rate = 0.01f;

        [Tooltip("Speed at which the fluid leaves, m/s. 0.01 to 1000; a fill may have 0.")]
        [SerializeField] float speed = 2f;

        [Tooltip("Largest angle between a particle's velocity and the axis, degrees. 0 to 180.")]
        [Range(0f, 180f)]
        [SerializeField] float spread;

        [Tooltip("Fraction of this object's own velocity, turning included, that the fluid takes along. 0 to 1. 1: as from a real " +
            "nozzle. After putting the object somewhere else call Teleport().")]
        [Range(0f, 1f)]
        [SerializeField] float inheritVelocity = 1f;

        [Tooltip("Starts by itself, with the fluid.")]
        [SerializeField] bool playOnEnable = true;

        [Tooltip("Fluid time from its start until it lets fluid in, s. 0 or more.")]
        [SerializeField] float delay;

        [Tooltip("Fluid time during which it lets fluid in, s. 0: for ever.")]
        [SerializeField] float duration;

        [Tooltip("Material of what it lets in: density and viscosity. None: that of Phase. Takes 12 bytes a particle of capacity.")]
        [SerializeField] FluidMaterialAsset material;

        [Tooltip("Number of a look and a material, 0 to 7: of Phase Looks of the Fluid Surface or Phase Colors of the Particle Renderer, and of " +
            "Phase Materials of the Fluid Simulation. A Material has its own. Other than 0 takes 8 bytes a particle of capacity.")]
        [Range(0, 7)]
        [SerializeField] int phase;

        [Tooltip("Fluid time after which its particles are removed, s. 0: never. Other than 0 takes 8 bytes a particle of capacity.")]
        [SerializeField] float lifetime;

        EmissionClock clock;
        EmitterPositions positions;
        PositionsKey positionsKey;
        [NonSerialized] string positionsProblem;
        [NonSerialized] bool isOn;
        [NonSerialized] bool saysLast;              // one step after the last tells the GPU that nothing waits any more
        [NonSerialized] int searchSteps;            // until every place was tried
        [NonSerialized]
        float3 takenAlong;          // velocity of its own that the fluid took along in the last step, d/s, in the domain's frame

        /// <summary>Shape that the fluid comes from.</summary>
        public EmitterShape Shape { get => shape; set { shape = value; Changed(); } }
        /// <summary>Closed stream, spray or fill.</summary>
        public EmitterMode Mode { get => mode; set { mode = value; Changed(); } }
        /// <summary>Size of the box, m.</summary>
        public Vector3 Size { get => size; set { size = value; Changed(); } }
        /// <summary>Radius of the sphere or disc, m.</summary>
        public float Radius { get => radius; set { radius = value; Changed(); } }
        /// <summary>Mesh whose surface emits.</summary>
        public Mesh Mesh { get => mesh; set { mesh = value; Changed(); } }
        /// <summary>Volume let in, m³/s. Out-of-range values are clamped with a warning.</summary>
        public float Rate { get => rate; set { rate = value; Changed(); } }
        /// <summary>Speed at which the fluid leaves, m/s. Out-of-range values are clamped with a warning.</summary>
        public float Speed { get => speed; set { speed = value; Changed(); } }
        /// <summary>Largest angle between a particle's velocity and the axis, degrees.</summary>
        public float Spread { get => spread; set { spread = value; Changed(); } }
        /// <summary>
        /// Fraction of the object's own velocity that the fluid takes along, 0 to 1: of its path in the simulation's box since the last
        /// steps over the time between, and of its turning at the outlet. At most 1000 m/s; nothing after
        /// <see cref="FluidPart.Teleport"/>. Out-of-range values are clamped with a warning.
        /// </summary>
        /// <remarks>1 by default: as from a real nozzle, whose jet leaves at rest density however it moves.</remarks>
        public float InheritVelocity { get => inheritVelocity; set { inheritVelocity = value; Changed(); } }
        /// <summary>Whether it begins by itself, with the fluid.</summary>
        public bool PlayOnEnable { get => playOnEnable; set => playOnEnable = value; }
        /// <summary>Fluid time from its start until it lets fluid in, s.</summary>
        public float Delay { get => delay; set { delay = value; Changed(); } }
        /// <summary>Fluid time during which it lets fluid in, s; 0 for ever.</summary>
        public float Duration { get => duration; set { duration = value; Changed(); } }
        /// <summary>Material of what it lets in; null for that of <see cref="Phase"/>.</summary>
        public FluidMaterialAsset Material { get => material; set { material = value; Changed(); } }
        /// <summary>Number of the particles' look and material, 0 to 7, where there is no <see cref="Material"/>.</summary>
        public int Phase { get => phase; set { phase = value; Changed(); } }
        /// <summary>Fluid time after which its particles are removed, s; 0 for never.</summary>
        public float Lifetime { get => lifetime; set { lifetime = value; Changed(); } }

        /// <summary>Whether it lets fluid in now: started, past its delay and within its duration.</summary>
        public bool IsEmitting => isOn && isActiveAndEnabled && clock.Time >= delay && clock.Time < End;

        /// <summary>Velocity with which the fluid left the center of the outlet in the last step, m/s, world space, but for the spread.</summary>
        internal Vector3 LeavingVelocity => transform.forward * LeavingSpeed
            + (Simulation != null ? Simulation.DomainToWorld.MultiplyVector(takenAlong) : Vector3.zero);

        /// <summary>Volume that was due since its last start, m³: what it let in and what waits, was refused or was given up.</summary>
        public double DueVolume => clock.Due * ParticleVolume;

        /// <summary>Particles let in since the simulation's start, as far as the GPU has told: two or three frames ago.</summary>
        public int Emitted => Count(EmitterStates.Word.Emitted);
        /// <summary>Volume let in since the simulation's start, m³, as far as the GPU has told: two or three frames ago.</summary>
        public double EmittedVolume => Emitted * ParticleVolume;
        /// <summary>Particles due that wait for room, as far as the GPU has told.</summary>
        public int Waiting => Count(EmitterStates.Word.Waiting);
        /// <summary>Particles given up for want of room since the simulation's start, as far as the GPU has told.</summary>
        public int Blocked => Count(EmitterStates.Word.Blocked);
        /// <summary>Particles that the simulation's capacity did not hold since its start, as far as the GPU has told.</summary>
        public int Refused => Count(EmitterStates.Word.Refused);

        /// <summary>Lets fluid in from now on, after the delay and for the duration. Begins again if it runs.</summary>
        public void StartEmission()
        {
            clock = default;
            isOn = true;
        }

        /// <summary>Lets no more in. What waits for room is given up.</summary>
        public void StopEmission() => isOn = false;

        internal override PartKind PartKind => PartKind.Emitter;

        internal override void OnRestart()
        {
            base.OnRestart();
            clock = default;
            isOn = playOnEnable;
            takenAlong = float3.zero;
        }

        /// <summary>Goes on with particles of another size.</summary>
        void IEmitter.OnResampled() => clock.Resample(ParticleVolume);

        EmitterRecord IEmitter.Save(in DomainFrame frame)
            => new EmitterRecord { part = SavePart(frame), clock = clock.Record, isOn = isOn ? 1u : 0u, saysLast = saysLast ? 1u : 0u };

        void IEmitter.Load(in EmitterRecord record, in DomainFrame frame, float tolerance)
        {
            LoadPart(record.part, frame, tolerance);
            clock.Record = record.clock;
            isOn = record.isOn != 0;
            saysLast = record.saysLast != 0;
        }

        /// <summary>Describes its work in the next step.</summary>
        /// <param name="from">Fraction of the frame at which the step starts.</param>
        /// <param name="to">Fraction of the frame at which it ends.</param>
        /// <param name="frameTime">Time in which this came from where it was at the last frame's steps, s, above 0.</param>
        /// <param name="isTarget">Whether a drain gives it particles.</param>
        /// <returns>Whether it does anything.</returns>
        bool IEmitter.TryGetStep(in DomainFrame frame, float spacing, float step, float from, float to, float frameTime, bool isTarget,
            out EmitterStep result)
        {
            result = default;
            takenAlong = float3.zero;
            if (!TryGetMotion(frame, from, to, out RigidPose start, out RigidPose end) || !TryGetPositions(spacing))
                return false;
            EmissionClock.Fraction fraction = default;
            double until = End;
            // Particles that wait at the end of the duration still have the full time to find room.
            bool lingers = isOn && clock.Time < until + MaxWait;
            if (isOn)
                fraction = clock.Advance(step, rate, delay, until, ParticleVolume, Emitters.MaxCandidates);
            bool takesPart = lingers || isTarget;
            if (!takesPart && !saysLast)
                return false;
            saysLast = takesPart;

            float perSecond = (float)(rate / ParticleVolume);
            result = new EmitterStep
            {
                number = Number,
                positions = positions,
                start = start,
                end = end,
                speed = LeavingSpeed / spacing,
                cosSpread = math.cos(math.radians(spread)),
                due = fraction.due,
                firstSerial = (uint)fraction.first,
                firstAge = fraction.firstAge,
                interval = fraction.interval,
                maxWaiting = lingers ? (int)math.min(math.ceil(perSecond * MaxWait), int.MaxValue / 2) : 0,
                isLast = !takesPart,
                phase = Simulation.Phases.PhaseOf(material, phase),
                lifetimeSteps = lifetime > 0f ? math.max((int)math.round(lifetime / step), 1) : 0,
            };
            result.ChoosePositions(perSecond, step);
            result.Inherit(inheritVelocity, (to - from) * frameTime, MaxSpeed / spacing);
            takenAlong = result.velocity;
            searchSteps = result.StepsOfASearch;
            if (fraction.due > 0 && ShouldLog(TooFast, rate > 1.01f * MaxRateOf(spacing, step)))
                Warn(RateProblem(spacing, step));
            if (fraction.due > 0 && ShouldLog(Torn, IsTorn(Simulation)))
                Warn(TornProblem(Simulation));
            return true;
        }

        int IEmitter.NamedPhase => material == null ? phase : 0;

        /// <summary>Says once by name what the numbers from the GPU tell.</summary>
        void IEmitter.ReportRefused()
        {
            if (ShouldLog(Shut, IsShut))
                Warn(ShutProblem);
            if (ShouldLog(NoCapacity, Refused > 0))
                Warn(CapacityProblem);
        }

        private protected override void ListOwnProblems(FluidSimulation fluid, List<string> problems)
        {
            FindPositions(fluid.ParticleSpacing);
            problems.AddIfAny(positionsProblem != null ? ShapeProblem : null);
            if (positions != null && rate > 1.01f * MaxRateOf(fluid.ParticleSpacing, fluid.FixedStep))
                problems.Add(RateProblem(fluid.ParticleSpacing, fluid.FixedStep));
            if (positions != null && IsTorn(fluid))
                problems.Add(TornProblem(fluid));
            problems.AddIfAny(IsShut ? ShutProblem : null);
            problems.AddIfAny(Refused > 0 ? CapacityProblem : null);
        }

        // The drains' stage removes particles when their lifetime is over.
        private protected override FeatureSet UsedFeatures => ((FeatureSet)Features.Emitters).With(Features.Drains, lifetime > 0f)
            | (material != null ? material.UsedFeatures : FeatureSet.None);

        private protected override string ValidateValues()
        {
            string problem = null;
            Limit.Clamp("rate", ref rate, 0f, MaxRate, 0f, ref problem);
            Limit.Clamp("speed", ref speed, mode == EmitterMode.Fill ? 0f : MinSpeed, MaxSpeed, 1f, ref problem);
            Limit.Clamp("spread", ref spread, 0f, 180f, 0f, ref problem);
            Limit.Clamp("inherit velocity", ref inheritVelocity, 0f, 1f, 1f, ref problem);
            Limit.Clamp("delay", ref delay, 0f, float.MaxValue, 0f, ref problem);
            Limit.Clamp("duration", ref duration, 0f, float.MaxValue, 0f, ref problem);
            Limit.Clamp("phase", ref phase, 0, ParticleTags.MaxPhase, ref problem);
            Limit.Clamp("lifetime", ref lifetime, 0f, ParticleTags.MaxLifetime, 0f, ref problem);
            Limit.Finite("size", ref size, Vector3.one * 0.2f, ref problem);
            Limit.Clamp("radius", ref radius, 0f, float.MaxValue, 0.1f, ref problem);
            return problem;
        }

        double End => duration > 0f ? (double)delay + duration : double.PositiveInfinity;

        double ParticleVolume
        {
            get
            {
                double spacing = Simulation != null ? Simulation.ParticleSpacing : 0.0;
                return spacing * spacing * spacing;
            }
        }

        int Count(EmitterStates.Word word) => Simulation != null && Number >= 0 ? Simulation.Inputs.Parts.EmitterCount(Number, word) : 0;

        // m/s.
        float LeavingSpeed => mode == EmitterMode.Fill && shape != EmitterShape.MeshSurface ? speed : math.max(speed, MinSpeed);

        // m³/s that leave the shape at rest density, as far as a step can try.
        double MaxRateOf(float spacing, float step)
        {
            double perSecond = Emitters.MaxCandidates / (double)step;
            if (!positions.FillsVolume)
                perSecond = math.min(perSecond, positions.Count * (double)LeavingSpeed / spacing);
            return perSecond * spacing * spacing * spacing;
        }

        string ShapeProblem => positionsProblem + " It lets nothing in.";

        string RateProblem(float spacing, float step) => Invariant($"its rate of {rate} m³/s is more than leaves its shape at rest ") +
            Invariant($"density: at most {MaxRateOf(spacing, step):0.######} m³/s ") +
            $"do{(positions.FillsVolume ? "" : Invariant($" at {speed} m/s"))}. Enlarge it, raise its speed or lower the rate.";

        // Whether each substep lets in a ring of its own: the one before is ahead by what it fell, in a fluid so thick that a substep evens out
        // the flow within a ring (ν Δt > d²).
        bool IsTorn(FluidSimulation fluid)
        {
            float spacing = fluid.ParticleSpacing, step = fluid.FixedStep / Substeps(fluid);
            return !positions.FillsVolume && LeavingSpeed * step > 1.01f * MaxTravel * spacing
                && fluid.Material.dynamicViscosity * step > fluid.Material.density * spacing * spacing;
        }

        string TornProblem(FluidSimulation fluid)
        {
            int substeps = Substeps(fluid);
            float perStep = MaxTravel * fluid.ParticleSpacing * substeps, rateNeeded = math.ceil(LeavingSpeed / perStep);
            string remedy = rateNeeded > FluidSimulation.MaxStepRate ? "Lower its speed to " +
                Invariant($"{perStep * FluidSimulation.MaxStepRate:G3} m/s and set the Step Rate of FluidSimulation '{fluid.name}' to ") +
                Invariant($"{FluidSimulation.MaxStepRate}")
                : Invariant($"Set the Step Rate of FluidSimulation '{fluid.name}' to {rateNeeded} or more, take more Substeps or lower its speed");
            return Invariant($"its jet of thick fluid moves by {LeavingSpeed * fluid.FixedStep / substeps / fluid.ParticleSpacing:0.##} particle ") +
                $"spacings in a substep, so that each lets in a ring of its own. {remedy}.";
        }

        // For so long that what waited first is given up, and every place was tried. A volume that was filled and is full has nothing amiss.
        bool IsShut
        {
            get
            {
                if (Simulation == null)
                    return false;
                int emissions = mode == EmitterMode.Fill ? 1 : Substeps(Simulation);
                float needed = math.max(math.ceil(MaxWait / Simulation.FixedStep - 1e-3f) * emissions, searchSteps);
                return Count(EmitterStates.Word.Shut) >= needed
                    && (ShutBy < EmitterStates.ShutCause.Full || mode != EmitterMode.Fill || Emitted == 0);
            }
        }

        EmitterStates.ShutCause ShutBy => (EmitterStates.ShutCause)Count(EmitterStates.Word.ShutBy);

        string ShutProblem => ShutCauseText + " What is due is given up and counted as blocked.";

        string ShutCauseText
        {
            get
            {
                switch (ShutBy)
                {
                    case EmitterStates.ShutCause.Collider:
                        return "a collider covers all of its outlet, so that nothing comes out. Move it or the collider apart.";
                    case EmitterStates.ShutCause.Outside:
                        return $"its outlet lies outside the box of FluidSimulation '{Simulation.name}', so that nothing comes out. Move it into " +
                            "the box, or enlarge the Domain Size.";
                    case EmitterStates.ShutCause.Full:
                        return $"the box of FluidSimulation '{Simulation.name}' is full, so that nothing comes out. Drain the fluid, enlarge the " +
                            "Domain Size or let less in.";
                    default:
                        return mode == EmitterMode.Fill || shape == EmitterShape.MeshSurface
                            ? "water fills its shape, so that nothing comes out: it lets in where there is room. Move it out of the water, or " +
                                "choose a Jet or a Spray from a Box, Sphere or Disc, which press water away."
                            : "the water before it cannot yield, as in a closed vessel that is full or a gap that is too narrow, so that " +
                                "nothing comes out. Give the water an outlet, drain it or let less in.";
                }
            }
        }

        static int Substeps(FluidSimulation fluid) => fluid.IsRunning ? math.max(fluid.Input.settings.substeps, 1) : fluid.Settings.substeps;

        string CapacityProblem => $"it is stopped by the capacity of FluidSimulation '{Simulation.name}': " +
            Invariant($"{Simulation.Capacity:N0} particles are all in use. What does not fit is refused and counted. Raise the ") +
            "capacity, drain the fluid or give particles a lifetime.";

        bool TryGetPositions(float spacing)
        {
            FindPositions(spacing);
            if (ShouldLog(NoShape, positionsProblem != null))
                Warn(ShapeProblem);
            return positions != null;
        }

        // Looks at the shape again only where something of it has changed.
        void FindPositions(float spacing)
        {
            var key = new PositionsKey
            {
                shape = shape,
                mode = mode,
                size = size,
                radius = radius,
                mesh = mesh,
                scale = shape == EmitterShape.MeshSurface ? transform.lossyScale : Vector3.one,
                spacing = spacing,
            };
            if (key.Equals(positionsKey))
                return;
            positionsKey = key;
            positions = EmitterPositions.Of(shape, mode, size, radius, mesh, key.scale, spacing, out positionsProblem);
            ShouldLog(NoShape, false);        // another problem is told again
        }

        // Inputs that the positions depend on.
        struct PositionsKey
        {
            public EmitterShape shape;
            public EmitterMode mode;
            public Vector3 size, scale;
            public float radius, spacing;
            public Mesh mesh;

            public bool Equals(in PositionsKey other) => shape == other.shape && mode == other.mode && size.Equals(other.size)
                && scale.Equals(other.scale)
                && radius == other.radius && spacing == other.spacing && ReferenceEquals(mesh, other.mesh);
        }
    }
}
