using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>
    /// Phases of several materials. All particles have the same volume, so a phase's density is the mass of its particles. Masses weigh the
    /// density constraint, the velocity smoothing and the viscosity, and the coarse grid solves for a pressure with 1/ρ at its faces.
    /// </summary>
    /// <remarks>
    /// Drops and bubbles smaller than a coarse cell would move with the cell's mean. A particle most of whose neighbors have other densities
    /// therefore gets more or less of the grid's displacement than they: as much as a sphere with added mass.
    /// </remarks>
    sealed class MaterialTable : Stage
    {
        /// <summary>Keyword, or define, of the kernels that weigh particles.</summary>
        public const string Keyword = "RILL_MATERIALS";

        // Ratios of densities up to which one and two V-cycles solve for the pressure; with fewer the lighter liquid sloshes for ever.
        const float RatioOfOneCycle = 20f, RatioOfTwoCycles = 100f;

        readonly GraphicsBuffer constants, slips;
        readonly PhaseConstants[] upload = new PhaseConstants[1];

        public MaterialTable(int capacity)
        {
            constants = Buffers.Constants<PhaseConstants>("Rill.Phases", "RillPhases");
            slips = Buffers.Structured<float>("Rill.Slips", capacity);
            BufferClear.Now(slips);
        }

        public static bool IsNeeded(in StepInput input) => input.phases.Differ(input.material);

        /// <summary>Returns how many V-cycles solve for the pressure of phases that differ in density.</summary>
        public static int CyclesFor(in StepInput input)
        {
            float ratio = input.phases.Ratio(input.material);
            return ratio <= RatioOfOneCycle ? 1 : ratio <= RatioOfTwoCycles ? 2 : 4;
        }

        public override bool Survives(ParticleChange change) => change == ParticleChange.Shifted;

        public override void ListState(List<StateBuffer> state) => state.Add(new StateBuffer(SnapshotSection.Slips, slips, StateExtent.Moved));

        /// <summary>Records the materials of this step.</summary>
        public void Upload(CommandBuffer cmd, in StepInput input, float spacing, bool deepWater)
        {
            upload[0] = PhaseConstants.For(input, spacing, deepWater);
            cmd.SetBufferData(constants, upload);
        }

        /// <summary>Records materials, slips and tags as what a kernel reads.</summary>
        public void Bind(in StepContext step, ComputeShader shader, int kernel)
        {
            Buffers.Bind(step.Commands, shader, kernel);
            step.Commands.SetComputeBufferParam(shader, kernel, ParticleTags.Ids.Tags, step.Tags);
        }

        /// <param name="stage">The stage, or null where none was made.</param>
        public static StageDescription Describe(MaterialTable stage, in StepInput input)
        {
            bool needed = IsNeeded(input);
            var description = new StageDescription("Materials", needed, needed
                ? Invariant($"densities of the phases differ by a factor of {input.phases.Ratio(input.material):0.###}, ") +
                Invariant($"{CyclesFor(input)} V-cycles") : "all phases have one material");
            if (needed && stage != null)
                stage.Buffers.Describe(description);
            return description;
        }
    }
}
