using System;
using System.Collections.Generic;
using System.Linq;
using Host;
using Host.Report;
using NUnit.Framework;

namespace Host.Tests
{
    /// <summary>What judges the solver against experiment and theory, on data whose answer is known.</summary>
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
                .Select(t => (t, 0.5 + 0.02 * (Math.Exp(-damping * t) * Math.Cos(frequency * t + 1) + noise * (2 * random.NextDouble() - 1)))).ToList();
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
