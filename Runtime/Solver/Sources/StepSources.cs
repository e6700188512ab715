namespace Rill
{
    /// <summary>Work of emitters, drains, force fields and sources of smoke in one step, in the domain's frame; used again for every step.</summary>
    sealed class StepSources
    {
        /// <summary>Most emitters of a simulation.</summary>
        public const int MaxEmitters = 32;
        /// <summary>most drains of a simulation</summary>
        [GenerateHlsl("Drains")] public const int MaxDrains = 32;
        /// <summary>Most force fields of a simulation.</summary>
        public const int MaxFields = 32;
        /// <summary>Most sources of smoke of a simulation.</summary>
        public const int MaxSmokeSources = 32;

        public readonly EmitterStep[] emitters = new EmitterStep[MaxEmitters];
        public readonly DrainRegion[] drains = new DrainRegion[MaxDrains];
        public readonly FieldRegion[] fields = new FieldRegion[MaxFields];
        public readonly SmokeRegion[] smoke = new SmokeRegion[MaxSmokeSources];
        public int emitterCount, drainCount, fieldCount, smokeCount;

        /// <summary>Bit e: the emitter with number e is gone, and what waits for it is given up before this step emits.</summary>
        public uint goneEmitters;
        /// <summary>Bit d: the drain with number d is gone, and what it took does not count for the next with that number.</summary>
        public uint goneDrains;
        /// <summary>Whether there are emitters, also such that do nothing in this step: what they have done is kept.</summary>
        public bool keepsEmitters;
        /// <summary>Whether there are drains, also such that do nothing in this step: what they have taken is kept.</summary>
        public bool keepsDrains;
        /// <summary>Whether an emitter gives its particles a phase or a lifetime.</summary>
        public bool needsTags;
        /// <summary>Whether an emitter gives its particles a lifetime.</summary>
        public bool needsLifetimes;
        /// <summary>Whether a drain gives its particles to an emitter.</summary>
        public bool recycles;
        /// <summary>Whether one of the drains has a limit.</summary>
        public bool limitsDrains;
        /// <summary>Whether a wind asks for the density at the particles.</summary>
        public bool hasWind;

        /// <summary>Nothing acts, until it is added.</summary>
        public void Clear()
        {
            emitterCount = drainCount = fieldCount = smokeCount = 0;
            goneEmitters = goneDrains = 0;
            keepsEmitters = keepsDrains = needsTags = needsLifetimes = recycles = limitsDrains = hasWind = false;
        }

        public void Add(in EmitterStep emitter)
        {
            emitters[emitterCount++] = emitter;
            needsTags |= emitter.phase != 0 || emitter.lifetimeSteps != 0;
            needsLifetimes |= emitter.lifetimeSteps != 0;
        }

        public void Add(in DrainRegion drain)
        {
            drains[drainCount++] = drain;
            recycles |= drain.emitter != DrainRegion.NoEmitter;
            limitsDrains |= drain.limit != DrainRegion.NoLimit;
        }

        public void Add(in FieldRegion field)
        {
            fields[fieldCount++] = field;
            hasWind |= field.kind == (uint)ForceFieldKind.Wind;
        }

        public void Add(in SmokeRegion region) => smoke[smokeCount++] = region;

        /// <summary>Takes out what emitters do.</summary>
        public void LeaveOutEmitters()
        {
            emitterCount = 0;
            goneEmitters = 0;
            keepsEmitters = needsTags = needsLifetimes = recycles = false;
        }

        /// <summary>Takes out phases and lifetimes of emitted particles.</summary>
        public void LeaveOutTags() => needsTags = needsLifetimes = false;

        /// <summary>Takes out what drains do.</summary>
        public void LeaveOutDrains()
        {
            drainCount = 0;
            goneDrains = 0;
            keepsDrains = recycles = limitsDrains = false;
        }

        /// <summary>Takes out force fields.</summary>
        public void LeaveOutFields()
        {
            fieldCount = 0;
            hasWind = false;
        }
    }
}
