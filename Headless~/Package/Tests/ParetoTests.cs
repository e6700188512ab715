using System.Collections.Generic;
using System.Linq;
using Host.Report;
using NUnit.Framework;

namespace Host.Tests
{
    public class ParetoTests
    {
        static List<(double cost, double error)> Front(params (double cost, double error)[] all)
            => Pareto.Front(all, one => one.cost, one => one.error);

        [Test]
        public void The_front_is_what_none_beats_by_rising_cost()
        {
            Assert.That(Front((4, 1), (1, 9), (3, 3), (2, 4), (3.5, 3.5), (5, 2)), Is.EqualTo(new[] { (1d, 9d), (2d, 4d), (3d, 3d), (4d, 1d) }));
        }

        [Test]
        public void A_dominated_point_is_out()
        {
            Assert.That(Front((1, 1), (2, 2)), Is.EqualTo(new[] { (1d, 1d) }));
            Assert.That(Front((1, 1), (1, 2)), Is.EqualTo(new[] { (1d, 1d) }), "the same cost, more error");
            Assert.That(Front((1, 1), (2, 1)), Is.EqualTo(new[] { (1d, 1d) }), "the same error, more cost");
        }

        [Test]
        public void Equals_stay_together() => Assert.That(Front((1, 2), (3, 1), (1, 2)), Is.EqualTo(new[] { (1d, 2d), (1d, 2d), (3d, 1d) }));

        [Test]
        public void What_lacks_a_figure_is_never_part_of_it()
        {
            Assert.That(Front((double.NaN, 0), (0, double.NaN), (1, 1)), Is.EqualTo(new[] { (1d, 1d) }));
            Assert.That(Front(), Is.Empty);
        }

        [Test]
        public void It_is_what_comparing_all_pairs_leaves()
        {
            var random = new System.Random(5);
            var all = Enumerable.Range(0, 300).Select(_ => ((double)random.Next(40), (double)random.Next(40))).ToArray();
            var left = all.Where(a => !all.Any(b => b.Item1 <= a.Item1 && b.Item2 <= a.Item2 && (b.Item1 < a.Item1 || b.Item2 < a.Item2)))
                .OrderBy(a => a.Item1);
            Assert.That(Front(all), Is.EqualTo(left));
        }
    }
}
