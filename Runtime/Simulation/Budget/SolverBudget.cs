using System;
using UnityEngine;

namespace Rill
{
    /// <summary>
    /// GPU time that a fluid's steps may take. Substeps, iterations and relaxation are then chosen, along a measured ladder,
    /// instead of those of <see cref="SolverSettings"/>.
    /// </summary>
    [Serializable]
    public struct SolverBudget
    {
        const float MillisecondsOfSecond = 1000f;

        /// <summary>Off: the solver's settings hold. Otherwise substeps, iterations and relaxation are chosen to fit the time.</summary>
        [Tooltip("Off: the solver's settings hold. Otherwise substeps, iterations and relaxation are chosen to fit the time.")]
        public BudgetMode mode;

        /// <summary>GPU time that the steps of a frame may take, ms. 0.01 to 1000. Drawing and statistics come on top.</summary>
        [Tooltip("GPU time that the steps of a frame may take, ms. 0.01 to 1000. Drawing and statistics come on top.")]
        [Range(0.01f, 1000f)] public float milliseconds;

        /// <summary>Fraction of the frame that the steps may take. 0.01 to 1.</summary>
        [Tooltip("Fraction of the frame that the steps may take. 0.01 to 1.")]
        [Range(0.01f, 1f)] public float fraction;

        /// <summary>Frames a second that the game aims for, which the fraction is of. 10 to 500.</summary>
        [Tooltip("Frames a second that the game aims for, which the fraction is of. 10 to 500.")]
        [Range(10f, 500f)] public float frameRate;

        /// <summary>Mean density error C+ that is good enough. 0 (none is) to 0.1. Below it no more is spent. Needs statistics.</summary>
        [Tooltip("Mean density error C+ that is good enough. 0 (none is) to 0.1. Below it no more is spent. Needs statistics.")]
        [Range(0f, 0.1f)] public float targetError;

        /// <summary>Fewest iterations of a substep. 1 to 50.</summary>
        [Tooltip("Fewest iterations of a substep. 1 to 50.")]
        [Range(1, 50)] public int minIterations;

        /// <summary>Most iterations of a substep, at least the fewest. 1 to 50.</summary>
        [Tooltip("Most iterations of a substep, at least the fewest. 1 to 50.")]
        [Range(1, 50)] public int maxIterations;

        /// <summary>Fewest substeps. 1 to 16.</summary>
        [Tooltip("Fewest substeps. 1 to 16.")]
        [Range(1, 16)] public int minSubsteps;

        /// <summary>Most substeps, at least the fewest. 1 to 16.</summary>
        [Tooltip("Most substeps, at least the fewest. 1 to 16.")]
        [Range(1, 16)] public int maxSubsteps;

        /// <summary>Time of a step on the player's GPU over that on the GPU of the cost model. 0 (unknown) to 10000. Used where steps
        /// cannot be timed; the inspector shows it where they can.</summary>
        [Tooltip("Time of a step on the player's GPU over that on the GPU of the cost model. 0 (unknown) to 10000. Used where steps " +
            "cannot be timed; the inspector shows it where they can.")]
        [Min(0f)] public float deviceFactor;

        /// <summary>No budget, with the values that one begins with when it is turned on.</summary>
        public static SolverBudget Default => new SolverBudget
        {
            mode = BudgetMode.Off,
            milliseconds = 2f,
            fraction = 0.15f,
            frameRate = 60f,
            targetError = 0.005f,
            minIterations = 1,
            maxIterations = 16,
            minSubsteps = 1,
            maxSubsteps = 4,
        };

        /// <summary>Time in a frame, ms.</summary>
        public float FrameMilliseconds => mode == BudgetMode.FrameFraction ? fraction * MillisecondsOfSecond / frameRate : milliseconds;

        /// <summary>Puts every value into its range.</summary>
        /// <param name="problem">What was wrong and what it became; null if nothing was.</param>
        /// <returns>Whether the budget was valid as it stood.</returns>
        public bool Validate(out string problem)
        {
            problem = null;
            Limit.Clamp("budget milliseconds", ref milliseconds, 0.01f, 1000f, Default.milliseconds, ref problem);
            Limit.Clamp("budget fraction", ref fraction, 0.01f, 1f, Default.fraction, ref problem);
            Limit.Clamp("budget frame rate", ref frameRate, 10f, 500f, Default.frameRate, ref problem);
            Limit.Clamp("budget target error", ref targetError, 0f, 0.1f, Default.targetError, ref problem);
            Limit.Clamp("budget least iterations", ref minIterations, 1, 50, ref problem);
            Limit.Clamp("budget most iterations", ref maxIterations, minIterations, 50, ref problem);
            Limit.Clamp("budget least substeps", ref minSubsteps, 1, 16, ref problem);
            Limit.Clamp("budget most substeps", ref maxSubsteps, minSubsteps, 16, ref problem);
            Limit.Clamp("budget device factor", ref deviceFactor, 0f, 10000f, 0f, ref problem);
            return problem == null;
        }
    }
}
