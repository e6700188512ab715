using NUnit.Framework;

namespace Rill.Tests
{
    /// <summary>The running mean of what steps take over the model.</summary>
    public class CostFactorTests
    {
        const float Seconds = 1f / 60f;

        [Test]
        public void After_a_jump_it_is_the_mean_of_all_readings_since()
        {
            CostFactor factor = Of(1f, 60);
            Add(factor, 2f, 2f, 2f);
            Assert.That(factor.Value, Is.EqualTo(2f), "it jumped");
            Add(factor, 1.6f, 1.6f, 1.6f, 1.6f);
            Assert.That(factor.Value, Is.EqualTo(12.4f / 7f).Within(0.5).Percent);
        }

        [TestCase(10f, 1.02f)]
        [TestCase(0.01f, 0.98f)]
        public void One_hitch_counts_as_three_tenths_off_however_long_it_was(float hitch, float expected)
        {
            CostFactor factor = Of(1f, 60);
            Add(factor, hitch);
            Assert.That(factor.Value, Is.EqualTo(expected).Within(1e-3f));
        }

        [Test]
        public void After_a_reset_nothing_of_the_readings_before_counts()
        {
            CostFactor factor = Of(1f, 60);
            factor.Reset();
            Add(factor, 1.2f, 1.2f, 1.2f, 1.2f);
            Assert.That(factor.IsKnown, Is.False);
            Add(factor, 1.2f);
            Assert.That((factor.IsKnown, factor.Value), Is.EqualTo((true, 1.2f)));
        }

        static CostFactor Of(float ratio, int readings)
        {
            var factor = new CostFactor();
            for (int i = 0; i < readings; i++)
                factor.Add(ratio, Seconds);
            return factor;
        }

        static void Add(CostFactor factor, params float[] ratios)
        {
            foreach (float ratio in ratios)
                factor.Add(ratio, Seconds);
        }
    }
}
