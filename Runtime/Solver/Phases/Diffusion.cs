using System;
using System.Runtime.InteropServices;
using Unity.Mathematics;
using Unity.Profiling;
using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>How often particles of two phases exchange them in a substep.</summary>
    [GenerateHlsl("Diffusion", ConstantBuffer = "RillDiffusion")]
    [StructLayout(LayoutKind.Sequential)]
    struct DiffusionConstants
    {
        /// <summary>a row for each phase: exchanges of a particle among phases 0 to 3 alone</summary>
        public PhaseRows lowRates;

        /// <summary>the same with phases 4 to 7</summary>
        public PhaseRows highRates;
    }

    /// <summary>
    /// Diffusion of materials that mix: neighbors of two materials exchange them, so that each material is kept to the particle. Made when first
    /// needed. See Diffusion.compute.
    /// </summary>
    /// <remarks>
    /// All particles have the same volume, so a particle that takes the material of its neighbor is as good as one that moved there. A walk of
    /// steps r that come at a rate k has the diffusivity Σ k r² / 6 (Einstein 1905). The neighbors of a particle, n, fill a ball of the list
    /// radius R, where the mean of r² is 3/5 R². A pair exchanges them at k = 10 D / (R² n), with the mean of both for n: at a wall or a surface
    /// that makes good for those that are missing.
    /// </remarks>
    sealed class Diffusion : Stage
    {
        /// <summary>Largest D Δt, d²: a particle has one partner in a substep.</summary>
        public const double MaxStrength = 0.1;

        static readonly ProfilerMarker Marker = GpuMarker.Create("Rill.Diffusion");

        readonly ComputeShader shader = StageShader.LoadCompute("Diffusion");
        readonly Kernel choose, exchange;
        readonly StepKeywords keywords;
        readonly GraphicsBuffer constants;
        readonly DiffusionConstants[] upload = new DiffusionConstants[1];

        public Diffusion(int capacity)
        {
            choose = new Kernel(shader, "Choose");
            exchange = new Kernel(shader, "Exchange");
            keywords = new StepKeywords(shader, readsLists: true, skipsAsleep: true, weighs: true);
            constants = Buffers.Constants<DiffusionConstants>("Rill.Diffusion.Constants", "RillDiffusion");
            Buffers.Structured<uint2>("Rill.Diffusion.Choices", capacity);
        }

        public static bool IsNeeded(in StepInput input) => input.phases.MaxDiffusion > 0f;

        /// <summary>Largest diffusivity that acts in full, m²/s.</summary>
        /// <param name="spacing">m.</param>
        /// <param name="substep">s.</param>
        public static double Limit(float spacing, float substep) => MaxStrength * spacing * spacing / substep;

        public override bool Survives(ParticleChange change) => true;

        /// <summary>Records the materials of a step.</summary>
        public void Upload(CommandBuffer cmd, in StepInput input, SolverLayout layout)
        {
            double squares = layout.ListRadius * (double)layout.ListRadius, unit = layout.Spacing * (double)layout.Spacing / input.SubstepTime;
            var rates = new PhasePairs();
            for (int phase = 0; phase < PhaseMaterials.Phases; phase++)
                for (int other = 0; other < PhaseMaterials.Phases; other++)
                    rates[phase, other] = (float)(10.0 * Math.Min(input.phases.Diffusion(phase, other) / unit, MaxStrength) / squares);
            upload[0] = new DiffusionConstants { lowRates = rates.low, highRates = rates.high };
            cmd.SetBufferData(constants, upload);
        }

        /// <summary>Records the exchange of a substep, at its end.</summary>
        /// <param name="number">Number of the substep since the fluid began: each has random numbers of its own.</param>
        public void Record(in StepContext step, uint number)
        {
            CommandBuffer cmd = step.Commands;
            cmd.BeginSample(Marker);
            keywords.Record(step);
            step.BindConstants(shader);
            cmd.SetComputeIntParam(shader, Ids.ExchangeSeed, (int)number);
            step.BindLists(shader, choose);
            Dispatch(step, choose);
            step.Lists.Bind(cmd, shader, exchange);
            step.Materials?.Bind(step, shader, exchange);
            Dispatch(step, exchange);
            cmd.EndSample(Marker);
        }

        /// <param name="stage">The stage, or null where none was made.</param>
        public static StageDescription Describe(Diffusion stage, in StepContext step)
        {
            bool needed = IsNeeded(step.Input);
            var description = new StageDescription("Diffusion", needed, needed
                ? Text(step.Input.phases.MaxDiffusion, step.Layout.Spacing, step.SubstepTime, step.Substeps) : "no materials mix");
            if (needed && stage != null)
            {
                description.Kernel(stage.choose, step.Substeps, stage.keywords.Variant(step));
                description.Kernel(stage.exchange, step.Substeps, stage.keywords.Variant(step));
                stage.Buffers.Describe(description);
            }
            return description;
        }

        /// <summary>Returns what acts of a diffusivity, and what would make more of it act.</summary>
        /// <param name="asked">m²/s.</param>
        /// <param name="spacing">m.</param>
        /// <param name="substep">s.</param>
        public static string Text(float asked, float spacing, float substep, int substeps)
        {
            double limit = Limit(spacing, substep);
            return asked <= limit ? Invariant($"{asked:G3} m²/s acts (of at most {limit:G3})")
                : Invariant($"{asked:G3} m²/s acts like {limit:G3} m²/s; {Math.Ceiling(substeps * asked / limit - 1e-6)} substeps would reach it");
        }

        void Dispatch(in StepContext step, Kernel kernel)
        {
            Buffers.Bind(step.Commands, shader, kernel);
            step.Particles.Bind(step.Commands, shader, kernel);
            step.Commands.SetComputeBufferParam(shader, kernel, ParticleTags.Ids.Tags, step.Tags);
            step.Particles.DispatchSorted(step.Commands, shader, kernel);
        }

        static class Ids
        {
            public static readonly int ExchangeSeed = Shader.PropertyToID("_ExchangeSeed");
        }
    }
}
