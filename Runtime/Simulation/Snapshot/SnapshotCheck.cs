using System;
using System.Runtime.InteropServices;
using Unity.Mathematics;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Whether what stands in the sections of a snapshot can be: nothing that a kernel would follow out of a buffer.</summary>
    static class SnapshotCheck
    {
        const int MaxSubsteps = 1024;
        const double MaxSeconds = 1e12;

        /// <exception cref="System.IO.InvalidDataException">It cannot; the message says what.</exception>
        public static void Check(SnapshotContents contents)
        {
            SolverRecord solver = Single<SolverRecord>(contents, SnapshotSection.Solver);
            CheckSolver(solver);
            CheckParticles(contents, solver);
            CheckLists(contents, solver);
            CheckStages(contents, solver);
            CheckScene(contents, solver.spacing);
        }

        static void CheckSolver(in SolverRecord solver)
        {
            Require(solver.spacing > 0f && IsFinite(solver.spacing) && math.all(solver.domainSize > 0f) && IsFinite(solver.domainSize),
                "their particle spacing or box is not a valid size");
            Require(solver.particles <= SolverLayout.MaxCapacity && solver.moved <= solver.particles
                && solver.maxParticles >= solver.particles,
                Invariant($"{solver.particles:N0} particles, {solver.moved:N0} of which moved, cannot be"));
            Require(solver.lastSubsteps >= 0 && solver.lastSubsteps <= MaxSubsteps && (solver.lastSubsteps > 0 || solver.moved == 0),
                Invariant($"{solver.lastSubsteps} substeps cannot be"));
            Require(IsFinite(solver.minAdded) && IsFinite(solver.maxAdded), "where particles were added is not finite");
            Require(solver.flags <= (SolverRecord.HasNew | SolverRecord.IsStart | SolverRecord.HasMarked) && solver.hasLifetimes <= 1,
                "a flag is unknown");
        }

        static void CheckParticles(SnapshotContents contents, in SolverRecord solver)
        {
            Length(contents, SnapshotSection.Counters, sizeof(uint) * ParticleBuffers.CounterCount);
            ReadOnlySpan<uint> counters = contents.Values<uint>(SnapshotSection.Counters);
            Require(counters[(int)ParticleCounter.Alive] == solver.particles && counters[(int)ParticleCounter.Moved] == solver.moved
                && counters[(int)ParticleCounter.Sorted] <= SolverLayout.MaxCapacity, "their counts contradict each other");
            Length(contents, SnapshotSection.Positions, 16L * solver.particles);
            Length(contents, SnapshotSection.Velocities, 16L * solver.particles);
            Length(contents, SnapshotSection.Ids, 4L * solver.particles);
            if (solver.moved > 0 || contents.Has(SnapshotSection.StartPositions))
                Length(contents, SnapshotSection.StartPositions, 16L * solver.moved);
            if (solver.hasLifetimes != 0 || contents.Has(SnapshotSection.Tags))
                Length(contents, SnapshotSection.Tags, 4L * solver.particles);

            uint last = 0;
            foreach (uint start in contents.Values<uint>(SnapshotSection.CellStarts))
            {
                Require(start >= last && start <= solver.particles, "their cells contradict their number");
                last = start;
            }

            // Two with one id would be sorted to one place and leave another unset.
            uint[] ids = contents.Values<uint>(SnapshotSection.Ids).ToArray();
            Array.Sort(ids);
            for (int i = 1; i < ids.Length; i++)
                if (ids[i] == ids[i - 1])
                    throw SnapshotFormat.Damaged(Invariant($"two particles have the id {ids[i]}"));
        }

        static void CheckLists(SnapshotContents contents, in SolverRecord solver)
        {
            if (!contents.Has(SnapshotSection.NeighborCounts) && !contents.Has(SnapshotSection.Neighbors))
                return;
            Length(contents, SnapshotSection.NeighborCounts, 4L * solver.moved);
            long entries = 0;
            foreach (uint count in contents.Values<uint>(SnapshotSection.NeighborCounts))
                entries += count;
            Length(contents, SnapshotSection.Neighbors, 4L * entries);
            foreach (uint neighbor in contents.Values<uint>(SnapshotSection.Neighbors))
                if (neighbor >= solver.moved)
                    throw SnapshotFormat.Damaged(Invariant($"a neighbor has index {neighbor} of {solver.moved:N0}"));
        }

        static void CheckStages(SnapshotContents contents, in SolverRecord solver)
        {
            if (contents.Has(SnapshotSection.Rest))
            {
                RestRecord rest = Single<RestRecord>(contents, SnapshotSection.Rest);
                Require(IsFinite(rest.gravity) && IsFinite(rest.timeStep) && rest.wake <= 1, "what the water rested under is not finite");
            }
            if (contents.Has(SnapshotSection.Coarse))
            {
                Require(IsFinite(Single<CoarseRecord>(contents, SnapshotSection.Coarse).wantedSize), "the size of coarse cells is not finite");
                if (contents.Has(SnapshotSection.FlowTime))
                    Require(Single<float>(contents, SnapshotSection.FlowTime) is float time && time >= 0f && IsFinite(time),
                        "the flow's time is not finite");
                foreach (SnapshotSection section in new[] { SnapshotSection.CoarseErrors, SnapshotSection.FlowPotential,
                    SnapshotSection.ErrorPotential })
                    foreach (float value in contents.Values<float>(section))
                        if (!IsFinite(value))
                            throw SnapshotFormat.Damaged(Invariant($"section {section} is not finite"));
            }
            if (contents.Has(SnapshotSection.Extrapolation))
            {
                ExtrapolationRecord extrapolation = Single<ExtrapolationRecord>(contents, SnapshotSection.Extrapolation);
                Require(extrapolation.lastTimeStep >= 0f && IsFinite(extrapolation.lastTimeStep) && IsFinite(extrapolation.lastWeight),
                    "the last time step is not finite");
                Length(contents, SnapshotSection.Means, 16L * solver.moved);
            }
            if (contents.Has(SnapshotSection.Conformation))
                Length(contents, SnapshotSection.Conformation, 24L * solver.moved);
            if (contents.Has(SnapshotSection.EmitterStates))
                Length(contents, SnapshotSection.EmitterStates, sizeof(uint) * StepSources.MaxEmitters * EmitterStates.Words);
            if (contents.Has(SnapshotSection.DrainStates))
                Length(contents, SnapshotSection.DrainStates, sizeof(uint) * StepSources.MaxDrains * Drains.Words);
            Several<FieldRegion>(contents, SnapshotSection.Fields, StepSources.MaxFields);
            Require(AreFinite(contents.Bytes(SnapshotSection.Fields)), "a force field is not finite");
        }

        static void CheckScene(SnapshotContents contents, float spacing)
        {
            if (contents.Has(SnapshotSection.Time))
            {
                TimeRecord time = Single<TimeRecord>(contents, SnapshotSection.Time);
                ClockRecord clock = time.clock;
                Require(time.stepCount >= 0 && IsTime(time.fluidTime) && IsTime(time.lastFrameTime) && IsTime(clock.accumulated)
                    && IsTime(clock.passing) && IsTime(clock.dropped)
                    && IsTime(clock.frameInterval) && IsTime(clock.lag) && IsTime(clock.frameLag) && IsTime(clock.lastFrameLag),
                        "a time is negative or not finite");
                Require(time.box.IsFinite && IsFinite(time.lastPosition) && IsFinite(time.lastVelocity) && time.lastDuration >= 0f
                    && IsFinite(time.lastDuration), "the pose of the box is not finite");
                Require(time.collidersJump <= 1, "a flag of the time is unknown");
            }
            foreach (EmitterRecord emitter in Several<EmitterRecord>(contents, SnapshotSection.Emitters, StepSources.MaxEmitters))
            {
                CheckPart(emitter.part, StepSources.MaxEmitters);
                double whole = emitter.clock.volume / ((double)spacing * spacing * spacing);
                Require(IsTime(emitter.clock.volume) && IsTime(emitter.clock.time) && emitter.clock.due >= 0
                    && emitter.clock.due <= whole + 1.0, "what an emitter let in is negative, not finite or more than was due");
                Require(emitter.isOn <= 1 && emitter.saysLast <= 1, "a flag of an emitter is unknown");
            }
            foreach (DrainRecord drain in Several<DrainRecord>(contents, SnapshotSection.Drains, StepSources.MaxDrains))
            {
                CheckPart(drain.part, StepSources.MaxDrains);
                Require(IsTime(drain.budget), "what a drain may take is negative or not finite");
            }
            foreach (ColliderRecord collider in Several<ColliderRecord>(contents, SnapshotSection.Colliders, ColliderSet.MaxCount))
            {
                Require(IsFinite(collider.size) && collider.now.IsFinite && collider.end.IsFinite && collider.seen.IsFinite,
                    "the pose of a collider is not finite");
                Require(Enum.IsDefined(typeof(ColliderShape), collider.shape) && collider.follows <= 1, "the shape of a collider is unknown");
            }
            CheckCalls(contents);
            CheckForces(contents);
            if (contents.Has(SnapshotSection.Bodies))
                contents.Bodies = SnapshotBodies.Read(contents.Bytes(SnapshotSection.Bodies));
        }

        static void CheckCalls(SnapshotContents contents)
        {
            if (!contents.Has(SnapshotSection.Calls))
                return;
            CallsRecord calls = Single<CallsRecord>(contents, SnapshotSection.Calls);
            Require(IsTime(calls.frameDropped) && calls.droppingFrames >= 0 && calls.sinceDrop >= 0 && calls.collected.IsFinite
                && calls.flags <= (CallsRecord.PositionIsKnown | CallsRecord.IsTeleported) && calls.stepsSinceReadback >= 0,
                "what was called since the last steps cannot be");
        }

        static void CheckForces(SnapshotContents contents)
        {
            int colliders = Several<ColliderRecord>(contents, SnapshotSection.Colliders, ColliderSet.MaxCount).Length;
            ReadOnlySpan<ForceRecord> forces = Several<ForceRecord>(contents, SnapshotSection.Forces, ColliderSet.MaxCount);
            Require(forces.Length == 0 || forces.Length == colliders, "there are forces of other colliders");
            foreach (ForceRecord force in forces)
                Require(force.flags <= ForceRecord.All && force.step >= 0 && force.duration >= 0f && force.quiet >= 0f,
                    "a force on a collider cannot be");
            Require(AreFinite(contents.Bytes(SnapshotSection.Forces)) && AreFinite(contents.Bytes(SnapshotSection.TakenColliders)),
                "a force on a collider is not finite");
            Several<TakenRecord>(contents, SnapshotSection.TakenColliders, ColliderSet.MaxCount);
            if (!contents.Has(SnapshotSection.Reactions))
                return;
            ReactionsRecord reactions = Single<ReactionsRecord>(contents, SnapshotSection.Reactions);
            long bytes = sizeof(uint) * (long)ColliderReactions.WordsOf(reactions.hasWettedAreas != 0);
            Length(contents, SnapshotSection.ReactionSums, bytes);
            if (reactions.frames != ReactionsRecord.NothingPending)
                Length(contents, SnapshotSection.ReactionsTaken, bytes);
            Require(reactions.time >= 0f && IsFinite(reactions.time) && reactions.takenTime >= 0f && IsFinite(reactions.takenTime)
                && reactions.hasWettedAreas <= 1 && reactions.frames >= ReactionsRecord.NothingPending && math.isfinite(reactions.takenImpulse)
                && math.all(math.isfinite((float3)reactions.shiftSince)) && math.all(math.isfinite(((quaternion)reactions.takenRotation).value))
                && reactions.takenStep >= 0, "the sums of forces on colliders cannot be");
        }

        // Flags and counts look like small floats.
        static bool AreFinite(byte[] bytes)
        {
            foreach (float value in MemoryMarshal.Cast<byte, float>(bytes))
                if (!IsFinite(value))
                    return false;
            return true;
        }

        static void CheckPart(in PartRecord part, int most)
        {
            Require(part.number < most && part.follows <= 1 && part.now.IsFinite && part.last.IsFinite,
                "the number or the pose of an emitter or a drain cannot be");
        }

        static T Single<T>(SnapshotContents contents, SnapshotSection section) where T : struct
        {
            Length(contents, section, SnapshotContents.SizeOf<T>());
            return contents.Get<T>(section);
        }

        static ReadOnlySpan<T> Several<T>(SnapshotContents contents, SnapshotSection section, int most) where T : struct
        {
            int length = contents.Bytes(section).Length, size = SnapshotContents.SizeOf<T>();
            Require(length % size == 0 && length / size <= most, Invariant($"section {section} has {length:N0} bytes, not up to {most} ") +
                Invariant($"times {size}"));
            return contents.Values<T>(section);
        }

        static void Length(SnapshotContents contents, SnapshotSection section, long wanted)
        {
            int length = contents.Bytes(section).Length;
            Require(contents.Has(section) && length == wanted, Invariant($"section {section} has {length:N0} bytes, not {wanted:N0}"));
        }

        static bool IsFinite(float value) => math.isfinite(value);

        static bool IsFinite(float3 value) => math.all(math.isfinite(value));

        static bool IsTime(double value) => value >= 0.0 && value <= MaxSeconds;

        static void Require(bool holds, string how)
        {
            if (!holds)
                throw SnapshotFormat.Damaged(how);
        }
    }
}
