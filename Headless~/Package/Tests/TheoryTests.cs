using System.Collections.Generic;
using Host;
using Host.Report;
using NUnit.Framework;
using Rill;

namespace Host.Tests
{
    /// <summary>The solver against experiment and theory, in small; "rill report experiment" does it at size.</summary>
    public class TheoryTests : GraphicsFixture
    {
        [TestCase(DeepWater.On)]
        [TestCase(DeepWater.Off)]
        public void A_cube_falls_as_far_as_its_steps_say_and_keeps_its_shape(DeepWater deepWater)
        {
            FreeFall fall = FreeFall.Run(FluidRun.Water(1, 2, deepWater), 0.05f);
            Assert.That(fall.DiscreteError, Is.EqualTo(0).Within(2e-4));
            Assert.That(fall.Error, Is.EqualTo(1.0 / 60 / fall.Time).Within(1e-3), "half a step ahead of g t²/2");
            Assert.That(fall.RadiusRatio, Is.EqualTo(1).Within(0.02), "the first steps push apart what its lattice's offsets made too dense");
        }

        [Test]
        public void The_potentials_of_a_still_column_are_its_pressure()
        {
            StillColumn column = StillColumn.Run(24, 8, 0.05f, FluidRun.Water(1, 2), settle: 1);
            Assert.That(column.BottomError, Is.InRange(-0.05, 0.05));
            Assert.That(column.HeightRatio, Is.InRange(0.97, 1.03));
        }

        [Test]
        public void The_front_of_a_dam_break_keeps_to_the_experiments()
        {
            DamBreakFront dam = DamBreakFront.Run(20, FluidRun.Water(1, 2));
            var deviation = new FrontDeviation(dam.Front, FrontSeries.Experiments(Session.Root()));
            Assert.That(deviation.WithinBar, $"ahead by {100 * deviation.Min:0.0} to {100 * deviation.Max:0.0} %");
            Assert.That(dam.EnergyRatio, Is.InRange(0.9, 1.0));
        }

        [Test]
        public void Water_in_a_box_sloshes_with_the_period_of_its_first_mode()
        {
            const int along = 32;
            double depth = Sloshing.NearestDepth(along, 0.35), theory = Sloshing.Period(depth);
            List<(double, double)> samples = Sloshing.Run(along, depth, 0.1, FluidRun.Water(1, 2), 1.6 * theory);
            DampedCosine fit = DampedCosine.Fit(samples);
            Assert.That(fit.Misfit, Is.LessThan(0.1));
            Assert.That(fit.Period / theory, Is.InRange(0.9, 1.1));
        }
    }
}
