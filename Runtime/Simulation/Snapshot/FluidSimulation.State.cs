using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    // Snapshots: taken without waiting, restored at once; and the one that a restart begins with.
    public sealed partial class FluidSimulation
    {
        const float SamePlace = 1e-3f;      // within which an object is where it was: d in the box, and as many spacings in the world

        [Tooltip("Snapshot that the fluid starts with instead of its volumes. None: the volumes are filled.")]
        [SerializeField] FluidSnapshotAsset startState;

        [NonSerialized] string startProblem;        // of the newest restart

        /// <summary>Snapshot that a restart begins with instead of the volumes; null for the volumes.</summary>
        public FluidSnapshotAsset StartState { get => startState; set => startState = value; }

        /// <summary>Asks for a snapshot of the present state. It comes two or three frames later; nothing waits for it, and the fluid may
        /// go on meanwhile.</summary>
        /// <remarks>Takes managed memory for all of the state: about 60 bytes a particle, more for fluids with a viscosity, elasticity or
        /// phases.</remarks>
        /// <exception cref="InvalidOperationException">The simulation is not running, or has more particles than one readback takes.</exception>
        public FluidSnapshotRequest RequestSnapshot()
        {
            StartAgainIfChanged();
            if (pbf == null)
                throw new InvalidOperationException($"FluidSimulation '{name}' is not running: enable it before you take a snapshot.");
            var contents = new SnapshotContents();
            SayKeptIsLeftOut();
            SnapshotCapture capture = pbf.Capture(contents);
            SaveScene(contents, capture);
            var request = new FluidSnapshotRequest();
            capture.Request(request.Finish);
            return request;
        }

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
        /// <param name="snapshot">Of a fluid with the same box and particle spacing, and of no more particles than this capacity.</param>
        /// <param name="bodies">Whether floating bodies are put back. False: they stay where they are, and begin there at rest.</param>
        /// <exception cref="ArgumentNullException">There is none.</exception>
        /// <exception cref="ArgumentException">It does not fit this fluid; the message says why. The fluid stays as it was.</exception>
        /// <exception cref="InvalidOperationException">The simulation is not running, though there is a graphics device, or this is called
        /// in a pass of <see cref="BeforeStep"/>.</exception>
        public void Restore(FluidSnapshot snapshot, bool bodies = true)
        {
            if (snapshot == null)
                throw new ArgumentNullException(nameof(snapshot));
            ThrowInPass();
            if (pbf == null && HasNoGraphics)
                return;
            if (pbf != null && layoutChanged)
            {
                Release();
                OnEnable();
            }
            if (pbf == null)
                throw new InvalidOperationException($"FluidSimulation '{name}' is not running: enable it before you restore a snapshot.");
            if (pbf.ProblemOf(snapshot.Contents) is string problem)
                throw new ArgumentException($"The snapshot does not fit FluidSimulation '{name}': {problem}", nameof(snapshot));

            resampling = null;
            pbf.Restore(snapshot.Contents, FeaturesFor(snapshot.Contents));
            LoadScene(snapshot.Contents, bodies);
        }

        // Instead of the volumes; false where there is none, or it does not fit.
        bool TryStartFromState()
        {
            string before = startProblem;
            startProblem = StartStateProblem;
            if (startState == null)
                return false;
            if (startProblem != null)
            {
                if (startProblem != before)
                    Debug.LogError($"Rill: FluidSimulation '{name}' {startProblem}", this);
                return false;
            }
            SnapshotContents contents = startState.Snapshot.Contents;
            pbf.Restore(contents.Fluid(), FeaturesFor(contents));
            return true;
        }

        // Why the start state is not used; null where it is, or there is none.
        string StartStateProblem
        {
            get
            {
                if (startState == null)
                    return null;
                if (!startState.Validate(out string problem))
                    return $"fills its volumes instead of its start state: {problem}";
                problem = pbf != null ? pbf.ProblemOf(startState.Snapshot.Contents) : null;
                return problem != null ? $"fills its volumes instead of its start state '{startState.name}': {problem}" : null;
            }
        }

        // Those that the scene asks for, as far as the build and the device have them.
        FeatureSet FeaturesFor(SnapshotContents contents)
        {
            var still = new StepInput { settings = solver, material = material };
            FeatureSet features = FeatureSet.None;
            if (contents.Has(SnapshotSection.Rest) && RestingRegions.IsNeeded(still))
                features = features.With(Features.Sleep, Has(Features.Sleep));
            if (contents.Has(SnapshotSection.Coarse) && solver.deepWater != DeepWater.Off)
                features = features.With(Features.DeepWater, Has(Features.DeepWater));
            if (contents.Has(SnapshotSection.Conformation) && Viscoelasticity.IsNeeded(still))
                features = features.With(Features.Elasticity, Has(Features.Elasticity));
            if (contents.Has(SnapshotSection.NeighborCounts) && ImplicitViscosity.IsNeeded(still))
                features = features.With(Features.Viscosity, Has(Features.Viscosity));
            if (contents.Has(SnapshotSection.EmitterStates) && HasAny(emitters))
                features = features.With(Features.Emitters, Has(Features.Emitters));
            if (contents.Has(SnapshotSection.DrainStates) || contents.Has(SnapshotSection.Tags))
                features = features.With(Features.Drains, Has(Features.Drains));
            if (contents.Has(SnapshotSection.Fields) && HasAny(fields))
                features = features.With(Features.ForceFields, Has(Features.ForceFields));
            if (contents.Has(SnapshotSection.Colliders) && (SceneColliders.Enabled.Count > 0 || ColliderSource != null))
                features = features.With(Features.Colliders, Has(Features.Colliders));
            return features;
        }

        static bool HasAny(FluidPart[] parts)
        {
            foreach (FluidPart part in parts)
                if (part != null)
                    return true;
            return false;
        }

        // What the component and its parts know besides their settings.
        void SaveScene(SnapshotContents contents, SnapshotCapture capture)
        {
            GetPose(out Vector3 place, out Quaternion rotation);
            contents.Set(SnapshotSection.Time, new TimeRecord
            {
                stepCount = StepCount,
                fluidTime = FluidTime,
                lastFrameTime = lastFrameTime,
                clock = clock.Record,
                box = new PoseRecord(new RigidPose(place, rotation)),
                lastPosition = lastPosition,
                lastVelocity = lastVelocity,
                lastDuration = lastDuration,
                goneEmitters = goneEmitters,
                goneDrains = goneDrains,
                collidersJump = colliders.Jumped ? 1u : 0u,
            });
            var frame = new DomainFrame(place, rotation, domainSize, particleSpacing);
            var emitterRecords = new List<EmitterRecord>();
            foreach (FluidPart emitter in emitters)
                if (emitter != null)
                    emitterRecords.Add(((IEmitter)emitter).Save(frame));
            var drainRecords = new List<DrainRecord>();
            foreach (FluidPart drain in drains)
                if (drain != null)
                    drainRecords.Add(((IDrain)drain).Save(frame));
            SetIfAny(contents, SnapshotSection.Emitters, emitterRecords);
            SetIfAny(contents, SnapshotSection.Drains, drainRecords);
            SetIfAny(contents, SnapshotSection.Colliders, colliders.Save(frame));
            SaveCalls(contents);
            SetIfAny(contents, SnapshotSection.Forces, colliders.SaveForces(this));
            var taken = new List<TakenRecord>();
            ReactionsRecord reactions = colliders.SaveTaken(this, taken);
            pbf.CaptureReactions(capture, contents, colliders.Set, reactions);
            SetIfAny(contents, SnapshotSection.TakenColliders, taken);
            SaveBodies(contents, capture);
        }

        void SaveCalls(SnapshotContents contents)
        {
            var calls = new CallsRecord
            {
                collected = isTeleported ? new PoseRecord(collectedFrame.Box) : default,
                flags = (positionIsKnown ? CallsRecord.PositionIsKnown : 0) | (isTeleported ? CallsRecord.IsTeleported : 0),
                stepsSinceReadback = stepsSinceReadback,
            };
            clock.SaveDrops(ref calls);
            contents.Set(SnapshotSection.Calls, calls);
        }

        static void SetIfAny<T>(SnapshotContents contents, SnapshotSection section, List<T> records) where T : struct
        {
            if (records.Count > 0)
                contents.SetValues<T>(section, records.ToArray());
        }

        void LoadScene(SnapshotContents contents, bool putsBodies)
        {
            TimeRecord time = contents.Get<TimeRecord>(SnapshotSection.Time);
            StepCount = time.stepCount;
            FluidTime = time.fluidTime;
            lastFrameTime = time.lastFrameTime;
            clock.Record = time.clock;
            stepsSinceStatistics = 0;
            StandStill();
            RestartSources();
            RestartQueries();

            GetPose(out Vector3 place, out Quaternion rotation);
            isTeleported = false;
            if (time.box.IsAt(new RigidPose(place, rotation), SamePlace * particleSpacing))
            {
                lastPosition = time.lastPosition;
                lastVelocity = time.lastVelocity;
                lastDuration = time.lastDuration;
                positionIsKnown = lastDuration > 0f;
                LoadCalls(contents);
            }
            var box = new BoxMotion(time.box.Pose, new RigidPose(place, rotation));
            var frame = new DomainFrame(place, rotation, domainSize, particleSpacing);
            List<RestoredBody> bodies = putsBodies ? PlaceBodies(contents, box) : new List<RestoredBody>();
            LoadParts(contents, time, frame);
            LoadColliders(contents, frame, box);
            colliders.Jumped = time.collidersJump != 0;
            LoadBodies(bodies, box);
        }

        void LoadCalls(SnapshotContents contents)
        {
            if (!contents.Has(SnapshotSection.Calls))
                return;
            CallsRecord calls = contents.Get<CallsRecord>(SnapshotSection.Calls);
            clock.LoadDrops(calls);
            positionIsKnown = (calls.flags & CallsRecord.PositionIsKnown) != 0;
            isTeleported = (calls.flags & CallsRecord.IsTeleported) != 0;
            if (isTeleported)
                collectedFrame = new DomainFrame(calls.collected.position, calls.collected.Pose.rotation, domainSize, particleSpacing);
            stepsSinceReadback = calls.stepsSinceReadback;
        }

        void LoadParts(SnapshotContents contents, in TimeRecord time, in DomainFrame frame)
        {
            // Those of the snapshot that are no more give up what waits for them.
            goneEmitters = time.goneEmitters;
            goneDrains = time.goneDrains;
            foreach (EmitterRecord record in contents.Values<EmitterRecord>(SnapshotSection.Emitters))
            {
                FluidPart emitter = emitters[record.part.number];
                if (emitter != null)
                    ((IEmitter)emitter).Load(record, frame, SamePlace);
                else
                    goneEmitters |= 1u << (int)record.part.number;
            }
            foreach (DrainRecord record in contents.Values<DrainRecord>(SnapshotSection.Drains))
            {
                FluidPart drain = drains[record.part.number];
                if (drain != null)
                    ((IDrain)drain).Load(record, frame, SamePlace);
                else
                    goneDrains |= 1u << (int)record.part.number;
            }
        }

        // Those that are where they were go on from there; the others are new to the fluid, and wake what rests.
        void LoadColliders(SnapshotContents contents, in DomainFrame frame, in BoxMotion box)
        {
            ReadOnlySpan<ColliderRecord> records = contents.Values<ColliderRecord>(SnapshotSection.Colliders);
            int before = colliders.Set.Count;
            bool areAllThere = colliders.Load(records, frame, SamePlace, GatherOwnColliders(), this);
            if (!box.IsTurned)
                colliders.LoadForces(this, contents, box.Shift);
            if (records.Length > 0 && areAllThere && Gate.IsLoaded(Features.Colliders))
            {
                if (!box.IsTurned)
                    pbf.AdoptColliders(colliders.Set);
                if (pbf.Reactions != null)
                    pbf.Reactions.Arrived = OnReactions;
            }
            else if (records.Length + before > 0)
            {
                colliders.Set.Version++;
                pbf.Resting?.Wake();        // also where none is left, of which no step would tell
            }
        }
    }
}
