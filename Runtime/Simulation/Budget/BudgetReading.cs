namespace Rill
{
    /// <summary>Readings that a budget's controller gets in a frame.</summary>
    struct BudgetReading
    {
        /// <summary>Since the last reading, s.</summary>
        public float seconds;
        /// <summary>GPU time of one step of an earlier frame, ms; 0 where it is not known.</summary>
        public float milliseconds;
        /// <summary>Time of that step by the cost model, ms.</summary>
        public float modeled;
        public GpuTimeKind source;
        /// <summary>Steps of a frame that takes any, on the mean; at least 1.</summary>
        public float stepsPerFrame;
        public float particles;
        /// <summary>C+ of the newest statistics; NaN before the first.</summary>
        public float densityError;
    }
}
