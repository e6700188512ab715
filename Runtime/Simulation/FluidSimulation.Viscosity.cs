using System;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    // A dynamic viscosity beyond what its passes reach.
    public sealed partial class FluidSimulation
    {
        [NonSerialized] bool isTooViscous, saidTooViscous;

        // Of the input as it is recorded: with the substeps that are taken.
        void CheckViscosity()
        {
            isTooViscous = ImplicitViscosity.IsNeeded(input) && ImplicitViscosity.Strength(input, pbf.Layout) > ImplicitViscosity.MaxStrength;
            if (!isTooViscous || saidTooViscous)
                return;
            saidTooViscous = true;
            Debug.LogWarning($"Rill: FluidSimulation '{name}': {TooViscousProblem}", this);
        }

        string TooViscousProblem
        {
            get
            {
                double strength = ImplicitViscosity.Strength(input, pbf.Layout), beyond = strength / ImplicitViscosity.MaxStrength;
                double substeps = Math.Ceiling(input.settings.substeps * beyond);
                string remedy = substeps <= SolverSettings.MaxSubsteps ? Invariant($"Take {substeps} substeps or a particle spacing of")
                    : "Take a particle spacing of";
                return Invariant($"its dynamic viscosity of {material.dynamicViscosity:G4} Pa s is more than ") +
                    Invariant($"{ImplicitViscosity.MaxPasses} passes solve: at this spacing and substep that is ") +
                    Invariant($"{material.dynamicViscosity / beyond:G3} Pa s. Flow over many particles is braked less: up to ") +
                    Invariant($"{100.0 * ImplicitViscosity.ErrorLeft(strength):G2} % of what should end in a substep goes on. {remedy} ") +
                    Invariant($"{particleSpacing * Math.Sqrt(beyond):G3} m, or lower the viscosity.");
            }
        }
    }
}
