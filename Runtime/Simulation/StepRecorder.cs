using System;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Makes the input of a fluid's steps from its settings and the scene, and records them.</summary>
    sealed class StepRecorder
    {
        const int TooViscous = 0, BordersDiffer = 1, LevelsLack = 2, GrainsFlow = 3;       // problems of the log

        readonly FluidSimulation fluid;
        SolverSettings settings;        // of the steps of this frame, as the budget has them
        StepInput input;
        bool isTooViscous;
        OnceLog log;

        public StepRecorder(FluidSimulation fluid)
        {
            this.fluid = fluid;
            Budget = new FluidBudget(fluid);
            Passes = new ScriptPasses(fluid);
            Tension = new TensionCheck(fluid);
        }

        public FluidBudget Budget { get; }

        public ScriptPasses Passes { get; }

        public TensionCheck Tension { get; }

        /// <summary>The last step.</summary>
        public ref readonly StepInput Input => ref input;

        /// <summary>Settings of the steps of this frame: the fluid's own, or those that its budget chose.</summary>
        public ref readonly SolverSettings Settings => ref settings;

        /// <summary>Set every frame by what draws the density, which then is summed with the velocities of the next steps.</summary>
        public bool NeedsDensity { get; set; }

        /// <summary>Set every frame by what draws foam, which then is made in the next steps; none where it was not set.</summary>
        public FoamSettings? NeedsFoam { get; set; }

        /// <summary>Set every frame by what draws smoke, which then is made in the next steps; none where it was not set.</summary>
        public SmokeSettings? NeedsSmoke { get; set; }

        /// <summary>Raised after the commands of a fixed step, with its number: for what is recorded of the state that it leaves.</summary>
        public event Action<CommandBuffer, int> AfterStep;

        /// <summary>Raised after the commands of all steps of a frame, with whether they were executed.</summary>
        public event Action<bool> AfterSteps;

        /// <summary>Why a dynamic viscosity is not reached; null where it is.</summary>
        public string Problem => isTooViscous ? TooViscousProblem : null;

        /// <summary>Why the borders act otherwise than they are set; null where they do not.</summary>
        public string BordersProblem => fluid.Inputs.Parts.LacksNumbers(fluid.Borders) ? LevelsProblem : DifferProblem;

        string DifferProblem => fluid.Borders.ProblemIn(fluid.DomainSize, fluid.ParticleSpacing);

        /// <summary>Lets problems be logged again, as the fluid begins.</summary>
        public void Begin()
        {
            isTooViscous = false;
            log.Reset();
            Tension.Begin();
        }

        /// <summary>Chooses the settings of a frame's steps.</summary>
        /// <param name="frameTime">Fluid time of the frame, s.</param>
        public void BeginFrame(float frameTime) => settings = Budget.BeginFrame(frameTime);

        /// <summary>Substep that <see cref="Prepare"/> is going to choose, s.</summary>
        public float SubstepTime => fluid.FixedStep / settings.StableSubsteps(GravityStep);

        /// <summary>Makes the input of the steps of a frame. Its gravity is that in the domain's frame, less the acceleration of the frame
        /// itself since the last steps.</summary>
        /// <param name="duration">Time in which the box moved. Not that of the steps, since frames and steps differ, s.</param>
        public void Prepare(float duration)
        {
            SceneInputs inputs = fluid.Inputs;
            DomainFrame frame = fluid.Box.Frame;
            RigidPose box = frame.Box;
            float3 acceleration = fluid.Box.Accelerate(box.position, duration);
            Vector3 felt = fluid.Inertial ? fluid.Gravity - (Vector3)acceleration : fluid.Gravity;
            input = new StepInput
            {
                timeStep = fluid.FixedStep,
                gravity = Quaternion.Inverse(box.rotation) * felt + inputs.Parts.UniformField(frame),
                settings = settings,
                material = fluid.Material,
                phases = fluid.Phases.ForStep(),
                needsDensity = NeedsDensity,
                borders = fluid.Borders.In(fluid.DomainSize, fluid.ParticleSpacing),
                colliders = inputs.Colliders.Set,
                tracksPhases = fluid.TrackPhases,
                foam = NeedsFoam ?? default,
                foamSeed = fluid.Seed,
                hasSmoke = NeedsSmoke.HasValue,
                smoke = NeedsSmoke ?? default,
            };
            NeedsDensity = false;
            NeedsFoam = null;
            NeedsSmoke = null;
            fluid.Support.Gate.TurnOffMissing(fluid.Solver, ref input);
            if (inputs.Connections.Neighbors is StepConnections neighbors)
            {
                input.settings.sleepSpeed = 0f;     // what sleeps does not feel what comes
                input.connections = neighbors;
            }
            fluid.Support.BeginSteps();
            input.settings.relaxation = settings.StableRelaxation(fluid.Solver.IsDeep(input));
            input.settings.substeps = settings.StableSubsteps(GravityStep);
            CheckViscosity();
            CheckBorders();
            if (log.ShouldLog(GrainsFlow, GrainFriction.LacksPressure(input)))
                Debug.LogWarning($"Rill: FluidSimulation '{fluid.name}': {GrainsFlowProblem}", fluid);
            fluid.Phases.CheckDiffusion(input);
            Tension.Check(input);
        }

        /// <summary>Makes the input of a step in which nothing acts, so that each particle goes on as it is.</summary>
        public void PrepareStill()
        {
            settings = fluid.Settings;
            settings.substeps = 1;
            settings.iterations = 0;
            settings.deepWater = DeepWater.Off;
            settings.sleepSpeed = 0f;
            settings.numericalDamping = 1f;
            input = new StepInput
            {
                timeStep = fluid.FixedStep, gravity = float3.zero, settings = settings, material = fluid.Material.WithoutForces(),
                needsDensity = NeedsDensity
            };
            NeedsDensity = false;
            NeedsFoam = null;
            NeedsSmoke = null;
            fluid.Support.BeginSteps();
            fluid.Support.TurnOffRefused(ref input, settings);
        }

        /// <summary>Records the steps of a frame.</summary>
        /// <param name="problem">Says why the fluid cannot go on; null where it can, or where a pass of a script disabled it.</param>
        public bool TryRecord(CommandBuffer commands, int steps, out string problem)
        {
            problem = null;
            try
            {
                for (int i = 0; i < steps; i++)
                {
                    input.frameFrom = i / (float)steps;
                    input.frameTo = (i + 1) / (float)steps;
                    input.sources = fluid.Inputs.Parts.Collect(input);
                    input.takesParticles = i == 0;
                    fluid.Support.TurnOffRefused(ref input, settings);
                    if (!Passes.Record(commands, ref input))
                        return false;
                    input.needsDensity |= input.sources != null && input.sources.hasWind;
                    Budget.BeginStep(commands);
                    fluid.Solver.Step(commands, input);
                    AfterStep?.Invoke(commands, fluid.StepCount + i + 1);
                    Budget.EndStep(commands);
                }
                return true;
            }
            catch (ArgumentException refusal)       // a stage that this scene needs is more than the device holds
            {
                problem = refusal.Message;
                return false;
            }
        }

        /// <summary>Raises <see cref="AfterSteps"/>.</summary>
        public void RaiseAfterSteps(bool areExecuted) => AfterSteps?.Invoke(areExecuted);

        /// <summary>How far gravity and the strongest field carry a particle in a step, d. The acceleration of the box is left out: a jerk of it
        /// lasts one step, and its cost would come as a hitch.</summary>
        public float GravityStep => (fluid.Gravity.magnitude + fluid.Inputs.Parts.MaxFieldAcceleration) * fluid.FixedStep * fluid.FixedStep
            / fluid.ParticleSpacing;

        // Checks the input as it is recorded: with the substeps that are taken.
        void CheckViscosity()
        {
            isTooViscous = ImplicitViscosity.IsNeeded(input)
                && ImplicitViscosity.Strength(input, fluid.Solver.Layout) > ImplicitViscosity.MaxStrength;
            if (isTooViscous && log.ShouldLog(TooViscous))
                Debug.LogWarning($"Rill: FluidSimulation '{fluid.name}': {TooViscousProblem}", fluid);
        }

        void CheckBorders()
        {
            if (log.ShouldLog(BordersDiffer, fluid.Borders.DifferIn(fluid.DomainSize, fluid.ParticleSpacing)))
                Debug.LogWarning($"Rill: FluidSimulation '{fluid.name}': {DifferProblem}", fluid);
            if (log.ShouldLog(LevelsLack, fluid.Inputs.Parts.LacksNumbers(input.borders)))
                Debug.LogWarning($"Rill: FluidSimulation '{fluid.name}': {LevelsProblem}", fluid);
        }

        /// <summary>Why grains flow as a liquid; null where none do.</summary>
        public string GrainsProblem
        {
            get
            {
                var still = new StepInput { settings = fluid.Settings, material = fluid.Material, phases = fluid.Phases.ForStep() };
                return GrainFriction.LacksPressure(still) ? GrainsFlowProblem : null;
            }
        }

        const string GrainsFlowProblem = "its grains flow as a liquid, because Deep Water is off and nothing finds the pressure between them. " +
            "Set Deep Water to Automatic.";

        static string LevelsProblem => Invariant($"an open border holds its level by one of {StepSources.MaxEmitters} emitters and drains, and ") +
            "the scene's take its number, so the level is not held. Disable an emitter or a drain, the last enabled first.";

        string TooViscousProblem
        {
            get
            {
                double strength = ImplicitViscosity.Strength(input, fluid.Solver.Layout), beyond = strength / ImplicitViscosity.MaxStrength;
                double substeps = Math.Ceiling(input.settings.substeps * beyond);
                double viscosity = input.phases.MaxKinematicViscosity(input.material) * input.material.density;
                string remedy = substeps <= SolverSettings.MaxSubsteps ? Invariant($"Take {substeps} substeps or a particle spacing of")
                    : "Take a particle spacing of";
                return Invariant($"its dynamic viscosity of {viscosity:G4} Pa s is more than ") +
                    Invariant($"{ImplicitViscosity.MaxPasses} passes solve: at this spacing and substep that is ") +
                    Invariant($"{viscosity / beyond:G3} Pa s. Flow over many particles is braked less: up to ") +
                    Invariant($"{100.0 * ImplicitViscosity.ErrorLeft(strength):G2} % of what should end in a substep goes on. {remedy} ") +
                    Invariant($"{fluid.ParticleSpacing * Math.Sqrt(beyond):G3} m, or lower the viscosity.");
            }
        }
    }
}
