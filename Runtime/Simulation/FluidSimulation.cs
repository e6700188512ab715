using System;
using System.Collections.Generic;
using Unity.Mathematics;
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
    /// rotating frame are left out.) A transform that stops being finite is not followed until it is a place again. Any other
    /// problem is logged once, by name, and disables the component.
    /// </remarks>
    [AddComponentMenu("Rill/Fluid Simulation"), Icon(PackagePaths.Icon), ManualPage("concepts.md")]
    [DisallowMultipleComponent]
    [DefaultExecutionOrder(ExecutionOrder)]
    public sealed partial class FluidSimulation : MonoBehaviour, IHasProblems, IAppliesSettings
    {
        /// <summary>When it steps, in LateUpdate: what scripts of a lower order and animations move in a frame acts on the fluid in that
        /// frame.</summary>
        public const int ExecutionOrder = 1000;

        internal const float MaxStepRate = 1000f;
        const float DefaultStepRate = 60f;
        static readonly Vector3 DefaultGravity = new Vector3(0f, -9.81f, 0f);

        [Tooltip("Inner size of the box, m. Each side at least two particle spacings.")]
        [SerializeField] Vector3 domainSize = new Vector3(2f, 2f, 1f);

        [Tooltip("Distance between particles at rest, m, above 0. Half of it means eight times the particles.")]
        [SerializeField] float particleSpacing = 0.05f;

        [Tooltip("Most particles, 1 to 16,777,216. Memory is taken for all of them; what does not fit is refused and counted.")]
        [SerializeField] int capacity = 50000;

        [SerializeField] FluidMaterial material = FluidMaterial.Water;
        [SerializeField] SolverSettings solver = SolverSettings.Default;

        [Tooltip("Acceleration in world space, m/s².")]
        [SerializeField] Vector3 gravity = DefaultGravity;

        [Tooltip("Fixed steps in a second of fluid time. 10 to 1000.")]
        [Range(10f, MaxStepRate)]
        [SerializeField] float stepRate = DefaultStepRate;

        [Tooltip("Steps that one frame takes at most, 1 to 16. Time beyond that is dropped and counted.")]
        [Range(1, 16)]
        [SerializeField] int maxStepsPerFrame = 4;

        [Tooltip("Whether acceleration of this object acts on the fluid: on for a glass that is shaken, off for a window that follows the player.")]
        [SerializeField] bool inertial = true;

        [Tooltip("Whether time stands still.")]
        [SerializeField] bool paused;

        [Tooltip("Of the small offsets from the lattice with which fluid is filled in.")]
        [SerializeField] int seed = 1;

        [Tooltip("Steps between measurements of the fluid. 0 measures nothing and costs nothing.")]
        [Min(0)]
        [SerializeField] int statisticsInterval = 10;

        PbfSolver pbf;
        CommandBuffer commands;
        FixedStepClock clock;
        StepInput input;
        [NonSerialized] int stepsSinceStatistics;
        [NonSerialized] double lastFrameTime;       // FrameTime of the frame before, s
        [NonSerialized] float3 lastPosition, lastVelocity;
        [NonSerialized] float lastDuration;         // in which it had that velocity, s; 0 where the velocity is not known
        [NonSerialized] bool positionIsKnown;       // whether the box came from its last position
        [NonSerialized] bool layoutChanged;

        /// <summary>Fixed steps taken since the last restart.</summary>
        [field: NonSerialized] public int StepCount { get; private set; }

        /// <summary>Fluid time since the last restart, s.</summary>
        [field: NonSerialized] public double FluidTime { get; private set; }

        /// <summary>Fluid time of the current frame since the last restart, s: at which the fluid is drawn. Up to a fixed step more than
        /// <see cref="FluidTime"/>.</summary>
        public double FrameTime => FluidTime + clock.Lag;

        /// <summary>Length of a fixed step, s.</summary>
        public float FixedStep => 1f / stepRate;

        /// <summary>Whether time stands still.</summary>
        public bool Paused { get => paused; set => paused = value; }

        /// <summary>Whether acceleration of this object acts on the fluid.</summary>
        public bool Inertial { get => inertial; set => inertial = value; }

        /// <summary>What the solver spends on a step. Out-of-range values are clamped with a warning.</summary>
        public SolverSettings Settings { get => solver; set { solver = value; Changed(); } }

        /// <summary>What the fluid is. Out-of-range values are clamped with a warning.</summary>
        public FluidMaterial Material { get => material; set { material = value; Changed(); } }

        /// <summary>Acceleration in world space, m/s². One that is not finite becomes the default, with a warning.</summary>
        public Vector3 Gravity { get => gravity; set { gravity = value; Changed(); } }

        /// <summary>Steps between measurements; 0 for none.</summary>
        public int StatisticsInterval { get => statisticsInterval; set => statisticsInterval = Math.Max(value, 0); }

        /// <summary>Whether the fluid runs: enabled, supported and without a problem.</summary>
        public bool IsRunning => pbf != null;

        /// <summary>From the domain's frame in particle spacings, lowest corner at 0, to world space.</summary>
        public Matrix4x4 DomainToWorld
        {
            get
            {
                GetPose(out Vector3 position, out Quaternion rotation);
                return Matrix4x4.TRS(position, rotation, Vector3.one) * Matrix4x4.TRS(domainSize * -0.5f, Quaternion.identity,
                    Vector3.one * particleSpacing);
            }
        }

        /// <summary>Velocity of the box since the last steps, world space, m/s.</summary>
        internal Vector3 BoxVelocity => lastVelocity;

        internal PbfSolver Solver => pbf;
        internal StepInput Input => input;

        /// <summary>The fluid's time of the current frame since the newest state, x, and that of the frame before, z, in substeps; y and w
        /// the same in s.</summary>
        internal Vector4 FrameLag
        {
            get
            {
                double now = clock.Lag, before = lastFrameTime - FluidTime, substep = FixedStep / Math.Max(pbf.LastSubsteps, 1);
                return new Vector4((float)(now / substep), (float)now, (float)(before / substep), (float)before);
            }
        }

        /// <summary>Set every frame by what draws the density, which then is summed with the velocities of the next steps.</summary>
        [field: NonSerialized] internal bool NeedsDensity { get; set; }

        /// <summary>Set every frame by what draws foam, which then is made in the next steps; none where it was not set.</summary>
        internal FoamSettings? NeedsFoam { get; set; }

        /// <summary>Sets box, resolution and capacity; a running fluid starts again.</summary>
        /// <param name="size">Inner size of the box, m.</param>
        /// <param name="spacing">Distance between particles at rest, m.</param>
        /// <param name="particles">Most particles.</param>
        public void Configure(Vector3 size, float spacing, int particles)
        {
            domainSize = size;
            particleSpacing = spacing;
            capacity = particles;
            layoutChanged = true;
        }

        /// <summary>The newest measurements, a few frames old; false before the first since a restart, and where the graphics device gave
        /// an error instead of the newest, which is logged.</summary>
        public bool TryGetStatistics(out FluidStatistics statistics)
        {
            statistics = default;
            if (pbf == null || !pbf.TryGetStatistics(input, out statistics))
                return false;
            statistics.relaxation = input.settings.relaxation;
            statistics.relaxationClamped = input.settings.relaxation != effective.relaxation;
            statistics.substeps = input.settings.substeps;
            statistics.droppedTime = clock.Dropped;
            return true;
        }

        /// <summary>Removes all particles, fills the volumes again, or takes the start state, and sets fluid time to 0. A fluid that is off
        /// for a problem tries to begin again, and logs what is wrong if it still is.</summary>
        /// <exception cref="InvalidOperationException">Called in a pass of <see cref="BeforeStep"/>.</exception>
        public void Restart()
        {
            ThrowInPass();
            ReleaseKept();
            if (resampling != null)
            {
                ConfigureIfOther(domainSize, resampling.spacing, resampling.capacity);
                Release();
                OnEnable();
                return;
            }
            if (pbf == null)
            {
                if (failure != null && isActiveAndEnabled)
                    OnEnable();
                return;
            }
            pbf.Clear();
            clock = default;
            StepCount = 0;
            FluidTime = 0.0;
            lastFrameTime = 0.0;
            stepsSinceStatistics = 0;
            StandStill();
            ClearMotions();
            colliders.ForgetForces(this);
            RestartSources();
            RestartQueries();
            if (!TryStartFromState())
                FillVolumes();
        }

        /// <summary>What each stage costs this scene, and why it is there or not; empty when not running.</summary>
        internal List<StageDescription> Describe()
        {
            var stages = new List<StageDescription>();
            if (pbf == null)
                return stages;
            stages.AddRange(pbf.Describe(input, statisticsInterval));
            stages.Add(DescribeBatches());
            stages.Add(DescribeBudget());
            IDrawsFluid[] renderers = GetComponents<IDrawsFluid>();
            foreach (IDrawsFluid renderer in renderers)
                stages.Add(renderer.Describe());
            if (renderers.Length == 0)
                stages.Add(new StageDescription("Rendering", false, $"'{name}' has no renderer component"));
            return stages;
        }

        void OnEnable()
        {
            failure = null;
            Thrown.Clear();
            layoutChanged = false;
            isTooViscous = saidTooViscous = dropIsKnown = false;
            if (HasNoGraphics)
            {
                LogNoGraphics();
                return;
            }
            if (DeviceGate.MissingAbility() is string missing)
            {
                Fail(missing);
                return;
            }
            isNowhere = NoPoseProblem != null;
            if (isNowhere)
            {
                Fail(NoPoseProblem);
                return;
            }
            FollowTransform();

            CheckSettings();
            clamped.Log(this);
            bool resumes = TryResume();
            shaders.Hold();
            if (resumes)
                return;
            try
            {
                SolverLayout layout = MakeLayout();
                if (ProblemOnDevice(layout) is string problem)
                {
                    Fail(problem);
                    return;
                }
                pbf = new PbfSolver(layout, limits);
            }
            catch (Exception refusal) when (refusal is ArgumentException || refusal is InvalidOperationException)
            {
                Fail(refusal.Message);
                return;
            }
            commands = new CommandBuffer { name = "Rill" };
            Restart();
        }

        void OnDisable()
        {
            if (!TryKeep())
                Release();
        }

        void OnDestroy() => ReleaseKept();

        void Release()
        {
            ReleaseKept();
            ReleaseBatches();
            LogLost();
            pbf?.Dispose();
            pbf = null;
            resampling = null;
            colliders.Clear();
            neighbors = null;
            ReleaseBudget();
            ReleaseSources();
            commands?.Dispose();
            commands = null;
            shaders.Release();
        }

        void OnValidate() => ChangedSettings.ApplyLater(this);

        void Changed() => ChangedSettings.Apply(this);

        void IAppliesSettings.CheckSettings()
        {
            layoutChanged |= failure != null || pbf != null && !Matches(pbf.Layout);      // what it failed of may have changed
            CheckSettings();
        }

        void IAppliesSettings.ApplySettings()
        {
            clamped.Log(this);
            shaders.Follow(UsedFeatures);
            if (!keepStateOnDisable)
                ReleaseKept();
        }

        // After the scripts and animations that move what acts on the fluid.
        void LateUpdate()
        {
            if (IsInEditMode)
                AdvanceInEditMode();
            else
                Advance(Time.deltaTime);
        }

        /// <summary>Lets time pass: takes the fixed steps that fit. Allocates no managed memory once it runs.</summary>
        /// <param name="frameTime">Time since the last call, s.</param>
        internal void Advance(float frameTime)
        {
            PendingReadbacks.FinishResumed();
            colliders.TellExit(this);
            CheckReadbacks();
            if (layoutChanged || isNowhere && NoPoseProblem == null)
            {
                Release();
                OnEnable();
            }
            FinishResampling();
            if (pbf == null)
                return;
            CollectMeshNeeds();
            FollowMeshSize();
            if (playback != null)
                ShowRecording(frameTime);
            else
                TakeSteps(frameTime);
            FinishSurface();
        }

        void TakeSteps(float frameTime)
        {
            lastFrameTime = FrameTime;
            MarkTurn();
            bool moves = FollowTransform();
            // Where the box and what acts in it go while time stands still is no push when it goes on, nor is the box's return from no place.
            float rate = IsInEditMode ? RateInEditMode(frameTime) : TimeRate();
            bool stands = IsResampling || !(rate * frameTime > 0f);     // also by Time.timeScale
            if (stands || rate < 1f || !moves)
                StandStill();
            if (stands || rate < 1f || !moves && !poseIsLost)
                ClearMotions();
            if (stands)
            {
                DropGhosts();
                AnswerQueries();
                return;
            }
            frameTime *= rate;

            BeginBudgetFrame(frameTime);
            int steps = clock.Advance(frameTime, FixedStep, maxStepsPerFrame);
            LogDroppedTime(frameTime);
            if (steps > 0)
            {
                Simulate(steps, (float)clock.FrameInterval);
            }
            else
            {
                DropGhosts();
                if (AnswersAreLate)
                    AnswerQueries();
            }
            budgeted?.EndFrame(steps);
        }

        /// <param name="duration">Time in which the box moved: not that of the steps, since frames and steps differ, s.</param>
        void Simulate(int steps, float duration)
        {
            CollectColliders(steps * FixedStep);
            CollectConnections();
            PrepareInput(duration);
            commands.Clear();
            bool isRecorded = TryRecordSteps(steps);
            collectedFrame = Frame;
            isTeleported = false;
            if (!isRecorded)
            {
                AfterSteps?.Invoke(false);
                return;
            }
            StepCount += steps;
            FluidTime += steps * (double)FixedStep;
            stepsSinceStatistics += steps;
            MarkSteps();
            Execute();
            ReadSources(steps);
            ReadConnections();
            ReadKept();
            ReadHandOver();
            AfterSteps?.Invoke(true);
        }

        /// <summary>Records what looks at the state that the steps of this frame leave, executes it all, and asks for what comes back.</summary>
        void Execute()
        {
            RecordSurface();
            int queries = RecordQueries();
            RecordBatches();
            pbf.RecordGhostRemoval(commands);

            bool measures = statisticsInterval > 0 && stepsSinceStatistics >= statisticsInterval && !pbf.StatisticsPending
            && Has(Features.Statistics);
            if (measures)
                pbf.RecordStatistics(commands, input);
            else if (statisticsInterval <= 0)
                pbf.ReleaseStatistics();
            ColliderReactions reactions = TakeReactions();
            Graphics.ExecuteCommandBuffer(commands);

            reactions?.Request();
            RequestQueries(queries);
            RequestBatches();
            if (measures)
            {
                pbf.Foam?.Request();
                pbf.RequestStatistics();
                stepsSinceStatistics = 0;
            }
        }

        bool TryRecordSteps(int steps)
        {
            try
            {
                for (int i = 0; i < steps; i++)
                {
                    input.frameFrom = i / (float)steps;
                    input.frameTo = (i + 1) / (float)steps;
                    input.sources = TakeSources();
                    input.takesParticles = i == 0;
                    LimitToDevice();
                    if (!RecordPasses())
                        return false;
                    input.needsDensity |= input.sources != null && input.sources.hasWind;
                    budgeted?.BeginStep(commands);
                    pbf.Step(commands, input);
                    AfterStep?.Invoke(commands, StepCount + i + 1);
                    budgeted?.EndStep(commands);
                }
                return true;
            }
            catch (ArgumentException problem)       // a stage that this scene needs is more than the device holds
            {
                Fail(problem.Message);
                return false;
            }
        }

        // Gravity in the domain's frame, less the acceleration of the frame itself since the last steps.
        void PrepareInput(float duration)
        {
            GetPose(out Vector3 place, out Quaternion rotation);
            float3 acceleration = FollowBox(place, duration);
            Vector3 felt = inertial ? gravity - (Vector3)acceleration : gravity;
            input = new StepInput
            {
                timeStep = FixedStep,
                gravity = Quaternion.Inverse(rotation) * felt + UniformField(new DomainFrame(place, rotation, domainSize, particleSpacing)),
                settings = effective,
                material = material,
                needsDensity = NeedsDensity,
                colliders = colliders.Set,
                tracksPhases = TrackPhases,
                foam = NeedsFoam ?? default,
                foamSeed = seed,
            };
            NeedsDensity = false;
            NeedsFoam = null;
            Gate.TurnOffMissing(pbf, ref input);
            if (IsConnected)
            {
                input.settings.sleepSpeed = 0f;     // what sleeps does not feel what comes
                input.connections = neighbors;
            }
            wanted = FeatureSet.None;
            input.settings.relaxation = effective.StableRelaxation(pbf.IsDeep(input));
            input.settings.substeps = effective.StableSubsteps(GravityStep);
            CheckViscosity();
        }

        // Acceleration of the box since the last steps, m/s²: 0 until its velocity is known. A box that moves as time goes on, or as the
        // fluid begins, does not come from rest.
        float3 FollowBox(float3 position, float duration)
        {
            float3 acceleration = 0f;
            if (positionIsKnown)
            {
                float3 velocity = (position - lastPosition) / duration;
                if (lastDuration > 0f)      // each velocity is that in the middle of its time
                    acceleration = (velocity - lastVelocity) / (0.5f * (lastDuration + duration));
                lastVelocity = velocity;
                lastDuration = duration;
            }
            lastPosition = position;
            positionIsKnown = true;
            return acceleration;
        }

        // How far gravity and the strongest field carry a particle in a step, d. Gravity alone of what the box feels: a jerk of the box is
        // one step's, and its cost would come as a hitch.
        float GravityStep => (gravity.magnitude + StrongestField) * FixedStep * FixedStep / particleSpacing;

        void CheckSettings()
        {
            solver.Validate(out string problem);
            material.Validate(out string materialProblem);
            Limit.Append(ref problem, materialProblem);
            budget.Validate(out string budgetProblem);
            Limit.Append(ref problem, budgetProblem);
            Limit.Finite("gravity", ref gravity, DefaultGravity, ref problem);
            Limit.Clamp("step rate", ref stepRate, 10f, MaxStepRate, DefaultStepRate, ref problem);
            Limit.Clamp("max steps per frame", ref maxStepsPerFrame, 1, 16, ref problem);
            ValidateCulling(ref problem);
            ValidateKept(ref problem);
            clamped.Set(problem);
        }

        bool Matches(SolverLayout layout)
        {
            return math.all(layout.DomainSize == (float3)domainSize / particleSpacing) && layout.Spacing == particleSpacing
                && layout.Capacity == capacity
                && layout.AskedNeighborCapacity == solver.neighborCapacity && layout.ListRadius == (float)LatticeKernels.Support * solver.listMargin;
        }

        SolverLayout MakeLayout() => new SolverLayout(domainSize, particleSpacing, capacity, solver.neighborCapacity, solver.listMargin);

        // Where the box goes from here on is no motion of its water.
        void StandStill()
        {
            GetPose(out Vector3 place, out _);
            lastPosition = place;
            lastVelocity = 0f;
            lastDuration = 0f;
            positionIsKnown = false;
        }

        // What moved through the fluid's box since the last steps has not moved through the fluid.
        void ClearMotions()
        {
            TeleportParts();
            colliders.Jumped = true;
        }

        // Logs what is wrong and stops, and nothing else in the scene. The component stays enabled: once its settings have changed, the fluid
        // begins again.
        void Fail(string problem)
        {
            failure = problem;
            Debug.LogError($"Rill: FluidSimulation '{name}' is off: {problem}", this);
            Release();
        }
    }
}
