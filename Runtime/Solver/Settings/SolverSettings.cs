using System;
using UnityEngine;

namespace Rill
{
    /// <summary>Effort of the solver in a step. Every value means the same at any particle spacing.</summary>
    [Serializable]
    public struct SolverSettings
    {
        /// <summary>Upper limit of over-relaxation in theory.</summary>
        const float RelaxationLimit = 2f;

        /// <summary>Less than that lets the coarse grid press particles together faster than the passes part them; see
        /// Research~/solver-study.md.</summary>
        const float MinDeepRelaxation = 0.3f;

        internal const int MaxSubsteps = 16;

        /// <summary>Maximum of |g| Δt² in a substep, d: beyond it neither the passes nor the coarse grid make up for what gravity presses
        /// together.</summary>
        const float MaxGravityStep = 0.6f;

        /// <summary>Maximum of |g| Δt² once more substeps are taken, d: as far as the coarse grid copes with cells that shallow water fills
        /// too.</summary>
        const float EasyGravityStep = 0.3f;

        /// <summary>Also solves for the pressure of deep water on a coarse grid. Without it 14 layers of particles stand 5 % too low, and 24
        /// collapse. Automatic is on above four layers.</summary>
        [Tooltip("Also solves for the pressure of deep water on a coarse grid. Without it 14 layers of particles stand 5 % too low, and 24 " +
            "collapse. Automatic is on above four layers.")]
        public DeepWater deepWater;

        /// <summary>Jacobi iterations of the density constraint a substep. 1 to 50.</summary>
        [Tooltip("Jacobi iterations of the density constraint a substep. 1 to 50.")]
        [Range(1, 50)] public int iterations;

        /// <summary>Relaxation ω: the fraction of each correction that is applied. 0 to 2; no more is used than stays stable with these
        /// iterations (0.3 with 1, or 0.8 in deep water, 1 with 2, 1.2 from 3, 1.3 from 8), and in deep water no less than 0.3. Above 0.8
        /// the fluid gets noisier.</summary>
        [Tooltip("Relaxation ω: the fraction of each correction that is applied. 0 to 2; no more is used than stays stable with these " +
            "iterations (0.3 with 1, or 0.8 in deep water, 1 with 2, 1.2 from 3, 1.3 from 8), and in deep water no less than 0.3. " +
            "Above 0.8 the fluid gets noisier.")]
        [Range(0f, RelaxationLimit)] public float relaxation;

        /// <summary>Substeps of a fixed step. 1 to 16. Besides its own iterations, one costs as much as four to eight more; for the density
        /// error those buy more. Impacts and turning water keep more energy with more substeps, and narrow vessels hold better. More are
        /// taken where gravity would carry a particle more than 0.6 spacings in one.</summary>
        [Tooltip("Substeps of a fixed step. 1 to 16. Besides its own iterations, one costs as much as four to eight more; for the density error " +
            "those buy more. Impacts and turning water keep more energy with more substeps, and narrow vessels hold better. More are taken where " +
            "gravity would carry a particle more than 0.6 spacings in one.")]
        [Range(1, MaxSubsteps)] public int substeps;

        /// <summary>Constraint force mixing ε, as a fraction of the constraint's denominator at rest. 1e-6 to 1; larger is softer.</summary>
        [Tooltip("Constraint force mixing ε, as a fraction of the constraint's denominator at rest. 1e-6 to 1; larger is softer.")]
        [Range(1e-6f, 1f)] public float softness;

        /// <summary>Radius of the neighbor list in support radii. 1 to 1.5; above 1 the list stays valid while particles move within a
        /// step.</summary>
        [Tooltip("Radius of the neighbor list in support radii. 1 to 1.5; above 1 the list stays valid while particles move within a step.")]
        [Range(1f, 1.5f)] public float listMargin;

        /// <summary>Neighbors that a particle's list holds. 16 to 256. About 30 at rest, over 64 in hard impacts; what does not fit is
        /// reported.</summary>
        [Tooltip("Neighbors that a particle's list holds. 16 to 256. About 30 at rest, over 64 in hard impacts; what does not fit is reported.")]
        [Range(16, 256)] public int neighborCapacity;

        /// <summary>Mean speed, m/s, below which a region of the water that has been so slow for half a second sleeps until something
        /// nearby moves. 0 (off) to 1. Sleeping water costs next to nothing, and flow that is slower stops.</summary>
        [Tooltip("Mean speed, m/s, below which a region of the water that has been so slow for half a second sleeps until something " +
            "nearby moves. 0 (off) to 1. Sleeping water costs next to nothing, and flow that is slower stops.")]
        [Range(0f, 1f)] public float sleepSpeed;

        /// <summary>Numerical damping of waves and turning water, as a fraction of that of a first-order time step. 0 to 1. Less keeps
        /// motion for longer, at the same number of substeps, so water takes longer to come to rest. Fluids with a shear modulus always
        /// have 1.</summary>
        [Tooltip("Numerical damping of waves and turning water, as a fraction of that of a first-order time step. 0 to 1. Less keeps " +
            "motion for longer, at the same number of substeps, so water takes longer to come to rest. Fluids with a shear modulus " +
            "always have 1.")]
        [Range(0f, 1f)] public float numericalDamping;

        /// <summary>The settings of a new fluid.</summary>
        public static SolverSettings Default => new SolverSettings
        {
            iterations = 4,
            relaxation = 0.8f,
            substeps = 1,
            softness = 1e-3f,
            listMargin = 1f,
            neighborCapacity = 64,
            numericalDamping = 1f,
        };

        /// <summary>
        /// Largest relaxation at which no scene of the stability study gained energy; see Documentation~/solver.md.
        /// </summary>
        /// <param name="iterations">Number of iterations of a substep.</param>
        /// <param name="deepWater">Whether the coarse grid carries the pressure of deep water: then one iteration stands more.</param>
        public static float MaxRelaxation(int iterations, bool deepWater = false)
        {
            if (iterations >= 8)
                return 1.3f;
            if (iterations >= 3)
                return 1.2f;
            if (iterations == 2)
                return 1f;
            return deepWater ? 0.8f : 0.3f;
        }

        /// <summary>The relaxation that a simulation uses: the one asked for, or the nearest stable one.</summary>
        /// <param name="deepWater">Whether the coarse grid carries the pressure of deep water: then at least 0.3.</param>
        public float StableRelaxation(bool deepWater)
        {
            float least = deepWater ? MinDeepRelaxation : 0f;
            return Math.Min(Math.Max(relaxation, least), MaxRelaxation(iterations, deepWater));
        }

        /// <summary>Substeps that a simulation takes: those asked for, or as many as it needs for gravity to stay small in one.</summary>
        /// <param name="gravityStep">How far gravity carries a particle in a step, |g| Δt², d.</param>
        public int StableSubsteps(float gravityStep) => Math.Max(substeps, MinSubsteps(gravityStep));

        /// <summary>Fewest substeps with which gravity stays small in one.</summary>
        /// <param name="gravityStep">How far gravity carries a particle in a step, |g| Δt², d.</param>
        public static int MinSubsteps(float gravityStep)
        {
            double needed = gravityStep > MaxGravityStep ? Math.Ceiling(Math.Sqrt(gravityStep / EasyGravityStep)) : 1.0;
            return (int)Math.Min(needed, MaxSubsteps);
        }

        /// <summary>Puts every value into its range.</summary>
        /// <param name="problem">What was wrong and what it became; null if nothing was.</param>
        /// <returns>Whether the settings were valid as they stood.</returns>
        public bool Validate(out string problem)
        {
            problem = null;
            Limit.Clamp("iterations", ref iterations, 1, 50, ref problem);
            Limit.Clamp("relaxation", ref relaxation, 0f, RelaxationLimit, Default.relaxation, ref problem);
            Limit.Clamp("substeps", ref substeps, 1, MaxSubsteps, ref problem);
            Limit.Clamp("softness", ref softness, 1e-6f, 1f, Default.softness, ref problem);
            Limit.Clamp("list margin", ref listMargin, 1f, 1.5f, Default.listMargin, ref problem);
            Limit.Clamp("neighbor capacity", ref neighborCapacity, 16, 256, ref problem);
            Limit.Clamp("sleep speed", ref sleepSpeed, 0f, 1f, Default.sleepSpeed, ref problem);
            Limit.Clamp("numerical damping", ref numericalDamping, 0f, 1f, Default.numericalDamping, ref problem);
            return problem == null;
        }
    }
}
