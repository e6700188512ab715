using System.Linq;
using NUnit.Framework;
using UnityEditor;

namespace Rill.Editor.Tests
{
    public class BudgetSummaryTests
    {
        static readonly BudgetState Spent = new BudgetState
        {
            reason = BudgetReason.TimeIsSpent, source = GpuTimeKind.Measured, targetMilliseconds = 2f, milliseconds = 1.75f, nextMilliseconds = 2.25f,
            substeps = 1, iterations = 4, relaxation = 0.8f, densityError = 0.0025f, deviceFactor = 1.5f,
        };

        [Test]
        public void A_budget_that_is_off_says_nothing()
        {
            Assert.That(BudgetSummary.Rows(default), Is.Empty);
            Assert.That(BudgetSummary.Messages(SolverBudget.Default, default, 0), Is.Empty);
        }

        [Test]
        public void Rows_name_the_choice_the_reason_the_time_its_source_and_the_error()
        {
            string[] rows = BudgetSummary.Rows(Spent).Select(row => $"{row.label}: {row.text}").ToArray();
            Assert.That(rows[0], Is.EqualTo("Budget chose: 1 substeps x 4 iterations, relaxation 0.8"));
            Assert.That(rows[1], Is.EqualTo("because: " + Spent.Why()));
            Assert.That(rows[2], Does.StartWith("GPU time: 1.75 of 2 ms").And.EndWith("measured around the steps"));
            Assert.That(rows[3], Does.Contain("0.25 %"));
            BudgetState unmeasured = Spent;
            unmeasured.densityError = float.NaN;
            Assert.That(BudgetSummary.Rows(unmeasured).Select(row => row.text), Has.Member("not measured"));
        }

        [Test]
        public void Help_boxes_carry_the_texts_of_validation()
        {
            SolverBudget budget = On();
            budget.milliseconds = -1f;
            SolverBudget checkedBudget = budget;
            checkedBudget.Validate(out string problem);
            Assert.That(BudgetSummary.Messages(budget, Spent, 10), Is.EqualTo(new[] { (MessageType.Warning, problem) }));
        }

        [TestCase(BudgetReason.MinStable, MessageType.Warning, "cannot be held")]
        [TestCase(BudgetReason.TimeUnknown, MessageType.Info, "Frame Timing Stats")]
        public void A_budget_that_cannot_be_held_or_told_says_what_to_do(BudgetReason reason, MessageType type, string text)
        {
            BudgetState state = Spent;
            state.reason = reason;
            (MessageType type, string text) message = BudgetSummary.Messages(On(), state, 10).Single();
            Assert.That(message.type, Is.EqualTo(type));
            Assert.That(message.text, Does.Contain(text));
        }

        [Test]
        public void A_target_error_without_statistics_is_warned_of()
        {
            Assert.That(BudgetSummary.Messages(On(), Spent, 0).Single().text, Does.Contain("statistics interval is 0"));
            SolverBudget budget = On();
            budget.targetError = 0f;
            Assert.That(BudgetSummary.Messages(budget, Spent, 0), Is.Empty);
        }

        static SolverBudget On()
        {
            SolverBudget budget = SolverBudget.Default;
            budget.mode = BudgetMode.Milliseconds;
            return budget;
        }
    }
}
