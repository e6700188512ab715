using System.Linq;
using Host.Studies.Methods;
using NUnit.Framework;

namespace Host.Tests
{
    public class ParetoFrontTests
    {
        static double[] Run(params double[] costs) => costs;

        [Test]
        public void What_another_run_beats_in_one_cost_and_equals_in_the_others_is_not_on_the_front()
        {
            double[] cheap = Run(1, 5), exact = Run(5, 1), expensive = Run(6, 1), poor = Run(1, 6);
            Assert.That(ParetoFront.Of(new[] { cheap, exact, expensive, poor }, run => run), Is.EquivalentTo(new[] { cheap, exact }));
        }

        [Test]
        public void Differences_that_do_not_repeat_decide_nothing()
        {
            double[] one = Run(1, 1), other = Run(1.01, 0.97);
            Assert.That(ParetoFront.Of(new[] { one, other }, run => run), Has.Count.EqualTo(2));
            Assert.That(ParetoFront.Beats(Run(1.01, 0.9), one), "slower by less than repeats, better by more");
            Assert.That(ParetoFront.Beats(Run(1.03, 0.9), one), Is.False, "slower by more than repeats");
        }

        [TestCase(1.0, 1.0, 1.0, 0, true, "stands")]
        [TestCase(1.06, 1.0, 1.0, 0, true, "diverged")]
        [TestCase(double.NaN, 1.0, 1.0, 0, true, "diverged")]
        [TestCase(1.0, 1.0, 1.0, 1, true, "diverged")]
        [TestCase(1.0, 0.8, 1.0, 0, false, "collapsed")]
        [TestCase(1.0, double.NaN, 1.0, 0, false, "collapsed")]
        [TestCase(1.0, 1.0, 1.2, 0, true, "boiled")]
        [TestCase(1.0, 1.0, 1.2, 0, false, "stands")]
        public void A_run_stands_by_its_energy_its_volume_and_its_particles(double energy, double lowest, double settled, int nonFinite,
            bool still, string state) =>
            Assert.That(MethodRun.StateOf(energy, lowest, settled, nonFinite, still), Is.EqualTo(state));
    }
}
