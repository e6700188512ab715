using System;
using System.Collections.Generic;
using System.Linq;
using Host;
using Host.Report;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>Tests the judgement of the solver against experiment and theory, on data whose answer is known.</summary>
    public class TheoryDetectorTests
    {
        static List<FrontSeries> Experiments() => FrontSeries.Experiments(Session.Root());

        static FrontSeries Scaled(double factor, double until = 3)
        {
            List<FrontSeries> experiments = Experiments();
            return new FrontSeries("planted", Enumerable.Range(0, 200).Select(i => 0.849 + 0.01 * i).Where(time => time <= until)
                .Select(time => (time, factor * experiments.Average(series => series.At(time)))));
        }

        [TestCase(0.02, 0.02, TestName = "A_piston_in_shallow_water_makes_waves_of_kh_times_its_stroke")]
        [TestCase(12.0, 2.0, TestName = "A_piston_in_deep_water_makes_waves_of_twice_its_stroke")]
        [TestCase(1.0, 0.9817, TestName = "A_piston_in_water_of_kh_1_makes_waves_almost_as_high_as_its_stroke")]
        public void The_wavemaker_theory_has_its_limits(double kh, double heightOverStroke)
        {
            Assert.That(Wavemaker.HeightOverStroke(kh), Is.EqualTo(heightOverStroke).Within(1e-3 * heightOverStroke));
        }

        [Test]
        public void A_tube_swings_with_the_inertia_of_its_water_less_what_the_flow_cuts_at_the_bends()
        {
            Assert.That(UTube.MiddleLine(12, 24, 48), Is.EqualTo(2 * 42 + 36));
            Assert.That(UTube.StraightLength(12, 24, 48), Is.EqualTo(120 - 24 * 2 * Math.Log(2) / Math.PI).Within(1e-9));
            Assert.That(UTube.Period(2 * FluidRun.Gravity), Is.EqualTo(2 * Math.PI).Within(1e-9));
        }

        // The drop of the potential along two channels at a right angle, each with two squares before the corner's, at a flux of 1.
        [Test]
        public void The_square_of_a_bend_has_the_inertia_that_the_tube_counts()
        {
            const int across = 16, squares = 2, side = (squares + 1) * across;
            var potential = new double[side, side];
            bool Inside(int x, int y) => x >= 0 && y >= 0 && x < side && y < side && (x < across || y < across);
            for (int sweep = 0; sweep < 700; sweep++)
                for (int x = 0; x < side; x++)
                    for (int y = 0; y < side; y++)
                    {
                        if (!Inside(x, y))
                            continue;
                        double sum = 0, weight = 0;
                        foreach ((int dx, int dy) in new[] { (1, 0), (-1, 0), (0, 1), (0, -1) })
                            if (Inside(x + dx, y + dy))
                                (sum, weight) = (sum + potential[x + dx, y + dy], weight + 1);
                        // The ends, half a cell away: 1 along x, 0 along y.
                        if (x == side - 1)
                            (sum, weight) = (sum + 2, weight + 2);
                        if (y == side - 1)
                            weight += 2;
                        potential[x, y] += 1.9 * (sum / weight - potential[x, y]);
                    }
            double flux = Enumerable.Range(0, across).Sum(y => 2 * (1 - potential[side - 1, y]));
            Assert.That(1 / flux - 2 * squares, Is.EqualTo(UTube.CornerFraction).Within(0.01));
        }

        static List<(double, double)> Swing(double stretch, double ripple) => Enumerable.Range(0, 300).Select(i => i / 60.0)
            .Select(t => (t, 1 - Math.Exp(-0.3 * t) * Math.Cos(2.5 * t / stretch) + ripple * Math.Sin(40 * t))).ToList();

        // Extremes of e^(-a t) cos(w t): where tan(w t) = -a/w.
        [TestCase(0)]
        [TestCase(0.01)]
        public void Turning_points_are_found_between_the_samples_and_ripples_are_none(double ripple)
        {
            List<double> turns = TurningPoints.Of(Swing(1, ripple), 0.03, 0.15);
            Assert.That(turns.Count, Is.EqualTo(3), "neither the start nor the end nor a ripple");
            for (int i = 0; i < turns.Count; i++)
                Assert.That(turns[i], Is.EqualTo(((i + 1) * Math.PI - Math.Atan(0.3 / 2.5)) / 2.5).Within(ripple > 0 ? 0.03 : 2e-3),
                    "a parabola leaves out the cubic part");
            Assert.That(TurningPoints.Of(Swing(1, 0.05), 0.01, 0.15).Count, Is.GreaterThan(3), "ripples above what is left out are turns");
        }

        [Test]
        public void What_goes_one_way_never_turns()
        {
            Assert.That(TurningPoints.Of(Enumerable.Range(0, 50).Select(i => (i / 60.0, i * 0.1)).ToList(), 0.03, 0.15), Is.Empty);
            Assert.That(ReflectedWaves.Arrivals(Swing(4, 0)), Has.All.NaN);
        }

        [TestCase(1.02, true)]
        [TestCase(0.98, true)]
        [TestCase(1.05, false)]
        [TestCase(0.95, false)]
        public void A_wave_that_is_late_or_early_by_more_than_the_bar_is_seen(double stretch, bool within)
        {
            double[] finest = ReflectedWaves.Arrivals(Swing(1, 0)), seen = ReflectedWaves.Arrivals(Swing(stretch, 0));
            for (int i = 0; i < finest.Length; i++)
                Assert.That(Math.Abs(seen[i] / finest[i] - 1) <= ReflectedWaves.Allowed(new[] { finest[i] }), Is.EqualTo(within), $"turn {i + 1}");
        }

        [Test]
        public void Starts_that_differ_by_more_than_the_bar_widen_it()
        {
            Assert.That(ReflectedWaves.Allowed(new[] { 1.0, 1.0, 1.0 }), Is.EqualTo(0.03));
            Assert.That(ReflectedWaves.Allowed(new[] { 0.9, 1.0, 1.1 }), Is.EqualTo(0.2).Within(1e-9));
        }

        [Test]
        public void A_percentile_leaves_the_few_beyond_it_out()
        {
            float[] values = Enumerable.Range(0, 1001).Select(i => (float)((i * 389) % 1001)).ToArray();
            values[Array.IndexOf(values, 1000f)] = 1e6f;
            Assert.That(Percentile.Of(values, 0.995), Is.EqualTo(995).Within(1e-6));
            Assert.That(Percentile.Of(values, 0), Is.EqualTo(0));
            Assert.That(Percentile.Of(values, 1), Is.EqualTo(1e6f));
            Assert.That(Percentile.Of(new[] { 1f, 2f }, 0.25), Is.EqualTo(1.25).Within(1e-6), "between two");
            Assert.Throws<ArgumentException>(() => Percentile.Of(new float[0], 0.5));
        }

        [Test]
        public void The_experiments_advance_and_reach_the_places_that_their_header_says()
        {
            List<FrontSeries> experiments = Experiments();
            Assert.That(experiments.Select(series => series.Name), Is.EquivalentTo(new[] { "MM1125", "MM225", "KO" }));
            foreach (FrontSeries series in experiments)
                Assert.That(series.Points.Select(point => point.Z), Is.Ordered);
            foreach ((string name, double time) in new[] { ("MM1125", 2.12), ("MM225", 2.16), ("KO", 2.20) })
                Assert.That(experiments.Single(series => series.Name == name).At(time), Is.EqualTo(2.5).Within(0.02), name);
        }

        [Test]
        public void A_front_at_the_mean_of_the_experiments_is_not_ahead_of_it()
        {
            var deviation = new FrontDeviation(Scaled(1), Experiments());
            Assert.That(deviation.Values.Count, Is.GreaterThan(20));
            Assert.That(deviation.Max, Is.EqualTo(0).Within(2e-3));
            Assert.That(deviation.Min, Is.EqualTo(0).Within(2e-3));
            Assert.That(deviation.WithinBar);
        }

        [TestCase(0.93, false)]
        [TestCase(0.96, true)]
        [TestCase(1.09, true)]
        [TestCase(1.12, false)]
        public void A_front_that_is_too_slow_or_too_fast_misses_the_bar(double factor, bool within)
        {
            Assert.That(new FrontDeviation(Scaled(factor), Experiments()).WithinBar, Is.EqualTo(within));
        }

        [Test]
        public void A_front_that_ends_early_misses_the_bar()
        {
            Assert.That(new FrontDeviation(Scaled(1, until: 2), Experiments()).WithinBar, Is.False);
        }

        [TestCase(5.0, 0.2, 0.0)]
        [TestCase(3.7, 0.0, 0.0)]
        [TestCase(5.3, 0.5, 0.1)]
        public void A_damped_cosine_is_found_again(double frequency, double damping, double noise)
        {
            var random = new Random(3);
            var samples = Enumerable.Range(0, 200).Select(i => i / 30.0)
                .Select(t => (t, 0.5 + 0.02 * (Math.Exp(-damping * t) * Math.Cos(frequency * t + 1)
                    + noise * (2 * random.NextDouble() - 1)))).ToList();
            DampedCosine fit = DampedCosine.Fit(samples);
            double tolerance = noise > 0 ? 0.01 : 1e-5;
            Assert.That(fit.Period, Is.EqualTo(2 * Math.PI / frequency).Within(tolerance));
            Assert.That(fit.Damping, Is.EqualTo(damping).Within(10 * tolerance));
            Assert.That(fit.Offset, Is.EqualTo(0.5).Within(tolerance));
            Assert.That(fit.Misfit, Is.LessThan(noise + 1e-4));
            Assert.That(fit.At(samples[40].t), Is.EqualTo(samples[40].Item2).Within(0.02 * noise + 1e-6));
        }

        [Test]
        public void What_swings_with_two_frequencies_is_said_to_fit_badly()
        {
            var samples = Enumerable.Range(0, 200).Select(i => i / 30.0).Select(t => (t, Math.Cos(4 * t) + Math.Cos(9 * t))).ToList();
            Assert.That(DampedCosine.Fit(samples).Misfit, Is.GreaterThan(0.3));
        }

        [Test]
        public void Still_water_of_the_reference_stays_still()
        {
            const double cell = 0.1;
            var flow = new StaggeredFlow(12, 20, cell);
            for (int y = 0; y < 30; y++)
                for (int x = 0; x < 36; x++)
                    flow.Add((x + 0.5) * cell / 3, (y + 0.5) * cell / 3, 0, 0, 0.55 * cell / 3);
            flow.Project(0.004, FluidRun.Gravity);
            for (int x = 0; x < 36; x++)
            {
                (double u, double v, double _, double _) = flow.At((x + 0.5) * cell / 3, 0.4);
                Assert.That(Math.Sqrt(u * u + v * v), Is.LessThan(1e-3 * 0.004 * FluidRun.Gravity));
            }
        }

        [Test]
        public void The_reference_is_ahead_of_the_experiments_as_water_without_friction_is()
        {
            var deviation = new FrontDeviation(InviscidDamBreak.Run(8), Experiments());
            Assert.That(deviation.Mean, Is.InRange(0.04, 0.09), "0.073 with 20 and 40 cells across");
        }
    }
}
