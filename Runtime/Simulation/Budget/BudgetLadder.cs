using System;

namespace Rill
{
    /// <summary>
    /// The settings that a budget climbs, from the cheapest that keeps a scene stable to the best: each costs more than the one
    /// before and leaves less density error. Measured figures and their commands: Research~/budget-study.md.
    /// </summary>
    sealed class BudgetLadder
    {
        // One iteration without the coarse grid is stable only at a relaxation that leaves a third of the volume; three are
        // noisier than two and than four.
        readonly BudgetRung[] plain =
        {
            new BudgetRung(1, 2, 0.8f, 1.16e-2f),
            new BudgetRung(1, 4, 0.8f, 4.7e-3f),
            new BudgetRung(1, 6, 0.8f, 2.6e-3f),
            new BudgetRung(1, 8, 0.8f, 1.6e-3f),
            new BudgetRung(1, 12, 0.8f, 8.1e-4f),
            new BudgetRung(1, 16, 0.8f, 4.7e-4f),
        };

        readonly BudgetRung[] deep =
        {
            new BudgetRung(1, 1, 0.8f, 5.0e-3f),
            new BudgetRung(1, 2, 0.8f, 3.1e-3f),
            new BudgetRung(1, 3, 0.8f, 2.2e-3f),
            new BudgetRung(1, 4, 0.8f, 1.7e-3f),
            new BudgetRung(1, 6, 0.8f, 1.1e-3f),
            new BudgetRung(1, 8, 0.8f, 8.0e-4f),
        };

        readonly BudgetRung[] rungs = new BudgetRung[16];
        SolverBudget bounds;
        int neededSubsteps;
        bool isDeep;

        public int Count { get; private set; }

        public BudgetRung this[int rung] => rungs[rung];

        /// <summary>Whether the fluid remembers its stretch, which costs as much with all rungs.</summary>
        public bool IsElastic { get; set; }

        /// <summary>Whether the bounds leave nothing that is stable, so that they are exceeded.</summary>
        public bool BoundsGaveWay { get; private set; }

        /// <summary>Chooses the rungs for a scene; allocates nothing.</summary>
        /// <param name="gravityStep">How far gravity carries a particle in a step, |g| Δt², d.</param>
        /// <returns>Whether they are others than before.</returns>
        public bool Build(bool deepWater, float gravityStep, in SolverBudget budget)
        {
            int substeps = SolverSettings.MinSubsteps(gravityStep);
            if (Count > 0 && deepWater == isDeep && substeps == neededSubsteps && HasBounds(budget))
                return false;
            isDeep = deepWater;
            neededSubsteps = substeps;
            bounds = budget;
            Count = 0;
            BudgetRung[] all = deepWater ? deep : plain;
            int least = Math.Max(substeps, budget.minSubsteps), most = Math.Max(substeps, budget.maxSubsteps);
            foreach (BudgetRung rung in all)
            {
                BudgetRung raised = rung.Substeps < least ? rung.WithSubsteps(least) : rung;
                if (raised.Substeps <= most && raised.Iterations >= budget.minIterations && raised.Iterations <= budget.maxIterations)
                    rungs[Count++] = raised;
            }
            BoundsGaveWay = Count == 0 || substeps > budget.maxSubsteps;
            if (Count == 0)
                rungs[Count++] = all[0].WithSubsteps(Math.Max(substeps, all[0].Substeps));
            return true;
        }

        /// <summary>Time of a step by the cost model, ms.</summary>
        public float Cost(int rung, float particles)
            => StepCost.Milliseconds(rungs[rung].Substeps, rungs[rung].Iterations, particles, isDeep, IsElastic);

        /// <summary>The best rung that costs no more than given settings do, or the least.</summary>
        public int Nearest(int substeps, int iterations, float particles)
        {
            float cost = StepCost.Milliseconds(substeps, iterations, particles, isDeep, IsElastic);
            int nearest = 0;
            for (int i = 1; i < Count; i++)
                if (Cost(i, particles) <= cost * 1.001f)
                    nearest = i;
            return nearest;
        }

        bool HasBounds(in SolverBudget budget) =>
            budget.minIterations == bounds.minIterations && budget.maxIterations == bounds.maxIterations
            && budget.minSubsteps == bounds.minSubsteps && budget.maxSubsteps == bounds.maxSubsteps;
    }
}
