using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>
    /// A fluid in a closed box around this object: owns its time and life-cycle and gives each fixed step to the solver.
    /// Fluid comes from the <see cref="FluidVolume"/> components on this object and its children.
    /// </summary>
    /// <remarks>
    /// The box follows the object's position and rotation, not its scale. Moving the object carries the fluid along; its
    /// acceleration acts on the fluid unless <c>inertial</c> is off. (A turning box tilts gravity; the other forces of a
    /// rotating frame are left out.) A transform that stops being finite is not followed until it is finite again. Any other
    /// problem is logged once, by name, and stops the fluid; the component stays enabled.
    /// </remarks>
    [AddComponentMenu("Rill/Fluid Simulation"), Icon(PackagePaths.Icon), ManualPage("concepts", "fluid-simulation")]
    [DisallowMultipleComponent]
    [DefaultExecutionOrder(ExecutionOrder)]
    public sealed partial class FluidSimulation : MonoBehaviour, IHasProblems, IAppliesSettings, IUsesFeatures, IRunsInEditMode
    {
        /// <summary>When it steps, in LateUpdate: what scripts of a lower order and animations move in a frame acts on the fluid in that
        /// frame.</summary>
        public const int ExecutionOrder = 1000;

        internal const float MaxStepRate = 1000f;
        const float DefaultStepRate = 60f, MinCulledRate = 0.01f, DefaultCulledRate = 0.25f;
        internal const int AllLayers = ~0;
        static readonly Vector3 DefaultGravity = new Vector3(0f, -9.81f, 0f);

        [Tooltip("Inner size of the box, m. Each side at least two particle spacings.")]
        [SerializeField] Vector3 domainSize = new Vector3(2f, 2f, 1f);

        [Tooltip("Distance between particles at rest, m, above 0. Half of it means eight times the particles.")]
        [SerializeField] float particleSpacing = 0.05f;

        [Tooltip("Maximum number of particles, 1 to 16,777,216. Memory for all of them is allocated up front; particles that do not fit are " +
            "refused and counted.")]
        [SerializeField] int capacity = 50000;

        [SerializeField] FluidMaterial material = FluidMaterial.Water;

        [Tooltip("Materials of phases 1 to 7: of the particles that emitters, volumes and scripts give that phase or that material. Phase 0 " +
            "has the Material above. A material that is used and not listed here gets the next free phase.")]
        [SerializeField] FluidMaterialAsset[] phaseMaterials = Array.Empty<FluidMaterialAsset>();

        [Tooltip("How two materials act on each other: whether they mix, and the tension between them. Two of the above, or one and " +
            "the fluid's own. All others stay apart.")]
        [SerializeField] FluidMaterialPair[] materialPairs = Array.Empty<FluidMaterialPair>();

        [SerializeField] SolverSettings solver = SolverSettings.Default;

        [Tooltip("GPU time that the fluid may take. When on, substeps, iterations and relaxation are chosen to fit it.")]
        [SerializeField] SolverBudget budget = SolverBudget.Default;

        [Tooltip("Acceleration in world space, m/s².")]
        [SerializeField] Vector3 gravity = DefaultGravity;

        [Tooltip("The four sides of the box: walls, bands that absorb waves, or open water.")]
        [SerializeField] FluidBorders borders = FluidBorders.Default;

        [Tooltip("Fixed steps in a second of fluid time. 10 to 1000.")]
        [Range(10f, MaxStepRate)]
        [SerializeField] float stepRate = DefaultStepRate;

        [Tooltip("Maximum number of steps in a frame, 1 to 16. Time beyond that is dropped and counted.")]
        [Range(1, 16)]
        [SerializeField] int maxStepsPerFrame = 4;

        [Tooltip("Lets acceleration of this object act on the fluid: on for a glass that is shaken, off for a window that follows the player.")]
        [SerializeField] bool inertial = true;

        [Tooltip("Layers whose Fluid Colliders act on this fluid. Fluid Physics Colliders has layers of its own.")]
        [SerializeField] LayerMask fluidColliderLayers = AllLayers;

        [Tooltip("Freezes the simulation.")]
        [SerializeField] bool paused;

        [Tooltip("Behavior while no enabled camera sees its box within the Culling Distance. Always Simulate: it goes on. " +
            "Slow: its time passes at the Culled Rate. Pause: its time stands still.")]
        [SerializeField] FluidCullingMode cullingMode = FluidCullingMode.AlwaysSimulate;

        [Tooltip("Distance from a camera to the box beyond which the camera does not count, m. 0: any distance counts.")]
        [SerializeField] float cullingDistance;

        [Tooltip("Fraction of the time, and so of the steps, that passes for a slowed fluid while no camera sees it. 0.01 to 1.")]
        [Range(MinCulledRate, 1f)]
        [SerializeField] float culledRate = DefaultCulledRate;

        [Tooltip("Seed of the random offsets of initial particle positions from the lattice.")]
        [SerializeField] int seed = 1;

        [Tooltip("Snapshot that the fluid starts with instead of its volumes. None: the volumes are filled.")]
        [SerializeField] FluidSnapshotAsset startState;

        [Tooltip("On: a disabled fluid keeps its water, and the memory for it, and goes on from there when it is enabled again. Off: " +
            "it gives its memory back and begins again.")]
        [SerializeField] bool keepStateOnDisable = true;

        [Tooltip("Maximum number of particles that Recenter keeps outside the box where it is told to, 1 to 16,777,216. Memory for all of them " +
            "is allocated then: 80 bytes each, and 8 more with phases or lifetimes.")]
        [SerializeField] int keptCapacity = 50000;

        [Tooltip("Steps between measurements of the fluid. 0 measures nothing and costs nothing.")]
        [Min(0)]
        [SerializeField] int statisticsInterval = 10;

        [Tooltip("Shaders that a build with this fluid contains. Used By Settings: those that the settings stored here need. All " +
            "Features: also those that a script may switch on or add.")]
        [SerializeField] ShadersInBuild shadersInBuild = ShadersInBuild.UsedBySettings;

        [SerializeField, HideInInspector] StageReferences shaders = new StageReferences();

        [NonSerialized] ClampedSettings clamped;
        [NonSerialized] bool layoutChanged;

        /// <summary>Called by Unity alone.</summary>
        public FluidSimulation()
        {
            SolverOwner = new SolverOwner(this);
            Box = new BoxTracker(this);
            Clock = new FluidClock(this);
            Support = new FeatureSupport(this);
            Inputs = new SceneInputs(this);
            Phases = new PhaseTable(this);
            Steps = new StepRecorder(this);
            Results = new FrameResults(this);
            Editing = new ParticleEditing(this);
            Resolution = new ResolutionChange(this);
            Snapshots = new FluidSnapshots(this);
            Playback = new PlaybackStepper(this);
        }

        internal SolverOwner SolverOwner { get; }

        internal BoxTracker Box { get; }

        internal FluidClock Clock { get; }

        internal FeatureSupport Support { get; }

        internal SceneInputs Inputs { get; }

        internal PhaseTable Phases { get; }

        internal StepRecorder Steps { get; }

        internal FrameResults Results { get; }

        internal ParticleEditing Editing { get; }

        internal ResolutionChange Resolution { get; }

        internal FluidSnapshots Snapshots { get; }

        internal PlaybackStepper Playback { get; }

        /// <summary>The solver; null while the fluid does not run.</summary>
        internal PbfSolver Solver => SolverOwner.Solver;

        internal CommandBuffer Commands => SolverOwner.Commands;

        /// <summary>The last step.</summary>
        internal StepInput Input => Steps.Input;

        /// <summary>Problem that stopped the fluid; null for none.</summary>
        [field: NonSerialized] internal string Failure { get; private set; }

        /// <summary>Whether the Editor simulates this fluid without Play. Set before it is enabled there, and taken back when it is
        /// disabled.</summary>
        [field: NonSerialized] internal bool IsInEditMode { get; set; }

        StageReferences IUsesFeatures.StageReferences => shaders;

        FeatureSet IUsesFeatures.UsedFeatures => Support.Used;

        bool IRunsInEditMode.BelongsTo(FluidSimulation fluid) => ReferenceEquals(fluid, this);

        void IHasProblems.ListProblems(List<string> problems) => FluidProblems.List(this, clamped.Problem, problems);

        /// <summary>Position and rotation of this object; the last finite ones while a component of them is not finite.</summary>
        internal void GetPose(out Vector3 position, out Quaternion rotation) => Box.GetPose(out position, out rotation);

        void OnEnable()
        {
            Failure = null;
            layoutChanged = false;
            Inputs.Thrown.Clear();
            Steps.Begin();
            Clock.Begin();
            if (FeatureSupport.HasNoGraphics)
            {
                Support.LogNoGraphics();
                return;
            }
            if (FeatureSupport.MissingAbility is string missing)
            {
                Fail(missing);
                return;
            }
            if (!Box.TryBegin(out string problem))
            {
                Fail(problem);
                return;
            }
            Box.Follow();

            CheckSettings();
            clamped.Log(this);
            bool resumes = TryResume();
            shaders.Hold();
            if (resumes)
                return;
            Phases.Clear();
            if (SolverOwner.TryMake(out problem))
                Restart();
            else
                Fail(problem);
        }

        void OnDisable()
        {
            if (!TrySuspend())
                Release();
        }

        void OnDestroy() => ReleaseSuspended();

        void OnValidate() => ChangedSettings.ApplyLater(this);

        // After the scripts and animations that move what acts on the fluid.
        void LateUpdate()
        {
            if (Clock.TryTakeTime(out float frameTime))
                Advance(frameTime);
        }

        /// <summary>Lets time pass: takes the fixed steps that fit. Allocates no managed memory once it runs.</summary>
        /// <param name="frameTime">Time since the last call, s.</param>
        internal void Advance(float frameTime)
        {
            Results.BeginFrame();
            if (layoutChanged || Box.CanBeginNow)
                BeginAgain();
            Resolution.Finish();
            if (!IsRunning)
                return;
            Results.Surface.Collect();
            if (IsPlayedBack)
                Playback.Advance(frameTime);
            else
                RunSteps(frameTime);
            Results.Surface.Update(Commands);
        }

        void RunSteps(float frameTime)
        {
            Clock.BeginFrame();
            Inputs.Connections.BeginFrame();
            bool moves = Box.Follow();
            float rate = Clock.Rate(frameTime);
            bool stands = Resolution.IsPending || !(rate * frameTime > 0f);     // also by Time.timeScale
            // Motion during a pause, or while the transform was not finite, must not push the fluid.
            if (stands || rate < 1f || !moves)
                Box.ResetMotion();
            if (stands || rate < 1f || !moves && !Box.IsPoseLost)
                Inputs.ResetMotion();
            if (stands)
            {
                Inputs.Connections.DropGhosts();
                Results.Queries.Execute(Commands);
                return;
            }
            frameTime *= rate;

            Steps.BeginFrame(frameTime);
            int steps = Clock.Advance(frameTime);
            if (steps > 0)
            {
                Simulate(steps);
            }
            else
            {
                Inputs.Connections.DropGhosts();
                if (Results.Queries.AreLate)
                    Results.Queries.Execute(Commands);
            }
            Steps.Budget.EndFrame(steps);
        }

        void Simulate(int steps)
        {
            Inputs.Colliders.Collect(steps * FixedStep, Steps.SubstepTime);
            Inputs.Connections.Collect();
            Steps.Prepare((float)Clock.Steps.FrameInterval);
            Commands.Clear();
            bool isRecorded = Steps.TryRecord(Commands, steps, out string problem);
            if (problem != null)
                Fail(problem);
            Box.MarkSteps();
            if (!isRecorded)
            {
                Steps.RaiseAfterSteps(false);
                return;
            }
            Clock.Count(steps);
            Results.Measurements.Count(steps);
            Inputs.Connections.MarkSteps();
            Results.Execute(Commands);
            Inputs.Parts.RequestCounts(steps);
            Inputs.Connections.RequestCounts();
            Editing.Recentering.RequestCounts();
            Steps.RaiseAfterSteps(true);
        }

        /// <summary>Begins at rest: nothing has moved since the last steps, neither the box nor what acts in it.</summary>
        internal void ResetMotion()
        {
            Box.ResetMotion();
            Inputs.ResetMotion();
        }

        /// <summary>Logs what is wrong and stops, and nothing else in the scene. The component stays enabled: once its settings have changed,
        /// the fluid begins again.</summary>
        internal void Fail(string problem)
        {
            Failure = problem;
            Debug.LogError($"Rill: FluidSimulation '{name}' is off: {problem}", this);
            Release();
        }

        /// <summary>Begins again where box, spacing or capacity are no longer those that the solver was made for.</summary>
        internal void BeginAgainIfChanged()
        {
            if (IsRunning && layoutChanged)
                BeginAgain();
        }

        /// <summary>Releases the solver of a disabled fluid, which begins again when it is enabled. Before scripts are loaded again, and when
        /// the fluid is destroyed.</summary>
        internal void ReleaseSuspended()
        {
            if (SolverOwner.TryResume())
                Release();
        }

        internal void ConfigureIfOther(Vector3 size, float spacing, int particles)
        {
            if (size != domainSize || spacing != particleSpacing || particles != capacity)
                Configure(size, spacing, particles);
        }

        /// <summary>Sets the resolution that a new solver already has.</summary>
        internal void SetResolution(float spacing, int particles)
        {
            particleSpacing = spacing;
            capacity = particles;
        }

        void BeginAgain()
        {
            Release();
            OnEnable();
        }

        void Release()
        {
            ReleaseSuspended();
            Editing.Release();
            Results.LogLost();
            Resolution.Cancel();
            Inputs.Release();
            Steps.Budget.Release();
            SolverOwner.Dispose();
            shaders.Release();
        }

        // Keeps the solver of a fluid that is disabled; false where there is none to keep.
        bool TrySuspend()
        {
            if (!keepStateOnDisable || SolverOwner.SuspendsNothing || !IsRunning || Failure != null || IsInEditMode)
                return false;
            SolverOwner.Suspend();
            Steps.Budget.Release();     // its recorder is one of a few
            shaders.Release();
            return true;
        }

        // Takes the solver back as the fluid is enabled. As after a pause, nothing has moved through the fluid meanwhile.
        bool TryResume()
        {
            if (SolverOwner.SuspendedIsOutdated)
                ReleaseSuspended();
            if (!SolverOwner.TryResume())
                return false;
            layoutChanged = false;
            ResetMotion();
            return true;
        }

        void Changed() => ChangedSettings.Apply(this);

        void IAppliesSettings.CheckSettings()
        {
            layoutChanged |= Failure != null || SolverOwner.IsOutdated;      // what it failed of may have changed
            CheckSettings();
        }

        void IAppliesSettings.ApplySettings()
        {
            clamped.Log(this);
            shaders.Follow(Support.Used);
            if (!keepStateOnDisable)
                ReleaseSuspended();
        }

        void CheckSettings()
        {
            solver.Validate(out string problem);
            material.Validate(out string materialProblem);
            Limit.Append(ref problem, materialProblem);
            budget.Validate(out string budgetProblem);
            Limit.Append(ref problem, budgetProblem);
            borders.Validate(out string borderProblem);
            Limit.Append(ref problem, borderProblem);
            Limit.Finite("gravity", ref gravity, DefaultGravity, ref problem);
            Limit.Clamp("step rate", ref stepRate, 10f, MaxStepRate, DefaultStepRate, ref problem);
            Limit.Clamp("max steps per frame", ref maxStepsPerFrame, 1, 16, ref problem);
            Limit.Clamp("culling distance", ref cullingDistance, 0f, float.MaxValue, 0f, ref problem);
            Limit.Clamp("culled rate", ref culledRate, MinCulledRate, 1f, DefaultCulledRate, ref problem);
            Limit.Clamp("kept capacity", ref keptCapacity, 1, SolverLayout.MaxCapacity, ref problem);
            if (phaseMaterials.Length >= Rill.PhaseMaterials.Phases)
                Limit.Append(ref problem, FormattableString.Invariant($"of {phaseMaterials.Length} phase materials only the first ") +
                    FormattableString.Invariant($"{Rill.PhaseMaterials.Phases - 1} have a phase. Remove the others"));
            for (int i = 0; i < materialPairs.Length; i++)
            {
                materialPairs[i].Validate(out string pairProblem);
                if (pairProblem != null)
                    Limit.Append(ref problem, FormattableString.Invariant($"material pair {i}: {pairProblem}"));
            }
            clamped.Set(problem);
        }
    }
}
