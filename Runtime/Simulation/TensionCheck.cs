using System;
using System.Collections.Generic;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Finds what keeps a fluid's surface tension from acting as asked, and logs it once.</summary>
    sealed class TensionCheck
    {
        const int Problems = 3;

        enum Problem { TooFewIterations, TooStrong, ReplacesOthers }

        readonly FluidSimulation fluid;
        StepInput input;
        bool isDeep;
        OnceLog log;

        public TensionCheck(FluidSimulation fluid) => this.fluid = fluid;

        /// <summary>Lets problems be logged again, as the fluid begins.</summary>
        public void Begin()
        {
            input = default;
            log.Reset();
        }

        /// <summary>Checks a step as it is recorded: with the substeps and iterations that are taken.</summary>
        public void Check(in StepInput step)
        {
            input = step;
            if (!step.phases.HaveTension(step.material))
                return;
            isDeep = fluid.Solver.IsDeep(step);
            for (int i = 0; i < Problems; i++)
                if (Has((Problem)i) && log.ShouldLog(i))
                    Debug.LogWarning($"Rill: FluidSimulation '{fluid.name}': {Text((Problem)i)}", fluid);
        }

        /// <summary>Adds the problems of the last step.</summary>
        public void List(List<string> problems)
        {
            for (int i = 0; i < Problems; i++)
                if (Has((Problem)i))
                    problems.Add(Text((Problem)i));
        }

        // Material of a phase as far as its tension goes.
        FluidMaterial MaterialOf(int phase)
        {
            FluidMaterial material = input.material;
            material.density = input.phases.Density(phase, input.material);
            material.surfaceTension = input.phases.Tension(phase, input.material);
            return material;
        }

        float Limit(in FluidMaterial material)
            => material.MaxSurfaceTension(fluid.Solver.Layout.Spacing, input.SubstepTime, input.settings.iterations, isDeep);

        // Phase whose tension is the most beyond its limit.
        int StrongestPhase()
        {
            int strongest = 0;
            float most = 0f;
            for (int phase = 0; phase <= input.phases.Last; phase++)
            {
                FluidMaterial material = MaterialOf(phase);
                float excess = material.surfaceTension / Mathf.Max(Limit(material), 1e-20f);
                if (excess <= most)
                    continue;
                (strongest, most) = (phase, excess);
            }
            return strongest;
        }

        bool Has(Problem problem)
        {
            if (!input.phases.HaveTension(input.material))
                return false;
            bool acts = input.settings.iterations >= SurfaceTension.MinIterations;
            switch (problem)
            {
                case Problem.TooFewIterations: return !acts;
                case Problem.TooStrong:
                    FluidMaterial strongest = MaterialOf(StrongestPhase());
                    return acts && strongest.surfaceTension > Limit(strongest);
                default: return acts && (input.material.artificialPressure > 0f || input.material.allowedTension > 0f);
            }
        }

        string Text(Problem problem)
        {
            int phase = StrongestPhase();
            FluidMaterial material = MaterialOf(phase);
            float tension = material.surfaceTension;
            FluidMaterialAsset asset = fluid.Phases[phase];
            string name = asset == null ? Invariant($"its surface tension of {tension:G4} N/m")
                : Invariant($"the surface tension of its material '{asset.name}', {tension:G4} N/m,");
            if (problem == Problem.TooFewIterations)
                return Invariant($"{name} does not act with {input.settings.iterations} iteration. Take ") +
                    Invariant($"{SurfaceTension.MinIterations} iterations or more, or set Surface Tension to 0.");
            if (problem == Problem.ReplacesOthers)
                return "its artificial pressure and allowed tension do not act beside its surface tension, which replaces them. Set both " +
                    "to 0, or Surface Tension to 0.";
            double limit = Limit(material);
            int substeps = SurfaceTension.Substeps(tension, limit, input.settings.substeps);
            string remedy = substeps <= SolverSettings.MaxSubsteps ? Invariant($"Take {substeps} substeps or a particle spacing of")
                : "Take a particle spacing of";
            string iterations = SurfaceTension.MaxStrength(input.settings.iterations + 1, isDeep)
                > SurfaceTension.MaxStrength(input.settings.iterations, isDeep) ? " or more iterations" : "";
            return Invariant($"{name} acts like {limit:G3} N/m: more is not stable at this spacing and ") +
                Invariant($"substep. {remedy} {fluid.ParticleSpacing * Math.Pow(tension / limit, 1.0 / 3.0):G3} m{iterations}, or lower it.");
        }
    }
}
