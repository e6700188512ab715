using System;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    // The budget: what is chosen instead of the solver's settings while it is on.
    public sealed partial class FluidSimulation
    {
        [Tooltip("GPU time that the fluid may take. When on, substeps, iterations and relaxation are chosen to fit it.")]
        [SerializeField] SolverBudget budget = SolverBudget.Default;

        BudgetedSolver budgeted;
        FrameGpuTime frameTime;
        [NonSerialized] SolverSettings effective;
        [NonSerialized] bool saidTooSmall, saidBounds;

        /// <summary>GPU time that the steps may take. Out-of-range values are clamped with a warning.</summary>
        public SolverBudget Budget
        {
            get => budget;
            set
            {
                saidTooSmall &= value.mode == budget.mode && value.FrameMilliseconds == budget.FrameMilliseconds;
                budget = value;
                Changed();
            }
        }

        /// <summary>What the budget chose, why, and the error that it costs.</summary>
        public BudgetState BudgetState => budgeted != null ? budgeted.State : default;

        /// <summary>Replaces the player's own source while the budget is on: for tests. Null is the player's own.</summary>
        internal IGpuTimeSource BudgetTime { get; set; }

        // Chooses the settings of a frame's steps.
        void BeginBudgetFrame(float seconds)
        {
            effective = solver;
            if (budget.mode == BudgetMode.Off)
            {
                ReleaseBudget();
                return;
            }
            if (budgeted == null)
            {
                frameTime = new FrameGpuTime();
                budgeted = new BudgetedSolver(BudgetTime ?? BestGpuTime.OfThisPlayer(frameTime));
            }
            frameTime.DeviceFactor = budget.deviceFactor;

            bool isMeasured = pbf.TryGetStatistics(input, out FluidStatistics statistics);
            GetPose(out _, out Quaternion rotation);
            var still = new StepInput { settings = solver, material = material, gravity = Quaternion.Inverse(rotation) * gravity };
            effective = budgeted.BeginFrame(seconds, budget, new BudgetScene
            {
                asked = solver,
                deepWater = pbf.IsDeep(still),
                elastic = Viscoelasticity.IsNeeded(still),
                gravityStep = GravityStep,
                particles = isMeasured ? statistics.particles : capacity,
                densityError = isMeasured ? statistics.densityError : float.NaN,
            });
            SayBudgetProblems();
        }

        void SayBudgetProblems()
        {
            BudgetState state = budgeted.State;
            if (state.reason == BudgetReason.MinStable && !saidTooSmall)
            {
                saidTooSmall = true;
                Debug.LogWarning(Invariant($"Rill: FluidSimulation '{name}': its budget of {state.targetMilliseconds:0.###} ms is less ") +
                    Invariant($"than the {state.milliseconds:0.###} ms that {state.substeps} substeps x {state.iterations} iterations ") +
                    "take; less than those is not stable or not within its bounds, so they stand. Raise the budget, widen its bounds or " +
                    "have fewer particles.", this);
            }
            if (budgeted.BoundsGaveWay && !saidBounds)
            {
                saidBounds = true;
                Debug.LogWarning($"Rill: FluidSimulation '{name}': the bounds of its budget leave no settings that are stable here; " +
                    Invariant($"using {state.substeps} substeps x {state.iterations} iterations. Widen the bounds."), this);
            }
        }

        void ReleaseBudget()
        {
            budgeted?.Dispose();
            budgeted = null;
            frameTime = null;
            saidTooSmall = saidBounds = false;
        }

        /// <summary>What the budget does, for <see cref="Describe"/>.</summary>
        StageDescription DescribeBudget() => budgeted != null
            ? new StageDescription("Budget", true, budgeted.State.ToString())
            : new StageDescription("Budget", false, "the budget is off");
    }
}
