using NUnit.Framework;

namespace Rill.Tests
{
    public class BudgetLadderTests
    {
        [Test]
        public void Every_rung_costs_more_than_the_one_before_leaves_less_error_and_is_stable([Values] bool deepWater,
            [Values(0.1f, 0.7f, 2f)] float fall, [Values(1e3f, 1e5f, 1e7f)] float particles)
        {
            BudgetLadder ladder = Ladder(deepWater, fall);
            Assert.That(ladder.Count, Is.GreaterThanOrEqualTo(4));
            Assert.That(ladder.BoundsGaveWay, Is.False);
            for (int i = 0; i < ladder.Count; i++)
            {
                Assert.That(ladder[i].Relaxation, Is.LessThanOrEqualTo(SolverSettings.MaxRelaxation(ladder[i].Iterations, deepWater)));
                Assert.That(ladder[i].Iterations, Is.GreaterThanOrEqualTo(deepWater ? 1 : 2));
                Assert.That(ladder[i].Substeps, Is.GreaterThanOrEqualTo(SolverSettings.MinSubsteps(fall)));
                if (i == 0)
                    continue;
                Assert.That(ladder.Cost(i, particles), Is.GreaterThan(ladder.Cost(i - 1, particles)));
                Assert.That(ladder[i].Error, Is.LessThan(ladder[i - 1].Error));
            }
        }

        [Test]
        public void Bounds_leave_the_rungs_within_them()
        {
            SolverBudget budget = SolverBudget.Default;
            budget.minIterations = 3;
            budget.maxIterations = 8;
            budget.minSubsteps = 2;
            var ladder = new BudgetLadder();
            ladder.Build(false, 0.1f, budget);
            for (int i = 0; i < ladder.Count; i++)
            {
                Assert.That(ladder[i].Iterations, Is.InRange(3, 8));
                Assert.That(ladder[i].Substeps, Is.EqualTo(2));
            }
        }

        [Test]
        public void Bounds_below_what_is_stable_give_way_to_it_and_say_so()
        {
            SolverBudget budget = SolverBudget.Default;
            budget.maxIterations = 1;
            var ladder = new BudgetLadder();
            ladder.Build(false, 0.1f, budget);
            Assert.That(ladder.BoundsGaveWay);
            Assert.That(ladder.Count, Is.EqualTo(1));
            Assert.That(ladder[0].Iterations, Is.EqualTo(2));

            budget = SolverBudget.Default;
            budget.maxSubsteps = 1;
            ladder.Build(true, 5f, budget);
            Assert.That(ladder.BoundsGaveWay);
            Assert.That(ladder[0].Substeps, Is.EqualTo(new SolverSettings { substeps = 1 }.StableSubsteps(5f)).And.GreaterThan(1));
            Assert.That(ladder.Count, Is.GreaterThan(1), "iterations are still chosen");
        }

        [Test]
        public void A_ladder_says_whether_it_became_another()
        {
            var ladder = new BudgetLadder();
            SolverBudget budget = SolverBudget.Default;
            Assert.That(ladder.Build(true, 0.3f, budget));
            Assert.That(ladder.Build(true, 0.31f, budget), Is.False);
            Assert.That(ladder.Build(true, 0.7f, budget));
            Assert.That(ladder.Build(false, 0.7f, budget));
            budget.maxIterations = 4;
            Assert.That(ladder.Build(false, 0.7f, budget));
            budget.milliseconds = 9f;
            Assert.That(ladder.Build(false, 0.7f, budget), Is.False);
        }

        [TestCase(1, 0, false)]
        [TestCase(2, 0, false)]
        [TestCase(4, 1, false)]
        [TestCase(5, 1, false)]
        [TestCase(50, 5, false)]
        [TestCase(2, 1, true)]
        [TestCase(7, 4, true)]
        public void The_nearest_rung_costs_no_more_than_the_settings_given(int iterations, int expected, bool deepWater)
        {
            Assert.That(Ladder(deepWater, 0.1f).Nearest(1, iterations, 1e5f), Is.EqualTo(expected));
        }

        // Research~/performance.md and solver-study.md: settled (elastic: moving), 1 substep, ms on an H200.
        [TestCase(1e6f, 1, true, false, 0.85f)]
        [TestCase(1e6f, 2, true, false, 1.03f)]
        [TestCase(1e6f, 4, true, false, 1.40f)]
        [TestCase(1e5f, 1, true, false, 0.22f)]
        [TestCase(1e5f, 2, true, false, 0.24f)]
        [TestCase(1e7f, 2, true, false, 8.3f)]
        [TestCase(1e5f, 4, false, false, 0.19f)]
        [TestCase(1e6f, 2, true, true, 1.43f)]
        [TestCase(1e5f, 2, true, true, 0.31f)]
        public void The_cost_model_is_within_fifteen_percent_of_what_was_measured(float particles, int iterations, bool deepWater,
            bool elastic, float measured)
        {
            Assert.That(StepCost.Milliseconds(1, iterations, particles, deepWater, elastic), Is.EqualTo(measured).Within(15).Percent);
        }

        static BudgetLadder Ladder(bool deepWater, float fall)
        {
            var ladder = new BudgetLadder();
            ladder.Build(deepWater, fall, SolverBudget.Default);
            return ladder;
        }
    }
}
