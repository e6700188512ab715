using UnityEngine;
using UnityEngine.Rendering;
using static System.FormattableString;

namespace Rill
{
    /// <summary>Chooses the settings of a fluid's steps: its own, or those by which a budget fits them into its GPU time.</summary>
    sealed class FluidBudget
    {
        const int TooSmall = 0, BoundsGiveWay = 1;      // problems of the log

        readonly FluidSimulation fluid;
        BudgetedSolver budgeted;        // null while the budget is off
        FrameGpuTime frameGpuTime;
        OnceLog log;

        public FluidBudget(FluidSimulation fluid) => this.fluid = fluid;

        /// <summary>Replaces the player's own source of GPU time, for tests; null is the player's own.</summary>
        public IGpuTimeSource TimeSource { get; set; }

        /// <summary>The settings that the budget chose, the reason, and the error that they cost.</summary>
        public BudgetState State => budgeted != null ? budgeted.State : default;

        /// <summary>Lets a budget that is too small be logged again.</summary>
        public void LogAgain() => log.Reset(TooSmall);

        /// <summary>Chooses the settings of a frame's steps.</summary>
        /// <param name="seconds">Fluid time of the frame, s.</param>
        public SolverSettings BeginFrame(float seconds)
        {
            SolverSettings settings = fluid.Settings;
            SolverBudget budget = fluid.Budget;
            if (budget.mode == BudgetMode.Off)
            {
                Release();
                return settings;
            }
            if (budgeted == null)
            {
                frameGpuTime = new FrameGpuTime();
                budgeted = new BudgetedSolver(TimeSource ?? BestGpuTime.OfThisPlayer(frameGpuTime));
            }
            frameGpuTime.DeviceFactor = budget.deviceFactor;

            PbfSolver solver = fluid.Solver;
            bool isMeasured = solver.TryGetStatistics(fluid.Input, out FluidStatistics statistics);
            fluid.GetPose(out _, out Quaternion rotation);
            var still = new StepInput { settings = settings, material = fluid.Material, gravity = Quaternion.Inverse(rotation) * fluid.Gravity };
            SolverSettings chosen = budgeted.BeginFrame(seconds, budget, new BudgetScene
            {
                asked = settings,
                deepWater = solver.IsDeep(still),
                elastic = Viscoelasticity.IsNeeded(still),
                hasTension = fluid.Phases.ForStep().HaveTension(fluid.Material),
                gravityStep = fluid.Steps.GravityStep,
                particles = isMeasured ? statistics.particles : fluid.Capacity,
                densityError = isMeasured ? statistics.densityError : float.NaN,
            });
            LogProblems();
            return chosen;
        }

        public void BeginStep(CommandBuffer commands) => budgeted?.BeginStep(commands);

        public void EndStep(CommandBuffer commands) => budgeted?.EndStep(commands);

        public void EndFrame(int steps) => budgeted?.EndFrame(steps);

        public void Release()
        {
            budgeted?.Dispose();
            budgeted = null;
            frameGpuTime = null;
            log.Reset();
        }

        public StageDescription Describe() => budgeted != null
            ? new StageDescription("Budget", true, budgeted.State.ToString())
            : new StageDescription("Budget", false, "the budget is off");

        void LogProblems()
        {
            BudgetState state = budgeted.State;
            if (state.reason == BudgetReason.MinStable && log.ShouldLog(TooSmall))
                Debug.LogWarning(Invariant($"Rill: FluidSimulation '{fluid.name}': its budget of {state.targetMilliseconds:0.###} ms is less ") +
                    Invariant($"than the {state.milliseconds:0.###} ms that {state.substeps} substeps x {state.iterations} iterations ") +
                    "take; less than those is not stable or not within its bounds, so they stand. Raise the budget, widen its bounds or " +
                    "have fewer particles.", fluid);
            if (budgeted.BoundsGaveWay && log.ShouldLog(BoundsGiveWay))
                Debug.LogWarning($"Rill: FluidSimulation '{fluid.name}': the bounds of its budget leave no settings that are stable here; " +
                    Invariant($"using {state.substeps} substeps x {state.iterations} iterations. Widen the bounds."), fluid);
        }
    }
}
