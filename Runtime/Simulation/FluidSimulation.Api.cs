using System;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    // The interface for scripts: settings, state, and calls of the classes that do the work.
    public sealed partial class FluidSimulation
    {
        /// <summary>Inner size of the box, m, each side at least two particle spacings. A running fluid starts again with another in its
        /// next frame.</summary>
        public Vector3 DomainSize { get => domainSize; set => ConfigureIfOther(value, particleSpacing, capacity); }

        /// <summary>Distance between particles at rest, m, above 0. A running fluid keeps its water, as particles of the new spacing: it has them,
        /// and tells the new value, two or three frames later, and its time stands until then. Where the capacity does not hold them it stays as it
        /// is, which is logged.</summary>
        public float ParticleSpacing { get => particleSpacing; set => Resolution.Change(value, Resolution.Capacity, !layoutChanged); }

        /// <summary>Maximum number of particles, 1 to 16,777,216. A running fluid keeps its water, as with another
        /// <see cref="ParticleSpacing"/>.</summary>
        public int Capacity { get => capacity; set => Resolution.Change(Resolution.Spacing, value, !layoutChanged); }

        /// <summary>Sets box, resolution and capacity; a running fluid starts again.</summary>
        /// <param name="size">Inner size of the box, m.</param>
        /// <param name="spacing">Distance between particles at rest, m.</param>
        /// <param name="particles">Maximum number of particles.</param>
        public void Configure(Vector3 size, float spacing, int particles)
        {
            domainSize = size;
            particleSpacing = spacing;
            capacity = particles;
            layoutChanged = true;
        }

        /// <summary>Properties of the fluid. Out-of-range values are clamped with a warning.</summary>
        public FluidMaterial Material { get => material; set { material = value; Changed(); } }

        /// <summary>Materials of phases 1 to 7, at most 7; null for a phase that has the fluid's own <see cref="Material"/>. What they hold acts in
        /// the next step. A material that an emitter, a volume or a script brings and that is not listed gets the next free phase.</summary>
        public FluidMaterialAsset[] PhaseMaterials
        {
            get => phaseMaterials;
            set
            {
                phaseMaterials = value ?? Array.Empty<FluidMaterialAsset>();
                Changed();
            }
        }

        /// <summary>Pairs of materials that mix or have a tension of their own between them. All others stay apart. A pair with a material that is
        /// not in the fluid waits for it. Of two entries for one pair the last counts. Out-of-range values are clamped with a warning.</summary>
        public FluidMaterialPair[] MaterialPairs
        {
            get => materialPairs;
            set
            {
                materialPairs = value ?? Array.Empty<FluidMaterialPair>();
                Changed();
            }
        }

        /// <summary>Returns the phase of a material in this fluid, 1 to 7, and gives it the next free one if it has none. 0, which is logged, where
        /// all are taken; 0 for null.</summary>
        public int PhaseOf(FluidMaterialAsset fluidMaterial) => Phases.PhaseOf(fluidMaterial);

        /// <summary>Dynamic viscosity, Pa s, 0 (off) to 1e6: that of <see cref="Material"/>. Acts as <see cref="Iterations"/> does.</summary>
        public float DynamicViscosity { get => material.dynamicViscosity; set { material.dynamicViscosity = value; Changed(); } }

        /// <summary>Settings of the solver: its effort in a step. Out-of-range values are clamped with a warning.</summary>
        public SolverSettings Settings { get => solver; set { solver = value; Changed(); } }

        /// <summary>Jacobi iterations of the density constraint a substep, 1 to 50: those of <see cref="Settings"/>. Acts from the next step
        /// on, and the water goes on; a <see cref="Budget"/> has bounds of its own. Out-of-range values are clamped with a warning.</summary>
        public int Iterations { get => solver.iterations; set { solver.iterations = value; Changed(); } }

        /// <summary>Substeps of a fixed step, 1 to 16: those of <see cref="Settings"/>. Acts as <see cref="Iterations"/> does.</summary>
        public int Substeps { get => solver.substeps; set { solver.substeps = value; Changed(); } }

        /// <summary>Relaxation, 0 to 2: that of <see cref="Settings"/>. Acts as <see cref="Iterations"/> does.</summary>
        public float Relaxation { get => solver.relaxation; set { solver.relaxation = value; Changed(); } }

        /// <summary>Whether the pressure of deep water is also solved for on a coarse grid: as in <see cref="Settings"/>. Acts as
        /// <see cref="Iterations"/> does.</summary>
        public DeepWater DeepWater { get => solver.deepWater; set { solver.deepWater = value; Changed(); } }

        /// <summary>Mean speed below which water sleeps, m/s, 0 (off) to 1: that of <see cref="Settings"/>. Acts as <see cref="Iterations"/>
        /// does.</summary>
        public float SleepSpeed { get => solver.sleepSpeed; set { solver.sleepSpeed = value; Changed(); } }

        /// <summary>Numerical damping of waves and turning water, 0 to 1: that of <see cref="Settings"/>. Acts as <see cref="Iterations"/>
        /// does.</summary>
        public float NumericalDamping { get => solver.numericalDamping; set { solver.numericalDamping = value; Changed(); } }

        /// <summary>GPU time that the steps may take. Out-of-range values are clamped with a warning.</summary>
        public SolverBudget Budget
        {
            get => budget;
            set
            {
                if (value.mode != budget.mode || value.FrameMilliseconds != budget.FrameMilliseconds)
                    Steps.Budget.LogAgain();
                budget = value;
                Changed();
            }
        }

        /// <summary>The settings that the budget chose, the reason, and the error that they cost.</summary>
        public BudgetState BudgetState => Steps.Budget.State;

        /// <summary>Acceleration in world space, m/s². One that is not finite becomes the default, with a warning.</summary>
        public Vector3 Gravity { get => gravity; set { gravity = value; Changed(); } }

        /// <summary>The four sides of the box: walls, bands that absorb waves, or open water. Acts from the next step on. Out-of-range values
        /// are clamped with a warning.</summary>
        public FluidBorders Borders { get => borders; set { borders = value; Changed(); } }

        /// <summary>Fixed steps in a second of fluid time, 10 to 1000. Acts from the next step on. Out-of-range values are clamped with a
        /// warning.</summary>
        public float StepRate { get => stepRate; set { stepRate = value; Changed(); } }

        /// <summary>Length of a fixed step, s.</summary>
        public float FixedStep => 1f / stepRate;

        /// <summary>Maximum number of steps in a frame, 1 to 16. Acts in the next frame. Out-of-range values are clamped with a warning.</summary>
        public int MaxStepsPerFrame { get => maxStepsPerFrame; set { maxStepsPerFrame = value; Changed(); } }

        /// <summary>Whether acceleration of this object acts on the fluid.</summary>
        public bool Inertial { get => inertial; set => inertial = value; }

        /// <summary>Layers whose Fluid Colliders act on this fluid; all by default. Acts from the next step on: a collider that another mask,
        /// or another layer of its object, takes out has left the fluid. Without effect on what a <c>FluidPhysicsColliders</c> takes.</summary>
        public LayerMask FluidColliderLayers { get => fluidColliderLayers; set => fluidColliderLayers = value; }

        /// <summary>Whether the simulation is frozen.</summary>
        public bool Paused { get => paused; set => paused = value; }

        /// <summary>Behavior while no camera sees the box; the fluid goes on by default.</summary>
        /// <remarks>
        /// Cameras that are enabled and draw this object's layer count, in the frame and where they are before its steps. A camera that a script
        /// renders while it is disabled, the scene view, and a shadow of water that is out of sight do not count. While the fluid is slowed or
        /// paused, what moves in it does not push it, as under <see cref="Paused"/>.
        /// </remarks>
        public FluidCullingMode CullingMode { get => cullingMode; set => cullingMode = value; }

        /// <summary>Distance from a camera to the box beyond which the camera does not count, m; 0 for however far. Out-of-range values are
        /// clamped with a warning.</summary>
        public float CullingDistance { get => cullingDistance; set { cullingDistance = value; Changed(); } }

        /// <summary>Fraction of the time, and so of the steps, that passes while a fluid is slowed, 0.01 to 1. Out-of-range values are
        /// clamped with a warning.</summary>
        public float CulledRate { get => culledRate; set { culledRate = value; Changed(); } }

        /// <summary>Whether no camera saw the box in the last frame, so that the fluid was slowed or paused. False with
        /// <see cref="FluidCullingMode.AlwaysSimulate"/>.</summary>
        public bool IsCulled => Clock.IsCulled;

        /// <summary>Seed of the random offsets of initial particle positions from the lattice. Acts at the next <see cref="Restart"/>
        /// or fill.</summary>
        public int Seed { get => seed; set => seed = value; }

        /// <summary>Snapshot that a restart begins with instead of the volumes; null for the volumes.</summary>
        public FluidSnapshotAsset StartState { get => startState; set => startState = value; }

        /// <summary>
        /// Whether the fluid keeps its water while this component or its object is disabled, and goes on from there when it is enabled again; on
        /// by default, since what is pooled or culled by being disabled should not lose its water. Off: it gives its memory back and begins
        /// again. Turning it off while the fluid is disabled gives the memory back at once.
        /// </summary>
        /// <remarks>A fluid that is destroyed gives all back. A budget measures again. One whose box, spacing, capacity or neighbor lists
        /// changed meanwhile begins again.</remarks>
        public bool KeepStateOnDisable
        {
            get => keepStateOnDisable;
            set
            {
                keepStateOnDisable = value;
                if (!value)
                    ReleaseSuspended();
            }
        }

        /// <summary>Whether the fluid is disabled and keeps its water.</summary>
        public bool HasKeptState => SolverOwner.IsSuspended;

        /// <summary>Maximum number of particles that <see cref="Recenter"/> keeps outside the box where it is told to, 1 to 16,777,216. Acts when it
        /// first keeps some, and after a <see cref="Restart"/>. Out-of-range values are clamped with a warning.</summary>
        public int KeptCapacity { get => keptCapacity; set { keptCapacity = value; Changed(); } }

        /// <summary>Particles that are kept outside the box, as far as the GPU has told: two or three frames ago.</summary>
        public int KeptParticleCount => IsRunning ? Solver.OutsideCount : 0;

        /// <summary>Steps between measurements; 0 for none.</summary>
        public int StatisticsInterval { get => statisticsInterval; set => statisticsInterval = Math.Max(value, 0); }

        /// <summary>Shaders that a build with this fluid contains. Of use in the Editor alone: a player has those that it was built with.</summary>
        public ShadersInBuild ShadersInBuild { get => shadersInBuild; set { shadersInBuild = value; Changed(); } }

        /// <summary>
        /// Whether particles have phases even where no emitter gives any, so that a pass can set them. From the passes of the next step on; once
        /// there they stay until a restart. 8 bytes for each particle of the capacity, and one dispatch a substep.
        /// </summary>
        [field: NonSerialized] public bool TrackPhases { get; set; }

        /// <summary>Whether the fluid runs: enabled, supported and without a problem.</summary>
        public bool IsRunning => Solver != null;

        /// <summary>Whether the frames of a <c>FluidPlayback</c> replace the fluid's steps.</summary>
        public bool IsPlayedBack => Playback.Source != null;

        /// <summary>Fixed steps taken since the last restart.</summary>
        public int StepCount => Clock.StepCount;

        /// <summary>Fluid time since the last restart, s.</summary>
        public double FluidTime => Clock.FluidTime;

        /// <summary>Fluid time of the current frame since the last restart, s: at which the fluid is drawn. Up to a fixed step more than
        /// <see cref="FluidTime"/>.</summary>
        public double FrameTime => Clock.FrameTime;

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

        /// <summary>
        /// Called at the start of each fixed step, which may be none or several times a frame, to record compute passes that read the
        /// particles or change their velocities and phases or remove some; what they change acts in that step. Record into the command
        /// buffer and keep neither argument.
        /// </summary>
        /// <remarks>
        /// Passes run in the order in which they were added, before drains, force fields and the fluid's own passes. One that throws is
        /// logged once, and the others go on. Water that sleeps wakes where particles were removed or got a velocity above the sleep speed.
        /// While there is any, each step also looks for particles to remove.
        /// </remarks>
        public event Action<CommandBuffer, FluidParticles> BeforeStep { add => Steps.Passes.Add(value); remove => Steps.Passes.Remove(value); }

        /// <summary>Removes all particles, fills the volumes again, or takes the start state, and sets fluid time to 0. A fluid that is off
        /// for a problem tries to begin again, and logs what is wrong if it still is.</summary>
        /// <exception cref="InvalidOperationException">Called in a pass of <see cref="BeforeStep"/>.</exception>
        public void Restart()
        {
            Steps.Passes.ThrowInPass();
            ReleaseSuspended();
            if (Resolution.IsPending)
            {
                ConfigureIfOther(domainSize, Resolution.Spacing, Resolution.Capacity);
                BeginAgain();
                return;
            }
            if (!IsRunning)
            {
                if (Failure != null && isActiveAndEnabled)
                    OnEnable();
                return;
            }
            Solver.Clear();
            Clock.Restart();
            Results.Measurements.Restart();
            ResetMotion();
            Inputs.Colliders.DropForces();
            Inputs.Parts.Restart();
            Results.Queries.Restart();
            if (!Snapshots.TryStart())
                Editing.Filling.UploadVolumes();
        }

        /// <summary>The newest measurements, a few frames old; false before the first since a restart, and where the graphics device gave
        /// an error instead of the newest, which is logged.</summary>
        public bool TryGetStatistics(out FluidStatistics statistics) => Results.Measurements.TryGet(out statistics);

        /// <summary>
        /// The particles as the last step left them; false while the fluid is not running. In LateUpdate of an order above
        /// <see cref="ExecutionOrder"/> they are those of the current frame.
        /// </summary>
        public bool TryGetParticles(out FluidParticles particles)
        {
            particles = IsRunning ? new FluidParticles(this) : default;
            return IsRunning;
        }

        /// <summary>Asks for a copy of the particles on the CPU, as the last step left them. It never waits: the copy comes two or three
        /// frames later.</summary>
        /// <param name="readback">Gets the copy. Use it again for every request.</param>
        /// <param name="fields">What to bring of each particle: the fewer, the less memory and traffic.</param>
        /// <returns>Whether the request is pending. False while the one before is, in a player without a graphics device, and where the
        /// stage ParticleAccess is not in the build, which is logged.</returns>
        /// <exception cref="ArgumentNullException">No readback.</exception>
        /// <exception cref="ArgumentOutOfRangeException">No field, or a copy of all fields is more than the device can bind.</exception>
        /// <exception cref="ObjectDisposedException">The readback was disposed of.</exception>
        /// <exception cref="InvalidOperationException">The simulation is not running, though there is a graphics device.</exception>
        public bool RequestParticles(ParticleReadback readback, ParticleFields fields = ParticleFields.All)
            => ParticleReadback.TryRequest(this, readback, fields);

        /// <summary>
        /// Adds particles at once, wherever they are: keep them a spacing apart and out of water that is there. Those beyond the capacity
        /// are refused, counted in the statistics and logged once. Allocates no managed memory after the first call. Does nothing in a
        /// player without a graphics device, as on a dedicated server.
        /// </summary>
        /// <param name="positions">World space, m.</param>
        /// <param name="velocities">World space, m/s; as many as positions.</param>
        /// <param name="phase">Number of the look of all of them, 0 to 7. Other than 0 takes 8 bytes a particle of capacity.</param>
        /// <param name="lifetime">Fluid time after which they are removed, s; 0 for never. Other than 0 takes 8 bytes a particle of capacity.</param>
        /// <exception cref="InvalidOperationException">The simulation is not running, though there is a graphics device.</exception>
        /// <exception cref="ArgumentException">Unequal lengths.</exception>
        /// <exception cref="ArgumentOutOfRangeException">Phase or lifetime is out of range.</exception>
        public void AddParticles(NativeArray<float3> positions, NativeArray<float3> velocities, int phase = 0, float lifetime = 0f)
            => Editing.Add(positions, velocities, phase, lifetime);

        /// <summary>
        /// Fills a shape at once, as far as there is room: not nearer than 0.9 spacings to a particle that is there, not in a collider where the
        /// last step left it (before the first, where that finds it), and not outside the box. What the capacity does not hold is refused,
        /// counted and logged once. Does nothing in a player without a graphics device, and where the stage ParticleEdits is not in the build,
        /// which is logged.
        /// </summary>
        /// <param name="shape">World space. A particle is put where all of it is inside.</param>
        /// <param name="velocity">World space, m/s.</param>
        /// <param name="phase">Number of the look of all of them, 0 to 7. Other than 0 takes 8 bytes a particle of capacity.</param>
        /// <param name="lifetime">Fluid time after which they are removed, s; 0 for never. Other than 0 takes 8 bytes a particle of capacity.</param>
        /// <exception cref="InvalidOperationException">The simulation is not running, though there is a graphics device, or this is called
        /// in a pass of <see cref="BeforeStep"/>.</exception>
        /// <exception cref="ArgumentException">The velocity is not finite, or the shape holds more particles than any simulation.</exception>
        /// <exception cref="ArgumentOutOfRangeException">Phase or lifetime is out of range.</exception>
        public void Fill(FluidShape shape, Vector3 velocity = default, int phase = 0, float lifetime = 0f)
            => Editing.Fill(shape, velocity, phase, lifetime);

        /// <summary>Fills a volume at once, wherever it is in the scene, as far as there is room: as
        /// <see cref="Fill(FluidShape, Vector3, int, float)"/>, with the volume's velocity and material.</summary>
        /// <param name="volume">On any object; it need not be enabled.</param>
        /// <param name="phase">Number of the look of all of them, 0 to 7, where the volume has no material.</param>
        /// <param name="lifetime">Fluid time after which they are removed, s; 0 for never.</param>
        /// <exception cref="ArgumentNullException">There is none.</exception>
        /// <exception cref="InvalidOperationException">The simulation is not running, though there is a graphics device, or this is called
        /// in a pass of <see cref="BeforeStep"/>.</exception>
        /// <exception cref="ArgumentException">The volume cannot be filled; the message says why.</exception>
        /// <exception cref="ArgumentOutOfRangeException">Phase or lifetime is out of range.</exception>
        public void Fill(FluidVolume volume, int phase = 0, float lifetime = 0f) => Editing.Fill(volume, phase, lifetime);

        /// <summary>Fills a shape at once with a material: as <see cref="Fill(FluidShape, Vector3, int, float)"/>, with the phase of the
        /// material.</summary>
        /// <param name="shape">World space. A particle is put where all of it is inside.</param>
        /// <param name="velocity">World space, m/s.</param>
        /// <param name="fluidMaterial">Null for the fluid's own.</param>
        /// <param name="lifetime">Fluid time after which they are removed, s; 0 for never.</param>
        /// <remarks>In a player the shaders for several materials must be in the build: list the material in <see cref="PhaseMaterials"/>, or set
        /// Shaders In Build to All Features.</remarks>
        public void Fill(FluidShape shape, Vector3 velocity, FluidMaterialAsset fluidMaterial, float lifetime = 0f)
            => Editing.Fill(shape, velocity, PhaseOf(fluidMaterial), lifetime);

        /// <summary>
        /// Removes the particles whose center is inside a shape at once. They count as drained, and free their part of the capacity with the
        /// next fixed step. Does nothing in a player without a graphics device, and where the stage ParticleEdits is not in the build,
        /// which is logged.
        /// </summary>
        /// <param name="shape">World space.</param>
        /// <exception cref="InvalidOperationException">The simulation is not running, though there is a graphics device, or this is called
        /// in a pass of <see cref="BeforeStep"/>.</exception>
        public void RemoveInside(FluidShape shape) => Editing.RemoveInside(shape);

        /// <summary>
        /// Removes all particles, also those kept outside the box, and their foam at once. The fluid's time, its statistics and its emitters
        /// go on; what is removed counts as drained. <see cref="Restart"/> also sets time and statistics to 0 and fills the volumes.
        /// Does nothing in a player without a graphics device.
        /// </summary>
        /// <exception cref="InvalidOperationException">The simulation is not running, though there is a graphics device, or this is called
        /// in a pass of <see cref="BeforeStep"/>.</exception>
        public void Clear() => Editing.Clear();

        /// <summary>
        /// Moves the box, and leaves the water where it is in the world: for a box that follows a target. What then lies outside goes to
        /// another fluid, is removed and counts as drained, or is kept and comes back as the box covers its place again. Nothing is pushed,
        /// neither by the box nor by what moved in it in this frame. Foam begins again.
        /// </summary>
        /// <remarks>
        /// Memory stays that of the box, however large the world. Setting the transform instead takes the water along. The part of the box that
        /// is new is empty: <see cref="Fill(FluidShape, Vector3, int, float)"/> of the whole box fills it and leaves the rest as it is.
        /// A particle that is handed over keeps position, velocity, phase and lifetime, and gets a new id. It does not look for room.
        /// </remarks>
        /// <param name="position">Position of this object, world space, m.</param>
        /// <param name="leaving">What happens to particles that then lie outside. What was kept before comes back in any case.</param>
        /// <param name="handOverTo">The fluid that gets those of them that lie in its box, whatever its rotation; null for none. Where its
        /// capacity is full, or it does not run, the rest is removed or kept as the others.</param>
        /// <exception cref="ArgumentException">The position is not finite, or the other fluid is this one or differs in particle spacing,
        /// material or step rate.</exception>
        /// <exception cref="InvalidOperationException">The simulation is not running, though there is a graphics device, or this is called
        /// in a pass of <see cref="BeforeStep"/> of either fluid.</exception>
        public void Recenter(Vector3 position, LeavingParticles leaving = LeavingParticles.Remove, FluidSimulation handOverTo = null)
            => Editing.Recentering.Recenter(position, leaving, handOverTo);

        /// <summary>
        /// Call after putting this object elsewhere: neither the box nor its water has moved through the world between. The water goes on as it
        /// is, in the box, and so do colliders, emitters, drains and floating bodies that went along. Those that stayed where they were in the
        /// world have not moved through the water either. For a fluid that is put elsewhere, and for a floating origin, which shifts the whole
        /// scene: shift it, then call this of each fluid, in the same frame.
        /// </summary>
        /// <remarks>
        /// Positions that were measured before are given where they are now: those of probes, detectors, points and rays, and what carries
        /// floating bodies. Particles kept outside the box go along too. What a moving box pushes is in the manual under <c>Inertial</c>;
        /// <see cref="Recenter"/> moves the box and leaves the water.
        /// </remarks>
        public void Teleport() => Box.Teleport();

        /// <summary>Asks for a snapshot of the present state. It comes two or three frames later; nothing waits for it, and the fluid may
        /// go on meanwhile.</summary>
        /// <remarks>Takes managed memory for all of the state: about 60 bytes a particle, more for fluids with a viscosity, elasticity or
        /// phases.</remarks>
        /// <exception cref="InvalidOperationException">The simulation is not running, or has more particles than one readback takes.</exception>
        public FluidSnapshotRequest RequestSnapshot() => Snapshots.Request();

        /// <summary>
        /// Replaces the present state by a snapshot, at once; the next step goes on from it. Put the box, emitters, drains and
        /// colliders where they were before you call this: what is where it was goes on moving as it did, anything else begins there at rest.
        /// Bodies that the fluid carries are put back by this, with their velocities.
        /// </summary>
        /// <remarks>
        /// Floating bodies are known again as the objects that they are; after a start of the game, or of the scene, by the names of the object
        /// and of those above it, of several with the same names in the order in which they were enabled. Those that are gone, and those that
        /// are new, are named in a warning.
        /// Emitters and drains are told apart by the order in which they were enabled, colliders by shape and size. Foam begins again.
        /// Does nothing in a player without a graphics device.
        /// </remarks>
        /// <param name="snapshot">Snapshot of a fluid with the same box and particle spacing, and of no more particles than this capacity.</param>
        /// <param name="bodies">Whether floating bodies are put back. False: they stay where they are, and begin there at rest.</param>
        /// <exception cref="ArgumentNullException">There is none.</exception>
        /// <exception cref="ArgumentException">It does not fit this fluid; the message says why. The fluid stays as it was.</exception>
        /// <exception cref="InvalidOperationException">The simulation is not running, though there is a graphics device, or this is called
        /// in a pass of <see cref="BeforeStep"/>.</exception>
        public void Restore(FluidSnapshot snapshot, bool bodies = true) => Snapshots.Restore(snapshot, bodies);

        /// <summary>
        /// Waits for the GPU and hands all results that are pending to probes, detectors and batches of this fluid; other readbacks of the game
        /// are left pending. For tests and tools in the Editor: it holds the frame up, and in the game a result that is a few frames old is
        /// there without waiting.
        /// </summary>
        public void FlushQueries() => Results.Queries.Flush();

        /// <summary>
        /// Asks for all probes, detectors and batches of this fluid of the water as it stands at this moment, waits for the GPU, and hands
        /// the results over before it returns. For tests, tools and small scenes: it holds the frame up by all that the GPU still has to do.
        /// Does nothing while the fluid is not running.
        /// </summary>
        /// <exception cref="InvalidOperationException">Called in a pass of <see cref="BeforeStep"/>.</exception>
        public void MeasureQueriesNow()
        {
            Steps.Passes.ThrowInPass("measuring");
            Results.Queries.MeasureNow();
        }
    }
}
