using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>
    /// Less damping by the time step: a velocity is not only that along the last path, u, which is the velocity half a substep ago, but
    /// u + β (ū − ū'), with the change of the mean velocity of the particle's neighborhood since the substep before. With β ½ it is the
    /// second-order backward difference (BDF2); with 0 the first-order step.
    /// </summary>
    /// <remarks>
    /// An acceleration a that lasts changes u by a Δt in a substep if (1 − β) a Δt of it acts at once: so gravity, force fields, viscosity
    /// and vorticity confinement are scaled, and the pressure that answers them comes out as 1 − β of theirs. Turning then loses q Ω² Δt of
    /// itself in a second and a wave q ω² Δt / 2, with q = (1 − 2 β) / (1 − β): the numerical damping of the settings.
    /// </remarks>
    sealed class VelocityExtrapolation : Stage
    {
        // Changes of velocity up to which they are extrapolated, times Δt: what is longer is an impact, which would bounce.
        const float MaxAtRest = 0.1f;       // d
        const float MaxFalling = 2f;        // of what gravity gives, or the strongest field

        GraphicsBuffer means, sorted;
        float lastTimeStep, lastWeight;

        public VelocityExtrapolation(int capacity)
        {
            means = Buffers.Structured<uint4>("Rill.Means", capacity);
            sorted = Buffers.Structured<uint4>("Rill.SortedMeans", capacity);
            BufferClear.Now(means);
        }

        public static bool IsNeeded(in StepInput input) => input.settings.numericalDamping < 1f && !Viscoelasticity.IsNeeded(input)
            && !GrainFriction.IsNeeded(input) && !Contacts.IsNeeded(input);

        /// <summary>β of a step; 0 where there is none.</summary>
        public static float WeightFor(in StepInput input)
        {
            float damping = input.settings.numericalDamping;
            return IsNeeded(input) ? (1f - damping) / (2f - damping) : 0f;
        }

        /// <summary>1 − β: the fraction of an acceleration that acts at once; the rest comes by the extrapolation if it lasts.</summary>
        public static float FractionAtOnce(in StepInput input) => 1f - WeightFor(input);

        /// <summary>Longest change of velocity in a substep that is extrapolated, d/s.</summary>
        public static float MaxChange(in StepInput input, float spacing)
        {
            float dt = input.SubstepTime;
            float strongest = math.length(input.gravity) / spacing;
            for (int i = 0; i < (input.sources?.fieldCount ?? 0); i++)
                strongest = math.max(strongest, math.abs(input.sources.fields[i].strength));
            return MaxAtRest / dt + MaxFalling * strongest * dt;
        }

        public override void ListState(List<StateBuffer> state) => state.Add(new StateBuffer(SnapshotSection.Means, means, StateExtent.Moved));

        /// <summary>State besides buffers that the next step depends on.</summary>
        public ExtrapolationRecord Record
        {
            get => new ExtrapolationRecord { lastTimeStep = lastTimeStep, lastWeight = lastWeight };
            set => (lastTimeStep, lastWeight) = (value.lastTimeStep, value.lastWeight);
        }

        /// <summary>Binds what a sort takes along.</summary>
        public void BindSort(CommandBuffer cmd, ComputeShader shader, int kernel) => Buffers.Bind(cmd, shader, kernel);

        public override bool Survives(ParticleChange change) => change == ParticleChange.Shifted;

        /// <summary>Binds what the velocity update of a substep reads and leaves.</summary>
        public void Bind(in StepContext step, ComputeShader shader, int kernel)
        {
            StepInput input = step.Input;
            float dt = input.SubstepTime, weight = WeightFor(input);
            float lastOverThis = lastTimeStep > 0f ? lastTimeStep / dt : 1f;
            float scale = lastTimeStep == dt && lastWeight == weight || lastTimeStep == 0f ? 1f : 1f / (lastWeight * lastOverThis + 1f - weight);
            Ids.Extrapolation.Bind(step.Commands, shader, kernel, scale, 1f / lastOverThis, sorted);
            Buffers.Swap(ref means, ref sorted);
            lastTimeStep = dt;
            lastWeight = weight;
        }

        /// <param name="stage">The stage, or null where none was made.</param>
        public static StageDescription Describe(VelocityExtrapolation stage, in StepContext step)
        {
            StepInput input = step.Input;
            bool needed = IsNeeded(input);
            var description = new StageDescription("Velocity extrapolation", needed, needed
                ? Invariant($"numerical damping {input.settings.numericalDamping} of a first-order ") +
                "step's" : Viscoelasticity.IsNeeded(input)
                ? "the fluid is elastic" : Contacts.IsNeeded(input) ? "contacts need the damping"
                : GrainFriction.IsNeeded(input) ? "grains need the damping" : "the numerical damping is 1");
            if (!needed || stage == null)
                return description;
            description.Kernel(step.Search.GatherMeans, step.Substeps, step.Search.Variant(step));
            stage.Buffers.Describe(description);
            return description;
        }

        static class Ids
        {
            public static readonly ShaderParameters Extrapolation = new ShaderParameters("_ChangeScale", "_LastChangeScale", "_Means");
        }
    }
}
