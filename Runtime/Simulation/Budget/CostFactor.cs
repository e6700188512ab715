using System;

namespace Rill
{
    /// <summary>
    /// How many times longer steps take here than the cost model says: a running mean of noisy readings that lets no single
    /// hitch through and follows a step in load at once.
    /// </summary>
    sealed class CostFactor
    {
        const int Window = 5;
        const float MeanSeconds = 0.25f;
        /// <summary>A median this far from the mean is another load, not noise; noise of ±20 % never gets there.</summary>
        const float Jump = 0.25f;
        /// <summary>A reading this far from the median is a hitch.</summary>
        const float Hitch = 0.3f;

        readonly float[] recent = new float[Window], sorted = new float[Window];
        int count;
        int sinceJump;

        public float Value { get; private set; }

        public bool IsKnown => count >= Window;

        public void Reset() => (count, sinceJump, Value) = (0, 0, 0f);

        /// <param name="ratio">Time over the model's, above 0.</param>
        /// <param name="seconds">Since the last reading.</param>
        public void Add(float ratio, float seconds)
        {
            recent[count % Window] = ratio;
            count = count == 2 * Window - 1 ? Window : count + 1;
            if (!IsKnown)
                return;
            float median = Median();
            if (Value <= 0f || Math.Abs(median / Value - 1f) > Jump)
            {
                Value = median;
                sinceJump = Window / 2;
                return;
            }
            // The mean of all since the jump, until that is more than the window of time.
            float gain = Math.Min(1f, Math.Max(1f / (++sinceJump + 1), seconds / MeanSeconds));
            float heard = Math.Min(Math.Max(ratio, median * (1f - Hitch)), median * (1f + Hitch));
            Value += gain * (heard - Value);
        }

        float Median()
        {
            for (int i = 0; i < Window; i++)
            {
                int at = i;
                for (; at > 0 && sorted[at - 1] > recent[i]; at--)
                    sorted[at] = sorted[at - 1];
                sorted[at] = recent[i];
            }
            return sorted[Window / 2];
        }
    }
}
