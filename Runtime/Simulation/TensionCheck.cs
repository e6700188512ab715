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
            if (step.material.surfaceTension <= 0f)
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

        double Limit => input.material.MaxSurfaceTension(fluid.Solver.Layout.Spacing, input.SubstepTime, input.settings.iterations, isDeep);

        bool Has(Problem problem)
        {
            FluidMaterial material = input.material;
            if (material.surfaceTension <= 0f)
                return false;
            bool acts = input.settings.iterations >= SurfaceTension.MinIterations;
            switch (problem)
            {
                case Problem.TooFewIterations: return !acts;
                case Problem.TooStrong: return acts && material.surfaceTension > Limit;
                default: return acts && (material.artificialPressure > 0f || material.allowedTension > 0f);
            }
        }

        string Text(Problem problem)
        {
            float tension = input.material.surfaceTension;
            if (problem == Problem.TooFewIterations)
                return Invariant($"its surface tension of {tension:G4} N/m does not act with {input.settings.iterations} iteration. Take ") +
                    Invariant($"{SurfaceTension.MinIterations} iterations or more, or set Surface Tension to 0.");
            if (problem == Problem.ReplacesOthers)
                return "its artificial pressure and allowed tension do not act beside its surface tension, which replaces them. Set both " +
                    "to 0, or Surface Tension to 0.";
            double limit = Limit;
            int substeps = SurfaceTension.Substeps(tension, limit, input.settings.substeps);
            string remedy = substeps <= SolverSettings.MaxSubsteps ? Invariant($"Take {substeps} substeps or a particle spacing of")
                : "Take a particle spacing of";
            string iterations = SurfaceTension.MaxStrength(input.settings.iterations + 1, isDeep)
                > SurfaceTension.MaxStrength(input.settings.iterations, isDeep) ? " or more iterations" : "";
            return Invariant($"its surface tension of {tension:G4} N/m acts like {limit:G3} N/m: more is not stable at this spacing and ") +
                Invariant($"substep. {remedy} {fluid.ParticleSpacing * Math.Pow(tension / limit, 1.0 / 3.0):G3} m{iterations}, or lower it.");
        }
    }
}
