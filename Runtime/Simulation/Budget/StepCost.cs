namespace Rill
{
    /// <summary>
    /// GPU time of a step on the GPU of Research~/performance.md (NVIDIA H200), fitted to the stages of 100,000 and
    /// 1,000,000 settled particles there: what each pass costs beside the others. A device's own speed is a factor on it.
    /// </summary>
    static class StepCost
    {
        const float Million = 1e6f;

        /// <param name="particles">Alive.</param>
        /// <param name="deepWater">Whether the coarse grid carries the pressure of deep water.</param>
        /// <param name="elastic">Whether the fluid remembers its stretch.</param>
        /// <returns>ms.</returns>
        public static float Milliseconds(int substeps, int iterations, float particles, bool deepWater, bool elastic)
        {
            float millions = particles / Million;
            // Sort, list with the first multiplier, velocity: a latency that no count saves, and a fraction by particle.
            float substep = 0.044f + 0.507f * millions;
            if (deepWater)
                substep += 0.09f + 0.097f * millions;
            if (elastic)
                substep += 0.027f + 0.498f * millions;
            float displacement = 0.004f + 0.093f * millions, multiplier = 0.003f + 0.087f * millions;
            return substeps * (substep + iterations * displacement + (iterations - 1) * multiplier);
        }
    }
}
