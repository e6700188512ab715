using System.Collections.Generic;
using UnityEngine;

namespace Rill
{
    /// <summary>The parts that are attached to a fluid, by their numbers: emitters, drains, force fields and sources of smoke, which act on it,
    /// and probes and detectors, which measure it. Gathers those that act for each step.</summary>
    sealed class SceneParts
    {
        const int ReadbackInterval = 10;        // steps between readbacks of the emitters' and drains' numbers

        readonly FluidSimulation fluid;
        readonly FluidPart[] emitters = new FluidPart[StepSources.MaxEmitters];
        readonly FluidPart[] drains = new FluidPart[StepSources.MaxDrains];
        readonly FluidPart[] fields = new FluidPart[StepSources.MaxFields];
        readonly FluidPart[] smokeSources = new FluidPart[StepSources.MaxSmokeSources];
        readonly FluidPart[] probes = new FluidPart[Queries.MaxProbes];
        readonly FluidPart[] detectors = new FluidPart[Queries.MaxDetectors];
        int actingCount;
        uint goneEmitters, goneDrains;      // since the last step, a bit for each number
        readonly BorderLevels levels = new BorderLevels();
        uint levelNumbers;                  // of the emitters and drains at open borders in the last step, a bit for each
        int stepsSinceReadback;
        StepSources sources;

        public SceneParts(FluidSimulation fluid) => this.fluid = fluid;

        /// <summary>Slots of the probes, null where one is free.</summary>
        public FluidPart[] Probes => probes;

        /// <summary>Slots of the detectors, null where one is free.</summary>
        public FluidPart[] Detectors => detectors;

        /// <summary>Probes and detectors.</summary>
        public int QueryCount { get; private set; }

        /// <summary>Whether an emitter names a phase by its number, without a material.</summary>
        public bool NamesPhase(int phase)
        {
            bool names = false;
            foreach (FluidPart part in emitters)
                names |= part != null && ((IEmitter)part).NamedPhase == phase;
            return names;
        }

        /// <summary>Lets the materials of all emitters get a phase.</summary>
        public void FindPhases()
        {
            foreach (FluidPart part in emitters)
                if (part != null)
                    fluid.Phases.PhaseOf(((IEmitter)part).Material);
        }

        public bool HasEmitters => HasAny(emitters);

        public bool HasFields => HasAny(fields);

        /// <summary>Gives a part its number, or none where there are too many of its kind.</summary>
        public void Attach(FluidPart part)
        {
            FluidPart[] slots = SlotsFor(part);
            for (int number = 0; number < slots.Length; number++)
            {
                if (slots[number] != null)
                    continue;
                slots[number] = part;
                part.Number = number;
                Count(part, 1);
                part.OnRestart();
                break;
            }
        }

        /// <summary>Maximum number of parts of a part's kind.</summary>
        public int MaxOf(FluidPart part) => SlotsFor(part).Length;

        /// <summary>Takes a part's number back.</summary>
        public void Detach(FluidPart part)
        {
            FluidPart[] slots = SlotsFor(part);
            if (part.Number < 0 || slots[part.Number] != part)
                return;
            slots[part.Number] = null;
            Count(part, -1);
            if (part.PartKind == PartKind.Emitter)
                goneEmitters |= 1u << part.Number;
            else if (part.PartKind == PartKind.Drain)
                goneDrains |= 1u << part.Number;
        }

        /// <summary>Returns a number of an emitter, as far as it has come back.</summary>
        public int EmitterCount(int number, EmitterStates.Word word) => fluid.Solver?.EmitterStates?.Latest(number, word) ?? 0;

        /// <summary>Returns the particles that a drain has removed, as far as their number has come back.</summary>
        public int DrainedCount(int number) => fluid.Solver?.DrainedBy(number) ?? 0;

        /// <summary>Collects what acts in the next step; null where there is nothing.</summary>
        /// <param name="input">The step, of which the part of the frame is known.</param>
        public StepSources Collect(in StepInput input)
        {
            uint atBorders = BorderLevels.NumbersOf(input.borders) & ~TakenNumbers;
            goneEmitters |= levelNumbers & ~atBorders;
            goneDrains |= levelNumbers & ~atBorders;
            levelNumbers = atBorders;
            if (actingCount == 0 && goneEmitters == 0 && goneDrains == 0 && atBorders == 0)
            {
                Release();
                return null;
            }
            FeatureGate gate = fluid.Support.Gate;
            sources ??= new StepSources();
            sources.Clear();
            sources.goneEmitters = fluid.Solver.EmitterStates != null ? goneEmitters : 0;       // without, nothing waits
            sources.goneDrains = goneDrains;
            goneEmitters = goneDrains = 0;
            DomainFrame frame = fluid.Box.Frame;
            float spacing = fluid.ParticleSpacing;
            uint targets = 0;
            foreach (FluidPart part in drains)
            {
                if (part == null)
                    continue;
                sources.keepsDrains = true;
                if (!gate.IsLoaded(Features.Drains) || !((IDrain)part).TryGetStep(frame, spacing, fluid.FixedStep, input.frameFrom, input.frameTo,
                    out DrainRegion region))
                    continue;
                sources.Add(region);
                if (region.emitter != DrainRegion.NoEmitter)
                    targets |= 1u << (int)region.emitter;
            }
            foreach (FluidPart part in emitters)
            {
                if (part == null)
                    continue;
                sources.keepsEmitters = true;
                if (gate.IsLoaded(Features.Emitters) && ((IEmitter)part).TryGetStep(frame, spacing, fluid.FixedStep, input.frameFrom, input.frameTo,
                    (float)fluid.Clock.Steps.FrameInterval, (targets >> part.Number & 1) != 0, out EmitterStep step))
                    sources.Add(step);
            }
            foreach (FluidPart part in fields)
                if (part != null && part is IForceField field && !field.IsUniform && gate.IsLoaded(Features.ForceFields)
                    && field.TryGetStep(frame, spacing, out FieldRegion region))
                    sources.Add(region);
            if (input.hasSmoke)
                foreach (FluidPart part in smokeSources)
                    if (part != null && ((ISmokeSource)part).TryGetStep(frame, spacing, input.smoke.airTemperature, out SmokeRegion region))
                        sources.Add(region);
            if (atBorders != 0 && gate.IsLoaded(Features.Emitters) && gate.IsLoaded(Features.Drains))
                levels.AddTo(sources, input, atBorders, fluid.Solver.Layout, fluid.Solver.StepIndex);
            sources.needsLifetimes = sources.needsLifetimes && gate.IsLoaded(Features.Drains);
            return sources;
        }

        /// <summary>Whether emitters or drains have a number that an open border needs.</summary>
        public bool LacksNumbers(in FluidBorders borders) => (BorderLevels.NumbersOf(borders) & TakenNumbers) != 0;

        uint TakenNumbers
        {
            get
            {
                uint taken = 0;
                for (int number = BorderLevels.FirstNumber; number < StepSources.MaxEmitters; number++)
                    taken |= emitters[number] != null || drains[number] != null ? 1u << number : 0u;
                return taken;
            }
        }

        /// <summary>Returns what uniform fields add to gravity, m/s² in the domain's frame. Like gravity they also pull in the solver's walls
        /// and surfaces, which a field that varies in space does not.</summary>
        public Vector3 UniformField(in DomainFrame frame)
        {
            Vector3 sum = Vector3.zero;
            if (actingCount > 0)
                foreach (FluidPart part in fields)
                    if (part != null && part is IForceField { IsUniform: true } field
                        && field.TryGetStep(frame, fluid.ParticleSpacing, out FieldRegion region))
                        sum += (Vector3)(region.flow * region.strength * fluid.ParticleSpacing);
            return Vector3.ClampMagnitude(sum, ForceFields.MaxAcceleration);
        }

        /// <summary>Acceleration of the strongest field, m/s²: like gravity, a strong field needs shorter steps.</summary>
        public float MaxFieldAcceleration
        {
            get
            {
                float strongest = 0f;
                if (actingCount > 0)
                    foreach (FluidPart field in fields)
                        if (field != null)
                            strongest = Mathf.Max(strongest, ((IForceField)field).MaxAcceleration);
                return strongest;
            }
        }

        /// <summary>Requests the numbers of emitters and drains, after the steps of a frame were executed, and logs what the last ones
        /// say.</summary>
        public void RequestCounts(int steps)
        {
            if (actingCount == 0)
                return;
            stepsSinceReadback += steps;
            if (stepsSinceReadback < ReadbackInterval)
                return;
            stepsSinceReadback = 0;
            foreach (FluidPart emitter in emitters)
                if (emitter != null)
                    ((IEmitter)emitter).ReportRefused();
            fluid.Solver.RequestSourceCounts();
        }

        /// <summary>Emitters that gave particles up for want of room, as they count it now. Waits for the GPU.</summary>
        public List<FluidPart> FindBlockedEmitters()
        {
            PbfSolver solver = fluid.Solver;
            solver.CompleteSourceCounts();      // one that is pending is of an older state
            solver.RequestSourceCounts();
            solver.CompleteSourceCounts();
            var blocked = new List<FluidPart>();
            foreach (FluidPart emitter in emitters)
                if (emitter != null && ((IEmitter)emitter).Blocked > 0)
                    blocked.Add(emitter);
            return blocked;
        }

        /// <summary>Lets emitters and drains begin where they are: they have not moved through the fluid since the last steps.</summary>
        public void ResetMotion()
        {
            if (actingCount == 0)
                return;
            foreach (FluidPart emitter in emitters)
                if (emitter != null)
                    emitter.Teleport();
            foreach (FluidPart drain in drains)
                if (drain != null)
                    drain.Teleport();
        }

        /// <summary>Begins again with the fluid.</summary>
        public void Restart()
        {
            goneEmitters = goneDrains = levelNumbers = 0;
            stepsSinceReadback = 0;
            foreach (FluidPart emitter in emitters)
                if (emitter != null)
                    emitter.OnRestart();
            foreach (FluidPart drain in drains)
                if (drain != null)
                    drain.OnRestart();
        }

        /// <summary>Lets probes and detectors begin again with the fluid.</summary>
        public void RestartQueries()
        {
            if (QueryCount == 0)
                return;
            foreach (FluidPart probe in probes)
                if (probe != null)
                    probe.OnRestart();
            foreach (FluidPart detector in detectors)
                if (detector != null)
                    detector.OnRestart();
        }

        /// <summary>Lets emitters go on with particles of another spacing.</summary>
        public void ContinueResampled()
        {
            foreach (FluidPart emitter in emitters)
                if (emitter != null)
                    ((IEmitter)emitter).OnResampled();
        }

        public void Release() => sources = null;

        public void Save(SnapshotContents contents, in DomainFrame frame)
        {
            var emitterRecords = new List<EmitterRecord>();
            foreach (FluidPart emitter in emitters)
                if (emitter != null)
                    emitterRecords.Add(((IEmitter)emitter).Save(frame));
            var drainRecords = new List<DrainRecord>();
            foreach (FluidPart drain in drains)
                if (drain != null)
                    drainRecords.Add(((IDrain)drain).Save(frame));
            contents.SetIfAny(SnapshotSection.Emitters, emitterRecords);
            contents.SetIfAny(SnapshotSection.Drains, drainRecords);
        }

        public void Save(ref TimeRecord to)
        {
            to.goneEmitters = goneEmitters;
            to.goneDrains = goneDrains;
        }

        public void Save(ref CallsRecord to) => to.stepsSinceReadback = stepsSinceReadback;

        public void Load(in CallsRecord from) => stepsSinceReadback = from.stepsSinceReadback;

        /// <summary>Loads emitters and drains. Those of the snapshot that are not attached any more give up what waits for them.</summary>
        /// <param name="tolerance">Distance within which a part is where it was, d.</param>
        public void Load(SnapshotContents contents, in TimeRecord time, in DomainFrame frame, float tolerance)
        {
            goneEmitters = time.goneEmitters;
            goneDrains = time.goneDrains;
            foreach (EmitterRecord record in contents.Values<EmitterRecord>(SnapshotSection.Emitters))
            {
                FluidPart emitter = emitters[record.part.number];
                if (emitter != null)
                    ((IEmitter)emitter).Load(record, frame, tolerance);
                else
                    goneEmitters |= 1u << (int)record.part.number;
            }
            foreach (DrainRecord record in contents.Values<DrainRecord>(SnapshotSection.Drains))
            {
                FluidPart drain = drains[record.part.number];
                if (drain != null)
                    ((IDrain)drain).Load(record, frame, tolerance);
                else
                    goneDrains |= 1u << (int)record.part.number;
            }
        }

        FluidPart[] SlotsFor(FluidPart part)
        {
            switch (part.PartKind)
            {
                case PartKind.Emitter: return emitters;
                case PartKind.Drain: return drains;
                case PartKind.ForceField: return fields;
                case PartKind.Probe: return probes;
                case PartKind.SmokeSource: return smokeSources;
                default: return detectors;
            }
        }

        // A part that only measures does not act in a step.
        void Count(FluidPart part, int change)
        {
            if (part is FluidQuery)
                QueryCount += change;
            else
                actingCount += change;
        }

        static bool HasAny(FluidPart[] parts)
        {
            foreach (FluidPart part in parts)
                if (part != null)
                    return true;
            return false;
        }
    }
}
