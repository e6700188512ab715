using System.Linq;
using NUnit.Framework;
using static System.FormattableString;

namespace Rill.Tests
{
    public class BudgetSettingsTests
    {
        [Test]
        public void The_default_is_valid_and_off()
        {
            SolverBudget budget = SolverBudget.Default;
            Assert.That(budget.Validate(out string problem), Is.True, problem);
            Assert.That(budget.mode, Is.EqualTo(BudgetMode.Off));
        }

        [TestCase(float.NaN)]
        [TestCase(float.PositiveInfinity)]
        [TestCase(-1f)]
        public void Values_out_of_range_become_valid_and_are_named(float bad)
        {
            var budget = new SolverBudget
            {
                milliseconds = bad, fraction = bad, frameRate = bad, targetError = bad, deviceFactor = bad,
                maxIterations = 99, maxSubsteps = 99
            };
            Assert.That(budget.Validate(out string problem), Is.False);
            foreach (string name in new[] { "milliseconds", "fraction", "frame rate", "target error", "device factor" })
                Assert.That(problem, Does.Contain(Invariant($"budget {name} {bad} is outside")));
            Assert.That(problem, Does.Contain("budget most iterations 99 is outside 1 to 50; using 50."));
            Assert.That(budget.Validate(out problem), Is.True, problem);
        }

        [Test]
        public void Most_is_never_less_than_least()
        {
            SolverBudget budget = SolverBudget.Default;
            budget.minIterations = 20;
            Assert.That(budget.Validate(out string problem), Is.False);
            Assert.That(problem, Is.EqualTo("budget most iterations 16 is outside 20 to 50; using 20."));
        }

        [Test]
        public void A_share_is_of_the_frame_that_is_aimed_for()
        {
            SolverBudget budget = SolverBudget.Default;
            budget.milliseconds = 3f;
            budget.fraction = 0.1f;
            budget.frameRate = 50f;
            budget.mode = BudgetMode.Milliseconds;
            Assert.That(budget.FrameMilliseconds, Is.EqualTo(3f));
            budget.mode = BudgetMode.FrameFraction;
            Assert.That(budget.FrameMilliseconds, Is.EqualTo(2f).Within(1e-5f));
        }

        [Test]
        public void Every_reason_says_why()
        {
            string[] whys = ((BudgetReason[])System.Enum.GetValues(typeof(BudgetReason)))
                .Select(reason => new BudgetState { reason = reason, nextMilliseconds = 1.5f }.Why()).ToArray();
            Assert.That(whys, Is.Unique);
            Assert.That(whys, Is.All.Not.Empty);
        }
    }
}
