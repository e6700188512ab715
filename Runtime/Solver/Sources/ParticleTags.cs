using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    /// <summary>Phase and lifetime of each particle, which travel with it through every sort. Made when an emitter first gives one.</summary>
    sealed class ParticleTags : Stage
    {
        /// <summary>Largest phase of a particle.</summary>
        public const int MaxPhase = 7;

        /// <summary>Longest lifetime of a particle, s: its steps fit into a tag.</summary>
        public const float MaxLifetime = 86400f;

        /// <summary>bits of a tag that hold a step</summary>
        [GenerateHlsl("ParticleTags", Prefix = "Tag")] public const uint StepMask = 0x00FFFFFFu;

        /// <summary>above them, the phase</summary>
        [GenerateHlsl("ParticleTags", Prefix = "Tag")] public const int PhaseShift = 24;

        /// <summary>bits of a phase</summary>
        [GenerateHlsl("ParticleTags", Prefix = "Tag")] public const int PhaseBits = 3;

        /// <summary>Keyword of the kernels that write tags, and of the shader that draws them.</summary>
        public const string Keyword = "RILL_TAGS";

        GraphicsBuffer current, sorted;

        public ParticleTags(int capacity)
        {
            current = Buffers.Structured<uint>("Rill.TagsA", capacity, "_Tags");
            sorted = Buffers.Structured<uint>("Rill.TagsB", capacity, "_SortedTags");
            Clear();
        }

        /// <summary>uint [capacity], see ParticleTags.hlsl; those of the particles alive come first.</summary>
        public GraphicsBuffer Current => current;

        /// <summary>No particle has a phase, and all live for ever.</summary>
        public void Clear() => BufferClear.Now(current);

        public override void ListState(List<StateBuffer> state) => state.Add(new StateBuffer(SnapshotSection.Tags, current, StateExtent.Particles));

        public override bool Survives(ParticleChange change) => change == ParticleChange.Shifted;

        /// <summary>Records that the tags follow their particles through the sort that was just recorded.</summary>
        public void RecordSort(in StepContext step)
        {
            step.Search.RecordGather(step.Commands, step.Particles, current, sorted);
            Buffers.Swap(ref current, ref sorted);
        }

        /// <param name="tags">The tags, or null where none were made.</param>
        public static StageDescription Describe(ParticleTags tags, in StepContext step)
        {
            var description = new StageDescription("Particle tags", tags != null, tags != null
                ? "an emitter gives its particles a phase or a lifetime" : "no emitter gives its particles a phase or a lifetime");
            if (tags == null)
                return description;
            description.Kernel(step.Search.GatherTags, step.Substeps, step.Search.Variant(step));
            tags.Buffers.Describe(description);
            return description;
        }

        public static class Ids
        {
            public static readonly int Tags = Shader.PropertyToID("_Tags");
        }
    }
}
