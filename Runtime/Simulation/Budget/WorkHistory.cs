namespace Rill
{
    /// <summary>Work that the last frames recorded, so that a time that comes late is matched with its own.</summary>
    sealed class WorkHistory
    {
        const int Frames = 8;

        readonly int[] steps = new int[Frames];
        readonly float[] stepCosts = new float[Frames];
        int newest;

        /// <summary>Ends a frame.</summary>
        /// <param name="stepCost">Cost of one step by the cost model, ms.</param>
        public void Add(int stepCount, float stepCost)
        {
            newest = (newest + 1) % Frames;
            steps[newest] = stepCount;
            stepCosts[newest] = stepCost;
        }

        /// <param name="framesAgo">1 for the frame before, to 8.</param>
        public int Steps(int framesAgo) => steps[At(framesAgo)];

        /// <summary>Time of one step by the cost model, ms; 0 before there was such a frame.</summary>
        /// <param name="framesAgo">1 for the frame before, to 8.</param>
        public float StepCost(int framesAgo) => stepCosts[At(framesAgo)];

        int At(int framesAgo) => (newest + Frames + 1 - framesAgo) % Frames;
    }
}
