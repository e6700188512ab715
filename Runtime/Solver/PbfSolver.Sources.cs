using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    // What comes and goes while the fluid runs: each stage is made when first needed.
    partial class PbfSolver
    {
        Emitters emitters;
        Drains drains;
        ForceFields forceFields;
        ParticleTags tags;
        bool hasLifetimes;

        /// <summary>uint [capacity], see ParticleTags.hlsl; null while no emitter gives its particles a phase or a lifetime.</summary>
        public GraphicsBuffer Tags => tags?.Current;

        /// <summary>What the emitters have done; null while there are none.</summary>
        public EmitterStates EmitterStates => emitters?.States;

        /// <summary>Particles that a drain has removed, as far as it has come back.</summary>
        public int DrainedBy(int number) => drains?.Drained(number) ?? 0;

        /// <summary>Starts the readback of what emitters and drains have done.</summary>
        public void RequestSourceCounts()
        {
            emitters?.States.Request();
            drains?.Request();
        }

        /// <summary>Waits for what <see cref="RequestSourceCounts"/> asked for, and for nothing else.</summary>
        public void CompleteSourceCounts()
        {
            emitters?.States.Complete();
            drains?.Complete();
        }

        ParticleTags TagsWithLifetimes => hasLifetimes ? tags : null;

        // Makes what the sources of this step need and gives back what they no longer do.
        void PrepareSources(in StepInput input)
        {
            StepSources sources = input.sources;
            PreparePhases(input);
            if (sources != null && sources.needsTags)
                tags ??= new ParticleTags(Layout.Capacity);
            hasLifetimes |= sources != null && sources.needsLifetimes;
            if (Emitters.IsNeeded(sources))
                emitters ??= new Emitters(limits, ReadbackErrors);
            else if (emitters != null && (sources == null || !sources.keepsEmitters))
                ReleaseEmitters();
            if (Drains.IsNeeded(sources, TagsWithLifetimes))
                drains ??= new Drains(ReadbackErrors);
            else if (drains != null && (sources == null || !sources.keepsDrains))
                ReleaseDrains();
            drains?.Remove(sources?.goneDrains ?? 0);
            if (ForceFields.IsNeeded(sources))
                forceFields ??= new ForceFields();
            else if (forceFields != null)
            {
                restingRegions?.Wake();
                ReleaseFields();
            }
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
            drains?.RecordForgotten(step.Commands);
            if (Drains.IsNeeded(sources, TagsWithLifetimes))
                drains.Record(step, lastSubsteps, sources != null && sources.recycles ? emitters.States : null, TagsWithLifetimes);
        }

        // Fields that change or come wake what rests, as those that go do.
        ForceFields FieldsFor(CommandBuffer cmd, in StepInput input)
        {
            if (!ForceFields.IsNeeded(input.sources))
                return null;
            if (forceFields.Upload(cmd, input.sources))
                restingRegions?.Wake();
            return forceFields;
        }

        void RecordEmission(in StepContext step, int substep)
        {
            if (Emitters.IsNeeded(step.Input.sources))
                emitters.Record(step, substep, stepIndex, tags);
        }

        // How deep the water gets is as far as an emitter lies above where gravity takes what it lets in.
        void ReachDown(in EmitterStep emitter, float3 gravity)
        {
            float3 down = math.normalizesafe(gravity) * math.length(Layout.DomainSize);
            float3 low = math.min(emitter.start.position, emitter.end.position) - emitter.positions.Radius,
                high = math.max(emitter.start.position, emitter.end.position) + emitter.positions.Radius;
            minAdded = math.min(minAdded, math.clamp(math.min(low, low + down), 0f, Layout.DomainSize));
            maxAdded = math.max(maxAdded, math.clamp(math.max(high, high + down), 0f, Layout.DomainSize));
        }

        void ClearSources()
        {
            emitters?.States.Clear();
            drains?.Clear();
            ReleaseTags();
        }

        void ReleaseSources()
        {
            ReleaseEmitters();
            ReleaseDrains();
            ReleaseFields();
            ReleaseTags();
        }

        void ReleaseEmitters()
        {
            emitters?.Dispose();
            emitters = null;
        }

        void ReleaseDrains()
        {
            drains?.Dispose();
            drains = null;
        }

        void ReleaseFields()
        {
            forceFields?.Dispose();
            forceFields = null;
        }

        void ReleaseTags()
        {
            tags?.Dispose();
            tags = null;
            hasLifetimes = false;
        }
    }
}
