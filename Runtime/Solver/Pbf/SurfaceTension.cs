using System;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    /// <summary>
    /// Surface tension: particles attract each other in each pass of the density constraint, and walls attract them by the contact angle.
    /// See SurfaceTension.hlsl.
    /// </summary>
    /// <remarks>
    /// The pair force f(r) = r³ (1 − r/h)² has the tension π/8 ∫ f r⁴ dr of a sharp surface (Fowler 1937), so 3.58 of it are 1 in units of d. A
    /// free surface of particles is not sharp: drops oscillate as with 1.4 times that. What counts is Σ = σ Δt² / (ρ d³) alone.
    /// </remarks>
    static class SurfaceTension
    {
        /// <summary>Fewest iterations with which it acts: the density has to be corrected after it has pulled.</summary>
        public const int MinIterations = 2;

        /// <summary>Factor of f that makes the tension Σ, d.</summary>
        const double PairScale = 2.6;

        const float Gravity = 9.81f;        // m/s², of the texts
        const float SeenFrom = 0.25f;       // d: a capillary length below it shows nowhere

        /// <summary>Whether a step has any; it takes the place of the artificial pressure and of the allowed tension then, which are tensions
        /// without a unit.</summary>
        public static bool IsNeeded(in StepInput input) => input.settings.iterations >= MinIterations && input.phases.HaveTension(input.material);

        /// <summary>Largest stable Σ.</summary>
        public static double MaxStrength(int iterations, bool deepWater)
            => iterations < MinIterations ? 0.0 : iterations == MinIterations && !deepWater ? 0.02 : 0.05;

        /// <summary>Tension at which Σ is 1, N/m.</summary>
        public static double UnitTension(float density, float spacing, float substep)
            => density * Math.Pow(spacing, 3.0) / ((double)substep * substep);

        /// <summary>Σ of the phase with the largest surface tension, as it acts on particles of the heaviest phase.</summary>
        public static double Strength(in StepInput input, float spacing, bool deepWater)
        {
            double strongest = 0.0;
            for (int phase = 0; phase <= input.phases.Last; phase++)
                strongest = Math.Max(strongest, Strength(input, phase, spacing, deepWater));
            return strongest;
        }

        /// <summary>Σ of a phase, limited by its own density, as it acts on particles of the heaviest phase.</summary>
        public static double Strength(in StepInput input, int phase, float spacing, bool deepWater)
        {
            float density = input.phases.Density(phase, input.material);
            double own = input.phases.Tension(phase, input.material) / UnitTension(density, spacing, input.SubstepTime);
            return Math.Min(own, MaxStrength(input.settings.iterations, deepWater)) * (density / input.phases.Heaviest(input.material));
        }

        /// <summary>Σ by which two phases attract each other: (σ + σ' − σ'') / 2 with a tension σ'' between them (Girifalco and Good 1957), which is
        /// the difference of the two (Antonow 1907) unless their pair has another, and none where they mix.</summary>
        public static double Attraction(in StepInput input, int phase, int other, float spacing, bool deepWater)
        {
            double first = Strength(input, phase, spacing, deepWater), second = Strength(input, other, spacing, deepWater);
            double between = Math.Abs(first - second), asked = input.phases.InterfaceTension(phase, other);
            if (input.phases.Diffusion(phase, other) > 0f)
                between = 0.0;
            else if (asked > 0.0)
                between = Math.Min(asked / UnitTension(input.phases.Heaviest(input.material), spacing, input.SubstepTime), first + second);
            return 0.5 * (first + second - between);
        }

        /// <summary>Attraction of a wall over that of as much of the fluid itself.</summary>
        /// <remarks>(1 + cos θ) / 2 after Young and Dupré would hold for a sharp surface on a smooth wall. Here a layer of particles lies at its
        /// contact offset and slips little, so that the line where the surface ends is pinned. These fit the mean of what drops come to that
        /// begin as balls, half balls and flat. To wet takes more than the fluid's own attraction.</remarks>
        public static double WallFraction(float contactAngle)
        {
            double cosine = Math.Cos(contactAngle * Math.PI / 180.0);
            return cosine <= 0.0 ? 0.5 * Math.Sqrt(1.0 + cosine) : 0.5 + 1.5 * cosine;
        }

        /// <summary>Density error that it may press deep water together by; 0 without it.</summary>
        /// <remarks>What a pass leaves of what it presses together: 0.25 to 0.65 of this was measured.</remarks>
        public static double PressedError(in StepContext step) => IsNeeded(step.Input) ? PairAttraction(step) : 0.0;

        /// <summary>Records its constants as what a shader reads.</summary>
        public static void Bind(in StepContext step, ComputeShader shader)
        {
            double pair = PairAttraction(step);
            step.Commands.SetComputeFloatParam(shader, Ids.PairAttraction, (float)pair);
            step.Commands.SetComputeFloatParam(shader, Ids.WallAttraction, (float)(pair * WallFraction(step.Input.material.contactAngle)));
        }

        /// <summary>Returns what acts in a step.</summary>
        public static string Describe(in StepContext step)
        {
            StepInput input = step.Input;
            if (!input.phases.HaveTension(input.material))
                return "surface tension is 0";
            if (input.phases.Differ(input.material))
                return Invariant($"surface tension by phase, Σ up to {Strength(input, step.Layout.Spacing, step.Coarse != null):G2}");
            return "surface tension " + Text(input.material, input.settings, step.Layout.Spacing, input.SubstepTime, step.Coarse != null);
        }

        /// <summary>Returns what acts of a surface tension above 0, and what would make more of it act.</summary>
        /// <param name="substep">s.</param>
        public static string Text(in FluidMaterial material, in SolverSettings settings, float spacing, float substep, bool deepWater)
        {
            double asked = material.surfaceTension, unit = UnitTension(material.density, spacing, substep);
            double limit = MaxStrength(settings.iterations, deepWater) * unit, acts = Math.Min(asked, limit);
            if (limit <= 0.0)
                return Invariant($"{asked:G3} N/m does not act with fewer than {MinIterations} iterations");
            double length = Math.Sqrt(acts / (material.density * Gravity));
            string text = asked <= limit ? Invariant($"{asked:G3} N/m acts") : Invariant($"{asked:G3} N/m acts like {limit:G3} N/m");
            text += Invariant($" (Σ {acts / unit:G2} of at most {limit / unit:G2}) over {1000.0 * length:G2} mm, {length / spacing:G2} spacings");
            if (asked > limit)
                return text + Invariant($"; {Substeps(asked, limit, settings.substeps)} substeps would reach it");
            return length >= SeenFrom * spacing ? text
                : text + Invariant($": not seen at this spacing, where {0.2 * limit:G2} to {limit:G2} N/m look like small drops");
        }

        /// <summary>Substeps of a step with which a tension beyond the limit would act in full.</summary>
        public static int Substeps(double asked, double limit, int substeps) => (int)Math.Ceiling(substeps * Math.Sqrt(asked / limit) - 1e-6);

        // Displacement by a pair whose f is 1 in a pass, d.
        static double PairAttraction(in StepContext step)
        {
            StepInput input = step.Input;
            return PairScale * Strength(input, step.Layout.Spacing, step.Coarse != null) * VelocityExtrapolation.FractionAtOnce(input)
                / input.settings.iterations;
        }

        static class Ids
        {
            public static readonly int PairAttraction = Shader.PropertyToID("_PairAttraction");
            public static readonly int WallAttraction = Shader.PropertyToID("_WallAttraction");
        }
    }
}
