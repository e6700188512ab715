using System;
using UnityEngine;

namespace Rill
{
    // What acts on the fluid from the scene: emitters, drains and force fields, each with a number of its own.
    public sealed partial class FluidSimulation
    {
        const int ReadbackInterval = 10;        // steps between readbacks of the emitters' and drains' numbers

        readonly FluidPart[] emitters = new FluidPart[StepSources.MaxEmitters];
        readonly FluidPart[] drains = new FluidPart[StepSources.MaxDrains];
        readonly FluidPart[] fields = new FluidPart[StepSources.MaxFields];
        [NonSerialized] int partCount;
        [NonSerialized] uint goneEmitters, goneDrains;      // since the last step, a bit for each number
        StepSources sources;
        [NonSerialized] int stepsSinceReadback;

        /// <summary>Gives a part its number, or none where there are too many of its kind.</summary>
        internal void Attach(FluidPart part)
        {
            FluidPart[] kind = PartsLike(part);
            for (int number = 0; number < kind.Length; number++)
            {
                if (kind[number] != null)
                    continue;
                kind[number] = part;
                part.Number = number;
                CountPart(part, 1);
                part.OnRestart();
                break;
            }
        }

        /// <summary>The most of a part's kind.</summary>
        internal int MaxLike(FluidPart part) => PartsLike(part).Length;

        /// <summary>Takes a part's number back.</summary>
        internal void Detach(FluidPart part)
        {
            FluidPart[] kind = PartsLike(part);
            if (part.Number < 0 || kind[part.Number] != part)
                return;
            kind[part.Number] = null;
            CountPart(part, -1);
            if (part.PartKind == PartKind.Emitter)
                goneEmitters |= 1u << part.Number;
            else if (part.PartKind == PartKind.Drain)
                goneDrains |= 1u << part.Number;
        }

        /// <summary>A number of an emitter, as far as it has come back.</summary>
        internal int EmitterCount(int number, EmitterStates.Word word) => pbf?.EmitterStates?.Latest(number, word) ?? 0;

        /// <summary>Particles that a drain has removed, as far as it has come back.</summary>
        internal int DrainedCount(int number) => pbf?.DrainedBy(number) ?? 0;

        FluidPart[] PartsLike(FluidPart part)
        {
            switch (part.PartKind)
            {
                case PartKind.Emitter: return emitters;
                case PartKind.Drain: return drains;
                case PartKind.ForceField: return fields;
                case PartKind.Probe: return probes;
                default: return detectors;
            }
        }

        // What only asks is no part of a step.
        void CountPart(FluidPart part, int change)
        {
            if (part is FluidQuery)
                queryPartCount += change;
            else
                partCount += change;
        }

        /// <summary>What acts in the next step; null where there is nothing.</summary>
        StepSources TakeSources()
        {
            if (partCount == 0 && goneEmitters == 0 && goneDrains == 0)
            {
                ReleaseSources();
                return null;
            }
            sources ??= new StepSources();
            sources.Clear();
            sources.goneEmitters = pbf.EmitterStates != null ? goneEmitters : 0;       // without, nothing waits
            sources.goneDrains = goneDrains;
            goneEmitters = goneDrains = 0;
            GetPose(out Vector3 place, out Quaternion rotation);
            var frame = new DomainFrame(place, rotation, domainSize, particleSpacing);
            uint targets = 0;
            foreach (FluidPart part in drains)
            {
                if (part == null)
                    continue;
                sources.keepsDrains = true;
                if (!Gate.IsLoaded(Features.Drains) || !((IDrain)part).TryGetStep(frame, particleSpacing, FixedStep, input.frameFrom, input.frameTo,
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
                if (Gate.IsLoaded(Features.Emitters) && ((IEmitter)part).TryGetStep(frame, particleSpacing, FixedStep, input.frameFrom, input.frameTo,
                    (float)clock.FrameInterval, (targets >> part.Number & 1) != 0, out EmitterStep step))
                    sources.Add(step);
            }
            foreach (FluidPart part in fields)
                if (part != null && part is IForceField field && !field.IsUniform && Gate.IsLoaded(Features.ForceFields)
                    && field.TryGetStep(frame, particleSpacing, out FieldRegion region))
                    sources.Add(region);
            sources.needsLifetimes = sources.needsLifetimes && Gate.IsLoaded(Features.Drains);
            return sources;
        }

        // What uniform fields add to gravity, m/s² in the domain's frame. As gravity they pull in the solver's walls and surfaces too,
        // which a field that differs from place to place does not.
        Vector3 UniformField(in DomainFrame frame)
        {
            Vector3 sum = Vector3.zero;
            if (partCount > 0)
                foreach (FluidPart part in fields)
                    if (part != null && part is IForceField { IsUniform: true } field
                        && field.TryGetStep(frame, particleSpacing, out FieldRegion region))
                        sum += (Vector3)(region.flow * region.strength * particleSpacing);
            return Vector3.ClampMagnitude(sum, ForceFields.MaxAcceleration);
        }

        // How strongly the strongest field pulls, m/s²: like gravity, it needs shorter steps where it is strong.
        float StrongestField
        {
            get
            {
                float strongest = 0f;
                if (partCount > 0)
                    foreach (FluidPart field in fields)
                        if (field != null)
                            strongest = Mathf.Max(strongest, ((IForceField)field).MaxAcceleration);
                return strongest;
            }
        }

        /// <summary>After the steps of a frame were executed: asks for the numbers of emitters and drains, and tells what the last ones
        /// say.</summary>
        void ReadSources(int steps)
        {
            if (partCount == 0)
                return;
            stepsSinceReadback += steps;
            if (stepsSinceReadback < ReadbackInterval)
                return;
            stepsSinceReadback = 0;
            foreach (FluidPart emitter in emitters)
                if (emitter != null)
                    ((IEmitter)emitter).ReportRefused();
            pbf.RequestSourceCounts();
        }

        void TeleportParts()
        {
            if (partCount == 0)
                return;
            foreach (FluidPart emitter in emitters)
                if (emitter != null)
                    emitter.Teleport();
            foreach (FluidPart drain in drains)
                if (drain != null)
                    drain.Teleport();
        }

        void RestartSources()
        {
            goneEmitters = goneDrains = 0;
            stepsSinceReadback = 0;
            foreach (FluidPart emitter in emitters)
                if (emitter != null)
                    emitter.OnRestart();
            foreach (FluidPart drain in drains)
                if (drain != null)
                    drain.OnRestart();
        }

        void ReleaseSources() => sources = null;
    }
}
