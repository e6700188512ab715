using NUnit.Framework;

namespace Rill.Tests
{
    public class OnceLogTests
    {
        const int First = 0, Last = 31;

        [Test]
        public void A_problem_is_logged_once_until_it_is_reset([Values(First, 7, Last)] int problem)
        {
            var log = new OnceLog();
            Assert.That((log.ShouldLog(problem), log.ShouldLog(problem)), Is.EqualTo((true, false)));
            log.Reset(problem);
            Assert.That((log.ShouldLog(problem), log.ShouldLog(problem)), Is.EqualTo((true, false)));
        }

        [Test]
        public void A_problem_that_passes_is_logged_when_it_comes_again([Values(First, Last)] int problem)
        {
            var log = new OnceLog();
            Assert.That(log.ShouldLog(problem, false), Is.False);
            Assert.That((log.ShouldLog(problem, true), log.ShouldLog(problem, true)), Is.EqualTo((true, false)));
            Assert.That(log.ShouldLog(problem, false), Is.False);
            Assert.That(log.ShouldLog(problem, true));
        }

        [Test]
        public void Problems_are_logged_independently()
        {
            var log = new OnceLog();
            for (int problem = First; problem <= Last; problem++)
                Assert.That(log.ShouldLog(problem), $"problem {problem}");
            log.Reset(5);
            for (int problem = First; problem <= Last; problem++)
                Assert.That(log.ShouldLog(problem), Is.EqualTo(problem == 5), $"problem {problem}");
            log.Reset();
            for (int problem = First; problem <= Last; problem++)
                Assert.That(log.ShouldLog(problem), $"problem {problem}");
        }
    }
}
