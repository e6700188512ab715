using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    // Sources, drains and force fields, which come and go while the fluid runs.
    partial class PbfSolver
    {
        bool hasLifetimes;

        /// <summary>uint [capacity], see ParticleTags.hlsl; null while no emitter gives its particles a phase or a lifetime.</summary>
        public GraphicsBuffer Tags => ParticleTags?.Current;

        /// <summary>Results of the emitters; null without emitters.</summary>
        public EmitterStates EmitterStates => Emitters?.States;

        /// <summary>Particles that a drain has removed, as far as it has come back.</summary>
        public int DrainedBy(int number) => Drains?.Drained(number) ?? 0;

        /// <summary>Starts the readback of what emitters and drains have done.</summary>
        public void RequestSourceCounts()
        {
            Emitters?.States.Request();
            Drains?.Request();
        }

        /// <summary>Waits for what <see cref="RequestSourceCounts"/> asked for, and for nothing else.</summary>
        public void CompleteSourceCounts()
        {
            Emitters?.States.Complete();
            Drains?.Complete();
        }

        ParticleTags TagsWithLifetimes => hasLifetimes ? ParticleTags : null;

        // Makes what the sources of this step need and gives back what they no longer do.
        void PrepareSources(in StepInput input)
        {
            StepSources sources = input.sources;
            PreparePhases(input);
            if (sources != null && sources.needsTags)
                NeedTags();
            hasLifetimes |= sources != null && sources.needsLifetimes;
            if (Emitters.IsNeeded(sources))
                NeedEmitters();
            else if (sources == null || !sources.keepsEmitters)
                Release(Features.Emitters);
            if (Drains.IsNeeded(sources, TagsWithLifetimes))
                NeedDrains();
            else if (sources == null || !sources.keepsDrains)
                Release(Features.Drains);
            Drains?.Remove(sources?.goneDrains ?? 0);
            for (int e = 0; e < (sources?.emitterCount ?? 0); e++)
            {
                maxParticles += sources.emitters[e].due;
                if (sources.emitters[e].due > 0 || sources.recycles)
                    ReachDown(sources.emitters[e], input.gravity);
            }
        }

        void RecordDrains(in StepContext step)
        {
            StepSources sources = step.Input.sources;
            Drains?.RecordForgotten(step.Commands);
            if (Drains.IsNeeded(sources, TagsWithLifetimes))
                Drains.Record(step, lastSubsteps, sources != null && sources.recycles ? Emitters.States : null, TagsWithLifetimes);
        }

        void RecordEmission(in StepContext step, int substep)
        {
            if (Emitters.IsNeeded(step.Input.sources))
                Emitters.Record(step, substep, stepIndex, ParticleTags);
        }

        // How deep the water gets is as far as an emitter lies above where gravity takes what it lets in.
        void ReachDown(in EmitterStep emitter, float3 gravity)
        {
            float3 down = math.normalizesafe(gravity) * math.length(Layout.DomainSize);
            float3 reach = emitter.HoldsLevel ? emitter.positions.HalfExtent : emitter.positions.Radius;
            float3 low = math.min(emitter.start.position, emitter.end.position) - reach,
                high = math.max(emitter.start.position, emitter.end.position) + reach;
            minAdded = math.min(minAdded, math.clamp(math.min(low, low + down), 0f, Layout.DomainSize));
            maxAdded = math.max(maxAdded, math.clamp(math.max(high, high + down), 0f, Layout.DomainSize));
        }

        void NeedEmitters()
        {
            if (Emitters == null)
                Keep(Features.Emitters, new Emitters(Limits, ReadbackErrors));
        }

        void NeedDrains()
        {
            if (Drains == null)
                Keep(Features.Drains, new Drains(ReadbackErrors));
        }

        void NeedTags()
        {
            if (ParticleTags == null)
                Keep(Features.Tags, new ParticleTags(Layout.Capacity));
        }

        void ReleaseTags()
        {
            Release(Features.Tags);
            hasLifetimes = false;
        }
    }
}
