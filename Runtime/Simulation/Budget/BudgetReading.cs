namespace Rill
{
    /// <summary>What a budget's controller learns in a frame.</summary>
    struct BudgetReading
    {
        /// <summary>Since the last reading, s.</summary>
        public float seconds;
        /// <summary>GPU time of one step of an earlier frame, ms; 0 where it is not known.</summary>
        public float milliseconds;
        /// <summary>What the cost model says of that step, ms.</summary>
        public float modeled;
        public GpuTimeKind source;
        /// <summary>Steps of a frame that takes any, on the mean; at least 1.</summary>
        public float stepsPerFrame;
        public float particles;
        /// <summary>C+ of the newest statistics; NaN before the first.</summary>
        public float densityError;
    }
}
